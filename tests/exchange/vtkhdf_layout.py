"""The rules of a VTKHDF file with a poly data set and time steps, and its meshes read by them alone.

Source: "VTKHDF File Format" 2.0 (docs.vtk.org, VTK File Formats): PolyData, and "Temporal Data" for the group Steps.
"""

import h5py
import numpy as np
from conftest import ropes_of

TOPOLOGIES = ["Vertices", "Lines", "Polygons", "Strips"]
COUNTS = ["NumberOfCells", "NumberOfConnectivityIds"]


def check_layout(path):
    """Raises AssertionError where the file breaks a rule."""
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        assert list(root.attrs["Version"]) == [2, 0]
        kind = root.attrs.get_id("Type").get_type()
        assert kind.get_class() == h5py.h5t.STRING and not kind.is_variable_str()
        assert kind.get_cset() == h5py.h5t.CSET_ASCII and root.attrs["Type"] == b"PolyData"
        parts = len(root["NumberOfPoints"])
        assert root["Points"].shape[1:] == (3,)
        for name in TOPOLOGIES:
            group = root[name]
            assert all(group[count].shape == (parts,) for count in COUNTS), name
            cells, ids = (group[count][0] for count in COUNTS)
            offsets, connectivity = group["Offsets"][:], group["Connectivity"][:]
            assert len(offsets) == cells + 1 and len(connectivity) == ids, name
            assert offsets[0] == 0 and offsets[-1] == ids and np.all(np.diff(offsets) >= 0), name
            assert np.all((connectivity >= 0) & (connectivity < root["NumberOfPoints"][0])), name
        check_steps(root)


def check_steps(root):
    steps, count = root["Steps"], int(root["Steps"].attrs["NSteps"])
    assert steps["Values"].shape == (count,) and np.all(np.diff(steps["Values"][:]) > 0)
    assert np.all(steps["NumberOfParts"][:] == 1) and np.all(steps["PartOffsets"][:] < len(root["NumberOfPoints"]))
    assert steps["CellOffsets"].shape == steps["ConnectivityIdOffsets"].shape == (count, len(TOPOLOGIES))
    points = root["NumberOfPoints"][0]
    cells = sum(root[name]["NumberOfCells"][0] for name in TOPOLOGIES)
    assert np.all(steps["PointOffsets"][:] + points <= len(root["Points"]))
    for data, offsets, rows in [("PointData", "PointDataOffsets", points), ("CellData", "CellDataOffsets", cells)]:
        assert set(root[data]) == set(steps[offsets])
        for name, array in root[data].items():
            assert steps[offsets][name].shape == (count,)
            assert np.all(steps[offsets][name][:] + rows <= len(array)), name


def read_step(path, step):
    """Points, arrays and cells of a step: {"points", "PointData", "CellData", topology: [ids of a cell]}."""
    with h5py.File(path) as file:
        root, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        part, mesh = steps["PartOffsets"][step], {}
        count, first = root["NumberOfPoints"][part], steps["PointOffsets"][step]
        mesh["points"] = root["Points"][first : first + count]
        cells = 0
        for column, name in enumerate(TOPOLOGIES):
            group = root[name]
            first_cell, first_id = steps["CellOffsets"][step, column], steps["ConnectivityIdOffsets"][step, column]
            here = group["NumberOfCells"][part]
            offsets = group["Offsets"][first_cell : first_cell + here + 1] + first_id
            mesh[name] = [group["Connectivity"][a:b] for a, b in zip(offsets, offsets[1:])] if here < 5000 else None
            cells += here
        for data, rows in [("PointData", count), ("CellData", cells)]:
            offsets = steps[data + "Offsets"]
            mesh[data] = {name: array[offsets[name][step] : offsets[name][step] + rows] for name, array in root[data].items()}
        return mesh


