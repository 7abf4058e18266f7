#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits smooth curves to shaky strokes and to the boundaries of labels.

    benchmarks/fits.py            50 strokes on each of four meshes; 30 labels on 300,000 faces
    benchmarks/fits.py --page     writes the tables into docs/SMOOTH_CURVES.md as well

Strokes: a curve of 200 points is known. Its points move sideways by noise with a standard deviation of 1 % of the diagonal, and
back onto the surface. A curve is fitted to them, with a deviation of 4 % of the diagonal. `off` is the root of the mean square
distance of the fitted curve from the known one, in % of the diagonal; `control points` those of its spline. Noise is white, or
smooth: correlated along the stroke by a Gaussian whose standard deviation is 1 % of the diagonal. Told are medians, and how many
strokes were refused: noise can carry points from one side of a thin limb to the other.
`least squares`: what a least-squares spline reaches whose number of control points is chosen by the known curve.

Labels: faces have the label of the nearest of 30 random points. Curves are fitted to all boundaries, and the mesh is parted along
them. `area`: the largest change of the area of a label, as a share of it. Needs requirements.txt and the package in
build/release/python.
"""
import argparse
import sys
import time
from pathlib import Path

import numpy as np
from cases import ROOT, bumpy_torus, machine, packaged_mesh, replace_table, resampled, write_json
from fills import diagonal, sphere
from scipy.interpolate import make_lsq_spline

sys.path.insert(0, str(ROOT / "build" / "release" / "python"))

import bspline_curve

POINTS = 200
NOISE, DEVIATION, CORRELATED = 0.01, 0.04, 0.01  # of the diagonal
LENGTHS = (0.4, 0.8)  # of known curves, in diagonals
CURVES = 10  # known ones on each mesh; each is drawn several times


# ---------------------------------------------------------------- strokes
def known_curve(mesh, random):
    """Through four points of a walk that bends."""
    while True:
        length = random.uniform(*LENGTHS) * diagonal(mesh)
        face = mesh.vertices[mesh.faces[random.integers(len(mesh.faces))]]
        at, normal = face.mean(0), np.cross(face[1] - face[0], face[2] - face[0])
        way = np.cross(normal, random.normal(size=3))
        picks = [at]
        for _ in range(3):
            turn = random.uniform(-0.7, 0.7)
            normal /= np.linalg.norm(normal)
            way = np.cos(turn) * way + np.sin(turn) * np.cross(normal, way)
            at = mesh.project((at + length / 3 * way / np.linalg.norm(way))[None]).points[0]
            way = at - picks[-1]
            picks.append(at)
        try:
            curve = mesh.curve(picks)
        except bspline_curve.InputError:
            continue
        if LENGTHS[0] < curve.length / diagonal(mesh) < LENGTHS[1]:
            return curve


def noise_of(kind, length, random, size):
    """Of points along a stroke, with a standard deviation of 1."""
    white = random.normal(size=POINTS)
    if kind == "white":
        return white
    along = np.linspace(0, length, POINTS)
    weights = np.exp(-0.5 * ((along[:, None] - along) / (CORRELATED * size)) ** 2)
    return weights @ white / np.linalg.norm(weights, axis=1)


def distances(points, line):
    """From points to a polyline."""
    starts, ways = line[:-1], np.diff(line, axis=0)
    share = ((points[:, None] - starts) * ways).sum(2) / np.maximum((ways**2).sum(1), 1e-300)
    feet = starts + np.clip(share, 0, 1)[:, :, None] * ways
    return np.linalg.norm(points[:, None] - feet, axis=2).min(1)


def off(line, known):
    return float(np.sqrt((distances(resampled(line, POINTS), known) ** 2).mean()))


def least_squares(stroke, known):
    """The best of least-squares splines, by the known curve."""
    along = np.linspace(0, 1, POINTS)
    results = []
    for count in range(4, 25):
        inner = np.linspace(0, 1, count - 2)[1:-1]
        spline = make_lsq_spline(along, stroke, np.concatenate([[0] * 4, inner, [1] * 4]), 3)
        results.append(off(spline(np.linspace(0, 1, 4 * POINTS)), known))
    return min(results)


def stroke_rows(copies, seed):
    meshes = {"bone": packaged_mesh("bone"), "bunny": packaged_mesh("bunny10k_textured"), "sphere": sphere(),
              "torus": bumpy_torus(240, 80)}
    for name, arrays in meshes.items():
        random = np.random.default_rng(seed)
        mesh = bspline_curve.Mesh(*arrays)
        size = diagonal(mesh)
        known = [known_curve(mesh, random) for _ in range(min(CURVES, copies))]
        for kind in ("white", "smooth"):
            told = {"off": [], "control points": [], "least squares": [], "seconds": []}
            refused = 0
            for copy in range(copies):
                curve = known[copy % len(known)]
                line = resampled(curve.points, POINTS)
                frames = curve.sample(POINTS)
                sideways = np.cross(frames.normals, frames.tangents)
                moves = NOISE * size * noise_of(kind, curve.length, random, size)
                stroke = mesh.project(frames.points + moves[:, None] * sideways).points
                start = time.perf_counter()
                try:
                    fitted = mesh.fit(stroke, deviation=DEVIATION * size)
                except bspline_curve.PickError:
                    refused += 1
                    continue
                told["seconds"].append(time.perf_counter() - start)
                told["off"].append(100 * off(fitted.points, line) / size)
                told["least squares"].append(100 * least_squares(stroke, line) / size)
                told["control points"].append(len(fitted.control_points))
            yield {"mesh": name, "noise": kind, "refused": refused} | {key: float(np.median(values)) for key, values in told.items()}


# ---------------------------------------------------------------- labels
def areas_of(vertices, faces):
    corners = vertices[faces]
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)


def label_row(around, across, count, seed):
    random = np.random.default_rng(seed)
    vertices, faces = bumpy_torus(around, across)
    mesh = bspline_curve.Mesh(vertices, faces)
    middles = vertices[faces].mean(1)
    seeds = middles[random.choice(len(faces), count, replace=False)]
    labels = np.linalg.norm(middles[:, None] - seeds, axis=2).argmin(1).astype(np.int32)
    mesh.curve(mesh.project(seeds[:2]).points)  # what is prepared once
    start = time.perf_counter()
    curves = mesh.fit_boundary(labels=labels)
    seconds = time.perf_counter() - start
    parted = mesh.segment(curves)
    # Each part has the label of most of its area.
    shares = np.zeros((parted.labels.max() + 1, count))
    np.add.at(shares, (parted.labels, labels[parted.parents]), areas_of(parted.vertices, parted.faces))
    before = np.bincount(labels, areas_of(vertices, faces), count)
    after = np.bincount(shares.argmax(1), shares.sum(1), count)
    ends = np.array([end for curve in curves if not curve.closed for end in (curve.points[0], curve.points[-1])])
    junctions = np.unique(ends, axis=0)
    apart = np.linalg.norm(junctions[:, None] - junctions, axis=2) + np.diag(np.full(len(junctions), np.inf))
    return {"faces": len(faces), "labels": count, "curves": len(curves), "seconds": seconds,
            "area": float((np.abs(after - before) / before).max()), "junctions": len(junctions),
            "nearest junctions": float(apart.min() / diagonal(mesh))}


# ---------------------------------------------------------------- results
def stroke_table(rows):
    lines = ["| mesh | noise | off, % | least squares, % | control points | ms | refused |", "|---|---|--:|--:|--:|--:|--:|"]
    lines += [f"| {row['mesh']} | {row['noise']} | {row['off']:.2f} | {row['least squares']:.2f} | {row['control points']:.0f} | "
              f"{1e3 * row['seconds']:.1f} | {row['refused']} |" for row in rows]
    on = machine()
    return "\n".join(lines) + f"\n\nOn {on['cores']} cores, {on['processor']}."


def label_text(row):
    return (f"{row['faces']:,} faces with {row['labels']} labels: {row['curves']} curves in {row['seconds']:.2f} s, "
            f"{row['junctions']} junctions, areas within {100 * row['area']:.2f} %.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two strokes on each mesh, few faces with labels")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--page", action="store_true", help="write the tables into docs/SMOOTH_CURVES.md as well")
    given = parser.parse_args()
    strokes = []
    for row in stroke_rows(2 if given.quick else 50, given.seed):
        strokes.append(row)
        print(f"{row['mesh']:8} {row['noise']:7} off {row['off']:.3f} % (least squares {row['least squares']:.3f}), "
              f"{row['control points']:.0f} control points, {1e3 * row['seconds']:.1f} ms, {row['refused']} refused", flush=True)
    labels = label_row(*((120, 40) if given.quick else (672, 224)), 8 if given.quick else 30, given.seed)
    print(label_text(labels))
    write_json(given.json, {"strokes": strokes, "labels": labels})
    if given.page:
        replace_table(ROOT / "docs" / "SMOOTH_CURVES.md", "strokes", stroke_table(strokes))
        replace_table(ROOT / "docs" / "SMOOTH_CURVES.md", "labels", label_text(labels))
    return 0


if __name__ == "__main__":
    sys.exit(main())
