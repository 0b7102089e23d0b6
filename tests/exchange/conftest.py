"""Short recordings that are exported."""

import os
import pathlib
import subprocess

import h5py
import numpy as np
import pytest

SCENARIOS = pathlib.Path(os.environ["NETPOCKET_SOURCE"]) / "scenarios"


def netpocket(*words):
    """Runs the program; its message when it fails."""
    done = subprocess.run([os.environ["NETPOCKET"], *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="session")
def recording(tmp_path_factory):
    """Case 1 with few elements, 2 s, a target that drifts and turns."""
    path = tmp_path_factory.mktemp("run") / "run.h5"
    netpocket("run", SCENARIOS / "case1.toml", "-o", path, "--quiet", "--until", 2, "--set", "pocket.elements_per_side=1",
              "--set", "target.spin=[0,0.2,0.05]", "--set", "target.velocity=[0.1,0,-0.05]")
    return path


@pytest.fixture(scope="session")
def roped(tmp_path_factory):
    """A net that is thrown, 12 s: its drawstring runs through rings, its tether off a drum."""
    path = tmp_path_factory.mktemp("roped") / "run.h5"
    netpocket("run", SCENARIOS / "thrown_net_winch.toml", "-o", path, "--quiet", "--until", 12, "--set", "net.cells=6",
              "--set", 'drawstring.passage="rings"')
    return path


def ropes_of(path):
    """Names and nodes of a recording's ropes without elements, which have the look 4 (node_group_look)."""
    with h5py.File(path) as run:
        structure = run["structure"]
        names = [text.rstrip(b"\0").decode() for text in structure["node_group_names"][:]]
        ends = np.cumsum(structure["node_group_size"][:])
        nodes = np.split(structure["node_group_nodes"][:], ends[:-1])
        return {name: list(of) for name, of, look in zip(names, nodes, structure["node_group_look"][:]) if look == 4}
