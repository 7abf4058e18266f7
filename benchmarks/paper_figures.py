#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remakes the figures of the paper, each with its claim and the number that supports or contradicts it.

    benchmarks/paper_figures.py                     # pictures into docs/images, text to the terminal
    benchmarks/paper_figures.py --page              # and the text into docs/PAPER.md
    benchmarks/paper_figures.py --only 9 10 --size 200

The paper's meshes are not public: there are the bunny of pymeshlab's wheel, and meshes made by a rule. Every
figure has the curve of preset=paper (blue) and that of the default (red). Needs requirements.txt and the Python package of
the build (-DBSPLINE_CURVE_PYTHON=ON).
"""
import argparse
import re
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "build" / "release" / "python"))
import bspline_curve  # noqa: E402
from bspline_curve._rendering import MESH_COLOUR, camera, normalised  # noqa: E402
from cases import farthest_picks  # noqa: E402
from paper_pictures import DARK, SIZE, Panel, Scene, graph, heat, montage, panel, pixels, ring  # noqa: E402
from paper_scenes import (  # noqa: E402
    PRESETS, apart, both, bunny, bunny_picks, draw, each, fluted_vase, grooved_plate, nearest, prepared, scene_of,
    smooth_torus, sphere,
)
from polyline_method import compare  # noqa: E402
from render_shell import edge_tubes, flat  # noqa: E402
from surface_baselines import (  # noqa: E402
    bezier_by_geodesics, geodesic, heat_level_set, phong_spline, projected_spline,
)

PAGE = ROOT / "docs" / "PAPER.md"
IMAGES = ROOT / "docs" / "images"
BEGIN, END = "<!-- figures: made by benchmarks/paper_figures.py -->\n", "<!-- end of figures -->\n"
GREEN, YELLOW = np.array((20, 140, 80)) / 255, np.array((226, 160, 20)) / 255


@dataclass
class Figure:
    number: int
    title: str
    claim: str
    make: object


FIGURES = []
# A curve that is taken as it is after the first steps.
FIRST_STEPS = {"max_rounds": 1, "max_iterations": 1, "distance_tolerance": 1000.0}


def figure(number, title, claim):
    def add(make):
        FIGURES.append(Figure(number, title, claim, make))
        return make
    return add


# ---------------------------------------------------------------- the figures
@figure(1, "The simplified shell", "The shell of [8] is highly simplified, and holds the surface between two layers.")
def shell_figure():
    mesh = bunny()
    shell = prepared(mesh, "paper").shell()
    panels = [panel("mesh", Scene(*mesh))]
    for name, layer in (("top", shell.top), ("bottom", shell.bottom)):
        vertices, faces = np.asarray(layer.vertices), np.asarray(layer.faces)
        diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
        points, own, normals = flat(vertices, faces)
        tubes, quads, around = edge_tubes(vertices, faces, 0.0012 * diagonal)
        shapes = [(points, own, normals, MESH_COLOUR), (tubes, quads, around, DARK)]
        panels.append(Panel(f"{name} layer", pixels(shapes, vertices, camera((0, 0, 1), (0, 1, 0)))))
    return panels, f"{len(mesh[1]):,} faces become {len(shell.top.faces):,} prisms."


@figure(3, "The first curve", "A control polygon that runs to either side of the surface in turn, with points of Dijkstra's path "
        "between where a segment leaves the shell, begins the method.")
def first_curve():
    mesh = bunny()
    picks = bunny_picks(mesh)
    first = draw(mesh, picks, "paper", **FIRST_STEPS)
    last = draw(mesh, picks, "paper")
    polygon = np.asarray(first.control_points)
    scene = Scene(*mesh, [(polygon, GREEN), (first.spline(np.linspace(0, 1, 200)), YELLOW)], list(picks))
    return ([panel("first steps: polygon, spline", scene), panel("at the end", scene_of(mesh, {"paper": last}, picks))],
            f"{first.report['knots_first']} knots at the start, {last.report['knots_last']} at the end.")


@figure(5, "The energy by iteration", "Within a round the energy falls; it jumps where knots come in and weights change.")
def energy_graph():
    mesh = bunny()
    picks = bunny_picks(mesh)
    panels, said = [], []
    for preset, colour in PRESETS:
        report = draw(mesh, picks, preset).report
        totals = np.array([entry["total"] for entry in report["iterations"]])
        rounds = np.array([entry["round"] for entry in report["iterations"]])
        starts = [0] + [i for i in range(1, len(rounds)) if rounds[i] != rounds[i - 1]]
        panels.append(graph(f"{preset}: energy", [(totals, starts, colour)], [preset]))
        rises = sum(totals[i] > totals[i - 1] * (1 + 1e-9) for i in range(1, len(rounds)) if rounds[i] == rounds[i - 1])
        said.append(f"`{preset}` {len(starts)} rounds, {len(totals)} iterations, {rises} of which raise the energy within a round")
    return panels, "; ".join(said) + "."


@figure(6, "A curve that begins outside the shell", "Heights scaled by η let a curve begin outside the shell, and the method brings "
        "it back to the surface.")
def outside():
    mesh = bunny()
    picks = bunny_picks(mesh)
    thin = {"target_thickness": 0.02}
    prepared_thin = bspline_curve.Mesh(*mesh, shell="simplified", **thin)
    few = prepared_thin.curve(picks[[0, 1, 3]], preset="paper", **FIRST_STEPS)
    curve = prepared_thin.curve(picks[[0, 1, 3]], preset="paper")
    start = few.spline(np.linspace(0, 1, 300))
    return ([panel("first steps, in a thin shell", Scene(*mesh, [(start, YELLOW)], list(picks[[0, 1, 3]]))),
             panel("at the end", scene_of(mesh, {"paper": curve}, picks[[0, 1, 3]]))],
            f"In a shell of a seventh of the usual thickness the first curve is {few.report['max_distance']:.3g} edges from the "
            f"surface, the last {curve.report['max_distance']:.2g} ({curve.report['status']}).")


@figure(7, "Against splines that are projected [21]", "Points of a spline in space, projected one by one, can miss the surface or "
        "leave gaps; by the shell's map the curve stays whole.")
def projected():
    mesh = bunny()
    low, size = mesh[0].min(0), np.ptp(mesh[0], axis=0)
    picks = nearest(mesh, *(low + np.array(share) * size for share in ((0.3, 0.45, 1), (0.2, 0.95, 0.6), (0.72, 0.9, 0.6), (0.8, 0.45, 1))))
    curves = both(mesh, picks)
    rivals = {"closest point": projected_spline(prepared(mesh, "default"), picks), "Phong": phong_spline(prepared(mesh, "default"), picks)}
    panels = [panel("paper (blue), default (red)", scene_of(mesh, curves, picks))]
    said = []
    for name, line in rivals.items():
        jumps = np.linalg.norm(np.diff(line.points, axis=0), axis=1)
        gap = jumps.max() / np.median(jumps)
        breaks = int((jumps > 8 * np.median(jumps)).sum())
        panels.append(panel(name, Scene(*mesh, [(part, GREEN) for part in line.parts()], list(picks))))
        said.append(f"{name}: {line.failed} of {len(line.points)} samples without a projection, {breaks} jumps "
                    f"(the largest {gap:.0f} times a usual step)")
    said.append("Ours has no gap: every segment lies in one face")
    return panels, ". ".join(one[0].upper() + one[1:] for one in said) + "."


@figure(8, "Against geodesic Bézier curves [24]", "Curves by De Casteljau's rule along geodesics do not pass through given points.")
def bezier():
    mesh = bunny()
    picks = bunny_picks(mesh)
    line = bezier_by_geodesics(prepared(mesh, "default"), picks)
    curves = both(mesh, picks)
    misses = np.linalg.norm(line[None] - picks[:, None], axis=-1).min(1)
    diagonal = prepared(mesh, "default").diagonal
    return ([panel("Bezier curve by geodesics", Scene(*mesh, [(line, GREEN)], list(picks))),
             panel("paper (blue), default (red)", scene_of(mesh, curves, picks))],
            f"The Bézier curve misses the inner picks by {100 * misses[1:-1].max() / diagonal:.1f} % of the diagonal; "
            + each(curves, lambda c: f"by {100 * max(np.linalg.norm(c.points - p, axis=1).min() for p in picks) / diagonal:.1g} %")
            + ".")


@figure(9, "λ from 1 to 0", "With λ = 1 curves are nearly straightest from pick to pick, with smaller λ they become smoother.")
def tension():
    mesh = bunny()
    panels, said = [], []
    for closed in (False, True):
        picks = bunny_picks(mesh, 6 if closed else 4)
        ways = [geodesic(prepared(mesh, "default"), a, b) for a, b in zip(picks, np.roll(picks, -1, axis=0) if closed else picks[1:])]
        shortest = sum(np.linalg.norm(np.diff(way, axis=0), axis=1).sum() for way in ways)
        lengths = {preset: [] for preset, _ in PRESETS}
        for share in (1.0, 0.5, 0.0):
            curves = both(mesh, picks, closed=closed, tension=share)
            panels.append(panel(f"{'closed' if closed else 'open'}, lambda = {share:g}", scene_of(mesh, curves, picks)))
            for preset, curve in curves.items():
                lengths[preset].append(curve.length / shortest)
        said.append(("closed: " if closed else "open: ") + "; ".join(
            f"`{preset}` " + ", ".join(f"{value:.3f}" for value in values) for preset, values in lengths.items()))
    return panels, "Length for λ = 1, 0.5, 0, relative to the geodesics from pick to pick. " + ". ".join(said) + "."


@figure(10, "Degrees 2, 3 and 4", "Higher degrees need fewer knots for the same picks and λ = 0.5 (113, 91, 59).")
def degrees():
    mesh = bunny(8000)
    picks = farthest_picks(*mesh, 10, 3)
    panels, knots = [], {preset: [] for preset, _ in PRESETS}
    for degree in (2, 3, 4):
        curves = both(mesh, picks, degree=degree, tension=0.5)
        panels.append(panel(f"degree {degree}", scene_of(mesh, curves, picks)))
        for preset, curve in curves.items():
            knots[preset].append(curve.report["knots_last"])
    return panels, "Knots: " + "; ".join(f"`{p}` {', '.join(map(str, k))}" for p, k in knots.items()) + "."


@figure(11, "Two resolutions", "The same picks give similar curves on a coarse and on a fine mesh.")
def resolutions():
    panels, said = [], []
    coarse, fine = bunny(), bunny(34834)
    for closed in (False, True):
        picks = bunny_picks(coarse, 6 if closed else 4)
        on_fine = nearest(fine, *picks)
        low, high = both(coarse, picks, closed=closed), both(fine, on_fine, closed=closed)
        panels += [panel(f"{len(coarse[0]):,} vertices", scene_of(coarse, low, picks)),
                   panel(f"{len(fine[0]):,} vertices", scene_of(fine, high, on_fine))]
        diagonal = prepared(coarse, "default").diagonal
        said.append(("closed: " if closed else "open: ") + "; ".join(
            f"`{preset}` {100 * apart(ring(low[preset]), ring(high[preset])) / diagonal:.2f} %" for preset in low))
    return panels, "The curves are apart by at most, of the diagonal, " + ". ".join(said) + "."


@figure(12, "Against an optimised polyline [9]", "Sampled with 5,132, about 590, 323 and 142 points, the spline is as smooth or "
        "smoother, and does not cost more with more points; the polyline does.")
def polyline():
    samples = (142, 323, 590, 5132)
    result = compare(ROOT / "build" / "release" / "bin" / "bspline_curve", 3485, 4, samples, 3)
    rows = result["rows"]
    lines = ["", "", "| points | spline, ms | polyline, ms | bending, spline / polyline |", "|--:|--:|--:|--:|"]
    for row in rows:
        spline, line = row["spline"], row["polyline"]
        lines.append(f"| {row['samples']:,} | {1e3 * spline['seconds']:.2f} | {1e3 * line['seconds']:.2f} | "
                     f"{spline['internal'] / line['internal']:.2f} |")
    mesh = bunny()
    picks = bunny_picks(mesh)
    scenes = []
    for count in (5132, 142):
        curves = {preset: draw(mesh, picks, preset, tension=0.5, samples=count) for preset, _ in PRESETS}
        scenes.append(panel(f"{count:,} samples", scene_of(mesh, curves, picks)))
    return scenes, "Both over the same fibres, λ = 0.5, by the default's spline." + "\n".join(lines)


@figure(13, "A curve that crosses itself, against a level set [17]", "Level sets cannot cross themselves; the spline can.")
def crossing():
    mesh = sphere(5)
    t = np.linspace(0, 2 * np.pi, 8, endpoint=False) + 0.2
    picks = normalised(np.stack([np.sin(t), np.sin(2 * t) * 0.6, 1.2 * np.ones_like(t)], 1))
    curves = both(mesh, picks, closed=True)
    contours = heat_level_set(prepared(mesh, "default"), picks)
    turns = each(curves, lambda c: f"{self_crossings(c)} crossing")
    scene = Scene(*mesh, [(line, GREEN) for line in contours], list(picks))
    longest = max(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in contours)
    met = sum(min(np.linalg.norm(line - p, axis=1).min() for line in contours) < 0.05 for p in picks)
    return ([panel("level set of a diffused function", scene), panel("paper (blue), default (red)", scene_of(mesh, curves, picks))],
            f"{turns}; the level set has {len(contours)} parts, none of which crosses another, the longest {longest:.2f} long, and "
            f"passes {met} of {len(picks)} picks.")


def self_crossings(curve):
    """How often the curve meets itself, by its imprint."""
    return len(curve.mesh.imprint([curve]).crossings)


@figure(14, "Concave regions by (24)", "With the normal variation as field, curves snap to concave regions.")
def concave():
    mesh = grooved_plate()
    x = np.array([-0.85, -0.2, 0.3, 0.85])
    picks = nearest(mesh, *np.stack([x, 0.35 * np.sin(2.5 * x), 0 * x], 1))[[0, 3]]
    values = prepared(mesh, "default").field("normal-variation")
    return with_field(mesh, picks, values, "normal-variation", np.square, (0.0, -0.5, 1.0))


@figure(15, "Sharp features by (25)", "With e to the minus maximal curvature as cost, curves run along sharp features.")
def sharp():
    mesh = fluted_vase()
    u = np.array([0.5, 1.2, 1.9, 2.6])
    v = 0.5 + 0.18 * np.sin(2 * u)
    picks = nearest(mesh, *np.stack([0.6 * np.cos(u), 1.3 * v, 0.6 * np.sin(u)], 1))[[0, 3]]
    values = prepared(mesh, "default").field("maximal-curvature")
    return with_field(mesh, picks, values, "maximal-curvature", lambda x: np.exp(-x), (0.0, 0.2, 1.0))


def with_field(mesh, picks, values, kind, cost, view):
    """Without and with a field: pictures, and the mean of its cost along the curves."""
    costs = cost(values)
    panels, means = [], {}
    for name, options in (("without the field", {}), ("with the field", {"field": kind})):
        curves = both(mesh, picks, **options)
        panels.append(panel(name, scene_of(mesh, curves, picks, colours=heat(values), view=view)))
        for preset, curve in curves.items():
            means.setdefault(preset, []).append(mean_along(curve, costs))
    said = "; ".join(f"`{preset}` {a:.3g} without, {b:.3g} with" for preset, (a, b) in means.items())
    strong = draw(mesh, picks, "paper", field=kind, field_weight=500.0)
    panels.append(panel("paper with mu = 500", scene_of(mesh, {"paper": strong}, picks, colours=heat(values), view=view)))
    return panels, (f"Mean cost along the curve (from {costs.min():.3g} to {costs.max():.3g} on the mesh): {said}; "
                    f"`paper` with μ = 500 {mean_along(strong, costs):.3g}.")


def mean_along(curve, values):
    at = (values[curve.mesh.faces[curve.faces]] * curve.barycentrics).sum(1)
    line = curve.points
    step = np.linalg.norm(np.diff(line, axis=0), axis=1)
    return float((step * (at[1:] + at[:-1]) / 2).sum() / step.sum())


@figure(16, "Obstacles by (26)", "With a field that is high on obstacles, the curve goes round them; without it, it crosses.")
def obstacles():
    mesh = bunny()
    vertices, faces = mesh
    picks = bunny_picks(mesh)[[0, 3]]
    way = geodesic(prepared(mesh, "default"), *picks)
    centres = [way[len(way) // 3], way[2 * len(way) // 3]]
    diagonal = prepared(mesh, "default").diagonal
    middle = vertices[faces].mean(1)
    region = np.flatnonzero(np.min([np.linalg.norm(middle - c, axis=1) for c in centres], 0) < 0.06 * diagonal)
    colours = np.tile(MESH_COLOUR, (len(vertices), 1))
    colours[np.unique(faces[region])] = (0.93, 0.76, 0.25)
    panels, said = [], []
    for name in ("without", "with"):
        curves = {}
        for preset, _ in PRESETS:
            options = {"field": prepared(mesh, preset).field("obstacle", region=region)} if name == "with" else {}
            if options and preset == "paper":
                options["field_weight"] = 1000.0
            curves[preset] = draw(mesh, picks, preset, **options)
        panels.append(panel(f"{name} the field", scene_of(mesh, curves, picks, colours=colours)))
        said.append(f"{name}: " + each(curves, lambda c: f"{100 * share_inside(c, region):.0f} %"))
    return panels, ("Share of the curve within the obstacles, " + ", ".join(said) + " (`paper` with μ = 1000: with μ = 1 the field "
                    "is too weak beside bending).")


def share_inside(curve, region):
    step = np.linalg.norm(np.diff(curve.points, axis=0), axis=1)
    inside = np.isin(curve.faces, region)
    return float((step * (inside[1:] & inside[:-1])).sum() / step.sum())


@figure(17, "A gallery of patterns", "Many curves on one model make patterns.")
def gallery():
    panels, count, seconds = [], 0, []
    torus = smooth_torus()
    u = np.linspace(0, 2 * np.pi, 10, endpoint=False)
    for preset, colour in PRESETS:
        lines = []
        for shift in np.linspace(0, 2 * np.pi, 5, endpoint=False):
            v = 3 * u + shift  # three turns across while it goes round once
            picks = nearest(torus, *np.stack([(1 + 0.35 * np.cos(v)) * np.cos(u), (1 + 0.35 * np.cos(v)) * np.sin(u),
                                              0.35 * np.sin(v)], 1))
            lines.append(timed(seconds, lambda p=picks, q=preset: draw(torus, p, q, closed=True)))
        panels.append(panel(f"torus, {preset}", Scene(*torus, [(ring(c), colour) for c in lines], view=(0.2, -0.6, 1))))
        ball_mesh, lines = sphere(), []
        for k in range(6):
            t = np.linspace(0, 2 * np.pi, 12, endpoint=False)
            tilt = normalised(np.array([np.cos(k * np.pi / 6), 0.25 * (-1) ** k, np.sin(k * np.pi / 6)]))
            a = normalised(np.cross(tilt, [0.1, 1, 0.2]))
            b = np.cross(tilt, a)
            picks = normalised(np.cos(t)[:, None] * a + np.sin(t)[:, None] * b + 0.22 * np.cos(4 * t)[:, None] * tilt)
            lines.append(timed(seconds, lambda p=nearest(ball_mesh, *picks), q=preset: draw(ball_mesh, p, q, closed=True)))
        panels.append(panel(f"sphere, {preset}", Scene(*ball_mesh, [(ring(c), colour) for c in lines], view=(0.3, 0.3, 1))))
        count += 11
    usable = sum(curve.usable for _, curve in seconds)
    return panels, f"{usable} of {count} curves are usable; the slowest took {1e3 * max(s for s, _ in seconds):.0f} ms."


def timed(seconds, make):
    begin = time.perf_counter()
    curve = make()
    seconds.append((time.perf_counter() - begin, curve))
    return curve


@figure(18, "Table 1", "Knots of the first and of the last curve, and seconds, by the size of the mesh.")
def table():
    from table1 import ROWS
    lines = ["", "", "| paper's model | vertices, picks | paper: knots, s | `paper`: knots, s | default: knots, s |", "|---|--:|--:|--:|--:|"]
    for row in ROWS[:5]:  # the simplified shell of the larger ones takes minutes
        mesh = bunny(row.vertices)
        picks = farthest_picks(*mesh, row.picks, 3)
        cells = []
        for preset, _ in PRESETS:
            prepared(mesh, preset).curve(picks[:3], preset=preset)  # builds the shell, as the paper's times do not count it
            begin = time.perf_counter()
            curve = draw(mesh, picks, preset)
            took = time.perf_counter() - begin
            cells.append(f"{curve.report['knots_first']} → {curve.report['knots_last']}, {took:.3f}")
        lines.append(f"| {row.name} | {row.vertices:,}, {row.picks} | {row.knots[0]} → {row.knots[1]}, {row.seconds:.3f} | "
                     + " | ".join(cells) + " |")
    return [], "Bunnies with as many vertices and picks; the shell is there already, as in the paper." + "\n".join(lines)


# ---------------------------------------------------------------- the page
def section(one, said):
    title = "### Table 1" if one.number == 18 else f"### Figure {one.number}: {one.title}"
    picture = "" if one.number == 18 else f"![{one.title}](images/paper_{one.number:02}.png)\n\n"
    return f"{title}\n\n*The paper:* {one.claim}\n\n{picture}*Here:* {said}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", type=int, nargs="*", help="numbers of figures; 18: Table 1")
    parser.add_argument("--size", type=int, default=SIZE[0], help="pixels of a panel")
    parser.add_argument("--images", type=Path, default=IMAGES)
    parser.add_argument("--page", action="store_true", help="write the text into docs/PAPER.md")
    given = parser.parse_args()
    if given.page and given.only:
        parser.error("--page needs all figures")
    SIZE[0] = given.size
    sections = []
    for one in FIGURES:
        if given.only and one.number not in given.only:
            continue
        begin = time.perf_counter()
        panels, said = one.make()
        if panels:
            montage(panels, given.images / f"paper_{one.number:02}.png")
        sections.append(section(one, said))
        print(f"{sections[-1]}\n[{time.perf_counter() - begin:.1f} s]\n", flush=True)
    if given.page:
        text = PAGE.read_text()
        made = BEGIN + "\n" + "\n".join(sections) + "\n" + END
        PAGE.write_text(re.sub(re.escape(BEGIN) + ".*" + re.escape(END), lambda _: made, text, flags=re.S))
    return 0


if __name__ == "__main__":
    sys.exit(main())
