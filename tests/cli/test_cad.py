# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves for CAD: STEP and IGES, read back by small readers of their own and by OpenCASCADE."""

import json
import re

import made_meshes as meshes
import numpy as np
import pytest

RING = [[0.3, 0.3, 0.0], [0.7, 0.3, 0.0], [0.7, 0.7, 0.0], [0.3, 0.7, 0.0]]
MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "um": 0.001, "in": 25.4, "ft": 304.8}


@pytest.fixture(params=["open", "closed", "open, a corner", "closed, corners", "closed, a corner elsewhere"])
def curve(run, tmp_path, request):
    """A curve on a hill, as JSON has it."""
    meshes.write_ply(tmp_path / "hill.ply", *meshes.plate(height=0.2))
    closed, _, corners = request.param.partition(", ")
    picks = RING if closed == "closed" else meshes.PICKS
    corners = {"": [], "a corner": [1], "corners": [0, 2], "a corner elsewhere": [1]}[corners]
    lifted = [[x, y, 0.2 * np.sin(np.pi * x) * np.sin(np.pi * y)] for x, y, _ in picks]
    (tmp_path / "picks.json").write_text(json.dumps({"picks": lifted, "closed": closed == "closed", "corners": corners}))

    def write(*names, **options):
        for name in ("curve.json", *names):
            words = [word for key, value in options.items() for word in (f"--{key}", value)]
            run.ok("hill.ply", "--picks", "picks.json", "--output", name, *words)
        return json.loads((tmp_path / "curve.json").read_text())

    return write


