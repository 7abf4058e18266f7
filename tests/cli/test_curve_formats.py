# SPDX-License-Identifier: GPL-3.0-or-later
"""Every format of curves as other programs read it: points, their order, closedness, and the spline."""

import csv
import json
from pathlib import Path

import ezdxf
import ezdxf.recover
import made_meshes as meshes
import meshio
import numpy as np
import pymeshlab
import pytest
import trimesh
from curve_files import read_ply
from scipy.interpolate import BSpline

CASES = [(degree, closed, "") for degree in (2, 3, 4) for closed in (False, True)]
CASES += [(2, False, "2,3"), (3, False, "3"), (3, True, "1,3"), (3, True, "4"), (4, True, "all")]
SIZE = 12  # cells of the hill
MEAN_EDGE = (2 + 2**0.5) / 3 / SIZE  # of the grid beneath; those of the hill are longer


def chain(count, closed):
    """The edges of a curve, in order."""
    return [[i, (i + 1) % count] for i in range(count - (not closed))]


class Case:
    """A curve on a hill and, by name, the files that hold it."""

    def __init__(self, folder, run, degree, closed, corners):
        self.folder, self.run, self.degree, self.closed, self.corners = folder, run, degree, closed, corners
        self.vertices, self.faces = meshes.plate(cells=SIZE, height=0.2)
        self.picks = self.vertices[[30, 90, 140, 100]]
        meshes.write_ply(folder / "hill.ply", self.vertices, self.faces, quality=self.vertices[:, 0])
        (folder / "picks.json").write_text(json.dumps({"picks": self.picks.tolist()}))
        document = json.loads(self.file("reference.json").read_text())
        self.polyline, self.spline = document["polyline"], document["spline"]
        self.points = np.array(self.polyline["points"])
        self.t = np.array(self.polyline["t"])
        self.edges = chain(len(self.points), closed)

    def file(self, name, *words):
        options = ("--degree", self.degree, "--samples", 40, *(["--closed"] if self.closed else []), *words)
        options += ("--corners", self.corners) if self.corners else ()
        if "--field" not in words:
            options += ("--field", "none")
        process = self.run("hill.ply", "--picks", "picks.json", "--output", name, *options)
        assert process.returncode == 0, process.stderr
        return self.folder / name

    def spline_at(self, t):
        """The program's spline, by scipy."""
        return BSpline(self.spline["knots"], np.array(self.spline["control_points"]), self.degree)(t)


@pytest.fixture(params=CASES, ids=lambda case: f"degree {case[0]} {'closed' if case[1] else 'open'} {case[2]}".strip())
def case(request, run, tmp_path):
    return Case(tmp_path, run, *request.param)


def test_corners_have_full_knots(case):
    values, counts = np.unique(case.spline["knots"], return_counts=True)
    numbers = range(1, 5) if case.corners == "all" else map(int, case.corners.split(",") if case.corners else [])
    expected = [case.spline["pick_parameters"][number - 1] for number in numbers]
    inside = (values < 1) & ((values >= 0) if case.closed else (values > 0))
    assert values[inside & (counts == case.degree)].tolist() == sorted(expected)
    assert set(counts[inside]) <= {1, case.degree}


def test_json_agrees_with_itself(case):
    assert case.spline["closed"] == case.closed
    picks = case.points[case.polyline["picks"]]
    assert np.abs(picks - case.picks).max() < 1e-12
    assert np.abs(case.spline_at(case.spline["pick_parameters"]) - case.picks).max() < 1e-9
    assert np.array_equal(case.t[case.polyline["picks"]], case.spline["pick_parameters"])
    assert np.linalg.norm(case.spline_at(case.t) - case.points, axis=1).max() < 0.1 * MEAN_EDGE


@pytest.mark.parametrize("words", [(), ("--field", "quality")], ids=["t", "field"])
def test_ply_in_meshlab(case, words):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(case.file("curve.ply", *words)))
    mesh = document.current_mesh()
    reference = json.loads(case.file("same.json", *words).read_text())["polyline"]
    assert np.array_equal(mesh.vertex_matrix(), reference["points"])
    assert mesh.edge_matrix().tolist() == chain(len(reference["points"]), case.closed)
    expected = np.array(reference["points"])[:, 0] if words else reference["t"]
    assert np.abs(mesh.vertex_scalar_array() - expected).max() < (1e-12 if words else 1e-300)


