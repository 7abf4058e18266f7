# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of docs/MESHLAB.md, as they are told there: few, and they lead to where the page says."""
import numpy as np
import pytest
from drawing_tool import SELECTED, Tool
from meshlab_window import MeshLabWindow

# The tool's icon, from the top left corner of MeshLab's window.
ICON = {"2020.09": (654, 27), "2025.07": (824, 27)}

RING = np.array([[-110, 0], [-50, -80], [40, -90], [110, -20], [70, 70], [-40, 80]])
MOVED, WAY = 2, np.array([10, 40])

# A click, a drag, a key, a name that is typed, and each start of MeshLab with the mesh count as one.
MOST_ACTIONS = 20


class Counted:
    """The actions of somebody who follows the page."""

    def __init__(self):
        self.done = []

    def __call__(self, what, act, *arguments):
        self.done.append(what)
        return act(*arguments)


@pytest.mark.parametrize("version", list(ICON))
def test_a_closed_curve_is_drawn_saved_opened_again_and_cut_along_in_few_steps(version, display, program_of, sphere):
    (display.home / "curves.json").unlink(missing_ok=True)
    does = Counted()

    def started(meshlab):
        corner = meshlab.main.x + ICON[version][0], meshlab.main.y + ICON[version][1]
        return Tool(meshlab, start=lambda: does("icon", meshlab.click, *corner))

    with does("start MeshLab with the mesh", MeshLabWindow, display, program_of(version), sphere) as meshlab:
        tool = started(meshlab)
        for offset in RING:
            does("click a point", tool.click, offset)
            tool.expect(offset, SELECTED)
        does("click the first point", tool.click, RING[0])
        does("drag a point", tool.drag, RING[MOVED], WAY)
        tool.expect(RING[MOVED] + WAY, SELECTED)
        does("Save …", tool.press, "Save")
        meshlab.wait_for_window("^Save curves$")
        does("Enter", meshlab.key, "Return")  # the name that it offers
        meshlab.wait_for_no_window("^Save curves$")
        does("Ctrl+Q", meshlab.key, "ctrl+q")
        assert meshlab.exit_status() == 0

    with does("start MeshLab with the mesh", MeshLabWindow, display, program_of(version), sphere) as meshlab:
        tool = started(meshlab)
        does("Open …", tool.press, "Open")
        meshlab.wait_for_window("^Open curves$")
        does("curves.json", meshlab.type, "curves.json")
        does("Enter", meshlab.key, "Return")
        meshlab.wait_for_no_window("^Open curves$")
        meshlab.wait_for_still_picture()
        does("Cut", tool.press, "Cut")
        line = meshlab.wait_for_log("^Closed curve through 6 picks")
        assert "usable" in line
        meshlab.wait_for_log('^The mesh is parted into 2 layers: "sphere part 0" and "sphere part 1"')
        tool.wait_for_end()

    assert len(does.done) <= MOST_ACTIONS, does.done
