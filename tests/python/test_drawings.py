# SPDX-License-Identifier: GPL-3.0-or-later
"""Random drawings, nested and degenerate, are read as other readers read them: the same paths, areas to 1e-9.

BSPLINE_CURVE_DRAWINGS is how many of each format, 20 by default; the first seed is BSPLINE_CURVE_FIRST_DRAWING."""

import os
import warnings
import xml.sax.saxutils

import bspline_curve  # noqa: F401
import numpy as np
import pytest
from bspline_curve._pattern import planar_drawing

COUNT = int(os.environ.get("BSPLINE_CURVE_DRAWINGS", 20))
FIRST = int(os.environ.get("BSPLINE_CURVE_FIRST_DRAWING", 0))
NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2


def figures_of(pieces):
    """(length, centroid of the line, area within it and its chord) of pieces: functions of t in [0, 1] to points and derivatives."""
    length, moment, area = 0.0, np.zeros(2), 0.0
    for piece in pieces:
        points, speeds = piece(NODES)
        way = WEIGHTS * np.hypot(*speeds.T)
        length += way.sum()
        moment += way @ points
        area += WEIGHTS @ (points[:, 0] * speeds[:, 1] - points[:, 1] * speeds[:, 0]) / 2
    start, end = pieces[0](np.zeros(1))[0][0], pieces[-1](np.ones(1))[0][0]
    area += (end[0] * start[1] - end[1] * start[0]) / 2
    return np.array([length, *(moment / length if length else start), abs(area)])


def bezier(points, weights=()):
    """A rational Bézier arc."""
    homogeneous = np.column_stack([np.array(points, float), np.ones(len(points))])
    homogeneous *= np.array(weights)[:, None] if len(weights) else 1.0

    def curve(levels, t):
        while len(levels) > 1:
            levels = [(1 - t)[:, None] * a + t[:, None] * b for a, b in zip(levels, levels[1:])]
        return levels[0]

    def piece(t):
        levels = [np.tile(row, (len(t), 1)) for row in homogeneous]
        at, speed = curve(levels, t), (len(levels) - 1) * curve([b - a for a, b in zip(levels, levels[1:])], t)
        points = at[:, :2] / at[:, 2:]
        return points, (speed[:, :2] - points * speed[:, 2:]) / at[:, 2:]

    return piece


def ellipse(centre, right, up, start, sweep):
    """Parts of an elliptical arc, of a quarter turn at most."""
    count = max(1, int(np.ceil(abs(sweep) / (np.pi / 2) - 1e-9)))

    def part(i):
        def piece(t):
            angle = (start + sweep * (i + t) / count)[:, None]
            along = np.cos(angle) * right + np.sin(angle) * up
            return centre + along, sweep / count * (np.cos(angle) * up - np.sin(angle) * right)

        return piece

    return [part(i) for i in range(count)]


def mapped(piece, matrix, shift):
    def result(t):
        points, speeds = piece(t)
        return points @ matrix.T + shift, speeds @ matrix.T

    return result


def read(file):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # notes of what is left out
        drawing = planar_drawing(file, ())
    return np.array([figures_of([bezier(*arc) for arc in arcs]) for _, arcs in drawing.paths])


def same_paths(ours, theirs, seed):
    """Whatever their order; y of the one may be moved against that of the other."""
    theirs = theirs[theirs[:, 0] > 1e-9 * theirs[:, 0].max()]
    assert len(ours) == len(theirs), f"seed {seed}"
    size = theirs[:, 0].max()
    key = lambda rows: np.lexsort(np.round(rows[:, ::-1] / size, 7).T)  # noqa: E731
    ours, theirs = ours[key(ours)], theirs[key(theirs)]
    assert np.abs(ours[:, 3] - theirs[:, 3]).max() <= 1e-9 * size * size, f"seed {seed}: areas"
    assert np.abs(ours[:, :3] - theirs[:, :3]).max() <= 1e-6 * size, f"seed {seed}: lengths or places"


# ---- SVG ----


def number(random):
    return f"{random.uniform(-50, 50):.{random.integers(0, 7)}f}"


