# SPDX-License-Identifier: GPL-3.0-or-later
"""The quick parts of scripts/release. `scripts/test release` builds its packages and tries them in a clean Debian 12."""
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.skipif(not (ROOT / ".git").exists(), reason="this is no checkout of git")


def release(*parts):
    return subprocess.run([ROOT / "scripts" / "release", *parts], capture_output=True, text=True)


def test_the_notes_are_the_newest_part_of_the_changelog():
    done = release("notes")
    assert done.returncode == 0, done.stderr
    notes = (ROOT / "build" / "release-files" / "NOTES.md").read_text().rstrip()
    parts = (ROOT / "CHANGELOG.md").read_text().split("\n## [")
    assert notes and notes == parts[1].partition("\n")[2].strip()


def test_an_unknown_part_is_refused():
    done = release("deb", "nonsense")
    assert done.returncode == 2 and "scripts/release PART..." in done.stderr


def test_every_part_is_told():
    usage = release("--help").stderr
    for part in ("sdist", "wheels", "deb", "notes", "sums", "try"):
        assert part in usage
