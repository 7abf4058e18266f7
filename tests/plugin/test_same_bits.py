# SPDX-License-Identifier: GPL-3.0-or-later
"""The same curve is the same bytes: from run to run, on one core and on two, with and without AVX2 and FMA in the C library, by the
program, the plugin and the Python package. The meshes have a quality, which curves follow only where they are asked to."""
import json
import os
import subprocess
import sys
import warnings

import numpy as np
import pymeshlab
import pytest
from curves import CurveLayer, draw
from made_meshes import write_ply
from meshes import wavy_plate

MESHES = {}
CASES = [(mesh, kind) for mesh in ("plate", "torus", "sphere", "rough", "fold", "broken") for kind in ("open", "closed", "valley", "quartic")]
CASES += [(mesh, kind) for mesh in ("plate", "sphere", "broken") for kind in ("cornered", "led")]
OPTIONS = {"open": {}, "closed": {"closed": True}, "valley": {"field": "valley"}, "quartic": {"degree": 4, "tension": 0.3},
           "cornered": {"closed": True, "corners": "5,2"}, "led": {"tangents": "1:0.1,0.3,1;2:0.3,1,0.2/any;3:1,0,0.2;4:1,0.2,0.3/0.2,1,0.4", "corners": "2,4"}}
# The package counts picks from 0.
IN_PYTHON = OPTIONS | {"cornered": {"closed": True, "corners": [4, 1]},
                       "led": {"tangents": {0: (0.1, 0.3, 1), 1: ((0.3, 1, 0.2), None), 2: (1, 0, 0.2), 3: ((1, 0.2, 0.3), (0.2, 1, 0.4))},
                               "corners": [1, 3]}}
WITHOUT_AVX2 = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA"}


def grid(columns, rows):
    """Faces of a grid that closes in both directions."""
    i, j = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    a, b = i * rows + j, (i + 1) % columns * rows + j
    c, d = (i + 1) % columns * rows + (j + 1) % rows, i * rows + (j + 1) % rows
    return np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def torus(across=1.0):
    u, v = np.meshgrid(2 * np.pi * np.arange(48) / 48, 2 * np.pi * np.arange(20) / 20, indexing="ij")
    r = 0.35 + 0.05 * np.sin(4 * u) * np.cos(2 * v)
    points = np.stack([(1 + r * np.cos(v)) * np.cos(u), (1 + r * np.cos(v)) * np.sin(u), across * r * np.sin(v)], -1)
    return points.reshape(-1, 3), grid(48, 20)


def mesh_of(name):
    if name not in MESHES:
        if name == "plate":
            made = wavy_plate()
        elif name == "torus":
            made = torus()
        elif name == "sphere":
            pymeshlab_set = pymeshlab.MeshSet(verbose=False)
            pymeshlab_set.create_sphere(subdiv=4)
            made = pymeshlab_set.current_mesh().vertex_matrix(), pymeshlab_set.current_mesh().face_matrix().astype(int)
        elif name == "rough":
            vertices, faces = torus()
            made = vertices + np.random.default_rng(3).normal(0, 0.01, vertices.shape), faces
        elif name == "fold":
            made = torus(0.05)
        else:  # a face twice, two turned, a flap
            vertices, faces = torus()
            faces = np.vstack([faces, faces[5], [0, 1, len(vertices)]])
            faces[[30, 31]] = faces[[30, 31]][:, ::-1]
            made = np.vstack([vertices, [3, 0, 0]]), faces
        MESHES[name] = made
    return MESHES[name]


def quality_of(name):
    """What would draw every curve aside."""
    return np.sin(np.arange(len(mesh_of(name)[0])) / 7.0)


def picks_of(name, kind):
    vertices, _ = mesh_of(name)
    count = 6 if OPTIONS[kind].get("closed") else 4
    return vertices[np.linspace(40, len(vertices) - 200, count).astype(int) + np.arange(count) * 7]


def bytes_of(points, faces, barycentrics):
    return (np.asarray(points, "<f8").tobytes(), np.asarray(faces, "<i4").tobytes(), np.asarray(barycentrics, "<f8").tobytes())


def by_program(program, folder, name, kind, cores=None, environment=None):
    mesh, picks, curve = folder / f"{name}.ply", folder / f"{name}.{kind}.json", folder / "curve.json"
    if not mesh.exists():
        write_ply(mesh, *mesh_of(name), quality_of(name))
    picks.write_text(json.dumps({"picks": picks_of(name, kind).tolist()}))
    words = [program, mesh, "--picks", picks, "--output", curve]
    for key, value in OPTIONS[kind].items():
        words += [f"--{key}"] if value is True else [f"--{key}", str(value)]
    pin = None if cores is None else lambda: os.sched_setaffinity(0, cores)
    subprocess.run(words, check=True, capture_output=True, preexec_fn=pin, env={**os.environ, **(environment or {})})
    polyline = json.loads(curve.read_text())["polyline"]
    return bytes_of(polyline["points"], polyline["faces"], polyline["barycentrics"])


@pytest.fixture(scope="module")
def package(build_folder):
    sys.path.insert(0, str(build_folder / "python"))
    import bspline_curve

    return bspline_curve


@pytest.mark.parametrize("name, kind", CASES)
def test_a_curve_is_the_same_bytes_everywhere(program, package, tmp_path, name, kind):
    expected = by_program(program, tmp_path, name, kind)
    assert len(expected[1]) > 4 * 250
    core = {min(os.sched_getaffinity(0))}
    assert by_program(program, tmp_path, name, kind) == expected, "from run to run"
    assert by_program(program, tmp_path, name, kind, cores=core) == expected, "on one core"
    assert by_program(program, tmp_path, name, kind, environment=WITHOUT_AVX2) == expected, "without AVX2"
    vertices, faces = mesh_of(name)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", package.MeshWarning)
        curve = package.Mesh(vertices, faces).curve(picks_of(name, kind), **IN_PYTHON[kind])
    assert bytes_of(curve.points, curve.faces, curve.barycentrics) == expected, "by the Python package"
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(vertices, faces, v_scalar_array=quality_of(name)))
    layer = CurveLayer(draw(document, picks_of(name, kind), **OPTIONS[kind])[0])
    assert bytes_of(layer.points, layer.faces, layer.barycentric) == expected, "by the plugin"
