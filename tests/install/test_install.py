# SPDX-License-Identifier: GPL-3.0-or-later
"""The library as a project outside sees it: installed and found, by CMake and pkg-config, and as a subdirectory."""
import json
import math
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
HEADERS = sorted(path.name for path in (ROOT / "include" / "bspline_curve").glob("*.h"))
OF_FILES = {"atomic_file.h", "files.h", "whole_shell.h"}
LIBRARY_ALONE = ["-DBSPLINE_CURVE_PROGRAM=OFF", "-DBSPLINE_CURVE_PLUGIN=OFF", "-DBSPLINE_CURVE_TESTS=OFF"]
WITHOUT_FILES = [*LIBRARY_ALONE, "-DBSPLINE_CURVE_FILES=OFF"]
ARCHIVES = [f"libbspline_curve_{name}.a" for name in ("core", "field", "sketch", "workpiece")]
FOREIGN = ["TetGen", "MeshLabSource", "Qt5", "GTest", "CLI11", "nlohmann_json", "tinyxml2", "benchmark"]

pytestmark = pytest.mark.slow

# Draws README's curve on a square of 2 x 12 x 12 faces, through picks on a circle around its middle.
PROGRAM = """
{includes}
#include <bspline_curve/version.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {{
    const int n = 12;
    std::vector<bspline_curve::Vec3> vertices, picks;
    std::vector<bspline_curve::Triangle> faces;
    for (int j = 0; j <= n; ++j) {{
        for (int i = 0; i <= n; ++i) {{
            vertices.emplace_back(i, j, 0.0);
            if (i < n && j < n) {{
                const int v = j * (n + 1) + i;
                faces.push_back({{v, v + 1, v + n + 2}});
                faces.push_back({{v, v + n + 2, v + n + 1}});
            }}
        }}
    }}
    for (int k = 0; k < 5; ++k) {{
        picks.emplace_back(6.0 + 4.0 * std::cos(1.2 * k), 6.0 + 4.0 * std::sin(1.2 * k), 0.0);
    }}
{example}
    for (const bspline_curve::Vec3& point : curve.polyline.points) {{
        const double radius = (point - bspline_curve::Vec3(6.0, 6.0, 0.0)).norm();
        if (std::abs(radius - 4.0) > 0.2 || point.z() != 0.0) return 1;
    }}
    if (!curve.report.usable || !curve.polyline.closed) return 2;
    if (curve.spline.knots.size() != curve.spline.controlPoints.size() + 4) return 3;
    try {{
        bspline_curve::Workpiece({{vertices, {{{{0, 0, 1}}}}}});
        return 4;
    }} catch (const bspline_curve::InputError& error) {{
        if (error.code() != bspline_curve::InputErrorCode::DegenerateFace) return 5;
    }}
    std::printf("%s %zu\\n", BSPLINE_CURVE_VERSION, curve.polyline.points.size());
}}
"""

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
{library}
if(DEFINED CMAKE_CXX_STANDARD OR DEFINED CMAKE_RUNTIME_OUTPUT_DIRECTORY OR DEFINED CMAKE_CXX_VISIBILITY_PRESET)
  message(FATAL_ERROR "the library sets what is the project's own to set")
endif()
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE bspline_curve::bspline_curve)
# Each public header by itself, twice.
add_library(headers OBJECT {headers})
target_link_libraries(headers PRIVATE bspline_curve::bspline_curve)
file(GENERATE OUTPUT definitions.txt CONTENT
  "$<TARGET_PROPERTY:consumer,INCLUDE_DIRECTORIES>|$<TARGET_PROPERTY:bspline_curve::bspline_curve,INTERFACE_COMPILE_OPTIONS>")
"""


def run(*command, **environment):
    done = subprocess.run(
        [str(part) for part in command], env={**os.environ, **environment}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout


def configure(source, build, *options):
    """Where nothing but Eigen can be found; scripts/fetch_meshlab keeps MeshLab's headers in the cache."""
    foreign = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in FOREIGN]
    run("cmake", "-S", source, "-B", build, "-G", "Ninja", *foreign, *options, XDG_CACHE_HOME=str(build))


