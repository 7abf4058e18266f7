# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package in virtual environments that the commands of the pages make from nothing, once."""
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def page_commands(page, section):
    """The first commands of a section."""
    return re.search(rf"\n## {section}\n.*?\n\n((?:    [^\n]*\n)+)", (ROOT / page).read_text(), re.S)[1]


class Home:
    """An empty home directory, and what was installed there."""

    def __init__(self, folder):
        self.folder = folder
        self.python = folder / "curves" / "bin" / "python"
        # Downloads are kept between runs: packages, headers, objects of the compiler.
        cache = os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))
        self.environment = {name: text for name, text in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_"))}
        self.environment |= {"HOME": str(folder), "XDG_CACHE_HOME": cache, "BSPLINE_CURVE_CACHE": ""}
        # Compiled as the release build is, so that ccache has the objects: seconds in place of minutes.
        self.environment["SKBUILD_CMAKE_DEFINE"] = "BSPLINE_CURVE_WERROR=ON"
        self.environment.setdefault("CXX", "c++")  # CMake's choice; pip's would be the compiler of Python
        if shutil.which("ccache"):
            self.environment.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")

    def install(self, page, section):
        command = ["bash", "-e", "-c", page_commands(page, section)]
        done = subprocess.run(command, cwd=ROOT, env=self.environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
        self.printed = done.stdout

    def run(self, *words):
        """Runs the installed Python in the home directory, far from the checkout."""
        return subprocess.run([self.python, *words], cwd=self.folder, env=self.environment, capture_output=True, text=True)

    def call(self, code, **given):
        """Runs code that finds these arrays as variables; the arrays that it puts into `answer`, a dict."""
        np.savez(self.folder / "given.npz", **given)
        lines = ["import numpy as np", "globals().update(np.load('given.npz', allow_pickle=True))", "answer = {}", code]
        script = self.folder / "call.py"
        script.write_text("\n".join([*lines, "np.savez('answer.npz', **answer)", ""]))
        done = self.run(script)
        assert done.returncode == 0, done.stdout + done.stderr
        return dict(np.load(self.folder / "answer.npz"))


@pytest.fixture(scope="session")
def home(tmp_path_factory):
    home = Home(tmp_path_factory.mktemp("home"))
    home.install("docs/PYTHON.md", "Building for pymeshlab")
    return home


@pytest.fixture(scope="session")
def plain_home(tmp_path_factory):
    """With nothing but what README's commands install."""
    home = Home(tmp_path_factory.mktemp("plain_home"))
    home.install("README.md", "Python")
    return home


@pytest.fixture(scope="session")
def sphere():
    """vertices and faces of a sphere of radius 1."""
    import pymeshlab

    document = pymeshlab.MeshSet()
    document.create_sphere(radius=1, subdiv=4)
    mesh = document.current_mesh()
    return {"vertices": mesh.vertex_matrix(), "faces": mesh.face_matrix()}
