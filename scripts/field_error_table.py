#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the field `maximal-curvature` with the curvature of known surfaces, as a Markdown table.

    scripts/field_error_table.py                          spheres, tori and cylinders, without and with noise
    scripts/field_error_table.py --page docs/FIELDS.md    writes the table into the page as well

Errors are root mean squares over the vertices, in units of the field; of a cylinder, over those farther than twice the scale
from its ends. Noise moves every coordinate by up to 10 % of a mean edge.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from shell_table import replace_table

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build" / "release" / "bin" / "bspline_curve"
UNIT = 20.0     # the field is curvature times the diagonal over this
SCALE = 0.015   # the default radius of averaging, in diagonals
NOISE = 0.1     # of a mean edge
SEED = 1


def midpoint_sphere(levels):
    """An icosahedron whose faces are split into four so often, with all vertices on the sphere."""
    golden = (1 + 5 ** 0.5) / 2
    vertices = [(x, y * golden, 0) for y in (-1, 1) for x in (-1, 1)]
    vertices = np.array([np.roll(vertex, turn) for turn in range(3) for vertex in vertices])
    edge = 2.0
    apart = np.linalg.norm(vertices[:, None] - vertices[None], axis=2)
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
             if max(apart[a, b], apart[b, c], apart[c, a]) < 1.01 * edge]
    faces = np.array([face if np.linalg.det(vertices[list(face)]) > 0 else face[::-1] for face in faces])
    for _ in range(levels):
        ends, index = np.unique(np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0, return_inverse=True)
        ab, bc, ca = (len(vertices) + index.reshape(-1, 3)).T
        a, b, c = faces.T
        faces = np.concatenate([np.stack(corners, 1) for corners in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
        vertices = np.concatenate([vertices, vertices[ends].mean(1)])
        vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return vertices / np.linalg.norm(vertices, axis=1, keepdims=True), faces


def grid_faces(rows, columns, rows_close):
    """Two triangles for each cell of a grid whose columns close to rings, and its rows as well where asked."""
    i, j = np.meshgrid(np.arange(rows if rows_close else rows - 1), np.arange(columns), indexing="ij")
    a, b = i * columns + j, (i + 1) % rows * columns + j
    c, d = (i + 1) % rows * columns + (j + 1) % columns, i * columns + (j + 1) % columns
    return np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def torus(around):
    """With the radii 1 and 0.3; the curvature across is the largest everywhere."""
    across = round(0.3 * around)
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    ring = 1 + 0.3 * np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), 0.3 * np.sin(v)], -1).reshape(-1, 3)
    return vertices, grid_faces(around, across, True)


def cylinder(around):
    """Of radius 1 and height 2, open."""
    rows = round(around / np.pi) + 1
    z, u = np.meshgrid(np.linspace(-1, 1, rows), np.arange(around) * 2 * np.pi / around, indexing="ij")
    vertices = np.stack([np.cos(u), np.sin(u), z], -1).reshape(-1, 3)
    return vertices, grid_faces(rows, around, False)[:, ::-1]


SURFACES = [  # name, curvature, meshes, or one of them where time is short
    ("sphere", 1.0, [(midpoint_sphere, level) for level in (3, 4, 5, 6, 7)]),
    ("torus, r = 0.3 R", 1 / 0.3, [(torus, count) for count in (100, 320)]),
    ("cylinder", 1.0, [(cylinder, count) for count in (80, 160)]),
]


def write_off(path, vertices, faces):
    with path.open("w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        np.savetxt(file, vertices, "%.17g")
        np.savetxt(file, np.column_stack([np.full(len(faces), 3), faces]), "%d")


def values_of(program, vertices, faces):
    with tempfile.TemporaryDirectory() as folder:
        mesh, output = Path(folder) / "mesh.off", Path(folder) / "field.npy"
        write_off(mesh, vertices, faces)
        subprocess.run([program, "field", mesh, "--kind", "maximal-curvature", "--output", output], check=True)
        return np.load(output)


def row_of(program, name, curvature, vertices, faces):
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    edge = np.linalg.norm(vertices[faces] - vertices[np.roll(faces, 1, axis=1)], axis=2).mean()
    exact = curvature * diagonal / UNIT
    inner = np.abs(vertices[:, 2]) < 1 - 2 * SCALE * diagonal if name == "cylinder" else slice(None)
    moved = vertices + NOISE * edge * np.random.default_rng(SEED).uniform(-1, 1, vertices.shape)
    errors = []
    for points in (vertices, moved):
        values = values_of(program, points, faces)
        scale = diagonal / np.linalg.norm(np.ptp(points, axis=0))  # of the noisy box
        errors.append(np.sqrt(np.mean((scale * values[inner] - exact) ** 2)))
    return f"| {name} | {edge / diagonal:.4f} | {exact:.3f} | {errors[0]:.4f} | {errors[1]:.3f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--quick", action="store_true", help="the coarsest mesh of each surface")
    parser.add_argument("--page", type=Path, help="puts the table between the markers of this page as well")
    given = parser.parse_args()
    lines = ["| surface | mean edge / diagonal | exact value | error | error with noise |", "|---|--:|--:|--:|--:|"]
    for name, curvature, meshes in SURFACES:
        for make, size in meshes[:1] if given.quick else meshes:
            lines.append(row_of(given.program, name, curvature, *make(size)))
    table = "\n".join(lines)
    print(table)
    if given.page:
        replace_table(given.page, "errors", table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
