# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong is said, the host lives on, and no layer is added."""
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from curves import as_text, assert_refuses


# ---- picks ----

def test_no_picks(plate):
    assert_refuses(plate, "no picks")


def test_a_pick_far_from_the_surface_is_named(plate, plate_picks):
    plate_picks[2, 2] += 0.1
    assert_refuses(plate, r"[Pp]ick 3", picks=as_text(plate_picks))


def test_picks_given_twice(plate, plate_picks, tmp_path):
    assert_refuses(plate, "picks and picks_file", picks=as_text(plate_picks), picks_file=str(tmp_path / "p.pp"))


def test_a_file_that_is_not_there(plate, tmp_path):
    assert_refuses(plate, "nowhere.pp", picks_file=str(tmp_path / "nowhere.pp"))


def test_a_layer_of_picks_with_faces(plate):
    plate.create_sphere()
    assert_refuses(plate, "picks_layer.*has faces", surface_layer=0, picks_layer=1)


# ---- layers ----

def test_layers_that_do_not_exist(plate, plate_picks):
    assert_refuses(plate, "surface_layer.*77", surface_layer=77, picks=as_text(plate_picks))
    assert_refuses(plate, "picks_layer.*77", picks_layer=77)


def test_a_surface_without_faces(plate_picks):
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(plate_picks), "points")
    assert_refuses(document, '"points" has no faces', picks=as_text(plate_picks))


def test_a_surface_that_is_no_manifold():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]], float)
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]])))
    assert_refuses(document, "more than two faces.*faces 0, 1, 2", picks="0.1 0 0; 0.9 0 0", strict=True)


def test_a_coordinate_that_is_not_finite(plate, plate_picks):
    plate.set_current_mesh(0)
    vertices, faces = plate.mesh(0).vertex_matrix(), plate.mesh(0).face_matrix()
    vertices[7, 1] = np.nan
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces))
    assert_refuses(document, r"(?s)finite.*7.*without the option strict", picks=as_text(plate_picks), strict=True)


# ---- options ----

def test_a_negative_segment_length(plate, plate_picks):
    assert_refuses(plate, "-1", picks=as_text(plate_picks), max_segment_length=pymeshlab.PureValue(-1))


@pytest.mark.parametrize(("is_of_other_version", "expected"), [
    (True, "libfilter_bspline_curve.so has different version from the running MeshLab version."),
    (False, "libfilter_bspline_curve.so has been already loaded."),
])
def test_a_plugin_that_is_not_loaded_is_told_as_the_page_says(is_of_other_version, expected, plugin_path, tmp_path):
    page = (Path(__file__).resolve().parents[2] / "docs" / "MESHLAB.md").read_text()
    assert f"`{expected}`" in page
    plugin = plugin_path
    if is_of_other_version:
        plugin = tmp_path / plugin_path.name
        built = plugin_path.read_bytes()
        assert b"2025.07d" in built
        plugin.write_bytes(built.replace(b"2025.07d", b"2023.12d"))
    with pytest.raises(pymeshlab.PyMeshLabException) as refused:
        pymeshlab.load_plugin(str(plugin))
    assert str(refused.value) == expected
