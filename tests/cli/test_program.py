# SPDX-License-Identifier: GPL-3.0-or-later
"""The program as a user runs it: every format in and out, options, and what it reports."""

import json
import os
import pty
import re
import signal
import subprocess
import time

import made_meshes as meshes
import numpy as np
import pytest
from made_meshes import PICKS
from curve_files import read_curve, read_ply, succeed

DEFAULT = ("plate.ply", "--picks", "picks.json", "--output", "curve.ply")


def passes(points, picks, tolerance=1e-9):
    """Every pick is a point of the curve, and they come in order."""
    distances = np.linalg.norm(points[None] - np.array(picks)[:, None], axis=2)
    assert distances.min(1).max() <= tolerance
    assert (np.diff(distances.argmin(1)) > 0).all()


@pytest.mark.parametrize("name", meshes.MESH_WRITERS)
def test_every_mesh_format_gives_the_same_curve(run, plate, name):
    succeed(run(*DEFAULT))
    reference, _, _ = read_curve(plate / "curve.ply")
    meshes.MESH_WRITERS[name](plate / name, *meshes.plate())
    succeed(run(name, "--picks", "picks.json", "--output", "other.ply"))
    points, _, _ = read_curve(plate / "other.ply")
    passes(points, PICKS, 1e-7)
    # STL stores floats, in an order of vertices of its own
    assert len(points) == len(reference) or name.endswith(".stl")
    if len(points) == len(reference):
        assert np.abs(points - reference).max() < (1e-5 if name.endswith(".stl") else 1e-12)


def test_points_of_the_curve_lie_where_face_and_barycentrics_say(run, plate):
    V, F = meshes.plate(height=0.1)
    meshes.write_ply(plate / "hill.ply", V, F)
    picks = [V[30].tolist(), V[90].tolist(), V[140].tolist()]
    (plate / "picks.json").write_text(json.dumps({"picks": picks}))
    for name in ("curve.ply", "curve.json"):
        succeed(run("hill.ply", "--picks", "picks.json", "--output", name))
    vertex = read_ply(plate / "curve.ply")["vertex"]
    points = np.stack([vertex[name] for name in "xyz"], 1)
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert weights.min() >= 0 and np.abs(weights.sum(1) - 1).max() < 1e-12
    assert np.abs((V[F[vertex["face"]]] * weights[:, :, None]).sum(1) - points).max() < 1e-12
    assert (np.diff(vertex["t"]) > 0).all()
    passes(points, picks)
    polyline = json.loads((plate / "curve.json").read_text())["polyline"]
    assert np.array_equal(polyline["points"], points)
    assert np.array_equal(polyline["faces"], vertex["face"])
    assert np.array_equal(polyline["barycentrics"], weights)
    assert np.array_equal(polyline["t"], vertex["t"])


def test_the_picks_file_may_ask_for_a_closed_curve(run, plate):
    (plate / "picks.json").write_text(json.dumps({"picks": PICKS, "closed": True}))
    succeed(run(*DEFAULT))
    assert read_curve(plate / "curve.ply")[2]


def test_a_pick_given_twice_is_passed_once_with_a_note(run, plate):
    run.ok(*DEFAULT[:-1], "once.json")
    picks = json.loads((plate / "picks.json").read_text())["picks"]
    (plate / "picks.json").write_text(json.dumps({"picks": [picks[0], picks[1], picks[1], *picks[2:]]}))
    result = run(*DEFAULT[:-1], "twice.json", "--report", "report.json")
    assert result.returncode == 0 and "note: pick 3 is at the same point" in result.stderr
    once, twice = (json.loads((plate / f"{name}.json").read_text()) for name in ("once", "twice"))
    assert once["polyline"]["points"] == twice["polyline"]["points"]
    first, second, *rest = once["polyline"]["picks"]
    assert twice["polyline"]["picks"] == [first, second, second, *rest]
    assert json.loads((plate / "report.json").read_text())["repeated_picks"] == [2]


