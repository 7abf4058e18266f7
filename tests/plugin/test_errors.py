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


def test_too_few_picks(plate, plate_picks):
    assert_refuses(plate, "1", picks=as_text(plate_picks[:1]))
    assert_refuses(plate, "3", picks=as_text(plate_picks[:2]), closed=True)


def test_a_pick_far_from_the_surface_is_named(plate, plate_picks):
    plate_picks[2, 2] += 0.1
    assert_refuses(plate, r"[Pp]ick 3", picks=as_text(plate_picks))


def test_too_few_different_picks_are_named(plate, plate_picks):
    picks = np.repeat(plate_picks[:1], 3, axis=0)
    assert_refuses(plate, r"[Pp]ick 1.*leaves 1 point", picks=as_text(picks))


def test_picks_on_different_components_are_named():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(np.vstack([square, square + [2, 0, 0]]), np.vstack([faces, faces + 4])))
    assert_refuses(document, r"(?s)[Pp]ick.*component", picks="0.2 0.2 0; 0.8 0.8 0; 2.5 0.5 0")


def test_text_that_is_no_point_is_named(plate):
    assert_refuses(plate, r"pick 2.*4 5", picks="0.1 0.1 0; 4 5")
    assert_refuses(plate, r"pick 1.*one", picks="one 2 3")


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
    assert_refuses(document, r"(?s)finite.*7", picks=as_text(plate_picks))


# ---- options ----

@pytest.mark.parametrize(
    "name, value",
    [("degree", 1), ("degree", 5), ("field_weight", -1.0), ("samples", -1),
     ("distance_tolerance", 0.0), ("shell_thickness", 0.0), ("shell_smoothing_passes", -1),
     ("target_thickness", 1.5), ("target_edge_length", -1.0), ("max_rounds", 0), ("max_iterations", 0),
     ("curve_segments", 0), ("normal_bending_weight", 0.0), ("minimum_span", 0.5)],
)
def test_a_value_out_of_its_range_is_refused_with_the_value(plate, plate_picks, name, value):
    assert_refuses(plate, f"{value:g}", picks=as_text(plate_picks), **{name: value})


def test_a_negative_segment_length(plate, plate_picks):
    assert_refuses(plate, "-1", picks=as_text(plate_picks), max_segment_length=pymeshlab.PureValue(-1))


def test_a_field_that_is_not_finite(plate, plate_picks):
    vertices, faces = plate.mesh(0).vertex_matrix(), plate.mesh(0).face_matrix()
    field = np.zeros(len(vertices))
    field[11] = np.inf
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces, v_scalar_array=field))
    assert_refuses(document, r"(?s)finite.*11", picks=as_text(plate_picks), field="quality")


def test_a_field_that_is_not_there(bunny_path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    picks = document.current_mesh().vertex_matrix()[[10, 2000]]
    assert_refuses(document, "no per-vertex quality", picks=as_text(picks), field="quality")


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
