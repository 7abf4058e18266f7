#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times imprinting a curve, and what MeshLib takes for the same.

    benchmarks/peers_cut.py                       curves on the meshes of benchmarks/cases.py
    benchmarks/peers_cut.py --cases FOLDER        those of files NAME.json: {"mesh": file, "picks": [...], "closed": bool}
    benchmarks/peers_cut.py --page                writes the table into docs/USING_CURVES.md as well
    benchmarks/peers_cut.py --large               100 curves of 1,000 segments on a mesh of a million faces as well

The program draws each curve; then both get its points, and the mesh, in memory. Ours is `imprint` alone, which works in doubles
and leaves the input as it is: that is, with a copy of the mesh. MeshLib's is convertMeshTriPointsToMeshContour and cutMesh, on a
mesh that is copied before the clock starts, in floats. Each in turn on one machine, the least of several rounds. `bad` counts
faces that MeshLib marks as crossed twice; where it deletes faces, `faces` are fewer than before. Needs requirements.txt.
"""
import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from cases import (PROGRAM, ROOT, cases_of, geometric_mean, machine, picked_cases, replace_table, torus_of, write_case, write_json,
                   write_ply)

LAYOUTS = ((4, False), (7, False), (6, True))  # picks, closed
LARGE_VERTICES, LARGE_CURVES, LARGE_SEGMENTS = 500_000, 100, 1000


def drawn(program, folder, case):
    """The curve file and the mesh file of a case."""
    mesh, picks = write_case(folder, case)
    curve = folder / "curve.json"
    words = [program, mesh, "--picks", picks, "--output", curve, "--field", "none", "--no-cache"]
    subprocess.run(list(map(str, words)), check=True, capture_output=True)
    return mesh, curve


def ours(program, folder, mesh, curves):
    """Seconds of imprint(), and faces."""
    words = [program, "imprint", mesh, "--output", folder / "out.ply", "--report", folder / "report.json"]
    for curve in curves:
        words += ["--curve", curve]
    subprocess.run(list(map(str, words)), check=True, capture_output=True)
    report = json.loads((folder / "report.json").read_text())
    return report["seconds"]["imprint"], report["faces"]


def meshlib(case, line):
    """Seconds of converting and cutting, faces marked as bad, and faces left; none where it gives up."""
    import meshlib.mrmeshnumpy as arrays
    import meshlib.mrmeshpy as mr

    mesh = arrays.meshFromFacesVerts(case.faces.astype(np.int32), case.vertices.astype(np.float32))
    points = line["polyline"]["points"]
    places = mr.std_vector_MeshTriPoint()
    for point in points + points[:1] if line["closed"] else points:
        places.append(mr.findProjection(mr.Vector3f(*point), mesh).mtp)
    start = time.perf_counter()
    try:
        contour = mr.convertMeshTriPointsToMeshContour(mesh, places)
        contours = mr.std_vector_OneMeshContour()
        contours.append(contour)
        cut = mr.cutMesh(mesh, contours)
    except (RuntimeError, ValueError) as failure:
        return None, str(failure).splitlines()[0], 0
    seconds = time.perf_counter() - start
    return seconds, cut.fbsWithContourIntersections.count(), mesh.topology.numValidFaces()


def compare(program, case, rounds):
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        mesh, curve = drawn(program, folder, case)
        line = json.loads(curve.read_text())
        mine, theirs = [], []
        for _ in range(rounds):
            mine.append(ours(program, folder, mesh, [curve]))
            theirs.append(meshlib(case, line))
        row = {"case": case.name, "faces": len(case.faces), "segments": len(line["polyline"]["points"]),
               "ours": min(s for s, _ in mine), "our_faces": mine[0][1], "bad": theirs[0][1], "meshlib_faces": theirs[0][2]}
        times = [seconds for seconds, _, _ in theirs if seconds is not None]
        return row | {"meshlib": min(times) if times else None}


# ---------------------------------------------------------------- many curves on a large mesh
def rings(vertices, faces):
    """Closed curves across a bumpy torus, in planes of its axis, of LARGE_SEGMENTS segments: where the plane cuts its edges, and
    middles between these."""
    from random_curves import Mesh, section_by

    mesh = Mesh(vertices, faces)
    for ring in range(LARGE_CURVES):
        angle = 2 * np.pi * (ring + 0.37) / LARGE_CURVES
        normal = np.array([-np.sin(angle), np.cos(angle), 0.0])
        heights = vertices @ normal
        beside = vertices @ np.array([np.cos(angle), np.sin(angle), 0.0]) > 0
        sign = heights[faces] > 0
        crossed = np.flatnonzero((sign.any(1) != sign.all(1)) & beside[faces].all(1))
        points, closed = section_by(mesh, heights, int(crossed[0]))
        assert closed
        finer, missing = [], LARGE_SEGMENTS - len(points)
        for index, (point, after) in enumerate(zip(points, points[1:] + points[:1])):
            face = int(np.intersect1d(mesh.holders(point), mesh.holders(after))[0])
            low, high = mesh.seen_from(point, face)[1], mesh.seen_from(after, face)[1]
            share = 2 if index < missing else 1
            finer += [(face, low + (high - low) * k / share) for k in range(share)]
        yield finer


def copy_seconds(vertices, faces, rounds=5):
    """Of the arrays of a mesh."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        vertices.copy(), faces.astype(np.int32)
        times.append(time.perf_counter() - start)
    return min(times)


