# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool "Draw B-spline Curves" in MeshLab's window: clicks add picks, drags move them, Enter makes a layer."""
import re

import numpy as np
from drawing_tool import CLICKS, DRAG, HANDLE, MADE, SELECTED, Tool, is_disc
from summaries import curves_told
from virtual_display import wait_until


def test_a_curve_is_clicked_dragged_undone_closed_and_made_a_layer(meshlab):
    tool = Tool(meshlab)
    tool.draw()
    for offset in CLICKS[:-1]:
        tool.expect(offset, HANDLE)

    tool.drag(CLICKS[2], DRAG)
    tool.expect(CLICKS[2] + DRAG, SELECTED)
    meshlab.wait_for_still_picture()
    inserted = tool.curve_between(CLICKS[3], CLICKS[4])
    tool.click(inserted)
    tool.expect(inserted, SELECTED)

    meshlab.key("ctrl+z", "ctrl+z")
    tool.expect(CLICKS[2], HANDLE)
    meshlab.key("ctrl+y")
    tool.expect(CLICKS[2] + DRAG, SELECTED)

    tool.click(CLICKS[0])  # the first pick closes the curve
    meshlab.wait_for_still_picture()
    meshlab.key("Return")
    line = meshlab.wait_for_log(MADE)
    assert re.search("^Closed curve through 5 picks, .* usable", line), line


def test_a_drag_with_shift_draws_freehand(meshlab):
    tool = Tool(meshlab)
    tool.wait_until_ready()
    tool.stroke(CLICKS)
    meshlab.wait_for_still_picture()
    meshlab.key("Return")
    (first,) = curves_told([meshlab.wait_for_log(MADE)])
    meshlab.key("ctrl+z")
    meshlab.key("Return")
    wait_until(lambda: meshlab.layers() == 1, "no curve")
    meshlab.key("ctrl+y")
    meshlab.key("Return")
    (again,) = curves_told([meshlab.wait_for_log(MADE, 2)])
    assert first["length"] == again["length"]


def test_a_layer_of_a_curve_is_taken_up_again(meshlab):
    tool = Tool(meshlab)
    tool.draw()
    meshlab.key("Return")
    first = meshlab.wait_for_log(MADE)
    assert meshlab.layers() == 3  # surface, curve, tube
    tool.end()
    meshlab.select_layer(1)

    tool = Tool(meshlab, count=2)
    for offset in CLICKS:
        tool.expect(offset, HANDLE)
    far = 2 * DRAG
    tool.drag(CLICKS[2], far)
    tool.expect(CLICKS[2] + far, SELECTED)
    meshlab.key("Return")
    second = meshlab.wait_for_log(MADE, 2)
    assert meshlab.layers() == 3  # in place of the old ones
    (one,), (other,) = curves_told([first]), curves_told([second])
    assert abs(float(one["length"]) - float(other["length"])) > 0.003


def test_drags_beside_the_mesh_move_the_camera(meshlab):
    tool = Tool(meshlab)
    tool.click(CLICKS[0])
    tool.expect(CLICKS[0], SELECTED)
    tool.drag(tool.beside - tool.middle, np.array([0, 200]))
    wait_until(
        lambda: not is_disc(tool.display.picture(), tool.middle + CLICKS[0], SELECTED), "the pick elsewhere"
    )
    tool.click(CLICKS[1])  # and the tool goes on
    tool.expect(CLICKS[1], SELECTED)
