# SPDX-License-Identifier: GPL-3.0-or-later
"""The windows of MeshLab 2020.09 and 2025.07: points picked with the mouse become a curve on the mesh."""
from dataclasses import dataclass

import numpy as np
import polylines
import pymeshlab
import pytest
from meshlab_window import MeshLabWindow
from summaries import curves_told, fields_told

CURVE = "B-spline Curve on Surface"
FIELD = "Scalar Field for Curves"

# Where the mouse picks, in pixels from the middle of the view.
CLICKS = np.array([[0, -110], [90, -60], [70, 60], [-50, 70]])
BUNNY_CLICKS = np.array([[-60, 20], [-20, 50], [30, 10], [60, 50]])


# In the list of layers: the surface, the curve, its tube.
CURVE_ROW = 1


@dataclass
class Session:
    """What was seen and written while the window was used."""

    error_shown: bool
    log: list
    view_height: int
    curve: tuple  # vertices and edges of the last curve, as MeshLab exported it


@pytest.fixture(scope="module", params=["2020.09", "2025.07"])
def session(request, display, program_of, sphere, tmp_path_factory):
    exported = tmp_path_factory.mktemp("exported") / "curve.obj"
    with MeshLabWindow(display, program_of(request.param), sphere) as meshlab:
        meshlab.use(FIELD)

        dialog = meshlab.open_filter(CURVE)
        meshlab.apply(dialog)
        error_shown = meshlab.wait_for_window("^Filter Failure$") is not None
        meshlab.key("Return")
        meshlab.wait_for_no_window("^Filter Failure$")
        meshlab.close(dialog)

        meshlab.pick(CLICKS)
        dialog = meshlab.open_filter(CURVE)
        for count in (1, 2):  # the second curve takes the place of the first
            meshlab.apply(dialog)
            meshlab.applied(CURVE, count)
        meshlab.close(dialog)
        meshlab.select_layer(CURVE_ROW)
        meshlab.export_layer(exported)
        return Session(error_shown, meshlab.log(), meshlab.view().height, polylines.read_obj(exported))


def curves_of(session):
    return curves_told(session.log)


def test_an_error_is_shown_and_logged(session):
    assert session.error_shown
    assert any('"Picks: coordinates", "Picks: file" and "Picks: layer"' in line for line in session.log)


def test_a_field_is_computed(session):
    ((least, largest, _),) = fields_told(session.log)
    assert largest == pytest.approx(least, rel=0.01)  # the mesh is a sphere


def test_apply_works_twice_in_a_row_and_the_second_needs_no_shell(session):
    first, second = curves_of(session)
    assert (first["usable"], second["usable"]) == ("usable", "usable")
    assert not first["kept"] and second["kept"]
    assert first["length"] == second["length"]


def test_the_layer_holds_the_curve(session, sphere):
    vertices, edges = session.curve
    assert edges.tolist() == polylines.in_order(vertices, closed=False)
    told = curves_of(session)[-1]
    assert polylines.length(vertices, edges) == pytest.approx(float(told["length"]), rel=1e-3)  # it has four digits
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(sphere))
    surface = document.current_mesh()
    assert polylines.distance_to_mesh(vertices, surface.vertex_matrix(), surface.face_matrix()) <= 2e-6


def test_the_curve_passes_where_the_mouse_picked(session):
    vertices, edges = session.curve
    focal = session.view_height / 2 / np.tan(np.radians(30))  # MeshLab's field of view is 60 degrees
    up = CLICKS * [1, -1]
    # How far the eye is from the middle of the sphere, as either end of the curve tells.
    ends = vertices[[0, -1]]
    eye = ends[:, 2] + focal * np.linalg.norm(ends[:, :2], axis=1) / np.linalg.norm(up[[0, -1]], axis=1)
    assert eye[0] == pytest.approx(eye[1], rel=0.01)
    picks = [on_sphere(click / focal, eye.mean()) for click in up]
    assert polylines.distance_to(picks, vertices, edges) <= 0.02
    np.testing.assert_allclose(ends, [picks[0], picks[-1]], atol=0.02)


def on_sphere(slope, eye):
    """Where a ray from (0, 0, eye), which moves by `slope` (x, y) for each unit of depth, meets the unit sphere."""
    squared = slope @ slope
    depth = (eye - np.sqrt(eye**2 - (1 + squared) * (eye**2 - 1))) / (1 + squared)
    return np.array([*(slope * depth), eye - depth])


def test_the_steps_of_readme_draw_a_curve_on_the_bunny(prefix, readme_commands, display, checkout):
    prepare, start = readme_commands[:2]
    done = display.run(["bash", "-e", "-c", prepare], cwd=checkout)
    assert done.returncode == 0, done.stdout + done.stderr
    program, mesh = (checkout / word.strip() for word in start.split("#")[0].split())
    exported = checkout / "curve.obj"
    with MeshLabWindow(display, program, mesh) as meshlab:
        meshlab.pick(BUNNY_CLICKS)
        meshlab.apply(meshlab.open_filter(CURVE))
        meshlab.applied(CURVE)
        meshlab.select_layer(CURVE_ROW)
        meshlab.export_layer(exported)
        (told,) = curves_told(meshlab.log())
    assert told["usable"] == "usable"
    vertices, edges = polylines.read_obj(exported)
    assert polylines.length(vertices, edges) == pytest.approx(float(told["length"]), rel=1e-3)
    assert edges.tolist() == polylines.in_order(vertices, closed=False)
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(mesh))
    bunny = document.current_mesh()
    distance = polylines.distance_to_mesh(vertices, bunny.vertex_matrix(), bunny.face_matrix())
    diagonal = bunny.bounding_box().diagonal()
    assert distance <= 1e-6 * diagonal
    # The mouse picked from left to right over a good part of the bunny.
    assert vertices[-1][0] - vertices[0][0] > 0.1 * diagonal
