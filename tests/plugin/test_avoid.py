# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces to avoid, named by selection or quality of the layer."""
import pymeshlab
import pytest
from curves import CurveLayer, draw
from meshes import wavy_plate

WALL = "(x > 0.4) && (x < 0.6) && (y < 0.7)"
WALL_OF_FACES = " && ".join(f"(x{k} > 0.39) && (x{k} < 0.61) && (y{k} < 0.71)" for k in range(3))


@pytest.fixture
def walled():
    """The plate with quality x, with a wall of faces selected, and with its vertices."""
    vertices, faces = wavy_plate()
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces, v_scalar_array=vertices[:, 0]), "plate")
    document.compute_selection_by_condition_per_face(condselect=WALL_OF_FACES)
    document.compute_selection_by_condition_per_vertex(condselect=WALL)
    return document, vertices, faces


def picks_on(vertices):
    return vertices[[4 * 41 + 16, 36 * 41 + 18]]  # left and right of the wall


@pytest.mark.parametrize("avoid", ["selected-faces", "selected-vertices"])
def test_the_curve_goes_round_a_selection(walled, avoid):
    document, vertices, faces = walled
    layer = document.current_mesh()
    chosen = layer.face_selection_array()
    if avoid == "selected-vertices":
        chosen = layer.vertex_selection_array()[faces].all(1)
    assert chosen.any()
    mesh, figures = draw(document, picks_on(vertices), avoid=avoid)
    curve = CurveLayer(mesh)
    assert not chosen[curve.faces].any()
    assert curve.points[:, 1].max() > 0.68
    assert figures["avoided_faces"] == chosen.sum() and 0 < figures["clearance"] < 0.1


def test_the_curve_stays_where_the_quality_is_beyond_a_threshold(walled):
    document, vertices, faces = walled
    picks = vertices[[30 * 41 + 4, 29 * 41 + 20, 38 * 41 + 36]]
    mesh, _ = draw(document, picks, avoid="under-threshold", avoid_threshold=0.7)
    assert (vertices[faces][:, :, 0].mean(1)[CurveLayer(mesh).faces] > 0.7).all()


def test_deleted_elements_do_not_shift_the_selection(walled):
    document, vertices, faces = walled
    # In a copy whose first faces are deleted, the wall is selected again.
    document.compute_selection_by_condition_per_face(condselect="(y0+y1+y2 < 0.2)")
    document.meshing_remove_selected_faces()
    document.compute_selection_by_condition_per_face(condselect=WALL_OF_FACES)
    mesh, figures = draw(document, picks_on(vertices), avoid="selected-faces")
    points = CurveLayer(mesh).points
    inside = (abs(points[:, 0] - 0.5) < 0.09) & (points[:, 1] < 0.69)
    assert figures["avoided_faces"] > 0 and not inside.any()
