# SPDX-License-Identifier: GPL-3.0-or-later
"""What a curve leaves besides its layer: tube, control polygon, shell and file."""
import json

import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, as_text, assert_refuses, draw
from meshes import wavy_plate


def layers(document):
    return {document.mesh(i).label(): document.mesh(i) for i in range(document.mesh_number())}


def distances(points, curve):
    """Of points to the nearest segment of a curve's layer."""
    a, b = curve.points[curve.edges[:, 0]], curve.points[curve.edges[:, 1]]
    along = b - a
    t = ((points[:, None] - a) * along).sum(2) / (along * along).sum(1)
    nearest = a + np.clip(t, 0, 1)[..., None] * along
    return np.linalg.norm(points[:, None] - nearest, axis=2).min(1)


def test_there_is_only_the_curve_unless_more_is_asked_for(plate, plate_picks):
    draw(plate, plate_picks)
    assert list(layers(plate)) == ["plate", "plate curve"]


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("radius", [pymeshlab.PureValue(0.01), pymeshlab.PercentageValue(0.7)])
def test_the_tube_is_closed_and_follows_the_curve(plate, plate_picks, closed, radius):
    layer, _ = draw(plate, plate_picks, closed=closed, tube_radius=radius)
    curve = CurveLayer(layer)
    assert layer.label() == "plate curve", "the curve stays the current layer"
    tube = layers(plate)["plate tube"]
    expected = 0.01 if isinstance(radius, pymeshlab.PureValue) else 0.007 * np.linalg.norm(np.ptp(wavy_plate()[0], axis=0))
    away = distances(tube.vertex_matrix(), curve)
    assert away.max() == pytest.approx(expected, rel=0.02)
    assert np.median(away) == pytest.approx(expected, rel=0.02)
    faces = tube.face_matrix()
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    assert sorted(map(tuple, edges)) == sorted(map(tuple, edges[:, ::-1])), "watertight"
    assert (tube.vertex_color_matrix() == tube.vertex_color_matrix()[0]).all()
    assert np.isfinite(tube.vertex_normal_matrix()).all()


def test_the_control_polygon_is_that_of_the_spline(plate, plate_picks):
    for closed in (False, True):
        plate.set_current_mesh(0)
        _, figures = draw(plate, plate_picks, closed=closed, control_polygon=True)
        polygon = plate.mesh(plate.mesh_number() - 1)
        points, edges = polygon.vertex_matrix(), polygon.edge_matrix()
        expected = figures["control_points"].reshape(-1, 3)
        expected = expected[: len(expected) - figures["degree"] * closed]
        np.testing.assert_array_equal(points, expected)
        n = len(points)
        assert edges.tolist() == [[i, (i + 1) % n] for i in range(n if closed else n - 1)]


@pytest.mark.parametrize("shell", ["full", "simplified"])
def test_top_and_bottom_of_the_shell_lie_on_either_side(plate, plate_picks, shell):
    draw(plate, plate_picks, shell=shell, shell_layers=True)
    top, bottom = layers(plate)["plate shell top"], layers(plate)["plate shell bottom"]
    assert top.face_number() == bottom.face_number() > 0
    assert (top.vertex_matrix() - bottom.vertex_matrix())[:, 2].min() > 0
    # Both look the way the surface does.
    for layer in (top, bottom):
        assert (layer.vertex_normal_matrix()[:, 2] > 0).all()


def test_all_layers_move_with_the_surface(plate, plate_picks):
    plate.compute_matrix_from_rotation(rotaxis="X axis", angle=30, freeze=False)
    plate.compute_matrix_from_scaling_or_normalization(axisx=2, uniformflag=True, freeze=False)
    matrix = plate.mesh(0).transform_matrix()
    assert not np.array_equal(matrix, np.eye(4))
    picks = plate_picks @ matrix[:3, :3].T + matrix[:3, 3]
    layer, figures = draw(plate, picks, tube_radius=pymeshlab.PureValue(0.02), control_polygon=True, shell_layers=True)
    curve = CurveLayer(layer)
    for each in layers(plate).values():
        np.testing.assert_array_equal(each.transform_matrix(), matrix)
    away = distances(layers(plate)["plate tube"].vertex_matrix(), curve)
    assert away.max() == pytest.approx(0.01, rel=0.02), "half as large in the layer's coordinates"
    polygon = layers(plate)["plate control polygon"].vertex_matrix() @ matrix[:3, :3].T + matrix[:3, 3]
    np.testing.assert_allclose(polygon, figures["control_points"].reshape(-1, 3), atol=1e-12)


def test_a_further_curve_is_drawn_on_the_surface_again(plate, plate_picks):
    for _ in range(2):
        draw(plate, plate_picks, tube_radius=pymeshlab.PureValue(0.01), control_polygon=True, shell_layers=True)
    assert plate.mesh_number() == 11
    first, second = CurveLayer(plate.mesh(1)), CurveLayer(plate.mesh(6))
    np.testing.assert_array_equal(first.points, second.points)


def test_the_curve_is_saved_with_its_spline(plate, plate_picks, tmp_path):
    file = tmp_path / "kurve ä.json"
    layer, figures = draw(plate, plate_picks, save=str(file))
    saved = json.loads(file.read_text())
    np.testing.assert_allclose(saved["polyline"]["points"], CurveLayer(layer).points, atol=1e-14)
    np.testing.assert_array_equal(np.ravel(saved["spline"]["control_points"]), figures["control_points"])
    assert list(tmp_path.iterdir()) == [file]


def test_the_saved_curve_is_read_by_meshlabs_importer(plate, plate_picks, tmp_path):
    layer, _ = draw(plate, plate_picks, save=str(tmp_path / "curve.ply"))
    other = pymeshlab.MeshSet()
    other.load_new_mesh(str(tmp_path / "curve.ply"))
    np.testing.assert_allclose(other.current_mesh().vertex_matrix(), CurveLayer(layer).points, atol=1e-14)
    np.testing.assert_array_equal(other.current_mesh().edge_matrix(), CurveLayer(layer).edges)


@pytest.mark.parametrize("parameters, message", [
    ({"save": "/no/such/folder/curve.ply"}, "no/such/folder"),
    ({"save": "curve.doc"}, ".doc"),
    ({"tube_radius": pymeshlab.PureValue(50)}, "tube radius is 50.*diagonal"),
    ({"tube_radius": pymeshlab.PureValue(-1)}, "-1"),
])
def test_what_cannot_be_is_refused_and_leaves_nothing(plate, plate_picks, parameters, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert_refuses(plate, message, picks=as_text(plate_picks), **parameters)
    assert plate.mesh_number() == 1 and list(tmp_path.iterdir()) == []
