# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb field, and fields of curves, as a user runs them; values against exact ones of simple surfaces."""

import json

import made_meshes as meshes
import meshio
import numpy as np
import pymeshlab
import pytest
from curve_files import read_ply, succeed

KINDS = ["normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance", "quality",
         "obstacle"]
COSTS = {"normal-variation": "square", "crease-distance": "square", "boundary-distance": "square",
         "quality": "identity", "obstacle": "identity"}


def folded_plate(cells=40):
    """A square plate folded upwards by 90 degrees along x = 0.5, with quality x; normals look into the fold."""
    V, F = meshes.plate(cells=cells)
    x = V[:, 0].copy()
    V[:, 0] = np.minimum(x, 0.5)
    V[:, 2] = np.maximum(x - 0.5, 0)
    return V, F, x


@pytest.fixture
def fold(tmp_path):
    """The folded plate in fold.ply, three picks in picks.json; returns vertices, faces, x when unfolded."""
    V, F, x = folded_plate()
    meshes.write_ply(tmp_path / "fold.ply", V, F, quality=x)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.3, 0.05, 0], [0.3, 0.95, 0]]}))
    return V, F, x


def made(run, folder, kind, *words, mesh="fold.ply"):
    succeed(run("field", mesh, "--kind", kind, "--output", "made.npy", *words))
    return np.load(folder / "made.npy")


def words_for(kind):
    return ("--region-over", "0.75") if kind == "obstacle" else ()


@pytest.mark.parametrize("kind", KINDS)
def test_every_format_holds_the_same_values_in_the_meshs_order(run, tmp_path, fold, kind):
    V, F, _ = fold
    values = made(run, tmp_path, kind, *words_for(kind))
    assert values.dtype == np.float64 and values.shape == (len(V),)
    succeed(run("field", "fold.ply", "--kind", kind, "--output", "made.txt", *words_for(kind)))
    assert np.array_equal(np.loadtxt(tmp_path / "made.txt"), values)
    succeed(run("field", "fold.ply", "--kind", kind, "--output", "made.ply", "--report", "r.json", *words_for(kind)))
    read = meshio.read(tmp_path / "made.ply")
    assert np.array_equal(read.point_data["quality"], values)
    assert np.array_equal(read.points, V) and np.array_equal(read.cells_dict["triangle"], F)
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(tmp_path / "made.ply"))
    assert np.array_equal(document.current_mesh().vertex_scalar_array(), values)
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["kind"] == kind and report["natural_cost"] == COSTS.get(kind, "exp-minus")
    assert report["minimum"] == values.min() and report["maximum"] == values.max()
    assert report["mean"] == pytest.approx(values.mean())
    assert report["seconds"]["field"] > 0 and report["mesh"]["vertices"] == len(V)


def test_values_are_those_of_a_fold(run, tmp_path, fold):
    V, F, x = fold
    onFold, onSide = np.abs(x - 0.5) < 1e-9, np.abs(x - 0.5) > 0.2
    inner = (V[:, 1] > 0.1) & (V[:, 1] < 0.9)
    assert np.abs(made(run, tmp_path, "normal-variation")[onFold & inner] - np.sqrt(0.5)).max() < 1e-9
    # Seen from inside the fold is concave.
    assert np.exp(-made(run, tmp_path, "valley"))[onFold & inner].max() < 0.1
    assert np.abs(made(run, tmp_path, "maximal-curvature")[onSide & inner]).max() < 1e-6
    assert made(run, tmp_path, "ridge").max() < 0.2
    diagonal = np.linalg.norm(np.ptp(V, axis=0))
    crease = made(run, tmp_path, "crease-distance", "--reach", "0.5")
    assert np.abs(crease - np.minimum(np.abs(x - 0.5) / (0.5 * diagonal), 1)).max() < 1e-9
    boundary = made(run, tmp_path, "boundary-distance", "--reach", "0.5")
    exact = np.min([x, 1 - x, V[:, 1], 1 - V[:, 1]], 0) / (0.5 * diagonal)
    assert np.abs(boundary - exact).max() < 0.02
    assert np.array_equal(made(run, tmp_path, "quality"), x)


