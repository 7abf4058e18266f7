# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb fit: smooth curves along polylines, boundaries of faces and of labels."""

import json

import made_meshes as meshes
import numpy as np
import pytest


@pytest.fixture
def plate(tmp_path):
    V, F = meshes.plate(cells=30)
    meshes.write_ply(tmp_path / "plate.ply", V, F)
    return V, F, V[F].mean(1)[:, :2]


def curve(path):
    return json.loads(path.read_text())


def distances(points, line):
    """Of points to a closed polyline."""
    a, u = line, np.roll(line, -1, 0) - line
    t = np.clip(((points[:, None] - a) * u).sum(2) / (u * u).sum(1), 0, 1)
    return np.linalg.norm(points[:, None] - a - t[..., None] * u, axis=2).min(1)


def test_a_jagged_line_becomes_a_smooth_curve_within_the_deviation(run, plate, tmp_path):
    steps = [(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)]
    line = []
    for (x, y), (u, v) in zip(steps, steps[1:] + steps[:1]):
        line += [(x + (u - x) * k / 12 + 0.01 * (k % 2), y + (v - y) * k / 12 - 0.01 * (k % 2), 0) for k in range(12)]
    line = np.array(line)
    (tmp_path / "line.obj").write_text(
        "".join("v %.17g %.17g %.17g\n" % tuple(p) for p in line) + "l " + " ".join(str(i + 1) for i in [*range(len(line)), 0]) + "\n"
    )
    run.ok("fit", "plate.ply", "--line", "line.obj", "--deviation", "0.03", "--output", "c.json", "--report", "r.json")
    drawn = curve(tmp_path / "c.json")
    assert drawn["closed"]
    points = np.array(drawn["polyline"]["points"])
    farthest = distances(points, line).max()
    report = curve(tmp_path / "r.json")
    assert farthest <= report["curves"][0]["deviation"] * (1 + 1e-9) <= 0.03
    assert report["curves"][0]["usable"] and report["notes"] == []
    run.ok("imprint", "plate.ply", "--curve", "c.json", "--output", "imprinted.ply")


def test_corners_are_told_and_can_be_switched_off(run, plate, tmp_path):
    V, F, middles = plate
    a, b = (middles - 0.5) @ np.array([[1, 1], [1, -1]]) / np.sqrt(2), 0.25
    inside = np.flatnonzero((np.abs(a) < b).all(1))
    (tmp_path / "faces.txt").write_text(" ".join(map(str, inside)))
    fit = ("fit", "plate.ply", "--selection", "faces.txt", "--output", "c.json", "--report", "r.json")
    for words, count in (((), 4), (("--corner-angle", "180"), 0)):
        run.ok(*fit, *words)
        corners = curve(tmp_path / "r.json")["curves"][0]["corners"]
        assert len(corners) == count and all(60 <= each["turn"] <= 120 for each in corners)
        spline = curve(tmp_path / "c.json")["spline"]
        assert all(spline["knots"].count(spline["pick_parameters"][each["pick"]]) >= 3 for each in corners)


def test_the_boundary_of_a_selection(run, plate, tmp_path):
    V, F, middles = plate
    inside = np.flatnonzero(np.linalg.norm(middles - 0.5, axis=1) < 0.3)
    (tmp_path / "faces.txt").write_text(" ".join(map(str, inside)))
    run.ok("fit", "plate.ply", "--selection", "faces.txt", "--output", "c.json")
    points = np.array(curve(tmp_path / "c.json")["polyline"]["points"])
    radii = np.linalg.norm(points[:, :2] - 0.5, axis=1)
    assert np.sqrt(((radii - 0.3) ** 2).mean()) < 0.2 / 30


def test_labels_give_each_boundary_once_and_keep_junctions(run, plate, tmp_path):
    V, F, middles = plate
    angle = np.arctan2(*(middles - 0.5).T)
    labels = np.where(np.linalg.norm(middles - 0.5, axis=1) < 0.25, 9, np.floor((angle + np.pi) / (2 * np.pi / 3)).astype(int))
    np.save(tmp_path / "labels.npy", labels.astype(np.int64))
    said = run.ok("fit", "plate.ply", "--labels", "labels.npy", "--output", "c.json", "--report", "r.json")
    report = curve(tmp_path / "r.json")
    assert len(report["curves"]) == 6 and not any(c["closed"] for c in report["curves"])  # three spokes, three arcs
    ends = []
    for i in range(6):
        points = curve(tmp_path / ("c.json" if i == 0 else f"c-{i + 1}.json"))["polyline"]["points"]
        ends += [tuple(points[0]), tuple(points[-1])]
    counts = sorted(ends.count(end) for end in set(ends))
    assert counts == [1, 1, 1, 3, 3, 3]
    assert said.stdout == "c.json: 6 curves, the last in c-6.json\n"


