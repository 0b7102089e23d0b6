"""Documents of the repository as pages of the documentation: copies with their links led to the pages, or taken away."""

from __future__ import annotations

import os
import pathlib
import re
import shutil

# Path in the repository, and of the page.
PAGES = {
    "scenarios/REFERENCE.md": "reference/parameters.md",
    "scenarios/studies/README.md": "reference/studies.md",
    "scenarios/FINDINGS.md": "reference/findings.md",
    "scenarios/CONTROL_FINDINGS.md": "reference/control_findings.md",
    "scenarios/THROWN_FINDINGS.md": "reference/thrown_findings.md",
    "scenarios/CAPTURE.md": "reference/capture.md",
    "engine/THEORY.md": "reference/model.md",
    "engine/recording/FORMAT.md": "reference/recordings.md",
    "engine/python/README.md": "reference/python.md",
    "engine/python/API.md": "reference/python_api.md",
    "engine/python/examples/first_capture.md": "reference/python_examples/first_capture.md",
    "engine/python/examples/own_controller.md": "reference/python_examples/own_controller.md",
    "engine/python/examples/probability_map.md": "reference/python_examples/probability_map.md",
    "engine/python/examples/random_policy.md": "reference/python_examples/random_policy.md",
    "engine/python/examples/sweep.md": "reference/python_examples/sweep.md",
    "tests/VERIFICATION.md": "reference/verification.md",
    "CHANGELOG.md": "reference/changes.md",
}
PICTURES = {".png", ".svg", ".jpg"}
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def led_to_pages(text: str, document: str, page: str, repository: pathlib.Path, stage: pathlib.Path) -> str:
    """The text of a document with links as its page needs them. Pictures are copied beside the page."""

    def replace(match: re.Match[str]) -> str:
        is_picture, words, target = match[1], match[2], match[3]
        if re.match(r"[a-z]+:|#", target):
            return match[0]
        path, _, anchor = target.partition("#")
        there = os.path.normpath(os.path.join(os.path.dirname(document), path))
        here = os.path.dirname(page)
        if there in PAGES:
            return f"[{words}]({os.path.relpath(PAGES[there], here)}{'#' + anchor if anchor else ''})"
        if is_picture and pathlib.Path(path).suffix in PICTURES:
            copy = stage / here / "pictures" / there.replace("/", "_")
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(repository / there, copy)
            return f"![{words}](pictures/{copy.name})"
        return words if words.startswith("`") else f"{words} (`{there}` in the repository)"

    return LINK.sub(replace, text)


def under_one_title(text: str) -> str:
    """The text with all titles but the first as headings below it."""
    first, *others = re.split(r"^(?=# )", text, flags=re.MULTILINE)[1:]
    return first + "".join("#" + other for other in others)


def glossary(readme: str) -> str:
    """The section "Glossary" of the engine's README as a page."""
    section = re.search(r"^## Glossary\n(.*?)(?=^## |\Z)", readme, re.MULTILINE | re.DOTALL)
    assert section, "engine/README.md has no glossary"
    return "# Glossary\n" + section[1]


def write_pages(repository: pathlib.Path, stage: pathlib.Path) -> None:
    for document, page in PAGES.items():
        text = led_to_pages((repository / document).read_text(), document, page, repository, stage)
        (stage / page).parent.mkdir(parents=True, exist_ok=True)
        # Pages that the list of contents does not name are reached from others.
        orphan = "---\norphan: true\n---\n" if "python_examples" in page else ""
        (stage / page).write_text(orphan + under_one_title(text))
    (stage / "reference/glossary.md").write_text(glossary((repository / "engine/README.md").read_text()))
