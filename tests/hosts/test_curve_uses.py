# SPDX-License-Identifier: GPL-3.0-or-later
"""Which layers filters that use curves take in MeshLab's window, and what they say and show."""
import re

import numpy as np
from summaries import offsets_told

CURVE, CUT, OFFSET = "B-spline Curve on Surface", "Cut along Curves", "Offset Curve on Surface"
CLICKS = np.array([[0, -110], [90, -60], [70, 60], [-50, 70]])  # in pixels from the middle of the view
SURFACE_ROW, CURVE_ROW, TUBE_ROW, OFFSET_ROW = range(4)  # in the list of layers


def draw(meshlab):
    meshlab.pick(CLICKS)
    meshlab.use(CURVE)


def test_offsets_are_of_curves_unless_a_line_is_chosen(meshlab):
    draw(meshlab)
    for count in (1, 2):
        meshlab.use(OFFSET, count)
        assert meshlab.current_layer() == SURFACE_ROW
    meshlab.select_layer(TUBE_ROW)
    meshlab.use(OFFSET, 3)
    meshlab.select_layer(CURVE_ROW)
    meshlab.use(OFFSET, 4)
    assert meshlab.current_layer() == CURVE_ROW
    assert offsets_told(meshlab.log()) == 4 * [(1, 1)]
    meshlab.select_layer(OFFSET_ROW)
    meshlab.use(OFFSET, 5)
    # Of a closed line, on both sides; the inner one is as thin as the curve that it surrounds, or nothing.
    assert offsets_told(meshlab.log())[4:] in ([(1, 1)], [(1, 2)])


def test_a_cut_along_an_open_curve_says_that_it_parts_nothing(meshlab):
    draw(meshlab)
    meshlab.use(CUT)
    assert re.search(r"The curve parts nothing: the mesh is cut open along it \(\d+ edges\)", "\n".join(meshlab.log()))
    assert meshlab.layers() == 4  # surface, curve, tube, result
