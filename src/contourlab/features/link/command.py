"""``contourlab link``: the cost of dividing controllers between base and axes, and the slowest network that still holds."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from contourlab.app.options import positive
from contourlab.app.quick import affordable, too_slow
from contourlab.app.session import QUIET, Session, question
from contourlab.errors import DivergenceError, ParameterError
from contourlab.features.link.cost import WAYS, DivisionCost, allowed_error, divided, division_cost, undivided_error
from contourlab.features.link.options import SEEDS, Link
from contourlab.features.link.result import LinkResult, SchemeCost
from contourlab.features.link.sweep import CHUNK, FEW, LinkSetting
from contourlab.features.run.source import Source, scenario_asked
from contourlab.findings import finding
from contourlab.loop.machine import require_loops
from contourlab.metrics.run_figures import goal_named
from contourlab.rendering.stages import Stages
from contourlab.study import Setting

if TYPE_CHECKING:
    from contourlab.feed import Reference
    from contourlab.loop import Controller
    from contourlab.scenario import Case


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
    judged = goal_named(settings.figure, "--figure")
    allowed = None
    if settings.tolerance is not None:
        allowed = positive("--tolerance", settings.tolerance, judged.quantity, f'a quantity, such as "{judged.example(15)}"')
    scenario = scenario_asked(source, settings)
    cases = scenario.cases()
    for case in cases:
        require_loops(case.machine)
    _refuse_idle(settings, cases)
    session.will_write(scenario.inputs, "summary.json")
    costs: dict[str, SchemeCost] = {}
    interrupted = False
    stages = session.stages()
    stages.expect(sum(1 + len(_controllers(case.controller, settings)) for case in cases))
    schemes_ready = (_ready(case, settings, judged.name, stages) for case in cases)
    chosen = _chosen(list(schemes_ready), settings) if settings.quick else schemes_ready
    try:
        for scheme in chosen:
            undivided = scheme.undivided(scheme.setting.reference)
            limit = allowed_error(undivided, settings.share, allowed)
            done: list[DivisionCost] = []
            for label, setting in scheme.divided:
                stages.begin(f"{scheme.case.name}: {label}")
                setting.allowed = limit
                done.append(division_cost(setting, settings.quantities, settings.span, stages.advance))
                costs[scheme.case.name] = SchemeCost(judged.name, undivided, limit, tuple(done))
    except KeyboardInterrupt:
        if not costs:
            raise
        interrupted = True
    left_out = [] if interrupted else [case.name for case in cases if case.name not in costs]
    findings = (finding("CL766", schemes=left_out),) if left_out else ()
    return LinkResult(scenario, costs, findings, interrupted)


@dataclass(frozen=True)
class _Scheme:
    """A scheme ready to be divided; `fits` batches of it fit into a quick answer."""

    case: Case
    setting: Setting
    figure: str
    divided: list[tuple[str, LinkSetting]]
    fits: float = math.inf

    def undivided(self, motion: Reference) -> float:
        """Return the error of the undivided loop along a motion."""
        try:
            return undivided_error(replace(self.setting, reference=motion), self.figure)
        except DivergenceError as error:
            error.add_note(f"Scheme {self.case.name!r} diverges without links. Choose other schemes with --schemes.")
            raise

    def share(self, options: Link, few: int) -> float:
        """Return the share of the time of a quick answer that the scheme takes with some values per doubling."""
        return sum(replace(setting, few=few).batches(options.quantities, options.span) for _, setting in self.divided) / self.fits


def _ready(case: Case, options: Link, figure: str, stages: Stages) -> _Scheme:
    stages.begin(f"planning {case.name}")
    setting, seeds = Setting.of(case), SEEDS if options.seeds is None else options.seeds
    divisions = _controllers(case.controller, options).items()
    divided = [(label, LinkSetting(replace(setting, controller=made), figure, math.nan, seeds)) for label, made in divisions]
    scheme = _Scheme(case, setting, figure, divided)
    run = lambda motion: replace(setting, reference=motion).batch(setting.as_it_is(CHUNK), [figure], threads=1)  # noqa: E731
    return replace(scheme, fits=affordable(run, setting.reference)) if options.quick else scheme


def _chosen(schemes: Sequence[_Scheme], options: Link) -> Iterator[_Scheme]:
    """Yield the schemes of a quick answer: all, with as many values per doubling as fit, or else those that fit with the fewest."""
    few = next((few for few in FEW if sum(scheme.share(options, few) for scheme in schemes) <= 1.0), FEW[-1])
    spent = 0.0
    for scheme in schemes:
        share = scheme.share(options, few)
        if spent + share <= 1.0:
            spent += share
            yield replace(scheme, divided=[(label, replace(setting, few=few)) for label, setting in scheme.divided])
    if spent == 0.0:
        raise too_slow(min(scheme.share(options, few) for scheme in schemes), 1.0)


def _controllers(controller: Controller, options: Link) -> dict[str, Controller]:
    """Return the divided controllers, each with its label."""
    if _as_it_is(controller, options):
        return {"links of the scenario": controller}
    return {
        f"{division} in the axis, messages {WAYS[ways]}": divided(controller, division, ways, options.network, options.axes or None)
        for division in options.divisions
        for ways in options.directions
    }


def _as_it_is(controller: Controller, options: Link) -> bool:
    """Return whether a controller keeps its own links."""
    return not options.division and any(axis.link is not None for axis in controller.axes.values())


def _refuse_idle(options: Link, cases: Sequence[Case]) -> None:
    """Refuse options that would have no effect."""
    texts = {options.PARTS[name].typed: text for name, text in options.given.items()}
    texts |= {"--ways": ",".join(options.ways), "--axes": ",".join(options.axes), "--extrapolate": "given" * options.extrapolate}
    own_links = [case for case in cases if _as_it_is(case.controller, options)]
    for case in own_links:
        for option, text in texts.items():
            if text:
                wanted = f"given with --division: without it, scheme {case.name!r} keeps its own links"
                raise ParameterError(option, repr(text), wanted)
    if options.longest is not None and options.quantities == ("loss",):
        raise ParameterError("--longest", options.longest, "left out: --vary tests the loss only, no time")
    links = [axis.link for case in own_links for axis in case.controller.axes.values() if axis.link is not None]
    parts = [options.network, *(part for link in links for part in (link.down, link.up) if part is not None)]
    random = {"jitter", "loss"} & set(options.quantities) or any(part.values().get(name) for part in parts for name in ("jitter", "loss"))
    if options.seeds is not None and not random:
        raise ParameterError("--seeds", f"{options.seeds}", "given with --jitter, --loss, or one of them in --vary: nothing else is random")
