# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve's layer saved by MeshLab's own menu: its picks and options stay beside the file, and the log says so."""
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polylines
import pymeshlab
import pytest
from meshlab_window import MeshLabWindow

CURVE = "B-spline Curve on Surface"
CLICKS = np.array([[0, -110], [90, -60], [70, 60], [-50, 70]])
SURFACE_ROW, CURVE_ROW = 0, 1  # in the list of layers; the tube is the third


@dataclass
class Session:
    """What was saved and said."""

    folder: Path
    log: list

    def curve(self, name):
        return json.loads((self.folder / f"{name}.bspline.json").read_text())

    def said(self, name):
        return [line for line in self.log if f"{name}.bspline.json" in line]


@pytest.fixture(scope="module", params=["2020.09", "2025.07"])
def session(request, display, program_of, sphere, tmp_path_factory):
    folder = tmp_path_factory.mktemp("exported")
    (folder / "taken.ply.bspline.json").write_text("somebody's own")
    with MeshLabWindow(display, program_of(request.param), sphere) as meshlab:
        meshlab.pick(CLICKS)
        meshlab.use(CURVE)
        meshlab.select_layer(CURVE_ROW)
        for name in ("curve.ply", "curve.obj", "taken.ply"):
            meshlab.export_layer(folder / name)
            meshlab.wait_for_log(f"{name}.bspline.json")
        for row, name in ((CURVE_ROW + 1, "tube.ply"), (SURFACE_ROW, "surface.ply")):
            meshlab.select_layer(row)
            meshlab.export_layer(folder / name)
        meshlab.select_layer(CURVE_ROW)
        meshlab.export_layer(folder / "last.obj")  # what the others had to say was said before it
        meshlab.wait_for_log("last.obj.bspline.json")
        return Session(folder, meshlab.log())


def test_one_line_says_where_picks_are_and_which_format_keeps_the_line(session):
    assert session.said("curve.ply") == [
        "curve.ply holds points only, since PLY files of MeshLab have no edges. Picks and options are kept in "
        "curve.ply.bspline.json; choose OBJ to keep the line as well."
    ]
    assert session.said("curve.obj") == ["Picks and options of curve.obj are kept in curve.obj.bspline.json."]


def test_picks_options_and_polyline_are_beside_each_file(session):
    ply, obj = session.curve("curve.ply"), session.curve("curve.obj")
    assert ply["picks"] == obj["picks"] and ply["options"] == obj["options"]
    assert ply["polyline"] == obj["polyline"] and ply["spline"] == obj["spline"] and ply["mesh"] == obj["mesh"]
    picks, line = ply["picks"], ply["polyline"]
    assert len(picks["points"]) == len(CLICKS)
    assert [line["points"][i] for i in line["picks"]] == picks["points"]
    assert ply["options"]["degree"] == 3
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(session.folder / "curve.ply"))
    saved = document.current_mesh().vertex_matrix()
    np.testing.assert_allclose(line["points"], saved, rtol=0, atol=1e-6)
    vertices, edges = polylines.read_obj(session.folder / "curve.obj")
    np.testing.assert_allclose(line["points"], vertices, rtol=0, atol=1e-6)
    assert len(edges) == len(vertices) - 1


def test_a_file_of_somebody_else_stays(session):
    assert (session.folder / "taken.ply.bspline.json").read_text() == "somebody's own"
    assert session.said("taken.ply") == [
        "Picks and options of taken.ply were not kept: taken.ply.bspline.json is there and is no file of curves; save "
        "the layer by another name."
    ]


def test_nothing_is_beside_other_layers(session):
    names = sorted(path.name for path in session.folder.iterdir() if "bspline" in path.name)
    assert names == [f"{name}.bspline.json" for name in ("curve.obj", "curve.ply", "last.obj", "taken.ply")]


def test_a_file_of_the_window_is_a_curve_elsewhere(session, sphere, loaded_plugin):
    """The points of a PLY are a curve on the mesh again, in a host with other numbers too."""
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(sphere))
    document.load_new_mesh(str(session.folder / "curve.ply"))
    document.set_current_mesh(0)
    figures = document.apply_filter("imprint_curves", curve_layer=1)
    assert (figures["curves"], figures["projected_curves"]) == (1, 0)
    line = session.curve("curve.ply")["polyline"]["points"]
    np.testing.assert_allclose(document.mesh(1).vertex_matrix(), line, rtol=0, atol=1e-12)
