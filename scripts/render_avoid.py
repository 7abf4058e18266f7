#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a curve without and with faces to avoid side by side as a PNG, after Fig. 16 of the paper.

    scripts/render_avoid.py --output avoid.png

Four picks on the side of the bunny of pymeshlab's wheel, and two discs of faces between them. The renderer is that of
render_curve.py.
"""
import argparse
import json
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image
from render_curve import MESH_COLOUR, camera, read_mesh, render, vertex_normals
from render_fields import ROOT, draw, scene, text, window_around

VIEW, UP = [-0.25, 0.28, 1], [0, 1, 0]
# As seen: to the right and up from the middle of the mesh, in heights of its box.
PICKS = [[-0.22, -0.22], [-0.04, -0.05], [0.14, -0.18], [0.32, -0.05]]
DISCS = [([-0.12, -0.16], 0.06), ([0.22, -0.09], 0.06)]  # centre, radius
FREE, AVOIDED = MESH_COLOUR, np.array([0.25, 0.45, 0.70])


def seen_at(places, mesh, frame, height):
    """The points of the surface that are seen at these places."""
    vertices, faces, _ = mesh
    seen = vertices @ frame.T
    middle = (seen.min(0) + seen.max(0))[:2] / 2
    corners = seen[faces]
    a, b, c = (corners[:, k, :2] for k in range(3))
    points = []
    for place in np.array(places) * height + middle:
        doubled = lambda p, q: (p[:, 0] - place[0]) * (q[:, 1] - place[1]) - (p[:, 1] - place[1]) * (q[:, 0] - place[0])
        shares = np.stack([doubled(b, c), doubled(c, a), doubled(a, b)], 1)
        over = np.nonzero((shares > 0).all(1))[0]  # seen from outside
        shares = shares[over] / shares[over].sum(1, keepdims=True)
        nearest = (shares * corners[over, :, 2]).sum(1).argmax()
        points.append(shares[nearest] @ vertices[faces[over[nearest]]])
    return np.array(points)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", required=True, help="the PNG")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--size", type=int, nargs=2, default=[640, 480], help="width and height of each picture, pixels")
    parser.add_argument("--supersampling", type=int, default=3)
    options = parser.parse_args()

    import pymeshlab

    mesh_file = Path(pymeshlab.__file__).parent / "tests/sample_meshes/bunny.obj"
    vertices, faces, _ = read_mesh(mesh_file)
    mesh = vertices, faces, vertex_normals(vertices, faces)
    frame = camera(VIEW, UP)
    height = np.ptp(vertices @ frame.T, axis=0)[1]
    picks = seen_at(PICKS, mesh, frame, height)
    centres = seen_at([place for place, _ in DISCS], mesh, frame, height)
    middles = vertices[faces].mean(1)
    distances = [np.linalg.norm(middles - centre, axis=1) / (radius * height) for centre, (_, radius) in zip(centres, DISCS)]
    avoided = np.nonzero(np.min(distances, axis=0) < 1)[0]

    with tempfile.TemporaryDirectory() as folder:
        ids, picks_file = Path(folder) / "faces.npy", Path(folder) / "picks.json"
        np.save(ids, avoided)
        picks_file.write_text(json.dumps({"picks": picks.tolist()}))
        curves = [draw(options.program, (mesh_file, mesh), picks_file, *avoid)[0] for avoid in ((), ("--avoid", ids))]

    # Vertices of their own for the faces to avoid, so that colours end at edges.
    own = np.where(np.isin(np.arange(len(faces)), avoided)[:, None], faces + len(vertices), faces)
    shown = np.vstack([vertices] * 2), own, np.vstack([mesh[2]] * 2)
    colours = np.repeat([FREE, AVOIDED], len(vertices), 0)
    width, tall = options.size
    window = window_around(np.vstack(curves), frame, width / tall, 0.15)
    radius = 0.011 * (window[1] - window[0])[1]
    gap, head = 6, 30
    image = Image.new("RGB", (2 * width + gap, head + tall), "white")
    for k, (curve, words) in enumerate(zip(curves, ("no faces to avoid", "the blue faces avoided"))):
        part = render(scene(shown, colours, curve, picks, radius), frame, options.size, options.supersampling, window, 0.25)
        image.paste(Image.fromarray((part * 255 + 0.5).astype(np.uint8)), (k * (width + gap), head))
        text(image, (k * (width + gap) + width // 2, head // 2), words, 19, "mm")
    Path(options.output).parent.mkdir(parents=True, exist_ok=True)
    image.save(options.output, optimize=True)


if __name__ == "__main__":
    main()
