"""Controllers that the searches of a swap start from, by their files."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.design.numbers import Number
from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.settings import Known
from contourlab.features.swap.variants import Variant
from contourlab.loop import parameter_names

if TYPE_CHECKING:
    from contourlab.loop import Controller

ROUNDING = 1e-9
"""Part by which a number that was written on its bound may be beyond it as it is read."""


@dataclass(frozen=True)
class Origins:
    """Designs of files.

    Attributes
    ----------
    known : tuple of Known
    notes : tuple of str
        What the files have that the study does not take from them.
    files : tuple of str
        As they were named.
    """

    known: tuple[Known, ...] = ()
    notes: tuple[str, ...] = ()
    files: tuple[str, ...] = ()


def known_designs(fleet: Fleet, texts: Sequence[str], plugins: Sequence[str | Path] = ()) -> Origins:
    """Read designs that searches are to start from.

    Parameters
    ----------
    fleet : Fleet
    texts : sequence of str
        Each one file for all variants, or one for each with commas between, in the order of the variants. An axis that has another name
        there may stand for the swapped one, where it is the only one that does not fit.
    plugins : sequence of str or Path
        Python files with further components.

    Raises
    ------
    ScenarioError, ParameterError
        If a file is wrong, there are not as many as variants, a number that is searched is not in it, or beyond its bounds.
    """
    known: list[Known] = []
    notes: list[str] = []
    named: list[str] = []
    for text in texts:
        files, n = [word.strip() for word in text.split(",")], fleet.n_variant
        if len(files) not in (1, n) or not all(files):
            names = "; ".join(variant.name for variant in fleet.variants)
            raise ParameterError("--from", repr(text), f"one file for all variants, or {n} of them with commas between, for {names}")
        design = []
        # A file for all is read for each: what it says of an axis may hang on what stands there.
        for variant, file in zip(fleet.variants, files * (n if len(files) == 1 else 1), strict=True):
            made = _loaded(file, variant, plugins)
            design.append(_numbers(fleet, variant, file, made))
            notes += _left_out(fleet, variant, file, made)
        known.append(tuple(design))
        named += files
    return Origins(tuple(known), tuple(dict.fromkeys(notes)), tuple(named))


def _loaded(file: str, variant: Variant, plugins: Sequence[str | Path]) -> Controller:
    """Return a controller of a variant, an axis by another name in the place of the swapped one if need be."""
    from contourlab.scenario.load import controller_axes, load_controller

    names, there = variant.machine.axis_names, controller_axes(file, plugins)
    missing, other = [name for name in names if name not in there], [name for name in there if name not in names]
    swapped = {axis for axis, _ in variant.modules}
    called = {missing[0]: other[0]} if len(missing) == len(other) == 1 and missing[0] in swapped else {}
    try:
        return load_controller(file, variant.machine, plugins, called=called)
    except ScenarioError as error:
        error.add_note(f"As a controller to start from, for {variant.name}.")
        raise


def _numbers(fleet: Fleet, variant: Variant, file: str, made: Controller) -> dict[str, float]:
    """Return what a controller has in the way of the numbers that are searched."""
    there = parameter_names(variant.machine, made)
    missing = [number.short for number in fleet.space.numbers if number.name not in there]
    if missing:
        raise ParameterError("--from", file, f"a controller with all numbers that are searched; it has no {', '.join(missing)}")
    values = {number.name: float(getattr(*there[number.name])) for number in fleet.space.numbers}
    beyond = [number for number in fleet.space.numbers if not _within(number, values[number.name])]
    if beyond:
        said = "; ".join(_beyond(number, values[number.name]) for number in beyond)
        raise ParameterError("--from", file, f"within the bounds of the search: {said}; {_room(beyond, values)}")
    return values


def _within(number: Number, value: float) -> bool:
    slack = ROUNDING * max(abs(number.low), abs(number.high))
    return number.low - slack <= value <= number.high + slack


def _beyond(number: Number, value: float) -> str:
    low, high, shown = (f"{number.shown(each):.4g}" for each in (number.low, number.high, value))
    return f"{number.short} is {shown}, its bounds are {low} to {high} {number.written_in}".rstrip()


def _room(beyond: Sequence[Number], values: dict[str, float]) -> str:
    """Return in words what would make room."""
    ratios = [values[number.name] / number.value if number.value else math.inf for number in beyond]
    bounds = "--parameter NAME=LOW..HIGH gives wider ones"
    if not all(math.isfinite(ratio) and ratio > 0.0 for ratio in ratios):
        return bounds
    width = math.ceil(10.0 * max(max(ratio, 1.0 / ratio) for ratio in ratios)) / 10.0
    return f"--width {width:g} gives wider ones to all without bounds of their own, or {bounds}"


def _left_out(fleet: Fleet, variant: Variant, file: str, made: Controller) -> Iterator[str]:
    """Yield what a controller has otherwise than the scenario's, but for the numbers that are searched."""
    there, here = (parameter_names(variant.machine, one) for one in (made, fleet.controller))
    searched = set(fleet.space.names)
    heads = [name for name in here if name.startswith("controller.") and name not in searched]
    differ = [name for name in heads if name not in there or getattr(*there[name]) != getattr(*here[name])]
    differ += [name for name in there if name not in here]
    if differ:
        shown = ", ".join(name.removeprefix("controller.").removeprefix("axes.") for name in differ[:4])
        more = f" and {len(differ) - 4} more" if len(differ) > 4 else ""
        yield f"{file} has {shown}{more} otherwise than the scenario, whose hold: only numbers that are searched are taken from it"
