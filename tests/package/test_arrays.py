# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves and fields on arrays are those of the program; what is wrong is said."""
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import BSpline

ROOT = Path(__file__).resolve().parents[2]
USE = "from meshlab_bspline_curve import *\n"
PICKS = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]])
PARTS = ("points", "faces", "barycentrics", "t", "values", "control_points", "knots", "pick_parameters", "pick_vertices")
TAKE = USE + "answer |= {name: getattr(curve, name) for name in %r}\n" % (PARTS,)


def drawn(home, arguments="", **given):
    """The parts of a curve through `picks`, and the figures that are numbers."""
    given = {"picks": PICKS} | given
    code = USE + f"curve = draw_curve(vertices, faces, picks, {arguments})\n" + TAKE + "answer |= curve.figures\n"
    return home.call(code, **given)


@pytest.mark.parametrize(
    ("arguments", "options"),
    [
        ("", []),
        ("closed=True, degree=4, samples=60, shell='simplified'", "--closed --degree 4 --samples 60 --shell simplified".split()),
        ("field='valley', field_weight=500", ["--field", "valley", "--field-weight", "500"]),
        ("field=values, field_cost='square', max_segment_length=0.01",
         ["--field", "values.npy", "--field-cost", "square", "--max-segment-length", "0.01"]),
        ("pick_tolerance='0.5 edges'", ["--pick-tolerance", "0.5edges"]),
        ("pick_tolerance=0.01", ["--pick-tolerance", "0.01"]),
        ("corners='2,3'", ["--corners", "3, 2"]),
        ("corners='all', closed=True", ["--corners", "all", "--closed"]),
        ("tangents='1: 0, 1, 0.5; 3: 1, 0, 0'", ["--tangents", "3:1,0,0;1:0,1,0.5"]),
        ("avoid=disc", ["--avoid", "disc.npy"]),
        ("quality=values, avoid='over-threshold', avoid_threshold=0.5, field='quality', field_weight=0",
         ["--field", "values.npy", "--field-weight", "0", "--avoid", "over-threshold", "--avoid-threshold", "0.5"]),
    ],
)
def test_a_curve_is_the_programs(arguments, options, home, program, bunny_path, tmp_path):
    import pymeshlab

    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    vertices, faces = document.current_mesh().vertex_matrix(), document.current_mesh().face_matrix()
    text = (ROOT / "examples" / "bunny.pp").read_text()
    picks = np.array([[float(word.split('"')[1]) for word in line.split()[1:4]] for line in text.splitlines() if "<point" in line])
    centres = vertices[faces].mean(1)
    disc = np.flatnonzero(np.linalg.norm(centres - centres[np.linalg.norm(centres - picks[1:3].mean(0), axis=1).argmin()], axis=1) < 0.03)
    values = np.linalg.norm(vertices - vertices[0], axis=1) * 0.5
    np.save(tmp_path / "values.npy", values)
    np.save(tmp_path / "disc.npy", disc)
    np.savetxt(tmp_path / "picks.xyz", picks, fmt="%.17g")
    subprocess.run([program, bunny_path, "--picks", "picks.xyz", *options, "--output", "curve.json"], cwd=tmp_path, check=True)
    expected = json.loads((tmp_path / "curve.json").read_text())
    curve = drawn(home, arguments, vertices=vertices, faces=faces, picks=picks, values=values, disc=disc)

    line, spline = expected["polyline"], expected["spline"]
    assert len(curve["points"]) == len(line["points"]) > 60
    np.testing.assert_allclose(curve["points"], line["points"], rtol=0, atol=1e-12)
    np.testing.assert_array_equal(curve["faces"], line["faces"])
    np.testing.assert_allclose(curve["barycentrics"], line["barycentrics"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(curve["control_points"], spline["control_points"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(curve["knots"], spline["knots"], rtol=0, atol=1e-12)
    on_faces = (vertices[faces[curve["faces"]]] * curve["barycentrics"][..., None]).sum(1)
    np.testing.assert_allclose(on_faces, curve["points"], rtol=0, atol=1e-12)
    reach = 0.03 if "pick_tolerance" in arguments else 2e-3  # picks are moved to the surface
    np.testing.assert_allclose(curve["points"][curve["pick_vertices"]], picks, rtol=0, atol=reach)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_evaluated_points_are_of_the_spline(degree, closed, home, sphere):
    at = np.r_[np.linspace(0, 1, 101), 0.25, 0.5]
    code = USE + (
        f"curve = draw_curve(vertices, faces, picks, degree={degree}, closed={closed})\n"
        "answer |= {'on': curve.evaluate(at), 'grid': curve.evaluate(at[:6].reshape(2, 3)), 'one': curve.evaluate(0.5),\n"
        "           'at_picks': curve.evaluate(curve.pick_parameters), 'segments': curve.segments(), 'length': curve.length}\n"
    ) + TAKE
    got = home.call(code, picks=PICKS, at=at, **sphere)
    spline = BSpline(got["knots"], got["control_points"], degree)
    np.testing.assert_allclose(got["on"], spline(np.where(at == 1, 1 - 1e-16, at)), rtol=0, atol=1e-12)
    np.testing.assert_array_equal(got["grid"], got["on"][:6].reshape(2, 3, 3))
    np.testing.assert_array_equal(got["one"], got["on"][50])
    np.testing.assert_allclose(got["at_picks"], PICKS, atol=1e-9)
    ends = got["points"][got["segments"]]
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(got["length"])
    assert len(got["segments"]) == len(got["points"]) - (not closed)


def test_further_calls_on_the_same_arrays_keep_the_shell(home, sphere):
    code = USE + (
        "kept = []\n"
        "def draw(mesh, through): kept.append(draw_curve(mesh, faces, through).figures['surface_kept'])\n"
        "draw(vertices, picks); draw(vertices, picks); draw(vertices.copy(), picks[:2]); draw(vertices * 2, picks * 2)\n"
        "draw(vertices, picks)\n"
        "answer['kept'] = kept"
    )
    assert home.call(code, picks=PICKS, **sphere)["kept"].tolist() == [False, True, True, False, True]


def test_threads_get_their_own_curves(home, sphere):
    code = USE + (
        "from concurrent.futures import ThreadPoolExecutor\n"
        "closed = [bool(i % 2) for i in range(12)]\n"
        "with ThreadPoolExecutor(4) as pool:\n"
        "    curves = list(pool.map(lambda c: draw_curve(vertices, faces, picks, closed=c), closed))\n"
        "answer['right'] = [curve.closed == c for curve, c in zip(curves, closed)]"
    )
    assert home.call(code, picks=PICKS, **sphere)["right"].all()


def test_a_tube_and_a_file_come_with_the_curve(home, sphere):
    code = USE + (
        "from pathlib import Path\n"
        "curve = draw_curve(vertices, faces, picks, tube_radius=0.02, save=Path('saved.json'))\n"
        "answer |= {'tube_vertices': curve.tube.vertices, 'tube_faces': curve.tube.faces}\n"
    ) + TAKE
    got = home.call(code, picks=PICKS, **sphere)
    saved = json.loads((home.folder / "saved.json").read_text())
    np.testing.assert_array_equal(saved["polyline"]["points"], got["points"])
    sides = np.sort(got["tube_faces"][:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (np.unique(sides, axis=0, return_counts=True)[1] == 2).all()  # closed
    away = np.linalg.norm(got["tube_vertices"][:, None] - got["points"][None], axis=2).min(1)
    assert away.max() == pytest.approx(0.02, rel=0.25)


@pytest.mark.parametrize(("arguments", "options"), [
    ("", ["--kind", "maximal-curvature"]),
    ("'ridge', curvature_scale=0.05, normalised=True", ["--kind", "ridge", "--curvature-scale", "0.05", "--normalised"]),
    ("'obstacle', region=faces[:, 0] < 300, obstacle_value=0.5", ["--kind", "obstacle", "--region", "region.npy", "--obstacle-value", "0.5"]),
])
def test_a_field_is_the_programs(arguments, options, home, program, bunny_path, tmp_path):
    import pymeshlab

    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(bunny_path))
    vertices, faces = document.current_mesh().vertex_matrix(), document.current_mesh().face_matrix()
    np.save(tmp_path / "region.npy", np.flatnonzero(faces[:, 0] < 300))
    subprocess.run([program, "field", bunny_path, *options, "--output", "field.npy"], cwd=tmp_path, check=True)
    got = home.call(USE + f"answer['field'] = compute_field(vertices, faces, {arguments})", vertices=vertices, faces=faces)
    np.testing.assert_allclose(got["field"], np.load(tmp_path / "field.npy"), rtol=1e-12, atol=1e-12)


def test_the_quality_as_a_field_can_be_smoothed(home, sphere):
    code = USE + "answer['field'] = compute_field(vertices, faces, 'quality', quality=vertices[:, 2], inverted=True)"
    z = sphere["vertices"][:, 2]
    np.testing.assert_allclose(home.call(code, **sphere)["field"], z.max() + z.min() - z, atol=1e-12)


REFUSED = [
    ("draw_curve(vertices[:, :2], faces, picks)", "ValueError: vertices has shape (2562, 2), but must have (n, 3)"),
    ("draw_curve(vertices.ravel(), faces, picks)", "ValueError: vertices has shape (7686,), but must have (n, 3)"),
    ("draw_curve(vertices[:0], faces[:0], picks)", "ValueError: vertices is empty: a triangle mesh is needed"),
    ("draw_curve(vertices, faces[:0], picks)", "ValueError: faces is empty: a triangle mesh is needed"),
    ("draw_curve(vertices, faces[:, :2], picks)", "ValueError: faces has shape (5120, 2), but must have (m, 3)"),
    ("draw_curve(vertices, faces * 1.0, picks)", "ValueError: faces holds float64, but must hold integers"),
    ("draw_curve(vertices, faces - 1, picks)", "] is -1, but there are 2562 vertices, counted from 0"),
    ("draw_curve(vertices, faces, [[1, 0, 0], [0, np.nan, 0]])", "ValueError: picks[1] is [0.0, nan, 0.0], but must be finite"),
    ("draw_curve(vertices, faces, [[1, 0], [0, 1, 0]])", "ValueError: picks is no array: "),
    ("draw_curve(vertices, faces, [['1', '0', '0']])", "ValueError: picks holds <U1, but must hold numbers"),
    ("draw_curve(vertices, faces, np.empty((0, 3)))", "ValueError: picks is empty"),
    ("draw_curve(vertices, faces, picks, tension=2)", "ValueError: tension is 2, but must be in [0, 1]"),
    ("draw_curve(vertices, faces, picks, minimum_span=0)", "ValueError: minimum_span is 0, but must be in (0, 0.1]"),
    ("draw_curve(vertices, faces, picks, field_weight=np.inf)", "ValueError: field_weight is inf, but must be finite and at least 0"),
    ("draw_curve(vertices, faces, picks, distance_tolerance=0)", "distance_tolerance is 0, but must be finite and more than 0"),
    ("draw_curve(vertices, faces, picks, samples=1.5)", "TypeError: samples is 1.5, but must be an integer"),
    ("draw_curve(vertices, faces, picks, tension='1')", "TypeError: tension is '1', but must be a number"),
    ("draw_curve(vertices, faces, picks, closed=1)", "TypeError: closed is 1, but must be True or False"),
    ("draw_curve(vertices, faces, picks, shell='thin')", "ValueError: shell is 'thin', but must be one of 'local', "),
    ("draw_curve(vertices, faces, picks, shell=1)", "TypeError: shell is 1, but must be text"),
    ("draw_curve(vertices, faces, picks, field=[1, 2])", "field has shape (2,), but must have (2562,), a value for each vertex"),
    ("draw_curve(vertices, faces, picks, field=vertices[:, 0], quality=vertices[:, 0])", "field and quality are both given"),
    ("draw_curve(vertices, faces, picks, field='quality')", "field is 'quality', but quality is not given"),
    ("draw_curve(vertices, faces, picks, quality=vertices[:, 0])", "quality is given, but nothing uses it"),
    ("draw_curve(vertices, faces, picks, field='valley', quality=vertices[:, 0])", "quality is given, but nothing uses it"),
    ("draw_curve(vertices, faces, picks, field='obstacle')", "field is 'obstacle', which needs field_region"),
    ("draw_curve(vertices, faces, picks, field='obstacle', field_region=[1], avoid=[2])", "compute_field(kind='obstacle')"),
    ("draw_curve(vertices, faces, picks, avoid='selected-faces')", "arrays know no selection: give ids of faces"),
    ("draw_curve(vertices, faces, picks, avoid='under-threshold')", "needs a field or quality: give one of them"),
    ("draw_curve(vertices, faces, picks, avoid=[7, 5120])", "ValueError: avoid[1] is 5120, but there are 5120 faces"),
    ("draw_curve(vertices, faces, picks, avoid=[True])", "avoid has shape (1,), but must have (5120,), a bool for each face"),
    ("draw_curve(vertices, faces, picks, avoid=[[1, 2]])", "avoid has shape (1, 2), but must have (k,), ids of faces"),
    ("draw_curve(vertices, faces, picks, avoid=[0.5])", "avoid holds float64, but must hold integers"),
    ("compute_field(vertices, faces, 'obstacle')", "ValueError: kind is 'obstacle', which needs region"),
    ("compute_field(vertices, faces, 'quality')", "ValueError: kind is 'quality', which needs quality"),
    ("compute_field(vertices, faces, 'none')", "ValueError: kind is 'none', but must be one of 'normal-variation'"),
    ("draw_curve(vertices, faces, picks[:1])", "CurveError: an open curve needs at least 2 picks, not 1"),
    ("draw_curve(vertices, faces, picks * [[1], [3], [1]])", "CurveError: pick 2 lies 2 from the surface"),
    ("draw_curve(vertices, np.vstack([faces, faces[:1]]), picks, strict=True)", "CurveError: 3 edges join more than two faces"),
    ("draw_curve(vertices, faces, picks, field=np.where(vertices[:, 0] > 0, np.nan, 1))", "CurveError: "),
    ("draw_curve(vertices, faces, picks, avoid=range(5120))", "CurveError: pick 1"),
    ("draw_curve(vertices, faces, picks, save='nowhere/curve.ply')", "CurveError: nowhere/curve.ply: the directory nowhere does not"),
    ("draw_curve(vertices, faces, picks).evaluate([0.5, 1.5])", "ValueError: t is in [0.5, 1.5], but an open curve has [0, 1]"),
    ("draw_curve(vertices, faces, picks).evaluate(np.nan)", "ValueError: t must be finite"),
]


def test_what_is_wrong_is_said_and_the_next_call_works(home, sphere):
    code = USE + (
        "said = []\n"
        "for call in calls.tolist():\n"
        "    try:\n"
        "        eval(call)\n"
        "        said.append('nothing')\n"
        "    except (ValueError, TypeError, CurveError) as error:\n"
        "        said.append(f'{type(error).__name__}: {error}')\n"
        "answer['said'] = said\n"
        "answer['usable'] = draw_curve(vertices, faces, picks).usable"
    )
    got = home.call(code, picks=PICKS, calls=[call for call, _ in REFUSED], **sphere)
    wrong = [(call, said) for (call, expected), said in zip(REFUSED, got["said"], strict=True) if expected not in said]
    assert wrong == []
    assert all("\n" not in said for said in got["said"])
    assert got["usable"]


def test_numbers_of_numpy_are_options(home, sphere):
    arguments = "closed=np.True_, degree=np.int64(4), tension=np.float32(0.5), samples=np.uint8(50)"
    got = drawn(home, arguments, **sphere)
    assert got["closed"] and got["degree"] == 4
