# SPDX-License-Identifier: GPL-3.0-or-later
"""README's example runs as it stands there, and its options are those of the filter and the program."""
import re
import subprocess
from pathlib import Path

import pymeshlab
import pytest

README = (Path(__file__).resolve().parents[2] / "README.md").read_text()


@pytest.fixture(scope="module")
def help_text(program):
    return subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout


def parameters(capfd):
    from curves import FILTER

    pymeshlab.print_filter_parameter_list(FILTER)
    return re.findall(r"^\t(\w+) : ", capfd.readouterr().out, re.M)


def test_the_python_example_runs(capsys):
    code = re.search(r"```python\n(.*?)```", README, re.S).group(1)
    code = re.sub(r'^pymeshlab\.load_plugin\(.*\n', "", code, flags=re.M)  # the plugin of this build is loaded
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out.startswith("True ")


def test_every_parameter_of_the_filter_is_explained(capfd):
    names = parameters(capfd)
    assert len(names) > 20
    assert [name for name in names if f"`{name}`" not in README] == []


def test_the_program_has_the_filters_options(capfd, help_text):
    only_in_the_filter = {"surface_layer", "picks_layer", "picks_file"}
    names = set(parameters(capfd)) - only_in_the_filter
    assert [name for name in names if "--" + name.replace("_", "-") not in help_text] == []
