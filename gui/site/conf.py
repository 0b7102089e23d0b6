"""Settings of Sphinx for the documentation; build_site.py calls it on the pages that it has put together."""

import os

project = "Netpocket"
author = "The Netpocket authors"
copyright = "The Netpocket authors, BSD 3-Clause licence"  # noqa: A001, the name is Sphinx's
release = version = os.environ["NETPOCKET_VERSION"]

extensions = ["myst_parser"]
myst_heading_anchors = 4
# Documents of the repository are whole pages here: their headings may begin at any level.
suppress_warnings = ["myst.header"]
exclude_patterns = ["start/**", "tutorials/*/**", "gallery/**"]

html_theme = "furo"
html_title = f"Netpocket {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_favicon = "_static/netpocket.svg"
html_logo = "_static/netpocket.svg"
html_copy_source = False
html_show_sourcelink = False
pygments_style = "friendly"
