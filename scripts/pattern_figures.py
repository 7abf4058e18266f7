#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of patterns in docs/COMMAND_LINE.md: a text along a curve on a torus, a drawing on a bunny, a border round
a torus.

    .cache/venv/bin/python scripts/pattern_figures.py [--output docs/images]

It runs the program that `cmake --build --preset release` leaves, in a folder that goes away, and prints what it reports.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image
from render_curve import MESH_COLOUR, camera, normalised, read_mesh, render, tube, vertex_normals

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build" / "release" / "bin" / "bspline_curve"
FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
RED, BLUE = np.array([0.78, 0.13, 0.07]), np.array([0.10, 0.25, 0.60])
SIZE = (640, 480)

# A gear with a hole and a star in it.
DRAWING = """<svg viewBox="-60 -60 120 120">
 <path d="{gear}"/><circle r="34"/>
 <path d="M0 -30 L7 -10 L28 -9 L11 4 L17 24 L0 12 L-17 24 L-11 4 L-28 -9 L-7 -10Z"/>
</svg>"""
BORDER = '<svg><path d="M0 0 V-3 H4 V-1 H2 V-2 H1 V0 H5"/><path d="M0 1.2 C1.5 2.2 3.5 0.2 5 1.2"/></svg>'


def gear(teeth=12, inner=44.0, outer=56.0):
    points = []
    for i in range(teeth):
        for share, radius in ((-0.28, inner), (-0.14, outer), (0.14, outer), (0.28, inner)):
            angle = 2 * np.pi * (i + share) / teeth
            points.append((radius * np.sin(angle), -radius * np.cos(angle)))
    return "M" + " L".join(f"{x:.3f} {y:.3f}" for x, y in points) + "Z"


def torus():
    return trimesh.creation.torus(1.0, 0.4, major_sections=120, minor_sections=60)


class Scene:
    """A mesh in a folder, and curves on it."""

    def __init__(self, folder, name, vertices, faces):
        self.folder, self.name = folder, name
        self.vertices, self.faces = np.asarray(vertices), np.asarray(faces)
        trimesh.Trimesh(self.vertices, self.faces, process=False).export(folder / f"{name}.ply")

    def run(self, *words):
        subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, check=True)

    def curve(self, name, picks, *words):
        (self.folder / "picks.json").write_text(json.dumps({"picks": np.asarray(picks).tolist()}))
        self.run(f"{self.name}.ply", "--picks", "picks.json", "--output", f"{name}.json", *words)
        return f"{name}.json"

    def pattern(self, *words):
        self.run("pattern", f"{self.name}.ply", "--output", "pattern.json", "--report", "report.json", *words)
        report = json.loads((self.folder / "report.json").read_text())
        ratios = [report["distortion"][end]["ratio"] for end in ("shortest", "longest")]
        print(f"{self.name}: {len(report['curves'])} curves, {report['seconds']['draw']:.2f} s, lengths {ratios[0]:.3f} to "
              f"{ratios[1]:.3f} of what was drawn, at most {report['largest_deviation']:.2g} off "
              f"(tolerance {report['tolerance']:.2g})")
        return self.lines("pattern.json")

    def lines(self, name):
        data = json.loads((self.folder / name).read_text())
        for curve in data.get("curves", [data]):
            points = np.array(curve["polyline"]["points"])
            yield np.vstack([points, points[:1]]) if curve["closed"] else points

    def picture(self, path, lines, view, up, radius, others=()):
        shapes = [(self.vertices, self.faces, vertex_normals(self.vertices, self.faces), MESH_COLOUR)]
        for group, colour, width in ((lines, RED, radius), (others, BLUE, 0.6 * radius)):
            for line in group:
                points, corners = tube(line, width, sides=8)
                shapes.append((points, corners, vertex_normals(points, corners), colour))
        pixels = render(shapes, camera(normalised(np.array(view, float)), up), SIZE, 3)
        Image.fromarray((pixels * 255 + 0.5).astype(np.uint8)).quantize(128).save(path, optimize=True)


def text_on_torus(folder, output):
    mesh = torus()
    scene = Scene(folder, "torus", mesh.vertices, mesh.faces)
    turns = np.linspace(np.radians(205), np.radians(335), 5)
    tilt = np.radians([40, 62, 48, 62, 40])
    picks = np.stack([(1 + 0.4 * np.cos(tilt)) * np.cos(turns), (1 + 0.4 * np.cos(tilt)) * np.sin(turns), 0.4 * np.sin(tilt)], 1)
    line = scene.curve("line", picks)
    lines = list(scene.pattern("--text", "straightest geodesics", "--font", FONT, "--along", line, "--shift", 0.03))
    scene.picture(output / "pattern-text.png", lines, (0, -0.75, 1.0), (0, 0, 1), 0.006, scene.lines(line))


def border_on_torus(folder, output):
    mesh = torus()
    scene = Scene(folder, "ring", mesh.vertices, mesh.faces)
    turns = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    tilt = np.radians(50)
    picks = np.stack([(1 + 0.4 * np.cos(tilt)) * np.cos(turns), (1 + 0.4 * np.cos(tilt)) * np.sin(turns),
                      np.full(6, 0.4 * np.sin(tilt))], 1)
    line = scene.curve("circle", picks, "--closed")
    (folder / "border.svg").write_text(BORDER)
    lines = list(scene.pattern("--drawing", "border.svg", "--along", line, "--repeat", 24))
    scene.picture(output / "pattern-border.png", lines, (0, -0.75, 1.0), (0, 0, 1), 0.006)


def drawing_on_bunny(folder, output):
    import pymeshlab

    bunny = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"
    vertices, faces, _ = read_mesh(bunny)
    scene = Scene(folder, "bunny", vertices, faces)
    (folder / "drawing.svg").write_text(DRAWING.format(gear=gear()))
    size = np.ptp(vertices, axis=0)
    low = vertices.min(axis=0)
    # A place on the side of the body.
    side = low + size * [0.62, 0.42, 1.0]
    near = np.argmax(vertices[:, 2] - 8 * np.linalg.norm(vertices[:, :2] - side[:2], axis=1))
    centre = ",".join(f"{x:.9g}" for x in vertices[near])
    lines = list(scene.pattern("--drawing", "drawing.svg", "--centre", centre, "--size", 0.42 * size.max(), "--smoothing", 5))
    scene.picture(output / "pattern-drawing.png", lines, (0.1, 0.15, 1.0), (0, 1, 0), 0.004 * size.max())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "images")
    output = parser.parse_args().output.resolve()
    for figure in (text_on_torus, border_on_torus, drawing_on_bunny):
        with tempfile.TemporaryDirectory() as folder:
            figure(Path(folder), output)


if __name__ == "__main__":
    main()
