# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth curves along the boundaries of selected faces and of labels."""
import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, assert_refuses, assert_strictly_on
from meshes import wavy_plate

FIT = "fit_curve_to_selection_boundary"
CENTRE, RADIUS, EDGE = np.array([0.5, 0.5]), 0.28, 1 / 40
ROUND = f"((x0+x1+x2)/3-0.5)^2+((y0+y1+y2)/3-0.5)^2 < {RADIUS ** 2}"


def is_round():
    """Faces whose middle is within a circle, seen from above."""
    vertices, faces = wavy_plate()
    return np.linalg.norm(vertices[faces].mean(1)[:, :2] - CENTRE, axis=1) < RADIUS


def labelled(**arrays):
    vertices, faces = wavy_plate()
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces, **arrays), "plate")
    return document


def assert_a_smooth_circle(layer):
    curve = CurveLayer(layer)
    assert len(layer.edge_matrix()) == layer.vertex_number()  # closed
    vertices, faces = wavy_plate()
    assert_strictly_on(curve, vertices, faces)
    points = layer.vertex_matrix()[:, :2]
    assert np.abs(np.linalg.norm(points - CENTRE, axis=1) - RADIUS).max() < 1.5 * EDGE
    steps = np.diff(np.vstack([points, points[:1]]), axis=0)
    steps = steps[np.linalg.norm(steps, axis=1) > 1e-3 * EDGE]
    turns = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
    assert np.abs(np.degrees(turns)).max() < 30  # the boundary turns by 45 and 90


def test_a_selection_becomes_a_smooth_closed_curve(plate):
    plate.compute_selection_by_condition_per_face(condselect=ROUND)
    selected = plate.current_mesh().face_selection_array()
    figures = plate.apply_filter(FIT)
    assert [layer.label() for layer in plate] == ["plate", "plate curve"]
    assert (figures["curves"], figures["closed_curves"], figures["left_out"]) == (1, 1, 0)
    assert figures["largest_deviation"] <= 2 * EDGE
    assert_a_smooth_circle(plate.current_mesh())
    np.testing.assert_array_equal(plate.mesh(0).face_selection_array(), selected)


@pytest.mark.parametrize("kind", ["face-quality", "face-colour"])
def test_labels_of_faces(kind):
    inside = is_round()
    colours = np.where(inside[:, None], [1.0, 0, 0, 1], [0, 0.2, 1.0, 1])
    document = labelled(f_scalar_array=7.0 * inside, f_color_matrix=colours)
    figures = document.apply_filter(FIT, boundaries=kind)
    assert figures["curves"] == 1
    assert_a_smooth_circle(document.current_mesh())


def test_labels_of_vertices():
    vertices, _ = wavy_plate()
    inside = np.linalg.norm(vertices[:, :2] - CENTRE, axis=1) < RADIUS
    document = labelled(v_scalar_array=3.0 * inside)
    assert document.apply_filter(FIT, boundaries="vertex-quality")["curves"] == 1
    assert_a_smooth_circle(document.current_mesh())


def test_lines_between_three_labels_meet_in_one_point():
    vertices, faces = wavy_plate()
    middles = vertices[faces].mean(1)[:, :2] - CENTRE
    angles = np.degrees(np.arctan2(middles[:, 1], middles[:, 0])) % 360
    document = labelled(f_scalar_array=np.digitize(angles, [100, 230]).astype(float))
    figures = document.apply_filter(FIT, boundaries="face-quality")
    assert (figures["curves"], figures["closed_curves"]) == (3, 0)
    ends = [document.mesh(i).vertex_matrix()[[0, -1]] for i in (1, 2, 3)]
    junction = [np.array(e)[np.linalg.norm(np.array(e)[:, :2] - CENTRE, axis=1).argmin()] for e in ends]
    np.testing.assert_allclose(junction, [junction[0]] * 3, atol=1e-12)


def test_deviation_bounds_the_distance(plate):
    plate.compute_selection_by_condition_per_face(condselect=ROUND)
    assert plate.apply_filter(FIT, deviation="0.4 edges")["largest_deviation"] <= 0.4 * 0.031
    plate.set_current_mesh(0)
    assert_refuses(plate, "deviation", FIT, deviation="-1")


def test_a_fitted_curve_is_a_curve_of_the_other_filters(plate):
    plate.compute_selection_by_condition_per_face(condselect=ROUND)
    plate.apply_filter(FIT)
    plate.set_current_mesh(0)
    assert plate.apply_filter("segment_by_curves")["parts"] == 2


def test_what_has_no_boundary_is_refused(plate):
    assert_refuses(plate, "no face is selected", FIT)
    assert_refuses(plate, "has no quality of faces", FIT, boundaries="face-quality")
