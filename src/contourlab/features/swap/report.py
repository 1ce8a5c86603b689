"""All that a study of a swap found, and whether it holds."""

from __future__ import annotations

import math
from dataclasses import dataclass

from contourlab.features.swap.coverage import Coverage
from contourlab.features.swap.final import Final
from contourlab.features.swap.fleet import OBJECTIVES
from contourlab.features.swap.linear import LinearSwap
from contourlab.features.swap.network import NetworkCost
from contourlab.features.swap.study import SwapStudy
from contourlab.features.swap.verdict import verdict

WORDS = {"both": "both ways", "one": "one way"}
UNITS = {"m*s": "um s", "m": "um"}


@dataclass(frozen=True, eq=False)
class SwapReport:
    """What a study found.

    Attributes
    ----------
    study : SwapStudy
    final : Final
        Of the recommended design, or where none is, of the shared one.
    networks : tuple of NetworkCost
        Of the same design; none where it breaks a guard.
    over : Coverage, optional
    linear : tuple of LinearSwap
    origins : tuple of str
        Files that searches started from, as they were given.
    notes : tuple of str
        On these files, and on searches that were kept.
    """

    study: SwapStudy
    final: Final
    networks: tuple[NetworkCost, ...] = ()
    over: Coverage | None = None
    linear: tuple[LinearSwap, ...] = ()
    origins: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def unit(self) -> str:
        """What J is shown in."""
        return UNITS[OBJECTIVES[self.study.fleet.objective][0]]

    def apart(self, cost: NetworkCost) -> str:
        """Return the numbers that are local and stand in the base under a division, as people say them; empty for none."""
        short = {number.name: number.short for number in self.study.fleet.space.numbers}
        return ", ".join(short[name] for name in cost.apart)

    @property
    def passed(self) -> bool:
        """Whether a design is modular for sure, keeps its exact margins, and holds over a network in one of the ways asked for."""
        told = self.study.recommended is not None and not self.study.fell_short
        return told and self.final.holds and any(cost.holds for cost in self.networks)

    @property
    def verdict(self) -> str:
        """The verdict in words, with what the network costs."""
        words = [verdict(self.study)]
        if self.study.recommended is not None and not self.final.holds:
            words.append("but the exact margins are not kept, see below")
        if self.networks and self.study.recommended is None:
            words.append("the shared design over a network")
        words += [_network_words(cost, self.apart(cost)) for ways in WORDS for cost in self.networks if cost.ways == ways]
        return "; ".join(words)


def _network_words(cost: NetworkCost, apart: str) -> str:
    """Return in words how little network is enough, and what is local though it stands in the base."""
    aside = f" ({apart} set in the base for each axis)" if apart else ""
    how = f"with the {cost.division} in the axis{aside} and messages {WORDS[cost.ways]}"
    if not math.isfinite(cost.rate):
        return f"{how} no message rate holds on all variants"
    fewest = f"{how} {cost.rate:.4g} a second are the fewest that hold on all variants"
    if not cost.limited:
        fewest += ", and the fewest that were looked at"
    return fewest if cost.holds else f"{fewest}, but the network as given does not hold"
