#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills holes smoothly, beside MeshLib's fillHoleNicely and pymeshlab's closing of holes.

    benchmarks/fills.py            five shapes with holes of three sizes
    benchmarks/fills.py --page     writes the table into docs/USING_CURVES.md as well

A closed curve is drawn round each hole, and the mesh is opened along it; all three fill that mesh, with edges as long as its
own. `off` is the largest distance of the patch's vertices and of the middles of its faces from the surface that was there, in
radii of the hole; `turn` by how much the surface turns across the edges of the rim, in degrees, in the median and at 95 %;
`angle` the angle that 5 % of the patch's corners are below; `aspect` what 95 % of its faces are below, 1 for an equilateral one;
`cross` how many faces cross others, by MeshLib. Ours takes the time of a cut with a fill without that of the same cut
without one. Needs requirements.txt and the package in build/release/python.
"""
import argparse
import sys
import time
from pathlib import Path

import numpy as np
from cases import ROOT, bumpy_torus, machine, midpoint_subdivided, packaged_mesh, replace_table, write_json

sys.path.insert(0, str(ROOT / "build" / "release" / "python"))

import bspline_curve

SIZES = (8, 16, 32)  # radii of holes, in mean edges
PICKS = 8


def sphere():
    """Of radius 1, by halving the edges of an octahedron."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    faces = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    for _ in range(6):
        vertices, faces = midpoint_subdivided(vertices, faces)
        vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return vertices, faces


def cylinder():
    """Of radius 1, with flat ends."""
    around, along = 160, 130
    u, z = np.meshgrid(2 * np.pi * np.arange(around) / around, 2 * np.pi / around * np.arange(along), indexing="ij")
    points = np.stack([np.cos(u), np.sin(u), z], -1).reshape(-1, 3)
    i, j = (each.ravel() for each in np.meshgrid(np.arange(around), np.arange(along - 1), indexing="ij"))
    a, b = i * along + j, (i + 1) % around * along + j
    side = np.concatenate([np.stack([a, b, b + 1], 1), np.stack([a, b + 1, a + 1], 1)])
    first = along * np.arange(around)
    low, high = len(points), len(points) + 1
    ends = [np.stack([np.roll(first, -1), first, np.full(around, low)], 1),
            np.stack([first, np.roll(first, -1), np.full(around, high)], 1) + [along - 1, along - 1, 0]]
    return np.vstack([points, [0, 0, 0], [0, 0, points[:, 2].max()]]), np.concatenate([side, *ends])


def shapes():
    """(name, mesh, a point in the middle of the holes, the axis of the limb that they go round or None)."""
    yield "sphere", sphere(), np.array([0.3, 0.2, 0.93]), None
    yield "cylinder", cylinder(), np.array([1.0, 0.05, 2.5]), None
    torus = bumpy_torus(400, 140)
    yield "torus, outside", torus, np.array([1.4, 0.1, 0.0]), None
    yield "torus, inside", torus, np.array([0.65, 0.05, 0.0]), None
    bone = packaged_mesh("bone")
    yield "bone, round the shaft", bone, bone[0].mean(0), np.linalg.eigh(np.cov(bone[0].T))[1][:, 2]


def diagonal(mesh):
    return float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))


def mean_edge(mesh):
    corners = mesh.vertices[mesh.faces]
    return float(np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).mean())


def ring_about(mesh, middle, radius):
    """Picks on a circle about a point."""
    centre = mesh.project(middle[None])
    normal = np.cross(*(mesh.vertices[mesh.faces[centre.faces[0]]][1:] - mesh.vertices[mesh.faces[centre.faces[0]]][0]))
    first = np.cross(normal, [0.3, 0.5, 0.8])
    first /= np.linalg.norm(first)
    second = np.cross(normal / np.linalg.norm(normal), first)
    angle = 2 * np.pi * np.arange(PICKS) / PICKS
    return mesh.project(centre.points + radius * (np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second)).points


def ring_round(mesh, middle, axis):
    """Picks where half-planes of the axis leave the mesh."""
    first = np.cross(axis, [0.3, 0.5, 0.8])
    first /= np.linalg.norm(first)
    second = np.cross(axis, first)
    angle = 2 * np.pi * np.arange(PICKS) / PICKS
    far = 0.2 * diagonal(mesh) * (np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second)
    return mesh.project(middle + far).points


