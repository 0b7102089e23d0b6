"""The reference is that of the module, and the guide names only what exists."""

import os
import pathlib
import re

import netpocket
import reference

FOLDER = pathlib.Path(os.environ["NETPOCKET_SOURCE"], "engine", "python")


def test_the_reference_is_up_to_date():
    text = reference.reference(netpocket)
    if os.environ.get("NETPOCKET_RENEW"):
        (FOLDER / "API.md").write_text(text)
    assert (FOLDER / "API.md").read_text() == text, "renew it with NETPOCKET_RENEW=1"


def test_everything_is_described():
    for name in netpocket.__all__:
        assert getattr(netpocket, name).__doc__, name


def test_the_guide_names_what_exists():
    guide = (FOLDER / "README.md").read_text()
    names = set(re.findall(r"netpocket\.([A-Za-z_]+)", guide)) - {"h5"}
    assert names and all(hasattr(netpocket, name) for name in names)
