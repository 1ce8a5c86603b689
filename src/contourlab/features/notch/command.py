"""``contourlab notch``: propose a notch filter for each resonance that spoils a loop, with margins and contour error before and after."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar

from contourlab.analysis.identification.resonance import identify_resonance
from contourlab.app.json_values import json_values
from contourlab.app.results import proposed
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.components.plant.plant import resonance_of
from contourlab.errors import LogError, ParameterError
from contourlab.features.measure.log_choice import open_log
from contourlab.features.notch.options import Notch
from contourlab.features.run.source import Source, case_asked
from contourlab.features.tune.objective import Evaluation, evaluate
from contourlab.figures import figure, number
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.loop import Controller, Machine
from contourlab.loop.machine import require_loops
from contourlab.loop.parameters import with_values
from contourlab.metrics.run_figures import FIGURES
from contourlab.rendering.margin_words import decibel, degrees
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario import Case, Scenario
from contourlab.study import Setting
from contourlab.study.guards import Bounds, Guards
from contourlab.study.notch import MOVED, NotchDesign, design_notch, with_velocity_gain

SHOWN = ("contour_error_rms", "contour_error_max", "part_error_max", "tracking_error_rms", "limited_share")
"""Figures of the runs before and after."""
PASSES = 5
"""Passes after which a plant has a measured resonance: its parameters are nearly proportional to it."""


@dataclass(frozen=True, eq=False)
class Notched(Answer):
    """Notch filters, and the runs without and with them.

    Attributes
    ----------
    scenario : Scenario
    case : Case
        Its scheme.
    bounds : Bounds
    designs : dict of str to NotchDesign
        By axis.
    before, after : Evaluation
        The scenario as it is, and with the notches.
    without : Evaluation or None
        The scenario without notches, each velocity gain lowered until the margins are kept; None where nothing has to be lowered, or
        nothing helps.
    findings : tuple of Finding
    controller : Controller
        With the notches.
    controller_file : Path or None
        The file written.
    """

    scenario: Scenario = field(repr=False)
    case: Case = field(repr=False)
    bounds: Bounds
    designs: dict[str, NotchDesign]
    before: Evaluation
    after: Evaluation
    without: Evaluation | None
    findings: tuple[Finding, ...]
    controller: Controller = field(repr=False)
    controller_file: Path | None = None

    json_form: ClassVar = {
        "name": "scenario.name",
        "scheme": "case.name",
        **{name: name for name in ("passed", "bounds", "designs", "before", "after", "without", "findings", "controller_file")},
    }

    @property
    def passed(self) -> bool:
        """Whether every axis keeps the margins."""
        return not any(map(self.bounds.broken, self.after.margins.values()))

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The designs, one a row [SI]."""
        return [{"axis": axis, **json_values(design)} for axis, design in self.designs.items()]

    def save(self, folder: str | Path = "results", *, write: str | Path | None = None) -> Notched:
        """Write the controller, if there is a notch.

        Parameters
        ----------
        folder : str or Path
            Gets nothing.
        write : str or Path, optional
            Controller file; none by default.

        Returns
        -------
        Notched
            With the name of its file.

        Raises
        ------
        OutputError
            If the file cannot be written.
        """
        from contourlab.scenario.dump import dump

        if write is None or not self.designs:
            return self
        head = f"Notch filters for {self.scenario.name}, scheme {self.case.name}."
        write_text_atomic(Path(write), proposed(head, dump(self.controller, self.case.machine)))
        return replace(self, controller_file=Path(write))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Write the controller, or analyse the scenario."""
        wanted = asked.files.write is None and self.designs
        return asked.again("--write", "notched.toml") if wanted else ["analyse", *asked.given]

    @property
    def text(self) -> str:
        """Tables, findings, and the file written."""
        parts = [
            f"{self.scenario.name}, {self.case.name}",
            *(_design_text(axis, design) for axis, design in self.designs.items()),
            _runs(self),
        ]
        parts.append(paragraphs(map(str, self.findings)))
        written = self.controller_file
        parts.append("no controller file: name one with --write" if written is None else f"controller file: {written}")
        return "\n\n".join(filter(None, parts))


@question(Notch)
def notch(*source: Source, settings: Notch, session: Session = QUIET) -> Notched:
    """Propose a notch for the resonance of each axis that breaks its margins, or of the given axes, and run without and with.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    Notched

    Raises
    ------
    ScenarioError, ParameterError
        If the scenario cannot be read, or a given axis has no resonance.
    ComponentError
        If the loop of an axis has no linear model.
    """
    scenario, case = case_asked(source, settings)
    session.will_write([*scenario.inputs, *([] if settings.log is None else settings.files(settings.log))])
    bounds, machine, made = settings.margins, case.machine, case.controller
    require_loops(machine)
    unknown = [name for name in settings.axes if name not in machine.axis_names]
    if unknown:
        raise ParameterError("--axes", unknown[0], f"one of {', '.join(machine.axis_names)}")
    heard = list[Finding]()
    if settings.log is not None:
        machine, heard = _ringing(settings.log, machine, made, settings)
        case = replace(case, machine=machine)
    designs: dict[str, NotchDesign] = {}
    for name in settings.axes or _in_need(machine, made, bounds):
        designs[name], made = design_notch(machine, made, name, bounds)
    setting = Setting.of(case)
    lowered = _lowered(case.controller, designs)
    before, after = (evaluate(replace(setting, controller=tried), bounds) for tried in (case.controller, made))
    without = None if lowered is None else evaluate(replace(setting, controller=lowered), bounds)
    findings = heard + [one for name, design in designs.items() for one in _findings(name, design, bounds)]
    findings += [] if designs else [finding("CL640", bounds=bounds.margin_words)]
    return Notched(scenario, case, bounds, designs, before, after, without, tuple(findings), made)


def _ringing(log: Path, machine: Machine, controller: Controller, settings: Notch) -> tuple[Machine, list[Finding]]:
    """Return the machine with the resonance that an accelerometer measured on an axis, and findings."""
    if len(settings.axes) != 1:
        raise ParameterError("--axes", ",".join(settings.axes) or "missing", "the axis that moved while --log was recorded")
    axis, opened = settings.axes[0], open_log(log, settings)
    acceleration = opened.signal(axis, "acceleration") if axis in opened.result.axes else None
    if acceleration is None:
        raise LogError(f"has no acceleration of {axis}: name it, as --column 'acceleration.{axis}=NAME [m/s^2]'", file=log)
    with about(log):
        fit = identify_resonance(acceleration, opened.result.servo_period)
    if not fit.usable:
        raise LogError("; ".join([f"shows no resonance of {axis} well enough", *(one.text for one in fit.findings)]), file=log)
    measured, known = fit.values.tolist(), fit.robust_deviations.tolist()
    for _ in range(PASSES):
        # The parameters are those without carried mass and guide friction.
        plant, loaded = machine.axis(axis).plant.values(), resonance_of(machine.loaded_plant(axis))
        if loaded is None or "resonance" not in plant:
            raise ParameterError(
                f"axes.{axis}.plant", f'"{machine.axis(axis).plant.kind}"', "one with a measured resonance, such as two-mass"
            )
        own = plant["resonance"] * measured[0] / loaded[0], max(plant["damping_ratio"], 1e-4) * measured[1] / loaded[1]
        names = (f"axes.{axis}.plant.{name}" for name in ("resonance", "damping_ratio"))
        machine, _ = with_values(machine, controller, dict(zip(names, own, strict=True)))
    heard = finding("CL643", f"axis {axis}", frequency=measured[0], deviation=known[0], damping=measured[1], damping_deviation=known[1])
    return machine, [heard, *fit.findings, *opened.findings]


def _lowered(controller: Controller, designs: Mapping[str, NotchDesign]) -> Controller | None:
    """Return the controller with velocity gains that keep the margins without a notch; None if there are none, or no need for them."""
    factors = {name: design.largest_before / design.velocity_gain_before for name, design in designs.items()}
    if not factors or not all(factor > 0.0 for factor in factors.values()) or min(factors.values()) >= 1.0:
        return None
    for name, factor in factors.items():
        controller = with_velocity_gain(controller, name, min(factor, 1.0))
    return controller


def _in_need(machine: Machine, controller: Controller, bounds: Bounds) -> list[str]:
    """Return the axes with a resonance whose loops break the margins."""
    margins = Guards(machine, controller, bounds).exact({})
    ringing = [name for name in machine.axis_names if resonance_of(machine.loaded_plant(name)) is not None]
    return [name for name in ringing if name in margins and bounds.broken(margins[name])]


def _findings(name: str, design: NotchDesign, bounds: Bounds) -> list[Finding]:
    place = f"axis {name}"
    broken = [words for margins in (design.margins_after, *design.margins_moved) if (words := bounds.broken(margins))]
    if broken:
        return [finding("CL641", place, margins=broken[0])]
    if design.velocity_gain_after != design.velocity_gain_before:
        return [finding("CL642", place, share=design.velocity_gain_after / design.velocity_gain_before)]
    return []


def _design_text(axis: str, design: NotchDesign) -> str:
    head = (
        f"axis {axis}: resonance {figure(design.resonance, 'Hz', 4)} with a damping ratio of {number(design.damping_ratio)}; notch at "
        f"{figure(design.frequency, 'Hz', 4)}, damping ratio {number(design.denominator_damping_ratio)}, of its zeros "
        f"{number(design.numerator_damping_ratio)}"
    )
    both = (design.margins_before, design.margins_after)
    rows = [("gain margin", *map(decibel, both)), ("phase margin", *map(degrees, both))]
    rows += [
        (f"margins, resonance {100.0 * share:+.0f} %", "", f"{decibel(moved)}, {degrees(moved)}" if moved.stable else "unstable")
        for share, moved in zip((-MOVED, MOVED), design.margins_moved, strict=False)
    ]
    if math.isfinite(design.velocity_gain_before):
        gains = (design.velocity_gain_before, design.velocity_gain_after), (design.largest_before, design.largest_after)
        heads = ("velocity gain [command s/m]", "largest that keeps the margins")
        rows += [(name, *(number(gain, 4) for gain in pair)) for name, pair in zip(heads, gains, strict=True)]
    table = Table([Column(f"axis {axis}", left=True), Column("before"), Column("after")], rows=rows)
    return f"{paragraphs([head])}\n\n{table.text()}"


def _runs(notched: Notched) -> str:
    if not notched.designs:
        return ""
    runs = {"before": notched.before, "before, lower gain": notched.without, "after": notched.after}
    shown = {head: run for head, run in runs.items() if run is not None}
    rows = (
        (one.label, *("diverges" if run.run is None else figure(run.figures[one.name], one.display) for run in shown.values()))
        for one in map(FIGURES.__getitem__, SHOWN)
    )
    return Table([Column("run", left=True), *map(Column, shown)], rows=rows).text()
