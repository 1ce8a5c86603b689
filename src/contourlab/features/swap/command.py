"""``contourlab swap``: from a scenario and axis modules to a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import chain, product
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.options import positive
from contourlab.app.quick import affordable_candidates, too_slow
from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError, ScenarioError, refuse
from contourlab.features.link.sweep import FEW
from contourlab.features.run.source import Source, case_asked
from contourlab.features.swap.beyond import NetworkCost, coverage, least_division, network_cost
from contourlab.features.swap.linear import linear_swap
from contourlab.features.swap.options import Swap
from contourlab.features.swap.report import SwapResult, judged_exactly
from contourlab.features.swap.search import SwapSettings, WarmStart
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import Variant, Variants, variants_of
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages
from contourlab.study import Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable
from contourlab.study.runner import run_identity
from contourlab.study.space import ROUNDING

if TYPE_CHECKING:
    from contourlab.loop import Axis, Controller, Machine
    from contourlab.scenario import Case

SEARCHES = "searches"
"""Folder of the checkpoint, inside the folder of the results."""
LEAST = 200
"""Smallest budget of a search within the coverage."""
RUNNING = 0.5
"""Share of the time of a quick answer for runs; margins and the search itself take about as long."""
PLACES = 8
"""Points of a region at which J* is searched."""


@question(Swap)
def swap(*source: Source, settings: Swap, session: Session = QUIET) -> SwapResult:
    """Find out whether one controller holds when axes are swapped, and which parameters must move with them.

    Saved in a folder, finished searches are kept in its folder ``searches``: an interrupted study continues from there.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    SwapResult

    Raises
    ------
    ScenarioError, ParameterError
        If a file or an option is wrong; raised before anything runs.
    """
    scenario, case = case_asked(source, settings)
    machine, controller = case.machine, case.controller
    variants, tolerance, left_out = _variants(case, settings)
    candidates = tuple(name for name in variants.space.names if variants.members[0].module(name) and _may_move(controller, name))
    known, not_taken = warm_starts(variants, settings.starts, settings.plugin)
    local = _local_sets(variants, candidates, settings.local)
    search = SwapSettings(settings.budget, settings.seed, SwapSettings.full, settings.exhaustive, local, known, settings.quick)
    region = None
    if settings.region:
        region = Space.chosen(machine, controller, settings.region, settings.width, called="--region", machine_only=True)
    if settings.span < machine.servo_period:
        raise ParameterError("longest", settings.longest, f"at least the servo period, {machine.servo_period * 1e3:g} ms")
    files = chain((modules for _, modules in settings.swaps), settings.starts)
    inputs: tuple[str | Path, ...] = (*scenario.inputs, *(name for names in files for name in names))
    session.will_write(inputs, "swap.json")
    searches = session.folder / SEARCHES
    session.hold(resumable(searches, "searches"))
    stages = session.stages()
    with settings.pool.started(settings.plugin) as pool:
        if search.quick:
            stages.begin("timing a run")
            search = replace(search, budget=quick_budget(variants, search.budget))
        variants.run_in(pool)
        checkpoint = Checkpoint(searches, _identity(variants, candidates, search)) if session.saving else None
        stages.expect(_work(len(variants), len(candidates), search.quick))
        study = swap_study(variants, candidates, search, _stage(stages, variants), checkpoint)
        covered = None
        if region is not None:
            stages.begin("coverage of the region")
            budget, places = max(search.budget // 4, LEAST), settings.places or PLACES
            covered = coverage(variants, study.base.points[0], region, full=search.full, tolerance=tolerance, places=places, budget=budget)
        stages.begin("linear designs")
        swapped = settings.axis if settings.linear else ()
        linear = tuple(design for name in swapped for design in linear_swap(variants.members, controller, name, settings.linear))
        networks = _networks(study, settings, stages)
        stages.begin("exact margins")
        findings = (*left_out, *not_taken, *(checkpoint.findings("searches") if checkpoint else ()))
        return SwapResult(study, judged_exactly(study), networks, covered, linear, settings.from_, findings, inputs)


def quick_budget(variants: Variants, most: int) -> int:
    """Return the candidates of a search that fit into a quick study, rounded down to a power of 2 so that it hardly depends on the timing.

    Twice, J* of each variant and the shared design, which has twice the budget, are searched from the beginning.
    """
    space, first = variants.space, variants.runners[0]
    fits = RUNNING * affordable_candidates(first.setting, space.columns(space.start), first.figures, variants.threads)
    fits /= 2 * 3 * len(variants)
    if fits < 4 * LANES:
        raise too_slow(4 * LANES, fits)
    return min(most, 1 << int(math.log2(fits)))


def _work(variants: int, candidates: int, quick: bool) -> int | list[tuple[str, float]]:
    """Return the stages to expect; a search may need fewer. A quick study repeats its two searches."""
    if not quick:
        return 2 * variants + candidates + 4
    searches = [("each variant alone", 1.0), ("local: none", 2.0)]
    return [*searches, *searches, *([("local", 1.0 / candidates)] * candidates), ("", 0.2), ("writing", 0.2)]


def _stage(stages: Stages, variants: Variants) -> Callable[[str, int], None]:
    """Return a callback that begins a stage and shows the progress of its search."""
    before, most = 0, 0

    def begin(name: str, runs: int) -> None:
        nonlocal before, most
        before, most = variants.tried, runs
        stages.begin(name)

    variants.progress = lambda tried: stages.advance(min(tried - before, most), most)
    return begin


def _networks(study: SwapStudy, options: Swap, stages: Stages) -> tuple[NetworkCost, ...]:
    """Return the network cost of the recommended design, or of the shared one if none is recommended; empty if it breaks a guard."""
    choice, controller = study.shown, study.variants.setting.controller
    if not choice.holds:
        return ()
    own = next((axis.link.division for axis in controller.axes.values() if axis.link is not None), None)
    divisions = options.division or (own or least_division(choice.local),)
    few = FEW[0] if study.settings.quick else 0
    costs = []
    for division, ways in product(divisions, options.directions):
        stages.begin(f"network: {division} in the axis, {ways}")
        limits = {"within": options.share, "longest": options.span}
        costs.append(network_cost(choice, division, ways, options.network, **limits, few=few, progress=stages.advance))
    return tuple(costs)


# --- checks before anything runs ---------------------------------------------------------------------------------------------------------


def _identity(variants: Variants, candidates: Sequence[str], settings: SwapSettings) -> str:
    """Return a text of everything that determines the searches."""
    runs = run_identity([runner.setting for runner in variants.runners], ("analysis", "study", "features/swap"))
    local = None if settings.local is None else [sorted(names) for names in settings.local]
    known = [[sorted(values.items()) for values in design] for design in settings.known]
    names = [f"{variant.name} {variant.modules}" for variant in variants]
    search = [settings.budget, settings.seed, settings.full, settings.exhaustive, settings.quick, local, known]
    words = [variants.objective, variants.floor, variants.bounds, variants.space.numbers, candidates, *names, *search]
    return "\n".join([runs, *map(repr, words)])


def _variants(case: Case, options: Swap) -> tuple[Variants, float | None, list[Finding]]:
    """Return the variants, the largest J accepted in a region, and findings on what files of modules leave out."""
    machine = case.machine
    for name in options.axis:
        if name not in machine.axis_names:
            raise ParameterError("--axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    modules, left_out = _modules(machine, options)
    objective = goal_named(options.objective, "--objective")
    floor, tolerance = (
        None if text is None else positive(option, text, objective.quantity, f'a quantity, such as "{objective.example(2)}"')
        for option, text in (("--floor", options.floor), ("--tolerance", options.tolerance))
    )
    variants = Variants(
        variants_of(machine, modules),
        Setting.of(case),
        Space.chosen(machine, case.controller, options.parameter, options.width),
        objective=objective.name,
        floor=objective.floor if floor is None else floor,
        bounds=options.margins,
        threads=options.workers,
        gpu=options.pool.gpu,
    )
    return variants, tolerance, left_out


def _may_move(controller: Controller, name: str) -> bool:
    """Return whether a parameter may be local: the scenario's own links may leave its part in the base."""
    _, _, axis, slot, *_ = name.split(".")
    link = controller.axes[axis].link
    return link is None or link.is_local(slot)


