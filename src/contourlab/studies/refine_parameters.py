"""Which parameters of machines and controllers are refined: their names, where they begin and how far they may go."""

from __future__ import annotations

import fnmatch
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from contourlab.components.contract import Component, Parameter
from contourlab.errors import ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine, parameter_names
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.scenario.components import parameters_of
from contourlab.studies.log_run import LogRun

__all__ = ["Sought", "Wanted", "declared", "seek", "with_values"]

SPAN = 10.0
"""Where no range is given, a parameter may become so many times smaller or larger."""


@dataclass(frozen=True)
class Wanted:
    """A parameter that someone asks for.

    Attributes
    ----------
    name : str
        Dotted, as of `contourlab.loop.parameter_names`; ``*`` stands for anything between dots. ``LABEL:name`` is that of one run alone.
    low, high : float or None
        Range in SI; by default a tenth to ten times of where it begins, within what the part allows.
    """

    name: str
    low: float | None = None
    high: float | None = None


@dataclass(frozen=True)
class Sought:
    """A parameter that is refined.

    Attributes
    ----------
    name : str
        Dotted.
    runs : tuple of int
        In which of the runs it is the one parameter.
    label : str
        The name, with the run's label ahead where not all runs share it by name.
    declared : Parameter
        Unit, bounds and meaning.
    start, low, high : float
    """

    name: str
    runs: tuple[int, ...]
    label: str
    declared: Parameter
    start: float
    low: float
    high: float

    @property
    def scale(self) -> float:
        """Size of the parameter, what steps are measured by."""
        return max(abs(self.start), 0.1 * (self.high - self.low))


def seek(runs: Sequence[LogRun], wanted: Iterable[Wanted]) -> tuple[Sought, ...]:
    """Return the parameters that are asked for, each once.

    Parameters
    ----------
    runs : sequence of LogRun
    wanted : iterable of Wanted

    Raises
    ------
    ParameterError
        If a name fits nothing, a parameter is asked for twice or differs between runs at the start, or a range is none.
    """
    known = [parameter_names(run.machine, run.controller) for run in runs]
    found: dict[tuple[str, tuple[int, ...]], Sought] = {}
    for one in wanted:
        label, _, pattern = one.name.rpartition(":")
        among = [i for i, run in enumerate(runs) if label in ("", run.label)]
        if not among:
            raise ParameterError("--parameter", one.name, f"that of a run called {', '.join(run.label for run in runs)}")
        names = dict.fromkeys(name for i in among for name in known[i] if _fits(name, pattern))
        if not names:
            raise ParameterError("--parameter", one.name, f"the name of a number{_near(pattern, [n for i in among for n in known[i]])}")
        for name in names:
            held = tuple(i for i in among if name in known[i])
            if any(name == other and set(held) & set(places) for other, places in found):
                raise ParameterError("--parameter", name, "asked for once")
            found[name, held] = _sought(runs, known, name, held, label, one)
    if not found:
        raise ParameterError("--parameter", "none", "one or more, such as axes.x.plant.damping")
    return tuple(found.values())


def _fits(name: str, pattern: str) -> bool:
    parts, wanted = name.split("."), pattern.split(".")
    return len(parts) == len(wanted) and all(fnmatch.fnmatchcase(a, b) for a, b in zip(parts, wanted, strict=True))


def _near(pattern: str, names: Sequence[str]) -> str:
    import difflib

    close = difflib.get_close_matches(pattern, names, 3, 0.5)
    return f"; near to it: {', '.join(close)}" if close else f", such as {', '.join(names[:3])}"


