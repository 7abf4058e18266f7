# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference is what the docstrings say, and the types of the package are sound, by mypy and by pyright."""
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def test_the_reference_is_what_the_docstrings_say():
    done = subprocess.run([sys.executable, ROOT / "scripts" / "python_reference.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("mypy")


def test_the_package_is_typed_strictly(cache):
    command = [sys.executable, "-m", "mypy", "--cache-dir", cache, "--strict", "python/bspline_curve"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def pyright(folder, *files):
    """The errors that pyright finds: (file name, line, rule) each."""
    pytest.importorskip("pyright")
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "--outputjson", *files]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"] > 0, done.stdout + done.stderr
    return [(Path(each["file"]).name, each["range"]["start"]["line"] + 1, each["message"])
            for each in found["generalDiagnostics"] if each["severity"] == "error"]


def test_pyright_finds_no_error_in_the_package():
    assert pyright(ROOT) == []


@pytest.fixture
def user_program(tmp_path):
    """A program, and the lines of it that are wrong."""
    head = (
        "import bspline_curve\nimport numpy as np\nimport numpy.typing as npt\nfrom typing_extensions import assert_type\n"
        "v, f = np.zeros((3, 3)), np.zeros((1, 3), dtype=np.int32)\nmesh = bspline_curve.Mesh(v, f)\n"
    )
    wrong = [
        "mesh.curve(v, degree=4, shell=1)",
        "mesh.curve(v, degree='4')",
        "mesh.curve(v, bending='thin')",
        "mesh.curve(v).with_options(tension='much')",
        "mesh.field('hills')",
        "bspline_curve.Mesh(v, f, shell='thin')",
    ]
    right = [
        "curve = mesh.curve([(0, (1, 0, 0))], field='ridge', avoid=[1]).move(0, [0, 0, 1])",
        "assert_type(curve.points, npt.NDArray[np.float64])",
        "assert_type(mesh.curve(v, field=v[:, 0]).with_options(tension=0.2, avoid=None), bspline_curve.Curve)",
    ]
    program = tmp_path / "program.py"
    program.write_text(head + "\n".join([*right, *wrong, ""]))
    first = head.count("\n") + len(right) + 1
    return program, list(range(first, first + len(wrong)))


def test_users_see_the_types(cache, user_program):
    program, wrong = user_program
    command = [sys.executable, "-m", "mypy", "--cache-dir", cache, "--strict", program]
    done = subprocess.run(command, env={"MYPYPATH": str(ROOT / "python")}, capture_output=True, text=True)
    assert [line for line in range(1, 40) if f"program.py:{line}: error" in done.stdout] == wrong, done.stdout


def test_users_of_pyright_see_the_types(user_program):
    program, wrong = user_program
    (program.parent / "pyrightconfig.json").write_text(json.dumps({"extraPaths": [str(ROOT / "python")], "typeCheckingMode": "strict"}))
    found = pyright(program.parent)
    assert sorted({line for file, line, _ in found if file == "program.py"}) == wrong, found
