# SPDX-License-Identifier: GPL-3.0-or-later
"""Links, files and names in README, CONTRIBUTING and docs/ exist."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*ROOT.glob("*.md"), *sorted((ROOT / "docs").glob("*.md"))]
FOLDERS = "utility|web|surface|shell|spline|projection|solver|design|field|io|filters|cli|python|scripts|tests|benchmarks|cmake|examples|docs|include|site"


def anchor_of(title):
    """As GitHub makes it from a heading."""
    return re.sub(r"[^\w\- ]", "", title.replace("`", "").lower()).strip().replace(" ", "-")


def text_of(page):
    return re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    lost = []
    for link in re.findall(r"\]\(([^)\s]+)\)|<img src=\"([^\"]+)\"", page.read_text()):
        path, _, anchor = (link[0] or link[1]).partition("#")
        if path.startswith(("http:", "https:")):
            continue
        target = (page.parent / path).resolve() if path else page
        found = target.exists()
        if found and anchor:
            found = anchor in [anchor_of(title) for title in re.findall(r"^#+ (.*)$", text_of(target), re.M)]
        if not found:
            lost.append(link)
    assert lost == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_that_are_named_exist(page):
    named = re.findall(rf"`((?:{FOLDERS})/[\w./*-]*)`", text_of(page))
    lost = [path for path in named if not any(ROOT.glob(path.rstrip("/")))]
    if page.name == "CHANGELOG.md":
        lost = [path for path in lost if path not in text_of(page).partition("### Removed")[2]]
    assert lost == []


@pytest.mark.parametrize("page", ["CONTRIBUTING.md", "docs/ALGORITHM.md"])
def test_names_stand_in_the_file_that_the_page_tells(page):
    pairs = re.findall(r"`([A-Za-z_:]+)` in\s+`([\w/]+\.(?:h|cpp))`", text_of(ROOT / page))
    pairs += [(name, path) for path, name in re.findall(r"`([\w/]+\.(?:h|cpp))` \(`([A-Za-z_:]+)`", text_of(ROOT / page))]
    assert len(pairs) > 5
    assert [pair for pair in pairs if pair[0].split("::")[-1] not in (ROOT / pair[1]).read_text()] == []


def test_the_guide_names_the_keys_of_the_drawing_tool():
    table = re.search(r"### Keys\n\n(.*?)\n\n", (ROOT / "docs" / "MESHLAB.md").read_text(), re.S)[1]
    told = {key.strip() for row in table.splitlines()[2:] for key in row.split("|")[1].split(",")}
    source = (ROOT / "edit_bspline_curve" / "common" / "tool_keys.cpp").read_text()
    names = {"Period": "full stop", "Comma": "comma"}
    bound = {"Enter", "Escape"}
    for key, modifiers in re.findall(r"KeyBinding\{Qt::Key_(\w+), ([^,]+),", source):
        held = [name for name, word in (("Ctrl+", "Control"), ("Shift+", "Shift")) if word in modifiers]
        bound.add("".join(held) + names.get(key, key))
    assert told == bound


def rows():
    """The numbers of the paper's preset in docs/PAPER.md."""
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
