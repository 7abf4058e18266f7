# SPDX-License-Identifier: GPL-3.0-or-later
"""What people draw is never lost, and nothing of theirs is touched: keys, ends of the tool, the end of MeshLab."""
import re

import numpy as np
import pymeshlab
import pytest
from drawing_tool import CLICKS, DRAG, HANDLE, MADE, SELECTED, Tool, is_disc
from float_ply import write_ply
from meshlab_window import MeshLabWindow
from virtual_display import wait_until

VERSIONS = ["2020.09", "2025.07"]
FIELD = "Scalar Field for Curves"
ARC = CLICKS[:3]
SPARE = np.array([-60, -90])

# Every key of the guide, in an order in which each has something to do.
KEYS = [
    "period", "comma", "a", "m", "c", "c", "k", "n", "x", "Delete", "BackSpace", "ctrl+z", "ctrl+z", "ctrl+y", "ctrl+shift+z",
    "shift+Delete", "ctrl+Delete", "ctrl+shift+Delete", "Escape", "Escape", "KP_Delete", "KP_Enter", "Return",
]

SELECTED_FACES = 100


@pytest.fixture(scope="module")
def partly_selected(sphere, tmp_path_factory):
    """The sphere with a hundred selected faces."""
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(sphere))
    mesh = document.current_mesh()
    path = tmp_path_factory.mktemp("meshes") / "selected.ply"
    return write_ply(path, mesh.vertex_matrix(), mesh.face_matrix(), selected=SELECTED_FACES)


def arrays_of(path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(path))
    mesh = document.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


@pytest.mark.parametrize("version", VERSIONS)
def test_no_key_of_the_guide_touches_the_mesh(version, display, program_of, partly_selected, tmp_path):
    with MeshLabWindow(display, program_of(version), partly_selected) as meshlab:
        meshlab.export_layer(tmp_path / "before.ply")
        tool = Tool(meshlab)
        tool.draw()
        for key in KEYS:
            tool.click(SPARE)  # a pick, so that there is something to do
            meshlab.key(key)
        for key in KEYS:  # and with the focus in the panel
            tool.press("degree")
            meshlab.key(key)
        meshlab.wait_for_still_picture()
        tool.end()
        assert not any("Deleted" in line for line in meshlab.log()), meshlab.log()
        meshlab.select_layer(0)
        meshlab.export_layer(tmp_path / "after.ply")
        meshlab.key("Delete")  # without the tool it is MeshLab's again, and the faces are selected still
        meshlab.wait_for_log(f"Deleted {SELECTED_FACES} faces")
    for old, new in zip(arrays_of(tmp_path / "before.ply"), arrays_of(tmp_path / "after.ply")):
        np.testing.assert_array_equal(old, new)


def test_whatever_ends_the_tool_makes_layers(meshlab):
    made = 0

    def ended(tool, how):
        nonlocal made
        made += 1
        tool.wait_for_end()
        meshlab.wait_for_log(MADE, made)
        assert sum(1 for line in meshlab.log() if re.search(MADE, line)) == made, how

    def drawn(count):
        """Another curve each time, below the others."""
        tool = Tool(meshlab, count)
        tool.meshlab.key("n")
        tool.draw(ARC * [1, 1] + [0, -25 * (count - 1)])
        return tool

    tool = drawn(1)
    meshlab.start_action("Draw B-spline Curves")
    ended(tool, "its icon")

    tool = drawn(2)
    tool.press("Close")
    ended(tool, "the panel's cross")

    tool = drawn(3)
    dialog = meshlab.open_filter(FIELD)
    ended(tool, "a filter")
    meshlab.apply(dialog)
    meshlab.applied(FIELD)
    meshlab.close(dialog)

    tool = drawn(4)
    meshlab.key("ctrl+p")
    dialog = meshlab.wait_for_window(f"^{FIELD}$")
    ended(tool, "the last filter")
    meshlab.close(dialog)

    tool = drawn(5)
    meshlab.key("Escape")  # the mouse turns the view
    tool.press("Close")
    ended(tool, "the cross while the view is turned")

    tool = drawn(6)
    meshlab.start_action("Delete Current Mesh")
    dialog = meshlab.window("^Delete Current Mesh$")
    ended(tool, "the end of its surface")


