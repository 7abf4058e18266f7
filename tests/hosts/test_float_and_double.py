# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab 2020.09, which keeps floats, draws the curves of pymeshlab, which keeps doubles, on the shared cases."""
import json
from pathlib import Path

import numpy as np
import polylines
import pymeshlab
import pytest
from float_ply import write_ply
from meshlabserver import run_server

SHARED = Path(__file__).resolve().parents[3] / "shared"
CASES = sorted((SHARED / "cases").glob("*.json"))

# Relative to the diagonal. A mesh that is rounded when it is loaded is another mesh, where a decision may fall otherwise;
# docs/MESHLAB.md tells how much that was.
LARGEST = {"rounded first": 1e-5, "as it is": 5e-3}
CURVE = "generate_bspline_curve_on_surface"

pytestmark = pytest.mark.skipif(not CASES, reason="there are no ../shared/cases")


@pytest.fixture(scope="module")
def documents():
    """Those that were used; pymeshlab is easier on documents that stay."""
    return []


def loaded(path, documents):
    document = pymeshlab.MeshSet()
    documents.append(document)
    document.load_new_mesh(str(path))
    return document


@pytest.mark.parametrize("kind", LARGEST)
@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_both_draw_the_same_curve(path, kind, documents, display, prefix, loaded_plugin, write_script, tmp_path):
    case = json.loads(path.read_text())
    mesh = SHARED / case["mesh"]
    options = {"picks": "; ".join(" ".join(map(repr, pick)) for pick in case["picks"]), "closed": case["closed"]}
    if kind == "rounded first":
        surface = loaded(mesh, documents).current_mesh()
        mesh = write_ply(tmp_path / "mesh.ply", surface.vertex_matrix(), surface.face_matrix())
    output = tmp_path / "curve.ply"  # MeshLab writes its floats bit by bit, but no edges
    run = run_server(display, prefix, "-i", mesh, "-s", write_script((CURVE, options)), "-o", output)
    assert run.status == 0, run.output
    single = loaded(output, documents).current_mesh().vertex_matrix()

    document = loaded(mesh, documents)
    diagonal = document.current_mesh().bounding_box().diagonal()
    assert document.apply_filter(CURVE, **options)["usable"]
    double = document.current_mesh().vertex_matrix()
    document.clear()
    edges = [np.array(polylines.in_order(vertices, case["closed"])) for vertices in (single, double)]
    assert polylines.distance((single, edges[0]), (double, edges[1])) <= LARGEST[kind] * diagonal
