#!/usr/bin/env python3
"""Checks the documentation as built: every link and picture leads to something, browsers report nothing on any page, and no page
is wider than a phone's screen.

usage: check_site.py FOLDER [--jobs N]

FOLDER is that of index.html. Needs Chromium; reaches no network.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

PHONE_WIDTH = 390  # pixels
# Added to a copy of each page, which is shown in a frame as wide as a phone: windows of a browser are wider. The frame's page
# takes the width as its title.
MEASURE = """<script>window.addEventListener("load", () => parent.postMessage(document.documentElement.scrollWidth, "*"));</script>"""
FRAME = """<!DOCTYPE html><title>none</title><body><script>
window.addEventListener("message", (event) => { document.title = "width " + event.data; });</script>
<iframe src="%s" width="%d" height="900" style="border: 0"></iframe>"""


class Page(html.parser.HTMLParser):
    """Links and anchors of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.targets: set[str] = set()
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if value and name in ("href", "src"):
                self.targets.add(value)
            elif value and name in ("id", "name"):
                self.anchors.add(value)


def broken_links(folder: pathlib.Path, pages: dict[pathlib.Path, Page]) -> list[str]:
    faults = []
    for path, page in pages.items():
        for target in sorted(page.targets):
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            there = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not there.exists():
                faults.append(f"{path.relative_to(folder)}: {target} leads nowhere")
            elif parts.fragment and there in pages and urllib.parse.unquote(parts.fragment) not in pages[there].anchors:
                faults.append(f"{path.relative_to(folder)}: {target} names no part of that page")
    return faults


def seen_by_browser(page: pathlib.Path, folder: pathlib.Path) -> list[str]:
    """What Chromium reports on a page at the width of a phone."""
    name = page.relative_to(folder)
    with tempfile.TemporaryDirectory() as settings:
        copy, frame = page.with_name(f"checked_{page.name}"), page.with_name(f"frame_{page.name}")
        copy.write_text(page.read_text().replace("</head>", MEASURE + "</head>", 1))
        frame.write_text(FRAME % (copy.name, PHONE_WIDTH))
        try:
            seen = subprocess.run(
                ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
                 "--host-resolver-rules=MAP * ~NOTFOUND", "--proxy-server=127.0.0.1:9", f"--user-data-dir={settings}", "--hide-scrollbars",
                 "--window-size=600,1000", "--virtual-time-budget=10000", "--enable-logging=stderr", "--dump-dom", f"file://{frame}"],
                capture_output=True, text=True, timeout=240, check=False)
        finally:
            copy.unlink()
            frame.unlink()
    faults = [f"{name}: {message}" for message in re.findall(r":CONSOLE.*?\] (.*)", seen.stderr)]
    width = re.search(r"<title>width (\d+)</title>", seen.stdout)
    if not width:
        faults.append(f"{name}: the browser does not show it")
    elif int(width[1]) > PHONE_WIDTH:
        faults.append(f"{name}: {width[1]} pixels wide on a screen of {PHONE_WIDTH}")
    return faults


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    paths = sorted(path for path in folder.rglob("*.html") if "_static" not in path.parts)
    pages = {path: Page(path.read_text()) for path in paths}
    faults = broken_links(folder, pages)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for found in pool.map(lambda path: seen_by_browser(path, folder), paths):
            faults += found
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(pages)} pages, {sum(len(page.targets) for page in pages.values())} links, {len(faults)} faults")
    sys.exit(1 if faults or not pages else 0)


if __name__ == "__main__":
    main()
