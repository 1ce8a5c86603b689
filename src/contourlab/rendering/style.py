"""Colours, type and scale of every picture; colour-blind readers can distinguish the colours.

References
----------
M. Okabe, K. Ito, "Color Universal Design (CUD): How to make figures and presentations that are friendly to colorblind
people", 2008.
"""

from __future__ import annotations

import math

INK = "#1d2733"
MUTED = "#5b6774"
GRID = "#e4e8ec"
REFERENCE = "#8a949e"
LIMIT = "#a33b3b"
BAND = "#0f7b5f"

_CYCLE = ("#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_ALONE = "#0072b2"
_DASHES = ("solid", "dash", "dot")


def scheme_style(index: int, count: int) -> tuple[str, str]:
    """Return colour and dash of scheme `index` of `count`: the same in every picture.

    >>> scheme_style(0, 1)
    ('#0072b2', 'solid')
    """
    if count == 1:
        return _ALONE, "solid"
    return _CYCLE[index % len(_CYCLE)], _DASHES[(index // len(_CYCLE)) % len(_DASHES)]


def round_down(value: float) -> float:
    """Return the largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).

    >>> round_down(780.0), round_down(0.04)
    (500.0, 0.02)
    """
    power = 10.0 ** math.floor(math.log10(value))
    # Allow for rounding: 0.05 / 0.01 = 5.000000000000001 and 4.999999999999999 count as 5.
    return max((step for step in (1.0, 2.0, 5.0) if step <= value / power * (1 + 1e-12)), default=1.0) * power


def magnification(extent: float, largest: float) -> float:
    """Return by how much to magnify errors so that the largest covers about a tenth of a drawing `extent` wide.

    Parameters
    ----------
    extent, largest : float [m], >= 0

    Returns
    -------
    float
        1, 2 or 5 times a power of ten, at least 1.

    >>> magnification(0.1, 12e-6)
    500.0
    """
    if not (largest > 0.0 and math.isfinite(largest) and extent > 0.0):
        return 1.0
    return max(1.0, round_down(0.1 * extent / largest))
