# SPDX-License-Identifier: GPL-3.0-or-later
"""The layer that the filter adds, in the real pymeshlab."""
import subprocess

import numpy as np
import pymeshlab
import pytest
from meshes import wavy_plate
from curves import CurveLayer, assert_edges_in_order, assert_passes, assert_strictly_on, draw, write_pp


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_a_curve_is_one_chain_on_the_surface_through_the_picks(plate, plate_picks, degree, closed):
    layer, figures = draw(plate, plate_picks, degree=degree, closed=closed)
    curve = CurveLayer(layer)
    assert figures["usable"]
    assert figures["degree"] == degree
    assert figures["closed"] == curve.is_closed() == closed
    assert_edges_in_order(curve)
    assert_strictly_on(curve, *wavy_plate())
    assert_passes(curve, figures, plate_picks)


def test_the_curve_is_a_new_current_layer_named_after_the_input(plate, plate_picks):
    layer, _ = draw(plate, plate_picks)
    assert plate.mesh_number() == 2
    assert plate.current_mesh_id() == 1
    assert layer.label() == "plate curve"
    assert layer.face_number() == 0


def test_the_name_leaves_out_the_extension_of_the_inputs_file(bunny_path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    vertices = document.current_mesh().vertex_matrix()
    layer, _ = draw(document, vertices[[10, 2000]])
    assert layer.label() == "bunny curve"


def test_the_input_layer_is_not_changed(plate, plate_picks):
    before = plate.mesh(0)
    was = (before.vertex_matrix().copy(), before.face_matrix().copy(), before.vertex_scalar_array().copy(),
           before.vertex_normal_matrix().copy(), before.transform_matrix().copy(), before.label())
    draw(plate, plate_picks, closed=True)
    after = plate.mesh(0)
    now = (after.vertex_matrix(), after.face_matrix(), after.vertex_scalar_array(), after.vertex_normal_matrix(),
           after.transform_matrix(), after.label())
    for a, b in zip(was, now):
        np.testing.assert_array_equal(a, b)


def test_the_filter_applied_again_draws_on_the_same_surface(plate, plate_picks):
    first = CurveLayer(draw(plate, plate_picks)[0])
    second = CurveLayer(draw(plate, plate_picks)[0])
    assert plate.mesh_number() == 3
    np.testing.assert_array_equal(first.points, second.points)


def test_a_surface_that_changed_gets_a_new_curve(plate, plate_picks):
    first = CurveLayer(draw(plate, plate_picks)[0])
    plate.set_current_mesh(0)
    plate.compute_matrix_from_translation(axisz=0.5, freeze=True)
    second = CurveLayer(draw(plate, plate_picks + [0, 0, 0.5])[0])
    np.testing.assert_allclose(second.points, first.points + [0, 0, 0.5], atol=1e-6)


def test_quality_is_the_parameter_where_there_is_no_field(plate, plate_picks):
    curve = CurveLayer(draw(plate, plate_picks)[0])
    np.testing.assert_array_equal(curve.quality, curve.t)
    assert curve.t[0] == 0 and curve.t[-1] == 1
    assert (np.diff(curve.t) > 0).all()


def test_quality_is_the_field_where_there_is_one(plate, plate_picks):
    vertices, faces = wavy_plate()
    plate.compute_scalar_by_function_per_vertex(q="x + 2 * y")
    curve = CurveLayer(draw(plate, plate_picks, field="quality")[0])
    field = vertices @ [1, 2, 0]
    np.testing.assert_allclose(curve.quality, (field[faces[curve.faces]] * curve.barycentric).sum(1), atol=1e-12)


@pytest.mark.parametrize("limit", [pymeshlab.PureValue(0.005), pymeshlab.PercentageValue(0.3)])
def test_no_segment_is_longer_than_asked(plate, plate_picks, limit):
    curve = CurveLayer(draw(plate, plate_picks, max_segment_length=limit)[0])
    assert np.linalg.norm(np.diff(curve.points, axis=0), axis=1).max() <= 0.005 * (1 + 1e-6)


def test_the_figures_describe_the_curve(plate, plate_picks):
    layer, figures = draw(plate, plate_picks)
    curve = CurveLayer(layer)
    assert figures["vertices"] == len(curve.points)
    assert figures["length"] == pytest.approx(curve.length(), rel=1e-12)
    assert isinstance(figures["usable"], bool) and isinstance(figures["converged"], bool)
    assert figures["max_pick_gap"] < 1e-9
    assert 0 <= figures["max_distance"] <= figures["allowed_distance"] == pytest.approx(0.1)
    assert figures["knots_first"] > 0 and figures["knots_last"] == len(figures["knots"])
    control_points = figures["control_points"].reshape(-1, 3)
    assert len(figures["knots"]) == len(control_points) + figures["degree"] + 1
    assert len(figures["pick_parameters"]) == len(plate_picks)
    np.testing.assert_allclose(curve.t[figures["pick_vertices"].astype(int)], figures["pick_parameters"], atol=1e-9)
    assert 0 < figures["seconds_curve"] < figures["seconds"]


def test_a_curve_in_a_simplified_shell_is_one_chain_on_the_surface_too(plate, plate_picks):
    prisms = {}
    for shell in ("full", "simplified"):
        layer, figures = draw(plate, plate_picks, shell=shell)
        curve = CurveLayer(layer)
        assert figures["usable"]
        assert_edges_in_order(curve)
        assert_strictly_on(curve, *wavy_plate())
        assert_passes(curve, figures, plate_picks)
        prisms[shell] = figures["prisms"]
    assert prisms["full"] > len(wavy_plate()[1]) > 10 * prisms["simplified"] > 0
    more = draw(plate, plate_picks, shell="simplified", target_edge_length=0.1)[1]["prisms"]
    assert more > prisms["simplified"]


def test_the_layers_matrix_is_honoured(plate, plate_picks):
    """Picks are world coordinates; the curve stays in the coordinates and under the matrix of its surface."""
    straight = CurveLayer(draw(plate, plate_picks)[0])
    plate.set_current_mesh(0)
    plate.compute_matrix_from_rotation(rotaxis="Z axis", angle=30, freeze=False)
    plate.compute_matrix_from_translation(axisx=3, axisy=-1, axisz=2, freeze=False)
    matrix = plate.current_mesh().transform_matrix()
    world_picks = plate_picks @ matrix[:3, :3].T + matrix[:3, 3]
    layer, figures = draw(plate, world_picks)
    curve = CurveLayer(layer)
    np.testing.assert_array_equal(layer.transform_matrix(), matrix)
    assert_strictly_on(curve, *wavy_plate())
    assert_passes(curve, figures, plate_picks)
    np.testing.assert_allclose(layer.transformed_vertex_matrix()[0], world_picks[0], atol=1e-9)
    assert curve.length() == pytest.approx(straight.length(), rel=1e-3)


def test_ids_are_those_of_the_layer_where_elements_are_deleted(plate):
    """A layer's arrays may still hold what was deleted, as after an edit in MeshLab's window."""
    vertices, faces = wavy_plate()
    removed = 80
    arrays = plate.apply_filter("convert_with_deleted", faces=removed)
    kept_vertices = np.unique(faces[removed:])
    assert not arrays["has_layers_ids"]
    np.testing.assert_array_equal(arrays["face_ids"], np.arange(removed, len(faces)))
    np.testing.assert_array_equal(arrays["vertex_ids"], kept_vertices)
    np.testing.assert_array_equal(arrays["vertices"].reshape(-1, 3), vertices[kept_vertices])
    np.testing.assert_array_equal(kept_vertices[arrays["faces"].reshape(-1, 3).astype(int)], faces[removed:])


def test_ids_are_those_of_the_arrays_where_nothing_is_deleted(plate):
    assert plate.apply_filter("convert_with_deleted", faces=0)["has_layers_ids"]


def test_the_host_keeps_the_tension_in_its_range(plate, plate_picks):
    most, beyond = (CurveLayer(draw(plate, plate_picks, tension=x)[0]) for x in (1.0, 1.5))
    np.testing.assert_array_equal(most.points, beyond.points)


@pytest.mark.parametrize("options", [{}, {"shell": "simplified", "target_thickness": 0.1}])
def test_the_program_draws_the_same_curve(options, program, bunny_path, tmp_path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    vertices = document.current_mesh().vertex_matrix()
    picks = vertices[[10, 2000, 5000]]
    pp = write_pp(tmp_path / "picks.pp", picks)
    layer, _ = draw(document, picks_file=str(pp), tension=0.1, distance_tolerance=0.05, **options)
    words = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
    subprocess.run(
        [program, bunny_path, "--picks", pp, "--output", tmp_path / "curve.ply", "--tension", "0.1",
         "--distance-tolerance", "0.05", *words],
        check=True,
    )
    document.load_new_mesh(str(tmp_path / "curve.ply"))
    np.testing.assert_allclose(layer.vertex_matrix(), document.current_mesh().vertex_matrix(), rtol=0, atol=1e-12)
