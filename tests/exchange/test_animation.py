"""The animation of a whole capture, read again."""

import h5py
import numpy as np
import pytest
from conftest import netpocket, ropes_of
from gltf_reader import Gltf, rotation_matrix

KEYS = 12


@pytest.fixture(scope="module")
def scene(recording, tmp_path_factory):
    file = tmp_path_factory.mktemp("gltf") / "run.glb"
    netpocket("export", recording, "--gltf", file, "--keys", KEYS, "--quiet")
    return Gltf(file)


@pytest.fixture(scope="module")
def run(recording):
    with h5py.File(recording) as file:
        yield file


def frame_at(run, time):
    """Index of the frame of a time."""
    times = run["frames/channels"][:, 0]
    index = int(np.argmin(np.abs(times - time)))
    assert abs(times[index] - time) < 1e-6
    return index


def node_places(scene, time):
    """Places of the recording's nodes: the middles of the points that follow their joints."""
    sums, counts = {}, {}
    for points, joints in scene.skinned("cords", time):
        for point, joint in zip(points, joints):
            sums[joint] = sums.get(joint, 0) + point
            counts[joint] = counts.get(joint, 0) + 1
    return {int(scene.nodes[j]["name"].removeprefix("node ")): total / counts[j] for j, total in sums.items()}


def test_keys_are_bounded_and_cover_the_capture(scene, run):
    times = scene.times()
    assert 2 <= len(times) <= KEYS and np.all(np.diff(times) > 0)
    recorded = run["frames/channels"][:, 0]
    assert times[0] == pytest.approx(recorded[0]) and times[-1] == pytest.approx(recorded[-1], abs=1e-6)
    assert np.ptp(np.diff(times)[:-1]) < 1e-5


def test_cords_are_where_the_recording_has_them(scene, run):
    groups = run["structure/element_group"][:]
    looks = run["structure/group_look"][:]
    tube = 1
    nodes = np.unique(run["structure/element_nodes"][:][looks[groups] != tube])
    for time in scene.times()[[0, 5, -1]]:
        places, recorded = node_places(scene, time), run["frames/position"][frame_at(run, time)]
        assert sorted(places) == list(nodes)
        for node in nodes:
            np.testing.assert_allclose(places[node], recorded[node], atol=1e-5)


def test_moves_between_keys(scene, run):
    first, second = scene.times()[[4, 5]].astype(float)
    a, b = run["frames/position"][frame_at(run, first)], run["frames/position"][frame_at(run, second)]
    places = node_places(scene, first + 0.25 * (second - first))
    for node, place in places.items():
        np.testing.assert_allclose(place, 0.75 * a[node] + 0.25 * b[node], atol=1e-5)
    assert max(np.linalg.norm(b[node] - a[node]) for node in places) > 1e-3, "nothing moves"


def test_every_element_is_drawn(scene, run):
    """Each element of a cord is three ribbons of two triangles, from one of its nodes to the other."""
    node = scene.nodes[scene.node("cords")]
    drawn = set()
    joints = scene.json["skins"][node["skin"]]["joints"]
    for primitive in scene.json["meshes"][node["mesh"]]["primitives"]:
        of_point = scene.values(primitive["attributes"]["JOINTS_0"])[:, 0]
        for corner in of_point[scene.values(primitive["indices"]).reshape(-1, 3)]:
            names = {int(scene.nodes[joints[j]]["name"].removeprefix("node ")) for j in corner}
            assert len(names) == 2
            drawn.add(tuple(sorted(names)))
    looks = run["structure/group_look"][:][run["structure/element_group"][:]]
    assert drawn == {tuple(sorted(ends)) for ends in run["structure/element_nodes"][:][looks != 1]}


def test_rods_have_their_thickness_about_their_axes(scene, run):
    looks = run["structure/group_look"][:][run["structure/element_group"][:]]
    ends = run["structure/element_nodes"][:][looks == 1]
    radius = run["structure/element_radius"][:][looks == 1][0]
    for time in scene.times()[[0, 6, -1]]:
        (points, joints), = scene.skinned("rods", time)
        rings = {}
        for point, joint in zip(points, joints):
            rings.setdefault(joint, []).append(point)
        centers = np.array([np.mean(ring, axis=0) for ring in rings.values()])
        for ring, center in zip(rings.values(), centers):
            np.testing.assert_allclose(np.linalg.norm(ring - center, axis=1), radius, rtol=1e-3)
        for node in np.unique(ends):
            place = run["frames/position"][frame_at(run, time)][node]
            assert np.linalg.norm(centers - place, axis=1).min() < 1e-5


@pytest.fixture(scope="module")
def roped_scene(roped, tmp_path_factory):
    file = tmp_path_factory.mktemp("roped") / "run.glb"
    netpocket("export", roped, "--gltf", file, "--keys", KEYS, "--quiet")
    return Gltf(file)


def rope_points(scene, name, time):
    """Points of a rope's tube at a time, by node of the recording."""
    (points, joints), = scene.skinned(name, time)
    places = {}
    for point, joint in zip(points, joints):
        owner, node = scene.nodes[joint]["name"].split(", node ")
        assert owner == name
        places.setdefault(int(node), []).append(point)
    return {node: np.array(of) for node, of in places.items()}


