"""Recordings as VTKHDF."""

import pytest
from conftest import netpocket
from vtkhdf_layout import check_bodies, check_layout, check_lines, check_ropes, check_with_vtk


@pytest.fixture(scope="module")
def folder(recording, tmp_path_factory):
    place = tmp_path_factory.mktemp("vtkhdf")
    netpocket("export", recording, "--vtkhdf", place, "--quiet")
    return place


@pytest.mark.parametrize("part", ["lines", "bodies"])
def test_follows_the_layout(folder, part):
    check_layout(folder / f"{part}.vtkhdf")


def test_lines_are_the_elements(folder, recording):
    check_lines(folder / "lines.vtkhdf", recording)


def test_bodies_are_in_their_places(folder, recording):
    check_bodies(folder / "bodies.vtkhdf", recording)


@pytest.mark.parametrize("part", ["lines", "bodies"])
def test_vtk_reads_it(folder, part):
    if not check_with_vtk(folder / f"{part}.vtkhdf"):
        pytest.skip("VTK before 9.3 reads no time steps of poly data")


@pytest.fixture(scope="module")
def roped_folder(roped, tmp_path_factory):
    place = tmp_path_factory.mktemp("roped")
    netpocket("export", roped, "--vtkhdf", place, "--quiet")
    return place


@pytest.mark.parametrize("part", ["lines", "bodies", "ropes"])
def test_with_ropes_it_follows_the_layout(roped_folder, part):
    check_layout(roped_folder / f"{part}.vtkhdf")


def test_ropes_run_through_their_rings(roped_folder, roped):
    check_ropes(roped_folder / "ropes.vtkhdf", roped)
    check_lines(roped_folder / "lines.vtkhdf", roped)


def test_vtk_reads_ropes(roped_folder):
    if not check_with_vtk(roped_folder / "ropes.vtkhdf"):
        pytest.skip("VTK before 9.3 reads no time steps of poly data")


def test_without_ropes_there_is_no_file_of_them(folder):
    assert sorted(file.name for file in folder.iterdir()) == ["bodies.vtkhdf", "lines.vtkhdf"]


def test_is_replaced_by_its_like_only(folder, recording, tmp_path):
    netpocket("export", recording, "--vtkhdf", folder, "--quiet")
    with pytest.raises(AssertionError, match="recording|HDF5"):
        (tmp_path / "lines.vtkhdf").write_bytes(recording.read_bytes())
        netpocket("export", recording, "--vtkhdf", tmp_path, "--quiet")
