# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that are no manifold are drawn on as they would be mended, and stay as they are. Fields, imprints and cuts on such layers
are tested in tests/filters."""
import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, assert_refuses, draw


def broken(plate, kind):
    """A document with a plate that has a bad spot far from the picks, and a quality."""
    vertices, faces = plate.mesh(0).vertex_matrix(), plate.mesh(0).face_matrix().astype(int)
    new = len(vertices)
    inner = faces[2 * (30 * 40 + 35)]  # no edge of it is on the boundary
    if kind == "bow tie":
        vertices = np.vstack([vertices, vertices[faces[0][0]] + [[-1, 0, 0], [-1, -1, 0]]])
        faces = np.vstack([[faces[0][0], new, new + 1], faces])
    elif kind == "three faces at an edge":
        vertices = np.vstack([vertices, vertices[inner].mean(0) + [0, 0, 1]])
        faces = np.vstack([faces, [inner[1], inner[0], new]])
    elif kind == "duplicate face":
        faces = np.vstack([[inner], faces])
    else:
        faces[0] = faces[0][::-1]
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces, v_scalar_array=vertices[:, 1] ** 2), "broken")
    return document, vertices, faces


KINDS = ["bow tie", "three faces at an edge", "duplicate face", "reversed face"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_curve_knows_the_faces_of_the_layer_as_it_is(plate, plate_picks, kind):
    document, vertices, faces = broken(plate, kind)
    assert_refuses(broken(plate, kind)[0], "edge|vert", picks="0.1 0.1 0; 0.9 0.9 0", strict=True)
    layer, figures = draw(document, plate_picks, field="quality")
    curve = CurveLayer(layer)
    assert figures["usable"]
    assert np.abs((vertices[faces[curve.faces]] * curve.barycentric[:, :, None]).sum(1) - curve.points).max() < 1e-12
    quality = (vertices[:, 1] ** 2)[faces[curve.faces]]
    assert np.abs((quality * curve.barycentric).sum(1) - curve.quality).max() < 1e-9
    assert np.array_equal(document.mesh(0).vertex_matrix(), vertices)
    assert np.array_equal(document.mesh(0).face_matrix(), faces)


@pytest.mark.parametrize("kind", KINDS)
def test_patterns_and_offsets_lie_on_the_layer_as_it_is(plate, tmp_path, kind):
    document, vertices, faces = broken(plate, kind)
    (tmp_path / "square.svg").write_text("<svg><path d='M0 0H1V1H0Z'/></svg>")
    draw(document, vertices[[415, 430]], field="none")
    size = pymeshlab.PureValue(0.05)
    document.apply_filter("pattern_on_surface", surface_layer=0, place="curve", drawing=str(tmp_path / "square.svg"), size=size)
    document.apply_filter("offset_curve_on_surface", surface_layer=0, curve_layer=1, offset=pymeshlab.PureValue(0.1))
    for layer in (document.mesh(2), document.mesh(3)):
        corners = vertices[faces[layer.vertex_custom_scalar_attribute_array("face_index").astype(int)]]
        weights = layer.vertex_custom_point_attribute_matrix("barycentric")
        assert np.abs((corners * weights[:, :, None]).sum(1) - layer.vertex_matrix()).max() < 1e-12


def test_parts_that_only_look_joined_are_welded(plate):
    vertices, faces = plate.mesh(0).vertex_matrix(), plate.mesh(0).face_matrix().astype(int)
    both = np.vstack([vertices, vertices * [-1, 1, 1] - [1e-8, 0, 0]]), np.vstack([faces, faces[:, ::-1] + len(vertices)])
    picks = both[0][[20 * 41 + 20, len(vertices) + 15 * 41 + 25]]
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(*both))
    assert_refuses(document, "option weld", picks="; ".join(" ".join(map(repr, p)) for p in picks.tolist()))
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(*both))
    for _ in range(2):  # the second time with the surface that was kept
        layer, figures = draw(document, picks, weld=1e-6, surface_layer=0)
        assert figures["usable"] and np.ptp(CurveLayer(layer).points[:, 0]) > 0.8
    figures = document.apply_filter("imprint_curves", weld=1e-6, surface_layer=0, curve_layer=1)
    assert (figures["projected_curves"], figures["parts"]) == (0, 1)
    document.set_current_mesh(0)
    assert_refuses(document, "option weld", picks="; ".join(" ".join(map(repr, p)) for p in picks.tolist()))
