# SPDX-License-Identifier: GPL-3.0-or-later
"""Every way to give picks leads to the same curve."""
import json

import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, as_text, draw, write_pp


@pytest.fixture
def expected(plate, plate_picks):
    return CurveLayer(draw(plate, plate_picks)[0]).points


@pytest.fixture
def same(expected, plate):
    """Draws on the plate by other parameters and compares."""
    plate.set_current_mesh(0)

    def compare(**parameters):
        np.testing.assert_array_equal(CurveLayer(draw(plate, **parameters)[0]).points, expected)

    return compare


def test_text_may_have_commas_line_ends_and_a_last_separator(same, plate_picks):
    same(picks="\n".join(", ".join(map(repr, p)) + ";" for p in plate_picks.tolist()))


def lines(points, separator):
    return "".join(separator.join(map(repr, p)) + "\n" for p in points.tolist())


@pytest.mark.parametrize("name, write", [
    ("picks.pp", write_pp),
    ("picks.json", lambda path, points: path.write_text(json.dumps({"picks": points.tolist()}))),
    ("picks.xyz", lambda path, points: path.write_text(lines(points, " "))),
    ("picks.csv", lambda path, points: path.write_text("x,y,z\n" + lines(points, ","))),
])
def test_a_file_of_every_format(same, plate_picks, tmp_path, name, write):
    write(tmp_path / name, plate_picks)
    same(picks_file=str(tmp_path / name))


def test_points_of_a_pp_file_that_are_not_active_are_left_out(same, plate_picks, tmp_path):
    points = np.insert(plate_picks, 2, [0.5, 0.5, 0], axis=0)
    same(picks_file=str(write_pp(tmp_path / "picks.pp", points, inactive=[2])))


@pytest.mark.parametrize("is_current", [False, True])
def test_a_layer_of_points(same, plate, plate_picks, is_current):
    plate.add_mesh(pymeshlab.Mesh(plate_picks), "picks")
    if not is_current:
        plate.set_current_mesh(0)
    same(picks_layer=plate.mesh_number() - 1)


def test_the_matrix_of_a_layer_of_points_is_applied(same, plate, plate_picks):
    plate.add_mesh(pymeshlab.Mesh(plate_picks - [1, 2, 3]), "picks")
    plate.compute_matrix_from_translation(axisx=1, axisy=2, axisz=3, freeze=False)
    picks = plate.current_mesh().transformed_vertex_matrix()
    assert np.abs(picks - plate_picks).max() < 1e-12
    curve = CurveLayer(draw(plate, surface_layer=0, picks_layer=plate.current_mesh_id())[0])
    np.testing.assert_allclose(curve.points[0], plate_picks[0], atol=1e-9)


def test_points_of_the_pickpoints_tool(same, plate, plate_picks):
    texts = [as_text([p]) + " 1" for p in plate_picks]
    texts.insert(1, "0.5 0.5 0 0")  # not present
    plate.apply_filter("leave_picked_points", points=";".join(texts))
    same()


def test_a_given_pick_goes_before_those_of_the_tool(same, plate, plate_picks):
    plate.apply_filter("leave_picked_points", points="0.1 0.1 0 1;0.9 0.9 0 1")
    same(picks=as_text(plate_picks))


def test_a_file_can_say_that_the_curve_is_closed(plate, plate_picks, tmp_path):
    (tmp_path / "picks.json").write_text(json.dumps({"picks": plate_picks.tolist(), "closed": True}))
    layer, figures = draw(plate, picks_file=str(tmp_path / "picks.json"))
    assert figures["closed"] and CurveLayer(layer).is_closed()