def test_options_of_values(run, tmp_path, fold):
    _, _, x = fold
    assert np.allclose(made(run, tmp_path, "quality", "--inverted"), 1 - x, atol=1e-15)
    normalised = made(run, tmp_path, "quality", "--normalised")
    low, high = np.quantile(x, [0.01, 0.99])
    assert np.allclose(normalised, np.clip((x - low) / (high - low), 0, 1), atol=1e-12)
    smooth = made(run, tmp_path, "normal-variation", "--smoothing", "0.1")
    rough = made(run, tmp_path, "normal-variation")
    assert smooth.std() < 0.7 * rough.std() and smooth.min() > rough.min()
    wide = made(run, tmp_path, "valley", "--curvature-scale", "0.08")
    assert wide.max() < 0.7 * made(run, tmp_path, "valley").max()


def test_obstacles_by_ids_and_by_thresholds(run, tmp_path, fold):
    V, F, x = fold
    region = np.flatnonzero(x[F].mean(1) > 0.75)
    by_threshold = made(run, tmp_path, "obstacle", "--region-over", "0.75")
    np.save(tmp_path / "region.npy", region)
    (tmp_path / "region.txt").write_text("# ids\n" + " ".join(map(str, region[::-1])))
    for name in ("region.npy", "region.txt"):
        assert np.array_equal(made(run, tmp_path, "obstacle", "--region", name), by_threshold)
    assert by_threshold[x < 0.7].max() == 0 and by_threshold.max() > 0.5
    under = made(run, tmp_path, "obstacle", "--region-under", "0.25")
    assert under[x > 0.3].max() == 0 and under.max() > 0.5
    steeper = made(run, tmp_path, "obstacle", "--region-over", "0.75", "--obstacle-slope", "80", "--obstacle-value", "2")
    outside = by_threshold == 0
    inside = np.isin(np.arange(len(V)), F[region])
    assert np.allclose(steeper[inside], 2 + 80 * (by_threshold[inside] - 1), atol=1e-9)
    assert steeper[~inside].max() == 0 and outside[~inside].all()


def test_scales_do_not_change_fields(run, tmp_path, fold):
    V, F, x = fold
    meshes.write_ply(tmp_path / "metres.ply", V / 1000, F, quality=x)
    for kind in KINDS:
        values = made(run, tmp_path, kind, *words_for(kind))
        metres = made(run, tmp_path, kind, *words_for(kind), mesh="metres.ply")
        assert np.abs(values - metres).max() < 1e-6, kind


@pytest.mark.parametrize(
    "words, status, part",
    [
        (("--kind", "boredom"), 2, "normal-variation|maximal-curvature"),
        ((), 2, "--kind"),
        (("--kind", "obstacle"), 2, "--region, --region-under, --region-over"),
        (("--kind", "ridge", "--region-over", "1"), 2, "obstacle only"),
        (("--kind", "obstacle", "--region-over", "1", "--region-under", "0"), 2, "only one"),
        (("--kind", "ridge", "--curvature-scale", "2"), 2, "[0, 1]"),
        (("--kind", "crease-distance", "--crease-angle", "95"), 1, "95 degrees"),
        (("--kind", "crease-distance", "--reach", "0"), 2, "(0, 1]"),
        (("--kind", "obstacle", "--region-over", "7"), 1, "no faces"),
        (("--kind", "obstacle", "--region-over", "-1"), 1, "covers all of 1 component"),
        (("--kind", "obstacle", "--region", "none.txt"), 1, "none.txt"),
        (("--kind", "obstacle", "--region", "ids.txt"), 1, "9999"),
        (("--kind", "ridge", "--output", "made.obj"), 1, ".ply, .npy, .txt"),
        (("--kind", "ridge", "--output", "none/made.ply"), 1, "none/made.ply"),
    ],
)
def test_refusals(refused, tmp_path, fold, words, status, part):
    (tmp_path / "ids.txt").write_text("1 2 9999")
    refused(status, "field", "fold.ply", *(() if "--output" in words else ("--output", "made.ply")), *words, says=[part])


