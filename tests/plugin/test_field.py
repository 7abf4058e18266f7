# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter that computes fields, and fields by kind in the filter for curves, in the real pymeshlab."""
import subprocess

import numpy as np
import pymeshlab
import pytest
from curves import KEPT, CurveLayer, assert_refuses, draw
from meshes import wavy_plate

FIELD = "compute_scalar_field_for_curves_per_vertex"
KINDS = ["normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance", "quality",
         "obstacle"]


def computed(document, kind, **parameters):
    figures = document.apply_filter(FIELD, kind=kind, **parameters)
    return document.current_mesh().vertex_scalar_array().copy(), figures


def roof(cells=40, waves=0.0):
    """A square plate folded downwards by 90 degrees along x = 0.5, seen from outside, with quality y; faces go along y."""
    vertices, faces = wavy_plate(cells)
    faces = faces.reshape(2, -1, 3).swapaxes(0, 1).reshape(-1, 3)
    x, y = vertices[:, 0], vertices[:, 1].copy()
    vertices = np.stack([np.minimum(x, 0.5), y, np.minimum(0.5 - x, 0) + waves * np.sin(20 * y)], 1)
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces, v_scalar_array=y), "roof")
    return document, vertices, faces, x


@pytest.mark.parametrize("kind", KINDS)
def test_values_are_those_of_the_program(program, tmp_path, kind):
    document, vertices, faces, x = roof(waves=0.05)
    document.compute_selection_by_condition_per_face(condselect="y0+y1+y2 > 1.8")
    selected = document.current_mesh().face_selection_array()
    document.save_current_mesh(str(tmp_path / "roof.ply"), save_vertex_quality=True)
    np.save(tmp_path / "region.npy", np.flatnonzero(selected))
    words = ["--region", "region.npy"] if kind == "obstacle" else []
    subprocess.run([program, "field", "roof.ply", "--kind", kind, "--output", "f.npy", "--smoothing", "0.03", *words],
                   check=True, cwd=tmp_path)
    expected = np.load(tmp_path / "f.npy")
    values, figures = computed(document, kind, smoothing=0.03)
    # The file may hold floats.
    np.testing.assert_allclose(values, expected, atol=1e-4)
    assert np.ptp(values) > 0.1
    assert figures == {"minimum": values.min(), "mean": pytest.approx(values.mean()), "maximum": values.max()}


def test_the_layer_keeps_everything_but_its_quality():
    document, vertices, faces, _ = roof()
    layer = document.current_mesh()
    before = (layer.vertex_matrix().copy(), layer.face_matrix().copy(), layer.vertex_color_matrix().copy())
    computed(document, "ridge")
    assert document.mesh_number() == 1
    layer = document.current_mesh()
    for a, b in zip(before, (layer.vertex_matrix(), layer.face_matrix(), layer.vertex_color_matrix())):
        np.testing.assert_array_equal(a, b)


