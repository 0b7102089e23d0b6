from typing import Any, Sequence

import numpy
import numpy.typing

from ._engine import Recording, Snapshot, Structure

class PictureOptions:
    def __init__(
        self,
        width: int,
        height: int,
        camera: str,
        color_by: str,
        background: str,
        title: str,
        contact_arrows: bool,
        trails: bool,
        ghost: bool,
        target_opacity: float,
        supersampling: int,
    ) -> None: ...

def draw_recording(recording: Recording, time: float, options: PictureOptions) -> numpy.typing.NDArray[numpy.uint8]: ...
def draw_snapshot(
    structure: Structure, snapshot: Snapshot, options: PictureOptions
) -> numpy.typing.NDArray[numpy.uint8]: ...
def png_of(pixels: numpy.typing.NDArray[Any]) -> bytes: ...
def figure_of(recordings: Sequence[Recording], name: str, format: str, resolution: float) -> bytes: ...
def figure_names() -> list[str]: ...