@pytest.mark.parametrize("verb", ["field", "curve"])
@pytest.mark.parametrize("words", [("quality",), ("obstacle", "region-over")])
def test_quality_that_is_not_there(run, tmp_path, fold, verb, words):
    V, F, _ = fold
    meshes.write_obj(tmp_path / "fold.obj", V, F)
    kind, prefix = ("--kind", "--") if verb == "field" else ("--field", "--field-")
    process = run(verb, "fold.obj", kind, words[0], "--output", "made.ply", *([prefix + words[1], "1"] if words[1:] else []),
                  *(["--picks", "picks.json"] if verb == "curve" else []))
    assert process.returncode == 1 and "fold.obj: has no per-vertex quality" in process.stderr


def test_mended_meshes_give_values_for_the_mesh_as_it_was(run, tmp_path, fold):
    V, F, x = fold
    V = np.vstack([V, [-1, 0, 0], [-1, -1, 0]])  # a face on the tip of vertex 0
    F = np.vstack([F, [0, len(V) - 2, len(V) - 1]])
    x = np.concatenate([x, [5, 6]])
    meshes.write_ply(tmp_path / "bad.ply", V, F, quality=x)
    refused = run("field", "bad.ply", "--kind", "quality", "--output", "made.ply", "--strict")
    assert refused.returncode == 1 and "1 vertex joins" in refused.stderr
    process = run("field", "bad.ply", "--kind", "quality", "--output", "made.ply", "--report", "r.json")
    assert process.returncode == 0 and "note: the mesh was mended: 1 vertex duplicated; --strict" in process.stderr
    read = meshio.read(tmp_path / "made.ply")
    assert np.array_equal(read.point_data["quality"], x) and np.array_equal(read.cells_dict["triangle"], F)
    assert len(json.loads((tmp_path / "r.json").read_text())["repair"]["duplicated_vertices"]) == 1


def test_merged_vertices_have_the_value_of_what_they_became(run, tmp_path, fold):
    V, F, x = fold
    a, b = F[700][:2]
    V[a] = V[b]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    words = ("--kind", "boundary-distance", "--output", "made.npy", "--report", "r.json", "--reach", "1")
    run.ok("field", "bad.ply", *words)
    merged = json.loads((tmp_path / "r.json").read_text())["repair"]["merged_vertices"]
    assert sorted(merged[0]) == sorted([a, b])
    values = np.load(tmp_path / "made.npy")
    assert values[a] == values[b] > 0 and len(values) == len(V)


# ---- fields of curves ----

CURVE = ("fold.ply", "--picks", "picks.json", "--output", "curve.ply", "--report", "r.json")


def drawn(run, folder, *words):
    process = run.ok(*CURVE, *words)
    vertex = read_ply(folder / "curve.ply")["vertex"]
    report = json.loads((folder / "r.json").read_text())
    assert process.stderr.splitlines() == [f"bspline_curve: note: {note}" for note in report["notes"]]
    return vertex, report


@pytest.mark.parametrize("kind", KINDS)
def test_a_field_by_kind_is_the_field_of_the_verb(run, tmp_path, fold, kind):
    V, F, _ = fold
    values = made(run, tmp_path, kind, *words_for(kind), "--normalised")
    words = [word.replace("--", "--field-") for word in (*words_for(kind), "--normalised")]
    vertex, report = drawn(run, tmp_path, "--field", kind, *words)
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert np.abs((values[F[vertex["face"]]] * weights).sum(1) - vertex["quality"]).max() < 1e-12
    field = report["field"]
    assert (field["kind"], field["cost"]) == (kind, COSTS.get(kind, "exp-minus"))
    assert 0 <= field["mean_cost"] <= 1 and isinstance(field["at_rest"], bool)
    assert report["seconds"]["field"] > 0


def test_a_file_is_a_quality_with_the_options_of_fields(run, tmp_path, fold):
    _, _, x = fold
    np.save(tmp_path / "x.npy", x)
    quality, report = drawn(run, tmp_path, "--field", "quality", "--field-inverted", "--mu", "5")
    from_file, _ = drawn(run, tmp_path, "--field", "x.npy", "--field-inverted", "--mu", "5")
    assert np.array_equal(quality, from_file)
    assert (report["field"]["kind"], report["field"]["cost"]) == ("quality", "identity")
    upwards, _ = drawn(run, tmp_path, "--field", "quality", "--mu", "5")
    assert upwards["x"].mean() < quality["x"].mean() - 0.01