def evaluate(degree, knots, points, t):
    """De Boor's algorithm."""
    k = min(max(np.searchsorted(knots, t, side="right") - 1, degree), len(points) - 1)
    level = [np.array(points[j + k - degree]) for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[j + k - degree], knots[j + 1 + k - r]
            share = (t - low) / (high - low)
            level[j] = (1 - share) * level[j - 1] + share * level[j]
    return level[degree]


def check_same_spline(document, degree, knots, points):
    """That of a file, with clamped knots, and that of JSON, whose knots are periodic where it is closed."""
    spline = document["spline"]
    own = np.array(spline["control_points"])
    assert degree == spline["degree"] and len(knots) == len(points) + degree + 1
    assert (knots[: degree + 1] == 0).all() and (knots[-degree - 1:] == 1).all()
    if not document["closed"]:
        assert np.abs(knots - spline["knots"]).max() == 0
        assert np.abs(points - own).max() < 1e-12
    for t in np.linspace(0, 1, 101):
        at = evaluate(degree, np.array(spline["knots"]), own, t)
        assert np.abs(evaluate(degree, knots, points, t) - at).max() < 1e-12


def instances(path):
    """Of a STEP file: number -> text."""
    text = path.read_text(encoding="ascii")
    assert text.startswith("ISO-10303-21;\nHEADER;\n") and text.endswith("ENDSEC;\nEND-ISO-10303-21;\n")
    found = dict(re.findall(r"^#(\d+)=(.*);$", text, re.M))
    assert list(map(int, found)) == list(range(1, len(found) + 1))
    used = {number for body in found.values() for number in re.findall(r"#(\d+)", body)}
    assert used <= set(found)
    return found


def only(found, name):
    (body,) = [body for body in found.values() if body.startswith(name + "(")]
    return body


def point(body):
    return [float(x) for x in re.fullmatch(r"CARTESIAN_POINT\('',\((.*)\)\)", body).group(1).split(",")]


def numbers_in(list_text):
    return [float(x) for x in list_text.split(",")]


@pytest.mark.parametrize("end", ["step", "stp"])
def test_step_holds_the_spline(curve, tmp_path, end):
    document = curve(f"curve.{end}")
    found = instances(tmp_path / f"curve.{end}")
    match = re.fullmatch(r"B_SPLINE_CURVE_WITH_KNOTS\('',(\d+),\((.*?)\),\.UNSPECIFIED\.,\.([TF])\.,\.F\.,"
                         r"\((.*?)\),\((.*?)\),\.UNSPECIFIED\.\)", only(found, "B_SPLINE_CURVE_WITH_KNOTS"))
    degree, ids, closed, multiplicities, knots = match.groups()
    assert (closed == "T") == document["closed"]
    points = np.array([point(found[number]) for number in re.findall(r"\d+", ids)])
    repeated = np.repeat(numbers_in(knots), [int(m) for m in multiplicities.split(",")])
    check_same_spline(document, int(degree), repeated, points)


def test_step_holds_the_polyline(curve, tmp_path):
    document = curve("curve.polyline.step")
    found = instances(tmp_path / "curve.polyline.step")
    points = np.array([point(found[number]) for number in re.findall(r"#(\d+)", only(found, "POLYLINE"))])
    expected = document["polyline"]["points"]
    assert np.array_equal(points, expected + expected[: 1 if document["closed"] else 0])


def entities(path):
    """Of an IGES file: type, form and parameters of each; and the fields of its global section."""
    lines = path.read_text(encoding="ascii").splitlines()
    assert {len(line) for line in lines} == {80}
    sections = {letter: [line for line in lines if line[72] == letter] for letter in "SGDPT"}
    for part in sections.values():
        assert [int(line[73:]) for line in part] == list(range(1, len(part) + 1))
    assert sections["T"][0][:32] == "".join(f"{letter}{len(sections[letter]):7d}" for letter in "SGDP")
    result = []
    for first, second in zip(sections["D"][::2], sections["D"][1::2]):
        start, count = int(first[8:16]), int(second[24:32])
        own = sections["P"][start - 1: start - 1 + count]
        assert {int(line[64:72]) for line in own} == {int(first[73:])}
        fields = "".join(line[:64].rstrip() for line in own).rstrip(";").split(",")
        assert fields[0] == first[:8].strip() == second[:8].strip()
        result.append((int(fields[0]), int(second[32:40]), [float(x.replace("D", "E")) for x in fields[1:]]))
    return result, "".join(line[:72].rstrip() for line in sections["G"])


@pytest.mark.parametrize("end", ["iges", "igs"])
def test_iges_holds_the_spline(curve, tmp_path, end):
    document = curve(f"curve.{end}")
    [(kind, form, numbers)], _ = entities(tmp_path / f"curve.{end}")
    assert (kind, form) == (126, 0)
    last, degree, _, closed, polynomial, periodic = map(int, numbers[:6])
    assert (closed, polynomial, periodic) == (int(document["closed"]), 1, 0)
    rest = np.array(numbers[6:])
    knots, weights = rest[: last + degree + 2], rest[last + degree + 2:][: last + 1]
    points = rest[len(knots) + len(weights):][: 3 * (last + 1)].reshape(-1, 3)
    assert (weights == 1).all() and list(rest[-5:]) == [0, 1, 0, 0, 0]
    assert len(rest) == len(knots) + len(weights) + points.size + 5
    check_same_spline(document, degree, knots, points)


def test_iges_holds_the_polyline(curve, tmp_path):
    document = curve("curve.polyline.igs")
    [(kind, form, numbers)], _ = entities(tmp_path / "curve.polyline.igs")
    assert (kind, form, numbers[0]) == (106, 12, 2)
    expected = document["polyline"]["points"]
    points = np.array(numbers[2:]).reshape(-1, 3)
    assert len(points) == numbers[1]
    assert np.array_equal(points, expected + expected[: 1 if document["closed"] else 0])


@pytest.mark.parametrize("unit", MILLIMETRES)
def test_units_are_named(curve, tmp_path, unit):
    curve("curve.step", "curve.igs", unit=unit)
    flags = {"mm": "2,2HMM", "cm": "10,2HCM", "m": "6,1HM", "um": "9,2HUM", "in": "1,2HIN", "ft": "4,2HFT"}
    assert f",1.D0,{flags[unit]}," in entities(tmp_path / "curve.igs")[1]
    words = " ".join(instances(tmp_path / "curve.step").values())
    prefix = {"mm": ".MILLI.", "cm": ".CENTI.", "m": "$", "um": ".MICRO."}.get(unit, ".MILLI.")
    assert f"SI_UNIT({prefix},.METRE.)" in words
    assert ("CONVERSION_BASED_UNIT" in words) == (unit in ("in", "ft"))
    assert unit not in ("in", "ft") or f"LENGTH_MEASURE({MILLIMETRES[unit]})" in words


def test_patterns_are_several_curves_in_one_file(run, plate):
    (plate / "a.svg").write_text("<svg><rect width='3' height='2'/></svg>")
    for end in ("step", "igs"):
        run.ok("pattern", "plate.ply", "--drawing", "a.svg", "--centre", "0.5,0.5,0", "--size", 0.4, "--output", f"a.{end}")
    assert sum(b.startswith("B_SPLINE_CURVE_WITH_KNOTS") for b in instances(plate / "a.step").values()) == 4
    assert [kind for kind, _, _ in entities(plate / "a.igs")[0]] == [126] * 4


@pytest.mark.parametrize("unit", ["mm", "in"])
@pytest.mark.parametrize("end", ["step", "igs", "polyline.step", "polyline.igs"])
def test_opencascade_reads_the_same_curves(curve, tmp_path, end, unit):
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.GCPnts import GCPnts_AbscissaPoint
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.IGESControl import IGESControl_Reader
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_EDGE
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    document = curve(f"curve.{end}", unit=unit)
    reader = STEPControl_Reader() if end.endswith("step") else IGESControl_Reader()
    Interface_Static.SetIVal_s("read.iges.bspline.continuity", 0)  # else it cuts splines at their corners
    assert reader.ReadFile(str(tmp_path / f"curve.{end}")) == IFSelect_RetDone
    reader.TransferRoots()
    explorer = TopExp_Explorer(reader.OneShape(), TopAbs_EDGE)
    edges = []
    while explorer.More():
        cast = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge
        edges.append(BRepAdaptor_Curve(cast(explorer.Current())))
        explorer.Next()
    scale = MILLIMETRES[unit]
    if end.startswith("polyline"):
        length = sum(GCPnts_AbscissaPoint.Length_s(edge) for edge in edges)
        points = np.array(document["polyline"]["points"])
        points = np.vstack([points, points[:1]]) if document["closed"] else points
        assert length / scale == pytest.approx(np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), rel=1e-9)
        return
    (edge,) = edges
    spline = document["spline"]
    read = edge.BSpline()
    assert read.Degree() == spline["degree"]
    if not document["closed"]:
        poles = [read.Pole(i + 1) for i in range(read.NbPoles())]
        assert np.abs(np.array([[p.X(), p.Y(), p.Z()] for p in poles]) / scale - spline["control_points"]).max() < 1e-12
        knots = [read.Knot(i + 1) for i in range(read.NbKnots()) for _ in range(read.Multiplicity(i + 1))]
        assert np.abs(np.array(knots) - spline["knots"]).max() < 1e-12
    for t in np.linspace(0, 1, 101):
        at = edge.Value(float(t))
        expected = evaluate(spline["degree"], np.array(spline["knots"]), np.array(spline["control_points"]), t)
        assert np.abs(np.array([at.X(), at.Y(), at.Z()]) / scale - expected).max() < 1e-12
