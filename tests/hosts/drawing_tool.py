# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the tool "Draw B-spline Curves" in MeshLab's window."""
import numpy as np
from virtual_display import wait_until

TOOL = "Draw B-spline Curves"

# Where the mouse clicks, in pixels from the middle of the view.
CLICKS = np.array([[-110, -20], [-60, 60], [20, 90], [90, 40], [100, -50]])
DRAG = np.array([0, -60])

# Colours of the painter.
SELECTED, HANDLE, CURVE, BAD = (255, 191, 26), (255, 255, 255), (242, 64, 26), (230, 0, 0)

# The last row of buttons in the panel, and where it is, relative to its height.
BUTTONS, BUTTON_ROW = ("Imprint", "Cut", "Segment"), 0.692

# From the top of the panel to the middle of its row of the degree.
DEGREE_ROW = 33


def is_like(pixel, colour, tolerance=40):
    return all(abs(int(a) - int(b)) <= tolerance for a, b in zip(pixel[:3], colour))


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
        self.view_height = view.height

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

    def choose_field(self, begin):
        """Chooses the first field in the panel whose label begins so, in one word, by keys."""
        panel = self.meshlab.window("^B-spline Curves$")
        self.meshlab.click(panel.x + panel.width / 2, panel.y + DEGREE_ROW)
        self.meshlab.key("Tab", "Tab")  # from degree over tension
        self.meshlab.type(begin)

    def press_button(self, name):
        """Clicks a button in the last row of the panel."""
        panel = self.meshlab.window("^B-spline Curves$")
        column = BUTTONS.index(name)
        self.meshlab.click(
            panel.x + panel.width * (column + 0.5) / len(BUTTONS), panel.y + panel.height * BUTTON_ROW
        )

    def _mouse(self, *words):
        self.display.xdotool(*(str(word if isinstance(word, str) else int(word)) for word in words))
