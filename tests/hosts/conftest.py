# SPDX-License-Identifier: GPL-3.0-or-later
"""Real hosts: MeshLab and meshlabserver 2020.09 of Debian with our plugin beside theirs, on a display without a screen."""
import importlib.util
import os
import re
import shutil
import subprocess
from pathlib import Path

import pymeshlab
import pytest
from float_ply import bunny_ply, write_ply
from meshlab_window import MeshLabWindow
from virtual_display import VirtualDisplay

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("BSPLINE_CURVE_BUILD", ROOT / "build" / "release"))


@pytest.fixture(scope="session")
def display():
    missing = VirtualDisplay.missing_programs()
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)} (Debian: xvfb openbox xdotool imagemagick)")
    with VirtualDisplay() as display:
        yield display


@pytest.fixture(scope="session")
def legacy_plugin():
    path = BUILD / "plugins" / "meshlab-2020.09" / "libfilter_bspline_curve_legacy.so"
    assert path.is_file(), f"{path} is not there: build with -DBSPLINE_CURVE_LEGACY=ON, or set BSPLINE_CURVE_BUILD"
    return path


@pytest.fixture(scope="session")
def prefix(legacy_plugin, tmp_path_factory):
    """MeshLab 2020.09 with our plugin, made as docs/MESHLAB.md says."""
    folder = tmp_path_factory.mktemp("hosts") / "meshlab-2020.09"
    command = [ROOT / "scripts" / "meshlab_2020_prefix", folder, legacy_plugin]
    done = subprocess.run(command, capture_output=True, text=True)
    if "is not installed" in done.stderr or "not 2020.09" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="session")
def program_on(request):
    """program_on(display, version): MeshLab's program, with our plugins where it looks for them on this display."""

    def program(display, version):
        if version == "2020.09":
            return request.getfixturevalue("prefix") / "bin" / "meshlab"
        where = subprocess.run([ROOT / "scripts" / "build_meshlab_gui", "--where"], capture_output=True, text=True)
        found = Path(where.stdout.strip()) / "bin" / "meshlab"
        if not found.is_file():
            pytest.skip("the window of MeshLab 2025.07 is not built; scripts/build_meshlab_gui builds it in 15 minutes")
        plugins = display.home / "data" / "VCG" / "MeshLab_64bit_dp" / "MeshLabExtraPlugins" / "2025.07d"
        plugins.mkdir(parents=True, exist_ok=True)
        for plugin in (BUILD / "plugins").glob("*.so"):
            shutil.copy(plugin, plugins)
        return found

    return program


@pytest.fixture(scope="session")
def program_of(program_on, display):
    """program_of(version): that program for the display of all tests."""
    return lambda version: program_on(display, version)


@pytest.fixture(params=["2020.09", "2025.07"])
def meshlab(request, display, program_of, sphere):
    """MeshLab's window with the sphere."""
    with MeshLabWindow(display, program_of(request.param), sphere) as window:
        yield window


@pytest.fixture(scope="session")
def example_scripts():
    """The module that writes filter scripts."""
    spec = importlib.util.spec_from_file_location("example_scripts", ROOT / "scripts" / "example_scripts.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def write_script(example_scripts, tmp_path):
    """Writes a filter script with these (filter, changed parameters) and returns its path."""

    def write(*filters, name="script.mlx"):
        text = example_scripts.script("A test's.", filters, example_scripts.descriptions())
        (tmp_path / name).write_text(text)
        return tmp_path / name

    return write


@pytest.fixture(scope="session")
def bunny(tmp_path_factory):
    return bunny_ply(tmp_path_factory.mktemp("meshes"))


@pytest.fixture(scope="session")
def sphere(tmp_path_factory):
    """A sphere of radius 1 about the origin as sphere.ply."""
    document = pymeshlab.MeshSet()
    document.create_sphere(radius=1, subdiv=5)
    mesh = document.current_mesh()
    return write_ply(tmp_path_factory.mktemp("meshes") / "sphere.ply", mesh.vertex_matrix(), mesh.face_matrix())


@pytest.fixture
def checkout(tmp_path):
    """What a user has after scripts/quickstart, with nothing that tests made before."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    (tmp_path / "scripts").symlink_to(ROOT / "scripts")
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "release").symlink_to(BUILD)
    shutil.copy(Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj", tmp_path)
    # As scripts/quickstart makes it.
    command = next(line for line in (ROOT / "scripts" / "quickstart").read_text().splitlines() if "bunny.ply" in line)
    environment = {**os.environ, "mesh": "bunny.obj", "results": "build/quickstart"}
    (tmp_path / "build" / "quickstart").mkdir()
    subprocess.run(["bash", "-e", "-c", command], cwd=tmp_path, env=environment, check=True)
    return tmp_path


@pytest.fixture(scope="session")
def readme_commands():
    """The commands of README's section on MeshLab, in order; one that goes on in the next line is one."""
    section = re.search(r"\n## MeshLab\n(.*?)\n## ", (ROOT / "README.md").read_text(), re.S)[1]
    lines = re.findall(r"^    (.*\n)", section, re.M)
    return "".join(lines).replace("\\\n", " ").splitlines()
