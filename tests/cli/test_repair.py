# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with bad spots are mended, and nothing is changed silently; --strict refuses them by name."""

import json
import re

import made_meshes as meshes
import numpy as np
import pytest
import trimesh
from broken_meshes import scan_with_bad_spots, spots
from curve_files import read_ply

KEYS = ["left_out_faces", "merged_vertices", "removed_degenerate_faces", "split_faces", "removed_duplicate_faces", "reversed_faces",
        "cut_edges", "duplicated_vertices", "joined_edges", "joined_vertices"]


def run_curve(run, folder, mesh, V, F, *words):
    """A curve beside the bad spots, checked against the mesh as it was given."""
    (folder / "picks.json").write_text(json.dumps({"picks": V[[15, 36, 40]].tolist()}))
    process = run.ok(mesh, "--picks", "picks.json", "--output", "curve.ply", "--report", "curve.json", *words)
    vertex = read_ply(folder / "curve.ply")["vertex"]
    points = np.stack([vertex[name] for name in "xyz"], 1)
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert np.abs((V[F[vertex["face"]]] * weights[:, :, None]).sum(1) - points).max() < 1e-9
    return process, json.loads((folder / "curve.json").read_text()), vertex


@pytest.mark.parametrize("name", spots())
def test_a_bad_spot_is_mended_and_strictly_refused_by_name(run, tmp_path, name):
    V, F, key, word = spots()[name]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    for verb in (("shell", "bad.ply", "--check"), ("bad.ply", "--picks", "p.json", "--output", "c.ply")):
        (tmp_path / "p.json").write_text(json.dumps({"picks": V[[4, 40]].tolist()}))
        process = run(*verb, "--strict")
        assert process.returncode == 1 and process.stderr.count("\n") == 1
        assert word in process.stderr and ("; without --strict the mesh is mended" in process.stderr or word == "twice")

    process = run.ok("shell", "bad.ply", "--check", "--report", "r.json", "--output", "s.vtu")
    assert process.stderr.startswith("bspline_curve: note: the mesh was mended: ") and process.stderr.count("\n") == 1
    report = json.loads((tmp_path / "r.json").read_text())
    assert all(entry["holds"] for entry in report["check"].values())
    assert report["faces"] == len(F)
    repair = report["repair"]
    assert list(repair) == ["changes", *KEYS] and repair[key] and repair["changes"] == sum(len(repair[k]) for k in KEYS)
    counts = sum(int(n) for n in re.findall(r"\d+", process.stderr))
    assert counts == repair["changes"], "the line counts what the report lists"

    process, curve_report, vertex = run_curve(run, tmp_path, "bad.ply", V, F)
    assert process.stderr.count("the mesh was mended") == 1
    assert curve_report["repair"] == repair
    gone = set(repair["left_out_faces"]) | set(repair["removed_degenerate_faces"]) | set(repair["removed_duplicate_faces"])
    assert not gone & set(vertex["face"].tolist())


