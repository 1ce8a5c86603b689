"""``contourlab swap``: from a scenario and axis modules to a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.json_values import json_values, write_json
from contourlab.app.quick import affordable, too_slow
from contourlab.app.results import proposed, staged
from contourlab.errors import ParameterError
from contourlab.features.link.command import USUAL_LONGEST, LinkOptions, LinkSettings, positive_quantity, read_options
from contourlab.features.link.sweep import FEW
from contourlab.features.run.command import RunOutcome, check_plots, file_names
from contourlab.features.swap.beyond import NetworkCost, coverage, least_division, network_cost
from contourlab.features.swap.linear import METHODS, linear_swap
from contourlab.features.swap.report import matrices, swap_result, text_of, write_matrices
from contourlab.features.swap.search import SwapSettings
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import Variants, variants_of
from contourlab.features.swap.warm_start import WarmStarts, warm_starts
from contourlab.findings import Finding, finding
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages, shown
from contourlab.result import write_text_atomic
from contourlab.study import Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable, run_identity
from contourlab.study.executors import Executor
from contourlab.study.guards import Bounds

if TYPE_CHECKING:
    from contourlab.loop import Axis, Controller, Machine
    from contourlab.scenario import Case

SEARCHES = "searches"
"""Folder of the checkpoint, inside the folder of the results."""
LEAST = 200
"""Smallest budget of a search within the coverage."""
PLACES = 8
"""Points of a region at which J* is searched."""


@dataclass(frozen=True)
class SwapOptions:
    """Options; quantities as typed.

    Attributes
    ----------
    objective, floor
        What to minimise, and J_tol with its unit; default J_tol: see `contourlab.metrics.run_figures.GOALS`.
    parameters, width
        See `contourlab.study.Space.chosen`.
    local : sequence of str
        Sets of local parameters to test instead of searching for one; names separated by commas.
    quick : bool
        Whether to use as much of the budget as fits into a minute, and state the uncertainty.
    executor : Executor
        Of the searches.
    gain_margin, phase_margin
        In dB and degrees.
    region : sequence of str
        Parameters of the machine with bounds.
    tolerance : str, optional
        Largest acceptable J in the region.
    places : int, optional
        Points of the region at which J* is searched, by default `PLACES`.
    origins : sequence of str
        See `contourlab.features.swap.warm_start.warm_starts`.
    linear : sequence of str
        Linear design methods from `contourlab.features.swap.linear.METHODS`.
    network : LinkOptions
        The network between base and axes. Default division: the smallest that puts all local parameters into the axis.
        Its quantities, axes, figure and tolerance are not used.
    """

    objective: str = "contour_error_integral"
    floor: str | None = None
    parameters: tuple[str, ...] = ()
    width: float = 4.0
    local: tuple[str, ...] = ()
    exhaustive: bool = False
    budget: int = 8000
    quick: bool = False
    seed: int = 0
    executor: Executor = field(default_factory=Executor)
    gain_margin: float = 6.0
    phase_margin: float = 30.0
    region: tuple[str, ...] = ()
    tolerance: str | None = None
    places: int | None = None
    origins: tuple[str, ...] = ()
    linear: tuple[str, ...] = ()
    network: LinkOptions = field(default_factory=LinkOptions)
    plugins: tuple[str | Path, ...] = field(default=())


def swap_scenario(
    file: str | Path,
    swaps: Sequence[tuple[str, Sequence[str]]],
    out: str | Path,
    options: SwapOptions,
    *,
    scheme: str | None = None,
    plots: Sequence[str] = ("png",),
    progress: bool = False,
) -> RunOutcome:
    """Find out whether one controller holds when axes are swapped, and which parameters must move with them.

    Parameters
    ----------
    file : str or Path
        A scenario.
    swaps : sequence of (str, sequence of str)
        Axis, and the files of the modules that may replace it.
    out : str or Path
        Folder of ``swap.json``, controllers and picture. Its folder ``searches`` keeps finished searches: an interrupted study
        continues from there.
    options : SwapOptions
    scheme : str, optional
        Scheme of the scenario; by default its base.
    plots : sequence of str
        Formats of the picture.
    progress : bool
        Whether to show progress.

    Raises
    ------
    ScenarioError, ParameterError
        If a file or an option is wrong; raised before anything runs.
    """
    check_plots(plots)
    ready, network = _prepared(file, swaps, options, scheme), read_options(options.network)
    variants, settings = ready.variants, ready.settings
    period = variants.members[0].machine.servo_period
    if network.longest < period:
        raise ParameterError("--longest", options.network.longest or USUAL_LONGEST, f"at least the servo period, {period * 1e3:g} ms")
    searches = Path(out) / SEARCHES
    with (
        resumable(searches, "searches"),
        shown(progress) as stages,
        staged(out, "swap.json", inputs=ready.inputs) as folder,
        options.executor.started(options.plugins) as pool,
    ):
        if settings.quick:
            stages.begin("timing a run")
            settings = replace(settings, budget=_quick_budget(variants, settings.budget))
        variants.run_in(pool)
        checkpoint = Checkpoint(searches, _identity(ready, settings))
        stages.expect(_work(len(variants), len(ready.candidates), settings.quick))
        study = swap_study(variants, ready.candidates, settings, _stage(stages, variants), checkpoint)
        covered = None
        if ready.region is not None:
            stages.begin("coverage of the region")
            limits = {"full": settings.full, "tolerance": ready.tolerance, "places": options.places or PLACES}
            budget = max(settings.budget // 4, LEAST)
            covered = coverage(variants, study.base.points[0], ready.region, budget=budget, **limits)  # type: ignore[arg-type]
        stages.begin("linear designs")
        swapped, own = [name for name, _ in swaps] if options.linear else [], variants.setting.controller
        linear = tuple(design for name in swapped for design in linear_swap(variants.members, own, name, options.linear))
        networks = _networks(study, options.network, network, stages)
        stages.begin("exact margins")
        findings = (*ready.findings, *checkpoint.findings("searches"))
        result = swap_result(study, networks, covered, linear, options.origins, findings)
        stages.begin("writing")
        lines = [text_of(result), *write_results(study, folder, Path(out), plots)]
        summary = json_values(result)
        write_json(folder / "swap.json", summary)
        return RunOutcome(result.passed, summary, "\n\n".join(lines))


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


def _networks(study: SwapStudy, options: LinkOptions, settings: LinkSettings, stages: Stages) -> tuple[NetworkCost, ...]:
    """Return the network cost of the recommended design, or of the shared one if none is recommended; empty if it breaks a guard."""
    choice = study.recommended or study.base
    if not choice.holds:
        return ()
    local, controller = frozenset(choice.local), study.variants.setting.controller
    divisions = settings.divisions
    if not options.divisions:
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


def _prepared(file: str | Path, swaps: Sequence[tuple[str, Sequence[str]]], options: SwapOptions, scheme: str | None) -> _Prepared:
    from contourlab.scenario import load_scenario

    _check(options)
    scenario = load_scenario(file, plugins=options.plugins)
    case: Case = scenario.case(scheme) if scheme is not None else scenario.base
    machine, controller = case.machine, case.controller
    for name, _ in swaps:
        if name not in machine.axis_names:
            raise ParameterError("--axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    modules, left_out = _modules(machine, swaps, options.plugins)
    objective = goal_named(options.objective, "--objective")
    floor, tolerance = (
        None if text is None else positive_quantity(option, text, objective.quantity, objective.example(2))
        for option, text in (("--floor", options.floor), ("--tolerance", options.tolerance))
    )
    variants = Variants(
        variants_of(machine, modules),
        Setting.of(case),
        Space.chosen(machine, controller, options.parameters, options.width),
        objective=objective.name,
        floor=objective.floor if floor is None else floor,
        bounds=Bounds(options.gain_margin, options.phase_margin),
        threads=options.executor.workers,
        gpu=options.executor.gpu,
    )
    candidates = tuple(name for name in variants.space.names if variants.members[0].module(name) and _may_move(controller, name))
    local, starts = _local_sets(variants, candidates, options.local), warm_starts(variants, options.origins, options.plugins)
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


def _check(options: SwapOptions) -> None:
    """Refuse options that are out of range or have no effect."""
    places = options.places
    faults = [
        (options.budget < 100, "--budget", options.budget, "100 or more candidates a search"),
        (options.seed < 0, "--seed", options.seed, "0 or more"),
        (places is not None and (places < 1 or places & (places - 1)), "--places", places, "a power of 2"),
        (options.exhaustive and options.quick, "--exhaustive", "given with --quick", "left out: there are too many sets for a minute"),
        (options.exhaustive and options.local, "--exhaustive", "given with --local", "left out: it tries all sets, --local only a few"),
        (options.tolerance and not options.region, "--tolerance", options.tolerance, "given with --region: it limits J there"),
        (places is not None and not options.region, "--places", places, "given with --region: it counts points there"),
        (places is not None and options.tolerance, "--places", places, "left out with --tolerance, which needs no J*"),
        *((method not in METHODS, "--linear", repr(method), "one of " + ", ".join(METHODS)) for method in options.linear),
    ]
    for wrong, option, value, wanted in faults:
        if wrong:
            raise ParameterError(option, str(value), wanted)


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
