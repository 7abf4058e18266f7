# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of curves that were saved by MeshLab's formats, and are curves again by the file beside them."""
import json

import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, assert_refuses, draw
from meshes import wavy_plate

CORNERS = [10 * 41 + 10, 10 * 41 + 30, 30 * 41 + 30, 30 * 41 + 10]


@pytest.fixture
def saved(plate, tmp_path):
    """Saves a closed curve by a format of MeshLab, and what MeshLab's window would leave beside it."""

    def save(extension):
        vertices, _ = wavy_plate()
        json_file = tmp_path / "curve.json"
        layer, _ = draw(plate, vertices[CORNERS], closed=True, save=str(json_file))
        curve = CurveLayer(layer)
        path = tmp_path / f"line.{extension}"
        plate.save_current_mesh(str(path))
        json_file.rename(f"{path}.bspline.json")
        return path, curve

    return save


def again(path, vertices=None):
    """A new document with the plate, the current layer, and the file."""
    plate_vertices, faces = wavy_plate()
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(plate_vertices if vertices is None else vertices, faces), "plate")
    document.load_new_mesh(str(path))
    document.set_current_mesh(0)
    return document


@pytest.mark.parametrize("extension", ["ply", "obj"])
def test_a_curve_of_a_file_is_used_exactly_where_it_was_drawn(saved, extension):
    path, curve = saved(extension)
    document = again(path)
    assert document.mesh(1).edge_number() == (0 if extension == "ply" else len(curve.edges))
    figures = document.apply_filter("imprint_curves", curve_layer=1)
    assert (figures["curves"], figures["projected_curves"], figures["parts"]) == (1, 0, 2)
    restored = CurveLayer(document.mesh(1))
    np.testing.assert_array_equal(restored.points, curve.points)
    np.testing.assert_array_equal(restored.barycentric, curve.barycentric)
    np.testing.assert_array_equal(restored.faces, curve.faces)
    np.testing.assert_array_equal(restored.t, curve.t)
    assert restored.is_closed()


def test_all_visible_polylines_are_those_of_files_too(saved):
    path, _ = saved("ply")
    assert again(path).apply_filter("cut_along_curves")["curves"] == 1


def test_a_curve_of_another_version_of_the_mesh_is_projected(saved):
    path, curve = saved("ply")
    vertices, _ = wavy_plate()
    vertices[0] += 1e-3
    document = again(path, vertices)
    figures = document.apply_filter("imprint_curves", curve_layer=1)
    assert (figures["curves"], figures["projected_curves"]) == (1, 1)
    np.testing.assert_array_equal(document.mesh(1).vertex_matrix(), curve.points)


@pytest.mark.parametrize("damage", ["other", "text", "faces", "gone"])
def test_a_layer_without_a_fitting_file_stays_as_it_is(saved, damage):
    path, curve = saved("ply")
    beside = path.with_name(path.name + ".bspline.json")
    document = json.loads(beside.read_text())
    if damage == "other":
        document["polyline"]["points"][0][0] += 0.01
    if damage == "faces":
        document["polyline"]["faces"][0] = 10**6
    beside.write_text("nothing" if damage == "text" else json.dumps(document))
    if damage == "gone":
        beside.unlink()
    document = again(path)
    assert_refuses(document, "no polyline", name="imprint_curves", curve_layer=1)
    assert document.mesh(1).edge_number() == 0
    np.testing.assert_array_equal(document.mesh(1).vertex_matrix(), curve.points)


def test_a_project_holds_curves(saved, tmp_path):
    path, curve = saved("ply")
    first = again(path)
    for layer in (0, 1):
        first.set_current_mesh(layer)
        first.apply_filter(
            "compute_matrix_from_translation", traslmethod="XYZ translation", axisx=1.0, axisy=2.0, axisz=3.0, freeze=False
        )
    first.set_current_mesh(0)
    first.save_current_mesh(str(tmp_path / "plate.ply"))
    first.save_project(str(tmp_path / "all.mlp"))
    document = pymeshlab.MeshSet()
    document.load_project(str(tmp_path / "all.mlp"))
    document.set_current_mesh(0)
    figures = document.apply_filter("imprint_curves", curve_layer=1)
    assert (figures["curves"], figures["projected_curves"], figures["parts"]) == (1, 0, 2)
    np.testing.assert_allclose(document.mesh(1).vertex_matrix(), curve.points, rtol=0, atol=1e-12)