def _modules(machine: Machine, options: Swap) -> tuple[dict[str, list[tuple[str, Axis]]], list[Finding]]:
    """Load the modules of each axis by name, and report what their files leave out."""
    from contourlab.scenario.load import load_module

    modules: dict[str, list[tuple[str, Axis]]] = {}
    findings = []
    for name, others in options.swaps:
        for file in others:
            refuse(not file.strip(), ParameterError, "--with", repr(file), "names of axis files, separated by commas")
            module, left_out = load_module(file, machine.axis(name), options.plugin)
            called = Path(file.rpartition(":")[2]).stem
            modules.setdefault(name, []).append((called, module))
            if left_out:
                findings.append(finding("CL716", f"{name} = {called}", parts=left_out))
    return modules, findings


def _local_sets(variants: Variants, candidates: Sequence[str], texts: Sequence[str]) -> tuple[frozenset[str], ...] | None:
    """Return the requested sets of local parameters; None without a request."""
    short = {number.name: number.short for number in variants.space.numbers if number.name in candidates}
    sets = []
    for text in texts:
        chosen: set[str] = set()
        for word in map(str.strip, text.split(",")):
            fits = [name for name, called in short.items() if word and (word in (name, called) or called.endswith(f".{word}"))]
            if not fits:
                raise ParameterError("--local", repr(word), "a parameter of a swapped axis: " + ", ".join(short.values()))
            chosen.update(fits)
        sets.append(frozenset(chosen))
    return tuple(sets) or None


# --- controller files as additional starts of every search (``--from``) ----------------------------------------------------------------


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
    refuse(missing, ParameterError, "--from", file, f"a controller with all searched parameters; it has no {', '.join(missing)}")
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
