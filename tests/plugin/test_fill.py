# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter Fill Holes in pymeshlab: holes that a mesh has, closed on a copy of it."""
import numpy as np
import pymeshlab
import pytest
from curves import assert_refuses


@pytest.fixture
def pierced():
    """A document with a sphere that has a small hole at the top and a large one at the bottom; quality is the height."""
    document = pymeshlab.MeshSet()
    document.create_sphere(subdiv=4)
    whole = document.current_mesh()
    vertices, faces = whole.vertex_matrix(), whole.face_matrix()
    height = vertices[faces][:, :, 2].mean(1)
    faces = faces[(height < 0.98) & (height > -0.85)]
    used, faces = np.unique(faces, return_inverse=True)
    vertices = vertices[used]
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces.reshape(-1, 3), v_scalar_array=vertices[:, 2]), "pierced")
    return document


@pytest.mark.parametrize("shape", ["smooth", "flat"])
def test_all_holes_are_closed_and_the_mesh_stays(pierced, shape):
    source = pierced.mesh(0)
    vertices, faces = source.vertex_matrix(), source.face_matrix()
    figures = pierced.apply_filter("fill_holes", shape=shape)
    filled = pierced.current_mesh()
    assert filled.label() == "pierced filled" and figures["filled_holes"] == 2
    assert (figures["vertices"], figures["faces"]) == (filled.vertex_number(), filled.face_number())
    assert figures["new_faces"] == filled.face_number() - len(faces)
    np.testing.assert_array_equal(filled.face_matrix()[: len(faces)], faces)
    np.testing.assert_array_equal(source.face_matrix(), faces)
    assert pierced.apply_filter("get_topological_measures")["boundary_edges"] == 0
    if shape == "smooth":
        volume = pierced.apply_filter("get_geometric_measures")["mesh_volume"]
        assert volume == pytest.approx(4 / 3 * np.pi, rel=0.01)
        new = filled.vertex_matrix()[len(vertices):, 2]
        assert (np.sign(filled.vertex_scalar_array()[len(vertices):]) == np.sign(new)).all()


@pytest.mark.parametrize("words, top, bottom", [
    ({"max_edges": 40}, True, False),
    ({"max_length": 2.0}, True, False),
    ({"seed": "0 0 -1"}, False, True),
])
def test_those_that_are_chosen_are_closed(pierced, words, top, bottom):
    count = pierced.mesh(0).vertex_number()
    assert pierced.apply_filter("fill_holes", **words)["filled_holes"] == 1
    new = pierced.current_mesh().vertex_matrix()[count:, 2]
    assert ((new > 0.9).any(), (new < -0.8).any()) == (top, bottom)


def test_what_cannot_be_done_is_refused(pierced):
    assert_refuses(pierced, "none of 2 holes is as small as that", "fill_holes", max_edges=3)
    assert_refuses(pierced, "one point", "fill_holes", seed="0 0 1; 0 0 -1")
    assert_refuses(pierced, "max_edges", "fill_holes", max_edges=-1)
    pierced.apply_filter("fill_holes")
    assert_refuses(pierced, "the mesh has no hole", "fill_holes")
