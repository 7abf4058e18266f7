# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the program in README and its pages run as they stand, after scripts/quickstart. Those of Python and of
MeshLab are run in tests/package and tests/hosts."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]


def commands_of(page, section):
    text = re.search(rf"\n## {section}\n(.*?)(?=\n## |\Z)", (ROOT / page).read_text(), re.S)[1]
    return re.findall(r"^    (.+)$", text, re.M)


@pytest.fixture
def checkout(program, tmp_path):
    """What a user has after scripts/quickstart."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    (tmp_path / ".cache").mkdir()
    (tmp_path / ".cache" / "venv").symlink_to(sys.prefix)
    (tmp_path / "build" / "quickstart").mkdir(parents=True)
    (tmp_path / "build" / "release" / "bin").mkdir(parents=True)
    (tmp_path / "build" / "release" / "bin" / "bspline_curve").symlink_to(program)
    command = next(line for line in (ROOT / "scripts" / "quickstart").read_text().splitlines() if "bunny.ply" in line)
    mesh = next(Path(sys.prefix).glob("lib/python3*/site-packages/pymeshlab/tests/sample_meshes/bunny.obj"))
    environment = {**os.environ, "mesh": str(mesh), "results": "build/quickstart"}
    subprocess.run(["bash", "-e", "-c", command], cwd=tmp_path, env=environment, check=True)
    return tmp_path


@pytest.mark.parametrize(("page", "section", "made"), [
    ("README.md", "Five uses", ["build/ring.json", "build/filled.ply", "build/curve.step", "build/ridge.ply", "build/offset.ply"]),
    ("docs/COMMAND_LINE.md", "Batches", ["examples/batch/jobs.results.csv", "examples/batch/bunny-straight.dxf"]),
    ("docs/COMMAND_LINE.md", "Fields", ["build/ridge.ply"]),
    ("docs/COMMAND_LINE.md", "Shells", ["build/shell.vtu"]),
    ("docs/COMMAND_LINE.md", "Imprints", ["build/imprinted.ply", "build/map.json"]),
    ("docs/COMMAND_LINE.md", "Cuts", ["build/opened.ply"]),
    ("docs/COMMAND_LINE.md", "Offsets", ["build/offset.ply"]),
    ("docs/COMMAND_LINE.md", "Patterns", ["build/star.json", "build/starred.ply"]),
])
def test_the_commands_of_a_page_make_what_they_say(checkout, page, section, made):
    commands = commands_of(page, section)
    assert commands
    done = subprocess.run(["bash", "-e", "-c", "\n".join(commands)], cwd=checkout, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert [name for name in made if not (checkout / name).is_file()] == []


def test_every_command_of_readme_is_run_by_a_test():
    """Here, in tests/package and tests/hosts; scripts/quickstart and scripts/test are run by whoever runs this."""
    text = (ROOT / "README.md").read_text()
    run = [command for section in ("Five uses", "Python", "MeshLab") for command in commands_of("README.md", section)]
    code = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    assert [c for c in re.findall(r"^    (.+)$", code, re.M) if c not in run] == ["scripts/quickstart", "scripts/test"]
