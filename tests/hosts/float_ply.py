# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes meshes whose coordinates are floats."""
import numpy as np


def write_ply(path, vertices, faces):
    """Binary, with float coordinates, so that every host has the same numbers."""
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    head += [f"property float {axis}" for axis in "xyz"]
    head += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    path.write_bytes("\n".join(head).encode() + b"\n" + np.asarray(vertices, "<f4").tobytes() + rows.tobytes())
    return path