def check_lines(path, recording):
    """Compares the lines of all steps with the nodes and elements of the recording."""
    with h5py.File(path) as file, h5py.File(recording) as run:
        nodes = run["structure/element_nodes"][:]
        frames = len(run["frames/step"])
        assert file["VTKHDF/Steps"].attrs["NSteps"] == frames
        names = [text.rstrip(b"\0").decode() for text in file["netpocket/groups"][:]]
        assert names == [text.rstrip(b"\0").decode() for text in run["structure/group_names"][:]]
        for frame in {0, 1, frames // 2, frames - 1}:
            mesh = read_step(path, frame)
            assert len(mesh["Lines"]) == len(nodes)
            ends = np.array(mesh["Lines"])
            np.testing.assert_allclose(mesh["points"][ends], run["frames/position"][frame][nodes], atol=2e-6)
            np.testing.assert_allclose(mesh["PointData"]["velocity"][ends], run["frames/velocity"][frame][nodes], atol=2e-6)
            for name in ["tension", "strain"]:
                np.testing.assert_array_equal(mesh["CellData"][name], run["frames/" + name][frame])
            np.testing.assert_array_equal(mesh["CellData"]["group"], run["structure/element_group"][:])


def check_bodies(path, recording):
    """The centres of the bodies' boxes are where the recording has the bodies; corners keep their distances."""
    with h5py.File(recording) as run:
        states = run["frames/body_state"][:]
        for frame in {0, len(states) // 2, len(states) - 1}:
            mesh, first = read_step(path, frame), read_step(path, 0)
            body = mesh["CellData"]["body"]
            for index, state in enumerate(states[frame]):
                used = np.unique(np.concatenate([cell for cell, of in zip(mesh["Polygons"], body) if of == index]))
                points = mesh["points"][used].astype(float)
                middle = (points.min(axis=0) + points.max(axis=0)) / 2
                np.testing.assert_allclose(middle, state[:3], atol=0.02)  # a sphere of facets
                normals = mesh["PointData"]["Normals"][used].astype(float)
                assert np.all(np.sum(normals * (points - middle), axis=1) > 0)
                before = first["points"][used].astype(float)
                np.testing.assert_allclose(np.linalg.norm(points - points[0], axis=1),
                                           np.linalg.norm(before - before[0], axis=1), atol=1e-5)


def check_ropes(path, recording):
    """Each rope without elements is a line through its nodes, in all steps."""
    ropes = ropes_of(recording)
    with h5py.File(path) as file, h5py.File(recording) as run:
        frames = len(run["frames/step"])
        assert file["VTKHDF/Steps"].attrs["NSteps"] == frames
        np.testing.assert_allclose(file["VTKHDF/Steps/Values"][:], run["frames/channels"][:, 0], atol=1e-6)
        assert [text.rstrip(b"\0").decode() for text in file["netpocket/ropes"][:]] == list(ropes)
        for frame in range(frames):
            mesh = read_step(path, frame)
            assert len(mesh["Lines"]) == len(ropes)
            assert list(mesh["CellData"]["rope"]) == list(range(len(ropes)))
            for line, nodes in zip(mesh["Lines"], ropes.values()):
                np.testing.assert_allclose(mesh["points"][line], run["frames/position"][frame][nodes], atol=2e-6)
                np.testing.assert_allclose(mesh["PointData"]["velocity"][line], run["frames/velocity"][frame][nodes],
                                           atol=2e-6)


def read_with_vtk(path):
    """Times, and a function that gives the points of a time, by VTK's own reader. None where it is too old."""
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
        from vtkmodules.vtkIOHDF import vtkHDFReader
        from vtkmodules.util.numpy_support import vtk_to_numpy
    except ImportError:
        return None
    version = vtkVersion()
    if (version.GetVTKMajorVersion(), version.GetVTKMinorVersion()) < (9, 3):
        return None
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(reader.GetExecutive().TIME_STEPS())

    def mesh_at(time):
        reader.UpdateTimeStep(time)
        mesh = reader.GetOutput()
        arrays = mesh.GetCellData()
        data = {arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i)).copy() for i in range(arrays.GetNumberOfArrays())}
        return vtk_to_numpy(mesh.GetPoints().GetData()).copy(), data, mesh.GetNumberOfCells()

    return times, mesh_at


def check_with_vtk(path):
    """Whether VTK's reader gives what the layout says. False where it is too old."""
    read = read_with_vtk(path)
    if read is None:
        return False
    times, mesh_at = read
    with h5py.File(path) as file:
        np.testing.assert_allclose(times, file["VTKHDF/Steps/Values"][:])
    for step in {0, len(times) // 2, len(times) - 1}:
        points, data, cells = mesh_at(times[step])
        mesh = read_step(path, step)
        np.testing.assert_array_equal(points, mesh["points"])
        assert set(data) == set(mesh["CellData"])
        for name, values in data.items():
            np.testing.assert_array_equal(values, mesh["CellData"][name])
            assert len(values) == cells
    return True
