# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters' dialogs on small screens: their buttons and the view stay within reach, and what they make can be seen."""
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from meshlab_window import MeshLabWindow
from summaries import curves_told, fields_told
from virtual_display import VirtualDisplay

CURVE = "B-spline Curve on Surface"

# Where the mouse picks, in pixels from the middle of the view, and then once more.
CLICKS = np.array([[0, -110], [90, -60], [70, 60]])
FURTHER = np.array([-50, 70])

LAYERS = 3  # surface, curve, tube

FIELD = "Scalar Field for Curves"
PATTERN = "Pattern on Surface"
FILTERS = [CURVE, FIELD, "Imprint Curves", "Cut along Curves", "Segment by Curves", "Offset Curve on Surface", PATTERN, "Fit Curve to Selection Boundary",
           "Edit Curve on Surface"]
WITH_ALL_OPTIONS = [CURVE, PATTERN]  # in 2020.09

FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")

# Of the dialog of patterns, and the second field of that of fields: from the bottom of the dialog.
TEXT = {"2020.09": 269, "2025.07": 416}
FONT_BELOW, CENTRE_BELOW = 31, 93
SCALE_OF_CURVATURE = {"2020.09": 469, "2025.07": 512}


@pytest.fixture(params=["2020.09", "2025.07"])
def version(request):
    return request.param


@pytest.fixture
def small(version, program_on, sphere):
    """MeshLab's window with the sphere on the smallest screen."""
    with VirtualDisplay(1280, 720) as display, MeshLabWindow(display, program_on(display, version), sphere) as meshlab:
        yield meshlab


def assert_within_the_screen(meshlab, dialog):
    screen = meshlab.display
    assert dialog.x >= 0 and dialog.x + dialog.width <= screen.width, dialog
    assert dialog.y >= 0 and dialog.y + dialog.height <= screen.height, dialog


def try_apply(meshlab, dialog):
    """Clicks Apply, which says that something is missing or runs, and Close."""
    meshlab.apply(dialog)
    if dialog.name == FIELD:
        meshlab.applied(FIELD)
    else:
        meshlab.wait_for_window("^Filter Failure$")
        meshlab.key("Return")
        meshlab.wait_for_no_window("^Filter Failure$")
    meshlab.close(dialog)


def test_all_dialogs_lie_on_a_small_screen_with_their_buttons(small, version):
    for name in FILTERS:
        dialog = small.open_filter(name)
        assert_within_the_screen(small, dialog)
        if version == "2025.07":
            small.unfold(dialog, has_preview=name == FIELD)
            dialog = small.wait_for_dialog(name)
            assert_within_the_screen(small, dialog)
        try_apply(small, dialog)
    for name in WITH_ALL_OPTIONS if version == "2020.09" else []:
        dialog = small.open_filter(name + " (All Options)")
        assert_within_the_screen(small, dialog)
        try_apply(small, dialog)


def test_help_leaves_the_buttons_on_a_small_screen(small, version):
    for name in (CURVE, PATTERN):
        dialog = small.open_filter(name)
        if version == "2025.07":
            small.unfold(dialog)
            dialog = small.wait_for_dialog(name)
        dialog = small.toggle_help(dialog)
        assert_within_the_screen(small, dialog)
        dialog = small.toggle_help(dialog)
        assert_within_the_screen(small, dialog)
        try_apply(small, dialog)


def test_enter_applies_once(small, version):
    dialog = small.open_filter(FIELD)
    small.key("Return")
    small.applied(FIELD)
    small.write_into(dialog, SCALE_OF_CURVATURE[version], "0.2")
    small.key("Return")
    small.applied(FIELD, 2)
    small.wait_for_still_picture()
    first, second = fields_told(small.log())
    assert first != second
    small.close(dialog)


def test_enter_is_left_alone_in_other_dialogs(prefix, sphere):
    with VirtualDisplay(1280, 720) as display, MeshLabWindow(display, prefix / "bin" / "meshlab", sphere) as meshlab:
        dialog = meshlab.open_filter("Torus")
        meshlab.key("Return")
        meshlab.wait_for_still_picture()
        meshlab.apply(dialog)
        meshlab.applied("Torus")
        assert len([line for line in meshlab.log() if line.startswith("Applied filter")]) == 1


def write_pattern(meshlab, version, font=None):
    """Opens the dialog of patterns, writes a text and where it goes, and applies with Enter."""
    dialog = meshlab.open_filter(PATTERN)
    text = TEXT[version]
    meshlab.write_into(dialog, text, "io")
    if font is not None:
        meshlab.write_into(dialog, text - FONT_BELOW, font)
    meshlab.write_into(dialog, text - CENTRE_BELOW, "0 0 1")
    meshlab.key("Return")
    return dialog


def fonts_of(meshlab):
    told = [re.fullmatch(r"The text is set in the font (.*)\.", line) for line in meshlab.log()]
    return [font[1] for font in told if font]


def test_a_text_needs_no_font_and_a_typed_one_is_kept(small, version, tmp_path):
    if not FONT.exists():
        pytest.skip(f"no {FONT}")
    font = shutil.copy(FONT, tmp_path / "my.ttf")
    for count, given in enumerate([None, font, None], 1):
        dialog = write_pattern(small, version, given)
        small.applied(PATTERN, count)
        small.close(dialog)
    found, typed, kept = fonts_of(small)
    assert Path(found).name == FONT.name
    assert (typed, kept) == (str(font), str(font))


@pytest.mark.parametrize("size", [(1366, 768), (1280, 720)], ids=lambda size: "x".join(map(str, size)))
def test_the_dialog_leaves_the_view_and_its_buttons_within_reach(size, prefix, sphere):
    width, height = size
    with VirtualDisplay(width, height) as small, MeshLabWindow(small, prefix / "bin" / "meshlab", sphere) as meshlab:
        dialog = meshlab.open_filter(CURVE)
        view = meshlab.view()
        assert_within_the_screen(meshlab, dialog)
        covered = max(0, min(dialog.x + dialog.width, view.x + view.width) - max(dialog.x, view.x))
        assert covered * dialog.height <= 0.5 * view.width * view.height


def test_moved_picks_replace_their_curve_and_the_surface_stays_current(meshlab):
    meshlab.pick(CLICKS)
    for count in (1, 2):
        meshlab.use(CURVE, count)
        assert meshlab.layers() == LAYERS
        if count == 1:
            meshlab.pick([FURTHER])  # the tool goes on where it was, since the surface is current
    lengths = [float(told["length"]) for told in curves_told(meshlab.log())]
    assert lengths[1] > 1.1 * lengths[0]
