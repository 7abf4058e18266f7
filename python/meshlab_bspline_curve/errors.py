# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package raises besides ValueError and TypeError."""


class CurveError(RuntimeError):
    """The curve or field could not be made; the message is the filter's: which pick, which faces, what to do."""


class HostError(ImportError):
    """The plugin cannot be used in the pymeshlab that is installed."""
