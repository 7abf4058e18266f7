#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a curve on its mesh as a PNG, without a graphics card or a window.

The mesh may have any format that MeshLab reads; the curve is what bspline_curve writes (.json, .ply, .obj). The renderer
is that of the Python package.
"""
import argparse
import json
import re
import sys
from pathlib import Path

import numpy as np
from PIL import Image

# By itself, since the package as a whole needs to be installed.
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python" / "bspline_curve"))
from _rendering import MESH_COLOUR, ball, camera, curve_picture, normalised, render, tube, vertex_normals

__all__ = ["MESH_COLOUR", "ball", "camera", "normalised", "render", "tube", "vertex_normals"]  # for the other pictures


def read_mesh(path):
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), mesh.edge_matrix()


def read_curve(path):
    """Points in order along the curve, the first repeated at the end where it is closed."""
    if Path(path).suffix == ".json":
        data = json.loads(Path(path).read_text())
        points, closed = np.array(data["polyline"]["points"]), data["closed"]
    else:
        points, _, edges = read_mesh(path)
        closed = len(edges) == len(points)
    return np.vstack([points, points[:1]]) if closed else points


def read_picks(path):
    text = Path(path).read_text()
    if Path(path).suffix == ".json":
        return np.array(json.loads(text)["picks"])
    points = re.findall(r"<point\b[^>]*>", text)
    return np.array([[float(re.search(rf'\b{c}="([^"]*)"', p).group(1)) for c in "xyz"] for p in points])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh")
    parser.add_argument("curve")
    parser.add_argument("--picks", help="a .pp or .json file: drawn as balls")
    parser.add_argument("--output", required=True, help="the PNG")
    parser.add_argument("--view", type=float, nargs=3, default=[0, 0, 1], help="from the mesh towards the viewer")
    parser.add_argument("--up", type=float, nargs=3, default=[0, 1, 0])
    parser.add_argument("--size", type=int, nargs=2, default=[1000, 1000], help="width and height, pixels")
    parser.add_argument("--width", type=float, default=0.0045, help="radius of the curve, of the mesh's diagonal")
    parser.add_argument("--supersampling", type=int, default=3)
    options = parser.parse_args()

    vertices, faces, _ = read_mesh(options.mesh)
    picks = read_picks(options.picks) if options.picks else np.empty((0, 3))
    pixels = curve_picture(
        (vertices, faces), read_curve(options.curve), picks,
        view=options.view, up=options.up, size=options.size, width=options.width, supersampling=options.supersampling,
    )
    Path(options.output).parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(pixels).save(options.output)


if __name__ == "__main__":
    main()