def test_closing_the_document_makes_layers_before_meshlab_asks(meshlab):
    tool = Tool(meshlab)
    tool.draw(ARC)
    meshlab.click(meshlab.main.x + meshlab.main.width - 12, meshlab.main.y - 8)  # the cross of the document
    meshlab.wait_for_window("^MeshLab$")  # its question
    meshlab.wait_for_log(MADE)
    meshlab.key("Return")  # No
    meshlab.wait_for_no_window("^MeshLab$")
    assert meshlab.layers() == 3


QUESTION = "^B-spline Curves$"


@pytest.mark.parametrize(
    ("keys", "curves", "drags"),
    [("alt+F4", 0, False), ("alt+F4", 1, False), ("alt+F4", 1, True), ("alt+F4", 5, False), ("ctrl+q", 1, False), ("ctrl+q", 1, True)],
)
def test_meshlab_closes_with_curves(meshlab, keys, curves, drags):
    tool = Tool(meshlab)
    for curve in range(curves):
        meshlab.key("n")
        tool.draw(ARC + [0, -25 * curve])
    if drags:
        tool.hold(ARC[1], DRAG)
    meshlab.key(keys)
    if curves > 0:
        meshlab.wait_for_window(QUESTION)
        meshlab.key("Return")  # go on drawing
        meshlab.wait_for_no_window(QUESTION)
        if drags:
            tool.let_go()
        tool.expect(ARC[0] + [0, -25 * (curves - 1)], HANDLE)
        meshlab.key(keys)
        meshlab.wait_for_window(QUESTION)
        meshlab.key("shift+Tab", "space")  # close without saving
    assert meshlab.exit_status() == 0


def test_what_is_not_finished_is_there_again(meshlab):
    tool = Tool(meshlab)
    tool.draw(ARC)
    meshlab.key("n")
    lonely = np.array([-20, -90])
    tool.click(lonely)
    tool.expect(lonely, SELECTED)
    tool.end()
    meshlab.wait_for_log(MADE)
    meshlab.wait_for_log("1 curve is not finished")

    tool = Tool(meshlab, 2)
    tool.press_row(0)
    for offset in ARC:
        tool.expect(offset, HANDLE)
    tool.press_row(1)
    tool.expect(lonely, HANDLE)
    tool.click(lonely + [60, 0])
    tool.expect(lonely + [60, 0], SELECTED)
    tool.end()
    meshlab.wait_for_log(MADE, 2)


def test_a_layer_whose_curve_was_changed_into_none_is_shown_again(meshlab):
    tool = Tool(meshlab)
    tool.draw(ARC)
    meshlab.key("Return")
    meshlab.wait_for_log(MADE)
    tool.press_row(0)
    tool.expect(ARC[0], HANDLE)
    for pick in ARC[:0:-1]:
        meshlab.display.xdotool("keydown", "shift")
        tool.click(pick)
        meshlab.display.xdotool("keyup", "shift")
    meshlab.wait_for_still_picture()
    with pytest.raises(AssertionError, match="no curve"):
        tool.curve_between(ARC[1], ARC[2])
    middle = tool.middle
    tool.end()
    meshlab.wait_for_log("1 curve is not finished")
    meshlab.wait_for_still_picture()
    view = meshlab.view()
    tool.middle = [view.x + view.width // 2, view.y + view.height // 2] + 0 * middle
    tool.curve_between(ARC[1], ARC[2])


def test_undo_works_after_a_change_in_the_panel(meshlab):
    tool = Tool(meshlab)
    tool.draw()
    tool.press("degree")
    meshlab.key("Down")
    meshlab.wait_for_still_picture()
    meshlab.key("ctrl+z")
    meshlab.key("ctrl+z")  # the last pick
    wait_until(lambda: not is_disc(meshlab.display.picture(), tool.middle + CLICKS[-1], SELECTED), "the end of the last pick")
