import gc
import pathlib

import numpy
import pytest

import netpocket


def test_channels_and_frames(recording_path):
    recording = netpocket.Recording(str(recording_path))
    assert len(recording) == recording.times.shape[0] == 51
    assert recording.times[-1] == pytest.approx(1)
    names = [channel.name for channel in recording.channels]
    assert "mouth_radius" in recording and "mouth_radius" in names and "nothing" not in recording
    assert all(channel.unit and channel.meaning for channel in recording.channels)
    last = recording.frame(-1)
    assert last.time == recording.times[-1] and last["mouth_radius"] == recording["mouth_radius"][-1]
    assert last.positions.shape == (recording.structure.node_count, 3)
    assert recording.frame_at(0.5) == 25
    assert recording.status.reason == "finished" and recording.statistics.steps > 100
    assert recording.scenario["pocket.mesh_rows"] == 2


def test_errors(recording_path, tmp_path):
    recording = netpocket.Recording(str(recording_path))
    with pytest.raises(IndexError, match="no frame 51"):
        recording.frame(51)
    with pytest.raises(IndexError):
        recording.frame(-52)
    with pytest.raises(KeyError, match="wind"):
        recording["wind"]
    with pytest.raises(netpocket.FileError, match="nothing.h5"):
        netpocket.Recording(str(tmp_path / "nothing.h5"))
    (tmp_path / "text.h5").write_text("no recording")
    with pytest.raises(netpocket.RecordingError):
        netpocket.Recording(str(tmp_path / "text.h5"))
    with pytest.raises(TypeError):
        netpocket.Recording(5)
    with pytest.raises(netpocket.FileError, match="small.h5"):
        netpocket.record(recording.scenario, str(recording_path))  # no overwriting unless it is asked for


def test_views_keep_the_recording(recording_path):
    force = netpocket.Recording(str(recording_path))["energy_kinetic"]
    gc.collect()
    assert force.shape == (51,) and force[-1] > 0 and not force.flags.writeable


def test_tables(recording_path, scenario):
    recording = netpocket.Recording(str(recording_path))
    table = netpocket.table(recording)
    assert len(table) == 51 and table.mouth_radius.iloc[0] > 7
    both = netpocket.table([recording, netpocket.run_many([scenario])[0]])
    assert set(both.run) == {0, 1} and len(both) == 102


def test_structure(recording_path):
    structure = netpocket.Recording(str(recording_path)).structure
    assert structure.element_nodes.max() < structure.node_count
    assert structure.element_thread.max() < len(structure.threads)
    assert structure.element_group.max() < len(structure.groups)
    assert len(structure.nodes("rod tips")) == 8 and structure.nodes("nothing") == []
    assert [body.name for body in structure.bodies] == ["spacecraft", "target"]


def test_plain_h5py_reads_the_same(recording_path):
    """The example of engine/recording/FORMAT.md."""
    import h5py

    with h5py.File(recording_path, "r") as file:
        table = file["frames/channels"]
        names = table.attrs["names"].decode().split(",")
        channels = dict(zip(names, numpy.asarray(table).T))
        positions = file["frames/position"][10]
    recording = netpocket.Recording(str(recording_path))
    assert names == [channel.name for channel in recording.channels]
    assert all((channels[name] == recording[name]).all() for name in names)
    assert (positions == recording.frame(10).positions).all()


def test_a_study_reads_as_a_table(tmp_path):
    import os
    import subprocess

    (tmp_path / "base.toml").write_text(
        'name = "base"\n[pocket]\nmesh_columns = 2\nmesh_rows = 2\nelements_per_side = 1\n[output]\nend_time = 0.2\n')
    (tmp_path / "study.toml").write_text(
        'name = "s"\nbase = "base.toml"\n[vary]\ntarget.radius = [3, 4]\n')
    result = subprocess.run([os.environ["NETPOCKET"], "study", "study.toml", "-o", "out"], cwd=tmp_path, capture_output=True,
                            text=True)
    assert result.returncode == 0, result.stderr
    table = netpocket.study_table(tmp_path / "out")
    assert sorted(table["target.radius"]) == [3, 4]
