#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of docs/USING_CURVES.md: what curves are used for, with the program alone.

    .cache/venv/bin/python scripts/using_curves_figures.py [--only NAME] [--output docs/images]

Meshes are those that pymeshlab's wheel ships, and a plaque with a relief made by a rule.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "scripts"))
sys.path.insert(0, str(ROOT / "benchmarks"))
from cases import packaged_mesh, write_ply  # noqa: E402
from random_curves import Mesh, section_by  # noqa: E402
from random_imprints import read_result  # noqa: E402
from render_curve import camera, normalised, render, tube, vertex_normals  # noqa: E402

PROGRAM = ROOT / "build" / "release" / "bin" / "bspline_curve"
STONE, RED, BLUE, NEW = (0.72, 0.73, 0.75), (0.80, 0.13, 0.10), (0.10, 0.35, 0.75), (0.55, 0.75, 0.55)
SUPERSAMPLING = 3


# ---------------------------------------------------------------- meshes and picks
def plaque(cells=160):
    """A plate with a raised star of five points, whose sides are steep and whose top is rounded."""
    x = np.linspace(-1, 1, cells + 1)
    u, v = np.meshgrid(x, x, indexing="ij")
    turn, away = np.arctan2(v, u), np.hypot(u, v)
    rim = 0.50 + 0.17 * np.cos(5 * turn)
    inside = 1 / (1 + np.exp(-(rim - away) / 0.012))
    height = inside * (0.10 + 0.06 * np.sqrt(np.clip(1 - (away / 0.75) ** 2, 0, 1))) + 0.03 * np.sin(2 * u) * np.cos(2 * v)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1, 1)
    faces = np.concatenate([corner + [0, cells + 1, cells + 2], corner + [0, cells + 2, 1]])
    return np.stack([u, v, height], -1).reshape(-1, 3), faces


def ring_picks(vertices, faces, point, normal, count):
    """Points of the section of a mesh through the place nearest to a point, across a direction."""
    mesh = Mesh(vertices, faces)
    middles = vertices[faces].mean(1)
    for nudge in (0.0, 1e-7, -1e-7):
        near = int(np.linalg.norm(middles - point, axis=1).argmin())
        heights = (vertices - middles[near]) @ np.asarray(normal) + nudge
        found = section_by(mesh, heights, near)
        if found is not None:
            break
    line = np.array([mesh.position(p) for p in found[0]])
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(np.vstack([line, line[:1]]), axis=0), axis=1))])
    return line[[int(np.searchsorted(way, way[-1] * k / count)) % len(line) for k in range(count)]]


def cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def seen_at(vertices, faces, view, places):
    """The points of a mesh that are seen from a side at places of the picture, which is 1 wide or high."""
    frame = camera(view, (0, 1, 0))
    seen = vertices @ frame.T
    low, span = seen.min(0), np.ptp(seen[:, :2], axis=0).max()
    a, b, c = (seen[faces[:, k]] for k in range(3))
    area = cross(b - a, c - a)
    found = []
    for place in np.atleast_2d(places):
        p = np.append(low[:2] + span * place, 0)
        weights = np.stack([cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)], 1)
        weights /= np.where(area == 0, np.inf, area)[:, None]
        over = np.flatnonzero((weights.min(1) >= 0) & (area != 0))
        depth = (weights[over] * np.stack([a[over, 2], b[over, 2], c[over, 2]], 1)).sum(1)
        best = over[depth.argmax()]
        found.append(weights[best] @ vertices[faces[best]])
    return np.array(found)


def circle(at, reach, count):
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.asarray(at) + reach * np.stack([np.cos(turn), np.sin(turn)], 1)