def test_a_curve_may_pass_beside_its_picks(run, plate):
    run.ok(*DEFAULT[:-1], "near.json", "--pick-tolerance", "0.02", "--report", "report.json")
    picks = json.loads((plate / "picks.json").read_text())["picks"]
    distances = json.loads((plate / "report.json").read_text())["pick_distances"]
    assert len(distances) == len(picks) and 0.001 < max(distances) <= 0.02
    run.ok(*DEFAULT[:-1], "through.json", "--report", "report.json")
    assert json.loads((plate / "report.json").read_text())["pick_distances"] == []


@pytest.mark.parametrize("text", ["-1", "1mm", "edges", "nan"])
def test_a_tolerance_of_picks_that_is_no_length_is_refused(run, plate, text):
    result = run(*DEFAULT, f"--pick-tolerance={text}")
    assert result.returncode == 2 and "must be a length" in result.stderr and "--pick-tolerance" in result.stderr


def test_each_pick_may_have_a_tolerance_of_its_own(run, plate):
    def distances(*words):
        run.ok(*DEFAULT[:-1], "near.json", *words, "--report", "report.json")
        return json.loads((plate / "report.json").read_text())["pick_distances"]

    for words in ("0.02,0,1edge", "0.02, 0, 1 edges"):
        first, second, third = distances("--pick-tolerance", words)
        assert second < 1e-9 and first <= 0.02 and third > 1e-6
    assert max(distances("--pick-tolerance", "0,0.02,0")) > 0.001
    # Weights draw, and bound nothing; a larger one draws harder.
    near, nearer = (distances("--pick-tolerance", f"0, weight {weight}, 0")[1] for weight in (100, 10000))
    assert 1e-6 < nearer < near
    # A file of picks says it of its own, and the option goes before it.
    document = json.loads((plate / "picks.json").read_text())
    (plate / "picks.json").write_text(json.dumps({**document, "tolerances": [0, "weight 100", 0.0]}))
    assert distances()[1] == near
    assert distances("--pick-tolerance", "0,0.02,0") != distances()
    for wrong, said in (([0.1], "3 entries"), ([0, "far", 0], "must be a length"), (0.1, "one for each"), ([0, -1, 0], "not negative")):
        (plate / "bad.json").write_text(json.dumps({**document, "tolerances": wrong}))
        bad = run(*["bad.json" if word == "picks.json" else word for word in DEFAULT])
        assert bad.returncode == 1 and "tolerances" in bad.stderr and said in bad.stderr, bad.stderr


def test_as_many_tolerances_as_picks_are_wanted(run, plate):
    result = run(*DEFAULT, "--pick-tolerance", "0.1,0.2")
    assert result.returncode == 1 and "2 pick tolerances for 3 picks" in result.stderr, result.stderr


def test_a_curve_turns_at_its_corners_and_passes_picks_in_given_directions(run, plate):
    run.ok(*DEFAULT[:-1], "curve.json", "--corners", "2", "--tangents", "1: 0, 1, 0.5; 3: 0,-2,0", "--report", "report.json")
    spline = json.loads((plate / "curve.json").read_text())["spline"]
    assert spline["knots"].count(spline["pick_parameters"][1]) == 3
    points = np.array(spline["control_points"])
    assert abs(points[1] - points[0])[0] < 1e-9 and points[1, 1] > points[0, 1]
    assert abs(points[-1] - points[-2])[0] < 1e-9 and points[-1, 1] < points[-2, 1]
    tangents = json.loads((plate / "report.json").read_text())["tangents"]
    assert [each["pick"] for each in tangents] == [0, 2] and all(each["angle_of_spline"] < 1e-6 for each in tangents)
    # A curve keeps its directions, and a file of picks may name some; the option goes before it.
    kept = json.loads((plate / "curve.json").read_text())["tangents"]
    assert [each["pick"] for each in kept] == [0, 2]
    np.testing.assert_allclose(kept[0]["direction"], [0, 1, 0], atol=1e-9)
    document = json.loads((plate / "picks.json").read_text())
    (plate / "picks.json").write_text(json.dumps({**document, "tangents": kept}))
    for words, picks in (((), [0, 2]), (("--tangents", "2: 1,0,0"), [1])):
        run.ok(*DEFAULT[:-1], "curve.json", *words, "--report", "report.json")
        assert [each["pick"] for each in json.loads((plate / "report.json").read_text())["tangents"]] == picks
    (plate / "bad.json").write_text(json.dumps({**document, "tangents": [{"pick": 7, "direction": [1, 0, 0]}]}))
    bad = run(*["bad.json" if word == "picks.json" else word for word in DEFAULT])
    assert bad.returncode == 1 and "tangents" in bad.stderr
    (plate / "picks.json").write_text(json.dumps(document))
    # The same of corners.
    document = json.loads((plate / "picks.json").read_text())
    (plate / "picks.json").write_text(json.dumps({**document, "corners": [1]}))
    for words, multiplicity in (((), 3), (("--corners", "1"), 0)):
        run.ok(*DEFAULT[:-1], "curve.json", *words)
        spline = json.loads((plate / "curve.json").read_text())["spline"]
        assert (spline["knots"].count(spline["pick_parameters"][1]) == 3) == (multiplicity == 3)