def test_a_sound_mesh_is_left_alone_and_no_word_said(run, tmp_path):
    V, F = meshes.plate(cells=6, height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    process, report, _ = run_curve(run, tmp_path, "hill.ply", V, F)
    plain = (tmp_path / "curve.ply").read_bytes()
    assert process.stderr == "" and report["repair"] is None
    process, report, _ = run_curve(run, tmp_path, "hill.ply", V, F, "--strict")
    assert process.stderr == "" and report["repair"] is None
    assert (tmp_path / "curve.ply").read_bytes() == plain


def test_one_sided_surfaces_are_cut_open_and_strictly_refused_by_name(run, tmp_path):
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    rim = lambda side: np.stack([(1 + side * np.cos(angle / 2)) * np.cos(angle),
                                 (1 + side * np.cos(angle / 2)) * np.sin(angle), side * np.sin(angle / 2)], 1)
    V = np.vstack([rim(-0.3), rim(0.3)])
    i, j = np.arange(40), (np.arange(40) + 1) % 40
    other = np.where(j == 0, 40, 0)  # the strip comes back upside down
    F = np.vstack([np.stack([i, j + other, i + 40], 1), np.stack([j + other, (j + 40 - other), i + 40], 1)])
    meshes.write_ply(tmp_path / "moebius.ply", V, F)
    process = run("shell", "moebius.ply", "--check", "--strict")
    assert process.returncode == 1 and "Moebius" in process.stderr and process.stderr.count("\n") == 1
    process, report, _ = run_curve(run, tmp_path, "moebius.ply", V, F)
    assert report["usable"] and len(report["repair"]["cut_edges"]) == 1 and len(report["repair"]["duplicated_vertices"]) == 2


def test_a_field_is_carried_over_to_duplicated_vertices(run, tmp_path):
    V, F, _, _ = spots()["three faces at an edge"]
    field = V[:, 1] ** 2
    meshes.write_ply(tmp_path / "bad.ply", V, F, quality=field)
    _, _, vertex = run_curve(run, tmp_path, "bad.ply", V, F, "--field", "quality", "--mu", "1")
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert np.abs((field[F[vertex["face"]]] * weights).sum(1) - vertex["quality"]).max() < 1e-12


@pytest.mark.parametrize("extension", ["ply", "obj", "off"])
def test_a_scan_with_many_bad_spots(run, tmp_path, extension):
    V, F = scan_with_bad_spots()
    {"ply": meshes.write_ply, "obj": meshes.write_obj, "off": meshes.write_off}[extension](tmp_path / f"scan.{extension}", V, F)
    assert run("shell", f"scan.{extension}", "--check", "--strict").returncode == 1
    run.ok("shell", f"scan.{extension}", "--check", "--report", "r.json")
    repair = json.loads((tmp_path / "r.json").read_text())["repair"]
    assert len(repair["removed_duplicate_faces"]) == 6 and len(repair["removed_degenerate_faces"]) == 6
    assert len(repair["reversed_faces"]) >= 6 and len(repair["cut_edges"]) >= 6 and repair["duplicated_vertices"]
    first = (tmp_path / "r.json").read_bytes()
    run.ok("shell", f"scan.{extension}", "--check", "--report", "r.json")
    assert json.loads((tmp_path / "r.json").read_text())["repair"] == json.loads(first)["repair"]


def test_repair_is_still_taken_and_says_nothing_new(run, tmp_path):
    V, F, _, _ = spots()["bow tie"]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    said = [run_curve(run, tmp_path, "bad.ply", V, F, *words)[0].stderr for words in ((), ("--repair",))]
    assert said[0] == said[1] != ""
    assert "--repair" not in run("curve", "--help").stdout and "--strict" in run("curve", "--help").stdout


def test_a_batch_mends_and_refuses_by_the_line(run, tmp_path):
    V, F, _, _ = spots()["three faces at an edge"]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[15, 36, 40]].tolist()}))
    lines = ["mesh,picks,output,strict", "bad.ply,picks.json,a.ply,no", "bad.ply,picks.json,b.ply,yes"]
    (tmp_path / "jobs.csv").write_text("\n".join(lines) + "\n")
    run("batch", "jobs.csv")
    results = (tmp_path / "jobs.results.csv").read_text()
    assert (tmp_path / "a.ply").exists() and not (tmp_path / "b.ply").exists()
    assert "more than two faces" in results


def two_halves(gap):
    """Two plates side by side, so far apart; the second has vertices of its own."""
    V, F = meshes.plate(cells=8)
    return np.vstack([V, V + [1 + gap, 0, 0]]), np.vstack([F, F + len(V)])


