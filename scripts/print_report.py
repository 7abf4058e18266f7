#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the report of bspline_curve as a page of text."""
import json
import sys
from pathlib import Path


def main():
    report = json.loads(Path(sys.argv[1]).read_text())
    mesh, curve, seconds = report["mesh"], report["curve"], report["seconds"]
    verdict = "usable" if report["usable"] else "NOT usable"
    rows = [
        ("mesh", f"{Path(mesh['file']).name}: {mesh['vertices']:,} vertices, {mesh['faces']:,} faces"),
        ("curve", f"{'closed' if curve['closed'] else 'open'}, degree {curve['degree']}, length {curve['length']:.4g}, "
                  f"{curve['vertices']:,} vertices, each segment in one face"),
        ("status", f"{report['status']}, {verdict}"),
        ("shell", f"none: fibres over {report['faces_passed']:,} faces" if report["shell"] == "fibres" else
                  f"{report['shell']}, {report['prisms']:,} prisms{', from the cache' if report['cached'] else ''}"),
        ("knots", f"{report['knots_first']} at first, {report['knots_last']} at last"),
        ("distance", f"spline to surface at most {report['max_distance']:.3g} mean edge lengths "
                     f"(allowed: {report['allowed_distance']:.3g}); the polyline lies on the surface"),
        ("picks", f"missed by at most {report['max_pick_gap']:.2g} of the diagonal"),
        ("work", f"{len(report['rounds'])} rounds, {report['newton_iterations']} Newton iterations"),
        ("first curve", f"{1e3 * seconds['cold']:.0f} ms, of which preparing the mesh "
                        f"{1e3 * (seconds['cold'] - seconds['design']):.0f} ms"),
    ]
    if seconds["warm"] is not None:
        rows.append(("next curve", f"{1e3 * seconds['warm']:.1f} ms, on the same mesh"))
    for name, text in rows:
        print(f"{name:12s} {text}")


if __name__ == "__main__":
    main()