def test_a_corner_can_have_a_direction_on_either_side(run, plate):
    run.ok(*DEFAULT[:-1], "curve.json", "--corners", "2", "--tangents", "2: 1, 1, 0 / 1, -1, 0", "--report", "report.json")
    document = json.loads((plate / "curve.json").read_text())
    (kept,) = document["tangents"]
    assert kept["pick"] == 1
    np.testing.assert_allclose(kept["before"], np.array([1, 1, 0]) / np.sqrt(2), atol=1e-6)
    np.testing.assert_allclose(kept["after"], np.array([1, -1, 0]) / np.sqrt(2), atol=1e-6)
    (met,) = json.loads((plate / "report.json").read_text())["tangents"]
    assert met["angle_of_spline"] < 1e-6
    # What was written is read: the same curve.
    picks = json.loads((plate / "picks.json").read_text())
    (plate / "led.json").write_text(json.dumps({**picks, "corners": [1], "tangents": [kept]}))
    run.ok(*["led.json" if word == "picks.json" else word for word in DEFAULT[:-1]], "again.json")
    again = json.loads((plate / "again.json").read_text())
    np.testing.assert_allclose(again["spline"]["control_points"], document["spline"]["control_points"], atol=1e-9)


@pytest.mark.parametrize(
    ("words", "said"),
    [(["--corners", "4"], "pick 4 is to be a corner, but there are 3 picks"), (["--corners", "0"], "from 1"),
     (["--tangents", "4:1,0,0"], "pick 4 has a tangent, but there are 3 picks"), (["--tangents", "1:0,0,0"], "not zero"),
     (["--tangents", "1:0,0,1"], "pick 1 is normal"), (["--tangents", "2:1,0,0/0,1,0"], "two directions"),
     (["--tangents", "1:1,0,0", "--preset", "paper"], "constraint")],
)
def test_corners_and_tangents_that_cannot_be_are_refused(run, plate, words, said):
    process = run(*DEFAULT, *words)
    assert process.returncode in (1, 2) and said in process.stderr, process.stderr


def test_more_samples_and_shorter_segments_refine_the_polyline(run, plate):
    counts = []
    for samples in (0, 64, 1000):
        succeed(run(*DEFAULT, "--samples", samples))
        counts.append(len(read_curve(plate / "curve.ply")[0]))
    assert counts[0] < counts[1] < counts[2] and counts[2] >= 1000
    succeed(run(*DEFAULT, "--samples", 0, "--max-segment-length", 0.01))
    points, _, _ = read_curve(plate / "curve.ply")
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).max() <= 0.01 * (1 + 1e-9)


def test_tension_one_is_straighter_than_zero_under_both_names(run, plate):
    length = {}
    for words in (("--tension", "0"), ("--tension", "1"), ("--lambda", "1")):
        succeed(run(*DEFAULT, *words))
        points, _, _ = read_curve(plate / "curve.ply")
        length[words] = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert length["--tension", "1"] < length["--tension", "0"]
    assert length["--tension", "1"] == length["--lambda", "1"]