def large(program, rounds):
    from random_curves import Mesh, as_json

    vertices, faces = torus_of(LARGE_VERTICES)
    mesh = Mesh(vertices, faces)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        write_ply(folder / "mesh.ply", vertices, faces)
        files, segments = [], 0
        for index, points in enumerate(rings(vertices, faces)):
            files.append(folder / f"{index}.json")
            segments += len(points)
            files[-1].write_text(json.dumps(as_json(mesh, points, True)))
        seconds = min(ours(program, folder, folder / "mesh.ply", files)[0] for _ in range(rounds))
    return {"faces": len(faces), "curves": len(files), "segments": segments, "imprint": seconds,
            "copy": copy_seconds(vertices, faces.astype(np.int32))}


def text_of(row):
    theirs = f"{1e3 * row['meshlib']:8.2f} {row['ours'] / row['meshlib']:6.2f}" if row["meshlib"] else f"{'-':>8} {'-':>6}"
    return (f"{row['case']:28} {row['faces']:8,} {row['segments']:8,} {1e3 * row['ours']:8.2f} {theirs} {row['bad']!s:>6} "
            f"{row['our_faces']:8,} {row['meshlib_faces']:8,}")


def page_table(results):
    """Rows of the page: milliseconds, and what becomes of the faces."""
    lines = ["| curve | faces | segments | ours, ms | MeshLib, ms | ratio | faces after ours | after MeshLib's |",
             "|---|--:|--:|--:|--:|--:|--:|--:|"]
    for row in results["rows"]:
        theirs = f"{1e3 * row['meshlib']:.2f} | {row['ours'] / row['meshlib']:.2f}" if row["meshlib"] else "– | –"
        left = f"{row['meshlib_faces']:,}" if row["meshlib"] else row["bad"]
        if row["meshlib"] and row["meshlib_faces"] < row["faces"]:
            left = f"**{left}**"
        lines.append(f"| {row['case']} | {row['faces']:,} | {row['segments']:,} | {1e3 * row['ours']:.2f} | {theirs} "
                     f"| {row['our_faces']:,} | {left} |")
    told = f"Ours / MeshLib, geometric mean: {results['ratio']:.2f}. Bold: faces that MeshLib deleted."
    if "large" in results:
        large = results["large"]
        told += (f" {large['curves']} curves with {large['segments']:,} segments together on {large['faces']:,} faces take "
                 f"{large['imprint']:.2f} s; copying the mesh is {large['copy']:.2f} s of it.")
    on = results["machine"]
    return "\n".join(lines) + f"\n\n{told} On {on['cores']} cores, {on['processor']}."


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=Path, help="folder of cases, in place of those made by a rule")
    parser.add_argument("--large", action="store_true", help="many curves on a mesh of a million faces as well")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--quick", action="store_true", help="two small meshes, one round")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--page", action="store_true", help="write the table into docs/USING_CURVES.md as well")
    given = parser.parse_args()
    rounds = 1 if given.quick else given.rounds
    print(f"{'milliseconds':28} {'faces':>8} {'segments':>8} {'ours':>8} {'MeshLib':>8} {'ratio':>6} {'bad':>6} {'faces':>8} {'faces':>8}")
    rows = []
    for case in cases_of(given.cases) if given.cases else picked_cases(LAYOUTS, given.quick):
        rows.append(compare(given.program, case, rounds))
        print(text_of(rows[-1]), flush=True)
    ratios = [row["ours"] / row["meshlib"] for row in rows if row["meshlib"]]
    print(f"ours / MeshLib: geometric mean {geometric_mean(ratios):.2f}, worst {max(ratios):.2f}, of {len(ratios)}")
    results = {"machine": machine(), "rows": rows, "ratio": geometric_mean(ratios)}
    if given.large:
        results["large"] = told = large(given.program, rounds)
        print(f"{told['curves']} curves with {told['segments']:,} segments together on {told['faces']:,} faces: {told['imprint']:.3f} s; "
              f"copying the mesh takes {told['copy']:.3f} s")
    write_json(given.json, results)
    if given.page:
        replace_table(ROOT / "docs" / "USING_CURVES.md", "peers-cut", page_table(results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
