"""Many runs, and tables of runs. Tables need pandas; everything else does not."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Sequence, Union

from . import _engine

if TYPE_CHECKING:
    import pandas

Run = Union[_engine.Recording, _engine.MemoryRun]


def run_many(scenarios: Iterable[_engine.Scenario], jobs: Optional[int] = None) -> list[_engine.MemoryRun]:
    """Runs scenarios to their end times, several at the same time, and keeps their channels in memory.

    `jobs`: runs at the same time; None: one for each processor. Results do not depend on it. Ctrl-C stops all.
    """
    return _engine.run_in_memory(list(scenarios), jobs or os.cpu_count() or 1)


def _channels(run: Run) -> Mapping[str, Any]:
    if isinstance(run, _engine.Recording):
        return {channel.name: run[channel.name] for channel in run.channels}
    return run.channels


def table(run: Union[Run, Sequence[Run]]) -> pandas.DataFrame:
    """Channels as a pandas table: a row for each frame. For several runs, a column `run` counts them from 0."""
    import pandas

    if isinstance(run, (_engine.Recording, _engine.MemoryRun)):
        return pandas.DataFrame(dict(_channels(run)))
    frames = [pandas.DataFrame(dict(_channels(one))).assign(run=number) for number, one in enumerate(run)]
    return pandas.concat(frames, ignore_index=True)


def study_table(folder: Union[str, os.PathLike[str]]) -> pandas.DataFrame:
    """The table of a study that `netpocket study` wrote to a folder."""
    import pandas

    return pandas.read_csv(pathlib.Path(folder) / "study.csv")