def path_data(random):
    """All commands, absolute and relative, and points that are there twice. svgelements goes on smoothly from Q to S and from C to T,
    and leaves arcs with a radius of 0 out, against SVG 1.1, Sect. 8.3.6 to 8.3.8 and F.6.2; where it enlarges radii that are too
    small, areas are right to 1e-7. None of these are here."""
    parts, kinds, last = [f"M {number(random)} {number(random)}"], "MLHVCSQTAZLLCQA", "M"
    counts = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "Z": 0}
    for _ in range(random.integers(0, 9)):
        letter = random.choice(list(kinds))
        if (letter == "S" and last in "QT") or (letter == "T" and last in "CS"):
            letter = "L"
        last = letter
        kind = letter if random.random() < 0.5 else letter.lower()
        if letter == "A":
            flags = random.integers(0, 2, 2)
            radii = [f"{radius:.4g}" for radius in random.uniform(75, 150, 2)]
            values = [*radii, number(random), *map(str, flags), number(random), number(random)]
        elif letter == "L" and kind == "l" and random.random() < 0.2:
            values = ["0", "0"]
        else:
            values = [number(random) for _ in range(counts[letter])]
        separator = random.choice([" ", ",", "\n"])
        parts.append(kind + separator.join(values))
    return random.choice(["", " "]).join(parts)


def shape(random):
    size = lambda low=0.5: f"{random.uniform(low, 40):.5g}"  # noqa: E731
    kind = random.choice(["rect", "round", "circle", "ellipse", "line", "polyline", "polygon", "path", "path", "path", "bad"])
    if kind == "rect":
        return f'<rect x="{number(random)}" y="{number(random)}" width="{size()}" height="{size()}"/>'
    if kind == "round":
        given = random.choice(["rx", "ry", "both"])
        radii = "".join(f' {name}="{size()}"' for name in (["rx", "ry"] if given == "both" else [given]))
        return f'<rect x="{number(random)}" width="{size()}" height="{size()}"{radii}/>'
    if kind == "circle":
        return f'<circle cx="{number(random)}" cy="{number(random)}" r="{size()}"/>'
    if kind == "ellipse":
        return f'<ellipse cy="{number(random)}" rx="{size()}" ry="{size()}"/>'
    if kind == "line":
        return f'<line x1="{number(random)}" y1="{number(random)}" x2="{number(random)}" y2="{number(random)}"/>'
    if kind in ("polyline", "polygon"):
        points = " ".join(f"{number(random)},{number(random)}" for _ in range(random.integers(2, 7)))
        return f'<{kind} points="{points}"/>'
    if kind == "path":
        return f"<path d={xml.sax.saxutils.quoteattr(path_data(random))}/>"
    return random.choice(['<circle r="0"/>', '<path d="M 1 1 L 1 1"/>', '<rect width="0" height="3"/>', '<path d="M 3 4"/>',
                          '<polygon points="2,2 2,2"/>', "<g/>", '<g display="none"><circle r="9"/></g>'])


def transform(random):
    def one():
        kind = random.choice(["translate", "scale", "rotate", "skewX", "skewY", "matrix", "about"])
        value = lambda low, high: f"{random.uniform(low, high):.4g}"  # noqa: E731
        if kind == "translate":
            return f"translate({value(-9, 9)},{value(-9, 9)})"
        if kind == "scale":
            return f"scale({value(0.5, 2)} {value(-2, -0.5)})" if random.random() < 0.5 else f"scale({value(0.5, 2)})"
        if kind == "about":
            return f"rotate({value(-180, 180)} {value(-9, 9)} {value(-9, 9)})"
        if kind == "matrix":
            return f"matrix({value(0.7, 1.3)} {value(-0.3, 0.3)} {value(-0.3, 0.3)} {value(0.7, 1.3)} {value(-9, 9)} {value(-9, 9)})"
        return f"{kind}({value(-30, 30)})"

    return " ".join(one() for _ in range(random.integers(1, 3)))


def group(random, depth=0):
    inside = "".join(
        group(random, depth + 1) if depth < 4 and random.random() < 0.3 else shape(random) for _ in range(random.integers(1, 4))
    )
    placed = f' transform="{transform(random)}"' if random.random() < 0.7 else ""
    return f"<g{placed}>{inside}</g>"


