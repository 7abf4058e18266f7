# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as edges of a mesh, and drawings as curves, in arrays."""
import re
import warnings

import made_meshes as meshes
import numpy as np
import pytest
import trimesh

import bspline_curve
from bspline_curve import Cut, FileError, InputError, Mesh, MeshWarning, OptionError


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


def test_values_of_either_side_of_a_seam_stay_there():
    vertices, faces, heights = meshes.halved_plate()
    with pytest.warns(MeshWarning, match="joined"):
        halves = Mesh(vertices, faces)
    ring = halves.curve([[0.3, 0.3, 0], [0.7, 0.35, 0], [0.7, 0.7, 0], [0.3, 0.65, 0]], closed=True)
    imprint = halves.imprint([ring])
    assert len(imprint.parts) == 2
    np.testing.assert_array_equal(imprint.vertices[: len(vertices)], vertices)
    values = imprint.values(np.column_stack([vertices, heights]), faces)
    np.testing.assert_allclose(values[:, :3], imprint.vertices, atol=1e-14)
    is_right = vertices[faces].mean(1)[imprint.parents, 0] > 0.5
    expected = imprint.vertices[imprint.faces] @ [1.0, 2.0, 0.0] + 10.0 * is_right[:, None]
    np.testing.assert_allclose(values[imprint.faces, 3], expected, atol=1e-12)
    cut = imprint.cut()
    np.testing.assert_array_equal(cut.origins[cut.faces], imprint.faces)
    np.testing.assert_array_equal(cut.vertices, imprint.vertices[cut.origins])
    relief = imprint.relief(0.1)
    np.testing.assert_array_equal(relief.origins[relief.faces[: len(imprint.faces)]], imprint.faces)


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
        mesh.imprint([crossing[0], bspline_curve.Mesh(arrays[0] * 1.01, arrays[1]).curve(1.01 * arrays[0][[45, 700]])])
    with pytest.raises(bspline_curve.OptionError, match="snap is 0.5"):
        mesh.imprint(crossing, snap=0.5)


@pytest.fixture(scope="module")
def ring(mesh, arrays):
    return mesh.curve(arrays[0][[500, 530, 1250, 1200]], closed=True)


def boundary_edges(faces):
    """How many edges have one face only, or more than two."""
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    counts = np.unique(sides, axis=0, return_counts=True)[1]
    return (counts == 1).sum(), (counts > 2).sum()


def test_parts_are_taken_by_size_and_by_a_point(mesh, ring):
    imprint = mesh.segment([ring])
    outer, inner = imprint.parts
    whole = mesh.cut([ring])
    inside = mesh.project([ring.points.mean(axis=0)]).points[0]
    assert len(whole.vertices) == len(imprint.vertices) + len(imprint.curves[0])
    np.testing.assert_array_equal(whole.labels, imprint.labels)
    for keep, part in [("largest", outer), ("smallest", inner), ("inside", inner), (inside, inner)]:
        taken = mesh.cut([ring], keep=keep)
        assert len(taken.faces) == len(part.faces)
        assert areas(taken.vertices, taken.faces).sum() == pytest.approx(part.area)
        np.testing.assert_array_equal(taken.vertices, imprint.vertices[taken.origins])
        assert set(taken.labels) == {int(part is inner)}


def test_holes_are_filled(mesh, ring):
    open_ = mesh.cut([ring], keep="largest")
    flat, smooth = (mesh.cut([ring], keep="largest", fill=fill) for fill in ("flat", "smooth"))
    edge = boundary_edges(mesh.faces)[0]
    assert boundary_edges(open_.faces) == (edge + len(mesh.imprint([ring]).curves[0]), 0)
    for filled in (flat, smooth):
        assert boundary_edges(filled.faces) == (edge, 0)
        assert (filled.labels == -1).sum() == len(filled.faces) - len(open_.faces)
    assert len(flat.vertices) == len(open_.vertices) < len(smooth.vertices)
    assert (smooth.origins == -1).sum() == len(smooth.vertices) - len(open_.vertices)
    areas_of = [areas(filled.vertices, filled.faces).sum() for filled in (flat, smooth)]
    assert areas_of[0] < areas_of[1] < 1.2 * areas(mesh.vertices, mesh.faces).sum()


