#!/usr/bin/env python3
"""Writes the reference from the doc strings: reference.py > engine/python/API.md, with the module on PYTHONPATH."""

import inspect
import re
from types import ModuleType
from typing import Any

import netpocket


def plain(signature: str) -> str:
    """A signature of pybind11 as one would write it in Python."""
    signature = signature.replace("netpocket._engine.", "").replace("netpocket._pictures.", "")
    signature = re.sub(r"numpy\.ndarray\[[^\]]*\]+", "array", signature)
    signature = re.sub(r"self: \w+(, )?", "", signature)
    signature = re.sub(r" = array\(\[[^)]*\)", " = (0, 0, 0)", signature)
    return signature


def described(name: str, thing: Any) -> tuple[str, str]:
    """Signature and text of a function, method or property."""
    text = inspect.getdoc(thing) or ""
    if isinstance(thing, property) or inspect.isdatadescriptor(thing):
        return name, text
    first, _, rest = text.partition("\n")
    if first.startswith(name + "("):  # pybind11 puts the signature into the doc string
        return plain(first), rest.strip()
    try:
        signature = str(inspect.signature(thing)).replace("'", "").replace("_engine.", "")
        return name + re.sub(r" = <[^>]*>", " = ...", re.sub(r"\(self(, )?", "(", signature)), text
    except (TypeError, ValueError):
        return name, text


def members_of(cls: type) -> list[str]:
    shown = ("__init__", "__getitem__", "__setitem__", "__len__")
    lines = []
    for name, member in vars(cls).items():
        if name.startswith("_") and name not in shown:
            continue
        if not (callable(member) or isinstance(member, property) or inspect.isdatadescriptor(member)):
            continue
        signature, text = described(name, member)
        if name in shown and (not text or "*args" in signature):
            continue
        text = "" if text.startswith(("Alias for", "Initialize self")) else text
        lines.append(f"- `{signature}`" + (f": {' '.join(text.split())}" if text else ""))
    return lines


def reference(module: ModuleType) -> str:
    classes = [name for name in module.__all__ if inspect.isclass(getattr(module, name))]
    functions = [name for name in module.__all__ if name not in classes]
    lines = ["# Reference of the module `netpocket`", "", "Made from the doc strings by `tests/python/reference.py`. SI units.", "",
             "## Functions", ""]
    for name in functions:
        signature, text = described(name, getattr(module, name))
        lines += [f"### `{signature}`", "", text, ""]
    lines += ["## Classes", ""]
    for name in classes:
        cls = getattr(module, name)
        lines += [f"### `{name}`", "", inspect.getdoc(cls) or "", "", *members_of(cls), ""]
    return re.sub("\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"


if __name__ == "__main__":
    print(reference(netpocket), end="")
