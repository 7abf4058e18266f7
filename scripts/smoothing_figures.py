#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of docs/SMOOTH_CURVES.md: curves of jagged labels and shaky picks, corners and directions.

    .cache/venv/bin/python scripts/smoothing_figures.py [--only NAME] [--output docs/images]

Meshes are those that pymeshlab's wheel ships, and a ball made by a rule.
"""
import numpy as np
from using_curves_figures import (
    BLUE,
    RED,
    STONE,
    Work,
    draw_figures,
    hues,
    line_shape,
    packaged_mesh,
    picture,
    seen_at,
    surface,
)

SEED = 7
DARK = (0.15, 0.15, 0.18)
TURNS = np.linspace(0, 2 * np.pi, 12, endpoint=False)


# ---------------------------------------------------------------- shapes
def ball(cells=60):
    """The unit ball: a cube whose sides are grids, blown up."""
    line = np.tan(np.linspace(-np.pi / 4, np.pi / 4, cells + 1))
    u, v = (each.ravel() for each in np.meshgrid(line, line, indexing="ij"))
    ones = np.ones_like(u)
    sides = [(u, v, ones), (v, u, -ones), (ones, u, v), (-ones, v, u), (v, ones, u), (u, -ones, v)]
    points = np.concatenate([np.stack(side, 1) for side in sides])
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1, 1)
    grid = np.concatenate([corner + [0, cells + 1, cells + 2], corner + [0, cells + 2, 1]])
    faces = np.concatenate([grid + k * len(u) for k in range(len(sides))])
    # The sides share the points of their edges.
    _, first, place = np.unique(np.round(points, 9), axis=0, return_index=True, return_inverse=True)
    return points[first], place.reshape(-1)[faces]


def dots(points, radius, colour):
    """A small ball at each point."""
    vertices, faces = ball(4)
    shapes = []
    for point in points:
        shapes.append((point + radius * vertices, faces, vertices, np.array(colour)))
    return shapes


def edge_lines(vertices, faces, labels, radius, colour=DARK):
    """The edges between faces of different labels, as tubes."""
    sides = np.sort(np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    owner = np.tile(np.arange(len(faces)), 3)
    order = np.lexsort(sides.T)
    sides, owner = sides[order], owner[order]
    same = np.flatnonzero((sides[1:] == sides[:-1]).all(1))
    kept = same[labels[owner[same]] != labels[owner[same + 1]]]
    return [line_shape(vertices[sides[i]], radius, colour) for i in kept]


# ---------------------------------------------------------------- pictures
def labels(folder):
    """Three labels of faces, whose boundaries are jagged; the curves of them; the mesh cut along these."""
    vertices, faces = packaged_mesh("bunny10k_textured")
    view = (0.25, 0.25, 1.0)
    work = Work(folder, vertices, faces)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    one, other = seen_at(vertices, faces, view, [(0.55, 0.34), (0.68, 0.26)])
    middles = vertices[faces].mean(1)
    near, far = (np.linalg.norm(middles - at, axis=1) for at in (one, other))
    given = np.where((near < 0.1 * size) & (near <= far), 1, np.where(far < 0.11 * size, 2, 0))
    np.savetxt(work.folder / "labels.txt", given, fmt="%d")
    work.run("fit", "--labels", "labels.txt", "--output", "boundary.json")
    files = sorted(work.folder.glob("boundary*.json"))
    lines = [work.line(file.name) for file in files]
    work.run("segment", *(word for file in files for word in ("--curve", file)), "--output", "parts.ply")
    told, cut, parts = work.mesh("parts.ply")
    window = ((one + other) / 2, 0.17 * size)
    colours = np.vstack([STONE, hues(3)])
    # Parts have the colour of the label that most of them had.
    centres = told[cut].mean(1)
    named = {}
    for part in np.unique(parts):
        chosen = centres[parts == part][::25]
        named[part] = np.bincount([given[np.linalg.norm(middles - c, axis=1).argmin()] for c in chosen]).argmax()
    smooth = np.array([named[part] for part in parts])
    jagged = edge_lines(vertices, faces, given, 0.0012 * size)
    curves = [line_shape(line, 0.0022 * size) for line in lines]
    return [picture([surface(vertices, faces, colours[given]), *jagged], view, (420, 420), window),
            picture([surface(vertices, faces, colours[given]), *curves], view, (420, 420), window),
            picture([surface(told, cut, colours[smooth])], view, (420, 420), window)]


def margin(folder):
    """A margin of shaky picks: the curve through them, one within a tolerance of them, one fitted to the line through them."""
    vertices, faces = packaged_mesh("bone")
    work, view = Work(folder, vertices, faces), (0.2, 1.0, 0.1)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    random = np.random.default_rng(SEED)
    reach = 0.065 + random.normal(0, 0.0035, 30)
    turn = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    places = np.array((0.33, 0.87)) + reach[:, None] * np.stack([np.cos(turn), np.sin(turn)], 1)
    picks = seen_at(vertices, faces, view, places)
    shaky = work.curve("shaky", picks)
    near = work.curve("near", picks, "--pick-tolerance", 0.007 * size)
    words = [*(f"v {x!r} {y!r} {z!r}" for x, y, z in picks.tolist()), "l " + " ".join(map(str, [*range(1, len(picks) + 1), 1]))]
    (work.folder / "line.obj").write_text("\n".join(words) + "\n")
    work.run("fit", "--line", "line.obj", "--deviation", 0.015 * size, "--output", "fitted.json")
    fitted = work.line("fitted.json")
    window = (shaky.mean(0), 0.12 * size)
    marks = dots(picks, 0.0035 * size, DARK)
    return [picture([surface(vertices, faces), line_shape(line, 0.0028 * size), *marks], view, (420, 420), window)
            for line in (shaky, near, fitted)]


def heart(folder):
    """A heart on a ball: without corners, with two, and with directions on their sides as well."""
    vertices, faces = ball()
    work, view, up = Work(folder, vertices, faces), (0, 0, 1), (0, 1, 0)
    x = 16 * np.sin(TURNS) ** 3
    y = 13 * np.cos(TURNS) - 5 * np.cos(2 * TURNS) - 2 * np.cos(3 * TURNS) - np.cos(4 * TURNS)
    picks = np.stack([0.034 * x, 0.034 * y + 0.08, np.ones(12)], 1)
    picks /= np.linalg.norm(picks, axis=1, keepdims=True)
    images = []
    corners = ("--corners", "1,7")
    sides = ("--tangents", "1: 0, -1, 0 / 0, 1, 0; 7: -0.5, -1, 0 / -0.5, 1, 0")
    for name, words in (("round", ()), ("heart", corners), ("led", (*corners, *sides))):
        line = work.curve(name, picks, *words)
        images.append(picture([surface(vertices, faces), line_shape(line, 0.012), *dots(picks, 0.02, DARK)], view, (420, 420), up=up))
    return images


def direction(folder):
    """A curve through three picks, and the same that leaves its ends upwards and passes the middle level."""
    vertices, faces = ball()
    work, view, up = Work(folder, vertices, faces), (0, 0, 1), (0, 1, 0)
    picks = np.array([(-0.6, -0.15, 1), (0, 0.25, 1), (0.6, -0.3, 1)], float)
    picks /= np.linalg.norm(picks, axis=1, keepdims=True)
    given = np.array([(0, 1, 0), (1, -0.4, 0), (0, 1, 0)], float)
    text = "; ".join(f"{i + 1}: {x:g}, {y:g}, {z:g}" for i, (x, y, z) in enumerate(given))
    images = []
    for name, words, arrows in (("free", (), False), ("aligned", ("--tangents", text), True)):
        line = work.curve(name, picks, *words, closed=False)
        shapes = [surface(vertices, faces), line_shape(line, 0.012), *dots(picks, 0.02, DARK)]
        if arrows:
            for pick, way in zip(picks, given):
                along = way - way @ pick * pick
                shapes.append(line_shape(1.012 * np.array([pick, pick + 0.22 * along / np.linalg.norm(along)]), 0.008, BLUE))
        images.append(picture(shapes, view, (420, 420), up=up))
    return images


def join(folder):
    """Two curves, the same as one at corners, smoothly, and longer at both ends."""
    vertices, faces = ball()
    work, view, up = Work(folder, vertices, faces), (0, 0, 1), (0, 1, 0)
    for name, places in {"one": [(-0.8, -0.2, 1), (-0.45, 0.2, 1), (-0.1, 0.1, 1)],
                         "other": [(0.08, 0.02, 1), (0.3, -0.3, 1), (0.7, -0.1, 1)]}.items():
        points = np.array(places, float)
        work.curve(name, points / np.linalg.norm(points, axis=1, keepdims=True), closed=False)
    words = ("--curve", "one.json", "--curve", "other.json", "--join", "--gap", 0.3)
    work.run("edit", *words, "--output", "corner.json")
    work.run("edit", *words, "--smooth", "--blend", 0.12, "--output", "smooth.json")
    work.run("edit", "--curve", "smooth.json", "--extend", 0.4, "--at", "both", "--output", "longer.json")
    images = []
    for names, colours in ((("one", "other"), (RED, BLUE)), (("corner",), (RED,)), (("longer", "smooth"), (BLUE, RED))):
        lines = [line_shape(work.line(name + ".json"), radius, colour)
                 for name, colour, radius in zip(names, colours, (0.012, 0.0125))]
        images.append(picture([surface(vertices, faces), *lines], view, (420, 420), up=up))
    return images


FIGURES = {"labels": labels, "margin": margin, "heart": heart, "direction": direction, "join": join}


if __name__ == "__main__":
    draw_figures(__doc__.splitlines()[0], FIGURES, "smooth")
