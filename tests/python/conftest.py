"""What the tests share: a small pocket that runs fast, and a recording of it."""

import pathlib

import pytest

import netpocket


def small() -> netpocket.Scenario:
    scenario = netpocket.Scenario()
    scenario["pocket.mesh_columns"] = scenario["pocket.mesh_rows"] = 2
    scenario["pocket.elements_per_side"] = 1
    scenario["output.end_time"] = 1
    return scenario


@pytest.fixture
def scenario() -> netpocket.Scenario:
    return small()


@pytest.fixture(scope="session")
def recording_path(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    path = tmp_path_factory.mktemp("run") / "small.h5"
    assert netpocket.record(small(), str(path)).reason == "finished"
    return path
