# SPDX-License-Identifier: GPL-3.0-or-later
"""Every host has the defaults of filters/filters.json: the program, the plugin and the Python packages. The drawing tool's are
compared in tests/filters/drawn_options_test.cpp, the libraries' in option_bindings_test.cpp."""
import ast
import inspect
import json
import re
import subprocess
import sys
from pathlib import Path

import pymeshlab
import pytest

ROOT = Path(__file__).resolve().parents[2]
FILTERS = {f["id"]: f for f in json.loads((ROOT / "filters" / "filters.json").read_text())["filters"]}
CURVE = {p["id"]: p for p in FILTERS["generate_bspline_curve_on_surface"]["parameters"]}


def test_a_curve_follows_no_field_by_default():
    assert CURVE["field"]["default"] == "none"


def test_the_program_has_the_defaults_of_the_filter(program):
    text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    told = dict(re.findall(r"^  --([\w-]+)[\w,-]* [^\s=]+=(\S+)", text, re.M))
    expected = {name.replace("_", "-"): p["default"] for name, p in CURVE.items()}
    shared = told.keys() & expected.keys()
    assert {"degree", "tension", "field", "field-weight", "field-cost", "avoid", "avoid-margin", "samples", "shell", "preset",
            "weld"} <= shared
    for name in shared:
        default = expected[name]
        assert told[name] == (default if isinstance(default, str) else f"{default:g}"), name


@pytest.mark.parametrize("name", FILTERS)
def test_the_plugin_has_the_defaults_of_the_filters(name):
    document = pymeshlab.MeshSet(verbose=False)
    document.create_sphere(subdiv=1)
    values = document.filter_parameter_values(name)
    for parameter in FILTERS[name]["parameters"]:
        if parameter["type"] != "mesh" and parameter["id"] in values:
            default = parameter["default"]
            given = values[parameter["id"]]  # floats of it are of single precision
            if parameter["type"] == "enum":
                given = parameter["enumOptions"][given]["id"]
            assert given == (pytest.approx(default) if isinstance(default, float) else default), parameter["id"]
    assert len(values) >= len(FILTERS[name]["parameters"]) - 1  # replace is of windows


def test_the_python_package_has_the_defaults_of_the_filter(build_folder):
    sys.path.insert(0, str(build_folder / "python"))
    import bspline_curve

    seen = set()
    for call in (bspline_curve.Mesh.__init__, bspline_curve.Mesh.curve):
        for name, argument in inspect.signature(call).parameters.items():
            if name in CURVE and argument.default is not inspect.Parameter.empty:
                default = "none" if argument.default is None else argument.default
                assert default == CURVE[name]["default"], name
                seen.add(name)
    assert len(seen) > 35 and {"field", "avoid", "degree", "samples", "shell", "weld"} <= seen


@pytest.mark.parametrize("name", ["filters", "methods"])
def test_the_package_for_pymeshlab_has_the_defaults_of_the_filters(name):
    # Read, not imported: it loads a plugin, and pymeshlab takes none twice.
    module = ast.parse((ROOT / "python" / "meshlab_bspline_curve" / f"{name}.py").read_text())
    names = {"draw_curve": "generate_bspline_curve_on_surface", "compute_field": "compute_scalar_field_for_curves_per_vertex"}
    compared = 0
    for function in (node for node in module.body if isinstance(node, ast.FunctionDef)):
        described = {p["id"]: p for p in FILTERS.get(names.get(function.name, function.name), {"parameters": []})["parameters"]}
        for argument, value in zip(function.args.kwonlyargs, function.args.kw_defaults, strict=True):
            if argument.arg in described and isinstance(value, ast.Constant) and value.value is not None:
                assert value.value == described[argument.arg]["default"], (function.name, argument.arg)
                compared += 1
    assert compared > 40
