# SPDX-License-Identifier: GPL-3.0-or-later
"""No test reads or writes the cache of whoever runs it."""

import os
from pathlib import Path

import pytest

BUILD = Path(os.environ.get("BSPLINE_CURVE_BUILD", Path(__file__).resolve().parents[1] / "build" / "release"))


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """With --dist loadgroup a file stays with one worker, and so do those of tests/package, which share what they install."""
    for item in items:
        shared = item.path.parent if item.path.parent.name == "package" else item.path
        item.add_marker(pytest.mark.xdist_group(str(shared.relative_to(Path(__file__).parent))))


@pytest.fixture(scope="session", autouse=True)
def no_cache():
    """Shells are kept nowhere, unless a test asks for `cache`."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BSPLINE_CURVE_CACHE", "")
        yield


@pytest.fixture(scope="session")
def build_folder():
    return BUILD


@pytest.fixture(scope="session")
def program():
    path = Path(os.environ.get("BSPLINE_CURVE_PROGRAM", BUILD / "bin" / "bspline_curve"))
    assert path.is_file(), f"no program at {path}; build it, or set BSPLINE_CURVE_PROGRAM"
    return path


@pytest.fixture(scope="session")
def bunny_path():
    import pymeshlab

    return Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"


@pytest.fixture(scope="session")
def plugin_path():
    return BUILD / "plugins" / "libfilter_bspline_curve.so"


@pytest.fixture(scope="session")
def loaded_plugin(plugin_path):
    """Loads the plugin into pymeshlab, once: it takes no plugin twice."""
    import pymeshlab

    assert plugin_path.is_file(), f"{plugin_path} is not there: build it, or set BSPLINE_CURVE_BUILD"
    pymeshlab.load_plugin(str(plugin_path))
    return plugin_path


@pytest.fixture
def cache(no_cache, monkeypatch, tmp_path_factory):
    """A cache of the test's own, not there yet; the path of its folder of shells."""
    folder = tmp_path_factory.mktemp("cache") / "of the test"
    monkeypatch.setenv("BSPLINE_CURVE_CACHE", str(folder))
    return folder / "shells"
