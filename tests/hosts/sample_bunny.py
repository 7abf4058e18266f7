# SPDX-License-Identifier: GPL-3.0-or-later
"""The bunny of pymeshlab's wheel."""
from pathlib import Path

import pymeshlab
from float_ply import write_ply


def bunny_ply(folder):
    """Writes bunny.ply into a folder; MeshLab 2020.09 ends while it reads the wheel's OBJ file."""
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"))
    mesh = document.current_mesh()
    return write_ply(folder / "bunny.ply", mesh.vertex_matrix(), mesh.face_matrix())
