"""Pictures and figures. They need no display, and show inline in notebooks."""

from __future__ import annotations

import ctypes
import os
import pathlib
from typing import Any, Optional, Sequence, Union

import numpy

from . import _engine

# VTK binds its OpenGL functions to those that the process has when it is loaded: to ours, which need no display.
ctypes.CDLL(str(pathlib.Path(__file__).with_name("_gl.so")), mode=ctypes.RTLD_GLOBAL)

from . import _pictures  # noqa: E402


class Picture(numpy.ndarray):  # type: ignore[type-arg]
    """Pixels (height, width, 3), uint8, rows from the top. A notebook shows it; save() writes it."""

    def _repr_png_(self) -> Optional[bytes]:
        if self.ndim != 3 or self.shape[2] != 3 or self.dtype != numpy.uint8:
            return None  # a part or a result of calculation that is no picture
        return _pictures.png_of(numpy.ascontiguousarray(self))

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes a PNG file."""
        data = self._repr_png_()
        if data is None:
            raise ValueError("only (height, width, 3) arrays of uint8 are pictures")
        pathlib.Path(path).write_bytes(data)


def render(
    source: Union[_engine.Recording, _engine.Simulation],
    *,
    frame: Optional[int] = None,
    time: Optional[float] = None,
    size: tuple[int, int] = (1280, 720),
    camera: str = "iso",
    color_by: str = "none",
    background: str = "white",
    title: str = "",
    contact_arrows: bool = False,
    trails: bool = False,
    ghost: bool = False,
    target_opacity: float = 1.0,
    supersampling: int = 2,
) -> Picture:
    """A picture of a recording, at a frame or a time (s; default: the last frame), or of a simulation now.

    `camera`: iso, side, front, mouth or follow. `color_by`: none, tension, strain, speed or contact. `background`:
    white or space. Pictures of one recording are framed alike.
    """
    options = _pictures.PictureOptions(
        size[0], size[1], camera, color_by, background, title, contact_arrows, trails, ghost, target_opacity, supersampling
    )
    if isinstance(source, _engine.Recording):
        if frame is not None and time is not None:
            raise ValueError("give a frame or a time, not both")
        if time is None:
            time = float(source.times[-1 if frame is None else frame])
        return _pictures.draw_recording(source, time, options).view(Picture)
    if frame is not None or time is not None or trails or ghost:
        raise ValueError("a simulation is drawn as it is now, without history")
    return _pictures.draw_snapshot(source.structure, source.snapshot(), options).view(Picture)


def figure_names() -> list[str]:
    """Names that figure() takes."""
    return _pictures.figure_names()


class Figure(bytes):
    """The bytes of a figure's file. A notebook shows PNG and SVG."""

    format: str

    def _repr_png_(self) -> Optional[bytes]:
        return bytes(self) if self.format == "png" else None

    def _repr_svg_(self) -> Optional[str]:
        return self.decode() if self.format == "svg" else None


def figure(
    recordings: Union[_engine.Recording, Sequence[_engine.Recording]],
    name: str,
    *,
    format: str = "svg",
    resolution: float = 150.0,
) -> Figure:
    """A figure of one or several runs: png, svg or pdf. `resolution`: dots per inch, for png."""
    runs = [recordings] if isinstance(recordings, _engine.Recording) else list(recordings)
    made = Figure(_pictures.figure_of(runs, name, format, resolution))
    made.format = format
    return made
