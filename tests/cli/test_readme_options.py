# SPDX-License-Identifier: GPL-3.0-or-later
"""README's option tables and the program's help name the same options and defaults."""

import re
from pathlib import Path

import pytest

README = (Path(__file__).resolve().parents[2] / "README.md").read_text()


def helped(run, *verb):
    """Option -> default ("" where there is none), as the help has them."""
    text = run(*verb, "--help").stdout
    return dict(re.findall(r"^  (?:-h,)?(--[\w-]+)[\w,-]*(?: [^\s=]+=(\S+))?", text, re.M))


@pytest.mark.parametrize("verb, title", [("shell", "Shells"), ("field", "Fields")])
def test_the_table_of_a_verb_is_the_help(run, verb, title):
    section = re.search(rf"### {title}\n(.*?)\n##", README, re.S)[1]
    rows = re.findall(r"^\| `(--[\w-]+)`[^|]*\| ([^|]*) \|", section, re.M)
    options = helped(run, verb)
    del options["--help"]
    assert sorted(name for name, _ in rows) == sorted(options)
    for name, default in rows:
        assert default == options[name] or (options[name] == "" and default in ("none", "off")), name


def test_the_tables_of_curves_have_the_programs_defaults(run):
    section = re.search(r"\n## Options\n(.*?)\n## ", README, re.S)[1]
    options = helped(run)
    rows = re.findall(r"^\| (`\w+`[^|]*) \| ([^|]*) \|", section, re.M)
    assert len(rows) > 20
    for names, defaults in rows:
        for name, default in zip(re.findall(r"`(\w+)`", names), defaults.split(", "), strict=True):
            given = options["--" + name.replace("_", "-")]
            assert default == given or (given == "" and default in ("none", "off")), name


def test_every_option_of_curves_is_explained(run):
    names = set(helped(run)) - {"--help", "--version"}
    assert len(names) > 25
    assert [n for n in names if f"`{n}`" not in README and f"`{n[2:].replace('-', '_')}`" not in README] == []
