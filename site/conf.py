# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx's settings for the site; scripts/site runs it."""

import re
from pathlib import Path

from docutils import nodes
from latex2mathml.converter import convert

ROOT = Path(__file__).resolve().parents[1]

project = "B-spline curves on triangle meshes"
version = release = re.search(r"project\(bspline_curve VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
author = "the authors of bspline_curve"
copyright = "GPL-3.0-or-later"  # noqa: A001
language = "en"

extensions = ["myst_parser"]
include_patterns = ["*.md", "cpp/*.md", "docs/*.md"]
root_doc = "index"
highlight_language = "text"  # most blocks are commands

myst_enable_extensions = ["dollarmath", "html_image"]
myst_fence_as_directive = ["math"]
myst_heading_anchors = 4  # as GitHub makes them

html_theme = "furo"
html_title = f"bspline_curve {version}"
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = None  # the same pages from the same sources
html_math_renderer = "mathml"


def setup(app):
    """Formulas as MathML, which browsers show by themselves: no script from elsewhere is loaded."""

    def shows(display):
        def visit(translator, node):
            translator.body.append(convert(node.astext(), display=display))
            raise nodes.SkipNode

        return visit, None

    app.add_html_math_renderer("mathml", shows("inline"), shows("block"))