def test_valleys_and_creases_draw_the_curve_into_the_fold(run, tmp_path, fold):
    straight, report = drawn(run, tmp_path, "--field", "none")
    assert report["field"] is None and report["seconds"]["field"] == 0
    # Far from the fold its curvature is 0, and so is the pull, unless it is smoothed wide.
    for words in (("valley", "--field-smoothing", "0.2"), ("crease-distance", "--field-reach", "0.5")):
        pulled, _ = drawn(run, tmp_path, "--field", *words, "--mu", "100")
        assert np.abs(straight["x"] - 0.3).max() < 1e-6
        assert pulled["x"].max() > 0.45, words


def test_obstacles_push_the_curve_away(run, tmp_path, fold):
    V, F, x = fold
    centres = np.stack([x, V[:, 1]], 1)[F].mean(1)
    np.save(tmp_path / "region.npy", np.flatnonzero(np.linalg.norm(centres - [0.27, 0.5], axis=1) < 0.12))
    inside = lambda vertex: np.hypot(vertex["x"] - 0.27, vertex["y"] - 0.5).min() < 0.1
    straight, _ = drawn(run, tmp_path, "--field", "none")
    pushed, _ = drawn(run, tmp_path, "--field", "obstacle", "--field-region", "region.npy")
    assert inside(straight) and not inside(pushed)


def test_the_cost_that_is_given_goes_before_the_natural_one(run, tmp_path, fold):
    _, report = drawn(run, tmp_path, "--field", "valley", "--field-cost", "square")
    assert (report["field"]["kind"], report["field"]["cost"]) == ("valley", "square")
    words = ("--field", "valley", "--field-region-over", "1")
    process = run(*CURVE, *words)
    assert process.returncode == 2 and "--field-region-over are for the field obstacle only" in process.stderr


# ---- the path that a curve starts from ----


@pytest.fixture
def road(tmp_path):
    """A plate where a road along y = 0.7 costs nothing, and all else as much everywhere; two picks beside the road."""
    V, F = meshes.plate(cells=40)
    meshes.write_ply(tmp_path / "plate.ply", V, F, quality=np.clip(np.abs(V[:, 1] - 0.7) / 0.1, 0, 1))
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.05, 0.5, 0], [0.95, 0.5, 0]]}))
    return tmp_path


def along(run, folder, *words):
    """Largest distance of the curve from the straight line between the picks, and its mean cost."""
    run.ok("plate.ply", "--picks", "picks.json", "--field", "quality", "--output", "curve.ply",
                  "--report", "r.json", *words)
    report = json.loads((folder / "r.json").read_text())
    return np.abs(read_ply(folder / "curve.ply")["vertex"]["y"] - 0.5).max(), report["field"]["mean_cost"]


def test_the_first_path_takes_the_road(run, road):
    away, cost = along(run, road)
    assert away > 0.15 and cost < 0.5
    assert along(run, road, "--field-guides-path", "on") == (away, cost)
    # Between the picks the field is flat, so nothing pulls a curve that starts there.
    away, cost = along(run, road, "--field-guides-path", "off")
    assert away < 1e-6 and abs(cost - 1) < 1e-6


def test_quality_is_followed_only_where_it_is_asked_for(run, road):
    draw = ["plate.ply", "--picks", "picks.json", "--output"]
    automatic = run(*draw, "auto.ply", "--field", "auto", "--report", "r.json")
    follows = "bspline_curve: note: the curve follows the quality of "
    assert automatic.stderr.startswith(follows + "plate.ply\n")
    assert json.loads((road / "r.json").read_text())["field"]["kind"] == "quality"
    assert follows not in run(*draw, "asked.ply", "--field", "quality").stderr
    y = [read_ply(road / name)["vertex"]["y"] for name in ("auto.ply", "asked.ply")]
    assert np.allclose(*y, rtol=0, atol=1e-9)
    assert "note" not in run(*draw, "none.ply").stderr
    assert np.abs(read_ply(road / "none.ply")["vertex"]["y"] - 0.5).max() < 1e-9


def test_the_option_is_on_or_off(run, road):
    process = run("plate.ply", "--picks", "picks.json", "--output", "curve.ply", "--field-guides-path", "yes")
    assert process.returncode == 2 and "yes is none of preset|off|on" in process.stderr
