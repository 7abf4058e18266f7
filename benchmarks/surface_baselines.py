# SPDX-License-Identifier: GPL-3.0-or-later
"""Small stand-ins for other ways to draw curves on meshes, for the figures of docs/PAPER.md: curves that are projected point by
point, Bézier curves by geodesics, level sets. None of them is tuned; each shows what its kind of method does. A mesh is a bspline_curve.Mesh."""
from dataclasses import dataclass

import numpy as np
from bspline_curve._rendering import normalised, vertex_normals
from scipy.interpolate import CubicSpline
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import spsolve

SAMPLES = 500


@dataclass
class Projected:
    """Samples of a spline on the surface, with rows of nan where the projection failed."""
    points: np.ndarray
    failed: int

    def parts(self):
        """The runs between failures and jumps, as lines of at least two points."""
        steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        usual = np.median(steps)
        ends = np.flatnonzero(steps > 8 * usual) + 1
        return [part for part in np.split(self.points, ends) if len(part) > 1]


def geodesic(mesh, start, end):
    """The curve with λ = 1 through two picks: points."""
    return mesh.curve([start, end], tension=1.0).points


# ---------------------------------------------------------------- spline in space, then projected [21]
def space_spline(picks):
    """Points of the natural cubic spline through picks, by chord length."""
    at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(picks, axis=0), axis=1))]
    return CubicSpline(at, picks, bc_type="natural")(np.linspace(0, at[-1], SAMPLES))


def projected_spline(mesh, picks):
    """By the closest point of the surface."""
    return Projected(mesh.project(space_spline(picks)).points, 0)


def phong_spline(mesh, picks, rings=3):
    """By normals that are interpolated as Phong's shading does: the point of the surface whose normal leads to the sample,
    among the faces near the closest point; the nearest where there are several."""
    vertices, faces = mesh.vertices, mesh.faces
    normals = vertex_normals(vertices, faces)
    samples = space_spline(picks)
    near = mesh.project(samples)
    around = faces_around(mesh)
    found = []
    for sample, face in zip(samples, near.faces):
        candidates = {int(face)}
        for _ in range(rings):
            candidates |= {f for c in candidates for v in faces[c] for f in around[v]}
        best = None
        for f in sorted(candidates):
            point = phong_point(vertices[faces[f]], normals[faces[f]], sample)
            if point is not None and (best is None or np.linalg.norm(point - sample) < np.linalg.norm(best - sample)):
                best = point
        if best is not None:
            found.append(best)
    return Projected(np.array(found), len(samples) - len(found))


def faces_around(mesh):
    around = [[] for _ in mesh.vertices]
    for f, face in enumerate(mesh.faces):
        for v in face:
            around[v].append(f)
    return around


def phong_point(corners, normals, sample, steps=12):
    """Newton's method for (sample - x(u, v)) × n(u, v) = 0; nothing where it ends outside of the face."""
    u = np.array([1 / 3, 1 / 3])
    edges, turns = corners[1:] - corners[0], normals[1:] - normals[0]
    for _ in range(steps):
        away = sample - corners[0] - u @ edges
        normal = normals[0] + u @ turns
        residual = np.cross(away, normal)
        slope = np.stack([np.cross(-edges[k], normal) + np.cross(away, turns[k]) for k in range(2)], 1)
        step, *_ = np.linalg.lstsq(slope, -residual, rcond=None)
        u = u + step
        if not np.isfinite(u).all() or np.abs(u).max() > 10:
            return None
        if np.abs(step).max() < 1e-12:
            break
    inside = u.min() >= -1e-9 and u.sum() <= 1 + 1e-9
    return corners[0] + u @ edges if inside and np.abs(step).max() < 1e-8 else None


# ---------------------------------------------------------------- Bézier curves by geodesics [24]
def bezier_by_geodesics(mesh, controls, samples=41):
    """De Casteljau's rule with points of geodesics in place of segments: points of the curve."""
    def between(a, b, t):
        if np.linalg.norm(a - b) < 1e-12:
            return a
        way = geodesic(mesh, a, b)
        at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))]
        return np.array([np.interp(t * at[-1], at, way[:, k]) for k in range(3)])

    points = []
    for t in np.linspace(0, 1, samples):
        level = [np.asarray(control) for control in controls]
        while len(level) > 1:
            level = [between(a, b, t) for a, b in zip(level, level[1:])]
        points.append(level[0])
    return np.array(points)


# ---------------------------------------------------------------- level sets of a diffused function [17]
def laplacian(vertices, faces):
    """Cotangent weights."""
    rows, columns, values = [], [], []
    for k in range(3):
        i, j, o = faces[:, (k + 1) % 3], faces[:, (k + 2) % 3], faces[:, k]
        a, b = vertices[i] - vertices[o], vertices[j] - vertices[o]
        cotangent = (a * b).sum(1) / np.linalg.norm(np.cross(a, b), axis=1)
        rows += [i, j]
        columns += [j, i]
        values += [cotangent / 2, cotangent / 2]
    n = len(vertices)
    weights = coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (n, n)).tocsr()
    return diags(np.asarray(weights.sum(1)).ravel()) - weights


def heat_level_set(mesh, picks, band=0.06):
    """The zero set of a harmonic function that is 1 to the left and -1 to the right of the closed polygon of geodesics
    through the picks, near it: lines of points."""
    vertices, faces = mesh.vertices, mesh.faces
    normals = vertex_normals(vertices, faces)
    lines = [geodesic(mesh, a, b) for a, b in zip(picks, np.roll(picks, -1, axis=0))]
    starts = np.concatenate([line[:-1] for line in lines])
    steps = np.concatenate([np.diff(line, axis=0) for line in lines])
    keep = np.linalg.norm(steps, axis=1) > 1e-9
    middles, along = starts[keep] + steps[keep] / 2, normalised(steps[keep])
    away = vertices[:, None] - middles[None]
    distance = np.linalg.norm(away, axis=-1)
    nearest = distance.argmin(1)
    side = (np.cross(normals, along[nearest]) * (vertices - middles[nearest])).sum(1)
    held = (distance.min(1) < band).astype(float)
    values = spsolve((laplacian(vertices, faces) + diags(held)).tocsc(), held * np.sign(side))
    return zero_set(vertices, faces, values)


def zero_set(vertices, faces, values):
    """Where linear interpolation is 0: lines, longest first."""
    ends = {}
    for face in faces:
        crossed = []
        for k in range(3):
            i, j = sorted((int(face[k]), int(face[(k + 1) % 3])))
            if (values[i] > 0) != (values[j] > 0):
                crossed.append((i, j))
        if len(crossed) == 2:
            for one, other in (crossed, crossed[::-1]):
                ends.setdefault(one, []).append(other)
    lines, left = [], set(ends)
    while left:
        here = min(left)
        line = [here]
        left.discard(here)
        while True:
            following = [e for e in ends[line[-1]] if e in left]
            if not following:
                break
            line.append(following[0])
            left.discard(following[0])
        line.append(line[0])
        share = lambda i, j: values[i] / (values[i] - values[j])
        lines.append(np.array([vertices[i] + share(i, j) * (vertices[j] - vertices[i]) for i, j in line]))
    return sorted(lines, key=len, reverse=True)
