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
html_copy_source = False
html_show_sourcelink = False

breathe_projects = {"libocean": os.environ["OCEAN_DOXYGEN_XML"]}
breathe_default_project = "libocean"
breathe_domain_by_extension = {"h": "c"}

sys.path.insert(0, str(ROOT / "libocean/python"))
autodoc_member_order = "bysource"
