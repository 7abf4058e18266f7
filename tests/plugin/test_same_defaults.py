# SPDX-License-Identifier: GPL-3.0-or-later
"""Every host has the parameters and defaults of filters/filters.json: here the plugin and the Python package. The others are
compared in tests/cli/test_readme_options.py, tests/package/test_types.py, and tests/filters: filter_description_test.cpp and
option_bindings_test.cpp."""
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


@pytest.mark.parametrize("name", FILTERS)
def test_the_host_lists_the_described_parameters_in_their_order(plugin_path, name):
    code = f"import pymeshlab; pymeshlab.load_plugin({str(plugin_path)!r}); pymeshlab.print_filter_parameter_list({name!r})"
    printed = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert re.findall(r"^\t(\w+) : ", printed, re.M) == [p["id"] for p in FILTERS[name]["parameters"] if p["group"] != "window"]


def test_the_example_of_the_page_runs(capsys):
    """With a document of pymeshlab; README's own example is run in tests/package."""
    code = re.search(r"```python\n(import pymeshlab\n.*?)```", (ROOT / "docs" / "PYTHON.md").read_text(), re.S)[1]
    code = re.sub(r'^pymeshlab\.load_plugin\(.*\n', "", code, flags=re.M)  # the plugin of this build is loaded
    exec(compile(code, "PYTHON.md", "exec"), {})
    assert capsys.readouterr().out.startswith("True ")


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
            # Python has no selections: faces of obstacles are an array, None where there are none.
            if name in CURVE and name != "field_region" and argument.default is not inspect.Parameter.empty:
                default = "none" if argument.default is None else argument.default
                if CURVE[name]["type"] in ("picks", "tangents"):  # indices and directions, in place of text
                    default = argument.default or ""
                assert default == CURVE[name]["default"], name
                seen.add(name)
    assert len(seen) > 35 and {"field", "avoid", "degree", "samples", "shell", "weld"} <= seen
