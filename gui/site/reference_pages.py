"""Pages that the program itself writes: commands from their --help, channels and metrics from a recording."""

from __future__ import annotations

import csv
import io
import pathlib
import re
import subprocess


def output_of(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def commands_page(program: str) -> str:
    overview = output_of(program, "--help")
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", overview, re.MULTILINE)
    assert listed, "netpocket --help lists no commands"
    page = ["# Commands", "", "What `netpocket --help` and `netpocket COMMAND --help` print. The package has the same as manual pages.", "",
            "```text", overview.rstrip(), "```", ""]
    for command, summary in re.findall(r"^  (\S+) +(.*)$", listed[1], re.MULTILINE):
        page += [f"## {command}", "", summary[0].upper() + summary[1:] + ".", "", "```text",
                 output_of(program, command, "--help").rstrip(), "```", ""]
    return "\n".join(page)


def table(head: list[str], rows: list[list[str]]) -> list[str]:
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows)]


def metrics_page(program: str, recording: pathlib.Path) -> str:
    rows = csv.DictReader(io.StringIO(output_of(program, "metrics", str(recording), "--csv")))
    return "\n".join(["# Metrics", "", "What `netpocket metrics`, studies and reports say about a capture. A number that does not exist is left out: it did "
                      "not happen, or was not recorded. The unit 1 means that the number has none.", "",
                      *table(["metric", "unit", "meaning"], [[f"`{r['name']}`", r["unit"], r["meaning"]] for r in rows]), ""])


# What the kinds of channels say about a value (recording/FORMAT.md).
KINDS = {"value": "at the frame", "interval": "over the interval since the last frame", "total": "since the start",
         "index": "number of a part"}


def channels_page(recordings: list[pathlib.Path]) -> str:
    """Of all recordings, each channel once. Needs h5py."""
    import h5py  # noqa: PLC0415, only the documentation needs it

    found: dict[str, tuple[str, str, str]] = {}
    for recording in recordings:
        with h5py.File(recording) as file:
            attributes = file["frames/channels"].attrs
            text = {key: attributes[key].decode() if isinstance(attributes[key], bytes) else str(attributes[key])
                    for key in ("names", "units", "kinds", "meanings")}
        for name, unit, kind, meaning in zip(text["names"].split(","), text["units"].split(","), text["kinds"].split(","),
                                             text["meanings"].split("\n"), strict=True):
            found.setdefault(name, (unit, kind, meaning))
    rows = [[f"`{name}`", unit, KINDS.get(kind, kind), meaning] for name, (unit, kind, meaning) in found.items()]
    return "\n".join(["# Channels", "", "A channel has one number for each recorded frame. `netpocket export --csv` writes all channels of a recording, the "
                      "window plots them, and `recording[\"contact_fy\"]` reads one in Python. Which channels a recording has depends on its "
                      "scenario: controllers, sensors and winches bring their own.", "",
                      *table(["channel", "unit", "taken", "meaning"], rows), ""])