def test_a_layer_without_quality_gets_one(bunny_path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    values, figures = computed(document, "maximal-curvature")
    assert len(values) == document.current_mesh().vertex_number()
    assert -1 <= figures["minimum"] < 0 and 2 < figures["maximum"] <= 8


def test_curvature_of_a_sphere():
    document = pymeshlab.MeshSet()
    document.create_sphere(radius=7, subdiv=5)
    values, _ = computed(document, "maximal-curvature")
    np.testing.assert_allclose(values, 0.05 * 2 * np.sqrt(3), rtol=2e-3)  # the diagonal is 2 sqrt(3) radii


def test_the_layers_matrix_counts():
    document, vertices, _, x = roof()
    straight, _ = computed(document, "boundary-distance")
    document.compute_matrix_from_scaling_or_normalization(axisx=4, axisy=1, axisz=1, uniformflag=False, freeze=False)
    assert not np.array_equal(document.current_mesh().transform_matrix(), np.eye(4))
    stretched, _ = computed(document, "boundary-distance")
    world = np.stack([4 * vertices[:, 0], vertices[:, 1], vertices[:, 2]], 1)
    other = pymeshlab.MeshSet()
    other.add_mesh(pymeshlab.Mesh(world, document.current_mesh().face_matrix()))
    expected, _ = computed(other, "boundary-distance")
    np.testing.assert_allclose(stretched, expected, atol=1e-9)
    assert np.abs(stretched - straight).max() > 0.1


def test_deleted_elements_are_left_out():
    document, vertices, faces, _ = roof()
    kept = document.apply_filter("convert_with_deleted", faces=6 * 80)
    ids = kept["vertex_ids"].astype(int)
    values, _ = computed(document, "crease-distance", reach=0.5)
    other = pymeshlab.MeshSet()
    other.add_mesh(pymeshlab.Mesh(kept["vertices"].reshape(-1, 3), kept["faces"].reshape(-1, 3).astype(int)))
    expected, _ = computed(other, "crease-distance", reach=0.5)
    assert len(expected) == len(ids) < len(vertices)
    np.testing.assert_allclose(values if len(values) == len(ids) else values[ids], expected, atol=1e-12)
    assert_refuses(document, "than the crease angle", FIELD, kind="crease-distance", crease_angle=95)


def test_obstacles_from_selected_vertices_are_the_faces_between_them():
    document, vertices, faces, _ = roof()
    document.compute_selection_by_condition_per_vertex(condselect="y > 0.6")
    by_vertices, _ = computed(document, "obstacle", region="selected-vertices")
    assert by_vertices[vertices[:, 1] < 0.6].max() == 0 and by_vertices.max() > 1
    document.compute_selection_by_condition_per_face(condselect="min(min(y0,y1),y2) > 0.6")
    by_faces, _ = computed(document, "obstacle", region="selected-faces")
    np.testing.assert_array_equal(by_vertices, by_faces)


# ---- refusals ----


def test_what_is_not_there_is_said(bunny_path):
    document, *_ = roof()
    assert_refuses(document, "region has no faces", FIELD, kind="obstacle")
    assert_refuses(document, "region has no faces", FIELD, kind="obstacle", region="selected-vertices")
    assert_refuses(document, "than the crease angle, 95", FIELD, kind="crease-distance", crease_angle=95)
    sphere = pymeshlab.MeshSet()
    sphere.create_sphere()
    assert_refuses(sphere, "closed", FIELD, kind="boundary-distance")
    bunny = pymeshlab.MeshSet()
    bunny.load_new_mesh(str(bunny_path))
    assert_refuses(bunny, "no per-vertex quality", FIELD, kind="quality")


def test_a_document_or_layer_that_is_empty():
    empty = pymeshlab.MeshSet()
    KEPT.append(empty)
    with pytest.raises(Exception):
        empty.apply_filter(FIELD)
    points = pymeshlab.MeshSet()
    points.add_mesh(pymeshlab.Mesh(np.eye(3)), "points")
    assert_refuses(points, '"points" has no faces', FIELD)


# ---- fields of curves ----


@pytest.mark.parametrize("kind", KINDS)
def test_a_curve_takes_the_same_fields(kind):
    document, vertices, faces, x = roof()
    document.compute_selection_by_condition_per_face(condselect="y0+y1+y2 > 1.8")
    picks = vertices[[2 * 41 + 4, 2 * 41 + 36]]
    curve = CurveLayer(draw(document, picks, field=kind, field_normalised=True, field_weight=0.1)[0])
    document.set_current_mesh(0)
    values, _ = computed(document, kind, normalised=True)
    expected = (values[faces[curve.faces]] * curve.barycentric).sum(1)
    np.testing.assert_allclose(curve.quality, expected, atol=1e-9)


def test_the_natural_cost_draws_the_curve_onto_the_ridge():
    document, vertices, faces, x = roof()
    picks = vertices[[16 * 41 + 2, 16 * 41 + 38]]
    heights = {}
    for name, parameters in {"none": {}, "natural": {"field": "ridge", "field_smoothing": 0.1},
                             "other": {"field": "ridge", "field_smoothing": 0.1, "field_cost": "identity"}}.items():
        document.set_current_mesh(0)
        curve = CurveLayer(draw(document, picks, field_weight=100.0, **parameters)[0])
        heights[name] = curve.points[:, 0].max(), curve.points[:, 0].min()
    assert heights["natural"][0] > 0.48, "exp-minus follows the ridge"
    assert heights["none"][0] < 0.41 and heights["other"][1] < 0.35, "identity avoids it"
