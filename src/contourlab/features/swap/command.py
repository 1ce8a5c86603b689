"""``contourlab swap``: from a scenario and axis modules to a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import chain, product
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.quick import affordable, too_slow
from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError
from contourlab.features.link.options import quantity
from contourlab.features.link.sweep import FEW
from contourlab.features.run.source import Source, case_asked
from contourlab.features.swap.beyond import NetworkCost, coverage, least_division, network_cost
from contourlab.features.swap.linear import linear_swap
from contourlab.features.swap.options import Swap
from contourlab.features.swap.report import SwapResult, swap_result
from contourlab.features.swap.search import SwapSettings
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import Variants, variants_of
from contourlab.features.swap.warm_start import warm_starts
from contourlab.findings import Finding, finding
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages
from contourlab.study import Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable
from contourlab.study.runner import run_identity

if TYPE_CHECKING:
    from contourlab.loop import Axis, Controller, Machine
    from contourlab.scenario import Case

SEARCHES = "searches"
"""Folder of the checkpoint, inside the folder of the results."""
LEAST = 200
"""Smallest budget of a search within the coverage."""
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
            search = replace(search, budget=_quick_budget(variants, search.budget))
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
        return swap_result(study, networks, covered, linear, settings.from_, findings, inputs)


def _quick_budget(variants: Variants, most: int) -> int:
    """Return the candidates of a search that fit into a quick study, rounded down to a power of 2 so that it hardly depends on the timing.

    Twice, J* of each variant and the shared design, which has twice the budget, are searched from the beginning.
    """
    column = variants.space.columns(variants.space.start[None])
    first = variants.runners[0]
    run = lambda motion: replace(first.setting, reference=motion).batch(column, first.figures)  # noqa: E731
    batches = affordable(run, first.setting.reference, variants.threads)
    fits = batches * LANES / (2 * 3 * len(variants))
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
        None if text is None else quantity(option, text, objective.quantity, f'"{objective.example(2)}"', positive=True)
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
            if not file.strip():
                raise ParameterError("--with", repr(file), "names of axis files, separated by commas")
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
