"""Sphinx configuration; ``make docs`` builds the site into docs/_build/html."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import api  # noqa: E402
import generate  # noqa: E402
from numpydoc import xref  # noqa: E402

import contourlab  # noqa: E402

generate.write()

project = "contourlab"
version = release = contourlab.__version__
project_copyright = "the contourlab authors"
extensions = ["live", "myst_parser", "numpydoc", "sphinx.ext.autosummary", "sphinx_copybutton", "sphinx_gallery.gen_gallery"]
exclude_patterns = ["_build", "_templates"]
templates_path = ["_templates"]
highlight_language = "none"  # formulas are indented blocks

myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]

autosummary_generate = True
autosummary_filename_map = {"contourlab.component": "contourlab.component-function"}  # some systems ignore case
smartquotes = False  # quotes belong to code
default_role = "code"  # names in docstrings
autodoc_typehints = "none"  # the docstrings give types, with shapes and units
numpydoc_xref_param_type = True  # and lead to the pages of types
numpydoc_xref_ignore = "all"  # no other word
numpydoc_xref_aliases = api.links()
xref.DEFAULT_LINKS.clear()  # words of Python, on another site
numpydoc_validation_checks = {"PR02"}  # a docstring names no parameter that does not exist
numpydoc_show_class_members = False  # the template lists them

sphinx_gallery_conf = {
    "examples_dirs": "../examples",
    "gallery_dirs": "examples",
    "filename_pattern": r"\.py$",
    "abort_on_example_error": True,
    "download_all_examples": False,
    "show_memory": False,
    "write_computation_times": False,  # its pages load scripts from elsewhere
    "min_reported_time": 1000,
    "show_signature": False,
    "image_scrapers": ("matplotlib", "live.of_examples"),
    "ignore_repr_types": "Viewer",
    "within_subsection_order": "FileNameSortKey",
}

html_theme = "pydata_sphinx_theme"
html_title = "contourlab"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "navigation_with_keys": False,
    "show_toc_level": 2,
    "header_links_before_dropdown": 7,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
}


def setup(app: Any) -> None:
    """Mend links to files outside of this folder that have a page on the site."""

    def relink(app: Any, name: str, source: list[str]) -> None:
        page = Path(app.env.doc2path(name))
        if page.suffix == ".md":
            source[0] = generate.relinked(source[0], page, page)

    app.connect("source-read", relink)