def test_labels_keep_their_areas_and_junctions(run, tmp_path):
    V, F = meshes.plate(cells=120)
    middles = V[F].mean(1)[:, :2]
    seeds = np.random.default_rng(3).uniform(0.05, 0.95, (12, 2))
    labels = np.linalg.norm(middles[:, None] - seeds, axis=2).argmin(1)
    meshes.write_ply(tmp_path / "fine.ply", V, F)
    np.save(tmp_path / "labels.npy", labels.astype(np.int64))
    run.ok("fit", "fine.ply", "--labels", "labels.npy", "--output", "c.json")
    names = sorted(path.name for path in tmp_path.glob("c*.json"))
    ends = [curve(tmp_path / name)["polyline"]["points"][i] for name in names for i in (0, -1)]
    inner = [tuple(end) for end in ends if 1e-6 < min(*end[:2], 1 - end[0], 1 - end[1])]
    assert len(inner) >= 30 and all(inner.count(end) >= 3 for end in inner)
    run.ok("segment", "fine.ply", *(word for name in names for word in ("--curve", name)), "--output", "p.ply", "--table", "p.csv")
    table = np.genfromtxt(tmp_path / "p.csv", delimiter=",", names=True)
    # The faces of a part have mostly the label whose seed is nearest to its middle.
    centres = np.stack([table["centroid_x"], table["centroid_y"]], 1)
    found = np.bincount(np.linalg.norm(centres[:, None] - seeds, axis=2).argmin(1), table["area"], minlength=12)
    np.testing.assert_allclose(found, np.bincount(labels, minlength=12) / len(F), rtol=0.01)


def test_lines_without_a_curve_so_near_are_refused_with_their_name(run, refused, plate, tmp_path):
    V, F, middles = plate
    inside = np.flatnonzero(np.linalg.norm(middles - 0.5, axis=1) < 0.3)
    (tmp_path / "faces.txt").write_text(" ".join(map(str, inside)))
    refused(1, "fit", "plate.ply", "--selection", "faces.txt", "--deviation", "1e-6", "--output", "c.json", says=["boundary 1 of the faces", "larger deviation"])
    refused(2, "fit", "plate.ply", "--selection", "faces.txt", "--corner-angle", "0", "--output", "c.json", says=["corner_angle"])
    refused(2, "fit", "plate.ply", "--output", "c.json", says=["--line, --selection and --labels"])
    refused(2, "fit", "plate.ply", "--selection", "faces.txt", "--deviation", "much", "--output", "c.json", says=["deviation"])
    (tmp_path / "labels.txt").write_text("1 2 3")
    refused(1, "fit", "plate.ply", "--labels", "labels.txt", "--output", "c.json", says=["3 labels", f"{len(F)} faces"])
    np.save(tmp_path / "one.npy", np.zeros(len(F), np.int64))
    refused(1, "fit", "plate.ply", "--labels", "one.npy", "--output", "c.json", says=["no line"])
    assert not (tmp_path / "c.json").exists()


def test_lines_are_draped_along_a_direction_first(run, refused, tmp_path):
    """Plans far above a hill, one of which leaves it: their shadows, smooth."""
    V, F = meshes.plate(height=0.2, cells=30)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    ring = np.c_[0.5 + 0.3 * np.cos(angles), 0.5 + 0.3 * np.sin(angles), 7 + np.cos(5 * angles)]
    beyond = [[0.1, 0.9, 4], [0.2, 0.95, 4], [1.4, 0.95, 4]]
    (tmp_path / "plan.obj").write_text(
        "".join("v %.17g %.17g %.17g\n" % tuple(p) for p in [*ring, *beyond])
        + "l " + " ".join(map(str, [*range(1, 61), 1])) + "\nl 61 62 63\n"
    )
    fit = ("fit", "hill.ply", "--line", "plan.obj", "--output", "c.json")
    refused(1, *fit, says=["line 1 of plan.obj", "vertex 0 lies 7.8", "a direction to drape it along"])
    note = run.ok(*fit, "--direction", "0,0,-1").stderr
    assert "2 lines to fit: along the direction it is beside the mesh 1 time" in note
    drawn = curve(tmp_path / "c.json")
    assert drawn["closed"] and not curve(tmp_path / "c-2.json")["closed"]
    points = np.array(drawn["polyline"]["points"])
    assert np.abs(np.hypot(*(points[:, :2] - 0.5).T) - 0.3).max() < 0.01
    end = np.array(curve(tmp_path / "c-2.json")["polyline"]["points"])[-1]
    assert end[0] == pytest.approx(1, abs=1e-9)
    refused(1, *fit, "--direction", "1,0,0", says=["nothing of it meets"])
    refused(2, *fit, "--direction", "0,0,0", says=["not all 0"])
    refused(2, "fit", "hill.ply", "--selection", "f.txt", "--direction", "0,0,1", "--output", "c.json", says=["--line"])
