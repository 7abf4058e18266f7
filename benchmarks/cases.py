# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and picks for benchmarks, all made by a rule or shipped in pymeshlab's wheel, and runs of the program on them."""
import json
import math
import os
import platform
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "scripts"))
from render_curve import read_mesh  # noqa: E402
from shell_kinds_table import geometric_mean  # noqa: E402, F401
from shell_table import packaged_meshes, replace_table  # noqa: E402, F401

PROGRAM = ROOT / "build" / "release" / "bin" / "bspline_curve"
PACKAGED = ("bone", "bunny10k_textured", "airplane", "bunny")
TORI = (3000, 12000, 50000)  # vertices
SEED = 1


class NoCurve(Exception):
    """What the program says where it draws none."""


@dataclass
class Case:
    name: str
    vertices: np.ndarray
    faces: np.ndarray
    picks: np.ndarray
    closed: bool


# ---------------------------------------------------------------- meshes
def packaged_mesh(name):
    """A mesh of pymeshlab's wheel, by the name of its file without extension."""
    return read_mesh(next(path for path in packaged_meshes() if path.stem == name))[:2]


def bumpy_torus(around, across):
    """A torus with bumps, of 2 around across faces, without noise: smooth on every resolution."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    minor = 0.35 + 0.04 * np.sin(5 * u) * np.sin(3 * v)
    points = np.stack([(1 + minor * np.cos(v)) * np.cos(u), (1 + minor * np.cos(v)) * np.sin(u), minor * np.sin(v)], -1)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    faces = np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], 2)
    return points.reshape(-1, 3), faces.reshape(-1, 3)


def torus_of(vertices):
    """A bumpy torus of about so many vertices, its cells nearly square."""
    across = max(12, round(math.sqrt(vertices / 3)))
    return bumpy_torus(max(12, round(vertices / across)), across)


def midpoint_subdivided(vertices, faces):
    """Every face split into four at the midpoints of its edges: the same surface."""
    edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    keys, index = np.unique(edges[:, 0].astype(np.int64) * len(vertices) + edges[:, 1], return_inverse=True)
    ends = np.stack([keys // len(vertices), keys % len(vertices)], 1)
    a, b, c = faces.T
    ab, bc, ca = (len(vertices) + index.reshape(-1, 3)).T
    split = np.stack([np.stack(corners, 1) for corners in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))], 1)
    return np.vstack([vertices, vertices[ends].mean(1)]), split.reshape(-1, 3)


def resampled(line, count):
    """So many points at equal steps along a polyline."""
    at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    even = np.linspace(0, at[-1], count)
    return np.stack([np.interp(even, at, line[:, k]) for k in range(3)], 1)


def largest_component(faces, count):
    """The vertices of the component with most faces."""
    label = np.arange(count)
    while True:
        least = label[faces].min(1)
        lower = label.copy()
        for k in range(3):
            np.minimum.at(lower, faces[:, k], least)
        lower = lower[lower]
        if (lower == label).all():
            break
        label = lower
    names, sizes = np.unique(label[faces[:, 0]], return_counts=True)
    return np.flatnonzero(label == names[sizes.argmax()])


# ---------------------------------------------------------------- picks
def farthest_picks(vertices, faces, count, seed):
    """Vertices of the largest component, far apart: a random one, then again and again the one that is farthest from all
    before; in the order of a short tour."""
    candidates = np.intersect1d(largest_component(faces, len(vertices)), faces)
    points = vertices[candidates]
    chosen = [int(np.random.default_rng(seed).integers(len(points)))]
    distance = np.full(len(points), np.inf)
    while len(chosen) < count:
        distance = np.minimum(distance, np.linalg.norm(points - points[chosen[-1]], axis=1))
        chosen.append(int(distance.argmax()))
    tour, rest = [chosen[0]], chosen[1:]
    while rest:
        rest.sort(key=lambda i: np.linalg.norm(points[i] - points[tour[-1]]))
        tour.append(rest.pop(0))
    return points[tour]


# ---------------------------------------------------------------- running
def picked_cases(layouts, quick):
    """A case for each layout (number of picks, closed) on each of some meshes of the wheel and some tori; `quick`: on two."""
    meshes = [(name, packaged_mesh(name)) for name in (("bone",) if quick else PACKAGED)]
    meshes += [(f"torus of {count:,}", torus_of(count)) for count in ((1000,) if quick else TORI)]
    for name, (vertices, faces) in meshes:
        for count, closed in layouts:
            picks = farthest_picks(vertices, faces, count, SEED)
            yield Case(f"{name}, {count} {'closed' if closed else 'open'}", vertices, faces, picks, closed)


def cases_of(folder):
    """Those of files NAME.json: {"mesh": file, "picks": [...], "closed": bool}."""
    for file in sorted(folder.glob("*.json")):
        told = json.loads(file.read_text())
        mesh = next(path for path in (folder / told["mesh"], folder.parent / told["mesh"]) if path.is_file())
        vertices, faces = read_mesh(mesh)[:2]
        yield Case(file.stem, vertices, faces, np.array(told["picks"]), told["closed"])


def write_ply(path, vertices, faces):
    rows = np.zeros(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    rows["n"], rows["v"] = 3, faces
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    Path(path).write_bytes(header.encode() + np.asarray(vertices, "<f8").tobytes() + rows.tobytes())


def write_case(folder, case):
    """The files of its mesh and its picks in a folder."""
    mesh, picks = folder / "mesh.ply", folder / "picks.json"
    write_ply(mesh, case.vertices, case.faces)
    picks.write_text(json.dumps({"picks": case.picks.tolist(), "closed": case.closed}))
    return mesh, picks


def report_of(program, folder, mesh, picks, *options, **environment):
    """The report of a run of the program, which leaves it and the curve in a folder. Throws NoCurve."""
    report = folder / "report.json"
    words = [program, mesh, "--picks", picks, "--output", folder / "curve.json", "--report", report, *options]
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, env={**os.environ, **environment})
    if done.returncode != 0:
        raise NoCurve(done.stderr.strip().removeprefix("bspline_curve: ").replace("\n", " "))
    return json.loads(report.read_text())


def draw(program, case, *options, repeat=5):
    """The report of a run of the program on a case. Throws NoCurve."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        return report_of(program, folder, *write_case(folder, case), "--repeat", repeat, "--no-cache", *options)


def is_in_whole_shell(report):
    """Whether the curve needed a shell of the whole surface, as those do that are drawn cell by cell."""
    return report["shell"] != "fibres"


def best_of(reports):
    """One report with the least of each time: what else runs on the machine only ever adds."""
    best = dict(reports[0])
    best["seconds"] = {key: None if value is None else min(report["seconds"][key] for report in reports)
                       for key, value in reports[0]["seconds"].items()}
    return best


# ---------------------------------------------------------------- results
def machine():
    """What a page says of the machine that it was made on."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        names = [line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")]
        model = names[0] if names else model
    return {"processor": model, "cores": os.cpu_count(), "load": round(os.getloadavg()[0], 2)}


def write_json(path, results):
    if path is not None:
        Path(path).write_text(json.dumps(results, indent=1) + "\n")
