# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the tool "Draw B-spline Curves" in MeshLab's window."""
import numpy as np
from virtual_display import wait_until

TOOL = "Draw B-spline Curves"

# Where the mouse clicks, in pixels from the middle of the view.
CLICKS = np.array([[-110, -20], [-60, 60], [20, 90], [90, 40], [100, -50]])
DRAG = np.array([0, -60])

# Colours of the painter.
SELECTED, HANDLE, CURVE, BAD = (255, 191, 26), (255, 255, 255), (225, 60, 30), (230, 0, 0)

# What the log says of each layer of a curve that is made.
MADE = "^(Open|Closed) curve through "

# The panel, docked on the left: its buttons, from the top left corner of MeshLab's window.
BUTTONS = {
    "Close": (260, 60), "Turn view": (68, 89), "Magnet": (198, 89),
    "Undo": (34, 117), "Redo": (97, 117), "New": (160, 117), "Remove": (227, 117),
    "closed": (13, 263), "degree": (236, 264), "tension": (145, 289), "field": (160, 314), "More options": (68, 343),
    "Make layers": (130, 371), "Imprint": (46, 399), "Cut": (133, 399), "Segment": (220, 399), "Cancel": (233, 399),
    "Save": (68, 427), "Open": (198, 427),
}
FIRST_CURVE, CURVE_HEIGHT = (96, 163), 19  # rows of its list; and the columns of eye and colour there
EYE_COLUMN, COLOUR_COLUMN = 17, 52


def is_like(pixel, colour, tolerance=40):
    return all(abs(int(a) - int(b)) <= tolerance for a, b in zip(pixel[:3], colour))


def is_disc(picture, place, colour):
    """Whether a disc of a colour lies at a place of the display: all pixels within 3 px of it."""
    x, y = (int(v) for v in place)
    return all(is_like(picture.getpixel((x + dx, y + dy)), colour) for dx in (-2, 0, 2) for dy in (-2, 0, 2))


class Tool:
    """The tool in a window, started."""

    def __init__(self, meshlab, count=1, start=None):
        """`start`: presses what starts it; by default it is found by its name."""
        self.meshlab, self.display = meshlab, meshlab.display
        (start or (lambda: meshlab.start_action(TOOL)))()
        meshlab.wait_for_log(f"Started Mode {TOOL}", count)
        self._find_view()

    def _find_view(self):
        """Where the view is, beside the panel."""
        self.meshlab.wait_for_still_picture()
        view = self.meshlab.view()
        assert view.x > self.meshlab.main.x, "the panel is not docked"
        self.middle = np.array([view.x + view.width // 2, view.y + view.height // 2])
        self.beside = np.array([view.x + view.width - 40, view.y + 60])
        self.view_height = view.height

    def wait_for_end(self):
        """Until the panel is gone."""
        wait_until(lambda: self.meshlab.view().x == self.meshlab.main.x, "the end of the tool")

    def wait_until_ready(self):
        """Until the surface is prepared, and the button Open can be pressed: its letters are black then."""
        x, y = self.meshlab.main.x + BUTTONS["Open"][0], self.meshlab.main.y + BUTTONS["Open"][1]
        box = (x - 30, y - 8, x + 30, y + 8)
        wait_until(lambda: max(low for low, _ in self.display.picture().crop(box).getextrema()) < 60, "the prepared surface")

    def end(self):
        """Presses the tool's icon again."""
        self.meshlab.start_action(TOOL)
        self.wait_for_end()

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

    def stroke(self, offsets, steps=10):
        """Drags through these places with Shift held."""
        self.display.xdotool("keydown", "shift")
        self._mouse("mousemove", *(self.middle + offsets[0]))
        self._mouse("mousedown", 1)
        for start, end in zip(offsets, offsets[1:]):
            for step in range(1, steps + 1):
                self._mouse("mousemove", *(self.middle + start + (end - start) * step // steps))
        self._mouse("mouseup", 1)
        self.display.xdotool("keyup", "shift")

    def hold(self, start, way):
        """Begins a drag, and does not end it."""
        self._mouse("mousemove", *(self.middle + start))
        self._mouse("mousedown", 1)
        self._mouse("mousemove", *(self.middle + start + way))

    def let_go(self):
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

    def draw(self, offsets=CLICKS):
        """Clicks picks, one after the other."""
        for offset in offsets:
            self.click(offset)
            self.expect(offset, SELECTED)

    def choose_field(self, begin):
        """Chooses the first field in the panel whose label begins so, in one word, by keys."""
        self.press("degree")
        self.meshlab.key("Tab")
        self.meshlab.type(begin)

    def press(self, button):
        """Clicks a button of the panel."""
        x, y = BUTTONS[button]
        self.meshlab.click(self.meshlab.main.x + x, self.meshlab.main.y + y)

    def press_row(self, row, x=FIRST_CURVE[0]):
        """Clicks a row of the list of curves."""
        self.meshlab.click(self.meshlab.main.x + x, self.meshlab.main.y + FIRST_CURVE[1] + row * CURVE_HEIGHT)

    def _mouse(self, *words):
        self.display.xdotool(*(str(word if isinstance(word, str) else int(word)) for word in words))
