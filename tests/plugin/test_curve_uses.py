# SPDX-License-Identifier: GPL-3.0-or-later
"""Imprint, cut, segment and offset on layers of polylines."""
import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, as_text, assert_refuses, assert_strictly_on, draw
from meshes import wavy_plate

CORNERS = [10 * 41 + 10, 10 * 41 + 30, 30 * 41 + 30, 30 * 41 + 10]


@pytest.fixture
def ringed(plate):
    """The plate, the current layer, with a closed curve on it; the curve's arrays."""
    vertices, _ = wavy_plate()
    layer, _ = draw(plate, vertices[CORNERS], closed=True)
    curve = CurveLayer(layer)
    plate.set_current_mesh(0)
    return plate, curve


def labels(document):
    return [layer.label() for layer in document]


def areas(mesh):
    a, b, c = (mesh.vertex_matrix()[mesh.face_matrix()[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def edges_of(mesh):
    faces = mesh.face_matrix()
    return {tuple(sorted(edge)) for k in range(3) for edge in faces[:, [k, (k + 1) % 3]].tolist()}


def coloured_plate():
    """A plate with all that a mesh of pymeshlab can have."""
    vertices, faces = wavy_plate()
    colours = np.column_stack([vertices[:, 0], vertices[:, 1], 0 * vertices[:, 0], 0 * vertices[:, 0] + 1])
    mesh = pymeshlab.Mesh(
        vertices, faces, v_scalar_array=vertices[:, 0], v_color_matrix=colours, f_scalar_array=np.arange(len(faces), dtype=float),
        f_color_matrix=np.tile([0.0, 0.2, 0.4, 1.0], (len(faces), 1)), v_tex_coords_matrix=vertices[:, :2],
        w_tex_coords_matrix=vertices[faces.ravel(), :2],
    )
    mesh.add_vertex_custom_scalar_attribute(vertices[:, 1], "height")
    mesh.add_vertex_custom_point_attribute(vertices, "place")
    mesh.add_face_custom_scalar_attribute(np.arange(len(faces), dtype=float), "number")
    return mesh


def test_an_imprint_keeps_the_mesh_and_has_the_curve_as_edges(ringed):
    document, curve = ringed
    vertices, faces = wavy_plate()
    figures = document.apply_filter("imprint_curves")
    assert labels(document) == ["plate", "plate curve", "plate imprinted"]
    mesh = document.current_mesh()
    assert (figures["curves"], figures["projected_curves"], figures["parts"]) == (1, 0, 2)
    np.testing.assert_array_equal(document.mesh(0).vertex_matrix(), vertices)
    np.testing.assert_array_equal(document.mesh(0).face_matrix(), faces)
    np.testing.assert_array_equal(mesh.vertex_matrix()[: len(vertices)], vertices)
    on_curve = np.flatnonzero(mesh.vertex_custom_scalar_attribute_array("on_curve"))
    at = np.array([on_curve[np.linalg.norm(mesh.vertex_matrix()[on_curve] - p, axis=1).argmin()] for p in curve.points])
    np.testing.assert_allclose(mesh.vertex_matrix()[at], curve.points, atol=1e-14)
    assert {tuple(sorted((at[a], at[b]))) for a, b in curve.edges} <= edges_of(mesh)
    parents = mesh.face_custom_scalar_attribute_array("parent").astype(int)
    np.testing.assert_allclose(np.bincount(parents, weights=areas(mesh)), areas(document.mesh(0)), rtol=1e-9)


def test_what_the_mesh_has_comes_along():
    document = pymeshlab.MeshSet()
    document.add_mesh(coloured_plate(), "plate")
    document.compute_selection_by_condition_per_face(condselect="(x0 + x1 + x2) < 1.5")
    vertices, _ = wavy_plate()
    draw(document, vertices[CORNERS], closed=True, field="none")
    document.apply_filter("imprint_curves", surface_layer=0)
    mesh = document.current_mesh()
    points = mesh.vertex_matrix()
    np.testing.assert_allclose(mesh.vertex_scalar_array(), points[:, 0], atol=1e-14)
    np.testing.assert_allclose(mesh.vertex_color_matrix()[:, :2], points[:, :2], atol=2 / 255)
    np.testing.assert_allclose(mesh.vertex_tex_coord_matrix(), points[:, :2], atol=1e-6)
    np.testing.assert_allclose(mesh.wedge_tex_coord_matrix(), points[mesh.face_matrix().ravel(), :2], atol=1e-6)
    np.testing.assert_allclose(mesh.vertex_custom_scalar_attribute_array("height"), points[:, 1], atol=1e-14)
    np.testing.assert_allclose(mesh.vertex_custom_point_attribute_matrix("place"), points, atol=1e-14)
    parents = mesh.face_custom_scalar_attribute_array("parent")
    np.testing.assert_array_equal(mesh.face_custom_scalar_attribute_array("number"), parents)
    np.testing.assert_array_equal(mesh.face_scalar_array(), parents)
    assert (mesh.face_color_matrix() == document.mesh(0).face_color_matrix()[0]).all()
    selected = document.mesh(0).face_selection_array()
    np.testing.assert_array_equal(mesh.face_selection_array(), selected[parents.astype(int)])
    assert 0 < selected.sum() < len(selected)


def test_parts_add_up_and_are_layers_of_their_own(ringed):
    document, _ = ringed
    figures = document.apply_filter("cut_along_curves", split=True)
    assert labels(document)[2:] == ["plate part 0", "plate part 1"]
    parts = [areas(document.mesh(i)).sum() for i in (2, 3)]
    np.testing.assert_allclose(parts, figures["part_areas"], rtol=1e-12)
    assert sum(parts) == pytest.approx(areas(document.mesh(0)).sum(), rel=1e-12)
    assert document.current_mesh().label() == "plate part 0"


def test_each_part_is_closed(ringed):
    document, _ = ringed
    figures = document.apply_filter("cut_along_curves", split=True, fill="smooth")
    assert figures["filled_holes"] == 2 and labels(document)[2:] == ["plate part 0", "plate part 1"]
    outer, inner = (document.mesh(i) for i in (2, 3))
    assert areas(inner).sum() > figures["part_areas"][1] and areas(outer).sum() > figures["part_areas"][0]


@pytest.mark.parametrize("keep, part", [("largest", 0), ("smallest", 1), ("inside", 1), ("seed", 1)])
def test_a_part_is_kept(ringed, keep, part):
    document, _ = ringed
    middle = as_text([wavy_plate()[0][20 * 41 + 20]])
    figures = document.apply_filter("cut_along_curves", keep=keep, **({"seed": middle} if keep == "seed" else {}))
    assert document.current_mesh().label() == "plate part"
    assert areas(document.current_mesh()).sum() == pytest.approx(figures["part_areas"][part], rel=1e-12)


@pytest.mark.parametrize("fill", ["flat", "smooth"])
def test_a_hole_is_filled(ringed, fill):
    document, _ = ringed
    figures = document.apply_filter("cut_along_curves", keep="largest", fill=fill)
    mesh = document.current_mesh()
    assert figures["filled_holes"] == 1
    assert document.get_topological_measures()["number_holes"] == 1  # the plate's own rim
    parents = mesh.face_custom_scalar_attribute_array("parent")
    assert (parents == -1).any() and np.isfinite(mesh.vertex_matrix()).all()


@pytest.mark.parametrize("words, share", [({"thickness": 0.02}, 0.02), ({"base": 0.1, "base_direction": "0 0 -1"}, 0.1)])
def test_a_part_becomes_a_solid(ringed, words, share):
    document, _ = ringed
    figures = document.apply_filter("cut_along_curves", keep="inside", **words)
    assert document.current_mesh().label() == "plate part"
    measured = document.get_topological_measures()
    assert measured["boundary_edges"] == 0 and measured["is_mesh_two_manifold"]
    assert document.get_geometric_measures()["mesh_volume"] > 0.9 * share * figures["part_areas"][1]


@pytest.mark.parametrize("profile", ["step", "ramp", "round"])
def test_curves_are_slots(ringed, profile):
    document, _ = ringed
    document.apply_filter("cut_along_curves", stroke=0.04, relief=-0.01, profile=profile)
    assert document.current_mesh().label() == "plate relief"
    assert document.get_topological_measures()["number_holes"] == 1  # the plate's own rim


def test_a_part_becomes_a_relief(ringed):
    document, _ = ringed
    figures = document.apply_filter("cut_along_curves", keep="inside", relief=0.05)
    assert document.current_mesh().label() == "plate relief"
    walls = document.current_mesh().face_custom_scalar_attribute_array("parent") == -1
    raised = document.current_mesh().vertex_matrix()[np.unique(document.current_mesh().face_matrix()[walls])]
    assert len(np.unique(raised, axis=0)) == len(raised)  # the walls have a top beside their foot
    assert areas(document.current_mesh())[walls].sum() == pytest.approx(0.05 * figures["part_perimeters"][1], rel=0.03)


def test_an_open_curve_is_a_slit(plate, plate_picks):
    draw(plate, plate_picks)
    plate.set_current_mesh(0)
    figures = plate.apply_filter("cut_along_curves")
    assert plate.current_mesh().label() == "plate cut"
    assert figures["parts"] == 1 and figures["doubled_vertices"] > 100


def test_segments_are_labelled_coloured_and_measured(ringed):
    document, curve = ringed
    figures = document.apply_filter("segment_by_curves")
    mesh = document.current_mesh()
    assert mesh.label() == "plate segmented"
    part = mesh.face_scalar_array().astype(int)
    np.testing.assert_allclose(np.bincount(part, weights=areas(mesh)), figures["part_areas"])
    np.testing.assert_array_equal(np.bincount(part), figures["part_faces"])
    assert figures["part_perimeters"][1] == pytest.approx(curve.length())
    centroid = figures["part_centroids"].reshape(-1, 3)[1]
    np.testing.assert_allclose(centroid[:2], [0.5, 0.5], atol=0.01)
    assert figures["part_eulers"].tolist() == [0, 1]
    colours = {label: mesh.face_color_matrix()[part == label] for label in (0, 1)}
    assert all((c == c[0]).all() for c in colours.values()) and (colours[0][0] != colours[1][0]).any()
    document.set_current_mesh(0)
    document.apply_filter("segment_by_curves", split=True)
    assert labels(document)[3:] == ["plate part 0", "plate part 1"]


def test_an_offset_is_a_curve_at_the_distance_and_is_used_again(ringed):
    document, curve = ringed
    vertices, faces = wavy_plate()
    figures = document.apply_filter("offset_curve_on_surface", offset=pymeshlab.PureValue(0.05), side="left", select_band=True)
    assert labels(document)[2:] == ["plate curve offset"] and figures["pieces"] == 1
    offset = CurveLayer(document.current_mesh())
    assert_strictly_on(offset, vertices, faces)
    assert offset.is_closed() and figures["length"] == pytest.approx(offset.length())
    away = np.linalg.norm(offset.points[:, None] - curve.points, axis=2).min(1)
    assert 0.045 < away.min() and away.max() < 0.0505
    band = document.mesh(0).face_selection_array()
    middles = vertices[faces].mean(1)
    far = np.linalg.norm(middles[:, None] - curve.points, axis=2).min(1)
    assert band.any() and far[band].max() < 0.0505
    figures = document.apply_filter("segment_by_curves", surface_layer=0, curve_layer=2)
    assert (figures["curves"], figures["projected_curves"], figures["parts"]) == (1, 0, 2)


def test_offsets_are_no_input_of_a_second_offset(ringed):
    document, curve = ringed
    for count in (1, 2):
        document.set_current_mesh(0)
        figures = document.apply_filter("offset_curve_on_surface", offset=pymeshlab.PureValue(0.03))
        assert (figures["curves"], figures["pieces"]) == (1, 2)
        assert len(labels(document)) == 2 + 2 * count
    # Not where they are visible beside curves, but where they are chosen, or alone.
    document.set_current_mesh(0)
    assert document.apply_filter("segment_by_curves")["parts"] == 2
    figures = document.apply_filter("segment_by_curves", surface_layer=0, curve_layer=2)
    assert (figures["curves"], figures["parts"]) == (1, 2) and figures["part_perimeters"][1] != pytest.approx(curve.length())
    for layer in (1, 4, 5):
        document.set_mesh_visibility(layer, False)
    figures = document.apply_filter("segment_by_curves")
    assert (figures["curves"], figures["parts"]) == (2, 3)


def test_curves_of_other_surfaces_are_left_out(ringed):
    document, _ = ringed
    vertices, faces = wavy_plate()
    document.add_mesh(pymeshlab.Mesh(vertices + [0, 0, 1e-3], faces), "other")
    draw(document, vertices[[12 * 41 + 12, 12 * 41 + 28, 28 * 41 + 28]], surface_layer=2)
    for surface, drawn in ((0, 1), (2, 3)):
        chosen = document.apply_filter("imprint_curves", surface_layer=surface, curve_layer=drawn)
        usual = document.apply_filter("imprint_curves", surface_layer=surface, curve_layer=surface)
        assert (usual["curves"], usual["projected_curves"], usual["faces"]) == (1, 0, chosen["faces"])
    # Where a surface has none of its own, those of others are meant that are near; and one that is chosen always.
    document.add_mesh(pymeshlab.Mesh(vertices, faces), "third")
    assert document.apply_filter("imprint_curves", surface_layer=document.current_mesh_id())["curves"] == 2
    assert document.apply_filter("imprint_curves", surface_layer=0, curve_layer=3)["projected_curves"] == 1


def test_the_tube_of_a_curve_is_no_surface(plate):
    vertices, _ = wavy_plate()
    draw(plate, vertices[CORNERS], closed=True, tube_radius=pymeshlab.PureValue(0.01))
    assert labels(plate) == ["plate", "plate curve", "plate tube"]
    plate.set_current_mesh(2)
    figures = plate.apply_filter("cut_along_curves", keep="inside")
    assert labels(plate)[3:] == ["plate part"] and figures["projected_curves"] == 0
    plate.set_current_mesh(2)
    draw(plate, vertices[CORNERS[:2]])
    assert labels(plate)[4].startswith("plate curve")  # no "plate tube curve"
    # Where it is named, it is meant.
    figures = plate.apply_filter("imprint_curves", surface_layer=2, curve_layer=1)
    assert plate.current_mesh().label() == "plate tube imprinted" and figures["projected_curves"] == 1


def test_polylines_from_elsewhere_are_projected(plate):
    t = np.linspace(0, 2 * np.pi, 50, endpoint=False)
    circle = np.column_stack([0.5 + 0.3 * np.cos(t), 0.5 + 0.3 * np.sin(t), 0 * t])
    circle[:, 2] = 0.05 * np.sin(5 * circle[:, 0]) * np.cos(4 * circle[:, 1]) + 0.004
    edges = np.column_stack([np.arange(50), (np.arange(50) + 1) % 50])
    plate.add_mesh(pymeshlab.Mesh(circle, edge_matrix=edges), "circle")
    plate.set_current_mesh(0)
    figures = plate.apply_filter("segment_by_curves", curve_layer=1)
    assert (figures["projected_curves"], figures["parts"]) == (1, 2)
    assert figures["part_perimeters"][1] == pytest.approx(0.6 * np.pi, rel=0.03)
    assert_refuses(
        plate, 'layer "circle" is not near layer "plate": vertex .* away from the mesh, and 0.001 at most is allowed',
        "imprint_curves", surface_layer=0, curve_layer=1, max_distance=pymeshlab.PureValue(0.001),
    )


def test_a_mesh_that_changed_is_refused_unless_curves_are_projected(ringed):
    document, _ = ringed
    document.apply_coord_laplacian_smoothing(stepsmoothnum=1)
    changed = 'layer "plate curve" was drawn on layer "plate", whose mesh changed since the curve was drawn'
    for name in ("imprint_curves", "cut_along_curves", "segment_by_curves", "offset_curve_on_surface"):
        assert_refuses(document, changed, name, surface_layer=0)
    figures = document.apply_filter("imprint_curves", surface_layer=0, project_curves=True)
    assert figures["projected_curves"] == 1


def test_layers_that_moved_together_are_exact(ringed):
    document, curve = ringed
    matrix = np.array([[0.0, -2, 0, 5], [2, 0, 0, 1], [0, 0, 2, -3], [0, 0, 0, 1]])
    for i in (0, 1):
        document.set_current_mesh(i)
        document.set_matrix(transformmatrix=matrix, freeze=False)
    figures = document.apply_filter("cut_along_curves", surface_layer=0, keep="inside")
    assert figures["projected_curves"] == 0
    mesh = document.current_mesh()
    np.testing.assert_array_equal(mesh.transform_matrix(), matrix)
    low, high = mesh.vertex_matrix().min(0), mesh.vertex_matrix().max(0)
    np.testing.assert_allclose([low[:2], high[:2]], [curve.points.min(0)[:2], curve.points.max(0)[:2]], atol=1e-9)
    assert figures["part_areas"][1] == pytest.approx(4 * areas(mesh).sum())


@pytest.mark.parametrize("name, parameters, message", [
    ("imprint_curves", {"curve_layer": 2}, 'curve_layer: layer "other" is no polyline: it has faces'),
    ("imprint_curves", {"curve_layer": 9}, "curve_layer: there is no layer 9"),
    ("cut_along_curves", {"keep": "seed", "seed": "0 0 9"}, "the seed .* away from the mesh"),
    ("cut_along_curves", {"keep": "seed"}, 'keep is "seed", but there is no point'),
    ("cut_along_curves", {"fill": "flat"}, "the option fill needs the option keep"),
    ("offset_curve_on_surface", {"offset": pymeshlab.PureValue(4)}, 'layer "plate curve": no point of the surface'),
    ("imprint_curves", {"snap": 0.5}, "snap is 0.5, but must be in"),
])
def test_what_cannot_be_is_refused_by_name(ringed, name, parameters, message):
    document, _ = ringed
    document.add_mesh(pymeshlab.Mesh(*wavy_plate(4)), "other")
    document.set_current_mesh(0)
    assert_refuses(document, message, name, surface_layer=0, **parameters)


def test_a_seed_on_a_curve_and_curves_that_open_nothing_are_refused(ringed):
    document, curve = ringed
    assert_refuses(document, "lies on a curve", "cut_along_curves", keep="seed", seed=as_text(curve.points[7:8]))
    other = pymeshlab.MeshSet()
    other.add_mesh(pymeshlab.Mesh(*wavy_plate()), "plate")
    assert_refuses(other, "there is no visible layer of polylines", "imprint_curves")
    rim = wavy_plate()[0][:20]
    other.add_mesh(pymeshlab.Mesh(rim, edge_matrix=np.column_stack([np.arange(19), np.arange(1, 20)])), "rim")
    assert_refuses(other, "there is nothing to cut", "cut_along_curves", surface_layer=0)
    assert_refuses(other, "the curves part nothing", "segment_by_curves", surface_layer=0)
