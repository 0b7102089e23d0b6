"""Runs the commands of a page of the documentation as its reader would.

Fenced blocks of a page are
- ```sh             commands, run one block after the other in one folder; `cd` stays in force
- ```toml NAME      a file (also python NAME, cpp NAME and others), written into that folder
- ```output         replaced by what the commands before it printed; ```output 3-9 by these lines of it
- ```console        commands that are only shown: they need root or another machine
Other blocks are text. /usr/share/doc/netpocket/examples stands for the folder of scenarios, so that a page can be run before
the program is installed.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

EXAMPLES = "/usr/share/doc/netpocket/examples"
FENCE = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


class CommandFailed(Exception):
    """A command of a page failed: says which and what it wrote."""


@dataclass
class Environment:
    """Where commands find the program, the module for Python and the scenarios."""

    program: pathlib.Path
    scenarios: pathlib.Path
    python: pathlib.Path  # interpreter
    module: pathlib.Path | None = None  # folder of the module netpocket, if there is one

    def variables(self) -> dict[str, str]:
        variables = dict(os.environ)
        variables["PATH"] = f"{self.program.parent}:{self.python.parent}:{variables['PATH']}"
        if self.module:
            variables["PYTHONPATH"] = str(self.module)
        return variables


def selected(text: str, lines: str | None) -> str:
    """Lines of a text, counted from 1: "3-9", "3-" or all."""
    if not lines:
        return text
    first, _, last = lines.partition("-")
    return "".join(text.splitlines(keepends=True)[int(first) - 1 : int(last) if last else None])


def run_block(block: str, folder: pathlib.Path, environment: Environment) -> tuple[str, pathlib.Path]:
    """What the commands print, and the folder in which they end."""
    read, write = os.pipe()
    script = block.replace(EXAMPLES, str(environment.scenarios)) + f"\npwd >&{write}\n"
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=environment.variables(), text=True,
                          pass_fds=(write,), stdin=subprocess.DEVNULL, capture_output=True, check=False)
    os.close(write)
    with os.fdopen(read) as end:
        ended_in = end.read().strip()
    if done.returncode != 0:
        raise CommandFailed(f"status {done.returncode} of\n{block}\n{done.stdout}{done.stderr}")
    return done.stdout, pathlib.Path(ended_in)


def run_page(text: str, folder: pathlib.Path, environment: Environment) -> str:
    """Runs a page's commands in an empty folder. Returns the page with what they printed."""
    here, printed = folder, ""

    def replace(match: re.Match[str]) -> str:
        nonlocal here, printed
        kind, word, body = match[1], match[2], match[3]
        if kind == "sh":
            printed, here = run_block(body, here, environment)
        elif kind == "output":
            shown = selected(printed, word).replace(str(environment.scenarios), EXAMPLES).replace(str(folder), "~")
            return f"```text\n{shown.rstrip()}\n```"
        elif kind == "console":
            return f"```sh\n{body}```"
        elif word:
            (here / word).parent.mkdir(parents=True, exist_ok=True)
            (here / word).write_text(body.replace(EXAMPLES, str(environment.scenarios)))
            return f"```{{code-block}} {kind}\n:caption: {word}\n\n{body}```"
        return match[0]

    return FENCE.sub(replace, text)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("scenarios", type=pathlib.Path)
    parser.add_argument("module", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()
    environment = Environment(arguments.program, arguments.scenarios, pathlib.Path(sys.executable), arguments.module)
    with tempfile.TemporaryDirectory() as folder:
        try:
            run_page(arguments.page.read_text(), pathlib.Path(folder), environment)
        except CommandFailed as failure:
            raise SystemExit(f"{arguments.page.name}: {failure}") from failure


if __name__ == "__main__":
    main()
