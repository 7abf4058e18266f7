# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes meshes whose coordinates are floats."""
from pathlib import Path

import numpy as np
import pymeshlab

SELECTED_FLAG = 1 << 5  # of vcglib


def write_ply(path, vertices, faces, selected=0):
    """Binary, with float coordinates, so that every host has the same numbers; the first faces may be selected."""
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    head += [f"property float {axis}" for axis in "xyz"]
    head += [f"element face {len(faces)}", "property list uchar int vertex_indices"] + ["property int flags"] * bool(selected) + ["end_header"]
    rows = np.zeros(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)] + [("flags", "<i4")] * bool(selected))
    rows["count"], rows["corners"] = 3, faces
    if selected:
        rows["flags"][:selected] = SELECTED_FLAG
    path.write_bytes("\n".join(head).encode() + b"\n" + np.asarray(vertices, "<f4").tobytes() + rows.tobytes())
    return path


def bunny_ply(folder):
    """Writes bunny.ply of pymeshlab's wheel into a folder; MeshLab 2020.09 ends while it reads the wheel's OBJ file."""
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"))
    mesh = document.current_mesh()
    return write_ply(folder / "bunny.ply", mesh.vertex_matrix(), mesh.face_matrix())
