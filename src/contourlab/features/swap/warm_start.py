"""Controller files as additional starts of every search (``--from``)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.swap.search import WarmStart
from contourlab.features.swap.variants import Variant, Variants
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.study import DesignVariable

if TYPE_CHECKING:
    from contourlab.loop import Controller

ROUNDING = 1e-9
"""Tolerance of a bound, relative to its size: a written value may lie beyond it by rounding."""


@dataclass(frozen=True)
class WarmStarts:
    """Designs from files.

    Attributes
    ----------
    designs : tuple of WarmStart
    files : tuple of str
    findings : tuple of Finding
        Values in the files that are not used.
    """

    designs: tuple[WarmStart, ...] = ()
    files: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()


def warm_starts(variants: Variants, texts: Sequence[str], plugins: Sequence[str | Path] = ()) -> WarmStarts:
    """Read designs from which searches start.

    Parameters
    ----------
    variants : Variants
    texts : sequence of str
        Each text is one file for all variants, or one file per variant, separated by commas, in the order of the variants.
    plugins : sequence of str or Path
        Python files with further components.

    Raises
    ------
    ScenarioError, ParameterError
        If a file is wrong, the number of files does not match, or a searched parameter is missing or outside its bounds.
    """
    designs: list[WarmStart] = []
    names: list[str] = []
    findings: list[Finding] = []
    for text in texts:
        files, n = [word.strip() for word in text.split(",")], len(variants)
        if len(files) not in (1, n) or not all(files):
            wanted = f"one file for all variants, or {n} files separated by commas, for {'; '.join(variants.names)}"
            raise ParameterError("--from", repr(text), wanted)
        values = []
        # Read a common file for each variant: units may depend on its machine.
        for variant, file in zip(variants, files * (n if len(files) == 1 else 1), strict=True):
            controller = _loaded(file, variant, plugins)
            values.append(_values(variants, variant, file, controller))
            findings += _not_taken(variants, variant, file, controller)
        designs.append(tuple(values))
        names += files
    return WarmStarts(tuple(designs), tuple(names), tuple(one for k, one in enumerate(findings) if one not in findings[:k]))


def _loaded(file: str, variant: Variant, plugins: Sequence[str | Path]) -> Controller:
    """Read a controller of a variant; map a single unknown axis name to the swapped axis if that is the only one missing."""
    from contourlab.scenario.load import controller_axes, load_controller

    names, there = variant.machine.axis_names, controller_axes(file, plugins)
    missing, other = [name for name in names if name not in there], [name for name in there if name not in names]
    swapped = {axis for axis, _ in variant.modules}
    called = {missing[0]: other[0]} if len(missing) == len(other) == 1 and missing[0] in swapped else {}
    try:
        return load_controller(file, variant.machine, plugins, called=called)
    except ScenarioError as error:
        error.add_note(f"This file is the --from controller of {variant.name}.")
        raise


def _values(variants: Variants, variant: Variant, file: str, controller: Controller) -> dict[str, float]:
    """Return the values of the searched parameters."""
    there = parameters_of(variant.machine, controller)
    missing = [number.short for number in variants.space.numbers if number.name not in there]
    if missing:
        raise ParameterError("--from", file, f"a controller with all searched parameters; it has no {', '.join(missing)}")
    values = {number.name: float(getattr(*there[number.name])) for number in variants.space.numbers}
    beyond = [number for number in variants.space.numbers if not _within(number, values[number.name])]
    if beyond:
        faults = "; ".join(_fault(number, values[number.name]) for number in beyond)
        raise ParameterError("--from", file, f"within the bounds of the search: {faults}; {_remedy(beyond, values)}")
    return values


def _within(number: DesignVariable, value: float) -> bool:
    slack = ROUNDING * max(abs(number.low), abs(number.high))
    return number.low - slack <= value <= number.high + slack


def _fault(number: DesignVariable, value: float) -> str:
    shown, low, high = (f"{number.display_value(one):.4g}" for one in (value, number.low, number.high))
    return f"{number.short} is {shown}, its bounds are {low} to {high} {number.display_unit}".rstrip()


def _remedy(beyond: Sequence[DesignVariable], values: dict[str, float]) -> str:
    ratios = [values[number.name] / number.value if number.value else math.inf for number in beyond]
    bounds = "widen them with --parameter NAME=LOW..HIGH"
    if not all(math.isfinite(ratio) and ratio > 0.0 for ratio in ratios):
        return bounds
    width = math.ceil(10.0 * max(max(ratio, 1.0 / ratio) for ratio in ratios)) / 10.0
    return f"widen all default bounds with --width {width:g}, or {bounds}"


def _not_taken(variants: Variants, variant: Variant, file: str, controller: Controller) -> list[Finding]:
    """Report the parameters that differ from the scenario's and are not searched."""
    there, here = (parameters_of(variant.machine, of) for of in (controller, variants.setting.controller))
    kept = [name for name in here if name.startswith("controller.") and name not in variants.space.names]
    differ = [name for name in kept if name not in there or getattr(*there[name]) != getattr(*here[name])]
    differ += [name for name in there if name not in here]
    names = [name.removeprefix("controller.").removeprefix("axes.") for name in differ]
    more = [f"{len(names) - 4} more"] if len(names) > 4 else []
    return [finding("CL715", file, names=[*names[:4], *more])] if names else []
