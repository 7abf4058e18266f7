# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program refuses: exit status, one line that says what is wrong, and no output."""

import json
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pytest
from made_meshes import PICKS

ROOT = Path(__file__).resolve().parents[2]
CURVE = json.loads((ROOT / "filters" / "filters.json").read_text())["filters"][0]["parameters"]
DEFAULT = ("plate.ply", "--picks", "picks.json", "--output", "curve.ply")
pytestmark = pytest.mark.usefixtures("plate")


# ---------------------------------------------------------------- usage: 2


@pytest.mark.parametrize("words, part", [
    (("--frobnicate",), "--frobnicate"),
    (("one too many",), "one too many"),
    (("--degree", "5"), "[2, 4]"),
    (("--degree", "2.5"), "whole number"),
    (("--degree", "three"), "three"),
    (("--degree",), "--degree"),
    (("--lambda", "1.1"), "[0, 1]"),
    (("--tension", "nan"), "[0, 1]"),
    (("--mu", "inf"), "inf"),
    (("--field-cost", "cube"), "exp-minus"),
    (("--preset", "papr"), "papr"),
    (("--repeat", "-1"), "--repeat"),
    *((("--" + p["id"].replace("_", "-"), f"{p['min'] - 1:g}"), p["id"].replace("_", "-")) for p in CURVE if "min" in p and p["id"] != "tube_radius"),
])
def test_wrong_options(refused, words, part):
    assert part in refused(2, *DEFAULT, *words)


@pytest.mark.parametrize("left_out", ["plate.ply", "--picks", "--output"])
def test_missing_options(refused, left_out):
    words = list(DEFAULT)
    at = words.index(left_out)
    del words[at : at + (2 if left_out.startswith("--") else 1)]
    refused(2, *words)


def test_no_arguments_at_all(refused):
    refused(2)


# ---------------------------------------------------------------- files: 1


def test_missing_files(refused):
    assert "none.ply" in refused(1, "none.ply", *DEFAULT[1:])
    assert "none.json" in refused(1, "plate.ply", "--picks", "none.json", "--output", "curve.ply")
    assert "none.npy" in refused(1, *DEFAULT, "--field", "none.npy")


@pytest.mark.parametrize(
    "status, words, parts",
    [
        (2, ("shel", "plate.ply"), ["shel is neither a mesh file nor one of the verbs help|curve|", "did you mean shell?"]),
        (2, ("frobnicate", "plate.ply"), ["help|curve|fit|batch|imprint|cut|fill|segment|offset|pattern|edit|points|field|shell\n"]),
        (2, ("help", "bach"), ["did you mean batch?"]),
        (1, (*DEFAULT, "--field", "valey"), ["--field valey: there is no such file", "|valley|", "did you mean valley?"]),
        (1, (*DEFAULT, "--field", "none.npy"), ["none.npy: there is no such file", "|obstacle|auto\n"]),
        (1, (*DEFAULT, "--avoid", "selected"), ["--avoid selected: there is no such file", "over-threshold"]),
        (2, (*DEFAULT, "--shell", "ful"), ["ful is none of local|full|simplified|preset; did you mean full?"]),
    ],
)
def test_mistyped_words(refused, status, words, parts):
    refused(status, *words, says=parts)


@pytest.mark.parametrize("name, content, part", [
    ("a.ply", "", "empty"),
    ("a.txt", "v 0 0 0\n", ".txt"),
    ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"),
])
def test_meshes_that_are_none(refused, plate, name, content, part):
    (plate / name).write_text(content)
    assert part in refused(1, name, *DEFAULT[1:], "--strict")


@pytest.mark.parametrize("change, part", [(lambda V, F: (V, F[:0]), "faces"),
                                          (lambda V, F: (V[:0], F[:0]), "")])
def test_meshes_that_nothing_mends(refused, plate, change, part):
    meshes.write_ply(plate / "bad.ply", *change(*meshes.plate(cells=4)))
    assert part in refused(1, "bad.ply", *DEFAULT[1:])