def test_ropes_run_through_their_rings(roped_scene, roped):
    ropes = ropes_of(roped)
    assert sorted(ropes) == ["drawstring 1", "drawstring 2", "drawstring 3", "drawstring 4", "wound tether"]
    times = roped_scene.times().astype(float)
    with h5py.File(roped) as run:
        for name, nodes in ropes.items():
            assert len(nodes) == (2 if name == "wound tether" else 7)
            for first, second in zip(times[:-1:3], times[1::3]):
                a, b = (run["frames/position"][frame_at(run, time)][nodes] for time in (first, second))
                for share in [0, 0.25, 1]:
                    places = rope_points(roped_scene, name, first + share * (second - first))
                    assert list(places) == nodes
                    middles = np.array([points.mean(axis=0) for points in places.values()])
                    np.testing.assert_allclose(middles, (1 - share) * a + share * b, atol=1e-5)
            whole = run["frames/position"][:][:, nodes]
            assert np.linalg.norm(whole[-1] - whole[0], axis=1).max() > 1, "nothing moves"


def test_a_rope_is_a_closed_tube_from_ring_to_ring(roped_scene, roped):
    """Seen along any part: about its middle the tube goes once round, and its walls reach from ring to ring."""
    for name, nodes in ropes_of(roped).items():
        node = roped_scene.nodes[roped_scene.node(name)]
        primitive, = roped_scene.json["meshes"][node["mesh"]]["primitives"]
        triangles = roped_scene.values(primitive["indices"]).reshape(-1, 3)
        of_point = roped_scene.values(primitive["attributes"]["JOINTS_0"])[:, 0].astype(int)
        assert np.all(np.ptp(of_point[triangles], axis=1) == 1), "each triangle joins a ring to the next"
        time = float(roped_scene.times()[-1])
        (points, _), = roped_scene.skinned(name, time)
        middles = np.array([of.mean(axis=0) for of in rope_points(roped_scene, name, time).values()])
        radii = np.linalg.norm(points - middles[of_point], axis=1)
        np.testing.assert_allclose(radii, radii[0], rtol=2e-3)
        for part in range(len(nodes) - 1):
            here = triangles[of_point[triangles].min(axis=1) == part]
            middle, along = middles[part : part + 2].mean(axis=0), middles[part + 1] - middles[part]
            # Rays across the part from its middle: each leaves through a wall.
            across = np.cross(along, [0.3, 0.5, -0.8])
            for angle in np.linspace(0, 2 * np.pi, 12, endpoint=False):
                ray = np.cos(angle) * across / np.linalg.norm(across) + np.sin(angle) * np.cross(
                    along / np.linalg.norm(along), across / np.linalg.norm(across))
                assert crosses(middle, ray, points[here], radii[0]), (name, part, angle)


def crosses(start, ray, triangles, reach):
    """Whether a ray meets one of the triangles within `reach` (Moeller and Trumbore)."""
    for a, b, c in triangles:
        matrix = np.column_stack([b - a, c - a, -ray])
        if abs(np.linalg.det(matrix)) < 1e-15:
            continue
        u, v, t = np.linalg.solve(matrix, start - a)
        if min(u, v) > -1e-6 and u + v < 1 + 1e-6 and 0 < t < 1.01 * reach:
            return True
    return False


def test_runs_without_such_ropes_have_no_mesh_for_them(scene, recording):
    assert not ropes_of(recording)
    assert sorted(skin["name"] for skin in scene.json["skins"]) == ["cords", "rods"]


def test_bodies_move_and_turn(scene, run):
    names = [text.rstrip(b"\0").decode() for text in run["structure/body_names"][:]]
    turned = 0
    for index, name in enumerate(names):
        node = scene.node(name)
        assert scene.nodes[node]["children"], name
        for time in scene.times()[[0, 7, -1]]:
            state = run["frames/body_state"][frame_at(run, time)][index]
            matrix = scene.matrix(node, time)
            np.testing.assert_allclose(matrix[:3, 3], state[:3], atol=1e-5)
            attitude = rotation_matrix(np.roll(state[3:7], -1))  # recorded w, x, y, z
            np.testing.assert_allclose(matrix[:3, :3], attitude, atol=1e-5)
            turned = max(turned, abs(matrix[0, 2]))
    assert turned > 0.1, "the target turns"


def test_vtk_reads_it(recording, tmp_path):
    """VTK's own reader, with its own deformation by skins."""
    geometry = pytest.importorskip("vtkmodules.vtkIOGeometry")
    file = tmp_path / "run.glb"
    netpocket("export", recording, "--gltf", file, "--keys", KEYS, "--quiet")
    scene = Gltf(file)
    reader = geometry.vtkGLTFReader()
    reader.SetFileName(str(file))
    reader.ApplyDeformationsToGeometryOn()
    reader.SetFrameRate(1000)
    reader.UpdateInformation()
    assert reader.GetNumberOfAnimations() == 1
    reader.EnableAnimation(0)
    time = float(scene.times()[5])
    reader.UpdateTimeStep(time)
    leaves, bounds = reader.GetOutput().NewIterator(), []
    while not leaves.IsDoneWithTraversal():
        bounds.append(leaves.GetCurrentDataObject().GetBounds())
        leaves.GoToNextItem()
    expected = []
    for name in ["cords", "rods"]:
        for points, _ in scene.skinned(name, time):
            expected.append(np.column_stack([points.min(axis=0), points.max(axis=0)]).ravel())
    for box in expected:
        assert min(np.abs(np.array(bound) - box).max() for bound in bounds) < 0.01


def test_needs_a_name_of_its_kind(recording, tmp_path):
    with pytest.raises(AssertionError, match="--gltf.*glb"):
        netpocket("export", recording, "--gltf", tmp_path / "run.png", "--quiet")
