# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the filter and looks at its results, for the tests."""
import numpy as np
import pymeshlab
import pytest

FILTER = "generate_bspline_curve_on_surface"

# After an error pymeshlab 2025.7 keeps a pointer to the document's log and uses it when it loads the next mesh (its
# issue 399), so a document that refused something must live on.
KEPT = []


def assert_refuses(document, message, name=FILTER, **parameters):
    KEPT.append(document)
    layers = document.mesh_number()
    with pytest.raises(pymeshlab.PyMeshLabException, match=message):
        document.apply_filter(name, **parameters)
    assert document.mesh_number() == layers


def as_text(points):
    return "; ".join(" ".join(repr(float(x)) for x in p) for p in points)


def write_pp(path, points, inactive=()):
    lines = [
        f' <point x="{p[0]!r}" y="{p[1]!r}" z="{p[2]!r}" active="{int(i not in inactive)}" name="{i}"/>'
        for i, p in enumerate(np.asarray(points).tolist())
    ]
    path.write_text("<!DOCTYPE PickedPoints>\n<PickedPoints>\n" + "\n".join(lines) + "\n</PickedPoints>\n")
    return path


def draw(document, through=None, **parameters):
    """Applies the filter, to an array of picks if one is given; returns the new layer and the figures."""
    if through is not None:
        parameters["picks"] = as_text(through)
    figures = document.apply_filter(FILTER, **parameters)
    return document.current_mesh(), figures


class CurveLayer:
    """The arrays of a curve's layer."""

    def __init__(self, layer):
        self.points = layer.vertex_matrix()
        self.edges = layer.edge_matrix()
        self.faces = layer.vertex_custom_scalar_attribute_array("face_index").astype(int)
        self.barycentric = layer.vertex_custom_point_attribute_matrix("barycentric")
        self.t = layer.vertex_custom_scalar_attribute_array("t")
        self.quality = layer.vertex_scalar_array()

    def is_closed(self):
        return len(self.edges) == len(self.points)

    def length(self):
        return np.linalg.norm(self.points[self.edges[:, 1]] - self.points[self.edges[:, 0]], axis=1).sum()


def assert_edges_in_order(curve):
    n = len(curve.points)
    expected = [[i, i + 1] for i in range(n - 1)] + ([[n - 1, 0]] if curve.is_closed() else [])
    assert curve.edges.tolist() == expected


def assert_strictly_on(curve, vertices, faces):
    """Every vertex is where its face and barycentrics say, every segment lies in one face."""
    assert (curve.barycentric >= 0).all()
    np.testing.assert_allclose(curve.barycentric.sum(1), 1, atol=1e-12)
    expected = (vertices[faces[curve.faces]] * curve.barycentric[..., None]).sum(1)
    np.testing.assert_allclose(curve.points, expected, rtol=0, atol=1e-12 * np.ptp(vertices))
    holders = [faces_holding(faces, f, b) for f, b in zip(curve.faces, curve.barycentric)]
    for a, b in curve.edges:
        assert holders[a] & holders[b], f"segment {a}-{b} lies in no face"
    assert (np.linalg.norm(np.diff(curve.points, axis=0), axis=1) > 0).all()


def faces_holding(faces, face, barycentric):
    """The faces that hold a point: those around the vertices of its face that it is a mixture of."""
    support = faces[face][barycentric > 0]
    return set(np.where((faces[:, :, None] == support).any(1).all(1))[0].tolist())


def assert_passes(curve, figures, picks, tolerance=1e-9):
    """The picks are vertices of the curve, in order."""
    at = figures["pick_vertices"].astype(int)
    assert len(at) == len(picks)
    assert (np.diff(at) > 0).all()
    assert np.linalg.norm(curve.points[at] - picks, axis=1).max() <= tolerance * np.ptp(curve.points)
