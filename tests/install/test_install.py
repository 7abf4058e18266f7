# SPDX-License-Identifier: GPL-3.0-or-later
"""The library as a project outside sees it: installed and found, and as a subdirectory."""
import json
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
HEADERS = sorted(path.name for path in (ROOT / "include" / "bspline_curve").glob("*.h"))
CORE_ALONE = ["-DBSPLINE_CURVE_PROGRAM=OFF", "-DBSPLINE_CURVE_PLUGIN=OFF", "-DBSPLINE_CURVE_TESTS=OFF"]
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
        bspline_curve::CurveDesigner({{vertices, {{{{0, 0, 1}}}}}});
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


def write_consumer(folder, library, names=(*(name for name in HEADERS if name != "field.h"), "version.h")):
    example = re.search(r"^## C\+\+\n.*?```cpp\n(.*?)```", (ROOT / "README.md").read_text(), re.M | re.S).group(1)
    lines = example.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    assert includes == ["#include <bspline_curve/designer.h>"]
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
def core_alone(build_folder):
    """The core, configured and built with Eigen alone, as the release build is: where there is ccache, it has the objects."""
    build = build_folder.parent / "core_alone"
    shutil.rmtree(build, ignore_errors=True)
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    configure(ROOT, build, *CORE_ALONE, "-DCMAKE_BUILD_TYPE=Release", *launcher)
    run("cmake", "--build", build)
    return build


@pytest.fixture(scope="session")
def prefix(core_alone, tmp_path_factory):
    """Where the core is installed, without fields."""
    prefix = tmp_path_factory.mktemp("install") / "prefix"
    run("cmake", "--install", core_alone, "--prefix", prefix)
    return prefix


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


def test_as_a_subdirectory_the_core_alone_is_compiled_as_by_itself(core_alone, tmp_path):
    """The same commands, so that it need not be compiled again; public headers and the consumer are compiled."""
    build = tmp_path / "build"
    write_consumer(tmp_path / "consumer", f"add_subdirectory({ROOT} library)")
    configure(tmp_path / "consumer", build, "-DCMAKE_BUILD_TYPE=Release", "-DBSPLINE_CURVE_WERROR=ON",
              "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    expected = commands_of_the_core(core_alone, core_alone)
    assert len(expected) > 10 and commands_of_the_core(build, build / "library") == expected
    outputs = {line.split(":")[0] for line in run("ninja", "-C", build, "-t", "targets", "all").splitlines()}
    assert {Path(name).name for name in outputs if name.endswith((".a", ".so"))} == {"libbspline_curve_core.a"}
    run("cmake", "--build", build, "--target", "headers")
    main = "CMakeFiles/consumer.dir/main.cpp.o"  # what it is linked with are the same objects
    run("ninja", "-C", build, main)
    run("c++", build / main, core_alone / "libbspline_curve_core.a", "-pthread", "-o", build / "consumer")
    check_consumer(build)


def test_as_a_subdirectory_it_installs_nothing_unasked(tmp_path):
    write_consumer(tmp_path / "consumer", f"add_subdirectory({ROOT} library)")
    configure(tmp_path / "consumer", tmp_path / "build")
    assert not (tmp_path / "build" / "library" / "bspline_curve-config.cmake").exists()


def test_the_core_is_built_with_eigen_alone(core_alone):
    assert (core_alone / "bspline_curve-config.cmake").exists()
    assert [path.name for path in core_alone.rglob("*.a")] == ["libbspline_curve_core.a"]


def test_an_installed_core_is_found_and_runs_the_example_of_the_readme(prefix, tmp_path):
    write_consumer(tmp_path / "consumer", "find_package(bspline_curve 0.1 REQUIRED COMPONENTS core)")
    build_and_run(tmp_path / "consumer", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")


def test_an_installation_holds_the_library_and_public_headers_alone(prefix):
    files = sorted(path.relative_to(prefix) for path in prefix.rglob("*") if path.is_file())
    headers = [path.name for path in files if path.parts[:2] == ("include", "bspline_curve")]
    assert headers == sorted([*(name for name in HEADERS if name != "field.h"), "version.h"])
    assert [path.name for path in files if path.suffix == ".a"] == ["libbspline_curve_core.a"]
    assert {path.suffix for path in files} == {".a", ".h", ".cmake"}
    package = "".join((prefix / path).read_text() for path in files if path.suffix == ".cmake")
    assert str(ROOT) not in package


def test_a_component_that_was_not_built_is_refused(prefix, tmp_path):
    write_consumer(tmp_path / "consumer", "find_package(bspline_curve REQUIRED COMPONENTS core field)")
    with pytest.raises(AssertionError, match="without the component field"):
        configure(tmp_path / "consumer", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")


def test_fields_are_a_component_of_a_build_that_has_them(tmp_path, build_folder):
    run("cmake", "--install", build_folder, "--prefix", tmp_path / "prefix", "--component", "library")
    consumer = tmp_path / "consumer"
    write_consumer(consumer, "find_package(bspline_curve REQUIRED COMPONENTS core field)", ["field.h"])
    program = (consumer / "main.cpp").read_text()
    (consumer / "main.cpp").write_text("#include <bspline_curve/field.h>\n" + program.replace("    std::printf", """
    bspline_curve::FieldOptions kind;
    kind.kind = bspline_curve::FieldKind::BoundaryDistance;
    if (bspline_curve::makeField(designer.mesh(), kind).values().size() != vertices.size()) return 6;
    std::printf"""))
    with (consumer / "CMakeLists.txt").open("a") as lists:
        lists.write("target_link_libraries(consumer PRIVATE bspline_curve::field)\n")
    build_and_run(consumer, tmp_path / "build", f"-DCMAKE_PREFIX_PATH={tmp_path / 'prefix'}")


def test_what_the_fuzzer_is_linked_with_is_built(tmp_path):
    """Configured as scripts/fuzz does, but for the compiler: CMake then knows every library by its target."""
    run("cmake", "--preset", "fuzz", "-S", ROOT, "-B", tmp_path, "-DCMAKE_CXX_COMPILER=c++", "-DCMAKE_CXX_FLAGS=")
    targets = run("ninja", "-C", tmp_path, "-t", "inputs", "fuzz")
    for library in ("bspline_curve_io", "bspline_curve_cli", "test_support"):
        assert f"lib{library}.a" in targets