@pytest.mark.parametrize("part", ["inside", None])
def test_a_part_is_moved_along_its_normals(mesh, ring, part):
    imprint = mesh.imprint([ring])
    inner = imprint.parts[1]
    part = part or imprint.vertices[imprint.faces[inner.faces[0]]].mean(0)
    relief = imprint.relief(0.01, part)
    kept = len(imprint.faces)
    assert boundary_edges(relief.faces) == boundary_edges(imprint.faces)
    moved = np.linalg.norm(relief.vertices[relief.faces[:kept]] - imprint.vertices[imprint.faces], axis=2)
    is_moved = np.repeat(imprint.labels[:, None] == 1, 3, axis=1)
    np.testing.assert_allclose(moved[is_moved], 0.01, rtol=0.01)  # faces come to lie at the height, not their vertices
    assert (moved[~is_moved] == 0).all()
    assert (relief.labels[kept:] == -1).all() and len(relief.faces) == kept + 2 * len(imprint.curves[0])
    np.testing.assert_array_equal(relief.origins[: len(imprint.vertices)], np.arange(len(imprint.vertices)))


def volume(cut):
    a, b, c = (cut.vertices[cut.faces[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def test_parts_become_solids(mesh, ring):
    imprint = mesh.imprint([ring])
    inner = imprint.parts[1]
    wall = imprint.thicken(0.01)
    assert max(boundary_edges(wall.faces)) == 0 and volume(wall) == pytest.approx(0.01 * inner.area, rel=0.05)
    np.testing.assert_array_equal(wall.faces[: len(inner.faces)].shape, imprint.faces[inner.faces].shape)
    np.testing.assert_array_equal(wall.origins[wall.faces[: len(inner.faces)]], imprint.faces[inner.faces])
    assert (wall.labels[: len(inner.faces)] == 1).all() and (wall.labels[len(inner.faces) :] == -1).all()
    normal = np.cross(*(imprint.vertices[imprint.faces[inner.faces][:, k]] - imprint.vertices[imprint.faces[inner.faces][:, 0]]
                        for k in (1, 2))).sum(axis=0)
    die, same = imprint.add_base(0.2), imprint.add_base(0.2, direction=-normal)
    assert max(boundary_edges(die.faces)) == 0 and volume(die) > 0.2 * 0.5 * np.linalg.norm(normal)
    np.testing.assert_allclose(same.vertices, die.vertices, atol=1e-9)
    height = (die.vertices @ -normal).max() / np.linalg.norm(normal)
    np.testing.assert_allclose(imprint.add_base(direction=-normal, height=height).vertices, die.vertices, atol=1e-9)
    with pytest.warns(MeshWarning, match=r"thinner than asked at \d+ vertices"):
        imprint.thicken(-1.5, progress=lambda share, stage: True)
    with pytest.raises(OptionError, match="thickness is 0"):
        imprint.thicken(0)
    with pytest.raises(OptionError, match="one of length and height"):
        imprint.add_base()
    with pytest.raises(OptionError, match="height needs direction"):
        imprint.add_base(height=1.0)
    with pytest.raises(InputError, match="beyond the plane"):
        imprint.add_base(direction=-normal, height=-1e3)


@pytest.mark.parametrize("profile, share", [("step", 1.0), ("ramp", 0.5), ("round", np.pi / 4)])
def test_slots_follow_curves_with_a_profile(mesh, ring, profile, share):
    strokes = mesh.imprint([ring], stroke=0.04)
    assert len(strokes.parts) == 3
    slot = strokes.relief(-0.01, profile=profile)
    assert boundary_edges(slot.faces) == boundary_edges(strokes.faces)
    sunk = volume(Cut(strokes.vertices, strokes.faces, None, None)) - volume(slot)
    assert sunk == pytest.approx(share * 0.01 * 0.04 * ring.length, rel=0.06)
    known = slot.origins >= 0
    still = np.linalg.norm(slot.vertices[known] - strokes.vertices[slot.origins[known]], axis=1)
    assert (still <= 0.01 * 1.01).all() and (still == 0).sum() > len(mesh.vertices) / 2
    assert known.all() == (profile == "step")
    with pytest.raises(OptionError, match="profile is 'sharp'"):
        strokes.relief(-0.01, profile="sharp")
    with pytest.raises(OptionError, match="stroke is -1"):
        mesh.imprint([ring], stroke=-1)


def test_holes_of_a_mesh_are_closed():
    vertices, faces = meshes.plate(cells=24)
    middle = vertices[faces].mean(axis=1) - vertices.mean(axis=0)
    pierced = faces[np.hypot(middle[:, 0], middle[:, 1]) > 0.2 * np.ptp(vertices[:, 0])]
    mesh = Mesh(vertices, pierced)
    with pytest.warns(MeshWarning, match="1 hole stays open"):
        closed = mesh.fill_holes("flat", seed=vertices.mean(axis=0))
    assert (closed.labels == np.r_[np.zeros(len(pierced)), np.full(len(closed.faces) - len(pierced), -1)]).all()
    assert areas(closed.vertices, closed.faces).sum() == pytest.approx(areas(vertices, faces).sum())
    with pytest.warns(MeshWarning):
        smooth = mesh.fill_holes(max_edges=90, progress=lambda share, stage: True)
    assert len(smooth.vertices) > len(mesh.vertices) and (smooth.origins[len(mesh.vertices) :] == -1).all()
    with pytest.raises(InputError, match="none of 2 holes"):
        mesh.fill_holes(max_length=1e-3)
    with pytest.raises(OptionError, match="max_edges"):
        mesh.fill_holes(max_edges=2)
    with pytest.raises(OptionError, match="shape"):
        mesh.fill_holes("round")
    with pytest.raises(InputError, match="seed"):
        mesh.fill_holes(seed=[1, 2])


def test_curves_that_part_the_mesh_are_not_warned_of(mesh, arrays, ring):
    low, high = arrays[0].min(axis=0), arrays[0].max(axis=0)
    ends = [arrays[0][np.abs(arrays[0][:, :2] - end).sum(axis=1).argmin()] for end in (low[:2], high[:2])]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(mesh.segment([mesh.curve(ends)]).parts) == 2  # from boundary to boundary
        mesh.cut([mesh.curve(ends)])
        mesh.cut([ring])


def test_a_relief_says_where_it_cannot_be(mesh, ring):
    imprint = mesh.imprint([ring])
    with pytest.warns(bspline_curve.MeshWarning) as noted:
        imprint.relief(-50.0)
    crossing, lower = (str(note.message) for note in noted)
    assert re.search(r"lower than asked at \d+ vertices", lower) and re.search(r"^\d+ faces cross others: ", crossing)
    with pytest.raises(bspline_curve.OptionError, match="height is nan"):
        imprint.relief(float("nan"))
    with pytest.raises(bspline_curve.OptionError, match="part is 'middle'"):
        imprint.relief(1.0, "middle")


def test_an_open_curve_parts_nothing(mesh, arrays, ring):
    slit = mesh.curve(arrays[0][[500, 900]])
    imprint = mesh.imprint([slit])
    edges = len(imprint.curves[0]) - 1
    for cut in (imprint.cut, lambda: mesh.cut([slit])):
        with pytest.warns(bspline_curve.MeshWarning, match=rf"^the curve parts nothing: .*\({edges} edges\)") as noted:
            assert len(cut().vertices) > len(imprint.vertices)
        assert [note.filename for note in noted] == [__file__]
    beside = mesh.curve(arrays[0][[1603, 1628]])
    for use in (mesh.segment, lambda curves: mesh.cut(curves, keep="inside")):
        with pytest.warns(bspline_curve.MeshWarning, match="^1 of 2 curves parts nothing; draw a closed curve"):
            use([beside, ring])
    for refused in (lambda: mesh.segment([slit]), lambda: mesh.cut([slit], keep="inside")):
        with pytest.raises(bspline_curve.InputError, match="part nothing"):
            refused()
    with pytest.raises(bspline_curve.InputError, match="nothing to cut"):
        mesh.cut([])
    with pytest.raises(bspline_curve.OptionError, match="keep is 'best'"):
        mesh.cut([ring], keep="best")
    with pytest.raises(bspline_curve.OptionError, match="needs keep"):
        mesh.cut([ring], fill="flat")
    with pytest.raises(bspline_curve.OptionError, match="fill is 'round'"):
        mesh.cut([ring], keep="inside", fill="round")
    with pytest.raises(bspline_curve.InputError, match="keep has shape"):
        mesh.cut([ring], keep=[0.0, 1.0])


def test_offsets_keep_their_distance(wavy):
    flat = bspline_curve.Mesh(*wavy(41, height=0))
    line = flat.curve([[-0.6, 0.01, 0], [0.6, 0.01, 0]])
    (around,) = line.offset(0.2)
    assert around.closed and around.usable and around.degree == 3 and len(around.picks) == 0
    assert around.length == pytest.approx(2 * 1.2 + 2 * np.pi * 0.2, rel=2e-3)
    beyond = np.maximum(np.abs(around.points[:, 0]) - 0.6, 0.0)
    np.testing.assert_allclose(np.hypot(beyond, around.points[:, 1] - 0.01), 0.2, atol=1e-3)
    off = np.abs(np.hypot(beyond, around.points[:, 1] - 0.01) / 0.2 - 1).max()
    assert off - 1e-12 < around.report["deviation"] < 1e-3
    assert len(around.control_points) < len(around) / 10
    sides = [line.offset(0.2, side=side)[0] for side in ("left", "right")]
    assert [np.sign(piece.points[len(piece) // 2, 1]) for piece in sides] == [1, -1]
    near = line.faces_within(0.2)
    assert near.dtype == bool and near.shape == (len(flat.faces),)
    assert areas(flat.vertices, flat.faces)[near].sum() == pytest.approx(1.2 * 0.4 + np.pi * 0.04, rel=0.03)
    left, right = (line.faces_within(0.2, side) for side in ("left", "right"))
    assert left.any() and right.any() and not (left & right).any() and not ((left | right) & ~near).any()
    assert line.offset(5.0) == []
    assert len(flat.imprint([line, around]).parts) == 2
    with pytest.raises(bspline_curve.PickError, match="no picks"):
        around.move(0, [0, 0, 0])
    with pytest.raises(bspline_curve.OptionError, match="distance is -1"):
        line.offset(-1)
    with pytest.raises(bspline_curve.OptionError, match="side is 'up'"):
        line.offset(0.1, side="up")


def test_the_mesh_is_taken_apart(mesh, arrays):
    ring = mesh.curve(arrays[0][[500, 530, 1250, 1200]], closed=True)
    imprint = mesh.imprint([ring])
    parts = imprint.split()
    assert [len(part.faces) for part in parts] == [len(part.faces) for part in imprint.parts]
    with pytest.raises(bspline_curve.OptionError, match="fill"):
        imprint.split("round")
    ball = trimesh.creation.icosphere(3)
    angles = 2 * np.pi * (np.arange(41) % 40) / 40
    imprint = bspline_curve.Mesh(ball.vertices, ball.faces).imprint([np.stack([np.cos(angles), np.sin(angles), 0 * angles], 1)])
    closed = imprint.split("flat")
    assert [int((part.labels == -1).sum()) for part in closed] == 2 * [len(imprint.curves[0]) - 2]
    assert sum(trimesh.Trimesh(part.vertices, part.faces).volume for part in closed) == pytest.approx(ball.volume, rel=1e-12)
    caps = [{frozenset(map(tuple, part.vertices[face])) for face in part.faces[part.labels == -1]} for part in closed]
    assert caps[0] == caps[1]


def test_long_work_tells_of_its_progress_and_can_be_cancelled(wavy):
    fine = bspline_curve.Mesh(*wavy(200))
    ring = fine.curve(fine.vertices[[200 * 50 + 50, 200 * 50 + 150, 200 * 150 + 150, 200 * 150 + 50]], closed=True)
    imprint = fine.imprint([ring])
    works = [
        ("measuring distances", lambda progress: ring.offset(0.08, progress=progress)),
        ("measuring distances", lambda progress: ring.faces_within(0.15, "left", progress=progress)),
        (" a patch", lambda progress: imprint.cut("largest", "smooth", progress)),
        (" a patch", lambda progress: imprint.split("smooth", progress)),
        (" a patch", lambda progress: fine.fill_holes("flat", progress=progress)),
        (" a patch", lambda progress: fine.cut([ring], "largest", "smooth", progress=progress)),
    ]
    for stage, work in works:
        told = []
        assert len(work(lambda fraction, name, told=told: told.append((fraction, name)))) > 0
        assert any(stage in name for _, name in told)
        assert [fraction for fraction, _ in told] == sorted(fraction for fraction, _ in told)
        with pytest.raises(bspline_curve.Cancelled):
            work(lambda *_: False)


@pytest.fixture
def broken(arrays):
    """A flap on an inner edge, first among the faces; a fin at a vertex; a face twice, and one turned over."""
    vertices, faces = arrays
    n = len(vertices)
    tips = vertices[[faces[700][0], faces[0][0], faces[0][0]]] + [[0, 0, 0.5], [-1, 0, 0], [-1, -1, 0]]
    more = [[faces[700][1], faces[700][0], n], *faces, [faces[0][0], n + 1, n + 2], faces[9]]
    changed = np.array(more, np.int32)
    changed[40] = changed[40][::-1]
    return np.r_[vertices, tips], changed


def test_what_is_made_of_a_mended_mesh_has_the_ids_of_the_given_one(arrays, broken):
    vertices, faces = broken
    with pytest.warns(bspline_curve.MeshWarning, match="edge cut"):
        mended = bspline_curve.Mesh(vertices, faces)
    ring = mended.curve(arrays[0][[500, 530, 1250, 1200]], closed=True)
    imprint = mended.imprint([ring])
    np.testing.assert_array_equal(imprint.vertices[: len(vertices)], vertices)
    children = np.bincount(imprint.parents, weights=areas(imprint.vertices, imprint.faces), minlength=len(faces))
    np.testing.assert_allclose(children[:-1], areas(vertices, faces)[:-1], rtol=1e-9)
    assert children[-1] == 0, "the second of two equal faces is left out"
    np.testing.assert_allclose(imprint.values(vertices, mended.faces), imprint.vertices, atol=1e-14)
    assert len(mended.cut([ring], keep="inside", fill="smooth").faces) > 0
    assert len(mended.segment([ring]).parts) == mended.components + 1
    with pytest.raises(bspline_curve.InputError, match="part nothing"):
        mended.segment([mended.curve(arrays[0][[500, 530]])])
    (inner, *others) = ring.offset(0.05, side="left")
    drawn = mended.pattern([[[0, 0], [1, 0], [1, 1], [0, 0]]], along=ring, size=0.1).curves
    for curve in (inner, *others, *drawn):
        given = (vertices[faces[curve.faces]] * curve.barycentrics[..., None]).sum(1)
        np.testing.assert_allclose(given, curve.points, atol=1e-14)
    assert len(mended.imprint([ring, inner, *drawn]).curves) == 2 + len(drawn)
    near = ring.faces_within(0.05, side="left")
    middles = vertices[faces].mean(1)
    gaps = np.linalg.norm(middles[near][:, None] - ring.points[None], axis=2).min(axis=1)
    assert near.shape == (len(faces),) and near.sum() > 50 and gaps.max() < 0.06


def test_a_curve_from_sheet_to_sheet_is_imprinted_but_has_no_offset(arrays, broken):
    vertices, faces = broken
    with pytest.warns(bspline_curve.MeshWarning):
        mended = bspline_curve.Mesh(vertices, faces)
    flap = vertices[faces[0]].mean(axis=0)
    curve = mended.curve([flap, vertices[faces[720][0]]])
    assert curve.usable
    imprint = mended.imprint([curve])
    np.testing.assert_array_equal(imprint.vertices[: len(vertices)], vertices)
    gaps = np.linalg.norm(imprint.vertices[imprint.curves[0]][None] - curve.points[:, None], axis=2)
    assert gaps.min(axis=1).max() < 1e-12
    np.testing.assert_allclose(imprint.values(vertices, faces), imprint.vertices, atol=1e-14)
    with pytest.raises(bspline_curve.InputError, match="the curve to offset: .* from sheet to sheet"):
        curve.offset(0.05)


# ---- drawings carried to a mesh ----


STAR = "M0 -4 L1 -1 L4 0 L1 1 L0 4 L-1 1 L-4 0 L-1 -1Z"


@pytest.fixture(scope="module")
def plate(wavy):
    return Mesh(*wavy(13, height=0, low=0))


def test_path_data_and_polylines_and_files_are_the_same_drawing(plate, tmp_path):
    (tmp_path / "star.svg").write_text(f"<svg xmlns='http://www.w3.org/2000/svg'><g><path d='{STAR}'/></g></svg>")
    corners = np.array([[0, 4], [1, 1], [4, 0], [1, -1], [0, -4], [-1, -1], [-4, 0], [-1, 1], [0, 4]], float)
    patterns = [
        plate.pattern(drawing, centre=[0.5, 0.4, 0], size=0.4) for drawing in (STAR, [corners], tmp_path / "star.svg")
    ]
    for pattern in patterns:
        assert len(pattern.curves) == 8
        assert pattern.paths.tolist() == pattern.copies.tolist() == [0] * 8
        for a, b, curve in zip(corners, corners[1:], pattern.curves):
            ends = [0.5, 0.4] + 0.05 * np.array([a, b])
            np.testing.assert_allclose(curve.points[[0, -1], :2], ends, atol=1e-9)
    assert patterns[0].shortest.ratio == pytest.approx(1, abs=1e-6)
    assert patterns[0].longest.position.shape == (3,)


def test_along_a_curve(plate):
    line = plate.curve([[0.1, 0.5, 0], [0.9, 0.5, 0]])
    pattern = plate.pattern([[[0, 0], [1, 0], [0.5, 1], [0, 0]]], along=line, repeat=4, size=0.1, shift=0.2)
    assert pattern.copies.tolist() == [0] * 3 + [1] * 3 + [2] * 3 + [3] * 3
    starts = np.array([curve.points[0] for curve in pattern.curves[::3]])
    np.testing.assert_allclose(starts[:, 0], np.linspace(0.1, 0.8, 4), atol=1e-6)
    np.testing.assert_allclose(starts[:, 1], 0.65, atol=1e-6)  # its middle is 0.2 to the left


def test_its_curves_are_curves_of_the_mesh(plate):
    pattern = plate.pattern(STAR, centre=[0.5, 0.5, 0], size=0.4)
    assert len(plate.segment(pattern.curves).parts) == 2
    assert all(curve.usable for curve in pattern.curves)


def test_refusals(plate, tmp_path):
    other = Mesh(plate.vertices * 1.01, plate.faces)
    line = other.curve([[0.1, 0.5, 0], [0.9, 0.5, 0]])
    (tmp_path / "bad.svg").write_text("<svg><path d='M0 0L1'/></svg>")
    (tmp_path / "worse.svg").write_text("<svg>")
    centre = [0.5, 0.5, 0]
    for error, said, arguments in [
        (InputError, "centre and along", {}),
        (InputError, "centre and along", {"centre": centre, "along": line}),
        (InputError, "another mesh", {"along": line}),
        (InputError, "centre must be", {"centre": [0, 0]}),
        (InputError, "away from the mesh", {"centre": [0, 0, 5]}),
        (InputError, "path 0", {"centre": centre, "size": 3}),
        (OptionError, "size", {"centre": centre, "size": -1}),
        (OptionError, "exclude", {"centre": centre, "size": 1, "scale": 1}),
        (OptionError, "corner_angle", {"centre": centre, "corner_angle": 0}),
        (OptionError, "path data", {"drawing": "M0 0X", "centre": centre}),
        (InputError, r"drawing\[0\]", {"drawing": [[1, 2]], "centre": centre}),
        (FileError, "read from .svg", {"drawing": "x.png", "centre": centre}),
        (FileError, "no.svg", {"drawing": tmp_path / "no.svg", "centre": centre}),
        (FileError, "line 1: <path>", {"drawing": tmp_path / "bad.svg", "centre": centre}),
        (FileError, "not XML", {"drawing": tmp_path / "worse.svg", "centre": centre}),
    ]:
        with pytest.raises(error, match=said):
            plate.pattern(**{"drawing": STAR, **arguments})


def test_layers_of_a_dxf_are_chosen(plate, tmp_path):
    lines = ["0 SECTION", "2 ENTITIES"]
    for layer, radius in [("inner", 0.1), ("outer", 0.3)]:
        lines += ["0 CIRCLE", f"8 {layer}", "10 0.5", "20 0.5", f"40 {radius}"]
    drawing = tmp_path / "a.dxf"
    drawing.write_text("\n".join(line.replace(" ", "\n") for line in lines + ["0 ENDSEC", "0 EOF"]) + "\n")
    at = {"centre": [0.5, 0.5, 0], "scale": 1.0}
    assert len(plate.pattern(drawing, **at).curves) == 2
    (circle,) = plate.pattern(drawing, layers=["outer"], **at).curves
    assert circle.length == pytest.approx(2 * np.pi * 0.3, rel=1e-3)
    with pytest.raises(FileError, match="no layer \"walls\""):
        plate.pattern(drawing, layers=["walls"], **at)
    with pytest.raises(InputError, match=r"in \.dxf alone"):
        plate.pattern(STAR, layers=["outer"], **at)
    with pytest.raises(TypeError, match="sequence of names"):
        plate.pattern(drawing, layers="outer", **at)