def test_parts_that_only_look_joined_are_welded_where_that_is_asked(run, refused, tmp_path):
    V, F = two_halves(1e-8)
    meshes.write_ply(tmp_path / "halves.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[20, 100, 140]].tolist()}))
    words = ("halves.ply", "--picks", "picks.json", "--output", "curve.ply")
    refused(1, *words, says=["pick 2", "another connected component"])
    process = run(*words, "--weld", "1e-6")
    assert process.returncode == 0 and process.stderr == "bspline_curve: note: the mesh was mended: 9 vertices merged\n"
    vertex = read_ply(tmp_path / "curve.ply")["vertex"]
    points = np.stack([vertex[name] for name in "xyz"], 1)
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert np.abs((V[F[vertex["face"]]] * weights[:, :, None]).sum(1) - points).max() < 2e-8
    assert vertex["face"].min() < len(F) / 2 <= vertex["face"].max(), "faces are those of the file"
    refused(2, *words, "--weld", "1e-6", "--strict", says=["strict", "weld", "choose one"])
    refused(2, *words, "--weld", "0.5", says=["--weld", "0.01"])


@pytest.mark.parametrize("mesh, advised", [("1e-8", "1e-06"), ("3e-5", "2e-05"), ("1e-3", "0.0005"), ("0.5", None), ("steps", "0.005")])
def test_a_distance_that_is_advised_helps_and_is_the_least_that_does(run, tmp_path, mesh, advised):
    if mesh == "steps":  # a vertex of one part beside an edge of the other, nearer to its ends than to nothing
        V, F = two_halves(0.0)
        V[81:][np.isclose(V[81:, 0], 1) & (V[81:, 1] > 0) & (V[81:, 1] < 1), 1] += 0.01
    else:
        V, F = two_halves(float(mesh))
    meshes.write_ply(tmp_path / "halves.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[20, 100]].tolist()}))
    words = ("halves.ply", "--picks", "picks.json", "--output", "curve.ply")
    found = re.search(r"; --weld (\S+) joins these components$", run(*words).stderr.strip())
    assert (found and found[1]) == advised
    if advised:
        assert run(*words, "--weld", advised).returncode == 0
        assert advised == "1e-06" or run(*words, "--weld", float(advised) * 0.4).returncode == 1


def test_a_vertex_that_no_face_uses_may_be_anywhere(run, tmp_path):
    V, F = meshes.plate(cells=6, height=0.1)
    outputs = []
    for mesh, vertices in (("plain.ply", V), ("nan.ply", np.vstack([V, [np.nan, np.inf, 0]]))):
        meshes.write_ply(tmp_path / mesh, vertices, F)
        process, _, _ = run_curve(run, tmp_path, mesh, V, F, "--field", "valley")
        assert process.stderr == ""
        for words in (("imprint", mesh, "--curve", "curve.ply", "--output", "out.ply"),
                      ("field", mesh, "--kind", "maximal-curvature", "--smoothing", 0.1, "--output", "f.npy"),
                      ("shell", mesh, "--check"),
                      ("offset", mesh, "--curve", "curve.ply", "--distance", 0.05, "--output", "offset.ply")):
            process = run(*words)
            assert process.returncode == 0, process.stderr
        imprinted = trimesh.load(tmp_path / "out.ply", process=False)
        outputs.append([read_ply(tmp_path / "curve.ply")["vertex"]["x"], len(imprinted.faces), np.load(tmp_path / "f.npy")[:49]])
    for plain, other in zip(*outputs):
        np.testing.assert_allclose(plain, other, atol=1e-12)


def test_a_slit_is_joined_unless_it_is_to_stay(run, refused, tmp_path):
    V, F = two_halves(0)
    meshes.write_ply(tmp_path / "halves.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[20, 100]].tolist()}))
    words = ("halves.ply", "--picks", "picks.json", "--output", "curve.ply", "--report", "r.json")
    process = run(*words)
    assert process.returncode == 0 and "8 pairs of edges on each other joined; the option slits leaves these open" in process.stderr
    repair = json.loads((tmp_path / "r.json").read_text())["repair"]
    assert len(repair["joined_edges"]) == 8 and len(repair["joined_vertices"]) == 9
    assert all((V[a] == V[b]).all() and a > b for a, b in repair["joined_vertices"])
    for option in ("--slits", "--strict"):
        refused(1, *words, option, says=["another connected component", "slits part them"])


def test_fields_and_shells_of_welded_parts_are_those_of_one(run, tmp_path):
    V, F = two_halves(0)
    meshes.write_ply(tmp_path / "halves.ply", V, F)
    run.ok("field", "halves.ply", "--kind", "boundary-distance", "--output", "f.npy", "--weld", "1e-9")
    field = np.load(tmp_path / "f.npy")
    seam = np.flatnonzero(np.isclose(V[:, 0], 1) & (np.abs(V[:, 1] - 0.5) < 0.1))
    assert len(field) == len(V) and len(seam) == 2 and field[seam[0]] == field[seam[1]] and field[seam[0]] > field.min()
    run.ok("shell", "halves.ply", "--check", "--weld", "1e-9")
