# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as edges of a mesh, in arrays."""
import numpy as np
import pytest

import bspline_curve


@pytest.fixture(scope="module")
def crossing(mesh, arrays):
    vertices = arrays[0]
    return [mesh.curve(vertices[[100, 860, 1600]]), mesh.curve(vertices[[130, 830, 1550]], degree=2)]


@pytest.fixture(scope="module")
def imprint(mesh, crossing):
    return mesh.imprint(crossing)


def areas(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def test_curves_are_edges_of_a_mesh_with_the_same_surface(mesh, crossing, imprint):
    np.testing.assert_array_equal(imprint.vertices[: len(mesh.vertices)], mesh.vertices)
    sides = np.sort(np.concatenate([imprint.faces[:, [0, 1]], imprint.faces[:, [1, 2]], imprint.faces[:, [2, 0]]]), axis=1)
    edges = set(map(tuple, sides.tolist()))
    for curve, vertices in zip(crossing, imprint.curves, strict=True):
        assert all((min(pair), max(pair)) in edges for pair in zip(vertices[:-1].tolist(), vertices[1:].tolist()))
        at = np.linalg.norm(imprint.vertices[vertices][:, None] - curve.points[None], axis=2).argmin(axis=0)
        assert (np.diff(at) >= 0).all()
        np.testing.assert_allclose(imprint.vertices[vertices[at]], curve.points, atol=1e-9)
    children = np.bincount(imprint.parents, weights=areas(imprint.vertices, imprint.faces))
    np.testing.assert_allclose(children, areas(mesh.vertices, mesh.faces), rtol=1e-9)
    assert len(imprint.crossings) >= 1 and imprint.largest_move < 1e-9
    assert len(repr(imprint)) < 100


def test_values_are_linear_in_each_face(mesh, imprint):
    np.testing.assert_allclose(imprint.values(mesh.vertices, mesh.faces), imprint.vertices, atol=1e-14)
    heights = mesh.vertices[:, 2]
    np.testing.assert_allclose(imprint.values(heights, mesh.faces), imprint.vertices[:, 2], atol=1e-14)
    with pytest.raises(bspline_curve.FieldError, match="one for each vertex"):
        imprint.values(heights[:5], mesh.faces)


def test_a_closed_curve_parts_a_disc(mesh, arrays):
    ring = mesh.curve(arrays[0][[500, 530, 1250, 1200]], closed=True)
    imprint = mesh.imprint([ring])
    outer, inner = imprint.parts
    assert outer.area > inner.area and inner.euler == 1 and outer.euler == 0
    assert inner.perimeter == pytest.approx(ring.length)
    assert outer.area + inner.area == pytest.approx(areas(mesh.vertices, mesh.faces).sum())
    np.testing.assert_array_equal(np.flatnonzero(imprint.labels == 1), inner.faces)
    cut = imprint.cut()
    assert len(cut.vertices) == len(imprint.vertices) + len(imprint.curves[0])
    np.testing.assert_array_equal(cut.origins[cut.faces], imprint.faces)
    np.testing.assert_array_equal(cut.vertices, imprint.vertices[cut.origins])
    assert not np.intersect1d(cut.faces[imprint.labels == 0], cut.faces[imprint.labels == 1]).size


def test_what_cannot_be_imprinted_is_refused(mesh, arrays, crossing):
    with pytest.raises(bspline_curve.InputError, match=r"curves\[1\] is of another mesh"):
        mesh.imprint([crossing[0], bspline_curve.Mesh(*arrays).curve(arrays[0][[45, 700]])])
    with pytest.raises(bspline_curve.OptionError, match="snap is 0.5"):
        mesh.imprint(crossing, snap=0.5)
