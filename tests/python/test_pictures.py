import numpy
import pytest

import netpocket


def test_a_picture_shows_the_pocket(recording_path):
    recording = netpocket.Recording(str(recording_path))
    picture = netpocket.render(recording, size=(320, 240))
    assert picture.shape == (240, 320, 3) and picture.dtype == numpy.uint8
    drawn = (numpy.asarray(picture).max(axis=2) < 250).mean()
    assert 0.05 < drawn < 0.7
    first = netpocket.render(recording, frame=0, size=(320, 240))
    assert (numpy.asarray(first) != numpy.asarray(picture)).any()
    same = netpocket.render(recording, time=0, size=(320, 240))
    assert (numpy.asarray(first) == numpy.asarray(same)).all()


def test_a_simulation_is_drawn_as_it_is_now(scenario):
    picture = netpocket.render(netpocket.Simulation(scenario), size=(200, 160), camera="front", background="space")
    assert picture.shape == (160, 200, 3) and numpy.asarray(picture).std() > 5


def test_notebooks_get_png(recording_path, tmp_path):
    picture = netpocket.render(netpocket.Recording(str(recording_path)), size=(64, 48))
    assert picture._repr_png_().startswith(b"\x89PNG")
    picture.save(tmp_path / "picture.png")
    assert (tmp_path / "picture.png").read_bytes() == picture._repr_png_()
    assert picture[:, :, 0]._repr_png_() is None
    with pytest.raises(ValueError):
        picture[:, :, 0].save(tmp_path / "part.png")


def test_figures_are_bytes(recording_path):
    recording = netpocket.Recording(str(recording_path))
    assert netpocket.figure(recording, "figure03_closing")._repr_svg_().lstrip().startswith("<?xml")
    assert netpocket.figure(recording, "energy", format="png", resolution=50).startswith(b"\x89PNG")
    assert netpocket.figure([recording, recording], "tension", format="pdf").startswith(b"%PDF")
    with pytest.raises(ValueError, match="figure03_closing"):
        netpocket.figure(recording, "figure03_closng")


@pytest.mark.parametrize("options, says", [
    ({"camera": "top"}, "top"), ({"color_by": "colour"}, "colour"), ({"background": "red"}, "red"),
    ({"size": (4, 4)}, "16"), ({"size": (100000, 100)}, "16384"), ({"target_opacity": 2}, "0 to 1"),
    ({"frame": 1, "time": 2}, "not both"),
])
def test_wrong_options_are_value_errors(recording_path, options, says):
    with pytest.raises(ValueError, match=says):
        netpocket.render(netpocket.Recording(str(recording_path)), **options)


def test_wrong_sources(scenario):
    with pytest.raises((TypeError, AttributeError)):
        netpocket.render("run.h5")
    with pytest.raises(ValueError, match="as it is now"):
        netpocket.render(netpocket.Simulation(scenario), time=1)
