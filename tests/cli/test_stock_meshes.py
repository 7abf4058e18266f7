# SPDX-License-Identifier: GPL-3.0-or-later
"""Shells of every kind of mesh that people have and that published code for shells refuses.

Meshes are made by MeshLab's filters or come with its wheel. Each must have the property that it stands for, and then
either a shell of which every check holds, or a refusal that says what, where and what to do.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pymeshlab
import pytest

pytestmark = pytest.mark.slow
SAMPLES = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"


# ---------------------------------------------------------------- making meshes
def made(*steps):
    """The last layer after filters, each a name and its parameters."""
    document = pymeshlab.MeshSet(verbose=False)
    for name, parameters in steps:
        document.apply_filter(name, **parameters)
    mesh = document.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix().astype(int)


def sample(name):
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(SAMPLES / name))
    mesh = document.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix().astype(int)


def together(*parts):
    """Meshes side by side in one file, each moved by its offset."""
    shifts = np.cumsum([0] + [len(V) for (V, _), _ in parts])
    return np.vstack([V + offset for (V, _), offset in parts]), np.vstack([F + s for ((_, F), _), s in zip(parts, shifts)])


def welded(V, F):
    """Vertices with equal coordinates made one."""
    rounded, index = np.unique(np.round(V, 9), axis=0, return_inverse=True)
    return rounded, index.reshape(-1)[F]


def implicit(expression, size, voxel):
    low, high = ({f"{end}{axis}": sign * size for axis in "xyz"} for end, sign in (("min", -1), ("max", 1)))
    return made(("create_implicit_surface", {"voxelsize": voxel, "expr": expression, **low, **high}))


def scaled(mesh, *factors):
    return mesh[0] * factors, mesh[1]


def sheet_folded_by(degrees):
    """A strip folded once, sharply, in the middle."""
    V, F = meshes.plate(cells=8)
    angle = np.radians(180 - degrees)
    over = np.maximum(V[:, 0] - 0.5, 0)
    return np.stack([np.minimum(V[:, 0], 0.5) - over * np.cos(angle), V[:, 1], over * np.sin(angle)], 1), F


def noisy_sphere():
    V, F = made(("create_sphere", {"subdiv": 4}))
    return V + np.random.default_rng(3).normal(0, 0.02, V.shape), F


# ---------------------------------------------------------------- measuring them
@dataclass
class Traits:
    """What may be unusual about a mesh."""

    boundary: int  # edges with one face
    components: int
    genus: float  # of all components together
    fold: float  # largest angle between the normals of neighbours, degrees
    thinnest: float  # smallest angle of a triangle, degrees
    widest: float  # largest
    crowded: int  # edges with more than two faces
    unused: int  # vertices without a face


def traits(V, F):
    corners = V[F]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    leave = corners[:, [1, 2, 0]] - corners
    arrive = -leave[:, [2, 0, 1]]
    angles = np.degrees(np.arctan2(np.linalg.norm(np.cross(leave, arrive), axis=2), (leave * arrive).sum(2)))
    sides = np.sort(np.concatenate([F[:, [k, (k + 1) % 3]] for k in range(3)]), 1)
    edges, index, counts = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(index.reshape(-1), kind="stable")
    first = np.cumsum(counts) - counts
    pairs = np.stack([order[first[counts == 2]], order[first[counts == 2] + 1]]) % len(F)
    label = np.arange(len(F))
    while True:  # the lowest face of each component, by passing it on
        lower = label.copy()
        np.minimum.at(lower, pairs[0], label[pairs[1]])
        np.minimum.at(lower, pairs[1], label[pairs[0]])
        lower = lower[lower]
        if (lower == label).all():
            break
        label = lower
    components = len(np.unique(label))
    loops = boundary_loops(edges[counts == 1])
    euler = len(np.unique(F)) - len(edges) + len(F)
    cosines = (normals[pairs[0]] * normals[pairs[1]]).sum(1).clip(-1, 1)
    return Traits(
        boundary=int((counts == 1).sum()),
        components=components,
        genus=components - (euler + loops) / 2,
        fold=float(np.degrees(np.arccos(cosines.min()))) if len(cosines) else 0.0,
        thinnest=float(angles.min()),
        widest=float(angles.max()),
        crowded=int((counts > 2).sum()),
        unused=len(V) - len(np.unique(F)),
    )


def boundary_loops(edges):
    """How many rings the boundary edges form."""
    parent = {v: v for v in edges.ravel().tolist()}

    def find(v):
        while parent[v] != v:
            parent[v] = v = parent[parent[v]]
        return v

    for a, b in edges.tolist():
        parent[find(a)] = find(b)
    return len({find(v) for v in parent})


# ---------------------------------------------------------------- cases
@dataclass
class Case:
    make: object
    has: object  # what must be unusual about it
    blocked: int = 0  # faces that may stay without a prism
    mended: bool = False


CASES = {
    # Boundaries.
    "annulus": Case(lambda: made(("create_annulus", {"sides": 60})), lambda t: t.boundary == 120),
    "grid": Case(lambda: made(("create_grid", {"numvertx": 20, "numverty": 20})), lambda t: t.boundary == 76),
    "sphere cap": Case(lambda: made(("create_sphere_cap", {"angle": 100, "subdiv": 4})), lambda t: t.boundary > 0),
    "fractal terrain": Case(lambda: made(("create_fractal_terrain", {"steps": 6})), lambda t: t.boundary > 0),
    "rugged terrain": Case(
        lambda: made(("create_fractal_terrain", {"steps": 6, "maxheight": 1.0})), lambda t: t.fold > 150 and t.boundary > 0
    ),
    "scan with holes": Case(lambda: sample("bunny10k_textured.obj"), lambda t: t.boundary > 100, blocked=2),
    # Sharp folds.
    "sheet folded by 178.5 degrees": Case(lambda: sheet_folded_by(178.5), lambda t: t.fold > 178),
    "sheet folded by 179.9 degrees": Case(lambda: sheet_folded_by(179.9), lambda t: t.fold > 179.8),
    "flattened torus": Case(
        lambda: scaled(made(("create_torus", {"hsubdiv": 60, "vsubdiv": 20})), 1, 1, 0.002),
        lambda t: t.fold > 178,
    ),
    "cow": Case(lambda: sample("cow.obj"), lambda t: t.fold > 170, blocked=91),
    # Thin triangles.
    "cone of needles": Case(lambda: made(("create_cone", {"r1": 0, "subdiv": 500})), lambda t: t.thinnest < 1),
    "long cone": Case(lambda: made(("create_cone", {"h": 100, "subdiv": 200})), lambda t: t.thinnest < 0.02),
    "marching cubes": Case(
        lambda: implicit("(x*x+y*y+z*z-1)*(x*x+y*y+z*z-0.3)", 1.5, 0.07), lambda t: t.widest > 179 and t.thinnest < 0.2
    ),
    "stretched sphere": Case(
        lambda: scaled(made(("create_sphere", {"subdiv": 4})), 1, 1, 200), lambda t: t.widest > 179 and t.thinnest < 0.3
    ),
    # Several components, one inside of another, or entangled.
    "spheres side by side": Case(
        lambda: together(*((made(("create_sphere", {"subdiv": 3})), [3 * i, 0, 0]) for i in range(5))),
        lambda t: t.components == 5,
    ),
    "nested spheres": Case(
        lambda: together(*((scaled(made(("create_sphere", {"subdiv": 3})), *[r] * 3), [0, 0, 0]) for r in (1, 0.9, 0.3))),
        lambda t: t.components == 3,
    ),
    "linked tori": Case(
        lambda: together(
            (made(("create_torus", {"hsubdiv": 40, "vsubdiv": 16})), [0, 0, 0]),
            ((lambda m: (m[0][:, [0, 2, 1]], m[1][:, ::-1]))(made(("create_torus", {"hsubdiv": 40, "vsubdiv": 16}))), [10, 0, 0]),
        ),
        lambda t: t.components == 2 and t.genus == 2,
    ),
    # Genus.
    "torus": Case(lambda: made(("create_torus", {})), lambda t: t.genus == 1),
    "double torus": Case(
        lambda: implicit("(x*x*(1-x*x)-y*y)*(x*x*(1-x*x)-y*y)+z*z-0.02", 1.5, 0.06), lambda t: t.genus == 2
    ),
    # Everything at once.
    "noisy isosurface": Case(
        lambda: made(("create_noisy_isosurface", {"resolution": 24})),
        lambda t: t.boundary > 0 and t.genus > 0 and t.fold > 150 and t.thinnest < 0.1,
        blocked=10,
    ),
    "noisy sphere": Case(noisy_sphere, lambda t: t.fold > 60),
    "airplane": Case(lambda: sample("airplane.obj"), lambda t: t.genus >= 0),
    "bone": Case(lambda: sample("bone.ply"), lambda t: t.unused > 100),
    "cube": Case(lambda: made(("create_cube", {})), lambda t: t.fold == pytest.approx(90)),
    "dodecahedron": Case(lambda: made(("create_dodecahedron", {})), lambda t: t.widest == pytest.approx(108)),
    # Spots that are no manifold, and faces without area: mended.
    "cubes that share an edge": Case(
        lambda: welded(*together((made(("create_cube", {})), [0, 0, 0]), (made(("create_cube", {})), [1, 1, 0]))),
        lambda t: t.crowded == 1, blocked=12, mended=True,
    ),
    "spheres that share a vertex": Case(
        lambda: welded(*together((made(("create_octahedron", {})), [0, 0, 0]), (made(("create_octahedron", {})), [2, 0, 0]))),
        lambda t: t.components == 2, blocked=8, mended=True,
    ),
    "gyroid": Case(
        lambda: implicit("sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)", 4, 0.2), lambda t: t.thinnest == 0, mended=True
    ),
}


def check_shell(run, folder, name, *words):
    """Runs a command that must work; returns its report."""
    run.ok("shell", name, "--check", "--report", "report.json", *words)
    report = json.loads((folder / "report.json").read_text())
    assert [key for key, entry in report["check"].items() if not entry["holds"]] == []
    return report


@pytest.mark.parametrize("kind", ["simplified", "full"])
@pytest.mark.parametrize("name", CASES)
def test_a_mesh_that_others_refuse_gets_a_shell_of_which_every_check_holds(run, refused, tmp_path, name, kind):
    case = CASES[name]
    V, F = case.make()
    found = traits(V, F)
    assert case.has(found), found
    meshes.write_ply(tmp_path / "mesh.ply", V, F)
    if case.mended:
        refused(1, "shell", "mesh.ply", "--check", "--strict")
    report = check_shell(run, tmp_path, "mesh.ply", "--shell", kind)
    assert report["faces"] == len(F)
    assert report["blocked_faces"] <= case.blocked
    assert report["thickness"]["min"] > 0
    assert (report["repair"] is None) != case.mended


def one_sided():
    """A plate of which two opposite sides are joined the wrong way round."""
    V, F = meshes.plate(cells=8)
    left, right = np.arange(9) * 9, np.arange(9) * 9 + 8
    F = F.copy()
    for a, b in zip(right, left[::-1]):
        F[F == a] = b
    return V, F


REFUSED = {
    "points only": (lambda: made(("create_sphere_points", {})), "has no faces"),
    "one-sided": (one_sided, "one-sided"),
    "a vertex at infinity": (lambda: (lambda m: (np.where(np.arange(len(m[0]))[:, None] == 5, np.inf, m[0]), m[1]))(
        made(("create_sphere", {}))), "vertices 5"),
    "a flat box without inside": (lambda: scaled(made(("create_cube", {})), 1, 1, 0), "no area"),
    "two copies of everything": (lambda: together(*[(made(("create_sphere", {})), [0, 0, 0])] * 2), "crosses itself"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_has_no_shell_is_refused_in_one_line_that_says_why(refused, tmp_path, name):
    make, word = REFUSED[name]
    meshes.write_ply(tmp_path / "mesh.ply", *make())
    words = ("--output", "shell.vtu", "--report", "report.json", "--check", "--strict")
    refused(1, "shell", "mesh.ply", *words, says=[word])
