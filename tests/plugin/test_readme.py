# SPDX-License-Identifier: GPL-3.0-or-later
"""The example with a document of pymeshlab runs as it stands in docs/PYTHON.md, and the host lists the parameters that the
description and the page name. README's own example is run in tests/package."""
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from curves import FILTER

ROOT = Path(__file__).resolve().parents[2]
PYTHON = (ROOT / "docs" / "PYTHON.md").read_text()
PAGE = (ROOT / "docs" / "PARAMETERS.md").read_text()
DESCRIBED = json.loads((ROOT / "filters" / "filters.json").read_text())["filters"]


@pytest.fixture(scope="module")
def help_text(program):
    return subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout


def listed(plugin_path, name):
    """Names of a filter's parameters, as the host prints them."""
    code = f"import pymeshlab; pymeshlab.load_plugin({str(plugin_path)!r}); pymeshlab.print_filter_parameter_list({name!r})"
    printed = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    return re.findall(r"^\t(\w+) : ", printed, re.M)


@pytest.fixture(scope="module")
def parameters(plugin_path):
    return listed(plugin_path, FILTER)


def test_the_python_example_runs(capsys):
    code = re.search(r"```python\n(import pymeshlab\n.*?)```", PYTHON, re.S).group(1)
    code = re.sub(r'^pymeshlab\.load_plugin\(.*\n', "", code, flags=re.M)  # the plugin of this build is loaded
    exec(compile(code, "PYTHON.md", "exec"), {})
    assert capsys.readouterr().out.startswith("True ")


def test_every_parameter_of_the_filter_is_explained(parameters):
    assert len(parameters) > 20
    assert [name for name in parameters if f"\n| `{name}`" not in PAGE] == []


@pytest.mark.parametrize("described", DESCRIBED, ids=lambda described: described["id"])
def test_the_host_has_the_described_parameters_in_their_order(plugin_path, described):
    assert listed(plugin_path, described["pythonName"]) == [
        p["id"] for p in described["parameters"] if p["group"] != "window"
    ]


def test_the_program_has_the_filters_options(parameters, help_text):
    only_in_the_filter = {"surface_layer", "picks_layer", "picks_file", "save", "tube_radius", "control_polygon",
                          "shell_layers"}
    names = set(parameters) - only_in_the_filter
    assert [name for name in names if "--" + name.replace("_", "-") not in help_text] == []
