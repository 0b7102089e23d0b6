"""What studies estimate against OpenTURNS, on captures' numbers whose functions are known.

The speed of the target against the spacecraft at the start is the length of its velocity. So a study's indices, quantiles
and rare failures of it can be had from OpenTURNS as well.
"""

import csv
import os
import pathlib
import shutil
import subprocess

import pytest

openturns = pytest.importorskip("openturns")

PROGRAM = os.environ["NETPOCKET"]
SOURCE = pathlib.Path(os.environ["NETPOCKET_SOURCE"])

COARSE = """
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.01
[uncertain]
"target.velocity[0]" = { distribution = "normal", mean = 0, deviation = 0.3 }
"target.velocity[1]" = { distribution = "uniform", min = 0.1, max = 0.5 }
"target.velocity[2]" = { distribution = "triangular", min = -0.2, mode = 0, max = 0.4 }
"""


def inputs() -> "openturns.ComposedDistribution":
    return openturns.ComposedDistribution(
        [openturns.Normal(0, 0.3), openturns.Uniform(0.1, 0.5), openturns.Triangular(-0.2, 0, 0.4)]
    )


def speed() -> "openturns.SymbolicFunction":
    return openturns.SymbolicFunction(["x", "y", "z"], ["sqrt(x^2 + y^2 + z^2)"])


def run(folder: pathlib.Path, head: str, tail: str = "") -> None:
    shutil.copy(SOURCE / "scenarios" / "case1.toml", folder)
    (folder / "study.toml").write_text('base = "case1.toml"\n' + head + COARSE + tail)
    subprocess.run([PROGRAM, "study", "study.toml", "-o", "out", "--jobs", "2", "--quiet"], cwd=folder, check=True)


def rows(path: pathlib.Path) -> list[dict[str, str]]:
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def test_indices_are_those_of_openturns(tmp_path: pathlib.Path) -> None:
    run(tmp_path, "", '[sensitivity]\nof = "relative_speed_start"\nblocks = 200\n')
    found = rows(tmp_path / "out" / "study_sensitivity.csv")
    openturns.RandomGenerator.SetSeed(1)
    design = openturns.SobolIndicesExperiment(inputs(), 20000, False).generate()
    exact = openturns.SaltelliSensitivityAlgorithm(design, speed()(design), 20000)
    first, total = exact.getFirstOrderIndices(), exact.getTotalOrderIndices()
    assert len(found) == 3
    for i, row in enumerate(found):
        # The intervals have 95 %; twice their width leaves room for the one input in twenty outside.
        for name, value in (("first", first[i]), ("total", total[i])):
            width = float(row[f"{name}_upper"]) - float(row[f"{name}_lower"])
            assert abs(float(row[name]) - value) < width, (row["input"], name)


def test_quantiles_are_those_of_openturns(tmp_path: pathlib.Path) -> None:
    run(tmp_path, 'sampling = "sobol"\nsamples = 400\n', '[estimate]\nof = ["relative_speed_start"]\n')
    openturns.RandomGenerator.SetSeed(1)
    exact = speed()(inputs().getSample(200000))
    for row in rows(tmp_path / "out" / "study_estimates.csv"):
        if not row["statistic"].startswith("quantile_"):
            continue
        value = exact.computeQuantilePerComponent(float(row["statistic"].removeprefix("quantile_")))[0]
        assert float(row["lower"]) <= value <= float(row["upper"]), row
        # Sobol points are far more even than those that the interval reckons with.
        assert float(row["value"]) == pytest.approx(value, rel=0.04)


def test_rare_failures_are_those_of_openturns(tmp_path: pathlib.Path) -> None:
    run(tmp_path, "seed = 3\n", '[rare]\nof = "relative_speed_start"\nat_least = 1.15\nsamples = 400\nlevels = 5\n')
    last = rows(tmp_path / "out" / "study_rare.csv")[-1]
    vector = openturns.RandomVector(inputs())
    event = openturns.ThresholdEvent(openturns.CompositeRandomVector(speed(), vector), openturns.Greater(), 1.15)
    openturns.RandomGenerator.SetSeed(1)
    search = openturns.SubsetSampling(event)
    search.setMaximumOuterSampling(40000)
    search.setBlockSize(1)
    search.run()
    exact = search.getResult().getProbabilityEstimate()
    assert 1e-5 < exact < 1e-3
    assert float(last["lower"]) <= exact <= float(last["upper"])