# ---------------------------------------------------------------- the program
class Work:
    """A folder with one mesh, and runs of the program on it."""

    def __init__(self, folder, vertices, faces):
        self.folder, self.vertices, self.faces = Path(folder), vertices, faces
        write_ply(self.folder / "mesh.ply", vertices, faces)

    def run(self, verb, *words):
        done = subprocess.run([str(PROGRAM), verb, str(self.folder / "mesh.ply"), *map(str, words)], capture_output=True,
                              text=True, cwd=self.folder)
        if done.returncode != 0:
            sys.exit(f"{verb}: {done.stderr}")
        return done

    def picks(self, name, points, closed=True):
        (self.folder / name).write_text(json.dumps({"picks": np.asarray(points).tolist(), "closed": closed}))
        return self.folder / name

    def curve(self, name, points, *options, closed=True):
        """Draws one; the points of its polyline, closed."""
        self.run("curve", "--picks", self.picks(name + ".picks.json", points, closed), "--output", name + ".json", *options)
        return self.line(name + ".json")

    def line(self, name):
        told = json.loads((self.folder / name).read_text())
        points = np.array(told["polyline"]["points"])
        return np.vstack([points, points[:1]]) if told["closed"] else points

    def mesh(self, name):
        vertices, _, faces, labels = read_result(self.folder / name)
        return vertices, faces, labels


# ---------------------------------------------------------------- pictures
def surface(vertices, faces, colour=STONE):
    """A shape to render; one colour, or one for each face, whose corners are then its own."""
    normals = vertex_normals(vertices, faces)
    if np.ndim(colour) == 1:
        return vertices, faces, normals, np.array(colour)
    corners = faces.ravel()
    return vertices[corners], np.arange(len(corners)).reshape(-1, 3), normals[corners], np.repeat(colour, 3, axis=0)


def line_shape(points, radius, colour=RED):
    vertices, faces = tube(points, radius)
    return vertices, faces, vertex_normals(vertices, faces), np.array(colour)


def picture(shapes, view, size, window=None, up=(0, 1, 0)):
    """`window`: middle and half the height of what is seen, in the mesh's own coordinates."""
    frame = camera(view, up)
    if window is not None:
        middle, half = frame @ np.asarray(window[0]), window[1]
        reach = np.array([half * size[0] / size[1], half, 1e6])
        window = (middle - reach, middle + reach)
    image = render(shapes, frame, size, SUPERSAMPLING, window)
    return (image * 255 + 0.5).astype(np.uint8)


def hues(count):
    """Colours that are told apart."""
    turn = (np.arange(count) * 0.381966) % 1.0
    wheel = np.clip(np.abs((turn[:, None] * 6 + [0, 4, 2]) % 6 - 3) - 1, 0, 1)
    return 0.35 + 0.5 * wheel


def hole(folder):
    """A patch of the bunny is cut away and the hole filled smoothly."""
    vertices, faces = packaged_mesh("bunny")
    work = Work(folder, vertices, faces)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    view = (0.25, 0.25, 1.0)
    picks = seen_at(vertices, faces, view, circle((0.62, 0.3), 0.12, 6))
    line = work.curve("ring", picks)
    work.run("cut", "--curve", "ring.json", "--keep", "largest", "--output", "open.ply")
    work.run("cut", "--curve", "ring.json", "--keep", "largest", "--fill", "smooth", "--output", "filled.ply")
    opened, closed = work.mesh("open.ply"), work.mesh("filled.ply")
    colours = np.where(closed[2][:, None] < 0, NEW, STONE)
    return [picture(shapes, view, (420, 420)) for shapes in (
        [surface(vertices, faces), line_shape(line, 0.004 * size)],
        [surface(*opened[:2])],
        [surface(*closed[:2], colours)])]


def outlined(folder):
    """The plaque and a curve along the foot of its star."""
    vertices, faces = plaque()
    work = Work(folder, vertices, faces)
    turn = np.arange(20) * np.pi / 10
    away = 0.50 + 0.17 * np.cos(5 * turn) + 0.035
    picks = np.stack([away * np.cos(turn), away * np.sin(turn)], 1)
    near = [vertices[np.linalg.norm(vertices[:, :2] - p, axis=1).argmin()] for p in picks]
    return work, work.curve("outline", near)


def relief(folder):
    """A relief is outlined by a curve along its foot, and lifted off."""
    work, line = outlined(folder)
    vertices, faces = work.vertices, work.faces
    work.run("cut", "--curve", "outline.json", "--split", "--output", "part.ply")
    ground, star = work.mesh("part.ply"), work.mesh("part-2.ply")
    lifted = star[0] + [0, 0, 0.45]
    view, up = (0.0, -1.0, 1.0), (0, 1, 0)
    return [picture([surface(vertices, faces), line_shape(line, 0.009)], view, (560, 420), up=up),
            picture([surface(*ground[:2]), surface(lifted, star[1], NEW)], view, (560, 420), up=up)]


