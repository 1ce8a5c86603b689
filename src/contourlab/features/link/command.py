"""``contourlab link``: what it costs to divide the controllers of a scenario between base and axes, and how little network is enough."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.folder import staged
from contourlab.app.json_values import json_values
from contourlab.app.stages import Stages, shown
from contourlab.errors import DivergenceError, ParameterError, UnitError
from contourlab.features.link.text import SHOWN, Costs, link_lines, link_summary
from contourlab.result import write_text_atomic
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.components.link.network import Network
    from contourlab.feed import Reference
    from contourlab.loop import Controller
    from contourlab.report.charts import Chart
    from contourlab.scenario import Case

LONGEST = 10.0
"""Seconds: the longest message period and delay of a network."""
USUAL_LONGEST = "100 ms"
"""Up to where times are varied where nobody says."""
MOST_SEEDS = 256
"""All seeds of 32 values run at once."""


@dataclass(frozen=True)
class LinkOptions:
    """What is asked for, as typed.

    Attributes
    ----------
    divisions, ways, quantities, axes : tuple of str
        Empty for all; a scenario with links of its own is taken as it stands unless a division is named.
    figure : str
        Of `SHOWN`.
    within : str, optional
        As ``"10 %"``, which it is by default: more than the undivided loop's error that is allowed.
    tolerance : str, optional
        Largest error in place of that, as ``"15 um"``.
    network : mapping of str to str
        Message period, delay, jitter and loss of the links while another is varied.
    extrapolate : bool
        Whether messages are extrapolated instead of held.
    longest : str, optional
        Up to where times are varied, by default `USUAL_LONGEST`.
    seeds : int, optional
        Runs of which the worst counts where chance plays a part, by default `contourlab.features.link.sweep.SEEDS`.
    """

    divisions: tuple[str, ...] = ()
    ways: tuple[str, ...] = ()
    quantities: tuple[str, ...] = ()
    axes: tuple[str, ...] = ()
    figure: str = "rms"
    within: str | None = None
    tolerance: str | None = None
    network: Mapping[str, str] | None = None
    extrapolate: bool = False
    longest: str | None = None
    seeds: int | None = None


@dataclass(frozen=True)
class LinkOutcome:
    """What the command prints: as JSON, and as text."""

    summary: dict[str, Any]
    text: str


def link_scenario(
    file: str | Path,
    options: LinkOptions,
    *,
    schemes: Sequence[str] = (),
    plugins: Sequence[str | Path] = (),
    plots: Sequence[str] = (),
    folder: str | Path = "results",
    progress: bool = False,
) -> LinkOutcome:
    """Divide the controllers of a scenario's schemes, vary the links between, and write ``summary.json`` and pictures into a folder.

    Parameters
    ----------
    file : str or Path
        A scenario.
    options : LinkOptions
    schemes : sequence of str
        As of `contourlab.features.run.schemes.compare_schemes`; all by default.
    plugins : sequence of str or Path
        Python files with components.
    plots : sequence of str
        png, svg or pdf, into ``plots`` in `folder`.
    folder : str or Path
        Of the results.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ScenarioError, ParameterError
        If the scenario cannot be read, or an option is out of range, or nothing would come of it.
    OutputError
        If the folder cannot be made or written to; found before anything is simulated.
    DivergenceError
        If a loop runs away even undivided.
    """
    from contourlab.features.run.command import check_plots
    from contourlab.features.run.schemes import loaded

    check_plots(plots)
    asked = read_options(options)
    scenario = loaded(file, schemes, plugins)
    refuse_idle(options, asked, scenario.cases())
    found: dict[str, Any] = {"name": scenario.name, "schemes": {}}
    texts: list[str] = []
    charts: list[Chart] = []
    with staged(folder, "summary.json", inputs=scenario.inputs) as stage:
        with shown(progress) as stages:
            for case in scenario.cases():
                stages.begin(f"planning {case.name}")
                costs = _costs(case, case.reference(), options, asked, stages)
                texts.append("\n".join(link_lines(costs)))
                found["schemes"][case.name] = link_summary(costs)
                charts += _charts(case.name if len(scenario.cases()) > 1 else "", costs)
        write_text_atomic(stage / "summary.json", json.dumps(json_values(found), indent=2, allow_nan=False) + "\n")
        if plots:
            from contourlab.report.plots import write_charts

            files = write_charts(charts, stage / "plots", plots)
            texts.append("\n".join(f"plot: {Path(folder) / one.relative_to(stage)}" for one in files))
    return LinkOutcome(found, "\n\n".join(texts))


# --- what is asked -----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Asked:
    """What is asked for, in SI; `divisions`, `ways` and `quantities` are all that there are where none was named."""

    within: float
    allowed: float | None
    longest: float
    seeds: int
    network: Network
    divisions: tuple[str, ...]
    ways: tuple[str, ...]
    quantities: tuple[str, ...]


def read_options(options: LinkOptions) -> Asked:
    """Return options in SI.

    Raises
    ------
    ParameterError
        If one is unknown or out of range, or two are given of which one alone can hold.
    """
    from contourlab.components.link.network import Network
    from contourlab.features.link.sweep import QUANTITIES, SEEDS, WAYS
    from contourlab.loop import DIVISIONS

    if options.figure not in SHOWN:
        raise ParameterError("--figure", repr(options.figure), "one of " + ", ".join(SHOWN))
    _each_once("--axes", options.axes)
    seeds = SEEDS if options.seeds is None else options.seeds
    if not 1 <= seeds <= MOST_SEEDS:
        raise ParameterError("--seeds", f"{seeds}", f">= 1 and <= {MOST_SEEDS}")
    if options.tolerance is not None and options.within is not None:
        raise ParameterError(
            "--within", f"{options.within} beside --tolerance", "one of the two: a part of the undivided error, or an error"
        )
    given = {name: _value(name, text) for name, text in (options.network or {}).items()}
    allowed = None
    if options.tolerance is not None:
        unit = "m*s" if options.figure == "integral" else "m"
        allowed = _positive("--tolerance", options.tolerance, unit, '"15 um s"' if unit == "m*s" else '"15 um"')
    text = USUAL_LONGEST if options.longest is None else options.longest
    longest = _positive("--longest", text, "s", '"100 ms"')
    if longest > LONGEST:
        raise ParameterError("--longest", text, f"up to {LONGEST:g} s, the most that a link takes")
    return Asked(
        within=_within("10 %" if options.within is None else options.within),
        allowed=allowed,
        longest=longest,
        seeds=seeds,
        network=Network(**given, between="extrapolate" if options.extrapolate else "hold"),
        divisions=_named("--division", options.divisions, tuple(DIVISIONS)),
        ways=_named("--ways", options.ways, tuple(WAYS)),
        quantities=_named("--vary", tuple(name.replace("-", "_") for name in options.quantities), QUANTITIES),
    )


def as_it_stands(controller: Controller, options: LinkOptions) -> bool:
    """Tell whether a controller is taken with the links that it has."""
    return not options.divisions and any(mine.link is not None for mine in controller.axes.values())


def refuse_idle(options: LinkOptions, asked: Asked, cases: Sequence[Case]) -> None:
    """Refuse options of which nothing would come.

    Raises
    ------
    ParameterError
        If a scheme that is taken with its own links is to be divided in another way, or what is varied has no use for an option.
    """
    texts = {f"--{name.replace('_', '-')}": text for name, text in (options.network or {}).items()}
    texts |= {"--ways": ",".join(options.ways), "--axes": ",".join(options.axes), "--extrapolate": "given" * options.extrapolate}
    for case in cases:
        for option, text in texts.items():
            if text and as_it_stands(case.controller, options):
                wanted = f"given with --division: scheme {case.name!r} has links of its own, and is taken as it stands without one"
                raise ParameterError(option, repr(text), wanted)
    if options.longest is not None and asked.quantities == ("loss",):
        raise ParameterError("--longest", options.longest, "given where a time is varied: --vary names the loss alone")
    drawn = {"jitter", "loss"} & set(asked.quantities) or asked.network.jitter or asked.network.loss
    if options.seeds is not None and not drawn and not any(_by_chance(case, options) for case in cases):
        wanted = "given where chance plays a part: with --jitter, --loss, or one of them in --vary"
        raise ParameterError("--seeds", f"{options.seeds}", wanted)


def _by_chance(case: Case, options: LinkOptions) -> bool:
    """Tell whether chance plays a part in links that a scheme is taken with."""
    links = [mine.link for mine in case.controller.axes.values() if mine.link is not None and as_it_stands(case.controller, options)]
    return any(part.values().get(name) for link in links for part in (link.down, link.up) if part for name in ("jitter", "loss"))


def _named(option: str, names: tuple[str, ...], known: tuple[str, ...]) -> tuple[str, ...]:
    for name in names:
        if name not in known:
            raise ParameterError(option, repr(name), "of " + ", ".join(one.replace("_", "-") for one in known))
    _each_once(option, tuple(name.replace("_", "-") for name in names))
    return names or known


def _each_once(option: str, names: tuple[str, ...]) -> None:
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ParameterError(option, repr(",".join(names)), f"names that differ: {twice} is given twice")


def _value(name: str, text: str) -> float:
    option = "--" + name.replace("_", "-")
    return _part(option, text) if name == "loss" else _quantity(option, text, "s", '"2 ms"')


def _part(option: str, text: str) -> float:
    return _quantity(option, text, "", '"10 %" or 0.1')


def _within(text: str) -> float:
    """Return a part; a number of 1 or more without a unit may be meant in percent or as a factor, and is asked about."""
    part = _part("--within", text)
    if part >= 1.0 and not re.search("%|percent", text):
        raise ParameterError("--within", text, f'a part below 1, or given in %: "{part:g} %" or "{100.0 * part:g} %"')
    return part


def _quantity(option: str, text: str, unit: str, example: str) -> float:
    try:
        value = to_si(float(text) if not unit and re.fullmatch(r"[\d.eE+-]+", text.strip()) else text, unit)
    except (UnitError, ValueError) as error:
        raise ParameterError(option, repr(text), f"a quantity, such as {example}") from error
    if not (value >= 0.0 and math.isfinite(value)):
        raise ParameterError(option, text, ">= 0 and finite")
    return value


def _positive(option: str, text: str, unit: str, example: str) -> float:
    value = _quantity(option, text, unit, example)
    if not value > 0.0:
        raise ParameterError(option, text, "> 0")
    return value


def _costs(case: Case, reference: Reference, options: LinkOptions, asked: Asked, stages: Stages) -> Costs:
    """Return the undivided loop's error, what is allowed, and what each division costs."""
    from contourlab.features.link.division import allowed_error, division_cost, undivided_error

    figure = SHOWN[options.figure][0]
    same: dict[str, Any] = {"seed": case.seed, "moving": case.moving}
    try:
        whole = undivided_error(case.machine, case.controller, reference, figure, **same)
    except DivergenceError as error:
        error.add_note(f"That is scheme {case.name!r}, undivided: --schemes takes others.")
        raise
    allowed = allowed_error(whole, asked.within, asked.allowed)
    costs = []
    for label, controller in _controllers(case.controller, options, asked):
        stages.begin(f"{case.name}: {label}")
        swept: dict[str, Any] = {
            "quantities": asked.quantities,
            "longest": asked.longest,
            "seeds": asked.seeds,
            "progress": stages.advance,
        }
        costs.append(division_cost(case.machine, controller, reference, allowed=allowed, figure=figure, **same, **swept))
    return Costs(case.name, options.figure, whole, allowed, tuple(costs))


def _controllers(controller: Controller, options: LinkOptions, asked: Asked) -> Iterator[tuple[str, Controller]]:
    from contourlab.features.link.sweep import divided

    if as_it_stands(controller, options):
        yield "as the scenario divides it", controller
        return
    for division in asked.divisions:
        for ways in asked.ways:
            yield f"{division} in the axis, {ways}", divided(controller, division, ways, asked.network, options.axes or None)


# --- pictures ----------------------------------------------------------------------------------------------------------------------------


def _charts(name: str, costs: Costs) -> Iterator[Chart]:
    """Yield a picture for each quantity: the error of every division over it."""
    from contourlab.features.link.pictures import link_chart

    _, unit, scale = SHOWN[costs.figure]
    slug = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")
    levels = {f"allowed; undivided {costs.whole * scale:.3g}": costs.allowed}
    label = f"contour error, {costs.figure} [{unit}]"
    for quantity in costs.divisions[0].sweeps:
        sweeps = {f"{cost.division}, {cost.ways}": cost.sweeps[quantity] for cost in costs.divisions}
        curves = {words: (sweep.values, sweep.error) for words, sweep in sweeps.items()}
        yield link_chart(quantity, curves, levels, label, scale, slug)