def random_svg(random):
    used = f'<defs><g id="a">{shape(random)}{shape(random)}</g></defs>'
    uses = "".join(
        f'<use href="#a" x="{number(random)}" y="{number(random)}" transform="{transform(random)}"/>' for _ in range(random.integers(0, 3))
    )
    body = "".join(group(random) for _ in range(3))
    return f'<svg xmlns="http://www.w3.org/2000/svg">{used}{body}{uses}<circle r="1"/></svg>'


def paths_of_svgelements(file):
    """Figures of the subpaths that svgelements reads, y upwards; arcs are kept as ellipses, so that skewing keeps them exact."""
    svgelements = pytest.importorskip("svgelements")

    def pieces_of(segment):
        if isinstance(segment, svgelements.Arc):
            centre, right, up = (np.array([p.x, p.y]) for p in (segment.center, segment.prx, segment.pry))
            start = segment.get_start_t()
            return ellipse(centre, right - centre, up - centre, start, segment.sweep)
        points = {"Line": "start end", "Close": "start end", "QuadraticBezier": "start control end",
                  "CubicBezier": "start control1 control2 end"}[type(segment).__name__]
        corners = [getattr(segment, name) for name in points.split()]
        return [] if None in corners else [bezier([(p.x, p.y) for p in corners])]

    found = []
    for element in svgelements.SVG.parse(str(file), reify=False).elements():
        if not isinstance(element, svgelements.Shape):
            continue
        m = element.transform
        matrix, shift = np.array([[m.a, m.c], [-m.b, -m.d]]), np.array([m.e, -m.f])
        if isinstance(element, svgelements.Path):
            path = element
        else:
            path = svgelements.Path(element.segments(transformed=False))
        for subpath in path.as_subpaths():
            pieces = [p for segment in subpath if not isinstance(segment, svgelements.Move) for p in pieces_of(segment)]
            if pieces:
                found.append(figures_of([mapped(piece, matrix, shift) for piece in pieces]))
    return np.array(found)


@pytest.mark.parametrize("seed", range(FIRST, FIRST + COUNT))
def test_random_svgs_are_those_of_svgelements(tmp_path, seed):
    file = tmp_path / "a.svg"
    file.write_text(random_svg(np.random.default_rng(seed)))
    same_paths(read(file), paths_of_svgelements(file), seed)


# ---- DXF ----


def random_entities(random, layout, doc, depth=0):
    at = lambda: tuple(random.uniform(-3, 3, 2))  # noqa: E731
    kinds = ["line", "circle", "arc", "ellipse", "light", "old", "spline", "rational", "insert", "bad"]
    for kind in random.choice(kinds, random.integers(2, 7)):
        mirrored = {"extrusion": (0, 0, int(random.choice([-1, 1])))}
        if kind == "line":
            layout.add_line(at(), at())
        elif kind == "circle":
            layout.add_circle(at(), random.uniform(0.1, 2), mirrored)
        elif kind == "arc":
            layout.add_arc(at(), random.uniform(0.1, 2), *random.uniform(0, 360, 2), dxfattribs=mirrored)
        elif kind == "ellipse":
            layout.add_ellipse(at(), (*random.uniform(0.5, 2, 2), 0), random.uniform(0.1, 1), *random.uniform(0, 6.2, 2))
        elif kind in ("light", "old"):
            points = [(*at(), float(random.choice([0, random.uniform(-1.5, 1.5)]))) for _ in range(random.integers(2, 6))]
            points += points[-1:] if random.random() < 0.2 else []
            add = layout.add_lwpolyline if kind == "light" else layout.add_polyline2d
            add(points, format="xyb", close=bool(random.integers(2)), dxfattribs=mirrored)
        elif kind in ("spline", "rational"):
            points, degree = [(*at(), 0) for _ in range(7)], int(random.integers(2, 5))
            if kind == "spline":
                layout.add_open_spline(points, degree=degree)
            else:
                layout.add_rational_spline(points, random.uniform(0.3, 2, 7).tolist(), degree=degree)
        elif kind == "bad":
            layout.add_circle(at(), 0.0)
            layout.add_line((1, 1), (1, 1))
        elif kind == "insert" and depth < 4:
            block = doc.blocks.new(name=f"B{len(doc.blocks)}", base_point=at())
            random_entities(random, block, doc, depth + 1)
            layout.add_blockref(block.name, at(), {
                "xscale": random.choice([1, -0.7]), "yscale": random.uniform(0.5, 1), "rotation": random.uniform(0, 360),
                "column_count": int(random.integers(1, 3)), "column_spacing": 7.0})


