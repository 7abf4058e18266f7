# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared cases beside the checkout, through the program and through pymeshlab, judged from outside."""
import importlib.util
import json
import subprocess
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from curves import draw

SHARED = Path(__file__).resolve().parents[3] / "shared"
CASES = sorted((SHARED / "cases").glob("*.json"))
JUDGE = SHARED / "checks" / "check_curve.py"

pytestmark = pytest.mark.skipif(not (CASES and JUDGE.exists()), reason="there are no ../shared/cases and ../shared/checks")


@pytest.fixture(scope="module")
def judge():
    spec = importlib.util.spec_from_file_location("check_curve", JUDGE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def surfaces(judge):
    """Meshes, each read once."""
    kept = {}

    def read(path):
        if path not in kept:
            kept[path] = judge.read_mesh(path)
        return kept[path]

    return read


def assert_passes_the_judge(judge, surface, case, points, closed, tolerance):
    _, failures = judge.judge(*surface, points, closed, np.array(case["picks"]), case["closed"], tolerance)
    assert not failures


@pytest.mark.parametrize("shell", ["full", "simplified"])
@pytest.mark.parametrize("path", CASES, ids=lambda p: p.stem)
def test_the_program_draws_every_shared_case(judge, surfaces, program, path, shell, tmp_path):
    case = json.loads(path.read_text())
    mesh = SHARED / case["mesh"]
    output = tmp_path / "curve.ply"
    subprocess.run([program, mesh, "--picks", path, "--output", output, "--shell", shell], check=True, timeout=120)
    points, closed, chain_error = judge.read_curve(output)
    assert chain_error is None
    assert_passes_the_judge(judge, surfaces(mesh), case, points, closed, 1e-9)


@pytest.mark.parametrize("path", CASES, ids=lambda p: p.stem)
def test_pymeshlab_draws_every_shared_case(judge, surfaces, path):
    case = json.loads(path.read_text())
    mesh = SHARED / case["mesh"]
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(mesh))
    layer, figures = draw(document, case["picks"], closed=case["closed"])
    assert figures["usable"]
    points, closed, chain_error = judge.order_chain(layer.vertex_matrix(), layer.edge_matrix())
    assert chain_error is None
    assert_passes_the_judge(judge, surfaces(mesh), case, points, closed, 1e-9)