def holes(mesh, middle, axis):
    """Closed curves round holes of three sizes; of a limb at three places."""
    for k, size in enumerate(SIZES):
        if axis is None:
            picks = ring_about(mesh, middle, size * mean_edge(mesh))
        else:
            picks = ring_round(mesh, middle + 0.06 * (k - 1) * diagonal(mesh) * axis, axis)
        yield size, mesh.curve(picks, closed=True)


# ---------------------------------------------------------------- fills
def ours(imprint, keep):
    def seconds(fill):
        start = time.perf_counter()
        cut = imprint.cut(keep, fill=fill)
        return time.perf_counter() - start, cut

    plain = min(seconds("none")[0] for _ in range(3))
    times, cuts = zip(*(seconds("smooth") for _ in range(3)))
    return max(min(times) - plain, 0.0), cuts[0].vertices, cuts[0].faces


def meshlib(vertices, faces, near):
    import meshlib.mrmeshnumpy as arrays
    import meshlib.mrmeshpy as mr

    mesh = arrays.meshFromFacesVerts(faces.astype(np.int32), vertices.astype(np.float32))
    start = time.perf_counter()
    edges = list(mesh.topology.findHoleRepresentiveEdges())
    places = [np.array(list(mesh.points.vec[mesh.topology.org(edge).get()])) for edge in edges]
    edge = edges[int(np.argmin([np.linalg.norm(place - near, axis=1).min() for place in places]))]
    settings = mr.FillHoleNicelySettings()
    settings.subdivideSettings.maxEdgeLen = float(mesh.averageEdgeLength())
    mr.fillHoleNicely(mesh, edge, settings)
    seconds = time.perf_counter() - start
    return seconds, arrays.getNumpyVerts(mesh), arrays.getNumpyFaces(mesh.topology)


def pymeshlab(vertices, faces, rim_edges):
    import pymeshlab as package

    document = package.MeshSet(verbose=False)
    document.add_mesh(package.Mesh(vertices, faces))
    start = time.perf_counter()
    edge = float(np.linalg.norm(vertices[faces] - vertices[np.roll(faces, -1, axis=1)], axis=2).mean())
    document.meshing_close_holes(maxholesize=rim_edges, newfaceselected=False, refinehole=True, refineholeedgelen=package.PureValue(edge))
    seconds = time.perf_counter() - start
    mesh = document.current_mesh()
    return seconds, mesh.vertex_matrix(), mesh.face_matrix()


# ---------------------------------------------------------------- measures
def normals_of(vertices, faces):
    normals = np.cross(vertices[faces[:, 1]] - vertices[faces[:, 0]], vertices[faces[:, 2]] - vertices[faces[:, 0]])
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def turns_at(vertices, faces, kept):
    """Angles across the edges between the first faces, which are kept, and the others."""
    normals = normals_of(vertices, faces)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    owners = np.tile(np.arange(len(faces)), 3)
    order = np.lexsort(np.sort(edges, axis=1).T)
    keys, owners = np.sort(edges, axis=1)[order], owners[order]
    pairs = np.flatnonzero((keys[1:] == keys[:-1]).all(1))
    a, b = owners[pairs], owners[pairs + 1]
    rim = (a < kept) != (b < kept)
    cosines = (normals[a[rim]] * normals[b[rim]]).sum(1)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def shape_of(vertices, faces):
    """The smallest angle that 95 % of the corners have, in degrees, and the aspect that 95 % of the faces are below."""
    sides = np.linalg.norm(vertices[faces] - vertices[np.roll(faces, -1, axis=1)], axis=2)
    a, b, c = sides.T
    cosines = np.stack([(b * b + c * c - a * a) / (2 * b * c), (c * c + a * a - b * b) / (2 * c * a), (a * a + b * b - c * c) / (2 * a * b)])
    area = 0.5 * np.linalg.norm(np.cross(vertices[faces[:, 1]] - vertices[faces[:, 0]], vertices[faces[:, 2]] - vertices[faces[:, 0]]), axis=1)
    aspect = sides.max(1) * sides.sum(1) / (4 * np.sqrt(3) * np.maximum(area, 1e-300))
    return float(np.percentile(np.degrees(np.arccos(np.clip(cosines, -1, 1))), 5)), float(np.percentile(aspect, 95))


