"""Which parameters of machines and controllers are refined: their names, where they begin and how far they may go."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.design.variables import DesignVariable, Space
from contourlab.errors import ParameterError
from contourlab.features.refine.log_run import LogRun
from contourlab.loop import parameter_names

SPAN = 10.0
"""Where no range is given, a parameter may become so many times smaller or larger."""


@dataclass(frozen=True)
class Sought:
    """A parameter that is refined.

    Attributes
    ----------
    number : DesignVariable
        Its dotted name, where it begins, its bounds and its unit.
    runs : tuple of int
        In which of the runs it is the one parameter.
    label : str
        The name, with the run's label ahead where it was asked for in that run alone.
    signed : bool
        Whether it may be below zero.
    """

    number: DesignVariable
    runs: tuple[int, ...]
    label: str
    signed: bool

    @property
    def name(self) -> str:
        """Dotted."""
        return self.number.name

    @property
    def scale(self) -> float:
        """Size of the parameter, what steps are measured by."""
        return max(abs(self.number.value), 0.1 * (self.number.high - self.number.low))


def seek(runs: Sequence[LogRun], wanted: Iterable[str]) -> tuple[Sought, ...]:
    """Return the parameters that are asked for, each once.

    Parameters
    ----------
    runs : sequence of LogRun
    wanted : iterable of str
        As `Space.chosen` takes them, ``NAME`` or ``NAME=LOW..HIGH``; ``LABEL:NAME`` is that of one run alone.

    Raises
    ------
    ParameterError
        If a name fits nothing, a parameter is asked for twice or differs between runs at the start, or a range is none.
    """
    found: dict[tuple[str, tuple[int, ...]], Sought] = {}
    for text in wanted:
        label, _, rest = text.rpartition(":")
        among = [i for i, run in enumerate(runs) if label in ("", run.label)]
        if not among:
            raise ParameterError("--parameter", text, f"that of a run called {', '.join(run.label for run in runs)}")
        chosen = _chosen(runs, among, rest)
        for name in dict.fromkeys(name for numbers in chosen.values() for name in numbers):
            held = tuple(i for i in among if name in chosen[i])
            if any(name == other and set(held) & set(places) for other, places in found):
                raise ParameterError("--parameter", name, "asked for once")
            found[name, held] = _sought(runs, [chosen[i][name] for i in held], held, label)
    if not found:
        raise ParameterError("--parameter", "none", "one or more, such as axes.x.plant.damping")
    return tuple(found.values())


def _chosen(runs: Sequence[LogRun], among: Sequence[int], text: str) -> dict[int, dict[str, DesignVariable]]:
    """Return for each run the numbers that a text chooses there; an error only where it chooses none in any."""
    found: dict[int, dict[str, DesignVariable]] = {}
    for i in among:
        try:
            space = Space.chosen(runs[i].machine, runs[i].controller, [text], SPAN)
        except ParameterError as error:
            if i == among[-1] and not any(found.values()):
                raise
            if not _fits_nothing(error):
                raise
            found[i] = {}
        else:
            found[i] = {number.name: number for number in space.numbers}
    return found


def _fits_nothing(error: ParameterError) -> bool:
    return error.name == "parameter"


def _sought(runs: Sequence[LogRun], numbers: Sequence[DesignVariable], held: tuple[int, ...], label: str) -> Sought:
    number = numbers[0]
    starts = sorted({one.value for one in numbers})
    if len(starts) > 1:
        told = f"begins at {' and '.join(f'{number.display_value(s):.6g}' for s in starts)} {number.display}"
        bound = f"the same in all runs, or asked for in one of them as {runs[held[0]].label}:{number.name}; it {told}"
        raise ParameterError("--parameter", number.name, bound)
    part, word = parameter_names(runs[held[0]].machine, runs[held[0]].controller)[number.name]
    if part.parameters[word].whole or not math.isfinite(number.value):
        raise ParameterError("--parameter", number.name, f"a number that can change a little; it is {number.value:g}")
    if not number.low <= number.value <= number.high:
        ends = f"{number.display_value(number.low):g}..{number.display_value(number.high):g} {number.display}".strip()
        start = f"{number.display_value(number.value):.6g} {number.display}".strip()
        raise ParameterError("--parameter", f"{number.name}={ends}", f"a range that holds where it begins, {start}")
    return Sought(number, held, f"{label}:{number.name}" if label else number.name, part.parameters[word].minimum < 0.0)


def columns_of(sought: Sequence[Sought], run: int, points: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return the columns of points (k, p) that are parameters of a run, by their names there."""
    return {one.name: points[:, j] for j, one in enumerate(sought) if run in one.runs}
