# SPDX-License-Identifier: GPL-3.0-or-later
"""No test reads or writes the cache of whoever runs it."""

import pytest


@pytest.fixture(scope="session", autouse=True)
def no_cache():
    """Shells are kept nowhere, unless a test asks for `cache`."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BSPLINE_CURVE_CACHE", "")
        yield


@pytest.fixture
def cache(no_cache, monkeypatch, tmp_path_factory):
    """A cache of the test's own, not there yet; the path of its folder of shells."""
    folder = tmp_path_factory.mktemp("cache") / "of the test"
    monkeypatch.setenv("BSPLINE_CURVE_CACHE", str(folder))
    return folder / "shells"
