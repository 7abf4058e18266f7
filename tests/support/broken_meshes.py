# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with bad spots, as arrays."""

from pathlib import Path

import made_meshes as meshes
import numpy as np
import pymeshlab

SAMPLES = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"


def append(V, F, vertices=(), faces=()):
    return np.vstack([V, np.reshape(vertices, (-1, 3))]), np.vstack([F, np.reshape(faces, (-1, 3))]).astype(int)


def spots():
    """name -> vertices, faces, the key of the report that tells, the word of the refusal"""
    V, F = meshes.plate(cells=6, height=0.1)
    n, m = len(V), len(F)
    inner = F[30]
    collapsed = V.copy()
    collapsed[F[30][0]] = collapsed[F[30][1]]
    turned = F.copy()
    turned[[7, 20, 21]] = turned[[7, 20, 21]][:, ::-1]
    cap_at = (V[inner[0]] + V[inner[1]]) / 2
    return {
        "a face that is not finite": (*append(V, F, [np.nan] * 3, [*inner[:2], n]), "left_out_faces", "finite"),
        "bow tie": (*append(V, F, [[-1, 0, 0], [-1, -1, 0]], [0, n, n + 1]), "duplicated_vertices", "vertex joins"),
        "three faces at an edge": (*append(V, F, [0.5, 0.5, 1], [*inner[:2], n]), "cut_edges", "more than two faces"),
        "duplicate faces": (*append(V, F, [], [F[3], F[9][::-1]]), "removed_duplicate_faces", "copies of one face"),
        "reversed faces": (V, turned, "reversed_faces", "opposite ways"),
        "repeated vertices": (*append(V, F, [], [F[3][0], F[3][1], F[3][1]]), "removed_degenerate_faces", "twice"),
        "edges without length": (collapsed, F, "merged_vertices", "no area"),
        "a flat face in an edge": (
            *append(V, F[np.arange(m) != 30], cap_at, [[n, inner[2], inner[0]], [inner[1], inner[2], n],
                                                       [inner[0], inner[1], n]]),
            "split_faces", "no area",
        ),
    }


def scan_with_bad_spots():
    """A scan with thirty bad spots of every kind, at seeded places."""
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(SAMPLES / "bone.ply"))
    mesh = document.current_mesh()
    V, F = mesh.vertex_matrix().copy(), mesh.face_matrix().astype(int)
    random = np.random.default_rng(5)
    faces = random.permutation(len(F))
    for f in faces[:6]:  # flaps
        V, F = append(V, F, V[F[f]].mean(0) + 0.3 * np.ptp(V[F[f]]), [F[f][0], F[f][1], len(V)])
    for f in faces[6:12]:  # copies, half of them turned
        F = np.vstack([F, F[f][:: 1 if f % 2 else -1]])
    F[faces[12:18]] = F[faces[12:18]][:, ::-1]
    for f in faces[18:24]:  # spikes that touch in a vertex
        V, F = append(V, F, V[F[f][0]] + 0.2 * np.eye(3)[:2], [F[f][0], len(V), len(V) + 1])
    for f in faces[24:30]:  # repeated vertices
        F = np.vstack([F, [F[f][0], F[f][1], F[f][1]]])
    return V, F
