#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy over source files, a unit on each core: lint.py CLANG_TIDY BUILD HEADER_FILTER FILE...

BUILD holds compile_commands.json; sources that it compiles as one are read as one. A unit that was found in order is not
read again until its text, its options or those of clang-tidy change: what counts is the preprocessed text, comments
included, since NOLINT is one. Those that are in order are remembered in ~/.cache/bspline_curve/lint. Prints what is wrong;
the last line is "PASSED FAILED", in units. Exit status 1 where something failed.
"""
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
KEPT = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "bspline_curve" / "lint"
KEPT_DAYS = 60


def preprocessing(command):
    """The compiler's command for the preprocessed text of a file, with its comments and without its path."""
    words = shlex.split(command)
    kept, skip = [], False
    for word in words:
        if skip or word in ("-c", "-MD") or Path(word).name == "ccache":
            skip = False
        elif word in ("-o", "-MT", "-MF"):
            skip = True
        else:
            kept.append(word)
    return [*kept, "-E", "-C", "-P"]


def key_of(entry, settings):
    command = preprocessing(entry["command"])
    text = subprocess.run(command, cwd=entry["directory"], capture_output=True)
    if text.returncode != 0:
        return None  # clang-tidy says why
    options = [word for word in command if not word.startswith(("-I", "/")) and word != entry["file"]]
    digest = hashlib.sha256("\0".join([settings, *options]).encode())
    digest.update(text.stdout.replace(str(ROOT).encode(), b"."))  # __FILE__
    return digest.hexdigest()


def sources_of(unit):
    """The files that a unit of CMake's unity build includes; else the file itself."""
    if Path(unit).name.startswith("unity_") and Path(unit).suffix == ".cxx":
        return re.findall(r'^#include "([^"]+)"', Path(unit).read_text(), re.M)
    return [unit]


def units_of(files, entries):
    """Units that hold all of the files, the largest first, which keeps both cores busy to the end; and files in none."""
    units, missing = [], set(files)
    for unit in entries:
        held = missing.intersection(sources_of(unit)) if Path(unit).exists() else ()
        if held:
            units.append((unit, len(held)))
            missing -= held
    return [unit for unit, _ in sorted(units, key=lambda each: -each[1])], sorted(missing)


def check(file, entry, settings, command):
    """(in order, what was said)."""
    key = key_of(entry, settings)
    if key is not None and (KEPT / key).exists():
        (KEPT / key).touch()
        return True, ""
    said = subprocess.run([*command, file], capture_output=True, text=True)
    if said.returncode == 0:
        if key is not None:
            (KEPT / key).touch()
        return True, ""
    return False, said.stdout + said.stderr


def main():
    clang_tidy, build, header_filter, *files = sys.argv[1:]
    KEPT.mkdir(parents=True, exist_ok=True)
    for old in KEPT.iterdir():
        if old.stat().st_mtime < time.time() - KEPT_DAYS * 86400:
            old.unlink(missing_ok=True)
    version = subprocess.run([clang_tidy, "--version"], capture_output=True, text=True, check=True).stdout
    rules = "".join(path.read_text() for path in sorted(ROOT.rglob(".clang-tidy")) if ".cache" not in path.parts)
    settings = version + rules + header_filter.replace(str(ROOT), ".")
    entries = {entry["file"]: entry for entry in json.loads((Path(build) / "compile_commands.json").read_text())}
    # The last two are what clang says of units and of g++'s options.
    command = [clang_tidy, "-p", build, "--quiet", "--header-filter", header_filter,
               "--checks=-bugprone-suspicious-include", "--extra-arg=-Qunused-arguments"]
    units, missing = units_of([str(ROOT / file) for file in files], entries)
    for file in missing:
        print(f"{file}: not in {build}/compile_commands.json", file=sys.stderr)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda unit: check(unit, entries[unit], settings, command), units))
    for _, said in results:
        sys.stderr.write(said)
    passed = sum(ok for ok, _ in results)
    failed = len(results) - passed + len(missing)
    print(passed, failed)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
