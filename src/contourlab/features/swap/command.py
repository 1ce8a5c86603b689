"""``contourlab swap``: from a scenario and axis modules to a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.quick import affordable, too_slow
from contourlab.app.results import proposed
from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError
from contourlab.features.link.command import LinkSettings, positive_quantity, read_options
from contourlab.features.link.options import Link, Network
from contourlab.features.link.sweep import FEW
from contourlab.features.run.command import file_names
from contourlab.features.run.source import Source, case_asked
from contourlab.features.swap.beyond import NetworkCost, coverage, least_division, network_cost
from contourlab.features.swap.linear import linear_swap
from contourlab.features.swap.options import Swap
from contourlab.features.swap.report import SwapResult, matrices, swap_result, write_matrices
from contourlab.features.swap.search import SwapSettings
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import Variants, variants_of
from contourlab.features.swap.warm_start import WarmStarts, warm_starts
from contourlab.findings import Finding, finding
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages
from contourlab.result import write_text_atomic
from contourlab.study import Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable
from contourlab.study.runner import run_identity

if TYPE_CHECKING:
    from contourlab.loop import Axis, Controller, Machine

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
    ready, network = _prepared(source, settings), read_options(Link(**{name: getattr(settings, name) for name in Network.PARTS}))
    variants, search = ready.variants, ready.settings
    period = variants.members[0].machine.servo_period
    if network.longest < period:
        raise ParameterError("longest", settings.longest, f"at least the servo period, {period * 1e3:g} ms")
    session.will_write(ready.inputs, "swap.json")
    searches = session.folder / SEARCHES
    session.hold(resumable(searches, "searches"))
    stages = session.stages()
    with settings.pool.started(settings.plugin) as pool:
        if search.quick:
            stages.begin("timing a run")
            search = replace(search, budget=_quick_budget(variants, search.budget))
        variants.run_in(pool)
        checkpoint = Checkpoint(searches, _identity(ready, search))
        stages.expect(_work(len(variants), len(ready.candidates), search.quick))
        study = swap_study(variants, ready.candidates, search, _stage(stages, variants), checkpoint)
        covered = None
        if ready.region is not None:
            stages.begin("coverage of the region")
            limits = {"full": search.full, "tolerance": ready.tolerance, "places": settings.places or PLACES}
            budget = max(search.budget // 4, LEAST)
            covered = coverage(variants, study.base.points[0], ready.region, budget=budget, **limits)  # type: ignore[arg-type]
        stages.begin("linear designs")
        swapped, own = settings.axis if settings.linear else (), variants.setting.controller
        linear = tuple(design for name in swapped for design in linear_swap(variants.members, own, name, settings.linear))
        networks = _networks(study, settings, network, stages)
        stages.begin("exact margins")
        findings = (*ready.findings, *checkpoint.findings("searches"))
        result = swap_result(study, networks, covered, linear, settings.from_, findings)
        return replace(result, inputs=ready.inputs, writer=write_results)


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


def _networks(study: SwapStudy, options: Swap, settings: LinkSettings, stages: Stages) -> tuple[NetworkCost, ...]:
    """Return the network cost of the recommended design, or of the shared one if none is recommended; empty if it breaks a guard."""
    choice = study.recommended or study.base
    if not choice.holds:
        return ()
    local, controller = frozenset(choice.local), study.variants.setting.controller
    divisions = settings.divisions
    if not options.division:
        own = next((axis.link.division for axis in controller.axes.values() if axis.link is not None), None)
        divisions = (own or least_division(local),)
    costs = []
    for division in divisions:
        for ways in settings.ways:
            stages.begin(f"network: {division} in the axis, {ways}")
            limits = {"within": settings.within, "longest": settings.longest, "seeds": settings.seeds, "progress": stages.advance}
            limits["few"] = FEW[0] if study.settings.quick else 0
            costs.append(network_cost(study.variants, choice.points, local, division, ways, settings.network, **limits))  # type: ignore[arg-type]
    return tuple(costs)


def write_results(study: SwapStudy, folder: Path, out: Path, plots: Sequence[str]) -> list[str]:
    """Write picture and controllers into a folder that will replace `out`; return lines that list the files."""
    from contourlab.scenario.dump import dump

    variants, best, base = study.variants, study.recommended, study.base
    lines = []
    if plots:
        write_matrices(matrices(study), study.settings.full, "Loss at a swap", folder / "plots", plots)
        lines += [f"picture: {out / 'plots' / f'swap.{name}'}" for name in plots]
    (folder / "controllers").mkdir()
    files = file_names(variants.names)

    def write(name: str, i: int, controller: Controller, title: str) -> None:
        head = f"{title}; J and the guards apply to the motion of the study."
        write_text_atomic(folder / "controllers" / f"{name}.toml", proposed(head, dump(controller, variants.members[i].machine)))

    for i, name in enumerate(variants.names):
        write(f"own-{files[name]}", i, variants.controller_at(variants.best_points[i]), f"Best of {name} alone")
        if best is not None:
            write(files[name], i, variants.controller_at(best.points[i], best.local), f"For {name}. `local` parameters move with the axis")
            lines.append(f"controller for {name}: {out / 'controllers' / f'{files[name]}.toml'}")
    others = [f"the best controller of each variant alone: {out / 'controllers' / 'own-*.toml'}"]
    if base.holds:
        write("shared", 0, variants.controller_at(base.points[0]), f"Shared by {'; '.join(variants.names)}, nothing local")
        others.append(f"the shared design, nothing local: {out / 'controllers' / 'shared.toml'}")
    return ["\n".join([*lines, *others])]


# --- checks before anything runs ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Prepared:
    """A study ready to run, with the region of its coverage."""

    variants: Variants
    candidates: tuple[str, ...]
    settings: SwapSettings
    starts: WarmStarts
    region: Space | None
    tolerance: float | None
    findings: tuple[Finding, ...]
    inputs: tuple[str | Path, ...]


def _identity(ready: _Prepared, settings: SwapSettings) -> str:
    """Return a text of everything that determines the searches."""
    variants = ready.variants
    runs = run_identity([runner.setting for runner in variants.runners], ("analysis", "study", "features/swap"))
    local = None if settings.local is None else [sorted(names) for names in settings.local]
    known = [[sorted(values.items()) for values in design] for design in settings.known]
    names = [f"{variant.name} {variant.modules}" for variant in variants]
    search = [settings.budget, settings.seed, settings.full, settings.exhaustive, settings.quick, local, known]
    words = [variants.objective, variants.floor, variants.bounds, variants.space.numbers, ready.candidates, *names, *search]
    return "\n".join([runs, *map(repr, words)])


def _prepared(source: Sequence[Source], options: Swap) -> _Prepared:
    swaps = options.swaps
    scenario, case = case_asked(source, options)
    machine, controller = case.machine, case.controller
    for name, _ in swaps:
        if name not in machine.axis_names:
            raise ParameterError("--axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    modules, left_out = _modules(machine, swaps, options.plugin)
    objective = goal_named(options.objective, "--objective")
    floor, tolerance = (
        None if text is None else positive_quantity(option, text, objective.quantity, objective.example(2))
        for option, text in (("--floor", options.floor), ("--tolerance", options.tolerance))
    )
    variants = Variants(
        variants_of(machine, modules),
        Setting.of(case),
        Space.chosen(machine, controller, options.parameter, options.width),
        objective=objective.name,
        floor=objective.floor if floor is None else floor,
        bounds=options.margins,
        threads=options.workers,
        gpu=options.pool.gpu,
    )
    candidates = tuple(name for name in variants.space.names if variants.members[0].module(name) and _may_move(controller, name))
    local, starts = _local_sets(variants, candidates, options.local), warm_starts(variants, options.from_, options.plugin)
    search = {"exhaustive": options.exhaustive, "local": local, "known": starts.designs, "quick": options.quick}
    settings = SwapSettings(options.budget, options.seed, **search)  # type: ignore[arg-type]
    region = None
    if options.region:
        region = Space.chosen(machine, controller, options.region, options.width, called="--region", machine_only=True)
    inputs: tuple[str | Path, ...] = (*scenario.inputs, *(other for _, others in swaps for other in others), *starts.files)
    return _Prepared(variants, candidates, settings, starts, region, tolerance, (*left_out, *starts.findings), inputs)


def _may_move(controller: Controller, name: str) -> bool:
    """Return whether a parameter may be local: the scenario's own links may leave its part in the base."""
    _, _, axis, slot, *_ = name.split(".")
    link = controller.axes[axis].link
    return link is None or link.is_local(slot)


def _modules(
    machine: Machine, swaps: Sequence[tuple[str, Sequence[str]]], plugins: Sequence[str | Path]
) -> tuple[dict[str, list[tuple[str, Axis]]], list[Finding]]:
    """Load the modules of each axis by name, and report what their files leave out."""
    from contourlab.scenario.load import load_module

    modules: dict[str, list[tuple[str, Axis]]] = {}
    findings = []
    for name, others in swaps:
        for file in others:
            if not file.strip():
                raise ParameterError("--with", repr(file), "names of axis files, separated by commas")
            module, left_out = load_module(file, machine.axis(name), plugins)
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
        for word in (word.strip() for word in text.split(",")):
            fits = [name for name, called in short.items() if word and (word in (name, called) or called.endswith(f".{word}"))]
            if not fits:
                raise ParameterError("--local", repr(word), "a parameter of a swapped axis: " + ", ".join(short.values()))
            chosen.update(fits)
        sets.append(frozenset(chosen))
    return tuple(sets) or None
