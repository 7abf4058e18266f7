# SPDX-License-Identifier: GPL-3.0-or-later
"""README, docs/COMMAND_LINE.md, docs/PARAMETERS.md, the description of the filters and the program's help say the same."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()
PAGE = (ROOT / "docs" / "COMMAND_LINE.md").read_text()
FILTERS = json.loads((ROOT / "filters" / "filters.json").read_text())["filters"]
CURVE, FIELD = ({p["id"]: p for p in f["parameters"]} for f in FILTERS[:2])

# Layers, selections, and files that the program has options of its own for.
OF_HOSTS = {"surface_layer", "replace", "picks_layer", "picks_file", "picks", "field_region", "region", "tube_radius", "save",
            "control_polygon", "shell_layers"}
# What the program alone has.
OF_PROGRAM = {
    (): {"picks", "output", "report", "repeat", "require-usable", "no-cache", "field-region",
         "field-region-under", "field-region-over", "unit", "quiet"},
    ("field",): {"output", "report", "region", "region-under", "region-over", "quiet"},
    ("shell",): {"output", "report", "check", "conforming-to-surface", "no-cache", "quiet"},
}
OF_SHELLS = {"shell", "target_thickness", "target_edge_length", "shell_thickness", "shell_smoothing_passes", "strict", "weld", "slits"}


def helped(run, *verb):
    """Option -> (default, help); the default is "" where there is none."""
    verb = verb or ("curve",)
    text = run(*verb, "--help").stdout + (run(*verb, "--help", "paper").stdout if verb == ("curve",) else "")
    found = re.findall(r"^  (?:-h,)?--([\w-]+)[\w,-]*(?: [^\s=]+(?:=(\S+))?)?(?: REQUIRED)?\s+(\S.*)$", text, re.M)
    return {name: (default, words) for name, default, words in found if name not in ("help", "version")}


def described(parameters):
    return {p["id"].replace("_", "-"): p for p in parameters.values() if p["id"] not in OF_HOSTS}


def default_text(parameter):
    value = parameter["default"]
    return ("on" if value else "") if isinstance(value, bool) else f"{value:g}" if isinstance(value, float) else str(value)


@pytest.mark.parametrize("verb, parameters, other", [
    ((), CURVE, {"avoid-threshold": ""}),  # has to be given where it is needed
    (("field",), FIELD, {"kind": ""}),  # has to be given
    (("shell",), {name: CURVE[name] for name in OF_SHELLS}, {"shell": "simplified"}),
])
def test_options_are_the_described_parameters_and_the_programs_own(run, verb, parameters, other):
    options = helped(run, *verb)
    expected = described(parameters)
    assert set(options) - OF_PROGRAM[verb] == set(expected)
    assert OF_PROGRAM[verb] <= set(options)
    for name, parameter in expected.items():
        default, words = options[name]
        assert default == other.get(name, default_text(parameter)), name
        assert words.startswith(parameter["help"]), name


def test_a_kind_is_told_with_the_option(run):
    words = helped(run, "field")["kind"][1]
    for option in FIELD["kind"]["enumOptions"]:
        assert f"{option['id']}: {option['help']}" in words
    assert "selected" not in helped(run)["avoid"][1]


def rows_of(page, title):
    section = re.search(rf"\n## {title}\n(.*?)(?=\n## |\Z)", page, re.S)[1]
    return section, re.findall(r"^\| (`[\w-]+`[^|]*) \| ([^|]*) \|", section, re.M)


@pytest.mark.parametrize("verb, title", [("shell", "Shells"), ("field", "Fields")])
def test_the_section_of_a_verb_names_every_option_and_its_default(run, verb, title):
    section, rows = rows_of(PAGE, title)
    options = helped(run, verb)
    for name, default in rows:
        given = options[name.strip("`-")][0]
        assert default == given or (given == "" and default in ("none", "off")), name
    assert len(rows) >= 5
    assert [name for name in options if f"`--{name}`" not in section] == []


def test_the_table_of_curves_has_the_programs_defaults(run):
    _, rows = rows_of(README, "Options")
    options = helped(run)
    assert len(rows) > 6
    for name, default in rows:
        given = options[name.strip("`").replace("_", "-")][0]
        assert default == given or (given == "" and default in ("none", "off")), name


def test_what_the_program_alone_has_is_explained(run):
    section, _ = rows_of(PAGE, "Curves")
    assert [name for name in OF_PROGRAM[()] if f"`--{name}`" not in section] == []


def test_the_page_of_parameters_is_what_the_description_says():
    done = subprocess.run([sys.executable, ROOT / "scripts" / "parameters_page.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    page = (ROOT / "docs" / "PARAMETERS.md").read_text()
    for parameter in [*CURVE, *FIELD]:
        assert f"\n| `{parameter}`" in page
    assert "docs/PARAMETERS.md" in README


def test_a_page_that_is_out_of_date_is_noticed(tmp_path):
    for name in ("scripts", "filters", "docs"):
        (tmp_path / name).mkdir()
    script = tmp_path / "scripts" / "parameters_page.py"
    script.write_text((ROOT / "scripts" / "parameters_page.py").read_text())
    description = (ROOT / "filters" / "filters.json").read_text()
    (tmp_path / "filters" / "filters.json").write_text(description)
    subprocess.run([sys.executable, script], check=True)
    assert (tmp_path / "docs" / "PARAMETERS.md").read_text() == (ROOT / "docs" / "PARAMETERS.md").read_text()
    (tmp_path / "filters" / "filters.json").write_text(description.replace("Polynomial degree", "Degree"))
    done = subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)
    assert done.returncode == 1 and "run scripts/parameters_page.py" in done.stderr
