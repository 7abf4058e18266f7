# SPDX-License-Identifier: GPL-3.0-or-later
"""The hot paths take as many instructions as before, and the script that says so tells where they do not."""
import json

import pytest

PATH = "foot_point"


@pytest.fixture(scope="module")
def counted(hot_paths, tmp_path_factory):
    """Counts of one path, made here."""
    import count_instructions

    kept = tmp_path_factory.mktemp("counts") / "instructions.json"
    kept.write_text(json.dumps(count_instructions.count_all(hot_paths, [PATH], 1)))
    return kept


@pytest.fixture
def changed(counted, tmp_path):
    """A copy of the counts, after a change."""

    def call(change):
        results = json.loads(counted.read_text())
        change(results)
        (tmp_path / "kept.json").write_text(json.dumps(results))
        return tmp_path / "kept.json"

    return call


def test_the_hot_paths_take_as_many_instructions_as_those_kept(script, hot_paths):
    done = script("count_instructions.py", "--check", "--program", hot_paths)
    print(done.stdout)
    assert done.returncode == 0, done.stdout + done.stderr


def test_two_runs_count_the_same(script, hot_paths, counted):
    done = script("count_instructions.py", "--check", "--program", hot_paths, "--kept", counted, "--names", PATH)
    assert done.returncode == 0 and "before" not in done.stdout, done.stdout + done.stderr


@pytest.mark.parametrize("factor", [0.9, 1.1])
def test_a_path_that_takes_more_or_fewer_is_named_with_both_counts(script, hot_paths, changed, factor):
    def scale(results):
        results["paths"][PATH]["instructions"] = round(factor * results["paths"][PATH]["instructions"])

    kept = changed(scale)
    done = script("count_instructions.py", "--check", "--program", hot_paths, "--kept", kept, "--names", PATH)
    before = json.loads(kept.read_text())["paths"][PATH]["instructions"]
    assert done.returncode == 1 and f"{PATH}: {before:,} instructions before" in done.stdout, done.stdout + done.stderr


def test_a_path_that_was_never_counted_is_named(script, hot_paths, changed):
    kept = changed(lambda results: results["paths"].clear())
    done = script("count_instructions.py", "--check", "--program", hot_paths, "--kept", kept, "--names", PATH)
    assert done.returncode == 1 and f"{PATH}: not in" in done.stdout, done.stdout + done.stderr


def test_counts_of_another_compiler_are_not_compared(script, hot_paths, changed):
    def rename(results):
        results["build"]["compiler"] = "Other 1.0"
        results["paths"][PATH]["instructions"] = 1

    done = script("count_instructions.py", "--check", "--program", hot_paths, "--kept", changed(rename), "--names", PATH)
    assert done.returncode == 0 and "not compared" in done.stdout and "Other 1.0" in done.stdout, done.stdout + done.stderr


def test_functions_are_named_without_arguments_and_templates():
    import count_instructions

    names = {
        "bspline_curve::FibreProjector::move(Eigen::Matrix<double, 3, 1, 0, 3, 1> const&, bspline_curve::FootPoint&) const":
            "FibreProjector::move",
        "int bspline_curve::traceCurve<bspline_curve::f(int)::{lambda(int)#1}>(bspline_curve::TracedShell const&)": "traceCurve",
        "bspline_curve::(anonymous namespace)::Fit::operator()(double) const": "Fit::call",
        "void bspline_curve::Grid<4>::visit(int) const::{lambda(int, int)#2}::operator()(int, int) const": "Grid::visit::call",
        "operator new(unsigned long)": "operator new",
        "malloc": "malloc",
    }
    assert {name: count_instructions.short_name(name) for name in names} == names
