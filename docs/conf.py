# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Configures Sphinx for the site; build.py calls it."""

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

project = "libocean"
author = "The libocean authors"
copyright = author  # noqa: A001, the name that Sphinx reads
version = re.search(
    r"OCEAN_VERSION \"(.*?)\"", (ROOT / "libocean/include/ocean/version.hpp").read_text()
)[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = f"libocean {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
# Furo's own dark colours. Debian's build of Furo has them for its switch alone: a reader whose
# system prefers dark would see dark code on a white page.
html_theme_options = {
    "dark_css_variables": {
        "color-problematic": "#ee5151",
        "color-foreground-primary": "#ffffffcc",
        "color-foreground-secondary": "#9ca0a5",
        "color-foreground-muted": "#81868d",
        "color-foreground-border": "#666666",
        "color-background-primary": "#131416",
        "color-background-secondary": "#1a1c1e",
        "color-background-hover": "#1e2124ff",
        "color-background-hover--transparent": "#1e212400",
        "color-background-border": "#303335",
        "color-background-item": "#444",
        "color-brand-primary": "#2b8cee",
        "color-brand-content": "#368ce2",
        "color-highlighted-background": "#083563",
        "color-guilabel-background": "#08356380",
        "color-guilabel-border": "#13395f80",
        "color-api-keyword": "var(--color-foreground-secondary)",
        "color-highlight-on-target": "#333300",
        "color-admonition-background": "#18181a",
        "color-card-background": "#18181a",
        "color-card-marginals-background": "var(--color-background-hover)",
    }
}
html_copy_source = False
html_show_sourcelink = False

breathe_projects = {"libocean": os.environ["OCEAN_DOXYGEN_XML"]}
breathe_default_project = "libocean"
breathe_domain_by_extension = {"h": "c"}

sys.path.insert(0, str(ROOT / "libocean/python"))
autodoc_member_order = "bysource"