def test_ply_in_trimesh(case):
    path = trimesh.load(case.file("curve.ply"))
    assert np.array_equal(path.vertices, case.points)
    assert path.is_closed == case.closed
    assert np.array_equal(np.vstack([line.nodes for line in path.entities]), case.edges)
    vertex = path.metadata["_ply_raw"]["vertex"]["data"]
    assert np.array_equal(vertex["t"], case.t) and np.array_equal(vertex["face"], case.polyline["faces"])
    weights = np.stack([vertex[f"barycentric_{k}"] for k in range(3)], 1)
    assert np.array_equal(weights, case.polyline["barycentrics"])
    assert np.flatnonzero(vertex["is_pick"]).tolist() == sorted(case.polyline["picks"])


def test_obj_in_meshlab(case):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(case.file("curve.obj")))
    mesh = document.current_mesh()
    assert np.array_equal(mesh.vertex_matrix(), case.points)
    assert mesh.edge_matrix().tolist() == case.edges


def test_what_other_readers_take_is_what_the_page_says(case):
    """docs/FILES.md sends readers that would lose the lines, or z, to other formats."""
    path = case.file("curve.obj")
    assert np.array_equal(meshio.read(path).points, case.points) and meshio.read(path).cells == []
    assert np.array_equal(trimesh.load(path).vertices, case.points) and not hasattr(trimesh.load(path), "entities")
    with pytest.raises(SystemExit):
        meshio.read(case.file("curve.ply"))
    assert trimesh.load(case.file("curve.dxf")).vertices.shape[1] == 2, "trimesh reads no z"
    page = (Path(__file__).resolve().parents[2] / "docs" / "FILES.md").read_text()
    assert "| trimesh | `.obj`; without z: `.dxf`" in page and "| meshio | `.obj` | `.ply`" in page


def test_free_form_obj(case):
    path = case.file("curve.bspline.obj")
    words = [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    statements = [w[0] for w in words if w[0] != "v"]
    assert statements == ["cstype", "deg", "curv", "parm", "end"]
    points = np.array([w[1:] for w in words if w[0] == "v"], dtype=float)
    (curve,) = [w[1:] for w in words if w[0] == "curv"]
    (knots,) = [w[2:] for w in words if w[0] == "parm"]
    ids = np.array(curve[2:], dtype=int)
    assert ["deg", str(case.degree)] in words and ["cstype", "bspline"] in words
    assert (ids[-case.degree :] == ids[: case.degree]).all() == case.closed
    assert sorted(set(ids)) == list(range(1, len(points) + 1)), "every point is used"
    spline = BSpline(np.array(knots, dtype=float), points[ids - 1], case.degree)
    t = np.linspace(float(curve[0]), float(curve[1]), 500)
    assert np.array_equal(spline(t), case.spline_at(t))
    assert np.abs(spline(0) - spline(1)).max() < 1e-12 or not case.closed
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(path))
    assert np.array_equal(document.current_mesh().vertex_matrix(), points), "the control points"


def audited(path):
    """The model space of a DXF file that is in order for ezdxf."""
    for document, auditor in (ezdxf.recover.readfile(path), (ezdxf.readfile(path), None)):
        auditor = auditor or document.audit()
        assert [str(e) for e in [*auditor.errors, *auditor.fixes]] == []
    return document, document.modelspace()


def test_dxf_polyline_in_ezdxf(case):
    document, space = audited(case.file("curve.dxf"))
    (line,) = space
    assert document.dxfversion == "AC1009"
    assert line.dxftype() == "POLYLINE" and line.is_3d_polyline and line.dxf.layer in document.layers
    assert np.array_equal([tuple(p) for p in line.points()], case.points)
    assert line.is_closed == case.closed


