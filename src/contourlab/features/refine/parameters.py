"""Parameters of machines and controllers to refine: names, starts and ranges."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.refine.log_run import LogRun
from contourlab.figures import figure
from contourlab.loop import parameters_of
from contourlab.study.space import DesignVariable, Space

SPAN = 10.0
"""Factor by which a parameter without a range may become smaller or larger."""


@dataclass(frozen=True)
class Sought:
    """A parameter to refine.

    Attributes
    ----------
    variable : DesignVariable
        Its name, start, range and unit.
    runs : tuple of int
        The runs that share it.
    label : str
        The name, preceded by the label of the run if only this run has the parameter.
    signed : bool
        Whether the parameter may be below zero.
    """

    variable: DesignVariable
    runs: tuple[int, ...]
    label: str
    signed: bool

    @property
    def name(self) -> str:
        """Dotted name."""
        return self.variable.name

    @property
    def scale(self) -> float:
        """Size of the parameter, used to scale steps."""
        return max(abs(self.variable.value), 0.1 * (self.variable.high - self.variable.low))

    def shown(self, value: float, digits: int = 5) -> str:
        """Return a value [SI] in the display unit."""
        return f"{figure(self.variable.display_value(value), digits=digits)} {self.variable.display_unit}".strip()


@dataclass(frozen=True)
class RefinedParameter:
    """A refined parameter.

    Attributes
    ----------
    value, deviation, white_deviation : float [SI]
        Standard deviations for a coloured and for a white residual: nan at a bound, infinite if the logs do not determine the parameter.
        With several logs, `deviation` includes the scatter between them.
    """

    sought: Sought
    value: float
    deviation: float
    white_deviation: float
    at_bound: bool


def seek(runs: Sequence[LogRun], wanted: Iterable[str]) -> tuple[Sought, ...]:
    """Return the parameters that the texts name, each once.

    Parameters
    ----------
    wanted : iterable of str
        ``NAME`` or ``NAME=LOW..HIGH``, see `contourlab.study.Space.chosen`; ``LABEL:NAME`` selects one run.

    Raises
    ------
    ParameterError
        If a name matches nothing, a parameter is named twice or starts at different values in different runs, or a range is wrong.
    """
    sought: dict[tuple[str, tuple[int, ...]], Sought] = {}
    for text in wanted:
        label, _, rest = text.rpartition(":")
        among = [i for i, run in enumerate(runs) if label in ("", run.label)]
        if not among:
            raise ParameterError("--parameter", text, f"preceded by the label of a run: {', '.join(run.label for run in runs)}")
        chosen = _chosen(runs, among, rest)
        for name in dict.fromkeys(name for variables in chosen.values() for name in variables):
            held = tuple(i for i in among if name in chosen[i])
            if any(name == other and set(held) & set(places) for other, places in sought):
                raise ParameterError("--parameter", name, "given once")
            sought[name, held] = _sought(runs, [chosen[i][name] for i in held], held, label)
    if not sought:
        raise ParameterError("--parameter", "none", "one or more, such as axes.x.plant.damping")
    return tuple(sought.values())


def _chosen(runs: Sequence[LogRun], among: Sequence[int], text: str) -> dict[int, dict[str, DesignVariable]]:
    """Return the parameters that a text selects in each run; raise only if it selects none in any run."""
    chosen: dict[int, dict[str, DesignVariable]] = {}
    for i in among:
        try:
            space = Space.chosen(runs[i].machine, runs[i].controller, [text], SPAN)
        except ParameterError as error:
            fits_nothing = error.name == "parameter"
            if not fits_nothing or (i == among[-1] and not any(chosen.values())):
                raise
            chosen[i] = {}
        else:
            chosen[i] = {variable.name: variable for variable in space.numbers}
    return chosen


def _sought(runs: Sequence[LogRun], variables: Sequence[DesignVariable], held: tuple[int, ...], label: str) -> Sought:
    variable = variables[0]
    part, name = parameters_of(runs[held[0]].machine, runs[held[0]].controller)[variable.name]
    sought = Sought(variable, held, f"{label}:{variable.name}" if label else variable.name, part.parameters[name].minimum < 0.0)
    starts = sorted({one.value for one in variables})
    if len(starts) > 1:
        bound = f"equal in all runs, or selected in one run as {runs[held[0]].label}:{variable.name}"
        raise ParameterError("--parameter", variable.name, f"{bound}; it starts at {' and '.join(map(sought.shown, starts))}")
    if part.parameters[name].whole or not math.isfinite(variable.value):
        raise ParameterError("--parameter", variable.name, f"a continuous parameter with a finite value; it is {variable.value:g}")
    if not variable.low <= variable.value <= variable.high:
        ends = f"{sought.shown(variable.low)}..{sought.shown(variable.high)}"
        raise ParameterError("--parameter", f"{variable.name}={ends}", f"a range that includes the start, {sought.shown(variable.value)}")
    return sought


def columns_of(sought: Sequence[Sought], run: int, points: Array) -> dict[str, Array]:
    """Return the columns of points (k, p) that belong to a run, by parameter name."""
    return {parameter.name: points[:, j] for j, parameter in enumerate(sought) if run in parameter.runs}
