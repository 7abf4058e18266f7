# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts in benchmarks/ measure what they say, in their quick mode; those that need other programs run where these are."""
import importlib.util
import json
import shutil
from pathlib import Path

import cases  # on the path since conftest.py
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def needs(*modules):
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    return pytest.mark.skipif(bool(missing), reason=f"needs {', '.join(missing)} (benchmarks/requirements.txt)")


def area(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def succeed(done):
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


# ---------------------------------------------------------------- meshes and picks
def test_the_torus_is_closed_and_oriented():
    vertices, faces = cases.torus_of(3000)
    edges = faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    directed = {tuple(edge) for edge in edges.tolist()}
    assert len(directed) == len(edges) and all((b, a) in directed for a, b in directed)
    assert len(vertices) - len(directed) // 2 + len(faces) == 0
    assert abs(len(vertices) - 3000) < 60


def test_subdividing_keeps_the_surface_and_shares_midpoints():
    vertices, faces = cases.bumpy_torus(24, 12)
    finer, split = cases.midpoint_subdivided(vertices, faces)
    assert len(split) == 4 * len(faces) and len(finer) == len(vertices) + 3 * len(faces) // 2
    assert np.array_equal(finer[: len(vertices)], vertices)
    assert area(finer, split) == pytest.approx(area(vertices, faces), rel=1e-12)


def test_picks_are_far_apart_on_the_largest_component_and_the_same_every_time():
    vertices, faces = cases.bumpy_torus(40, 20)
    small, few = cases.bumpy_torus(12, 12)
    both, joined = np.vstack([small + 10, vertices]), np.vstack([few, faces + len(small)])
    picks = cases.farthest_picks(both, joined, 6, 1)
    assert np.array_equal(picks, cases.farthest_picks(both, joined, 6, 1))
    assert np.abs(picks).max() < 2, "none on the smaller component"
    distances = np.linalg.norm(picks[:, None] - picks[None], axis=2)[~np.eye(6, dtype=bool)]
    assert distances.min() > 0.5


def test_what_the_program_refuses_is_said(bench_program):
    vertices, faces = cases.bumpy_torus(24, 12)
    with pytest.raises(cases.NoCurve, match="pick 2"):
        cases.draw(bench_program, cases.Case("far", vertices, faces, np.array([vertices[0], [9, 9, 9]]), False))


# ---------------------------------------------------------------- scripts
def test_scaling_draws_the_same_curve_on_four_times_the_faces(script, bench_program, tmp_path):
    succeed(script("scaling.py", "--quick", "--program", bench_program, "--json", tmp_path / "s.json"))
    results = json.loads((tmp_path / "s.json").read_text())
    rows = results["rows"]
    assert [row["faces"] for row in rows] == 3 * [rows[0]["faces"]] + 3 * [4 * rows[0]["faces"]]
    assert [row["field"] for row in rows] == 2 * ["none", "waves", "maximal-curvature"]
    for row in rows:
        assert row["warm"] > 0 and row["bytes_per_face"] > 0
        assert 0.9 * row["cold"] < sum(row["stages"].values()) < 1.001 * row["cold"], "the stages are all of a cold curve"
        assert (row["stages"]["field"] > 0.001) == (row["field"] == "maximal-curvature"), "waves come from a file"
    plain = [row["cold"] for row in rows if row["field"] == "none"]
    assert results["growth"]["none"]["cold"]["worst"] == pytest.approx(plain[1] / plain[0])


def test_the_rows_of_table_1_have_their_vertices_and_picks(script, bench_program, tmp_path):
    succeed(script("table1.py", "--quick", "--program", bench_program, "--json", tmp_path / "t.json"))
    rows = json.loads((tmp_path / "t.json").read_text())["rows"]
    assert [(round(row["vertices"], -3), row["picks"]) for row in rows] == [(1000, 7), (3000, 4)]
    assert all(row["warm"] > 0 and row["cold"] > 0 and min(row["knots"]) > 0 for row in rows)


def test_rules_of_the_paper_are_replaced_one_by_one(script, bench_program, tmp_path):
    succeed(script("paper_rules.py", "--quick", "--program", bench_program, "--json", tmp_path / "r.json"))
    rows = json.loads((tmp_path / "r.json").read_text())
    assert [row["curves"] for row in rows] == 8 * [1] and len({row["rule"] for row in rows}) == 8
    assert all(row["ratio"] > 0.9 and len(row["knots"]) == 3 for row in rows)
    assert rows[0]["ratio"] > rows[-1]["ratio"], "by the paper's rules full tension does not shorten this curve"
    assert rows[-1]["longer"] == rows[-2]["longer"] == 0


def test_polylines_have_as_many_points_as_the_samples_that_splines_get(script, bench_program, tmp_path):
    if not (bench_program.parent / "polyline_comparison").is_file():
        pytest.skip("polyline_comparison is not built (-DBSPLINE_CURVE_BENCHMARKS=ON)")
    succeed(script("polyline_method.py", "--quick", "--program", bench_program, "--json", tmp_path / "l.json"))
    rows = json.loads((tmp_path / "l.json").read_text())["rows"]
    assert [row["samples"] for row in rows] == [165, 358]
    for row in rows:
        assert abs(row["polyline"]["points"] - row["samples"]) < 6 and row["spline"]["points"] > row["samples"]
        for kind in ("spline", "polyline"):
            assert row[kind]["usable"] and row[kind]["seconds"] > 0 and row[kind]["steps"] > 0
    energies = [row["spline"]["internal"] / row["polyline"]["internal"] for row in rows]
    assert 0.7 < energies[1] < 1.4, "both minimise the same energy"


def zoo_of(folder):
    """Two tori, one with a face twice and a bow tie, each with picks of each kind; and one mesh that is none."""
    (folder / "picks").mkdir(parents=True)
    for name, size in (("sound", 24), ("broken", 30)):
        vertices, faces = cases.bumpy_torus(size, 12)
        if name == "broken":
            faces = np.vstack([faces, faces[:1], [[0, len(vertices), len(vertices) + 1]]])
            vertices = np.vstack([vertices, [[3, 0, 0], [3, 1, 0]]])
        cases.write_ply(folder / f"{name}.ply", vertices, faces)
        for kind, count in (("A", 4), ("B", 6), ("C", 4)):
            picks = vertices[np.linspace(0, 12 * size - 60, count).astype(int)]
            (folder / "picks" / f"{name}.{kind}.picks.json").write_text(json.dumps({"picks": picks.tolist(), "closed": kind == "B"}))
    (folder / "none.obj").write_text("no mesh")
    (folder / "none.picks.json").write_text(json.dumps({"picks": [[0, 0, 0], [1, 0, 0]]}))


def test_the_zoo_counts_answers_and_what_was_mended_and_asks_the_judge(script, bench_program, tmp_path):
    zoo_of(tmp_path / "zoo")
    page, judge = tmp_path / "page.md", tmp_path / "judge.py"
    shutil.copy(ROOT / "docs" / "ROBUSTNESS.md", page)
    judge.write_text("import sys\nmesh, curve, option, picks = sys.argv[1:5]\nassert option == '--picks' and open(curve).read()\n"
                     "print('FAIL: C' if '.C.' in picks else '')\nsys.exit('.C.' in picks)\n")
    done = script("zoo.py", tmp_path / "zoo", "--program", bench_program, "--judge", judge, "--json", tmp_path / "z.json", "--page", page)
    assert done.returncode == 1, done.stdout + done.stderr
    rows = json.loads((tmp_path / "z.json").read_text())["rows"]
    drawn = [row for row in rows if row["answer"]]
    assert [row["mesh"] for row in rows if not row["answer"]] == ["none.obj"] and len(drawn) == 6
    for row in drawn:
        broken = row["mesh"] == "broken.ply"
        assert row["usable"] and row["cpu"] > 0 and row["faces"] > 500 and row["ratio"] > 0
        assert (row["mended"] is not None) == broken and row["judged"] == ("FAIL: C" if row["kind"] == "C" else "")
        assert not broken or (row["mended"]["removed_duplicate_faces"], row["mended"]["duplicated_vertices"]) == (1, 1)
    for line in ("| answers, % | at least 99.5 | 85.7 | **no** |", "| closed, 6 picks | 2 | 2 | 2 |",
                 "| judged right, or strict by the faces that they name, % | at least 100 | 100.0 | yes |",
                 "| duplicate faces removed | 1 | 1, 1 |", "| taken as they are | 1 |"):
        assert line in done.stdout and line in page.read_text()
    assert "no answer: none.obj" in done.stdout and "judged wrong: sound.ply C: FAIL: C; 0 segments" in done.stdout


def test_segments_that_leave_their_faces_are_counted(tmp_path):
    import zoo

    vertices, faces = cases.bumpy_torus(24, 12)
    cases.write_ply(tmp_path / "torus.ply", vertices, faces)
    weights = np.array([[1, 0, 0], [0.5, 0.5, 0], [0, 1, 0], [0.2, 0.3, 0.5]])
    line = {"faces": [0, 0, 0, 0], "barycentrics": weights.tolist(), "points": (weights[:, :, None] * vertices[faces[0]]).sum(1).tolist()}
    for change, count in ((None, 0), (("faces", 3, 200), 1), (("points", 1, [9, 9, 9]), 2)):
        polyline = json.loads(json.dumps(line))
        if change:
            polyline[change[0]][change[1]] = change[2]
            if change[0] == "faces":
                polyline["points"][3] = (weights[3, :, None] * vertices[faces[200]]).sum(0).tolist()
        (tmp_path / "curve.json").write_text(json.dumps({"polyline": polyline, "closed": False}))
        assert zoo.loose_segments(tmp_path / "torus.ply", tmp_path / "curve.json") == count


@needs("potpourri3d", "meshlib")
def test_peers_are_timed_on_the_same_curves(script, bench_program, tmp_path):
    text = succeed(script("peers.py", "--quick", "--program", bench_program, "--json", tmp_path / "p.json"))
    results = json.loads((tmp_path / "p.json").read_text())
    assert len(results["rows"]) == 4 and "geometric mean" in text
    for row in results["rows"]:
        assert all(row[who][state] > 0 for who in ("geodesic", "meshlib", "ours") for state in ("warm", "cold"))
    first = results["rows"][0]
    assert results["ratios"]["cold, ours / geodesic"][0] == pytest.approx(first["ours"]["cold"] / first["geodesic"]["cold"])


@needs("matplotlib", "potpourri3d", "meshlib")
def test_the_page_gets_other_tables_and_plots_and_keeps_its_text(script, bench_program, tmp_path):
    page = tmp_path / "docs" / "PERFORMANCE.md"
    page.parent.mkdir()
    shutil.copy(ROOT / "docs" / "PERFORMANCE.md", page)
    succeed(script("performance_page.py", "--quick", "--program", bench_program, "--page", page, "--results", tmp_path / "results"))
    before, after = (path.read_text().splitlines() for path in (ROOT / "docs" / "PERFORMANCE.md", page))
    assert [line for line in before if line and line[0] not in "|TI"] == [line for line in after if line and line[0] not in "|TI"]
    assert any(line.startswith("| torus of 1,000, 4 open |") for line in after)
    for name in ("peers", "scaling", "polylines", "instructions"):
        assert (page.parent / "images" / f"performance_{name}.png").read_bytes().startswith(b"\x89PNG")


def test_the_page_shows_every_count_that_is_kept():
    counts = json.loads((ROOT / "benchmarks" / "instructions.json").read_text())["paths"]
    page = (ROOT / "docs" / "PERFORMANCE.md").read_text()
    assert [name for name in counts if f"| {name.replace('_', ' ')} |" not in page] == []


def test_random_sets_of_curves_are_imprinted_as_promised(script, bench_program, tmp_path):
    done = script("random_imprints.py", "--sets", 40, "--seed", 7, "--program", bench_program, "--json", tmp_path / "r.json")
    succeed(done)
    rows = json.loads((tmp_path / "r.json").read_text())["rows"]
    assert sum(row["sets"] for row in rows) == 40 and len(rows) == 5 and all(row["wrong"] == 0 for row in rows)


def test_the_checks_of_imprints_see_what_is_wrong(bench_program, tmp_path):
    import random_curves
    import random_imprints as imprints

    mesh = random_curves.Mesh(*imprints.plate(6))
    quality = mesh.vertices @ [1.0, 2.0, 0.0]
    curves = random_curves.random_set(mesh, np.random.default_rng(3), 4)
    given = type("Given", (), {"program": bench_program})
    assert imprints.check_set(given, None, mesh, quality, curves, tmp_path) == []
    told, report = (json.loads((tmp_path / name).read_text()) for name in ("map.json", "report.json"))
    whole = imprints.read_result(tmp_path / "out.ply")
    words = [word for k in range(len(curves)) for word in ("--curve", tmp_path / f"curve-{k}.json")]

    def complaints(vertices=whole[0], values=whole[1], faces=whole[2], told=told, report=report):
        result = (vertices, values, faces, whole[3])
        wrong = imprints.wrong_imprint(mesh, quality, curves, result, told)
        return {text.partition(":")[0].partition(" ")[0] for text in
                wrong + imprints.wrong_parts(bench_program, tmp_path, mesh, words, result, told, report)}

    count = len(mesh.vertices)
    moved = whole[0].copy()
    moved[-1] += [1e-3, 0, 0]
    assert "quality" in complaints(vertices=moved)
    moved = whole[0].copy()
    moved[0, 2] = 1e-300
    assert "vertices" in complaints(vertices=moved)
    assert "faces" in complaints(faces=whole[2][:, ::-1])
    assert "parents" in complaints(told=told | {"parents": told["parents"][1:] + told["parents"][:1]})
    swapped = [c | {"vertices": c["vertices"][::2]} for c in told["curves"]]
    assert "curve" in complaints(told=told | {"curves": swapped})
    parts = [report["parts"][0] | {"area": 1.1 * report["parts"][0]["area"]}, *report["parts"][1:]]
    assert "parts" in complaints(report=report | {"parts": parts})
    parts = [report["parts"][0] | {"euler": 7}, *report["parts"][1:]]
    assert "parts" in complaints(report=report | {"parts": parts})
    assert count < len(whole[0])


def test_fits_are_measured_beside_what_is_known(script, tmp_path):
    succeed(script("fits.py", "--quick", "--json", tmp_path / "f.json"))
    told = json.loads((tmp_path / "f.json").read_text())
    assert [(row["mesh"], row["noise"]) for row in told["strokes"]] == [
        (mesh, noise) for mesh in ("bone", "bunny", "sphere", "torus") for noise in ("white", "smooth")]
    for row in told["strokes"]:
        assert 0.05 < row["least squares"] < 1.5 and row["off"] < 2 * row["least squares"]
        assert 4 < row["control points"] < 25
    labels = told["labels"]
    assert labels["labels"] == 8 and labels["curves"] > 8 and labels["area"] < 0.01
    assert labels["nearest junctions"] > 1e-3, "one point each"


@needs("meshlib")
def test_fills_are_measured_beside_those_of_others(script, tmp_path):
    succeed(script("fills.py", "--quick", "--json", tmp_path / "f.json"))
    rows = json.loads((tmp_path / "f.json").read_text())["rows"]
    assert [row["size"] for row in rows] == [8, 16, 32]
    for row in rows:
        assert row["ours"]["faces"] > row["rim"] and row["ours"]["cross"] == 0
        assert row["ours"]["off"] < 0.02 < row["MeshLib"]["off"], "a cap of a sphere"
        assert row["ours"]["turn"][0] < 2 and row["ours"]["aspect"] < 8


@needs("meshlib")
def test_imprinting_is_timed_beside_meshlib(script, bench_program, tmp_path):
    succeed(script("peers_cut.py", "--quick", "--program", bench_program, "--json", tmp_path / "p.json"))
    rows = json.loads((tmp_path / "p.json").read_text())["rows"]
    assert len(rows) == 6
    for row in rows:
        assert row["ours"] > 0 and row["our_faces"] > row["faces"] and row["segments"] > 100
    assert any(row["meshlib"] for row in rows)
