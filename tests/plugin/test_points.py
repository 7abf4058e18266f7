# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter Points on Curve in pymeshlab: a layer of points with frames, curvatures and distances."""
import numpy as np
import pytest
from curves import assert_refuses, draw
from meshes import wavy_plate


@pytest.fixture
def picks():
    return wavy_plate()[0][[20 * 41 + 5, 20 * 41 + 20, 20 * 41 + 35]]


def test_points_are_a_layer_with_what_is_known_of_them(plate, picks):
    draw(plate, picks, field="none")
    figures = plate.apply_filter("points_on_curve", surface_layer=0, count=9)
    assert (figures["curves"], figures["projected_curves"], figures["points"]) == (1, 0, 9)
    layer = plate.current_mesh()
    assert (layer.label(), layer.vertex_number(), layer.edge_number()) == ("plate points", 9, 0)
    number, point = layer.vertex_custom_scalar_attribute_array, layer.vertex_custom_point_attribute_matrix
    np.testing.assert_allclose(number("distance"), np.linspace(0, figures["length"], 9), atol=1e-12)
    np.testing.assert_allclose(layer.vertex_scalar_array(), number("distance"), atol=1e-6)
    vertices, corners = wavy_plate()
    places = np.einsum("ij,ijk->ik", point("barycentric"), vertices[corners[number("face_index").astype(int)]])
    np.testing.assert_allclose(layer.vertex_matrix(), places, atol=1e-14)
    tangent, left, normal = point("tangent"), point("left"), layer.vertex_normal_matrix()
    np.testing.assert_allclose(np.cross(normal, tangent), left, atol=1e-9)
    squares = number("normal_curvature") ** 2 + number("geodesic_curvature") ** 2
    np.testing.assert_allclose(squares, number("curvature") ** 2, rtol=1e-6)
    assert (number("curve") == 0).all()


def test_points_are_at_the_picks_or_at_distances(plate, picks):
    draw(plate, picks, field="none")
    plate.apply_filter("points_on_curve", surface_layer=0, at_picks=True)
    np.testing.assert_allclose(plate.current_mesh().vertex_matrix(), picks, atol=1e-9)
    plate.apply_filter("points_on_curve", surface_layer=0, distances="0, 0.25")
    np.testing.assert_allclose(plate.current_mesh().vertex_custom_scalar_attribute_array("distance"), [0, 0.25], atol=1e-12)
    for message, wrong in [('distances has "far"', {"distances": "far"}), ("exclude each other", {"distances": "0", "at_picks": True}),
                           ("is an open curve", {"count": 1})]:
        assert_refuses(plate, message, "points_on_curve", surface_layer=0, **wrong)