@pytest.mark.parametrize("name, text, part", [
    ("a.pp", "<PickedPoints>\n<point x='1' y='2'/>\n</PickedPoints>", "line 2"),
    ("a.json", '{"picks": [[0, 0]]}', "pick 1"),
    ("a.doc", "0 0 0\n", ".doc"),
])
def test_picks_files_that_are_none(refused, plate, name, text, part):
    (plate / name).write_text(text)
    assert part in refused(1, "plate.ply", "--picks", name, "--output", "curve.ply")


@pytest.mark.parametrize(
    "picks, words, part",
    [
        (PICKS[:1], (), "1"),
        (PICKS[:2], ("--closed",), "3"),
        ([PICKS[0], [0.5, 0.5, 0.5]], (), "1"),
        ([PICKS[1], PICKS[1]], (), "leaves 1 point"),
        ([PICKS[0], PICKS[1], PICKS[1], PICKS[0]], ("--closed",), "needs 3"),
    ],
)
def test_picks_that_cannot_be_met(refused, plate, picks, words, part):
    (plate / "picks.json").write_text(json.dumps({"picks": picks}))
    line = refused(1, *DEFAULT, *words)
    assert "pick" in line and part in line


def test_picks_on_different_components(refused, plate):
    V, F = meshes.plate(cells=6)
    meshes.write_ply(plate / "two.ply", np.vstack([V, V + [2, 0, 0]]), np.vstack([F, F + len(V)]))
    (plate / "picks.json").write_text(json.dumps({"picks": [PICKS[0], [2.5, 0.5, 0.0]]}))
    assert "component" in refused(1, "two.ply", *DEFAULT[1:])


@pytest.mark.parametrize(
    "output, part",
    [("none/curve.ply", "does not exist"), ("curve.txt", ".txt"), ("curve", "extension"), ("folder.ply", "directory")],
)
def test_outputs_that_cannot_be_written(refused, plate, output, part):
    (plate / "folder.ply").mkdir()
    assert part in refused(1, "plate.ply", "--picks", "picks.json", "--output", output)
    assert "plate" not in refused(1, "none.ply", "--picks", "none.json", "--output", output), "checked before any work"


def test_reports_that_cannot_be_written(refused):
    assert "report.txt" in refused(1, *DEFAULT, "--report", "report.txt")
    assert "none/r.json" in refused(1, *DEFAULT, "--report", "none/r.json")


@pytest.mark.parametrize(
    "values, part", [(np.zeros(5), "5 values"), (np.full(169, np.nan), "finite"), (np.zeros((169, 2)), "dimension")]
)
def test_fields_that_do_not_fit(refused, plate, values, part):
    np.save(plate / "field.npy", values)
    assert part in refused(1, *DEFAULT, "--field", "field.npy")


def test_quality_of_a_mesh_without(refused):
    assert "quality" in refused(1, *DEFAULT, "--field", "quality")


def test_a_curve_that_is_not_usable_is_written_unless_a_usable_one_is_required(run, plate):
    V, F = meshes.plate(cells=8, height=0.4)
    meshes.write_ply(plate / "hill.ply", V, F)
    (plate / "picks.json").write_text(json.dumps({"picks": V[[10, 40, 70]].tolist()}))
    effort = ("--max-rounds", 1, "--max-iterations", 1, "--distance-tolerance", 1e-9)
    for required in ((), ("--require-usable",)):
        (plate / "curve.ply").unlink(missing_ok=True)
        process = run("hill.ply", *DEFAULT[1:], "--report", "report.json", *effort, *required)
        assert process.returncode == len(required)
        assert "not usable" in process.stderr and process.stderr.count("\n") == 1
        assert (plate / "curve.ply").exists() == (not required)
    assert json.loads((plate / "report.json").read_text())["usable"] is False


def test_a_failure_leaves_an_existing_output_as_it_was(refused, plate):
    (plate / "curve.ply").write_text("precious")
    refused(1, "none.ply", *DEFAULT[1:])  # the fixture compares all files
    (plate / "picks.json").write_text(json.dumps({"picks": [[5, 5, 5], PICKS[1]]}))
    refused(1, *DEFAULT)


def test_line_ends_in_names_stay_within_one_line(refused):
    refused(1, "no\nsuch.ply", *DEFAULT[1:])