def _sought(
    runs: Sequence[LogRun], known: Sequence[Mapping[str, tuple[Component, str]]], name: str, held: tuple[int, ...], label: str, one: Wanted
) -> Sought:
    starts = {float(known[i][name][0].values()[known[i][name][1]]) for i in held}
    if len(starts) > 1:
        told = f"begins at {' and '.join(f'{s:.6g}' for s in sorted(starts))}: put the run's label ahead, as {runs[held[0]].label}:{name}"
        raise ParameterError("--parameter", name, f"the same in all runs, or asked for in one of them; it {told}")
    start = starts.pop()
    parameter = declared(runs[held[0]].machine, *known[held[0]][name], name)
    shown = f"{label}:{name}" if label else name
    if parameter.whole or not math.isfinite(start):
        raise ParameterError("--parameter", shown, f"a number that can change a little; it is {start:g}")
    low, high = _range(shown, start, parameter, one)
    return Sought(name, held, shown, parameter, start, low, high)


def _range(shown: str, start: float, parameter: Parameter, one: Wanted) -> tuple[float, float]:
    unit = f" {parameter.unit}" if parameter.unit else ""
    if one.low is None or one.high is None:
        if start == 0.0:
            bound = f"given with a range, as '{shown}=0{unit}..1{unit}': from 0 no size is known"
            raise ParameterError("--parameter", shown, bound)
        low, high = (start / SPAN, start * SPAN) if parameter.minimum >= 0.0 else (-SPAN * abs(start), SPAN * abs(start))
        low, high = max(low, parameter.minimum), min(high, parameter.maximum)
    else:
        low, high = one.low, one.high
        for value in (low, high):
            try:
                parameter.check(value)
            except ParameterError as error:
                error.add_note(f"In the range of {shown}.")
                raise
    if not low < high:
        raise ParameterError("--parameter", f"{shown}={low:g}..{high:g}", "a range, the lower end first", parameter.unit)
    if not low <= start <= high:
        raise ParameterError(
            "--parameter", f"{shown}={low:g}..{high:g}", f"a range that holds where it begins, {start:.6g}{unit}", parameter.unit
        )
    return low, high


def declared(machine: Machine, part: Component, parameter: str, name: str) -> Parameter:
    """Return what is known of a parameter, in the units of the plant that it works with.

    Parameters
    ----------
    machine : Machine
    part : Component
    parameter : str
        Its name there.
    name : str
        Its dotted name, which tells the axis.
    """
    axes = [word for word in name.split(".") if word in machine.axis_names]
    plant = machine.axis(axes[0]).plant if axes else machine.axes[0].plant
    return parameters_of(type(part), (plant.command_unit, plant.force_unit))[parameter]


def with_values(machine: Machine, controller: Controller, values: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Return machine and controller with other numbers in their places.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    values : mapping of str to float
        By dotted names.
    """
    for name, value in values.items():
        words = name.split(".")
        if words[0] == "axes":
            machine = replace(machine, axes=tuple(_axis(a, words[2:], value) if a.name == words[1] else a for a in machine.axes))
        elif words[1] == "axes":
            mine = _axis_controller(controller.axes[words[2]], words[3:], value)
            controller = replace(controller, axes={**controller.axes, words[2]: mine})
        else:
            part = getattr(controller, words[1]).replace(**{words[2]: value})
            controller = replace(controller, **{words[1]: part})
    return machine, controller


def _axis(axis: Axis, words: Sequence[str], value: float) -> Axis:
    slot, parameter = words
    assert slot in AXIS_SLOTS  # `parameter_names` gave it
    return replace(axis, **{slot: getattr(axis, slot).replace(**{parameter: value})})


def _axis_controller(mine: AxisController, words: Sequence[str], value: float) -> AxisController:
    if words[0] == "others":
        others = tuple((label, part.replace(**{words[2]: value}) if label == words[1] else part) for label, part in mine.others)
        return replace(mine, others=others)
    return replace(mine, **{words[0]: getattr(mine, words[0]).replace(**{words[1]: value})})


def columns_of(sought: Sequence[Sought], run: int, points: np.ndarray) -> dict[str, np.ndarray]:
    """Return the columns of points (k, p) that are parameters of a run, by their names there."""
    return {one.name: points[:, j] for j, one in enumerate(sought) if run in one.runs}
