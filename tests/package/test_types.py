# SPDX-License-Identifier: GPL-3.0-or-later
"""The package and what it offers are typed; arguments are those of the description."""
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FILTERS = json.loads((ROOT / "filters" / "filters.json").read_text())["filters"]


def mypy(home, *words):
    command = [sys.executable, "-m", "mypy", "--cache-dir", home.folder / "mypy", "--python-executable", home.python, *words]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


def test_the_package_is_typed_strictly(home):
    done = mypy(home, "python/meshlab_bspline_curve")
    assert done.returncode == 0, done.stdout


def test_its_users_see_the_types(home, tmp_path):
    (tmp_path / "right.py").write_text(
        "import numpy as np\n"
        "import numpy.typing as npt\n"
        "from meshlab_bspline_curve import Curve, compute_field, draw_curve\n"
        "from typing_extensions import assert_type\n"
        "v, f = np.zeros((3, 3)), np.zeros((1, 3), dtype=np.int32)\n"
        "curve = draw_curve(v, f, [[0, 0, 0], [1, 0, 0]], degree=4, field=[1.0, 2.0, 3.0], shell='simplified', avoid=[1])\n"
        "assert_type(curve, Curve)\n"
        "assert_type(curve.points, npt.NDArray[np.float64])\n"
        "assert_type(curve.faces, npt.NDArray[np.int64])\n"
        "assert_type(compute_field(v, f, 'ridge'), npt.NDArray[np.float64])\n"
    )
    (tmp_path / "wrong.py").write_text(
        "from meshlab_bspline_curve import compute_field, draw_curve\n"
        "draw_curve([], [], [], degree='4')\n"
        "draw_curve([], [], [], shell='thin')\n"
        "draw_curve([], [], [], radius=1)\n"
        "compute_field([], [], 'hills')\n"
    )
    right, wrong = mypy(home, tmp_path / "right.py"), mypy(home, tmp_path / "wrong.py")
    assert right.returncode == 0, right.stdout
    assert [line for line in range(1, 6) if f"wrong.py:{line}: error" in wrong.stdout] == [2, 3, 4, 5]


@pytest.mark.parametrize("described", FILTERS, ids=lambda described: described["id"])
def test_a_method_of_meshset_has_the_described_arguments(described, home):
    name = described["pythonName"]
    answer = home.call(
        "import inspect, json, pymeshlab, meshlab_bspline_curve\n"
        f"method = pymeshlab.MeshSet.{name}\n"
        "arguments = inspect.signature(method).parameters\n"
        "answer['defaults'] = json.dumps({a.name: a.default for a in list(arguments.values())[1:]})\n"
        "answer['text'] = inspect.getdoc(method)"
    )
    parameters = [p for p in described["parameters"] if p["group"] != "window"]
    expected = {p["id"]: None if p["type"] == "mesh" else p["default"] for p in parameters}
    defaults = json.loads(str(answer["defaults"]))
    assert list(defaults) == list(expected) and defaults == expected
    told = " ".join(str(answer["text"]).split())
    assert [p["id"] for p in parameters if p["help"] not in told or f"{p['id']} : " not in told] == []


def test_a_method_takes_lengths_and_layers(home):
    answer = home.call(
        "import pymeshlab, meshlab_bspline_curve\n"
        "document = pymeshlab.MeshSet()\n"
        "document.create_sphere(radius=1, subdiv=4)\n"
        "draw = lambda **options: document.generate_bspline_curve_on_surface(picks='1 0 0; 0 1 0', surface_layer=0, **options)\n"
        "answer['all'] = draw(samples=0)['vertices']\n"
        "answer['short'] = draw(samples=0, max_segment_length=0.01)['vertices']\n"
        "answer['percent'] = draw(samples=0, max_segment_length=pymeshlab.PercentageValue(0.1))['vertices']\n"
        "length = document.mesh(0).bounding_box().diagonal() / 1000\n"
        "answer |= {'length': length, 'absolute': draw(samples=0, max_segment_length=length)['vertices']}\n"
        "draw(tube_radius=0.05)\n"
        "answer['layers'] = [mesh.label() for mesh in document]\n"
        "document.set_current_mesh(0)\n"
        "answer['maximum'] = document.compute_scalar_field_for_curves_per_vertex(kind='maximal-curvature')['maximum']"
    )
    assert answer["all"] < 1.57 / 0.01  # crossings of edges and picks only
    assert 1.57 / 0.01 < answer["short"] <= 1.6 / 0.01 + 2 * answer["all"]
    assert answer["percent"] == answer["absolute"] > 1.57 / answer["length"]
    assert [label for label in answer["layers"] if label.endswith("tube")] != []
    assert answer["maximum"] > 0


def test_arguments_of_functions_are_the_described_ones(home):
    answer = home.call(
        "import inspect, json, meshlab_bspline_curve as package\n"
        "for name in ('draw_curve', 'compute_field'):\n"
        "    function = getattr(package, name)\n"
        "    answer[name] = json.dumps({a.name: a.default for a in inspect.signature(function).parameters.values()\n"
        "                               if a.default is not a.empty})\n"
        "    assert inspect.getdoc(function).count(' : ') >= len(inspect.signature(function).parameters)"
    )
    of_layers = {"surface_layer", "picks_layer", "picks_file", "picks", "control_polygon", "shell_layers"}
    for described, function, of_arrays in zip(FILTERS[:2], ("draw_curve", "compute_field"), ({"quality"}, {"quality"}), strict=True):
        expected = {p["id"]: p["default"] for p in described["parameters"] if p["id"] not in of_layers and p["group"] != "window"}
        expected |= {name: None for name in ("save", "field_region", "region") if name in expected} | {n: None for n in of_arrays}
        assert json.loads(str(answer[function])) == expected
