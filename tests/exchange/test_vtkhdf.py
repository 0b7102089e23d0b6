"""Recordings as VTKHDF."""

import pytest
from conftest import netpocket
from vtkhdf_layout import check_bodies, check_layout, check_lines, check_with_vtk


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


def test_is_replaced_by_its_like_only(folder, recording, tmp_path):
    netpocket("export", recording, "--vtkhdf", folder, "--quiet")
    with pytest.raises(AssertionError, match="recording|HDF5"):
        (tmp_path / "lines.vtkhdf").write_bytes(recording.read_bytes())
        netpocket("export", recording, "--vtkhdf", tmp_path, "--quiet")