def head(folder):
    """A head is segmented by five curves: round its muzzle, horns and ears."""
    vertices, faces = packaged_mesh("cow")
    work, view = Work(folder, vertices, faces), (0.3, 0.35, 1.0)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    # Where a ring is, and a way along what it goes round, as seen in the picture.
    rings = {"muzzle": [(0.14, 0.57), (0.15, 0.66), (0.14, 0.52)], "horn-1": [(0.12, 0.75), (0.135, 0.745), (0.085, 0.765)],
             "horn-2": [(0.25, 0.72), (0.24, 0.72), (0.285, 0.735)], "ear-1": [(0.10, 0.70), (0.11, 0.70), (0.07, 0.71)],
             "ear-2": [(0.28, 0.695), (0.265, 0.69), (0.33, 0.70)]}
    lines, words = [], []
    for name, places in rings.items():
        at, begin, end = seen_at(vertices, faces, view, places)
        lines.append(work.curve(name, ring_picks(vertices, faces, at, end - begin, 6)))
        words += ["--curve", name + ".json"]
    work.run("segment", *words, "--output", "parts.ply", "--table", "parts.csv")
    told, cut, labels = work.mesh("parts.ply")
    colours = np.vstack([STONE, hues(labels.max())])[labels]
    nose = vertices[vertices[:, 2] > vertices[:, 2].min() + 0.8 * np.ptp(vertices[:, 2])]
    window = ((nose.max(0) + nose.min(0)) / 2, 0.55 * np.ptp(nose, axis=0).max())
    return [picture([surface(vertices, faces), *(line_shape(line, 0.0025 * size) for line in lines)], view, (480, 420), window),
            picture([surface(told, cut, colours)], view, (480, 420), window)]


def margin(folder):
    """A margin, the lines at 2 % of the diagonal from it along the surface, and the band between them."""
    vertices, faces = packaged_mesh("bone")
    work, view = Work(folder, vertices, faces), (0.2, 1.0, 0.1)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    line = work.curve("margin", seen_at(vertices, faces, view, circle((0.33, 0.87), 0.065, 7)))
    work.run("offset", "--curve", "margin.json", "--distance", 0.02 * size, "--output", "offset.json")
    files = sorted(work.folder.glob("offset*.json"))
    offsets = [work.line(file.name) for file in files]
    work.run("segment", *(word for file in files for word in ("--curve", file)), "--output", "parts.ply")
    told, cut, labels = work.mesh("parts.ply")
    band = labels[np.linalg.norm(told[cut].mean(1) - line[0], axis=1).argmin()]
    colours = np.where(labels[:, None] == band, NEW, STONE)
    window = (line.mean(0), 0.17 * size)
    return [picture([surface(vertices, faces), line_shape(line, 0.003 * size)], view, (420, 420), window),
            picture([surface(told, cut, colours), line_shape(line, 0.003 * size),
                     *(line_shape(other, 0.002 * size, BLUE) for other in offsets)], view, (420, 420), window)]


def emboss(folder):
    """The band between two offsets of a closed curve, embossed and engraved."""
    vertices, faces = packaged_mesh("bunny")
    work, view = Work(folder, vertices, faces), (0.25, 0.25, 1.0)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    turn = np.arange(10) * np.pi / 5
    star = np.array((0.62, 0.3)) + (0.13 + 0.035 * np.cos(5 * turn))[:, None] * np.stack([np.cos(turn), np.sin(turn)], 1)
    line = work.curve("star", seen_at(vertices, faces, view, star))
    work.run("offset", "--curve", "star.json", "--distance", 0.012 * size, "--output", "offset.json")
    words = [word for file in sorted(work.folder.glob("offset*.json")) for word in ("--curve", file)]
    window = (line.mean(0), 0.2 * size)
    images = []
    for height in (0.012 * size, -0.012 * size):
        seed = "seed=" + ",".join(map(str, line[0]))
        work.run("cut", *words, "--keep", seed, "--relief", height, "--output", "relief.ply")
        told, cut, labels = work.mesh("relief.ply")
        band = labels[np.linalg.norm(told[cut].mean(1) - line[0], axis=1).argmin()]
        # Band, walls and rest meet in sharp edges, so each has normals of its own.
        kinds = [(labels == band, NEW), (labels < 0, NEW), ((labels != band) & (labels >= 0), STONE)]
        images.append(picture([surface(told, cut[kind], colour) for kind, colour in kinds], view, (420, 420), window))
    return images


