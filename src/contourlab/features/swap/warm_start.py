"""Controller files as additional starts of every search (``--from``)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.swap.search import WarmStart
from contourlab.features.swap.variants import Variant, Variants
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.study.space import ROUNDING

if TYPE_CHECKING:
    from contourlab.loop import Controller


def warm_starts(
    variants: Variants, starts: Sequence[Sequence[str]], plugins: Sequence[str | Path] = ()
) -> tuple[tuple[WarmStart, ...], list[Finding]]:
    """Read designs from which searches start, and report the values in the files that are not used.

    Parameters
    ----------
    variants : Variants
    starts : sequence of sequence of str
        One file for all variants, or one file per variant, in the order of the variants.
    plugins : sequence of str or Path
        Python files with further components.

    Raises
    ------
    ScenarioError, ParameterError
        If a file is wrong, the number of files does not match, or a searched parameter is missing or outside its bounds.
    """
    designs: list[WarmStart] = []
    findings: dict[str, Finding] = {}
    n = len(variants)
    for files in starts:
        if len(files) not in (1, n) or not all(files):
            wanted = f"one file for all variants, or {n} files separated by commas, for {'; '.join(variants.names)}"
            raise ParameterError("--from", repr(",".join(files)), wanted)
        values = []
        # Read a common file for each variant: units may depend on its machine.
        for variant, file in zip(variants, [*files] * (n // len(files)), strict=True):
            controller = _loaded(file, variant, plugins)
            values.append(_values(variants, variant, file, controller))
            if names := _not_taken(variants, variant, controller):
                more = [f"{len(names) - 4} more"] if len(names) > 4 else []
                one = finding("CL715", file, names=[*names[:4], *more])
                findings.setdefault(str(one), one)
        designs.append(tuple(values))
    return tuple(designs), list(findings.values())


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
    """Return the values of the searched parameters; a written value may lie beyond a bound by rounding."""
    there, numbers = parameters_of(variant.machine, controller), variants.space.numbers
    missing = [number.short for number in numbers if number.name not in there]
    if missing:
        raise ParameterError("--from", file, f"a controller with all searched parameters; it has no {', '.join(missing)}")
    values = {number.name: float(getattr(*there[number.name])) for number in numbers}
    faults, ratios = [], []
    for number in numbers:
        value, slack = values[number.name], ROUNDING * max(abs(number.low), abs(number.high))
        if not number.low - slack <= value <= number.high + slack:
            shown, low, high = (f"{number.display_value(one):.4g}" for one in (value, number.low, number.high))
            faults.append(f"{number.short} is {shown}, its bounds are {low} to {high} {number.display_unit}".rstrip())
            ratios.append(value / number.value if number.value else math.inf)
    if faults:
        remedy = "widen them with --parameter NAME=LOW..HIGH"
        if all(math.isfinite(ratio) and ratio > 0.0 for ratio in ratios):
            width = math.ceil(10.0 * max(max(ratio, 1.0 / ratio) for ratio in ratios)) / 10.0
            remedy = f"widen all default bounds with --width {width:g}, or {remedy}"
        raise ParameterError("--from", file, f"within the bounds of the search: {'; '.join(faults)}; {remedy}")
    return values


def _not_taken(variants: Variants, variant: Variant, controller: Controller) -> list[str]:
    """Return the parameters that differ from the scenario's and are not searched."""
    there, here = (parameters_of(variant.machine, of) for of in (controller, variants.setting.controller))
    kept = [name for name in here if name.startswith("controller.") and name not in variants.space.names]
    differ = [name for name in kept if name not in there or getattr(*there[name]) != getattr(*here[name])]
    differ += [name for name in there if name not in here]
    return [name.removeprefix("controller.").removeprefix("axes.") for name in differ]
