# SPDX-License-Identifier: GPL-3.0-or-later
"""Every public name is documented, and the examples of docstrings run as they stand there."""
import doctest
import inspect
import re

import bspline_curve
import numpy as np
import pytest
from bspline_curve import _mesh

CLASSES = [each for name in bspline_curve.__all__ if inspect.isclass(each := getattr(bspline_curve, name))]
RESULTS = [_mesh.Projection, _mesh.Shell, _mesh.Layer]
FUNCTIONS = [each for name in bspline_curve.__all__ if inspect.isfunction(each := getattr(bspline_curve, name))]
LOOK = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def members(kind):
    """Public ones, of the package: of a named tuple its fields, which need no function."""
    for name in dir(kind):
        if not name.startswith("_") and not hasattr(tuple if issubclass(kind, tuple) else Exception, name):
            yield name, inspect.getattr_static(kind, name)


def functions():
    """Each with its name."""
    yield from ((each.__name__, each) for each in FUNCTIONS)
    for kind in CLASSES:
        if kind.__init__ is not object.__init__ and not issubclass(kind, (Exception, tuple)) and kind.__init__.__doc__:
            yield f"{kind.__name__}.__init__", kind.__init__
        for name, member in members(kind):
            function = getattr(member, "__func__", member)
            if inspect.isfunction(function):
                yield f"{kind.__name__}.{name}", function


PUBLIC = dict(functions())


def documented(kind):
    """Names in the section of attributes, with a text or at least a type."""
    section = re.search(r"\nAttributes\n-+\n(.*?)(?=\n\n|\Z)", inspect.getdoc(kind) or "", re.S)
    heads = re.findall(r"(?m)^(\w[\w, ]*) : \S", section[1] if section else "")
    return {name for head in heads for name in head.split(", ")}


@pytest.mark.parametrize("kind", CLASSES + RESULTS, ids=lambda kind: kind.__name__)
def test_each_class_and_each_of_its_fields_is_documented(kind):
    assert inspect.getdoc(kind)
    fields = {name for name, member in members(kind) if not inspect.isfunction(getattr(member, "__func__", member))}
    if issubclass(kind, Exception):
        return  # theirs are told of InputError
    assert fields - documented(kind) == set()


@pytest.mark.parametrize("name", PUBLIC)
def test_each_function_is_documented_with_an_example(name):
    doc = inspect.getdoc(PUBLIC[name])
    assert doc and "\nExamples\n--------\n>>> " in doc
    parameters = [each for each in inspect.signature(PUBLIC[name]).parameters if each not in ("self", "cls")]
    missing = [each for each in parameters if not re.search(rf"\b{each}\b", doc)]
    assert not missing


@pytest.fixture(scope="module")
def names(mesh, arrays, picks):
    pyvista = pytest.importorskip("pyvista")
    pyvista.OFF_SCREEN = True
    return {
        "bspline_curve": bspline_curve, "np": np, "pyvista": pyvista, "mesh": mesh, "picks": picks,
        "curve": mesh.curve(picks), "ring": mesh.curve(arrays[0][[500, 530, 1250, 1200]], closed=True),
    }


@pytest.mark.parametrize("name", PUBLIC)
@pytest.mark.filterwarnings("ignore::bspline_curve.MeshWarning")
def test_examples_run(name, names, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    parser, said = doctest.DocTestParser(), []
    test = parser.get_doctest(inspect.getdoc(PUBLIC[name]), dict(names), name, None, None)
    assert test.examples
    result = doctest.DocTestRunner(optionflags=LOOK).run(test, out=said.append)
    assert result.failed == 0, "".join(said)