@pytest.mark.parametrize("source", ["quality", "field.npy", "field.txt"])
def test_a_field_pulls_the_curve_and_is_written_along_it(run, plate, source):
    V, F = meshes.plate()
    field = (V[:, 1] - 0.5) ** 2
    meshes.write_ply(plate / "plate.ply", V, F, quality=field)
    np.save(plate / "field.npy", field)
    np.savetxt(plate / "field.txt", field, fmt="%.17g")
    means = []
    for weight in (0, 1000):
        succeed(run(*DEFAULT, "--field", source, "--mu", weight, "--samples", 400))
        vertex = read_ply(plate / "curve.ply")["vertex"]
        corners = field[F[vertex["face"]]]
        weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
        assert np.abs((corners * weights).sum(1) - vertex["quality"]).max() < 1e-12
        means.append(vertex["quality"].mean())
    assert means[1] < means[0]


def test_the_report_holds_times_figures_rounds_and_iterations(run, plate):
    succeed(run(*DEFAULT, "--report", "report.json", "--repeat", 3))
    report = json.loads((plate / "report.json").read_text())
    seconds = report["seconds"]
    assert seconds["cold"] > 0 and seconds["warm"] > 0
    stages = ("validate", "tree", "shell", "path", "initial", "minimise", "knots", "polyline", "failed_attempts")
    assert sum(seconds[name] for name in stages) <= seconds["cold"] * 1.05
    assert report["usable"] is True and isinstance(report["status"], str)
    assert report["knots_first"] > 0 and report["knots_last"] > 0
    assert report["max_distance"] <= report["allowed_distance"] == pytest.approx(0.1)
    assert report["max_pick_gap"] < 1e-9
    assert len(report["rounds"]) >= 1
    assert report["newton_iterations"] >= sum(r["iterations"] for r in report["rounds"])
    assert all(i["round"] < len(report["rounds"]) for i in report["iterations"])
    points, _, _ = read_curve(plate / "curve.ply")
    assert report["curve"]["vertices"] == len(points)
    assert report["curve"]["length"] == pytest.approx(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    assert report["mesh"]["vertices"] == 169 and report["mesh"]["faces"] == 288
    assert report["mesh"]["diagonal"] == pytest.approx(2**0.5)
    assert 1e6 < report["peak_memory_bytes"]["read"] <= report["peak_memory_bytes"]["cold"] < 1e8


def test_warm_is_null_unless_repeats_are_asked_for(run, plate):
    succeed(run(*DEFAULT, "--report", "report.json"))
    assert json.loads((plate / "report.json").read_text())["seconds"]["warm"] is None


def test_the_kind_of_shell_can_be_chosen_and_is_reported(run, plate):
    V, F = meshes.plate(cells=24, height=0.2)
    meshes.write_ply(plate / "hill.ply", V, F)
    (plate / "picks.json").write_text(json.dumps({"picks": V[[30, 300, 590]].tolist()}))
    reports, curves = {}, {}
    for name, words in {
        "default": (), "full": ("--shell", "full"), "simplified": ("--shell", "simplified"),
        "thin": ("--shell", "simplified", "--target-thickness", 0.02),
        "short": ("--shell", "simplified", "--target-edge-length", 0.1),
    }.items():
        # Integrals cell by cell see the shell; at foot points they do not.
        words += ("--quadrature", "cells")
        succeed(run("curve", "hill.ply", "--picks", "picks.json", "--output", "c.ply", "--report", "r.json", *words))
        reports[name] = json.loads((plate / "r.json").read_text())
        curves[name], _, _ = read_curve(plate / "c.ply")
        passes(curves[name], V[[30, 300, 590]])
    assert [reports[name]["shell"] for name in ("full", "simplified", "thin", "short")] == ["full"] + 3 * ["simplified"]
    assert reports["default"]["shell"] == "full", "the whole one where a curve needs it"
    succeed(run("hill.ply", "--picks", "picks.json", "--output", "c.ply", "--report", "r.json"))
    fibres = json.loads((plate / "r.json").read_text())
    assert (fibres["shell"], fibres["prisms"], fibres["cached"]) == ("fibres", 0, False)
    assert 0 < fibres["faces_passed"] < len(F) and fibres["seconds"]["failed_attempts"] >= 0
    assert np.array_equal(curves["default"], curves["full"]) and reports["default"]["prisms"] == reports["full"]["prisms"]
    assert reports["full"]["prisms"] > len(F) > 5 * reports["simplified"]["prisms"] > 0
    assert reports["short"]["prisms"] > reports["simplified"]["prisms"]
    assert not np.array_equal(curves["thin"], curves["simplified"])


def test_explicit_options_win_over_the_preset_whatever_the_order(run, plate):
    def knots(*words):
        succeed(run("plate.ply", "--picks", "picks.json", "--output", "curve.json", "--report", "r.json", *words))
        spline = json.loads((plate / "curve.json").read_text())["spline"]
        return spline["degree"], spline["knots"], spline["control_points"]

    paper = knots("--preset", "paper")
    assert paper != knots()
    assert paper == knots("--preset", "paper", "--degree", "3")
    assert knots("--degree", "2", "--preset", "paper")[0] == 2
    assert knots("--preset", "default") == knots()


def test_the_same_command_gives_the_same_bytes(run, plate):
    succeed(run(*DEFAULT))
    first = (plate / "curve.ply").read_bytes()
    succeed(run(*DEFAULT))
    assert (plate / "curve.ply").read_bytes() == first


def test_spaces_and_unicode_in_paths(run, plate):
    folder = plate / "ein Ordner – 曲線"
    folder.mkdir()
    (plate / "plate.ply").rename(folder / "Plätte 1.ply")
    (plate / "picks.json").rename(folder / "punkte ✓.json")
    succeed(
        run(
            folder / "Plätte 1.ply",
            *("--picks", folder / "punkte ✓.json", "--output", folder / "Kurve 1.ply", "--report", folder / "b c.json"),
        )
    )
    assert read_curve(folder / "Kurve 1.ply")[0].shape[1] == 3
    assert json.loads((folder / "b c.json").read_text())["mesh"]["file"] == str(folder / "Plätte 1.ply")


def test_an_existing_output_is_replaced_and_nothing_else_is_left(run, plate):
    (plate / "curve.ply").write_text("old")
    succeed(run(*DEFAULT))
    assert read_curve(plate / "curve.ply")[0].shape[1] == 3
    assert sorted(p.name for p in plate.iterdir()) == ["curve.ply", "picks.json", "plate.ply"]


VERBS = ("batch", "curve", "cut", "edit", "field", "fill", "fit", "imprint", "offset", "pattern", "points", "segment", "shell")


def test_help_tells_all_verbs_on_one_screen(run):
    process = run("--help")
    assert (process.returncode, process.stderr) == (0, "") and process.stdout == run("help").stdout == run("-h").stdout
    lines = process.stdout.splitlines()
    assert len(lines) <= 24 and max(map(len, lines)) <= 80
    for verb in VERBS:
        assert any(line.startswith(f"  {verb} ") for line in lines)
        assert run(verb, "--help").returncode == 0


@pytest.mark.parametrize("words, said", [
    (("plate.ply", "--tensoin", "0.2"), "unknown argument --tensoin; did you mean --tension?"),
    (("plate.ply", "--lambada=0.2"), "unknown argument --lambada=0.2; did you mean --lambda?"),
    (("cut", "plate.ply", "--kep", "inside"), "unknown argument --kep; did you mean --keep?"),
    (("plate.ply", "--reapir"), "unknown argument --reapir (bspline_curve curve --help"),  # is hidden
    (("plate.ply", "--frobnicate"), "unknown argument --frobnicate (bspline_curve curve --help lists the options)"),
])
def test_a_mistyped_option_is_corrected(run, words, said):
    process = run(*words)
    assert process.returncode == 2 and said in process.stderr


def test_help_names_every_option_with_range_and_default(run):
    process = run("curve", "--help")
    assert process.returncode == 0 and process.stderr == ""
    for text in ("--picks", "--tension,--lambda", "[0, 1]", "--field-weight,--mu", "--degree", "[2, 4]", "--preset",
                 "--shell local|full|simplified|preset=", "--target-thickness", "--target-edge-length", "--shell-thickness", "edge lengths",
                 "--max-rounds", "Exit status"):
        assert text in process.stdout


def test_the_help_of_each_verb_is_in_groups(run):
    for verb in VERBS:
        groups = {}
        for line in run(verb, "--help").stdout.splitlines():
            if re.fullmatch(r"\w[\w ,-]*:", line):
                groups[line[:-1]] = []
            elif option := re.match(r"  (?:-h,)?--([a-z-]+)", line):
                list(groups.values())[-1].append(option[1])
        own = {name: flags for name, flags in groups.items() if name != "Options of curves, for --picks"}
        assert "quiet" in own["Output"] and "help" in own["Options"], (verb, groups)
        assert max(map(len, own.values())) <= 14, (verb, own)
    assert "report" in groups["Output"] and list(groups)[:2] == ["Positionals", "Options"]


def test_the_settings_of_the_paper_have_a_help_of_their_own(run):
    paper = {"quadrature", "barrier-width", "knot-rule", "alpha-min", "feature-tolerance", "gauss-points"}
    shown = {words: set(re.findall(r"^  --([a-z-]+)", run(*words).stdout, re.M)) for words in (
        ("curve", "--help"), ("--help", "paper"), ("curve", "--help", "paper"), ("help", "curve", "paper"), ("cut", "--help", "paper"))}
    assert not shown["curve", "--help"] & paper and {"preset", "distance-tolerance"} <= shown["curve", "--help"]
    assert "Settings of the paper: --help paper lists them" in run("curve", "--help").stdout
    for words in list(shown)[1:]:
        assert paper <= shown[words] and not shown[words] & shown["curve", "--help"], words
    assert run("field", "--help", "paper").stdout == run("field", "--help").stdout, "a verb without them"


def test_a_line_of_result_is_on_stdout_unless_quiet(run, plate):
    told = run.ok(*DEFAULT)
    points, _, _ = read_curve(plate / "curve.ply")
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    said = re.fullmatch(r"curve\.ply: an open curve, ([\d.]+) long, of (\d+) points\n", told.stdout)
    assert float(said[1]) == pytest.approx(length, rel=1e-3) and int(said[2]) == len(points) and told.stderr == ""
    quiet = run.ok(*DEFAULT, "--quiet")
    assert (quiet.stdout, quiet.stderr) == ("", "")
    noted = run.ok("cut", "plate.ply", "--curve", "curve.ply", "--output", "cut.ply", "--quiet")
    assert noted.stdout == "" and "note: " in noted.stderr, "notes stay"


def test_verbs_are_joined_by_standard_streams(program, run, plate):
    """Meshes are .ply there, all else is .json."""
    run.ok(*DEFAULT[:-1], "curve.json")
    run.ok("imprint", "plate.ply", "--curve", "curve.json", "--output", "imprinted.ply")
    line = '"$0" - --picks picks.json --output - < plate.ply | "$0" imprint plate.ply --curve - --output - > piped.ply'
    done = subprocess.run(["bash", "-eo", "pipefail", "-c", line, program], cwd=plate, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert (plate / "piped.ply").read_bytes() == (plate / "imprinted.ply").read_bytes()
    given = subprocess.run([program, "plate.ply", "--picks", "-", "--output", "-"], cwd=plate, input=(plate / "picks.json").read_bytes(),
                           capture_output=True)
    assert given.stdout == (plate / "curve.json").read_bytes()
    assert sorted(p.name for p in plate.iterdir()) == ["curve.json", "imprinted.ply", "picks.json", "piped.ply", "plate.ply"]


@pytest.mark.parametrize("words, said", [
    (("plate.ply", "--picks", "picks.json", "--output", "-", "--report", "-"), "standard output can take one file"),
    (("-", "--picks", "picks.json", "--output", "c.ply"), "the file is empty"),
])
def test_a_standard_stream_is_one_file(refused, plate, words, said):
    refused(1, *words, says=[said])


def test_standard_input_is_not_two_files(program, plate):
    words = [program, "-", "--picks", "-", "--output", "c.ply"]
    done = subprocess.run(words, cwd=plate, input=(plate / "picks.json").read_bytes(), capture_output=True)
    assert done.returncode == 1 and b"standard input is -.json already" in done.stderr


def test_standard_output_takes_no_series_and_a_batch_needs_files(run, refused, plate):
    run.ok(*DEFAULT[:-1], "curve.json")
    run.ok("imprint", "plate.ply", "--curve", "curve.json", "--output", "imprinted.ply")
    (plate / "jobs.csv").write_text("mesh,picks,output\nplate.ply,picks.json,-\n")
    refused(1, "batch", "jobs.csv", says=["a job needs files in place of -"])


@pytest.mark.parametrize("words, usage", [(("help", "curve"), "--picks"), (("help", "shell"), "--check"), (("help", "batch"), "--resume")])
def test_help_is_a_verb(run, words, usage):
    process = run(*words)
    assert (process.returncode, process.stderr) == (0, "") and usage in process.stdout
    assert process.stdout == run(*words[1:], "--help").stdout


def test_version(run):
    process = run("--version")
    assert process.returncode == 0 and process.stdout.startswith("bspline_curve ")


def test_the_verb_may_be_written_out(run, plate):
    succeed(run("curve", *DEFAULT))


# ---------------------------------------------------------------- terminal and Ctrl-C


def long_run(plate):
    """A command that takes many seconds."""
    meshes.write_ply(plate / "plate.ply", *meshes.plate(cells=60, height=0.1))
    picks = [[0.1, 0.2, 0.0], [0.5, 0.7, 0.1], [0.9, 0.3, 0.03]]
    V, _ = meshes.plate(cells=60, height=0.1)
    on_mesh = [V[np.linalg.norm(V - p, axis=1).argmin()].tolist() for p in picks]
    (plate / "picks.json").write_text(json.dumps({"picks": on_mesh}))
    return (*DEFAULT, "--repeat", "100000", "--report", "report.json")


def test_a_terminal_shows_progress_and_ctrl_c_leaves_no_files(program, plate):
    terminal, stderr = pty.openpty()
    process = subprocess.Popen([str(program), *long_run(plate)], cwd=plate, stderr=stderr, stdout=subprocess.DEVNULL)
    os.close(stderr)
    text, end = b"", time.monotonic() + 60
    while b"%" not in text and time.monotonic() < end:
        text += os.read(terminal, 4096)
    process.send_signal(signal.SIGINT)
    try:
        while block := os.read(terminal, 4096):
            text += block
    except OSError:  # the terminal closes with the process
        pass
    assert process.wait(timeout=60) == 130
    assert b"[" in text and b"%" in text
    assert b"interrupted" in text
    assert sorted(p.name for p in plate.iterdir()) == ["picks.json", "plate.ply"]


def test_ctrl_c_ends_also_what_looks_for_it_too_seldom(program, plate):
    long_run(plate)
    os.mkfifo(plate / "never.ply")  # reading waits for ever
    process = subprocess.Popen(
        [str(program), "never.ply", "--picks", "picks.json", "--output", "curve.json"],
        cwd=plate, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert out == "" and err == "bspline_curve: interrupted; nothing was written\n"
    assert sorted(p.name for p in plate.iterdir()) == ["never.ply", "picks.json", "plate.ply"]


@pytest.mark.parametrize("moment", [0.02, 0.05, 0.1, 0.15, 0.2, 0.3])
def test_ctrl_c_leaves_all_files_or_none(program, plate, moment):
    long_run(plate)
    process = subprocess.Popen(
        [str(program), *DEFAULT, "--report", "report.json", "--shell", "simplified"],
        cwd=plate, stderr=subprocess.PIPE, text=True, env=os.environ | {"XDG_CACHE_HOME": str(plate / "cache")},
    )
    time.sleep(moment)
    process.send_signal(signal.SIGINT)
    err = process.communicate(timeout=60)[1]
    names = {p.name for p in plate.rglob("*") if p.is_file()} - {"picks.json", "plate.ply"}
    assert not [name for name in names if name.endswith(".tmp")]
    written = names & {"curve.ply", "report.json"}
    if process.returncode == 130:
        assert "nothing was written" in err and not written
    else:
        assert process.returncode in (0, -signal.SIGINT)  # before the program listens
        assert len(written) == (2 if process.returncode == 0 else 0)


def test_a_pipe_shows_no_progress_and_ctrl_c_says_so_in_one_line(program, plate):
    process = subprocess.Popen(
        [str(program), *long_run(plate)], cwd=plate, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert out == "" and err.count("\n") == 1 and "interrupted" in err
    assert sorted(p.name for p in plate.iterdir()) == ["picks.json", "plate.ply"]