def test_dxf_polyline_in_trimesh(case):
    path = trimesh.load(case.file("curve.dxf"))
    assert len(path.entities) == 1 and path.is_closed == case.closed


def test_dxf_spline_in_ezdxf(case):
    document, space = audited(case.file("curve.bspline.dxf"))
    (entity,) = space
    assert document.dxfversion == "AC1015"
    assert entity.dxftype() == "SPLINE" and entity.closed == case.closed and entity.dxf.degree == case.degree
    assert entity.dxf.layer in document.layers
    t = np.linspace(0, 1, 500)
    by_ezdxf = np.array([tuple(p) for p in entity.construction_tool().points(t)])
    by_scipy = BSpline(np.array(entity.knots), np.array(entity.control_points), case.degree)(t)
    assert np.abs(by_ezdxf - case.spline_at(t)).max() < 1e-8, "ezdxf evaluates to nine digits"
    assert np.abs(by_scipy - case.spline_at(t)).max() < 1e-12
    assert np.abs(by_ezdxf[0] - by_ezdxf[-1]).max() < 1e-12 or not case.closed


def test_vtu_in_meshio(case):
    mesh = meshio.read(case.file("curve.vtu"))
    assert np.array_equal(mesh.points, case.points)
    assert [block.type for block in mesh.cells] == ["line"] and mesh.cells[0].data.tolist() == case.edges
    for name, expected in {"quality": case.t, "t": case.t, "face": case.polyline["faces"],
                           "barycentric": case.polyline["barycentrics"]}.items():
        assert np.array_equal(mesh.point_data[name], expected), name
    assert np.flatnonzero(mesh.point_data["is_pick"]).tolist() == sorted(case.polyline["picks"])


def test_csv(case):
    with open(case.file("curve.csv"), newline="") as stream:
        rows = list(csv.DictReader(stream))
    table = {name: np.array([row[name] for row in rows], dtype=float) for name in rows[0]}
    assert list(table) == ["x", "y", "z", "t", "face", "b0", "b1", "b2", "quality", "is_pick"]
    assert np.array_equal(np.stack([table[n] for n in "xyz"], 1), case.points)
    assert np.array_equal(np.stack([table[n] for n in ("b0", "b1", "b2")], 1), case.polyline["barycentrics"])
    assert np.array_equal(table["face"], case.polyline["faces"])
    assert np.array_equal(table["t"], case.t) and np.array_equal(table["quality"], case.t)
    assert np.flatnonzero(table["is_pick"]).tolist() == sorted(case.polyline["picks"])


def test_on_a_plane_the_spline_is_the_polyline(run, plate):
    for name in ("curve.csv", "curve.bspline.dxf", "curve.json"):
        run.ok("plate.ply", "--picks", "picks.json", "--output", name, "--closed")
    polyline = json.loads((plate / "curve.json").read_text())["polyline"]
    (entity,) = ezdxf.readfile(plate / "curve.bspline.dxf").modelspace()
    on_spline = np.array([tuple(p) for p in entity.construction_tool().points(polyline["t"])])
    assert np.abs(on_spline - polyline["points"]).max() < 1e-9


def test_numbers_far_from_one_are_exact(run, tmp_path):
    scale = 1e-7
    V, F = meshes.plate(cells=4, size=scale)
    meshes.write_ply(tmp_path / "small.ply", V + [1e3 * scale, 0, 0], F)
    picks = V[[0, 12, 19]] + [1e3 * scale, 0, 0]
    (tmp_path / "picks.json").write_text(json.dumps({"picks": picks.tolist()}))
    for name in ("curve.ply", "curve.dxf", "curve.csv"):
        run.ok("small.ply", "--picks", "picks.json", "--output", name)
    vertex = read_ply(tmp_path / "curve.ply")["vertex"]
    points = np.stack([vertex[name] for name in "xyz"], 1)
    _, (line,) = audited(tmp_path / "curve.dxf")
    assert np.array_equal([tuple(p) for p in line.points()], points)
    with open(tmp_path / "curve.csv", newline="") as stream:
        rows = [[float(row[n]) for n in "xyz"] for row in csv.DictReader(stream)]
    assert np.array_equal(rows, points)
