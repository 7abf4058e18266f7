# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and curves of the figures in docs/PAPER.md, each made once."""
import bspline_curve
import numpy as np
from bspline_curve._rendering import normalised
from cases import bumpy_torus, midpoint_subdivided, resampled
from paper_pictures import Scene, ring
from table1 import bunny_of

RED, BLUE = np.array((206, 44, 28)) / 255, np.array((32, 84, 190)) / 255
PRESETS = (("paper", BLUE), ("default", RED))
_kept = {}


def kept(name, make):
    if name not in _kept:
        _kept[name] = make()
    return _kept[name]


def bunny(vertices=3485):
    return kept(("bunny", vertices), lambda: bunny_of(vertices))


def smooth_torus():
    return kept("torus", lambda: bumpy_torus(90, 36))


def sphere(level=4):
    def make():
        t = (1 + 5 ** 0.5) / 2
        v = np.array([[-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0], [0, -1, t], [0, 1, t], [0, -1, -t], [0, 1, -t],
                      [t, 0, -1], [t, 0, 1], [-t, 0, -1], [-t, 0, 1]], float)
        f = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
                      [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
                      [8, 6, 7], [9, 8, 1]])
        for _ in range(level):
            v, f = midpoint_subdivided(normalised(v), f)
        return normalised(v), f
    return kept(("sphere", level), make)


def grooved_plate():
    """A plate with a winding groove: concave, for (24)."""
    def make():
        n = 120
        x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n), indexing="ij")
        across = y - 0.35 * np.sin(2.5 * x)
        z = 0.15 * np.exp(-(x ** 2 + y ** 2)) - 0.08 * np.exp(-(across / 0.06) ** 2)
        i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
        a = (i * n + j).ravel()
        faces = np.concatenate([np.stack([a, a + n, a + n + 1], 1), np.stack([a, a + n + 1, a + 1], 1)])
        return np.stack([x, y, z], -1).reshape(-1, 3), faces
    return kept("groove", make)


def fluted_vase():
    """A vase with a rounded rib that winds round it: maximal curvature is high along the rib, for (25)."""
    def make():
        around, high = 220, 110
        u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.linspace(0, 1, high), indexing="ij")
        rib = v - 0.5 - 0.18 * np.sin(2 * u)
        radius = 0.42 + 0.14 * np.sin(2.6 * v + 0.4) + 0.03 * np.exp(-(rib / 0.025) ** 2)
        points = np.stack([radius * np.cos(u), v * 1.3, radius * np.sin(u)], -1).reshape(-1, 3)
        i, j = np.meshgrid(np.arange(around), np.arange(high - 1), indexing="ij")
        a, b = (i * high + j).ravel(), ((i + 1) % around * high + j).ravel()
        return points, np.concatenate([np.stack([a, a + 1, b], 1), np.stack([b, a + 1, b + 1], 1)])
    return kept("vase", make)


def prepared(mesh, preset):
    """A Mesh in the shell of the preset, kept."""
    vertices, faces = mesh
    shell = {"shell": "simplified"} if preset == "paper" else {}
    return kept((id(vertices), preset), lambda: bspline_curve.Mesh(vertices, faces, **shell))


def draw(mesh, picks, preset, **options):
    return prepared(mesh, preset).curve(picks, preset=preset, **options)


def both(mesh, picks, **options):
    return {preset: draw(mesh, picks, preset, **options) for preset, _ in PRESETS}


def scene_of(mesh, curves, picks=(), **more):
    """Curves by preset in the presets' colours."""
    colours = dict(PRESETS)
    return Scene(*mesh, lines=[(ring(curve), colours[preset]) for preset, curve in curves.items()], balls=list(picks), **more)


def nearest(mesh, *points):
    """The points of the surface nearest to some points."""
    return prepared(mesh, "default").project(np.array(points, float)).points


def bunny_picks(mesh, count=4):
    """The same places, relative to the box of any bunny."""
    vertices = mesh[0]
    low, size = vertices.min(0), np.ptp(vertices, axis=0)
    shares = {4: [(0.16, 0.62, 0.8), (0.35, 0.42, 1.0), (0.6, 0.33, 1.0), (0.82, 0.5, 0.8)],
              6: [(0.15, 0.62, 0.8), (0.22, 0.38, 0.9), (0.5, 0.2, 1.0), (0.78, 0.32, 0.9), (0.7, 0.55, 0.8), (0.42, 0.6, 0.9)]}
    return nearest(mesh, *(low + np.array(share) * size for share in shares[count]))


def apart(one, other):
    """Largest distance of points of one line from the other."""
    a, b = resampled(one, 600), resampled(other, 3000)
    return float(np.sqrt(((a[:, None] - b[None]) ** 2).sum(-1).min(1)).max())


def each(curves, say):
    return "; ".join(f"`{preset}` {say(curve)}" for preset, curve in curves.items())