def sharp(told, cut, labels):
    """The parts of a mesh by label, each with normals of its own: they meet in sharp edges."""
    return [surface(told, cut[labels == label], STONE if label == 0 else NEW) for label in np.unique(labels)]


def slot(folder):
    """Slots of three profiles along two curves that cross."""
    vertices, faces = packaged_mesh("bunny")
    work, view = Work(folder, vertices, faces), (0.25, 0.25, 1.0)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    words = []
    for name, places in {"one": [(0.50, 0.24), (0.58, 0.33), (0.66, 0.27), (0.75, 0.36)],
                         "other": [(0.53, 0.40), (0.60, 0.31), (0.66, 0.20)]}.items():
        work.curve(name, seen_at(vertices, faces, view, places), closed=False)
        words += ["--curve", name + ".json"]
    window, images = (seen_at(vertices, faces, view, [(0.62, 0.3)])[0], 0.17 * size), []
    for profile in ("step", "ramp", "round"):
        work.run("cut", *words, "--slot", f"{0.03 * size},{0.015 * size}", "--profile", profile, "--output", "slot.ply")
        images.append(picture(sharp(*work.mesh("slot.ply")), view, (420, 420), window))
    return images


def wall(folder):
    """A part of the bunny's side becomes a wall."""
    vertices, faces = packaged_mesh("bunny")
    work, view = Work(folder, vertices, faces), (0.25, 0.25, 1.0)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    line = work.curve("ring", seen_at(vertices, faces, view, circle((0.62, 0.3), 0.2, 8)))
    work.run("cut", "--curve", "ring.json", "--keep", "inside", "--drop-untouched", "--thickness", 0.02 * size, "--output", "wall.ply")
    shapes = sharp(*work.mesh("wall.ply"))
    window = (line.mean(0), 0.2 * size)
    return [picture([surface(vertices, faces), line_shape(line, 0.004 * size)], view, (420, 420), window),
            picture(shapes, (1.0, 0.6, 0.8), (420, 420), window), picture(shapes, (-0.6, 0.5, -1.0), (420, 420), window)]


def base(folder):
    """The star of the plaque stands on a base."""
    work, line = outlined(folder)
    work.run("cut", "--curve", "outline.json", "--keep", "inside", "--base", 0.2, "--base-direction", "0,0,-1",
             "--output", "die.ply")
    told, cut, labels = work.mesh("die.ply")
    ground = np.ptp(told[cut][:, :, 2], axis=1) < 1e-9
    shapes = [surface(told, cut[kind], colour) for kind, colour in (
        (labels >= 0, STONE), ((labels < 0) & ground, NEW), ((labels < 0) & ~ground, NEW))]
    up = (0, 1, 0)
    return [picture([surface(work.vertices, work.faces), line_shape(line, 0.009)], (0.0, -1.0, 1.0), (420, 420), up=up),
            picture(shapes, (0.0, -1.0, 0.8), (420, 420), up=up), picture(shapes, (0.3, -1.0, -0.8), (420, 420), up=up)]


FIGURES = {"hole": hole, "relief": relief, "head": head, "margin": margin, "emboss": emboss, "slot": slot, "wall": wall,
           "base": base}


def draw_figures(description, figures, prefix):
    """The command line of a script that draws each figure, rows of images by a function of a folder to work in."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--only", choices=figures)
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "images")
    given = parser.parse_args()
    for name, draw in figures.items():
        if given.only in (None, name):
            with tempfile.TemporaryDirectory() as folder:
                images = draw(folder)
            file = given.output / f"{prefix}_{name}.png"
            Image.fromarray(np.hstack(images)).save(file, optimize=True)
            print(file)


if __name__ == "__main__":
    draw_figures(__doc__.splitlines()[0], FIGURES, "using")
