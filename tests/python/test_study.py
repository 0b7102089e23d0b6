"""The tables of a study in pandas, and a study in parts under GNU parallel."""

import os
import pathlib
import shutil
import subprocess

import pytest

PROGRAM = os.environ["NETPOCKET"]
SOURCE = pathlib.Path(os.environ["NETPOCKET_SOURCE"])
TABLES = ["study.csv", "study_columns.csv", "study_estimates.csv", "study.json"]

STUDY = """
base = "case1.toml"
sampling = "sobol"
samples = 6
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.02
[uncertain]
target.mass = { distribution = "uniform", min = 150, max = 250 }
"target.velocity[1]" = { distribution = "uniform", min = -0.5, max = -0.1 }
closing.law = { distribution = "discrete", values = ["cycloid", "quintic"] }
[estimate]
of = ["relative_speed_start"]
"""


@pytest.fixture
def study(tmp_path: pathlib.Path) -> pathlib.Path:
    shutil.copy(SOURCE / "scenarios" / "case1.toml", tmp_path)
    (tmp_path / "study.toml").write_text(STUDY)
    subprocess.run([PROGRAM, "study", "study.toml", "-o", "one", "--jobs", "1", "--quiet"], cwd=tmp_path, check=True)
    return tmp_path


def test_pandas_reads_the_tables(study: pathlib.Path) -> None:
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv(study / "one" / "study.csv")
    columns = pandas.read_csv(study / "one" / "study_columns.csv", index_col="name")
    assert list(table.columns) == list(columns.index)
    assert len(table) == 6
    assert table["target.mass"].between(150, 250).all()
    assert columns.loc["target.mass", "unit"] == "kg"
    # What was drawn is what the run had.
    assert (table["relative_speed_start"] + table["target.velocity[1]"]).abs().max() < 1e-12
    assert set(table["closing.law"]) <= {'"cycloid"', '"quintic"'}
    estimates = pandas.read_csv(study / "one" / "study_estimates.csv")
    median = estimates[(estimates["of"] == "relative_speed_start") & (estimates["statistic"] == "quantile_0.5")]
    # The smallest value that at least half of the values do not exceed: the third of six.
    assert median["value"].tolist() == [sorted(table["relative_speed_start"])[2]]


def test_hdf5_holds_the_table_with_units(study: pathlib.Path) -> None:
    h5py = pytest.importorskip("h5py")
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv(study / "one" / "study.csv", float_precision="round_trip")
    columns = pandas.read_csv(study / "one" / "study_columns.csv", index_col="name", keep_default_na=False)
    with h5py.File(study / "one" / "study.h5") as file:
        stored = {name: data.asstr()[:] if data.dtype.kind == "S" else data[:] for name, data in file["table"].items()}
        assert set(stored) == set(table.columns)
        for name, data in file["table"].items():
            assert data.attrs["unit"].decode() == columns.loc[name, "unit"], name
            assert data.attrs["help"].decode() == columns.loc[name, "meaning"], name
    frame = pandas.DataFrame(stored)[list(table.columns)]
    assert frame["point"].tolist() == [1, 2, 3, 4, 5, 6]
    for name in table.columns:
        if frame[name].dtype.kind == "f":
            assert frame[name].equals(table[name].astype(float)), name
        else:
            assert frame[name].astype(str).tolist() == table[name].fillna("").astype(str).tolist(), name


def test_sqlite_takes_the_table_in_one_line(study: pathlib.Path) -> None:
    pandas = pytest.importorskip("pandas")
    import sqlite3

    base = sqlite3.connect(study / "study.db")
    pandas.read_csv(study / "one" / "study.csv").to_sql("captures", base, index=False)
    (heaviest,) = base.execute('SELECT max("target.mass") FROM captures').fetchone()
    assert 150 <= heaviest <= 250


def test_parts_under_gnu_parallel_give_the_same_tables(study: pathlib.Path) -> None:
    if not shutil.which("parallel"):
        pytest.skip("GNU parallel is not there")
    command = f"seq 3 | parallel --will-cite -j 2 {PROGRAM} study study.toml -o parts --jobs 1 --quiet --part {{}}/3"
    subprocess.run(command, shell=True, cwd=study, check=True)
    for table in TABLES:
        assert (study / "parts" / table).read_bytes() == (study / "one" / table).read_bytes(), table
