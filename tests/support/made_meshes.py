# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and files for the tests, made with numpy alone."""

import struct

import numpy as np

PICKS = [[0.1, 0.2, 0.0], [0.5, 0.7, 0.0], [0.9, 0.3, 0.0]]  # on plate()


def plate(cells=12, size=1.0, height=0.0):
    """A square in the plane z = 0, or a hill of that height; vertex (i, j) has index j * (cells + 1) + i."""
    x = np.linspace(0.0, size, cells + 1)
    X, Y = np.meshgrid(x, x)
    Z = height * np.sin(np.pi * X / size) * np.sin(np.pi * Y / size)
    V = np.stack([X.ravel(), Y.ravel(), Z.ravel()], 1)
    faces = []
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i
            b, c, d = a + 1, a + cells + 2, a + cells + 1
            faces += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return V, np.array(faces)


def halved_plate(cells=12, height=0.0):
    """A plate of two halves, each with vertices of its own where they meet, and a value at the vertices that jumps there."""
    V, F = plate(cells, height=height)
    middle = np.flatnonzero(V[:, 0] == 0.5)
    copies = np.arange(len(V))
    copies[middle] = len(V) + np.arange(len(middle))
    is_right = V[F].mean(1)[:, 0] > 0.5
    values = V @ [1.0, 2.0, 0.0] + 10.0 * (V[:, 0] > 0.5)
    values = np.concatenate([values, V[middle] @ [1.0, 2.0, 0.0] + 10.0])
    return np.vstack([V, V[middle]]), np.where(is_right[:, None], copies[F], F), values


def write_ply(path, V, F, quality=None):
    """Binary, little-endian, double precision."""
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(V)}"]
    header += [f"property double {name}" for name in "xyz"] + (["property double quality"] if quality is not None else [])
    header += [f"element face {len(F)}", "property list uchar int vertex_indices", "end_header", ""]
    rows = V if quality is None else np.column_stack([V, quality])
    faces = b"".join(struct.pack("<B3i", 3, *map(int, f)) for f in F)
    path.write_bytes("\n".join(header).encode() + rows.astype("<f8").tobytes() + faces)


def write_obj(path, V, F):
    lines = ["v %.17g %.17g %.17g" % tuple(p) for p in V] + ["f %d %d %d" % tuple(f + 1) for f in F]
    path.write_text("\n".join(lines) + "\n")


def write_off(path, V, F):
    lines = ["OFF", f"{len(V)} {len(F)} 0"] + ["%.17g %.17g %.17g" % tuple(p) for p in V]
    path.write_text("\n".join(lines + ["3 %d %d %d" % tuple(f) for f in F]) + "\n")


def write_stl(path, V, F):
    """Binary: every face with vertices of its own."""
    data = bytes(80) + struct.pack("<I", len(F))
    for f in F:
        data += struct.pack("<12fH", 0, 0, 0, *V[f].ravel(), 0)
    path.write_bytes(data)


def write_stl_ascii(path, V, F):
    lines = ["solid plate"]
    for f in F:
        lines += ["facet normal 0 0 0", " outer loop"]
        lines += ["  vertex %.9g %.9g %.9g" % tuple(np.float32(p)) for p in V[f]]
        lines += [" endloop", "endfacet"]
    path.write_text("\n".join(lines + ["endsolid plate"]) + "\n")


MESH_WRITERS = {
    "plate.ply": write_ply,
    "plate.obj": write_obj,
    "plate.off": write_off,
    "plate.stl": write_stl,
    "ascii.stl": write_stl_ascii,
}
