#!/usr/bin/env python3
"""Puts the documentation together and builds it with Sphinx: runs all commands of its pages, draws all pictures, writes the
pages that the program knows best. Needs no network; the result opens from a folder.

usage: build_site.py PROGRAM FOLDER [--module DIR] [--jobs N]

FOLDER/source gets the pages, FOLDER/html the documentation. Pages that are newer than what they are made from are kept.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

import gallery
import reference_pages
import repository_pages
from page_commands import CommandFailed, Environment, run_page

SITE = pathlib.Path(__file__).resolve().parent
REPOSITORY = SITE.parent.parent
VIDEO = re.compile(r"^```\{video\} (\S+)\n```$", re.MULTILINE)


def with_videos(text: str, page: pathlib.Path, stage: pathlib.Path) -> str:
    """Videos as HTML; their files go where Sphinx copies them from."""

    def replace(match: re.Match[str]) -> str:
        file = page.parent / match[1]
        name = "_".join(file.relative_to(stage).parts)
        (stage / "_static").mkdir(exist_ok=True)
        shutil.copy(file, stage / "_static" / name)
        up = "../" * (len(page.relative_to(stage).parts) - 1)
        return f'```{{raw}} html\n<video controls muted playsinline preload="metadata" src="{up}_static/{name}"></video>\n```'

    return VIDEO.sub(replace, text)


def is_up_to_date(goal: pathlib.Path, *sources: pathlib.Path) -> bool:
    return goal.exists() and goal.stat().st_mtime > max(source.stat().st_mtime for source in sources)


def write_page(page: pathlib.Path, stage: pathlib.Path, environment: Environment) -> None:
    """A page with its commands run, in a folder of the page's name."""
    goal = stage / page.relative_to(SITE / "pages")
    folder = goal.with_suffix("")
    if is_up_to_date(goal, page, environment.program, SITE / "page_commands.py", *environment.scenarios.glob("*.toml")):
        return
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    try:
        text = run_page(page.read_text(), folder, environment)
    except CommandFailed as failure:
        raise SystemExit(f"{page.relative_to(REPOSITORY)}: {failure}") from failure
    text = text.replace("{literalinclude} repository:", f"{{literalinclude}} {os.path.relpath(REPOSITORY, goal.parent)}/")
    goal.write_text(with_videos(text, goal, stage))
    print(f"{page.name}: done", flush=True)


def version() -> str:
    found = re.search(r"VERSION (\d+\.\d+\.\d+)", (REPOSITORY / "CMakeLists.txt").read_text())
    assert found
    return found[1]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--module", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    stage = arguments.folder.resolve() / "source"
    stage.mkdir(parents=True, exist_ok=True)
    environment = Environment(program=program, scenarios=REPOSITORY / "scenarios", python=pathlib.Path(sys.executable),
                              module=arguments.module and arguments.module.resolve())

    (stage / "_static").mkdir(exist_ok=True)
    shutil.copy(SITE / "conf.py", stage)
    shutil.copy(SITE / "site.css", stage / "_static")
    shutil.copy(SITE.parent / "package/netpocket.svg", stage / "_static")
    shutil.copytree(SITE / "scripts", stage / "_static/scripts", dirs_exist_ok=True)
    repository_pages.write_pages(REPOSITORY, stage)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(lambda page: write_page(page, stage, environment), sorted((SITE / "pages").rglob("*.md"))))
    page, recordings = gallery.gallery_page(str(program), REPOSITORY / "scenarios", stage, arguments.jobs)
    (stage / "gallery.md").write_text(with_videos(page, stage / "gallery.md", stage))
    (stage / "reference/commands.md").write_text(reference_pages.commands_page(str(program)))
    (stage / "reference/metrics.md").write_text(reference_pages.metrics_page(str(program), stage / "gallery/case1.h5"))
    (stage / "reference/channels.md").write_text(reference_pages.channels_page(recordings))
    done = subprocess.run(["sphinx-build", "-W", "--keep-going", "-q", "-b", "html", str(stage), str(stage.parent / "html")],
                          env=os.environ | {"NETPOCKET_VERSION": version(), "PYTHONDONTWRITEBYTECODE": "1"}, check=False)
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
