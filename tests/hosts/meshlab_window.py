# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives MeshLab's window as a user does, with mouse and keyboard, and waits for what MeshLab itself shows or logs."""
import re
import tempfile
import time
from dataclasses import dataclass

import numpy as np
from virtual_display import wait_until

# No statistics, no look for updates, no question about either at the first start.
SETTINGS = """[General]
informativeShown=true
lastTimeMeshLabVersionCheckedOnStart=Thu Dec 31 2099
"""
SWITCHED_OFF = ("sendAnonymousData", "checkForUpdate")
SETTING = (
    'MeshLab%3A%3ASystem%3A%3A{0}="<!DOCTYPE MeshLabSettings>\\n<Param name=\\"MeshLab::System::{0}\\" '
    'type=\\"RichBool\\" value=\\"false\\" description=\\"\\" tooltip=\\"\\"/>\\n"\n'
)

# From the right edge of the view, and from the top of the window, to the name of the first layer; height of its row.
LAYER_NAME, FIRST_LAYER, LAYER_ROW = 80, 95, 31

# From the bottom of a filter's dialog to the middle of its last row of buttons, Close and Apply.
BUTTON_HEIGHT = 22

# From there to the row above it, Default and Help; in 2025.07 to what unfolds the rest of the parameters.
HELP_ROW, UNFOLD = 31, {False: 183, True: 214}  # where the filter has a preview

# For so long our dialogs look after their size and place once they are shown.
FITTED_SECONDS = 1.0

# Where the menu Filters is, and from the bottom left corner of the dialog of scripts to the middle of its button Save Script.
FILTERS_MENU = 118, 29
SCRIPT_BUTTON = 50, 47


@dataclass
class Window:
    id: str
    name: str
    x: int
    y: int
    width: int
    height: int


def write_settings(display):
    folder = display.home / "config" / "VCG"
    folder.mkdir(parents=True, exist_ok=True)
    for scalar in ("fp", "dp"):
        text = SETTINGS + "".join(SETTING.format(name) for name in SWITCHED_OFF)
        (folder / f"MeshLab_64bit_{scalar}.conf").write_text(text)


