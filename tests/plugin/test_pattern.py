# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter Pattern on Surface in pymeshlab: drawings and text as a layer of curves."""
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from curves import draw
from meshes import wavy_plate

STAR = "<svg><path d='M0 -4 L1 -1 L4 0 L1 1 L0 4 L-1 1 L-4 0 L-1 -1Z'/><circle r='3'/></svg>"
FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")


@pytest.fixture
def star(tmp_path):
    (tmp_path / "star.svg").write_text(STAR)
    return str(tmp_path / "star.svg")


def middle_of_the_plate():
    vertices, _ = wavy_plate()
    return vertices[20 * 41 + 20]


def text_of(point):
    return " ".join(f"{x:.17g}" for x in point)


def test_a_drawing_round_a_point_is_one_layer_of_curves(plate, star):
    centre = middle_of_the_plate()
    figures = plate.apply_filter("pattern_on_surface", drawing=star, centre=text_of(centre), size=pymeshlab.PureValue(0.4))
    assert [layer.label() for layer in plate] == ["plate", "plate pattern"]
    layer = plate.current_mesh()
    assert figures["curves"] == 9
    assert 0.5 < figures["shortest_ratio"] <= 1.01
    assert layer.edge_number() == layer.vertex_number() - 8  # eight open curves and a closed one
    faces = layer.vertex_custom_scalar_attribute_array("face_index").astype(int)
    weights = layer.vertex_custom_point_attribute_matrix("barycentric")
    vertices, corners = wavy_plate()
    points = np.einsum("ij,ijk->ik", weights, vertices[corners[faces]])
    np.testing.assert_allclose(layer.vertex_matrix(), points, atol=1e-14)
    reach = np.linalg.norm(layer.vertex_matrix() - centre, axis=1).max()
    assert 0.15 < reach <= 0.2 + 1e-9  # along the surface it is a fifth


def test_its_curves_cut_the_mesh(plate, star):
    plate.apply_filter("pattern_on_surface", drawing=star, centre=text_of(middle_of_the_plate()), size=pymeshlab.PureValue(0.4))
    figures = plate.apply_filter("imprint_curves", surface_layer=0)
    assert (figures["curves"], figures["projected_curves"], figures["parts"]) == (9, 0, 10)


def test_a_drawing_along_a_curve(plate, star):
    vertices, _ = wavy_plate()
    draw(plate, vertices[[20 * 41 + 5, 20 * 41 + 20, 20 * 41 + 35]], field="none")
    for _ in range(2):  # the second is not along the lines of the first
        figures = plate.apply_filter("pattern_on_surface", surface_layer=0, place="curve", drawing=star, repeat=3,
                                     size=pymeshlab.PureValue(0.1))
        assert figures["curves"] == 27
    assert plate.apply_filter("imprint_curves", surface_layer=0)["curves"] == 1
    assert plate.apply_filter("imprint_curves", surface_layer=0, curve_layer=2)["curves"] == 27


def test_a_text(plate):
    if not FONT.exists():
        pytest.skip(f"no {FONT}")
    figures = plate.apply_filter("pattern_on_surface", text="io", font=str(FONT), centre=text_of(middle_of_the_plate()),
                                 size=pymeshlab.PureValue(0.3))
    assert figures["curves"] == 4 + 4 + 2  # two boxes and two rings


def test_a_text_without_a_font_takes_one_of_the_system(plate, monkeypatch, tmp_path):
    if not FONT.exists():
        pytest.skip(f"no {FONT}")
    options = {"text": "io", "centre": text_of(middle_of_the_plate()), "size": pymeshlab.PureValue(0.3)}
    assert plate.apply_filter("pattern_on_surface", **options)["curves"] == 4 + 4 + 2
    for name in ("HOME", "XDG_DATA_DIRS", "XDG_DATA_HOME"):
        monkeypatch.setenv(name, str(tmp_path))
    with pytest.raises(pymeshlab.PyMeshLabException, match="no font was found for the text: give a font file"):
        plate.apply_filter("pattern_on_surface", surface_layer=0, **options)


@pytest.mark.parametrize(("options", "said"), [
    ({}, "drawing or a text"),
    ({"drawing": "no.svg", "centre": "0.5 0.5 0"}, "no.svg"),
    ({"text": "a", "font": "no.ttf", "centre": "0.5 0.5 0"}, "no.ttf"),
    ({"drawing": "star.svg", "text": "a"}, "not both"),
    ({"drawing": "star.svg"}, "0 points"),
    ({"drawing": "star.svg", "centre": "0 0 9"}, "away from the mesh"),
    ({"drawing": "star.svg", "place": "curve"}, "polyline"),
    ({"drawing": "star.svg", "centre": "middle", "size": 9.0}, "path 0"),
])
def test_refusals_leave_the_document_as_it_was(plate, star, options, said):
    given = dict(options)
    if given.get("drawing") == "star.svg":
        given["drawing"] = star
    if given.get("centre") == "middle":
        given["centre"] = text_of(middle_of_the_plate())
    if "size" in given:
        given["size"] = pymeshlab.PureValue(given["size"])
    with pytest.raises(pymeshlab.PyMeshLabException, match=said):
        plate.apply_filter("pattern_on_surface", **given)
    assert [layer.label() for layer in plate] == ["plate"]
