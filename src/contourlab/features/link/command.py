"""``contourlab link``: the cost of dividing controllers between base and axes, and the slowest network that still holds."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from contourlab.app.quick import affordable, too_slow
from contourlab.app.session import QUIET, Session, question
from contourlab.components.link.network import Network
from contourlab.errors import DivergenceError, ParameterError, UnitError
from contourlab.features.link import cost
from contourlab.features.link.cost import WAYS, DivisionCost, allowed_error, divided, division_cost
from contourlab.features.link.options import Link
from contourlab.features.link.result import LinkResult, SchemeCost
from contourlab.features.link.sweep import FEW, QUANTITIES, SEEDS, LinkSetting
from contourlab.features.run.source import Source, scenario_asked
from contourlab.findings import finding
from contourlab.loop import DIVISIONS
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages
from contourlab.study import Setting
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.feed import Reference
    from contourlab.loop import Controller
    from contourlab.scenario import Case

LONGEST = 10.0
"""Longest message period and delay of a network [s]."""
USUAL_LONGEST = "100 ms"
MOST_SEEDS = 256
"""A batch runs all seeds of 32 values at once."""


@question(Link)
def link(*source: Source, settings: Link, session: Session = QUIET) -> LinkResult:
    """Divide the controllers of a scenario's schemes, and vary the links between base and axes.

    Ctrl-C keeps the divisions that ended.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    LinkResult

    Raises
    ------
    ScenarioError, ParameterError
        If the scenario cannot be read, or an option is out of range or has no effect.
    DivergenceError
        If an undivided loop diverges.
    """
    known = read_options(settings)
    scenario = scenario_asked(source, settings)
    cases = scenario.cases()
    _refuse_idle(settings, known, cases)
    session.will_write(scenario.inputs, "summary.json")
    costs: dict[str, SchemeCost] = {}
    interrupted = False
    stages = session.stages()
    stages.expect(sum(1 + len(list(_controllers(case.controller, settings, known))) for case in cases))
    schemes_ready = (_ready(case, settings, known, stages) for case in cases)
    chosen = _chosen(list(schemes_ready), known) if settings.quick else schemes_ready
    try:
        for scheme in chosen:
            for cost_so_far in scheme.costs(known, stages):
                costs[scheme.case.name] = cost_so_far
    except KeyboardInterrupt:
        if not costs:
            raise
        interrupted = True
    left_out = [] if interrupted else [case.name for case in cases if case.name not in costs]
    findings = (finding("CL766", schemes=left_out),) if left_out else ()
    return LinkResult(scenario.name, costs, findings, len(cases) > 1, interrupted, scenario.inputs)


@dataclass(frozen=True)
class _Scheme:
    """A scheme ready to be divided; `undivided` returns its error, and `fits` batches of it fit into a quick answer."""

    case: Case
    figure: str
    undivided: Callable[[], float]
    settings: list[tuple[str, LinkSetting]]
    fits: float

    def share(self, settings: LinkSettings, few: int) -> float:
        """Return the share of the time of a quick answer that the scheme takes with some values per doubling."""
        given = (settings.quantities, settings.longest)
        return sum(replace(setting, few=few).batches(*given) for _, setting in self.settings) / self.fits

    def costs(self, settings: LinkSettings, stages: Stages) -> Iterator[SchemeCost]:
        """Yield the cost of the divisions so far, after each."""
        undivided = self.undivided()
        allowed = allowed_error(undivided, settings.within, settings.allowed)
        costs: list[DivisionCost] = []
        for label, setting in self.settings:
            stages.begin(f"{self.case.name}: {label}")
            setting.allowed = allowed
            costs.append(division_cost(setting, settings.quantities, settings.longest, stages.advance))
            yield SchemeCost(self.figure, undivided, allowed, tuple(costs))


def _ready(case: Case, options: Link, settings: LinkSettings, stages: Stages) -> _Scheme:
    stages.begin(f"planning {case.name}")
    setting, figure = Setting.of(case), goal_named(options.figure, "--figure").name

    def whole(motion: Reference = setting.reference) -> float:
        try:
            return cost.undivided_error(replace(setting, reference=motion), figure)
        except DivergenceError as error:
            error.add_note(f"Scheme {case.name!r} diverges without links. Choose other schemes with --schemes.")
            raise

    divided = [
        (label, LinkSetting(replace(setting, controller=made), figure, math.nan, settings.seeds))
        for label, made in _controllers(case.controller, options, settings)
    ]
    return _Scheme(case, figure, whole, divided, affordable(whole, setting.reference) if options.quick else math.inf)


def _chosen(schemes: Sequence[_Scheme], settings: LinkSettings) -> Iterator[_Scheme]:
    """Yield the schemes of a quick answer: all, with as many values per doubling as fit, or else those that fit with the fewest."""
    few = next((few for few in FEW if sum(scheme.share(settings, few) for scheme in schemes) <= 1.0), FEW[-1])
    spent = 0.0
    for scheme in schemes:
        share = scheme.share(settings, few)
        if spent + share <= 1.0:
            spent += share
            yield replace(scheme, settings=[(label, replace(setting, few=few)) for label, setting in scheme.settings])
    if spent == 0.0:
        raise too_slow(min(scheme.share(settings, few) for scheme in schemes), 1.0)


def _controllers(controller: Controller, options: Link, settings: LinkSettings) -> Iterator[tuple[str, Controller]]:
    if _as_it_is(controller, options):
        yield "links of the scenario", controller
        return
    for division in settings.divisions:
        for ways in settings.ways:
            made = divided(controller, division, ways, settings.network, options.axes or None)
            yield f"{division} in the axis, messages {WAYS[ways]}", made


# --- options -----------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LinkSettings:
    """The options in SI; `divisions`, `ways` and `quantities` contain all by default."""

    within: float
    allowed: float | None
    longest: float
    seeds: int
    network: Network
    divisions: tuple[str, ...]
    ways: tuple[str, ...]
    quantities: tuple[str, ...]


def read_options(options: Link) -> LinkSettings:
    """Return options in SI.

    Raises
    ------
    ParameterError
        If an option is unknown or out of range, or two options exclude each other.
    """
    judged = goal_named(options.figure, "--figure")
    _each_once("--axes", options.axes)
    seeds = SEEDS if options.seeds is None else options.seeds
    if not 1 <= seeds <= MOST_SEEDS:
        raise ParameterError("--seeds", f"{seeds}", f">= 1 and <= {MOST_SEEDS}")
    if options.tolerance is not None and options.within is not None:
        wanted = "given without --tolerance: only one of the two can limit the error"
        raise ParameterError("--within", f"{options.within} with --tolerance", wanted)
    allowed = None
    if options.tolerance is not None:
        allowed = positive_quantity("--tolerance", options.tolerance, judged.quantity, judged.example(15))
    text = USUAL_LONGEST if options.longest is None else options.longest
    longest = positive_quantity("--longest", text, "s", "100 ms")
    if longest > LONGEST:
        raise ParameterError("--longest", text, f"up to {LONGEST:g} s, the limit of a link")
    network = {name: _of_network(name, given) for name, given in options.network.items()}
    return LinkSettings(
        within=_within("10 %" if options.within is None else options.within),
        allowed=allowed,
        longest=longest,
        seeds=seeds,
        network=Network(**network, between="extrapolate" if options.extrapolate else "hold"),
        divisions=_named("--division", options.division, tuple(DIVISIONS)),
        ways=_named("--ways", options.ways, tuple(WAYS)),
        quantities=_named("--vary", tuple(name.replace("-", "_") for name in options.vary), QUANTITIES),
    )


def positive_quantity(option: str, text: str, unit: str, example: str) -> float:
    """Read a quantity above 0 [SI].

    Raises
    ------
    ParameterError
        If the text is not a quantity, or not above 0.
    """
    value = _quantity(option, text, unit, f'"{example}"')
    if not value > 0.0:
        raise ParameterError(option, text, "> 0")
    return value


def _quantity(option: str, text: str, unit: str, example: str) -> float:
    try:
        value = to_si(float(text) if not unit and re.fullmatch(r"[\d.eE+-]+", text.strip()) else text, unit)
    except (UnitError, ValueError) as error:
        raise ParameterError(option, repr(text), f"a quantity, such as {example}") from error
    if not (value >= 0.0 and math.isfinite(value)):
        raise ParameterError(option, text, ">= 0 and finite")
    return value


def _of_network(name: str, text: str) -> float:
    unit, example = ("", '"10 %" or 0.1') if name == "loss" else ("s", '"2 ms"')
    return _quantity("--" + name.replace("_", "-"), text, unit, example)


def _within(text: str) -> float:
    """Read a share; refuse a number of 1 or more without a unit, which may mean percent or a factor."""
    part = _quantity("--within", text, "", '"10 %" or 0.1')
    if part >= 1.0 and not re.search("%|percent", text):
        raise ParameterError("--within", text, f'below 1, or in %: "{part:g} %" or "{100.0 * part:g} %"')
    return part


def _named(option: str, names: tuple[str, ...], known: tuple[str, ...]) -> tuple[str, ...]:
    for name in names:
        if name not in known:
            raise ParameterError(option, repr(name), "one of " + ", ".join(each.replace("_", "-") for each in known))
    _each_once(option, tuple(name.replace("_", "-") for name in names))
    return names or known


def _each_once(option: str, names: tuple[str, ...]) -> None:
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ParameterError(option, repr(",".join(names)), f"different names: {twice} is given twice")


def _as_it_is(controller: Controller, options: Link) -> bool:
    """Return whether a controller keeps its own links."""
    return not options.division and any(axis.link is not None for axis in controller.axes.values())


def _refuse_idle(options: Link, settings: LinkSettings, cases: Sequence[Case]) -> None:
    """Refuse options that would have no effect."""
    texts = {f"--{name.replace('_', '-')}": text for name, text in options.network.items()}
    texts |= {"--ways": ",".join(options.ways), "--axes": ",".join(options.axes), "--extrapolate": "given" * options.extrapolate}
    own_links = [case for case in cases if _as_it_is(case.controller, options)]
    for case in own_links:
        for option, text in texts.items():
            if text:
                wanted = f"given with --division: without it, scheme {case.name!r} keeps its own links"
                raise ParameterError(option, repr(text), wanted)
    if options.longest is not None and settings.quantities == ("loss",):
        raise ParameterError("--longest", options.longest, "left out: --vary tests the loss only, no time")
    random = {"jitter", "loss"} & set(settings.quantities) or settings.network.jitter or settings.network.loss
    if options.seeds is not None and not random and not any(_has_chance(case.controller) for case in own_links):
        raise ParameterError("--seeds", f"{options.seeds}", "given with --jitter, --loss, or one of them in --vary: nothing else is random")


def _has_chance(controller: Controller) -> bool:
    """Return whether links of a controller have jitter or loss."""
    links = [axis.link for axis in controller.axes.values() if axis.link is not None]
    return any(part.values().get(name) for link in links for part in (link.down, link.up) if part for name in ("jitter", "loss"))
