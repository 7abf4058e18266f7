# SPDX-License-Identifier: GPL-3.0-or-later
"""Polylines as arrays: read from OBJ, measured, compared."""
import igl
import numpy as np


def read_obj(path):
    """Vertices and edges (from `l` elements) of a file that MeshLab wrote."""
    lines = [line.split() for line in path.read_text().splitlines()]
    vertices = np.array([[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]])
    edges = np.array([[int(word) - 1 for word in words[1:3]] for words in lines if words[:1] == ["l"]])
    return vertices, edges.reshape(-1, 2)


def length(vertices, edges):
    return np.linalg.norm(vertices[edges[:, 1]] - vertices[edges[:, 0]], axis=1).sum()


def in_order(vertices, closed):
    """The edges of a curve whose vertices are in order."""
    n = len(vertices)
    return [[i, i + 1] for i in range(n - 1)] + ([[n - 1, 0]] if closed else [])


def distance_to(points, vertices, edges):
    """The largest distance of points to a polyline."""
    start, along = vertices[edges[:, 0]], vertices[edges[:, 1]] - vertices[edges[:, 0]]
    squared = np.maximum((along**2).sum(1), np.finfo(float).tiny)
    largest = 0.0
    for point in points:
        fraction = np.clip(((point - start) * along).sum(1) / squared, 0, 1)
        largest = max(largest, np.linalg.norm(start + fraction[:, None] * along - point, axis=1).min())
    return largest


def distance(a, b):
    """The largest distance between two polylines, each given as vertices and edges."""
    return max(distance_to(a[0], *b), distance_to(b[0], *a))


def distance_to_mesh(points, vertices, faces):
    """The largest distance of points to a triangle mesh."""
    return np.sqrt(igl.point_mesh_squared_distance(points, vertices, faces.astype(np.int64))[0].max())
