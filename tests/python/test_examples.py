"""The examples run, and say what they promise."""

import os
import pathlib
import re
import subprocess
import sys

EXAMPLES = pathlib.Path(os.environ["NETPOCKET_SOURCE"], "engine", "python", "examples")


def run(name: str, *arguments: str) -> str:
    result = subprocess.run([sys.executable, EXAMPLES / f"{name}.py", *arguments], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_every_example_is_tested():
    assert {path.stem for path in EXAMPLES.glob("*.py")} == {
        "first_capture", "own_controller", "sweep", "probability_map", "random_policy"}


def test_first_capture(tmp_path):
    text = run("first_capture", str(tmp_path))
    before, after = map(float, re.search(r"mouth: ([\d.]+) m before, ([\d.]+) m after", text).groups())
    assert after < 0.5 * before
    assert {path.name for path in tmp_path.iterdir()} >= {"first.h5", "first.png", "first_force.svg"}


def test_own_controller():
    free, held = map(float, re.search(r"pulled ([\d.]+) m when free, ([\d.]+) m", run("own_controller")).groups())
    assert held < 0.2 * free


def test_sweep():
    pushes = [float(push) for push in re.findall(r"push\s+([\d.]+) N", run("sweep"))]
    assert len(pushes) == 4 and pushes == sorted(pushes)


def test_probability_map():
    assert re.search(r"\d of 4 are caught", run("probability_map", "4"))


def test_random_policy():
    assert "observations (8, 20)" in run("random_policy", "8", "3")