class MeshLabWindow:
    """A running MeshLab with these files. Use it in a `with` statement; it ends with it."""

    def __init__(self, display, program, *files, **environment):
        self.display, self.program, self.files = display, program, files
        self._environment = {"BSPLINE_CURVE_CACHE": "", **environment}
        self._process = None
        self._log_path = None

    def __enter__(self):
        write_settings(self.display)
        self.display.keep_managed()
        self._log_path = self.display.home / "meshlab.log"
        with open(self._log_path, "wb") as log:
            self._process = self.display.start([self.program, *self.files], output=log, **self._environment)
        try:
            if self.files[-1].suffix == ".mlp":
                self.main = wait_until(lambda: self.window(r"^MeshLab .*\["), "MeshLab's window")
                self.view()  # of the project
                self.wait_for_still_picture()
            else:
                self.wait_for_log("All files opened")
            self.main = wait_until(lambda: self.window(r"^MeshLab .*\["), "MeshLab's window")
            self._focus_view()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, kind, error, trace):
        if error is not None:
            with tempfile.NamedTemporaryFile(prefix="meshlab-", suffix=".png", delete=False) as file:
                self.display.picture().save(file, "PNG")
            error.add_note(f"The display as it was then: {file.name}. The log: {self.log()}; {self.display.state_of_manager()}")
        self._end()

    # ---- what MeshLab says ----

    def log(self):
        """What MeshLab logged, line by line, without levels."""
        text = self._log_path.read_text(errors="replace")
        return [match.group(1) for match in re.finditer(r"^LOG: \d (.*)$", text, re.MULTILINE)]

    def wait_for_log(self, expected, count=1):
        """Waits until so many lines hold an expression; the last of them."""

        def found():
            lines = [line for line in self.log() if re.search(expected, line)]
            if len(lines) < count and self._process.poll() is not None:
                raise RuntimeError(f"MeshLab ended: {self._log_path.read_text(errors='replace')[-2000:]}")
            return lines[count - 1 :] and lines[-1]

        return wait_until(found, f"{count} lines of the log with {expected!r}")

    def exit_status(self):
        """Waits until MeshLab ends by itself; its exit status."""
        return wait_until(lambda: (self._process.poll() is not None) and (self._process.poll(),), "MeshLab's end")[0]

    # ---- windows ----

    def window(self, name):
        """The visible window whose title matches; None where there is none."""
        ids = self.display.xdotool("search", "--onlyvisible", "--name", name)
        return self._described(ids[-1]) if ids else None

    def wait_for_window(self, name):
        return wait_until(lambda: self._settled(name), f"a window called {name!r}")

    def wait_for_no_window(self, name):
        wait_until(lambda: self.window(name) is None, f"the end of the window called {name!r}")

    def _settled(self, name):
        """The window, where it stays where it is."""
        first = self.window(name)
        self.display.picture()  # takes a moment
        return first if first is not None and first == self.window(name) else None

    def _described(self, window_id):
        answer = self.display.run(["xdotool", "getwindowgeometry", "--shell", window_id])
        values = dict(line.split("=", 1) for line in answer.stdout.splitlines() if "=" in line)
        if not {"X", "Y", "WIDTH", "HEIGHT"} <= set(values):
            return None  # it is gone
        name = self.display.run(["xdotool", "getwindowname", window_id]).stdout.strip()
        return Window(window_id, name, *(int(values[key]) for key in ("X", "Y", "WIDTH", "HEIGHT")))

    # ---- mouse and keyboard ----

    def click(self, x, y, button=1):
        self.display.xdotool("mousemove", str(int(x)), str(int(y)))
        self.display.xdotool("click", str(button))

    def key(self, *keys):
        self.display.xdotool("key", "--delay", "50", *keys)

    def type(self, text):
        self.display.xdotool("type", "--delay", "30", str(text))

    def change_of_picture(self, box, before):
        """Waits until a part (left, top, right, bottom) of the display no longer looks as before."""
        wait_until(lambda: self.display.picture().crop(box) != before.crop(box), f"a change in {box}")

    # ---- what users do ----

    def start_action(self, name):
        """Finds an action of the menus by its name, with Ctrl+F, and starts it."""
        self._focus_view()
        before = self.display.picture()
        right_half = (self.main.width // 2, self.main.y, self.main.width, self.main.y + 200)
        self.key("ctrl+f")
        self.change_of_picture(right_half, before)
        before = self.display.picture()
        self.type(name)
        self.change_of_picture(right_half, before)
        self.wait_for_still_picture()  # the list of what it found
        self.key("Down")
        self.key("Return")

    def pick(self, points):
        """Right-clicks points (x, y), from the middle of the view, with the tool PickPoints, and stays in it."""
        view = self.view()
        self.start_action("PickPoints")
        self.wait_for_log("Started Mode PickPoints")
        self.wait_for_window("^Form$")
        for x, y in np.asarray(points) + [view.x + view.width / 2, view.y + view.height / 2]:
            self.wait_for_still_picture()
            before = self.display.picture()
            self.click(x, y, button=3)
            self.change_of_picture((int(x) - 6, int(y) - 12, int(x) + 6, int(y) + 12), before)

    def open_filter(self, name):
        """Opens a filter's dialog; its window."""
        self.start_action(name)
        return self.wait_for_dialog(name)

    def wait_for_dialog(self, name):
        """A filter's dialog that has its size and place."""
        self.wait_for_window(f"^{re.escape(name)}$")
        self.wait_for_still_picture()
        time.sleep(FITTED_SECONDS)
        return self.wait_for_window(f"^{re.escape(name)}$")

    def apply(self, dialog):
        """Clicks Apply of a filter's dialog; see applied() and wait_for_window("^Filter Failure$")."""
        self.click(dialog.x + dialog.width * 0.74, dialog.y + dialog.height - BUTTON_HEIGHT)

    def use(self, name, count=1):
        """Applies a filter with what its dialog offers, and waits until it was applied so many times, in all."""
        dialog = self.open_filter(name)
        self.apply(dialog)
        self.applied(name, count)
        self.close(dialog)

    def toggle_help(self, dialog):
        """Clicks Help of a filter's dialog; the dialog as it is then."""
        self.click(dialog.x + dialog.width * 0.74, dialog.y + dialog.height - BUTTON_HEIGHT - HELP_ROW)
        return self.wait_for_dialog(dialog.name)

    def unfold(self, dialog, has_preview=False):
        """Shows all parameters of a filter's dialog of 2025.07."""
        before = self.display.picture()
        self.click(dialog.x + dialog.width / 2, dialog.y + dialog.height - BUTTON_HEIGHT - UNFOLD[has_preview])
        self.change_of_picture((dialog.x, dialog.y, dialog.x + dialog.width, dialog.y + dialog.height), before)

    def write_into(self, dialog, above_bottom, text):
        """Writes into a field of a filter's dialog, in place of what it holds."""
        self.click(dialog.x + dialog.width * 0.5, dialog.y + dialog.height - above_bottom)
        self.key("ctrl+a")
        self.type(text)

    def applied(self, name, count=1):
        """Waits until a filter was applied so many times, in all."""
        self.wait_for_log(f"^Applied filter:? {re.escape(name)} in", count)

    def close(self, dialog):
        """Clicks Close of a filter's dialog."""
        self.click(dialog.x + dialog.width * 0.25, dialog.y + dialog.height - BUTTON_HEIGHT)
        self.wait_for_no_window(f"^{re.escape(dialog.name)}$")

    def select_layer(self, row):
        """Makes the layer in a row of the list, from 0 on, the current one."""
        view = self.view()
        x, y = view.x + view.width + LAYER_NAME, self.main.y + FIRST_LAYER + row * LAYER_ROW
        self.click(x, y)
        wait_until(lambda: self._is_selected(x, y), f"layer {row} as the current one")

    def layers(self):
        """How many layers the list has."""
        self.wait_for_still_picture()
        picture, view = self.display.picture(), self.view()
        for row in range(20):
            x, y = view.x + view.width + LAYER_NAME, self.main.y + FIRST_LAYER + row * LAYER_ROW
            box = picture.crop((x - 10, y - 8, x + 40, y + 8))
            if min(low for low, _ in box.getextrema()) > 128:
                return row  # no letters
        raise AssertionError("no end of the list of layers")

    def current_layer(self):
        """The row of the current layer."""
        view = self.view()
        x, top = view.x + view.width + LAYER_NAME, self.main.y + FIRST_LAYER
        return next(row for row in range(20) if self._is_selected(x, top + row * LAYER_ROW))

    def _is_selected(self, x, y):
        """Whether a row of the list is blue: above the name, where no letter is."""
        red, _, blue = self.display.picture().getpixel((x, y - LAYER_ROW // 2 + 3))
        return blue > red + 60

    def export_layer(self, path):
        """Writes the current layer to a file that is not there yet, with File > Export Mesh as."""
        self.key("ctrl+shift+e")
        self.name_layers_file(path)

    def name_layers_file(self, path):
        """Answers the dialogs that write a layer."""
        self.wait_for_window("^Save .* Layer$")
        self.type(path)
        self.key("Return")
        self.wait_for_window("^Choose Saving Options")
        self.key("Return")
        self.wait_for_log(f"^Saved Mesh {re.escape(str(path))}")

    def save_project(self, path, unsaved=()):
        """Writes the project and, as MeshLab asks, layers that have no file yet to these: 2020.09 asks first, 2025.07 then."""
        self.key("ctrl+s")
        asks_first = "2020" in self.main.name
        if not asks_first:
            self.name_file("^Save Project File$", path)
            if unsaved:
                self.wait_for_window("^Layer.s. not saved$")
                self.key("Return")
        for file in unsaved:
            self.name_layers_file(file)
        if asks_first:
            self.name_file("^Save Project File$", path)
        wait_until(path.is_file, f"the file {path}")

    def name_file(self, title, path):
        """Types a name into a file dialog."""
        self.wait_for_window(title)
        self.type(path)
        self.key("Return")
        self.wait_for_no_window(title)

    def save_script(self, path):
        """Writes the filters that were applied to a file that is not there yet."""
        self.click(*FILTERS_MENU)
        self.wait_for_still_picture()
        self.key("Down", "Return")  # the first that is enabled: Show current filter script
        dialog = self.wait_for_window("^Dialog$")
        self.click(dialog.x + SCRIPT_BUTTON[0], dialog.y + dialog.height - SCRIPT_BUTTON[1])
        self.wait_for_window("^Save Filter Script File$")
        self.type(path)
        self.key("Return")
        wait_until(path.is_file, f"the file {path}")
        self.key("Escape")
        self.wait_for_no_window("^Dialog$")

    def view(self):
        """The part of the window that shows the mesh."""
        return wait_until(self._view, "the view")

    def _view(self):
        """The same; None while there is none, as before a project is open, or while windows come and go."""
        ids = self.display.xdotool("search", "--onlyvisible", "--class", "meshlab")
        parts = [window for window in map(self._described, ids) if window and window.name.startswith("MeshLab_64bit")]
        # Of those that are equally large the last one holds no other, and only its place is exact.
        return max(reversed(parts), key=lambda window: window.width * window.height, default=None)

    def _focus_view(self):
        """Clicks beside the mesh."""
        view = self.view()
        self.click(view.x + 20, view.y + 100)

    def wait_for_still_picture(self):
        """Until the display looks the same twice in a row. The frame rate below the mesh never does."""

        def is_still():
            first, second = (self.display.picture() for _ in range(2))
            upper = (0, 0, first.width, self.main.y + self.main.height * 3 // 4)
            return first.crop(upper) == second.crop(upper)

        wait_until(is_still, "a still picture")

    def _end(self):
        self._process.kill()
        self._process.wait()
