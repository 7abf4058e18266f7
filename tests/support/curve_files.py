# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the program's curve files; knows none of its code."""

import json
import re

import numpy as np

def succeed(process):
    """A process that did its work and said so in one line: a pipe shows no progress."""
    assert process.returncode == 0, process.stderr
    assert process.stderr == "" and re.fullmatch(r".+: .+\n", process.stdout), process.stdout


PLY_TYPES = {"double": "<f8", "float": "<f4", "int": "<i4", "uchar": "u1"}


def read_ply(path):
    """The elements of a binary PLY without lists: name -> structured array."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii").splitlines()
    assert header[:2] == ["ply", "format binary_little_endian 1.0"]
    elements, at = {}, end
    layout = []
    for line in header[2:]:
        words = line.split()
        if words[0] == "element":
            layout.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            layout[-1][2].append((words[2], PLY_TYPES[words[1]]))
    for name, count, fields in layout:
        kind = np.dtype(fields)
        elements[name] = np.frombuffer(data, kind, count, at)
        at += count * kind.itemsize
    assert at == len(data), "bytes are left over"
    return elements


def read_curve(path):
    """points, list of edges, closed."""
    if path.suffix == ".json":
        document = json.loads(path.read_text())
        points, closed = np.array(document["polyline"]["points"]), document["closed"]
        edges = [(i, i + 1) for i in range(len(points) - 1)] + ([(len(points) - 1, 0)] if closed else [])
        return points, edges, closed
    if path.suffix == ".ply":
        elements = read_ply(path)
        points = np.stack([elements["vertex"][name] for name in "xyz"], 1)
        edges = [(int(e["vertex1"]), int(e["vertex2"])) for e in elements["edge"]]
    else:
        lines = [line.split() for line in path.read_text().splitlines()]
        points = np.array([[float(x) for x in words[1:]] for words in lines if words[0] == "v"])
        chains = [[int(i) - 1 for i in words[1:]] for words in lines if words[0] == "l"]
        edges = [edge for chain in chains for edge in zip(chain[:-1], chain[1:])]
    closed = edges[-1][1] == 0
    ends = [(i, i + 1) for i in range(len(points) - 1)] + ([(len(points) - 1, 0)] if closed else [])
    assert edges == ends, "the edges are not in order along the curve"
    return points, edges, closed
