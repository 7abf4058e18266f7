# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of the paper's preset in docs/PAPER.md are those of the code."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def rows():
    table = (ROOT / "docs/PAPER.md").read_text().partition("## Numbers")[2].partition("\n## ")[0]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith("|")]
    return [(symbol, float(number), name.strip("`"), path.strip("`")) for symbol, _, number, name, path in cells[2:]]


@pytest.mark.parametrize("symbol, number, name, path", rows())
def test_a_number_is_that_of_the_code(symbol, number, name, path):
    set_to = re.findall(rf"\b{name} =\s+([\d.e+-]+)[;,]", (ROOT / path).read_text())
    assert [float(value) for value in set_to] == [number]


def test_the_preset_sets_no_number_elsewhere():
    body = (ROOT / "solver/options.cpp").read_text().partition("SolverOptions paperPreset() {")[2].partition("\n}")[0]
    numbers = {name for _, _, name, path in rows() if path.endswith("options.h")}
    assert not numbers & set(re.findall(r"options\.(\w+) =", body))


def test_all_rows_are_compared():
    assert len(rows()) == 15