def write_consumer(folder, library, names=(*HEADERS, "version.h")):
    example = re.search(r"^## C\+\+\n.*?```cpp\n(.*?)```", (ROOT / "README.md").read_text(), re.M | re.S).group(1)
    lines = example.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    assert includes == ["#include <bspline_curve/workpiece.h>"]
    code = [line for line in lines if line not in includes]
    includes.append("#include <bspline_curve/error.h>")
    folder.mkdir()
    (folder / "main.cpp").write_text(PROGRAM.format(includes="\n".join(includes), example="\n".join(code)))
    for name in names:
        (folder / f"{name}.cpp").write_text(f"#include <bspline_curve/{name}>\n" * 2)
    (folder / "CMakeLists.txt").write_text(
        PROJECT.format(library=library, headers=" ".join(f"{name}.cpp" for name in names)))


def build_and_run(source, build, *options):
    configure(source, build, *options)
    run("cmake", "--build", build)
    check_consumer(build)


def check_consumer(build):
    """The example gives its curve, and was compiled with none of the library's own paths and options."""
    version, points = run(build / "consumer").split()
    assert version == re.search(r"project\(bspline_curve VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    assert int(points) > 256
    includes, compile_options = (build / "definitions.txt").read_text().split("|")
    assert str(ROOT) not in includes.split(";")
    assert compile_options == ""


@pytest.fixture(scope="session")
def without_files(build_folder):
    """Configured and built with Eigen alone, as the release build is: where there is ccache, it has the objects."""
    build = build_folder.parent / "without_files"
    shutil.rmtree(build, ignore_errors=True)
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    configure(ROOT, build, *WITHOUT_FILES, "-DCMAKE_BUILD_TYPE=Release", *launcher)
    run("cmake", "--build", build)
    return build


@pytest.fixture(scope="session")
def prefix_without_files(without_files, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("without_files") / "prefix"
    run("cmake", "--install", without_files, "--prefix", prefix)
    return prefix


@pytest.fixture(scope="session")
def prefix(build_folder, tmp_path_factory):
    """Where the whole library is installed, and moved to from where that was done."""
    first = tmp_path_factory.mktemp("install") / "first"
    run("cmake", "--install", build_folder, "--prefix", first, "--component", "library")
    return first.rename(first.parent / "prefix")


def commands_of_the_core(build, generated):
    """How each source file of the core is compiled, whatever the folder of the build."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if "bspline_curve_core.dir" not in entry["command"]:
            continue
        words = [word for word in shlex.split(entry["command"]) if Path(word).name != "ccache"]
        found[Path(entry["file"]).name] = [
            "OBJECT" if word.endswith((".o", ".gch")) else word.replace(str(generated), "BUILD") for word in words
        ]
    return found


def test_as_a_subdirectory_the_library_alone_is_compiled_as_by_itself(without_files, tmp_path):
    """The same commands, so that it need not be compiled again; public headers and the consumer are compiled."""
    build = tmp_path / "build"
    write_consumer(tmp_path / "consumer", f"add_subdirectory({ROOT} library)")
    configure(tmp_path / "consumer", build, "-DCMAKE_BUILD_TYPE=Release", "-DBSPLINE_CURVE_WERROR=ON",
              "-DBSPLINE_CURVE_FILES=OFF", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    expected = commands_of_the_core(without_files, without_files)
    assert len(expected) > 10 and commands_of_the_core(build, build / "library") == expected
    outputs = {line.split(":")[0] for line in run("ninja", "-C", build, "-t", "targets", "all").splitlines()}
    assert sorted({Path(name).name for name in outputs if name.endswith((".a", ".so"))}) == ARCHIVES
    run("cmake", "--build", build, "--target", "headers")
    main = "CMakeFiles/consumer.dir/main.cpp.o"  # what it is linked with are the same objects
    run("ninja", "-C", build, main)
    archives = [next(without_files.rglob(f"libbspline_curve_{name}.a")) for name in ("workpiece", "field", "core")]
    run("c++", build / main, *archives, "-pthread", "-o", build / "consumer")
    check_consumer(build)


def test_as_a_subdirectory_it_installs_nothing_unasked(tmp_path):
    write_consumer(tmp_path / "consumer", f"add_subdirectory({ROOT} library)")
    configure(tmp_path / "consumer", tmp_path / "build", "-DBSPLINE_CURVE_FILES=OFF")
    assert not (tmp_path / "build" / "library" / "bspline_curve-config.cmake").exists()


def test_without_files_it_is_built_with_eigen_alone(without_files):
    assert (without_files / "bspline_curve-config.cmake").exists()
    assert sorted(path.name for path in without_files.rglob("*.a")) == ARCHIVES


def test_an_installed_library_is_found_and_runs_the_example_of_the_readme(prefix_without_files, tmp_path):
    names = [*(name for name in HEADERS if name not in OF_FILES), "version.h"]
    write_consumer(tmp_path / "consumer", "find_package(bspline_curve 0.1 REQUIRED)", names)
    build_and_run(tmp_path / "consumer", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix_without_files}")


def test_every_public_header_compiles_by_itself(prefix, tmp_path):
    write_consumer(tmp_path / "consumer", "find_package(bspline_curve 0.1 REQUIRED)")
    run("cmake", "-S", tmp_path / "consumer", "-B", tmp_path / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", tmp_path / "build", "--target", "headers")


@pytest.mark.parametrize("installed", ["prefix", "prefix_without_files"])
def test_an_installation_holds_the_library_and_public_headers_alone(installed, request):
    folder, has_files = request.getfixturevalue(installed), installed == "prefix"
    files = sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
    headers = [path.name for path in files if path.parts[:2] == ("include", "bspline_curve")]
    assert headers == sorted([*(name for name in HEADERS if has_files or name not in OF_FILES), "version.h"])
    archives = sorted(path.name for path in files if path.suffix == ".a")
    assert archives == sorted([*ARCHIVES, *(["libbspline_curve_io.a"] if has_files else [])])
    assert {path.suffix for path in files} == {".a", ".h", ".cmake", ".pc"}
    package = "".join((folder / path).read_text() for path in files if path.suffix in (".cmake", ".pc"))
    assert str(ROOT) not in package and str(folder.parent) not in package


def test_a_component_that_was_not_built_is_refused(prefix_without_files, tmp_path):
    write_consumer(tmp_path / "consumer", "find_package(bspline_curve REQUIRED COMPONENTS files)")
    with pytest.raises(AssertionError, match="without the component files"):
        configure(tmp_path / "consumer", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix_without_files}")


# ---- examples/cpp, as docs/CPP.md builds them: with what is installed ----


@pytest.fixture(scope="session")
def examples(prefix, tmp_path_factory):
    build = tmp_path_factory.mktemp("examples")
    run("cmake", "-S", ROOT / "examples" / "cpp", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
    run("cmake", "--build", build)
    return build


@pytest.fixture(scope="session")
def ball(tmp_path_factory):
    """A mesh of a ball of radius 1 with a face twice, so that it is mended, and a ring of picks round its north pole."""
    folder = tmp_path_factory.mktemp("ball")
    rings, around = 24, 48
    lines = ["v 0 0 1", "v 0 0 -1"]
    for i in range(1, rings):
        for j in range(around):
            polar, turn = math.pi * i / rings, 2 * math.pi * j / around
            lines.append(f"v {math.sin(polar) * math.cos(turn)} {math.sin(polar) * math.sin(turn)} {math.cos(polar)}")
    at = lambda i, j: 3 + (i - 1) * around + j % around  # noqa: E731
    for j in range(around):
        lines += [f"f 1 {at(1, j)} {at(1, j + 1)}", f"f 2 {at(rings - 1, j + 1)} {at(rings - 1, j)}"]
        for i in range(1, rings - 1):
            lines += [f"f {at(i, j)} {at(i + 1, j)} {at(i + 1, j + 1)}", f"f {at(i, j)} {at(i + 1, j + 1)} {at(i, j + 1)}"]
    lines.append(lines[-1])
    (folder / "ball.obj").write_text("\n".join(lines) + "\n")
    picks = [(math.cos(turn), math.sin(turn), 1) for turn in (0, 1.2, 2.5, 3.7, 5)]
    picks = [[c / math.sqrt(2) for c in pick] for pick in picks]
    (folder / "picks.json").write_text(json.dumps({"picks": picks}))
    return folder


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text)]


RING = 2 * math.pi / math.sqrt(2)  # round the pole


def test_draw_to_step(examples, ball, tmp_path):
    said = run(examples / "draw_to_step", ball / "ball.obj", ball / "picks.json", tmp_path / "ring.step")
    assert "the mesh was mended: 1 duplicate face removed" in said
    usable, length, controls = numbers(said.splitlines()[-1])
    assert usable == 1 and length == pytest.approx(RING, rel=0.02)
    text = (tmp_path / "ring.step").read_text()
    assert text.startswith("ISO-10303-21") and "B_SPLINE_CURVE_WITH_KNOTS" in text and controls > 8


def test_move_pick(examples, ball):
    usable, before, after = numbers(run(examples / "move_pick", ball / "ball.obj", ball / "picks.json"))
    assert usable == 1 and 0.001 < abs(after - before) < 0.3


def test_fit_boundary(examples, ball, tmp_path):
    said = run(examples / "fit_boundary", ball / "ball.obj", tmp_path / "curves.json")
    assert len(json.loads((tmp_path / "curves.json").read_text())["curves"]) == len(said.splitlines()) >= 1
    assert 0 < numbers(said)[0] < 0.1


def test_cut_and_fill(examples, ball, tmp_path):
    filled, faces = numbers(run(examples / "cut_and_fill", ball / "ball.obj", ball / "picks.json", tmp_path / "cut.ply"))
    assert filled == 1 and faces > 2000
    header = (tmp_path / "cut.ply").read_bytes()[:600].decode("latin1")
    assert f"element face {int(faces)}\n" in header and "label" in header


def test_offset_and_imprint(examples, ball, tmp_path):
    said = run(examples / "offset_and_imprint", ball / "ball.obj", ball / "picks.json", "0.2", tmp_path / "band.ply")
    assert numbers(said) == [2]
    assert (tmp_path / "band.ply").stat().st_size > 50_000


def test_pattern(examples, ball, tmp_path):
    said = run(examples / "pattern", ball / "ball.obj", ROOT / "examples" / "star.svg", "0", "0.6", "0.8", tmp_path / "star.obj")
    curves, shortest, longest = numbers(said)
    assert curves >= 1 and 0.8 < shortest <= longest < 1.1
    assert (tmp_path / "star.obj").read_text().count("\nl ") > 20


def test_refusals_end_with_their_message(examples, ball):
    done = subprocess.run([examples / "move_pick", ball / "none.obj", ball / "picks.json"], capture_output=True, text=True)
    assert done.returncode == 1 and "none.obj" in done.stderr


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
def test_pkg_config_links_an_example(prefix, ball, tmp_path):
    flags = run("pkg-config", "--cflags", "--libs", "bspline_curve", PKG_CONFIG_PATH=str(prefix / "lib" / "pkgconfig"))
    run("c++", "-std=c++20", "-O1", ROOT / "examples" / "cpp" / "cut_and_fill.cpp", *shlex.split(flags), "-o", tmp_path / "cut_and_fill")
    filled, _ = numbers(run(tmp_path / "cut_and_fill", ball / "ball.obj", ball / "picks.json", tmp_path / "cut.ply"))
    assert filled == 1


def test_examples_are_short_and_include_public_headers_alone():
    programs = sorted((ROOT / "examples" / "cpp").glob("*.cpp"))
    assert len(programs) == 6
    for program in programs:
        text = program.read_text()
        assert len(text.splitlines()) <= 40, program.name
        assert all(re.fullmatch(r"<(bspline_curve/\w+\.h|\w+)>", header) for header in re.findall(r"^#include (.+)", text, re.M))


def test_what_the_fuzzer_is_linked_with_is_built(tmp_path):
    """Configured as scripts/fuzz does, but for the compiler: CMake then knows every library by its target."""
    run("cmake", "--preset", "fuzz", "-S", ROOT, "-B", tmp_path, "-DCMAKE_CXX_COMPILER=c++", "-DCMAKE_CXX_FLAGS=")
    targets = run("ninja", "-C", tmp_path, "-t", "inputs", "fuzz")
    for library in ("bspline_curve_io", "bspline_curve_cli", "test_support"):
        assert f"lib{library}.a" in targets
