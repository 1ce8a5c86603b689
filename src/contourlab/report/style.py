"""Colours and type of every picture; the colours are told apart by colour-blind readers too.

References
----------
M. Okabe, K. Ito, "Color Universal Design (CUD): How to make figures and presentations that are friendly to colorblind
people", 2008.
"""

from __future__ import annotations

INK = "#1d2733"
MUTED = "#5b6774"
GRID = "#e4e8ec"
REFERENCE = "#8a949e"
LIMIT = "#a33b3b"
BAND = "#0f7b5f"
GOOD = "#0f6b52"
POOR = "#a8321e"
FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', 'DejaVu Sans', Arial, sans-serif"

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
