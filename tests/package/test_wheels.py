# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/wheels refuses and what it says. Making wheels takes minutes; those that were made are checked again here."""
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "wheels"
MADE = sorted((ROOT / "build" / "wheels" / "dist").glob("*.whl"))
NAME = "bspline_curve-0.1.0-cp312-abi3"


def wheels(*words):
    done = subprocess.run([sys.executable, SCRIPT, *words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


@pytest.fixture(scope="module")
def package(plain_home):
    """The folder of the installed package."""
    return Path(plain_home.run("-c", "import bspline_curve; print(bspline_curve.__file__)").stdout.strip()).parent


def packed(file, package, left_out=()):
    """A wheel of the installed package, as far as the script looks at it; its record lists no more than it holds."""
    folder = package.parent
    paths = [path for path in folder.glob("bspline_curve*/**/*") if path.is_file() and path.name not in left_out and path.suffix != ".pyc"]
    names = {str(path.relative_to(folder)) for path in paths}
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in paths:
            name = str(path.relative_to(folder))
            if path.name == "RECORD":
                rows = path.read_text().splitlines(keepends=True)
                archive.writestr(name, "".join(row for row in rows if row.split(",")[0] in names))
            else:
                archive.write(path, name)
    return file


def test_a_wheel_of_this_machine_is_refused(package, tmp_path):
    count, said = wheels("--check", packed(tmp_path / f"{NAME}-linux_x86_64.whl", package))
    assert count == 1 and "is for this machine alone: its name has no tag of manylinux" in said


def test_a_wheel_that_needs_a_new_glibc_is_refused_whatever_its_name_says(package, tmp_path):
    """The compiler of this machine links against its own glibc and libstdc++."""
    count, said = wheels("--check", packed(tmp_path / f"{NAME}-manylinux_2_17_x86_64.whl", package))
    assert count == 1 and ("but must be content with manylinux_2_17_x86_64" in said or "is refused by auditwheel" in said)


def test_a_wheel_with_code_of_another_processor_is_refused(package, tmp_path):
    file = packed(tmp_path / f"{NAME}-manylinux_2_17_aarch64.whl", package)
    count, said = wheels("--check", file)
    assert count == 1 and "is refused by auditwheel" in said and "x86_64 architecture" in said, said


def test_what_a_wheel_lacks_is_told(package, tmp_path):
    file = packed(tmp_path / f"{NAME}-linux_x86_64.whl", package, left_out=("py.typed", "_core.pyi"))
    _, said = wheels("--check", file)
    assert "does not hold bspline_curve/py.typed" in said and "does not hold bspline_curve/_core.pyi" in said


def test_the_trial_passes_with_the_installed_package_and_fails_without(plain_home, tmp_path):
    status, said = wheels("--try", plain_home.python)
    assert status == 0 and "<bspline_curve.Curve: closed, 4 picks" in said and "import" in said, said
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", tmp_path / "empty"], check=True)
    status, said = wheels("--try", tmp_path / "empty" / "bin" / "python")
    assert status == 1 and "No module named 'bspline_curve'" in said


@pytest.mark.skipif(not MADE, reason="scripts/wheels was not run")
def test_the_wheels_that_were_made_are_in_order():
    count, said = wheels("--check", *MADE)
    assert count == 0 and said.count(": in order, ") == len(MADE), said
