"""``contourlab swap``: from a scenario and other axes to a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.results import staged
from contourlab.app.kept_notes import kept_notes, taken_up_again
from contourlab.app.stages import Stages, shown
from contourlab.design import Space
from contourlab.design.guards import Bounds
from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.link.command import USUAL_LONGEST, Asked, LinkOptions, read_options
from contourlab.features.run.command import RunOutcome, check_plots
from contourlab.features.swap.coverage import coverage
from contourlab.features.swap.files import written
from contourlab.features.swap.final import final
from contourlab.features.swap.fleet import OBJECTIVES, Fleet
from contourlab.features.swap.kept_searches import KEPT, kept_searches
from contourlab.features.swap.known import known_designs
from contourlab.features.swap.linear import METHODS, linear_swap
from contourlab.features.swap.network import NetworkCost, least_division, network_cost
from contourlab.features.swap.report import WORDS, SwapReport
from contourlab.features.swap.settings import SwapSettings
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import variants_of
from contourlab.scenario.quantities import read_number

if TYPE_CHECKING:
    from contourlab.loop import Axis, Controller, Machine
    from contourlab.scenario import Case

PLACES = 8
"""Points of a region at which J* is searched."""


@dataclass(frozen=True)
class SwapOptions:
    """What is asked of a study; quantities as typed.

    Attributes
    ----------
    objective, floor
        Figure that is made small, and J_tol with its unit; by default that of `contourlab.features.swap.fleet.OBJECTIVES`.
    parameters, width
        As of `contourlab.design.Space.chosen`.
    local : sequence of str
        Names, with commas between those of one set, of local numbers to look at in place of searching for a set.
    gain_margin, phase_margin
        In dB and degrees.
    region : sequence of str
        Numbers of the machine with bounds.
    tolerance : str, optional
        J that is good enough in the region.
    places : int, optional
        Points of the region at which J* is searched, by default `PLACES`.
    origins : sequence of str
        Controllers that every search starts from as well, as of `contourlab.features.swap.known.known_designs`.
    linear : sequence of str
        Methods of linear design to report, of `contourlab.features.swap.linear.METHODS`.
    network : LinkOptions
        What is asked of the network between base and axes; without a division the one with the least in the axis that has all that is
        local. Its quantities, axes, figure and tolerance are not looked at.
    """

    objective: str = "contour_error_integral"
    floor: str | None = None
    parameters: tuple[str, ...] = ()
    width: float = 4.0
    local: tuple[str, ...] = ()
    exhaustive: bool = False
    budget: int = 8000
    seed: int = 0
    threads: int | None = None
    gain_margin: float = 6.0
    phase_margin: float = 30.0
    region: tuple[str, ...] = ()
    tolerance: str | None = None
    places: int | None = None
    origins: tuple[str, ...] = ()
    linear: tuple[str, ...] = ()
    network: LinkOptions = field(default_factory=LinkOptions)
    plugins: tuple[str | Path, ...] = field(default=())


@dataclass(frozen=True)
class _Prepared:
    """A study, all of it checked, before anything runs; coverage asks for a region, and for J that is good enough there or none."""

    fleet: Fleet
    candidates: tuple[str, ...]
    settings: SwapSettings
    region: Space | None
    tolerance: float | None
    notes: tuple[str, ...]
    inputs: tuple[str | Path, ...]


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
    """Say whether one controller holds when axes are swapped, and which numbers would have to move with them.

    Parameters
    ----------
    file : str or Path
        A scenario.
    swaps : sequence of (str, sequence of str)
        Axis, and the files of the axes that take its place.
    out : str or Path
        Folder of ``swap.json``, of controllers, and of the picture. Searches are kept in its folder ``searches``: those that are there from
        an earlier time are not made again, and after an interrupt the same study goes on.
    options : SwapOptions
    scheme : str, optional
        Of the scenario; by default its base.
    plots : sequence of str
        Formats of the picture.
    progress : bool

    Raises
    ------
    ScenarioError, ParameterError
        If a file or an option is wrong; before anything runs.
    """
    check_plots(plots)
    ready = _prepared(file, swaps, options, scheme)
    fleet, settings = ready.fleet, ready.settings
    asked = read_options(options.network)
    period = fleet.variants[0].machine.servo_period
    if asked.longest < period:
        raise ParameterError("--longest", options.network.longest or USUAL_LONGEST, f"the servo period, {period * 1e3:g} ms, or longer")
    with taken_up_again(Path(out) / KEPT, "searches"), shown(progress) as stages, staged(out, "swap.json", inputs=ready.inputs) as folder:
        kept = kept_searches(Path(out) / KEPT, fleet, ready.candidates, settings)
        study = swap_study(fleet, ready.candidates, settings, _told(stages, fleet), kept)
        over = None
        if ready.region is not None:
            stages.begin("coverage of the region")
            point, few = study.base.design.points[0], max(options.budget // 4, 200)
            over = coverage(
                fleet, point, ready.region, full=settings.full, tolerance=ready.tolerance, places=options.places or PLACES, budget=few
            )
        stages.begin("linear designs")
        swapped = [name for name, _ in swaps] if options.linear else []
        linear = tuple(found for name in swapped for found in linear_swap(fleet.variants, fleet.controller, name, options.linear))
        stages.begin("exact margins")
        ended = final(fleet, (study.recommended or study.base).design.points)
        networks = _networks(study, options.network, asked, stages)
        stages.begin("writing")
        told = kept_notes(kept, kept.found, "searches", "search", "scenario, axis, options or version of contourlab")
        report = SwapReport(study, ended, networks, over, linear, options.origins, (*ready.notes, *told))
        return written(report, folder, Path(out), plots)


def _networks(study: SwapStudy, options: LinkOptions, asked: Asked, stages: Stages) -> tuple[NetworkCost, ...]:
    """Return what a network costs the recommended design, or where none is, the shared one; nothing where that holds no guards."""
    choice = study.recommended or study.base
    if not choice.design.holds:
        return ()
    local, found = choice.design.local, []
    given = {"within": asked.within, "longest": asked.longest, "seeds": asked.seeds, "told": stages.advance}
    for division in asked.divisions if options.divisions else (_own_division(study.fleet.controller) or least_division(local),):
        for ways in asked.ways:
            stages.begin(f"network: {division} in the axis, messages {WORDS[ways]}")
            found.append(network_cost(study.fleet, choice.design.points, local, division, ways, asked.network, **given))  # type: ignore[arg-type]
    return tuple(found)


def _own_division(controller: Controller) -> str | None:
    return next((mine.link.division for mine in controller.axes.values() if mine.link is not None), None)


def _prepared(file: str | Path, swaps: Sequence[tuple[str, Sequence[str]]], options: SwapOptions, scheme: str | None) -> _Prepared:
    """Return all that is checked before anything runs."""
    from contourlab.scenario import load_scenario

    _check_search(options)
    scenario = load_scenario(file, plugins=options.plugins)
    case: Case = scenario.case(scheme) if scheme is not None else scenario.base
    machine, controller = case.machine, case.controller
    for name, _ in swaps:
        if name not in machine.axis_names:
            raise ParameterError("--axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    loaded, left_out = _modules(machine, swaps, options.plugins)
    variants = variants_of(machine, loaded)
    unit, default = OBJECTIVES.get(options.objective, ("", 0.0))
    if not unit:
        raise ParameterError("--objective", repr(options.objective), "one of " + ", ".join(OBJECTIVES))
    fleet = Fleet(
        variants,
        controller,
        case.reference(),
        Space.chosen(machine, controller, options.parameters, options.width),
        objective=options.objective,
        floor=_quantity("--floor", options.floor, unit, default),
        bounds=Bounds(options.gain_margin, options.phase_margin),
        moving=case.moving,
        seed=case.seed,
        threads=options.threads,
    )
    candidates = tuple(name for name in fleet.space.names if variants[0].module(name) and _may_move(controller, name))
    local, origins = _local_sets(fleet, candidates, options.local), known_designs(fleet, options.origins, options.plugins)
    settings = SwapSettings(options.budget, options.seed, exhaustive=options.exhaustive, local=local, known=origins.known)
    region = None
    if options.region:
        region = Space.chosen(machine, controller, options.region, options.width, called="--region", machine_only=True)
    tolerance = None if options.tolerance is None else _quantity("--tolerance", options.tolerance, unit, 0.0)
    _methods(options.linear)
    inputs: tuple[str | Path, ...] = (*scenario.inputs, *(other for _, others in swaps for other in others), *origins.files)
    return _Prepared(fleet, candidates, settings, region, tolerance, (*left_out, *origins.notes), inputs)


def _may_move(controller: Controller, name: str) -> bool:
    """Tell whether a number may be local: a scenario that divides its controllers itself leaves some in the base."""
    _, _, axis, slot, *_ = name.split(".")
    link = controller.axes[axis].link
    return link is None or link.is_local(slot)


def _check_search(options: SwapOptions) -> None:
    if options.budget < 100:
        raise ParameterError("--budget", str(options.budget), "100 or more candidates a search")
    if options.seed < 0:
        raise ParameterError("--seed", str(options.seed), "0 or more")
    if options.threads is not None and options.threads < 1:
        raise ParameterError("--threads", str(options.threads), "1 or more")
    if options.places is not None and (options.places < 1 or options.places & (options.places - 1)):
        raise ParameterError("--places", str(options.places), "a power of 2")
    _refuse_idle(options)


def _refuse_idle(options: SwapOptions) -> None:
    """Refuse options of which nothing would come."""
    if options.exhaustive and options.local:
        raise ParameterError("--exhaustive", "given beside --local", "one of the two: all sets by size, or those that are named")
    if options.tolerance is not None and not options.region:
        raise ParameterError("--tolerance", options.tolerance, "given with --region: it is the J that is good enough there")
    if options.places is not None and not options.region:
        raise ParameterError("--places", str(options.places), "given with --region, of which they are points")
    if options.places is not None and options.tolerance is not None:
        wanted = "left out with --tolerance, or that without it: J* is searched nowhere where J itself is judged"
        raise ParameterError("--places", f"{options.places} beside --tolerance", wanted)


def _methods(methods: Sequence[str]) -> None:
    for method in methods:
        if method not in METHODS:
            raise ParameterError("--linear", repr(method), "one of " + ", ".join(METHODS))


def _modules(
    machine: Machine, swaps: Sequence[tuple[str, Sequence[str]]], plugins: Sequence[str | Path]
) -> tuple[dict[str, list[tuple[str, Axis]]], list[str]]:
    """Return the modules that may come to each axis, by what they are called, and what their files leave out."""
    loaded: dict[str, list[tuple[str, Axis]]] = {}
    notes = []
    for name, others in swaps:
        for other in others:
            module, left_out = _module(other, machine.axis(name), plugins)
            loaded.setdefault(name, []).append((_called(other), module))
            if left_out:
                notes.append(f"{name} = {_called(other)}: its file leaves out {left_out}")
    return loaded, notes


def _module(file: str, place: Axis, plugins: Sequence[str | Path]) -> tuple[Axis, str]:
    from contourlab.scenario.load import load_module

    if not file.strip():
        raise ParameterError("--with", repr(file), "names of axis files, with commas between")
    try:
        return load_module(file, place, plugins)
    except ScenarioError as error:
        error.add_note(f"In the axis that is to take the place of {place.name}.")
        raise


def _called(file: str) -> str:
    return Path(file.rpartition(":")[2]).stem


def _quantity(option: str, text: str | None, unit: str, default: float) -> float:
    if text is None:
        return default
    example = "2 um*s" if "s" in unit else "2 um"
    try:
        value = read_number(text, unit, "")
    except Exception as error:
        raise ParameterError(option, repr(text), f'a quantity, such as "{example}"') from error
    if not (math.isfinite(value) and value > 0.0):
        raise ParameterError(option, repr(text), f'above 0, such as "{example}"')
    return value


def _local_sets(fleet: Fleet, candidates: Sequence[str], texts: Sequence[str]) -> tuple[frozenset[str], ...] | None:
    """Return the sets of local numbers that were asked for."""
    if not texts:
        return None
    short = {number.name: number.short for number in fleet.space.numbers if number.name in candidates}
    found = []
    for text in texts:
        chosen: set[str] = set()
        for word in (each.strip() for each in text.split(",")):
            fits = [name for name, called in short.items() if word and (word in (name, called) or called.endswith(f".{word}"))]
            if not fits:
                raise ParameterError("--local", repr(word), "a number of a swapped axis: " + ", ".join(short.values()))
            chosen.update(fits)
        found.append(frozenset(chosen))
    return tuple(found)


def _told(stages: Stages, fleet: Fleet) -> Callable[[str, int], None]:
    """Return what shows a stage, and how far it is in candidates."""
    at = {"tried": 0, "of": 0}

    def begin(words: str, most: int) -> None:
        at["tried"], at["of"] = fleet.tried, most
        stages.begin(words)

    fleet.progress = lambda tried: stages.advance(min(tried - at["tried"], at["of"]), at["of"])
    return begin