def crossing(vertices, faces):
    import meshlib.mrmeshnumpy as arrays
    import meshlib.mrmeshpy as mr

    mesh = arrays.meshFromFacesVerts(faces.astype(np.int32), vertices.astype(np.float32))
    return mr.findSelfCollidingTrianglesBS(mr.MeshPart(mesh)).count()


def measured(surface, kept, radius, filled):
    """`kept`: how many of the faces are no patch; `surface`: what was there, or None where there is nothing to compare with."""
    seconds, vertices, faces = filled
    vertices, faces = np.asarray(vertices, float), np.asarray(faces)
    patch = faces[kept:]
    if len(patch) == 0:
        return {"seconds": seconds, "faces": 0}
    turns = turns_at(vertices, faces, kept)
    angle, aspect = shape_of(vertices, patch)
    row = {"seconds": seconds, "faces": len(patch), "turn": [float(np.percentile(turns, q)) for q in (50, 95)], "angle": angle,
           "aspect": aspect, "cross": crossing(vertices, faces)}
    if surface is not None:
        inside = np.concatenate([vertices[np.unique(patch)], vertices[patch].mean(1)])
        row["off"] = float(np.linalg.norm(surface.project(inside).points - inside, axis=1).max()) / radius
    return row


def rows_of(name, arrays, middle, axis):
    mesh = bspline_curve.Mesh(*arrays)
    for size, curve in holes(mesh, middle, axis):
        imprint = mesh.imprint([curve])
        keep = "largest" if axis is None else "smallest"
        opened = imprint.cut(keep)
        vertices, faces = np.array(opened.vertices), np.array(opened.faces)
        radius = curve.length / (2 * np.pi)
        surface = mesh if axis is None else None
        fills = {"ours": ours(imprint, keep), "MeshLib": meshlib(vertices, faces, curve.points),
                 "pymeshlab": pymeshlab(vertices, faces, len(curve.points) + 1)}
        yield {"shape": name, "size": size, "rim": len(curve.points)} | {
            who: measured(surface, len(faces), radius, filled) for who, filled in fills.items()}


# ---------------------------------------------------------------- results
def text_of(told):
    if told["faces"] == 0:
        return "not filled"
    off = f"{100 * told['off']:.1f} %" if "off" in told else "–"
    return (f"{1e3 * told['seconds']:.0f} ms, {told['faces']:,} faces, off {off}, turn {told['turn'][0]:.1f}° / {told['turn'][1]:.1f}°, "
            f"angle {told['angle']:.0f}°, aspect {told['aspect']:.1f}, cross {told['cross']}")


def page_table(rows):
    head = "| hole | radius, edges | by | ms | faces | off, % | turn, median | turn, 95 % | angle | aspect | cross |"
    lines = [head, "|---|--:|---|" + "--:|" * 8]
    for row in rows:
        for who in ("ours", "MeshLib", "pymeshlab"):
            told = row[who]
            shown = f"| {row['shape']} | {row['size']} | {who} | {1e3 * told['seconds']:.0f} | {told['faces']:,} |"
            if told["faces"]:
                off = f"{100 * told['off']:.1f}" if "off" in told else "–"
                shown += (f" {off} | {told['turn'][0]:.1f}° | {told['turn'][1]:.1f}° | {told['angle']:.0f}° | {told['aspect']:.1f} | "
                          f"{told['cross']} |")
            else:
                shown += " – | – | – | – | – | – |"
            lines.append(shown)
    on = machine()
    return "\n".join(lines) + f"\n\nOn {on['cores']} cores, {on['processor']}."


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="one shape")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--page", action="store_true", help="write the table into docs/USING_CURVES.md as well")
    given = parser.parse_args()
    rows = []
    for shape in list(shapes())[: 1 if given.quick else None]:
        for row in rows_of(*shape):
            rows.append(row)
            for who in ("ours", "MeshLib", "pymeshlab"):
                print(f"{row['shape']:22} {row['size']:3} {who:10} {text_of(row[who])}", flush=True)
    write_json(given.json, {"rows": rows})
    if given.page:
        replace_table(ROOT / "docs" / "USING_CURVES.md", "fills", page_table(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
