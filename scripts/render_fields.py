#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws curves without a field (above) and with one (below), on meshes coloured by what the field costs, as a PNG.

    scripts/render_fields.py MESH:PICKS... --output fields.png

One column per curve, seen along the mean normal of the surface under it. What follows a second colon is the caption; without
one it is the name of the mesh. The renderer is that of render_curve.py.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from render_curve import ball, camera, normalised, read_mesh, read_picks, render, tube, vertex_normals

ROOT = Path(__file__).resolve().parents[1]
CURVE_COLOUR = np.array([0.93, 0.32, 0.02])
PICK_COLOUR = np.array([0.06, 0.06, 0.07])
EVEN = 0.45  # lit so evenly that colours can be read
INK = (40, 42, 48)
COSTS = np.array([0.0, 0.35, 0.7, 1.0, 1.3])  # and their colours, which differ in lightness also to the colour-blind
COLOURS = np.array([[0.03, 0.22, 0.48], [0.15, 0.49, 0.75], [0.56, 0.78, 0.88], [0.93, 0.93, 0.91], [1.00, 0.98, 0.85]])


def run(*words):
    subprocess.run(list(map(str, words)), check=True)


def draw(program, mesh, picks, *options):
    """The polyline of a curve: points, and the normals of the surface there."""
    vertices, faces, normals = mesh[1]
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "curve.json"
        run(program, mesh[0], "--picks", picks, *options, "--output", output)
        curve = json.loads(output.read_text())
    line = curve["polyline"]
    points = np.array(line["points"])
    across = (np.array(line["barycentrics"])[:, :, None] * normals[faces[np.array(line["faces"])]]).sum(1)
    return np.vstack([points, points[:1]]) if curve["closed"] else points, across


def costs(program, mesh, kind):
    with tempfile.TemporaryDirectory() as folder:
        output, report = Path(folder) / "field.npy", Path(folder) / "report.json"
        run(program, "field", mesh, "--kind", kind, "--output", output, "--report", report)
        cost, values = json.loads(report.read_text())["natural_cost"], np.load(output)
    return {"identity": values, "square": values**2, "exp-minus": np.exp(-values)}[cost]


def colours_of(cost):
    return np.stack([np.interp(cost, COSTS, COLOURS[:, k]) for k in range(3)], 1)


def upright(direction):
    """The axis that is up in the picture: y, or z where one looks along y."""
    return np.array([0.0, 1, 0]) if abs(direction[1]) < 0.9 else np.array([0.0, 0, 1])


def window_around(points, frame, aspect, room):
    """Lowest and highest corner of a box around the points, in the frame, wide enough for the aspect of the picture."""
    seen = points @ frame.T
    low, high = seen.min(0), seen.max(0)
    middle, half = (low + high) / 2, (high - low) / 2
    half[:2] = (1 + room) * max(half[0] / aspect, half[1]) * np.array([aspect, 1])
    return middle - half, middle + half


def scene(mesh, colours, curve, picks, radius):
    vertices, faces, normals = mesh
    line, line_faces = tube(curve, radius)
    shapes = [(vertices, faces, normals, colours), (line, line_faces, vertex_normals(line, line_faces), CURVE_COLOUR)]
    for pick in picks:
        points, ball_faces = ball(pick, 2 * radius)
        shapes.append((points, ball_faces, normalised(points - pick), PICK_COLOUR))
    return shapes


def column(program, mesh_file, picks_file, kind, options):
    """The two pictures of a curve, one above the other."""
    vertices, faces, _ = read_mesh(mesh_file)
    mesh = vertices, faces, vertex_normals(vertices, faces)
    picks = read_picks(picks_file)
    weight = ("--field-weight", options.field_weight) if options.field_weight is not None else ()
    curves = [draw(program, (mesh_file, mesh), picks_file, *field) for field in ((), ("--field", kind, *weight))]
    direction = normalised(np.vstack([across for _, across in curves]).mean(0))
    frame = camera(direction, upright(direction))
    width, height = options.size
    window = window_around(np.vstack([points for points, _ in curves]), frame, width / height, options.room)
    radius = options.width * (window[1] - window[0])[1]
    colours = colours_of(costs(program, mesh_file, kind))
    scenes = [scene(mesh, colours, points, picks, radius) for points, _ in curves]
    return np.concatenate([render(s, frame, options.size, options.supersampling, window, EVEN) for s in scenes])


def text(image, at, words, size, anchor):
    ImageDraw.Draw(image).text(at, words, INK, ImageFont.load_default(size), anchor)


def colour_bar(image, left, top, width, height):
    """From what costs most to what costs least, with figures below."""
    cost = np.linspace(COSTS[-1], COSTS[0], width)
    bar = np.broadcast_to(colours_of(cost)[None], (height, width, 3))
    image.paste(Image.fromarray((bar * 255 + 0.5).astype(np.uint8)), (left, top))
    ImageDraw.Draw(image).rectangle((left, top, left + width, top + height), outline=INK)
    for value in (1, 0.5, 0):
        at = left + width * (COSTS[-1] - value) / COSTS[-1]
        ImageDraw.Draw(image).line((at, top + height, at, top + height + 4), INK)
        text(image, (at, top + height + 6), f"{value:g}", 14, "mt")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("curves", nargs="+", metavar="MESH:PICKS[:CAPTION]")
    parser.add_argument("--output", required=True, help="the PNG")
    parser.add_argument("--field", default="maximal-curvature")
    parser.add_argument("--field-weight", type=float, help="left out: the program's default")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--size", type=int, nargs=2, default=[396, 396], help="width and height of each picture, pixels")
    parser.add_argument("--room", type=float, default=0.3, help="around the curve, of its extent")
    parser.add_argument("--width", type=float, default=0.009, help="radius of the curve, of the height of the picture")
    parser.add_argument("--supersampling", type=int, default=3)
    options = parser.parse_args()

    width, height = options.size
    gap, side, head, foot = 4, 30, 30, 52
    columns = len(options.curves)
    image = Image.new("RGB", (side + columns * (width + gap), head + 2 * (height + gap) + foot), "white")
    for k, words in enumerate(options.curves):
        mesh, picks, *caption = words.split(":", 2)
        parts = column(options.program, Path(mesh), Path(picks), options.field, options)
        for row in range(2):
            part = Image.fromarray((parts[row * height:(row + 1) * height] * 255 + 0.5).astype(np.uint8))
            image.paste(part, (side + k * (width + gap), head + row * (height + gap)))
        text(image, (side + k * (width + gap) + width // 2, head // 2), *(caption or [Path(mesh).stem]), 19, "mm")
    for row, words in enumerate(("no field", options.field)):
        label = Image.new("RGB", (height, side), "white")
        text(label, (height // 2, side // 2), words, 19, "mm")
        image.paste(label.rotate(90, expand=True), (0, head + row * (height + gap)))
    bottom = head + 2 * (height + gap) + 8
    colour_bar(image, side + 150, bottom, 360, 16)
    text(image, (side + 140, bottom + 8), "cost of the field", 17, "rm")
    Path(options.output).parent.mkdir(parents=True, exist_ok=True)
    image.save(options.output, optimize=True)


if __name__ == "__main__":
    main()
