# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program prints of its own options: manual pages, and completion that is tried in the shells themselves."""

import os
import pty
import re
import shutil
import subprocess

import pytest

VERBS = ("curve", "fit", "batch", "imprint", "cut", "fill", "segment", "offset", "pattern", "edit", "points", "field", "shell")
COMPLETED = [
    ("of", "offset"),
    ("cut --ke", "--keep"),
    ("segment plate.ply --sli", "--slits"),
    ("--tens", "--tension"),
    ("plate.ply --field-cost ex", "exp-minus"),
    ("plate.ply --picks pla", "plate.ply"),
]


def needs(shell):
    return pytest.mark.skipif(shutil.which(shell) is None, reason=f"{shell} is not installed")


@pytest.fixture(scope="session")
def installed(build_folder, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("installed")
    command = ["cmake", "--install", build_folder, "--component", "program", "--prefix", prefix]
    subprocess.run(command, check=True, capture_output=True)
    return prefix


@pytest.fixture
def environment(installed):
    return os.environ | {"PATH": f"{installed / 'bin'}:{os.environ['PATH']}"}


def test_the_program_is_installed_with_pages_and_completion(installed, run):
    done = subprocess.run([installed / "bin" / "bspline_curve", "--version"], capture_output=True, text=True)
    assert done.stdout == run("--version").stdout
    files = sorted(str(path.relative_to(installed / "share")) for path in (installed / "share").rglob("*") if path.is_file())
    pages = [f"man/man1/bspline_curve{end}.1" for end in ("", *(f"-{verb}" for verb in VERBS))]
    assert files == sorted([*pages, "bash-completion/completions/bspline_curve", "fish/vendor_completions.d/bspline_curve.fish",
                            "zsh/vendor-completions/_bspline_curve"])


@pytest.mark.parametrize("words, completed", COMPLETED)
def test_bash_completes(installed, environment, plate, words, completed):
    script = installed / "share/bash-completion/completions/bspline_curve"
    last, *before = [*reversed(words.split()), "bspline_curve"]
    words = [*reversed(before), last]
    code = (f"source {script}; COMP_WORDS=({' '.join(words)}); COMP_CWORD={len(words) - 1}; "
            f"_bspline_curve bspline_curve '{last}' '{before[0]}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    done = subprocess.run(["bash", "-c", code], cwd=plate, env=environment, capture_output=True, text=True)
    assert (done.stdout.split(), done.stderr) == ([completed], "")


@needs("fish")
@pytest.mark.parametrize("words, completed", COMPLETED)
def test_fish_completes(installed, environment, plate, words, completed):
    script = installed / "share/fish/vendor_completions.d/bspline_curve.fish"
    code = f"source {script}; complete -C 'bspline_curve {words}'"
    done = subprocess.run(["fish", "--no-config", "-c", code], cwd=plate, env=environment | {"HOME": str(plate)}, capture_output=True, text=True)
    assert done.stderr == "" and done.stdout.split("\t")[0].strip() == completed and done.stdout.count("\n") == 1


@needs("zsh")
@pytest.mark.parametrize("words, completed", COMPLETED)
def test_zsh_completes(installed, environment, plate, words, completed):
    """In a terminal, by the key: Ctrl-X prints what the line has become."""
    folder = installed / "share/zsh/vendor-completions"
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(plate)
        os.execvpe("zsh", ["zsh", "-f", "-i"], environment | {"TERM": "dumb", "HOME": str(plate)})
    setup = (f"fpath=({folder} $fpath); autoload -U compinit; compinit -u -D; "
             "tell() { print -r -- \"LINE=$BUFFER=END\"; BUFFER=exit; zle accept-line }; zle -N tell; bindkey '^X' tell\n")
    os.write(terminal, (setup + f"bspline_curve {words}\t\x18").encode())
    text = b""
    try:
        while block := os.read(terminal, 4096):
            text += block
    except OSError:  # the terminal closes with the shell
        pass
    os.waitpid(process, 0)
    line = re.findall(r"LINE=(.*?)=END", text.decode())
    assert line and line[-1].split()[-1] == completed, text.decode()


@pytest.mark.parametrize("verb", VERBS)
def test_completion_and_page_have_every_option_that_help_lists(run, verb):
    helped = run(verb, "--help").stdout + run(verb, "--help", "paper").stdout
    flags = {flag for line in re.findall(r"^  (-\S+)", helped, re.M) for flag in line.split(",")}
    assert len(flags) > 5
    page = run(verb, "--manual").stdout.replace("\\-", "-")
    assert flags == {flag for line in re.findall(r"^\\fB(-.*?)\\fR", page, re.M) for flag in line.split(", ")}
    bash = re.search(rf"\n    {verb}\)\n        flags='(.*?)'", run("--completion", "bash").stdout)[1]
    assert flags == set(bash.split())


@pytest.mark.skipif(shutil.which("man") is None, reason="man is not installed")
@pytest.mark.parametrize("name", ["bspline_curve", *(f"bspline_curve-{verb}" for verb in VERBS)])
def test_pages_are_formatted_without_a_warning(installed, name):
    page = installed / "share/man/man1" / f"{name}.1"
    command = ["man", "--warnings=all", "--local-file", page]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"MANWIDTH": "80", "MANPAGER": "cat"})
    assert (done.returncode, done.stderr) == (0, "")
    assert max(map(len, done.stdout.splitlines())) <= 80
    for title in ("NAME", "SYNOPSIS", "DESCRIPTION", "SEE ALSO"):
        assert f"\n{title}\n" in "\n" + done.stdout


def test_another_shell_is_refused(refused):
    refused(2, "--completion", "tcsh", says=["bash, zsh or fish"])
