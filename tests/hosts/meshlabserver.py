# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs meshlabserver 2020.09 and reads what it prints."""
import re
from dataclasses import dataclass, field


@dataclass
class ServerRun:
    status: int
    output: str
    figures: list = field(default_factory=list)  # of each filter: the log's key=value pairs


def figures_of(line):
    """The pairs of a line of nothing but key=value; None of any other line."""
    words = line.split()
    if not words or not all(re.fullmatch(r"[a-z_]+=\S+", word) for word in words):
        return None
    return dict(word.split("=", 1) for word in words)


def run_server(display, prefix, *words, cwd=None):
    """Runs it on a display; where no -l is given, it writes no file with a log of its own."""
    done = display.run([prefix / "bin" / "meshlabserver", *words], cwd=cwd)
    lines = done.stdout.splitlines()
    return ServerRun(done.returncode, done.stdout + done.stderr, [f for f in map(figures_of, lines) if f])
