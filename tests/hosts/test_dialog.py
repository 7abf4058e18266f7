# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter's dialog on small screens: its buttons and the view stay within reach, and what it makes can be seen."""
import numpy as np
import pytest
from meshlab_window import MeshLabWindow
from summaries import curves_told
from virtual_display import VirtualDisplay

CURVE = "B-spline Curve on Surface"

# Where the mouse picks, in pixels from the middle of the view, and then once more.
CLICKS = np.array([[0, -110], [90, -60], [70, 60]])
FURTHER = np.array([-50, 70])

LAYERS = 3  # surface, curve, tube


@pytest.mark.parametrize("size", [(1366, 768), (1280, 720)], ids=lambda size: "x".join(map(str, size)))
def test_the_dialog_leaves_the_view_and_its_buttons_within_reach(size, prefix, sphere):
    width, height = size
    with VirtualDisplay(width, height) as small, MeshLabWindow(small, prefix / "bin" / "meshlab", sphere) as meshlab:
        dialog = meshlab.open_filter(CURVE)
        view = meshlab.view()
        assert dialog.y >= 0 and dialog.y + dialog.height <= height
        assert dialog.x >= 0 and dialog.x + dialog.width <= width
        covered = max(0, min(dialog.x + dialog.width, view.x + view.width) - max(dialog.x, view.x))
        assert covered * dialog.height <= 0.5 * view.width * view.height



@pytest.mark.parametrize("version", ["2020.09", "2025.07"])
def test_moved_picks_replace_their_curve_and_the_surface_stays_current(version, display, program_of, sphere):
    with MeshLabWindow(display, program_of(version), sphere) as meshlab:
        view = meshlab.view()
        middle = np.array([view.x + view.width / 2, view.y + view.height / 2])
        meshlab.pick(CLICKS + middle)
        for count in (1, 2):
            dialog = meshlab.open_filter(CURVE)
            meshlab.apply(dialog)
            meshlab.applied(CURVE, count)
            meshlab.close(dialog)
            assert meshlab.layers() == LAYERS
            if count == 1:
                meshlab.pick([FURTHER + middle])  # the tool goes on where it was, since the surface is current
        lengths = [float(told["length"]) for told in curves_told(meshlab.log())]
        assert lengths[1] > 1.1 * lengths[0]
