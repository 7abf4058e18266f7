#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a mesh and the top, middle and bottom of its shell side by side as a PNG.

The shell is what `bspline_curve shell --output shell.ply` writes. The edges of its triangles are drawn as tubes, so that
the prisms can be seen; the renderer is that of render_curve.py.
"""
import argparse
from pathlib import Path

import numpy as np
from PIL import Image
from render_curve import MESH_COLOUR, camera, normalised, read_mesh, render, vertex_normals

LAYERS = ((1, np.array([0.82, 0.45, 0.37])), (0, np.array([0.80, 0.81, 0.83])), (-1, np.array([0.42, 0.56, 0.78])))
EDGE_COLOUR = np.array([0.15, 0.17, 0.22])


def read_layers(path):
    """Vertices, faces and f of the vertices."""
    import pymeshlab

    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(path))
    mesh = document.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_scalar_array()


PIECES = 16  # large triangles are cut up, since the renderer tests every pixel of a triangle's box


def flat(vertices, faces):
    """Each face cut into pieces with vertices of their own, so that it is shaded flat."""
    i, j = np.meshgrid(np.arange(PIECES), np.arange(PIECES), indexing="ij")
    upright, hanging = i + j < PIECES, i + j < PIECES - 1
    step = lambda di, dj, chosen: np.stack([i[chosen] + di, j[chosen] + dj], -1)
    pieces = np.concatenate([
        np.stack([step(0, 0, upright), step(1, 0, upright), step(0, 1, upright)], 1),
        np.stack([step(1, 0, hanging), step(1, 1, hanging), step(0, 1, hanging)], 1),
    ]) / PIECES  # piece, corner, weights of the second and third corner of the face
    a, b, c = (vertices[faces[:, k]][:, None, None] for k in range(3))
    u, v = pieces[None, ..., :1], pieces[None, ..., 1:]
    points = (a + u * (b - a) + v * (c - a)).reshape(-1, 3)
    own = np.arange(len(points)).reshape(-1, 3)
    return points, own, vertex_normals(points, own)


def edge_tubes(vertices, faces, radius, sides=6):
    """A tube of few sides along every edge."""
    edges = np.unique(np.sort(np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)]), 1), axis=0)
    start, end = vertices[edges[:, 0]], vertices[edges[:, 1]]
    along = normalised(end - start)
    other = np.where(np.abs(along[:, :1]) < 0.9, [[1.0, 0, 0]], [[0, 1.0, 0]])
    side = normalised(np.cross(along, other))
    up = np.cross(along, side)
    angle = np.linspace(0, 2 * np.pi, sides, endpoint=False)[None, :, None]
    normals = np.cos(angle) * side[:, None] + np.sin(angle) * up[:, None]
    share = np.linspace(0, 1, PIECES + 1)[None, :, None]
    centres = start[:, None] + share * (end - start)[:, None]  # edge, ring
    points = centres[:, :, None] + radius * normals[:, None]  # edge, ring, side
    k = np.arange(sides)
    ring = np.arange(len(edges) * (PIECES + 1)).reshape(-1, PIECES + 1)[:, :-1].reshape(-1, 1) * sides
    a, b = ring + k, ring + (k + 1) % sides
    quads = np.concatenate([np.stack([a, b, a + sides], -1), np.stack([b, b + sides, a + sides], -1)]).reshape(-1, 3)
    return points.reshape(-1, 3), quads, np.broadcast_to(normals[:, None], points.shape).reshape(-1, 3)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh")
    parser.add_argument("shell", help="the .ply of `bspline_curve shell`")
    parser.add_argument("--output", required=True, help="the PNG")
    parser.add_argument("--view", type=float, nargs=3, default=[0, 0, 1], help="from the mesh towards the viewer")
    parser.add_argument("--up", type=float, nargs=3, default=[0, 1, 0])
    parser.add_argument("--size", type=int, nargs=2, default=[420, 460], help="width and height of each part, pixels")
    parser.add_argument("--supersampling", type=int, default=3)
    options = parser.parse_args()

    vertices, faces, _ = read_mesh(options.mesh)
    points, triangles, height = read_layers(options.shell)
    diagonal = np.linalg.norm(vertices.max(0) - vertices.min(0))
    frame = camera(options.view, options.up)
    scenes = [[(vertices, faces, vertex_normals(vertices, faces), MESH_COLOUR)]]
    for level, colour in LAYERS:
        layer = triangles[height[triangles[:, 0]] == level]
        scenes.append([(*flat(points, layer), colour), (*edge_tubes(points, layer, 0.0018 * diagonal), EDGE_COLOUR)])
    parts = [render(scene, frame, options.size, options.supersampling) for scene in scenes]
    image = np.concatenate(parts, 1)
    Path(options.output).parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray((image * 255 + 0.5).astype(np.uint8)).save(options.output)


if __name__ == "__main__":
    main()
