"""A short recording that is exported."""

import os
import pathlib
import subprocess

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