def pieces_of_entity(entity):
    """Of an entity of ezdxf, in the coordinates of its layout."""
    from ezdxf.math import bulge_to_arc

    flip = -1.0 if entity.dxf.hasattr("extrusion") and entity.dxf.extrusion.z < 0 else 1.0
    kind = entity.dxftype()
    plane = lambda p: np.array([p[0], p[1]])  # noqa: E731
    unit = np.eye(2)
    if kind == "LINE":
        return [bezier([plane(entity.dxf.start), plane(entity.dxf.end)])]
    if kind in ("CIRCLE", "ARC"):
        start, end = (0.0, 360.0) if kind == "CIRCLE" else (entity.dxf.start_angle, entity.dxf.end_angle)
        sweep = 360.0 if kind == "CIRCLE" else (end - start) % 360.0
        radius = entity.dxf.radius
        arcs = ellipse(plane(entity.dxf.center), radius * unit[0], radius * unit[1], np.radians(start), np.radians(sweep))
    elif kind == "ELLIPSE":
        start, end = entity.dxf.start_param, entity.dxf.end_param
        right = plane(entity.dxf.major_axis)
        return ellipse(plane(entity.dxf.center), right, entity.dxf.ratio * np.array([-right[1], right[0]]), start,
                       (end - start) % (2 * np.pi) or 2 * np.pi)
    elif kind in ("LWPOLYLINE", "POLYLINE"):
        points = list(entity.get_points("xyb")) if kind == "LWPOLYLINE" else [
            (*plane(v.dxf.location), v.dxf.get("bulge", 0.0)) for v in entity.vertices]
        closed = entity.closed if kind == "LWPOLYLINE" else entity.is_closed
        arcs = []
        for (*a, bulge), (*b, _) in zip(points, points[1:] + points[:1] if closed else points[1:]):
            if a == b:
                continue
            if bulge == 0.0:
                arcs.append(bezier([a, b]))
                continue
            centre, start, end, radius = bulge_to_arc(a, b, bulge)
            sweep = (end - start) % (2 * np.pi)
            start, sweep = (start, sweep) if bulge > 0 else (start + sweep, -sweep)
            arcs += ellipse(plane(centre), radius * unit[0], radius * unit[1], start, sweep)
    else:
        spline = entity.construction_tool()
        knots = np.unique(spline.knots())

        def span(low, high):
            def piece(t):
                rows = [spline.derivative(low + (high - low) * s, 1) for s in t]
                return (np.array([plane(row[0]) for row in rows]), (high - low) * np.array([plane(row[1]) for row in rows]))

            return piece

        return [span(low, high) for low, high in zip(knots, knots[1:])]
    return [mapped(piece, np.diag([flip, 1.0]), np.zeros(2)) for piece in arcs]


def paths_of_ezdxf(entities, matrix):
    for entity in entities:
        if entity.dxftype() == "INSERT":
            for one in entity.multi_insert() if entity.mcount > 1 else [entity]:
                yield from paths_of_ezdxf(one.block(), one.matrix44() * matrix)
            continue
        pieces = [] if entity.dxftype() == "CIRCLE" and entity.dxf.radius == 0 else pieces_of_entity(entity)
        if pieces:
            rows = np.array([[*p] for p in matrix.transform_vertices([(0, 0, 0), (1, 0, 0), (0, 1, 0)])])[:, :2]
            yield figures_of([mapped(piece, (rows[1:] - rows[0]).T, rows[0]) for piece in pieces])


@pytest.mark.parametrize("seed", range(FIRST, FIRST + COUNT))
def test_random_dxf_drawings_have_the_areas_of_ezdxf(tmp_path, seed):
    ezdxf = pytest.importorskip("ezdxf")
    random = np.random.default_rng(seed)
    doc = ezdxf.new("R2010")
    doc.modelspace().add_circle((0, 0), 1)
    random_entities(random, doc.modelspace(), doc)
    file = tmp_path / "a.dxf"
    doc.saveas(file)
    same_paths(read(file), np.array(list(paths_of_ezdxf(doc.modelspace(), ezdxf.math.Matrix44()))), seed)
