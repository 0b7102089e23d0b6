#!/usr/bin/env python3
"""Writes the manual pages of the program and of each of its commands from their --help.

usage: make_man_pages.py PROGRAM FOLDER
"""

import gzip
import pathlib
import re
import subprocess
import sys


def escaped(text: str) -> str:
    """Text that troff shows as it is."""
    text = text.replace("\\", "\\\\").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def entries(lines: list[str]) -> list[tuple[str, str]]:
    """Options, commands or codes with their descriptions, which may go on in further lines."""
    found: list[tuple[str, str]] = []
    for line in lines:
        if found and re.match(r" {8,}", line):
            found[-1] = (found[-1][0], (found[-1][1] + " " + line.strip()).strip())
        else:
            name, _, text = line.strip().partition("  ")
            found.append((name, text.strip()))
    return found


def body(text: str) -> list[str]:
    """Sections ("Options:") and paragraphs of a help text, in troff."""
    page = []
    for block in re.split(r"\n\s*\n", text):
        lines = block.strip("\n").split("\n")
        title = re.fullmatch(r"(\S.*):", lines[0])
        if title and len(lines) > 1 and all(line.startswith("  ") for line in lines[1:]):
            page.append(f'.SH "{title[1].upper()}"')
            if title[1] == "Examples":
                page += [".nf", *(escaped(line.strip()) for line in lines[1:]), ".fi"]
            else:
                for name, description in entries(lines[1:]):
                    page += [".TP", f"\\fB{escaped(name)}\\fP", escaped(description)]
        elif all(line.startswith("  ") for line in lines):
            page += [".PP", ".nf", *(escaped(line.strip()) for line in lines), ".fi"]
        else:
            page += [".PP", *(escaped(line.strip()) for line in lines)]
    return page


def manual(name: str, summary: str, version: str, text: str, others: list[str]) -> str:
    usage = re.search(r"^Usage: (.*)$", text, re.MULTILINE)
    assert usage, f"{name} --help has no usage"
    page = [f'.TH {name.upper()} 1 "" "{version}" "User Commands"', ".SH NAME", f"{name} \\- {escaped(summary)}",
            ".SH SYNOPSIS", escaped(usage[1]), ".SH DESCRIPTION"]
    page += body(text.replace(usage[0], ""))
    page += [".SH FILES", escaped("/usr/share/doc/netpocket/examples: scenarios and the reference of their keys")]
    page += [".SH SEE ALSO", ", ".join(f"\\fB{escaped(other)}\\fP(1)" for other in others if other != name)]
    return "\n".join(page) + "\n"


def main() -> None:
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)

    def said(*arguments: str) -> str:
        return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout

    version = re.sub(r" \(.*", "", said("--version").split("\n")[0])
    text = said("--help")
    commands = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
    assert commands
    pages = {"netpocket": ("simulate the capture of space debris with a netted pocket", text)}
    for command, summary in entries(commands[1].rstrip().split("\n")):
        pages[f"netpocket-{command}"] = (summary, said(command, "--help"))
    for name, (summary, help_text) in pages.items():
        with gzip.GzipFile(folder / f"{name}.1.gz", "wb", mtime=0) as file:
            file.write(manual(name, summary, version, help_text, list(pages)).encode())


if __name__ == "__main__":
    main()
