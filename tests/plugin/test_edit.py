# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves joined, cut, turned round and made longer."""
import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, assert_refuses, assert_strictly_on, draw
from meshes import wavy_plate

EDIT = "edit_curve_on_surface"
LEFT, RIGHT = [5 * 41 + 5, 12 * 41 + 9, 20 * 41 + 12], [35 * 41 + 30, 28 * 41 + 20, 21 * 41 + 12]


@pytest.fixture
def curves(plate):
    """The plate, the current layer, with two curves whose ends are an edge apart."""
    vertices, _ = wavy_plate()
    for picks in (LEFT, RIGHT):
        draw(plate, vertices[picks])
        plate.set_current_mesh(0)
    return plate


def labels(document):
    return [layer.label() for layer in document]


def made(document, count):
    """The last layers, checked."""
    layers = [CurveLayer(layer) for layer in list(document)[-count:]]
    for layer in layers:
        assert_strictly_on(layer, *wavy_plate())
    return layers


def test_curves_become_one_and_are_hidden(curves):
    vertices, _ = wavy_plate()
    before = [CurveLayer(curves.mesh(i)).length() for i in (1, 2)]
    figures = curves.apply_filter(EDIT, gap="2 edges")
    assert labels(curves)[3:] == ["plate curve joined"] and (figures["curves"], figures["new_curves"]) == (2, 1)
    (whole,) = made(curves, 1)
    assert figures["length"] == pytest.approx(whole.length()) and sum(before) < whole.length() < sum(before) + 0.1
    np.testing.assert_allclose(whole.points[[0, -1]], vertices[[LEFT[0], RIGHT[0]]], atol=1e-6)
    assert [curves.mesh(i).is_visible() for i in range(4)] == [True, False, False, True]
    # What comes next takes the new curve alone.
    curves.set_current_mesh(0)
    assert curves.apply_filter("imprint_curves")["curves"] == 1


def test_ends_that_are_too_far_apart_are_refused(curves):
    assert_refuses(curves, "gap", EDIT, gap="0.1 edges")


def test_a_curve_is_cut_turned_and_made_longer(plate):
    vertices, _ = wavy_plate()
    draw(plate, vertices[LEFT])
    whole = CurveLayer(plate.mesh(1))
    figures = plate.apply_filter(EDIT, surface_layer=0, curve_layer=1, edit="split", at="0.5, 0.2")
    assert labels(plate)[2:] == [f"plate curve part {i}" for i in (1, 2, 3)] and figures["new_curves"] == 3
    parts = made(plate, 3)
    assert sum(part.length() for part in parts) == pytest.approx(whole.length(), rel=1e-6)
    plate.apply_filter(EDIT, surface_layer=0, curve_layer=1, edit="trim", at="0.2, 0.5")
    (trimmed,) = made(plate, 1)
    np.testing.assert_allclose(trimmed.points, parts[1].points, atol=1e-7)
    plate.apply_filter(EDIT, surface_layer=0, curve_layer=1, edit="reverse")
    (turned,) = made(plate, 1)
    np.testing.assert_allclose(turned.points, whole.points[::-1], atol=1e-7)
    length = pymeshlab.PureValue(0.05)
    plate.apply_filter(EDIT, surface_layer=0, curve_layer=1, edit="extend", extension=length, ends="both")
    (longer,) = made(plate, 1)
    assert longer.length() == pytest.approx(whole.length() + 0.1, abs=2e-3)
    # An edited curve can be edited again.
    plate.apply_filter(EDIT, surface_layer=0, curve_layer=plate.current_mesh_id(), edit="trim", at="0, 0.5")
    assert made(plate, 1)[0].length() == pytest.approx(longer.length() / 2, rel=0.2)


@pytest.mark.parametrize("at", ["", "0.5", "0.2, 1.5", "here"])
def test_places_that_are_none_are_refused(plate, at):
    vertices, _ = wavy_plate()
    draw(plate, vertices[LEFT])
    assert_refuses(plate, "at is ", EDIT, surface_layer=0, curve_layer=1, edit="trim", at=at)
