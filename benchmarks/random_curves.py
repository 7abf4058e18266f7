# SPDX-License-Identifier: GPL-3.0-or-later
"""Random polylines strictly on meshes, for benchmarks/random_imprints.py: each a list of (face, barycentric coordinates)."""
import numpy as np

MOST_STEPS = 60  # faces that a walk passes


class Mesh:
    """A triangle mesh with the faces beside and around."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = np.asarray(vertices, float), np.asarray(faces, int)
        owner = {}
        for face, (a, b, c) in enumerate(self.faces.tolist()):
            owner[a, b], owner[b, c], owner[c, a] = (face, 2), (face, 0), (face, 1)  # opposite corners
        self.beside = np.full((len(self.faces), 3), -1)  # across the side opposite to each corner
        for (a, b), (face, k) in owner.items():
            self.beside[face, k] = owner.get((b, a), (-1, 0))[0]
        order = np.argsort(self.faces.ravel(), kind="stable")
        self.around_faces = order // 3
        self.around_start = np.searchsorted(self.faces.ravel()[order], np.arange(len(self.vertices) + 1))
        rim = {v for (a, b) in owner if (b, a) not in owner for v in (a, b)}
        self.rim = np.zeros(len(self.vertices), bool)
        self.rim[list(rim)] = True

    def around(self, vertex):
        return self.around_faces[self.around_start[vertex]:self.around_start[vertex + 1]]

    def position(self, point):
        face, weights = point
        return weights @ self.vertices[self.faces[face]]

    def holders(self, point):
        """All faces that hold a point."""
        face, weights = point
        zero = np.flatnonzero(weights == 0)
        if len(zero) == 2:
            return self.around(self.faces[face][weights.argmax()])
        if len(zero) == 1 and self.beside[face, zero[0]] >= 0:
            return np.array([face, self.beside[face, zero[0]]])
        return np.array([face])

    def seen_from(self, point, face):
        """The same point in another face that holds it."""
        own, weights = point
        result = np.zeros(3)
        for k in np.flatnonzero(weights):
            result[np.flatnonzero(self.faces[face] == self.faces[own][k])[0]] = weights[k]
        return face, result


def cleared(weights):
    weights = np.clip(weights, 0, None)
    return weights / weights.sum()


def point_in(random, face):
    """Inside, on a side or at a corner; now and then hardly off a side."""
    weights, kind, k = random.dirichlet(np.ones(3)), random.integers(10), random.integers(3)
    if kind < 6:
        weights[k] = 0
    elif kind == 6:
        weights = np.eye(3)[k]
    elif kind < 9:
        weights[k] = 1e-11 if kind == 7 else 1e-7
    return int(face), cleared(weights)


# ---------------------------------------------------------------- the kinds of curves
def hops(mesh, random, face):
    """From point to point of neighbouring faces: back and forth, through vertices and along edges."""
    points = [point_in(random, face)]
    for _ in range(random.integers(1, 25)):
        points.append(point_in(random, random.choice(mesh.holders(points[-1]))))
    return points, False


def straight(mesh, random, face, bend=0.0):
    """Straight on over the faces, or turning a little in each, up to the boundary or so many faces."""
    weights = cleared(random.dirichlet(np.ones(3) * 2))
    points = [(int(face), weights)]
    a, b, c = mesh.vertices[mesh.faces[face]]
    normal = np.cross(b - a, c - a)
    direction = (b - a) + random.normal() * np.cross(normal, b - a) / np.linalg.norm(normal)
    for _ in range(random.integers(2, MOST_STEPS)):
        corners = mesh.vertices[mesh.faces[face]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        direction = direction - (direction @ normal) * normal
        direction = np.cos(bend) * direction + np.sin(bend) * np.cross(normal, direction)
        # Change of the barycentric coordinates along the way.
        slope = np.array([np.cross(normal, corners[(k + 2) % 3] - corners[(k + 1) % 3]) @ direction for k in range(3)])
        slope /= np.linalg.norm(np.cross(corners[1] - corners[0], corners[2] - corners[0]))
        ways = [(-weights[k] / slope[k], k) for k in range(3) if slope[k] < 0 and weights[k] > 0]
        if not ways:
            break
        way, side = min(ways)
        weights = weights + way * slope
        weights[side] = 0.0
        weights = cleared(weights)
        points.append((int(face), weights))
        beyond = mesh.beside[face, side]
        if beyond < 0 or (weights == 0).sum() > 1:
            break
        axis = corners[(side + 2) % 3] - corners[(side + 1) % 3]
        across = mesh.vertices[mesh.faces[beyond]]
        other = np.cross(across[1] - across[0], across[2] - across[0])
        other /= np.linalg.norm(other)
        axis /= np.linalg.norm(axis)
        along, aside = direction @ axis, direction @ np.cross(normal, axis)
        direction = along * axis + aside * np.cross(other, axis)
        face, weights = mesh.seen_from(points[-1], beyond)
    return points, False


def turning(mesh, random, face):
    """The same, turning so much that it crosses itself."""
    return straight(mesh, random, face, random.choice([-1, 1]) * random.uniform(0.1, 0.5))


def in_one_face(mesh, random, face):
    points = [point_in(random, face) for _ in range(random.integers(3, 9))]
    return points, bool(random.integers(2))


def along_edges(mesh, random, face):
    """From vertex to vertex; closed where it comes back to where it began."""
    points = [(int(face), np.eye(3)[random.integers(3)])]
    first = mesh.faces[face][points[0][1].argmax()]
    for step in range(random.integers(1, 20)):
        around = random.choice(mesh.holders(points[-1]))
        vertex = mesh.faces[points[-1][0]][points[-1][1].argmax()]
        choices = [k for k in range(3) if mesh.faces[around][k] != vertex]
        points.append((int(around), np.eye(3)[random.choice(choices)]))
        if step > 1 and mesh.faces[around][points[-1][1].argmax()] == first:
            return points[:-1], True
    return points, False


def round_a_vertex(mesh, random, face):
    vertex = mesh.faces[face][random.integers(3)]
    if mesh.rim[vertex]:
        return in_one_face(mesh, random, face)
    points, at = [], face
    while True:
        k = int(np.flatnonzero(mesh.faces[at] == vertex)[0])
        weights = np.zeros(3)
        weights[(k + 2) % 3] = random.uniform(0.05, 1.0)
        weights[k] = 1 - weights[(k + 2) % 3]
        points.append((int(at), weights))
        at = mesh.beside[at, (k + 1) % 3]
        if at == face:
            return points, True


def section(mesh, random, face):
    """The cut with a random plane: closed, or from boundary to boundary; hops in its place where it passes a vertex."""
    normal = random.normal(size=3)
    through = mesh.position((face, random.dirichlet(np.ones(3))))
    heights = (mesh.vertices - through) @ (normal / np.linalg.norm(normal))
    found = section_by(mesh, heights, face)
    return found if found is not None else hops(mesh, random, face)


def section_by(mesh, heights, face):
    """The line where heights of vertices are 0 that passes a face; none where it passes a vertex, or not the face."""
    def exits(at):
        h = heights[mesh.faces[at]]
        return [k for k in range(3) if (h[(k + 1) % 3] > 0) != (h[(k + 2) % 3] > 0)]

    def on_side(at, k):
        h = heights[mesh.faces[at]]
        weights, low, high = np.zeros(3), (k + 1) % 3, (k + 2) % 3
        weights[high] = h[low] / (h[low] - h[high])
        weights[low] = 1 - weights[high]
        return int(at), weights

    def follow(side):
        points, at = [], face
        while True:
            points.append(on_side(at, side))
            beyond = mesh.beside[at, side]
            if beyond < 0:
                return points, False
            ends = set(mesh.faces[at]) - {mesh.faces[at][side]}
            side = next(k for k in exits(beyond) if mesh.faces[beyond][k] in ends)
            at = beyond
            if at == face:
                return points, True

    if len(exits(face)) != 2 or (heights == 0).any():
        return None
    points, closed = follow(exits(face)[0])
    if closed:
        return points, True
    others, _ = follow(exits(face)[1])
    return others[::-1] + points, False


KINDS = (hops, straight, turning, in_one_face, along_edges, round_a_vertex, section)


def without_repetitions(mesh, points, closed):
    """Neighbours that are at the same place once; nothing where too few are left."""
    kept = []
    for point in points:
        if not kept or not np.array_equal(mesh.position(point), mesh.position(kept[-1])):
            kept.append(point)
    if closed and len(kept) > 1 and np.array_equal(mesh.position(kept[0]), mesh.position(kept[-1])):
        kept.pop()
    return kept if len(kept) >= (3 if closed else 2) else None


def random_set(mesh, random, count=None):
    """One to eight curves as (kind, points, closed), half of them near the first."""
    curves, home = [], int(random.integers(len(mesh.faces)))
    wanted = int(random.integers(1, 9)) if count is None else count
    while len(curves) < wanted:
        kind = KINDS[random.integers(len(KINDS))]
        face = home if random.integers(2) else int(random.integers(len(mesh.faces)))
        points, closed = kind(mesh, random, face)
        points = without_repetitions(mesh, points, closed)
        if points is not None:
            curves.append((kind.__name__, points, closed))
    return curves


def as_json(mesh, points, closed):
    """A curve file as the program writes it, but for the spline and the mesh's checksum."""
    line = {"points": [mesh.position(p).tolist() for p in points], "faces": [int(p[0]) for p in points],
            "barycentrics": [p[1].tolist() for p in points]}
    return {"closed": bool(closed), "polyline": line}
