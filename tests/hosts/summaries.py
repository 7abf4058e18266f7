# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters say in a window, as numbers. Scripts have lines of key=value instead: meshlabserver.figures_of."""
import re

NUMBER = r"(-?\d[\d.]*(?:e[+-]\d+)?)"
CURVE = re.compile(
    rf"(?P<kind>Open|Closed) curve through (?P<picks>\d+) picks, (?P<length>{NUMBER}) mesh units long, (?P<usable>usable|not usable): "
    rf"its spline (?:stays within|is up to) (?P<distance>{NUMBER}) mesh units (?:of|from) the surface\."
    rf"(?: It follows the field \"(?P<field>[^\"]+)\"\.)?.* Time: {NUMBER} s(?P<kept>, on a surface that was ready)?\."
)
FIELD = re.compile(rf'Field "(?P<field>[^"]+)" at (?P<vertices>\d+) vertices: from {NUMBER} to {NUMBER}, {NUMBER} on average\.')

OFFSET = re.compile(rf"Lines at {NUMBER} mesh units from (?P<curves>\d+) curves?: (?P<pieces>\d+) pieces?, .*")


def curves_told(log):
    """Of each curve in the log: kind, picks, length, usable, distance, field, kept; all are texts or None."""
    return [found.groupdict() for found in map(CURVE.fullmatch, log) if found]


def fields_told(log):
    """Of each field in the log: least, largest, mean."""
    return [tuple(map(float, found.groups()[2:])) for found in map(FIELD.fullmatch, log) if found]


def offsets_told(log):
    """Of each offset in the log: how many curves it is of, and how many lines there are."""
    return [(int(found["curves"]), int(found["pieces"])) for found in map(OFFSET.fullmatch, log) if found]
