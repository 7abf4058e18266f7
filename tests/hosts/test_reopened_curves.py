# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves live in files: what MeshLab or the tool saved is taken up again with the same picks, options and polyline."""
import json

import numpy as np
import pytest
from drawing_tool import CLICKS, HANDLE, MADE, Tool
from meshlab_window import MeshLabWindow
from virtual_display import wait_until

SAME = 1e-12  # of the sphere's radius
CURVE_ROW = 1  # in the list of layers


def save(meshlab, tool, path):
    """The curves of the tool, as its panel saves them."""
    tool.press("Save")
    meshlab.name_file("^Save curves$", path)
    wait_until(path.is_file, f"the file {path}")  # it is written after its dialog has gone
    return json.loads(path.read_text())


def the_curve(document):
    """Of a file with one curve."""
    return document["curves"][0] if "curves" in document else document


def expect_same(first, second):
    a, b = the_curve(first), the_curve(second)
    assert a["closed"] == b["closed"]
    assert a["options"] == b["options"] and a["options"]["degree"] == 4
    np.testing.assert_allclose(a["picks"]["points"], b["picks"]["points"], rtol=0, atol=SAME)
    np.testing.assert_allclose(a["polyline"]["points"], b["polyline"]["points"], rtol=0, atol=SAME)
    np.testing.assert_allclose(a["spline"]["control_points"], b["spline"]["control_points"], rtol=0, atol=SAME)


@pytest.mark.parametrize("version", ["2020.09", "2025.07"])
def test_a_curve_that_meshlab_saved_is_taken_up_with_picks_and_options(version, display, program_of, sphere, tmp_path):
    program = program_of(version)
    with MeshLabWindow(display, program, sphere) as meshlab:
        tool = Tool(meshlab)
        tool.draw()
        tool.press("degree")
        meshlab.key("Up")
        tool.press("closed")
        meshlab.wait_for_still_picture()
        drawn = save(meshlab, tool, tmp_path / "drawn.json")
        tool.end()
        meshlab.wait_for_log(MADE)
        meshlab.select_layer(CURVE_ROW)
        meshlab.export_layer(tmp_path / "curve.ply")
        meshlab.export_layer(tmp_path / "curve.obj")
        meshlab.save_project(tmp_path / "all.mlp", [tmp_path / "tube.ply"])

    opened = {"ply": [sphere, tmp_path / "curve.ply"], "obj": [sphere, tmp_path / "curve.obj"], "project": [tmp_path / "all.mlp"]}
    for way, files in opened.items():
        with MeshLabWindow(display, program, *files) as meshlab:
            meshlab.select_layer(CURVE_ROW)
            tool = Tool(meshlab)
            tool.press_row(0)
            for offset in CLICKS:
                tool.expect(offset, HANDLE)
            expect_same(drawn, save(meshlab, tool, tmp_path / f"{way}.json"))


@pytest.mark.parametrize("version", ["2020.09", "2025.07"])
@pytest.mark.parametrize("ending", ["json", "obj", "dxf"])
def test_the_panel_opens_what_it_saved(version, ending, display, program_of, sphere, tmp_path):
    with MeshLabWindow(display, program_of(version), sphere) as meshlab:
        tool = Tool(meshlab)
        tool.draw()
        tool.press("degree")
        meshlab.key("Up")
        meshlab.wait_for_still_picture()
        drawn = save(meshlab, tool, tmp_path / "drawn.json")
        tool.press("Save")
        again = tmp_path / f"again.{ending}"
        meshlab.name_file("^Save curves$", again)
        wait_until(again.is_file, f"the file {again}")
        tool.press("Remove")
        for _ in CLICKS:
            tool.press("Remove")
        tool.press("Open")
        meshlab.name_file("^Open curves$", again)
        tool.press_row(0)
        for offset in CLICKS:
            tool.expect(offset, HANDLE)
        expect_same(drawn, save(meshlab, tool, tmp_path / "opened.json"))
