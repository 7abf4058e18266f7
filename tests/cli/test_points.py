# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb points: points at equal steps along curves, with frame and curvature, and back as picks."""

import csv
import json

import made_meshes as meshes
import numpy as np
import pytest

RADIUS = 0.3


def rows_of(path):
    with open(path, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def columns(rows, *names):
    return np.array([[row[name] for name in names] for row in rows])


@pytest.fixture
def ring(run, tmp_path):
    """A closed curve near a circle on a flat plate, counterclockwise, and a straight line."""
    meshes.write_ply(tmp_path / "plate.ply", *meshes.plate(cells=16))
    angles = 2 * np.pi * np.arange(24) / 24
    picks = np.stack([0.5 + RADIUS * np.cos(angles), 0.5 + RADIUS * np.sin(angles), 0 * angles], 1)
    (tmp_path / "ring.json").write_text(json.dumps({"picks": picks.tolist(), "closed": True}))
    (tmp_path / "line.json").write_text(json.dumps({"picks": [[0.1, 0.5, 0], [0.9, 0.5, 0]]}))
    for name in ("ring", "line"):
        run.ok("plate.ply", "--picks", f"{name}.json", "--output", f"{name}-curve.json")
    return tmp_path


def test_points_of_a_circle_have_its_frame_and_curvature(run, ring):
    run.ok("points", "plate.ply", "--curve", "ring-curve.json", "--count", 36, "--output", "points.csv")
    rows = rows_of(ring / "points.csv")
    assert [row["number"] for row in rows] == list(range(1, 37))
    steps = np.diff([row["distance"] for row in rows])
    assert np.ptp(steps) < 1e-12 and abs(36 * steps[0] / (2 * np.pi * RADIUS) - 1) < 2e-3
    out = columns(rows, "x", "y", "z") - [0.5, 0.5, 0]
    assert np.abs(np.linalg.norm(out, axis=1) / RADIUS - 1).max() < 2e-3
    tangents, normals, left = (columns(rows, *(f"{name}_{axis}" for axis in "xyz")) for name in ("tangent", "normal", "left"))
    assert np.allclose(normals, [0, 0, 1], atol=1e-12)
    assert np.abs((tangents * out).sum(1)).max() < 0.02 * RADIUS
    assert np.allclose(left, np.cross(normals, tangents), atol=1e-12)
    curvature = columns(rows, "curvature", "normal_curvature", "geodesic_curvature")
    assert np.abs(curvature[:, [0, 2]] * RADIUS - 1).max() < 0.05  # counterclockwise: it turns to the left
    assert np.abs(curvature[:, 1]).max() < 1e-6
    V, F = meshes.plate(cells=16)
    places = (V[F[columns(rows, "face").astype(int)[:, 0]]] * columns(rows, "b0", "b1", "b2")[..., None]).sum(1)
    assert np.allclose(places, columns(rows, "x", "y", "z"), rtol=0, atol=1e-12)


def test_without_a_spline_curvature_is_measured_on_the_polyline(run, ring):
    run.ok("plate.ply", "--picks", "ring.json", "--output", "ring.ply")
    run.ok("points", "plate.ply", "--curve", "ring.ply", "--count", 36, "--output", "points.csv")
    assert np.abs(columns(rows_of(ring / "points.csv"), "curvature") * RADIUS - 1).max() < 0.25


def test_open_curves_have_points_at_both_ends_and_at_given_distances(run, refused, ring):
    run.ok("points", "plate.ply", "--curve", "line-curve.json", "--count", 5, "--output", "points.csv")
    assert np.allclose(columns(rows_of(ring / "points.csv"), "x")[:, 0], [0.1, 0.3, 0.5, 0.7, 0.9], rtol=0, atol=1e-9)
    run.ok("points", "plate.ply", "--curve", "line-curve.json", "--distances", "0,0.05,0.8", "--output", "points.csv")
    assert np.allclose(columns(rows_of(ring / "points.csv"), "x", "curvature"), [[0.1, 0], [0.15, 0], [0.9, 0]], atol=1e-9)
    refused(1, "points", "plate.ply", "--curve", "line-curve.json", "--distances", "0.9", "--output", "a.csv",
            says=["0.9 is not on the curve, which is 0.8 long"])
    refused(1, "points", "plate.ply", "--curve", "line-curve.json", "--count", 1, "--output", "a.csv", says=["must be 2 or more"])
    refused(2, "points", "plate.ply", "--curve", "line-curve.json", "--output", "a.csv", says=["one of --count"])
    refused(1, "points", "plate.ply", "--curve", "line-curve.json", "--count", 5, "--output", "a.doc", says=[".fcsv"])


@pytest.mark.parametrize("end", ["csv", "json", "mrk.json", "fcsv", "pp", "xyz"])
def test_picks_go_out_and_come_back_in_every_format(run, ring, end):
    run.ok("points", "plate.ply", "--curve", "ring-curve.json", "--at-picks", "--output", f"back.{end}")
    closed = [] if end in ("json", "mrk.json") else ["--closed"]
    run.ok("plate.ply", "--picks", f"back.{end}", *closed, "--output", "again.json")
    first, again = (json.loads((ring / name).read_text()) for name in ("ring-curve.json", "again.json"))
    assert again["closed"]
    picks = [np.array(d["polyline"]["points"])[d["polyline"]["picks"]] for d in (first, again)]
    assert np.allclose(*picks, rtol=0, atol=1e-12)
