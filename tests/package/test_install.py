# SPDX-License-Identifier: GPL-3.0-or-later
"""From the pages' commands to a picture, and what is told where something is missing."""
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
IMPORT = "import meshlab_bspline_curve"


def test_the_commands_of_the_page_draw_a_picture(home):
    assert re.search(r"demo\.png: a curve of \d{3} points, 1\.07\d long", home.printed)
    picture = np.asarray(Image.open(home.folder / "demo.png")).astype(int)
    assert picture.shape == (800, 900, 3)
    red, green, blue = np.moveaxis(picture, 2, 0)
    is_curve = (red > 120) & (green < red // 2) & (blue < red // 2)
    is_pick = (blue > 50) & (red < blue // 2) & (green < blue)
    assert 3000 < is_curve.sum() < 30000
    assert 500 < is_pick.sum() < 10000
    rows, columns = np.nonzero(is_curve)
    assert np.ptp(rows) > 200 and np.ptp(columns) > 300


def example(page, section):
    return re.search(rf"\n## {section}\n.*?```python\n(.*?)```", (ROOT / page).read_text(), re.S)[1]


def test_the_example_of_readme_runs(plain_home):
    done = plain_home.run("-c", example("README.md", "Python"))
    assert re.fullmatch(r"True <bspline_curve\.Curve: open, 4 picks, \d+ points, length [\d.]+>\n", done.stdout), done.stderr
    assert done.stderr == ""


@pytest.mark.skipif(not Path("/usr/include/CLI").is_dir(), reason="CLI11 is not installed")
def test_the_program_is_in_the_package(plain_home, program):
    folder = plain_home.python.parent
    for words in (["--version"], ["curve", "--help"], ["--completion", "bash"]):
        by_itself = subprocess.run([program, *words], capture_output=True, text=True)
        for name in ("bspline_curve", "bspline-curve"):
            if (name, words) != ("bspline-curve", ["--version"]):
                done = subprocess.run([folder / name, *words], capture_output=True, text=True)
                assert (done.returncode, done.stdout) == (0, by_itself.stdout)


def test_a_second_install_compiles_nothing(plain_home):
    command = [plain_home.python, "-m", "pip", "install", "-v", "--force-reinstall", "--no-deps", "."]

    def install():
        done = subprocess.run(command, cwd=ROOT, env=plain_home.environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
        return done.stdout.count("Building CXX object")

    install()  # other tests build for other packages in the same folder
    assert install() == 0


def test_the_package_needs_numpy_alone(plain_home):
    done = plain_home.run("-m", "pip", "list", "--format", "freeze")
    assert {line.split("==")[0] for line in done.stdout.split()} - {"pip", "setuptools"} == {"bspline_curve", "numpy"}


def test_the_example_for_pymeshlab_runs(home):
    done = home.run("-c", example("docs/PYTHON.md", "Building for pymeshlab"))
    assert (done.stdout, done.stderr) == ("True True\n", "")


def test_the_page_names_the_packages_that_the_build_needs():
    named = re.search(r"## Building.*?apt-get install (.*?)`", (ROOT / "docs" / "PYTHON.md").read_text(), re.S)[1].split()
    setup = (ROOT / "scripts" / "setup.sh").read_text()
    listed = re.sub(r"#.*", "", re.search(r"build_packages=\((.*?)\n\)", setup, re.S)[1]).split()
    assert set(named) == set(listed) - {"libcli11-dev"}  # for the program alone


def test_the_wheel_holds_the_plugin(home):
    answer = home.call(
        "import importlib.metadata as metadata\n"
        "answer['files'] = [str(file) for file in metadata.files('bspline_curve')]\n"
        "answer['requires'] = metadata.requires('bspline_curve')"
    )
    files = [file for file in answer["files"] if file.startswith("meshlab_bspline_curve/") and "__pycache__" not in file]
    assert [file for file in files if file.endswith(".so")] == ["meshlab_bspline_curve/libfilter_bspline_curve.so"]
    sources = {f"meshlab_bspline_curve/{path.name}" for path in (ROOT / "python" / "meshlab_bspline_curve").iterdir() if path.is_file()}
    made = {f"meshlab_bspline_curve/{name}" for name in ("_built_for.py", "filters.json", "bunny.pp", "libfilter_bspline_curve.so")}
    assert set(files) == sources | made
    assert "pymeshlab==2025.7.*; extra == 'meshlab'" in [str(each).replace('"', "'") for each in answer["requires"]]


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("pymeshlab.pmeshlab.__version__ = '2023.12.post3'",
         "built for pymeshlab 2025.7, but pymeshlab 2023.12.post3 is installed: run pip install \"pymeshlab==2025.7.*\""),
        ("pymeshlab.pmeshlab.__version__ = '2025.12'", "but pymeshlab 2025.12 is installed"),
        ("class Single:\n"
         "    def __init__(self, vertices): pass\n"
         "    def vertex_matrix(self): return np.zeros((1, 3), np.float32)\n"
         "pymeshlab.Mesh = Single",
         "built for a pymeshlab with double precision, but the one that is installed (2025.7.post1) has float precision"),
        ("def refuse(path): raise pymeshlab.PyMeshLabException('it is damaged.')\npymeshlab.load_plugin = refuse",
         "pymeshlab does not load the plugin: it is damaged.; run BSPLINE_CURVE_MESHLAB=1 pip install --force-reinstall"),
    ],
)
def test_a_host_that_does_not_fit_is_one_clear_error(home, before, expected):
    done = home.run("-c", f"import numpy as np, pymeshlab\n{before}\n{IMPORT}")
    assert done.returncode == 1
    last = done.stderr.splitlines()[-1]
    assert last.startswith("meshlab_bspline_curve.errors.HostError: ") and expected in last


def test_the_plugin_is_loaded_once_by_whoever_comes_first(home):
    done = home.run("-c", f"""if True:
        import importlib, pymeshlab
        before = pymeshlab.number_plugins()
        {IMPORT}
        assert pymeshlab.number_plugins() == before + 1
        importlib.reload(meshlab_bspline_curve)
        assert pymeshlab.number_plugins() == before + 1""")
    assert done.returncode == 0, done.stderr


def test_a_plugin_that_was_loaded_by_its_path_is_used(home, plugin_path):
    done = home.run("-c", f"""if True:
        import pymeshlab
        pymeshlab.load_plugin({str(plugin_path)!r})
        loaded = pymeshlab.number_plugins()
        {IMPORT}
        assert pymeshlab.number_plugins() == loaded
        document = pymeshlab.MeshSet()
        document.create_sphere()
        assert document.generate_bspline_curve_on_surface(picks="1 0 0; 0 1 0")["usable"]""")
    assert done.returncode == 0, done.stderr


def test_a_plugin_that_is_not_there_is_said(home):
    done = home.run("-c", f"""if True:
        from pathlib import Path
        {IMPORT}.host as host
        host.PLUGIN = Path("gone.so")
        host.load_plugin(("not loaded yet",))""")
    assert done.stderr.splitlines()[-1].startswith("meshlab_bspline_curve.errors.HostError: gone.so is not there: run BSPLINE_CURVE_MESHLAB=1 pip")


@pytest.mark.parametrize(
    ("before", "output", "expected"),
    [
        ("sys.modules['PIL'] = None", "a.png", "Pillow, which writes the picture, is not installed: run pip install pillow"),
        ("", "nowhere/a.png", "nowhere/a.png: the directory nowhere does not exist"),
        ("", "a.unknown", "a.unknown: no format of pictures has the extension '.unknown'"),
    ],
)
def test_a_demo_that_cannot_draw_says_why_in_one_line(home, before, output, expected):
    words = ["meshlab_bspline_curve", "demo", "--size", "40", "40", "--output", output]
    done = home.run("-c", f"import runpy, sys\n{before}\nsys.argv = {words}\nrunpy.run_module('meshlab_bspline_curve')\n"
                    "runpy.run_module('meshlab_bspline_curve', run_name='__main__', alter_sys=True)")
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1 and done.stderr.startswith("meshlab_bspline_curve: ") and expected in done.stderr
    assert not (home.folder / output).exists()


def test_without_headers_and_network_the_build_ends_with_one_error(home, tmp_path):
    (tmp_path / "bin").mkdir()
    apt = tmp_path / "bin" / "apt-get"
    apt.write_text("#!/bin/sh\nexit 100\n")
    apt.chmod(0o755)
    environment = home.environment | {"XDG_CACHE_HOME": str(tmp_path), "PATH": f"{tmp_path / 'bin'}:{home.environment['PATH']}"}
    command = ["cmake", "-S", ROOT, "-B", tmp_path / "build", "-DBSPLINE_CURVE_FETCH=ON",
               "-DBSPLINE_CURVE_PROGRAM=OFF", "-DBSPLINE_CURVE_TESTS=OFF"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode != 0 and done.stderr.count("CMake Error") == 1
    said = " ".join(done.stderr.split())
    assert "The headers of MeshLab 2025.07 and vcglib are not there, and could not be fetched" in said
    assert "apt is configured with no mirror of Debian" in said
    assert "pip: --config-settings cmake.define.MESHLAB_SOURCE_DIR=<the checkout>" in said


def test_functions_and_methods_are_what_the_description_says(tmp_path):
    script = ROOT / "scripts" / "python_filters.py"
    done = subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    # Others are noticed.
    for folder in ("scripts", "filters", "python/meshlab_bspline_curve", "python/bspline_curve"):
        (tmp_path / folder).mkdir(parents=True)
    for part in (script, *script.parent.glob("python_*.py")):
        (tmp_path / "scripts" / part.name).write_text(part.read_text())
    copy = tmp_path / "scripts" / script.name
    description = (ROOT / "filters" / "filters.json").read_text()
    (tmp_path / "filters" / "filters.json").write_text(description)
    subprocess.run([sys.executable, copy], check=True)
    (tmp_path / "filters" / "filters.json").write_text(description.replace('"default": 256', '"default": 257'))
    done = subprocess.run([sys.executable, copy, "--check"], capture_output=True, text=True)
    assert done.returncode == 1 and "filters.py, methods.py, _keywords.py; run scripts/python_filters.py" in done.stderr
