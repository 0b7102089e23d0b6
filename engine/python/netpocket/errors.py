"""What netpocket raises."""

from __future__ import annotations

from typing import NamedTuple, Sequence


class Problem(NamedTuple):
    """One problem of a scenario."""

    file: str
    """As it was named; empty for values set from Python."""
    line: int
    """1-based; 0 when it does not apply."""
    key: str
    """Such as 'net.diameter'; empty when it does not apply."""
    message: str

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}: " if self.line else f"{self.file}: " if self.file else ""
        return place + (f"{self.key}: " if self.key else "") + self.message


class ScenarioError(ValueError):
    """A scenario that cannot be read or simulated. `problems` has them all."""

    def __init__(self, problems: Sequence[Problem]) -> None:
        self.problems = list(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))

    def __reduce__(self) -> tuple[type[ScenarioError], tuple[list[Problem]]]:
        return (type(self), (self.problems,))


class DivergedError(RuntimeError):
    """A run that diverged: which step failed, where, and a likely remedy."""


class FileError(OSError):
    """A file that cannot be read or written."""


class RecordingError(FileError):
    """A file that is not a valid recording."""
