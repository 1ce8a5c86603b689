"""How thorough a study of a swap is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from contourlab.features.swap.loss import FULL

Known = tuple[Mapping[str, float], ...]
"""A design from elsewhere: values [SI] by dotted names for each variant, or once for all."""


@dataclass(frozen=True)
class SwapSettings:
    """How thorough the study is.

    Attributes
    ----------
    budget : int
        Candidates of each search; a shared one is run on all variants.
    seed : int
    full : float
        Largest swap loss that counts as full modularity.
    exhaustive : bool
        Whether all sets of local numbers are tried in the order of their size, in place of dropping one number after another.
    local : tuple of frozenset of str, or None
        Sets of local numbers to look at in place of searching for one.
    known : tuple of Known
        Designs from elsewhere that every search starts from too: for each variant its values [SI] by dotted names, or once for all; what is
        not given stays as it is.
    """

    budget: int = 8000
    seed: int = 0
    full: float = FULL
    exhaustive: bool = False
    local: tuple[frozenset[str], ...] | None = None
    known: tuple[Known, ...] = ()
