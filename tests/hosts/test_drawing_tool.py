# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool "Draw B-spline Curves" in MeshLab's window: clicks add picks, drags move them, Enter makes a layer."""
import re

import numpy as np
import pytest
from meshlab_window import MeshLabWindow
from virtual_display import wait_until

TOOL = "Draw B-spline Curves"

# Where the mouse clicks, in pixels from the middle of the view.
CLICKS = np.array([[-110, -20], [-60, 60], [20, 90], [90, 40], [100, -50]])
DRAG = np.array([0, -60])

# Colours of the painter.
SELECTED, HANDLE, CURVE = (255, 191, 26), (255, 255, 255), (242, 64, 26)


def is_like(pixel, colour, tolerance=40):
    return all(abs(a - b) <= tolerance for a, b in zip(pixel[:3], colour))


def is_disc(picture, place, colour):
    """Whether a disc of a colour lies at a place of the display: all pixels within 3 px of it."""
    x, y = (int(v) for v in place)
    return all(is_like(picture.getpixel((x + dx, y + dy)), colour) for dx in (-2, 0, 2) for dy in (-2, 0, 2))


class Tool:
    """The tool in a window, started."""

    def __init__(self, meshlab, count=1):
        self.meshlab, self.display = meshlab, meshlab.display
        meshlab.start_action(TOOL)
        meshlab.wait_for_log(f"Started Mode {TOOL}", count)
        meshlab.wait_for_window("^B-spline Curves$")
        meshlab.wait_for_still_picture()
        view = meshlab.view()
        self.middle = np.array([view.x + view.width // 2, view.y + view.height // 2])
        self.beside = np.array([view.x + view.width - 40, view.y + 60])

    def expect(self, offset, colour):
        place = self.middle + offset
        wait_until(lambda: is_disc(self.display.picture(), place, colour), f"a handle at {offset}")

    def click(self, offset):
        self.meshlab.click(*(self.middle + offset))

    def drag(self, start, way, steps=8):
        self._mouse("mousemove", *(self.middle + start))
        self._mouse("mousedown", 1)
        for step in range(1, steps + 1):
            self._mouse("mousemove", *(self.middle + start + way * step // steps))
        self._mouse("mouseup", 1)

    def curve_between(self, a, b):
        """A pixel of the curve near the middle of two offsets, as an offset."""
        picture = self.display.picture()
        near = self.middle + (a + b) // 2
        offsets = [(dx, dy) for dx in range(-30, 31) for dy in range(-30, 31)]
        offsets.sort(key=lambda o: o[0] ** 2 + o[1] ** 2)
        for offset in offsets:
            if is_like(picture.getpixel(tuple(int(v) for v in near + offset)), CURVE):
                return near + offset - self.middle
        raise AssertionError("no curve between the picks")

    def _mouse(self, *words):
        self.display.xdotool(*(str(word if isinstance(word, str) else int(word)) for word in words))


@pytest.fixture(params=["2020.09", "2025.07"])
def meshlab(request, display, program_of, sphere):
    with MeshLabWindow(display, program_of(request.param), sphere) as window:
        yield window


def test_a_curve_is_clicked_dragged_undone_closed_and_made_a_layer(meshlab):
    tool = Tool(meshlab)
    for offset in CLICKS:
        tool.click(offset)
        tool.expect(offset, SELECTED)  # where it was clicked
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
    line = meshlab.wait_for_log("^shell=")
    assert re.search("usable=true .*closed=true degree=3", line), line


def test_a_layer_of_a_curve_is_taken_up_again(meshlab):
    tool = Tool(meshlab)
    for offset in CLICKS:
        tool.click(offset)
        tool.expect(offset, SELECTED)
    meshlab.key("Return")
    first = meshlab.wait_for_log("^shell=")
    assert meshlab.layers() == 3  # surface, curve, tube
    meshlab.start_action(TOOL)  # ends it
    meshlab.wait_for_no_window("^B-spline Curves$")
    meshlab.select_layer(1)

    tool = Tool(meshlab, count=2)
    for offset in CLICKS:
        tool.expect(offset, HANDLE)
    tool.drag(CLICKS[2], DRAG)
    tool.expect(CLICKS[2] + DRAG, SELECTED)
    meshlab.key("Return")
    second = meshlab.wait_for_log("^shell=", 2)
    assert meshlab.layers() == 3  # in place of the old ones
    length = lambda line: float(re.search(r" length=([0-9.e+-]+)", line)[1])
    assert abs(length(second) - length(first)) > 0.01


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
