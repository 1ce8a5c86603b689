"""``contourlab backlash``: the gap of each axis as it can be measured, what it does to the loops, what to do about it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.stages import shown
from contourlab.features.backlash.study import AxisGap, BacklashStudy, Trial, backlash_study
from contourlab.units import from_si, to_si

if TYPE_CHECKING:
    from contourlab.analysis.backlash.limit_cycle_prediction import LimitCycle
    from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit
    from contourlab.components.contract import Component
    from contourlab.loop import Machine

HOLDING = "compensation"
FEW = 0.05
"""Part of a limit cycle's period that a servo period may be for a loop in continuous time to stand for a sampled one."""


@dataclass(frozen=True)
class BacklashOutcome:
    """What the command prints: as JSON, and as text."""

    summary: dict[str, Any]
    text: str


def backlash_scenario(
    file: str | Path, *, schemes: Sequence[str] = (), plugins: Sequence[str | Path] = (), progress: bool = False
) -> BacklashOutcome:
    """Study the backlash of the schemes of a scenario.

    Parameters
    ----------
    file : str or Path
        A scenario whose machine has axes with backlash.
    schemes : sequence of str
        As of `contourlab.features.run.schemes.compare_schemes`; all by default.
    plugins : sequence of str or Path
        Python files with components.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ComponentError
        If no axis has backlash.
    DivergenceError
        If a run without a change runs away.
    """
    from contourlab.features.run.schemes import loaded

    scenario = loaded(file, schemes, plugins)
    texts, found = [], {}
    with shown(progress) as stages:
        for case in scenario.cases():
            stages.begin(f"planning {case.name}")
            reference = case.reference()
            given: dict[str, Any] = {"seed": case.seed, "stage": stages.begin, "progress": stages.advance}
            study = backlash_study(case.name, case.machine, case.controller, reference, **given)
            texts.append("\n".join(_lines(study, case.machine)))
            found[case.name] = _summary(study, case.machine)
    return BacklashOutcome({"name": scenario.name, "schemes": found}, "\n\n".join(texts))


def _microns(value: float) -> str:
    return f"{value * 1e6:.3g} um"


def _lines(study: BacklashStudy, machine: Machine) -> Iterator[str]:
    yield study.name
    for one in study.axes:
        yield from _axis_lines(one, machine.servo_period)
    if study.circle is not None:
        seen = zip(study.circle.axes, study.circle.backlash, study.circle.deviation, strict=True)
        told = ", ".join(f"{axis} {_microns(value)} +- {_microns(2.0 * deviation)}" for axis, value, deviation in seen)
        yield f"  on the circle of the path, what the controller leaves: {told}"
    yield "  part error, rms and largest:"
    for trial in study.trials:
        chosen = "  <- recommended" if trial is study.recommended else ""
        if trial.metrics is None:
            yield f"    {trial.name}: runs away"
        else:
            error = trial.metrics.part_error
            yield f"    {trial.name}: {_microns(error.rms)}, {_microns(error.max)}{chosen}"
    for remark in study.remarks:
        yield f"  {remark}"
    if study.recommended.parts:
        yield "  to be put into the scenario:"
        yield from (f"    {line}".rstrip() for line in _snippet(study.recommended, machine).splitlines())


def _axis_lines(one: AxisGap, period: float) -> Iterator[str]:
    yield f"  axis {one.axis}: free travel {_microns(one.gap)} in the machine file, lost motion with friction {_microns(one.lost_motion)}"
    if one.pair is not None:
        spread = _microns(2.0 * one.pair.lost_motion_deviation)
        gap = "" if math.isnan(one.pair.gap) else f", of it free travel {_microns(one.pair.gap)}"
        yield f"    from motor and load in the run: lost motion {_microns(one.pair.lost_motion)} (scatter {spread}){gap}"
    if one.motor_side is not None:
        seen, deviation, confidence = one.motor_side
        yield f"    from the motor alone: free travel {_microns(seen)} +- {_microns(2.0 * deviation)}, confidence {confidence:.2f}"
    if one.prediction is not None:
        cycles = [f"{_cycle(c, period)} ({c.validity.partition(':')[0]})" for c in one.prediction]
        yield f"    limit cycles, describing function: {'; '.join(cycles) or 'none'}"
    if one.orbits is not None:
        orbits = [_cycle(orbit, period) for orbit in one.orbits.orbits]
        free = "without friction" + (", half gaps of the laws, hysteresis and hand-over" if one.prediction is None else "")
        yield f"    limit cycles, exact, {free}: {'; '.join(orbits) or 'none found'}"
    for remark in one.remarks:
        yield f"    {remark}"


def _cycle(cycle: LimitCycle | PeriodicOrbit, period: float) -> str:
    frequency = cycle.frequency / (2.0 * math.pi)
    short = f" (roughly: {1.0 / (frequency * period):.2g} servo periods long)" if frequency * period > FEW else ""
    return f"{'stable' if cycle.stable else 'unstable'}, {frequency:.4g} Hz, {_microns(cycle.amplitude)}{short}"


def _snippet(trial: Trial, machine: Machine) -> str:
    """Return the compensation as TOML."""
    from contourlab.scenario.dump import component_table
    from contourlab.scenario.toml_text import toml

    def units(name: str) -> tuple[str, str]:
        plant = machine.axis(name).plant
        return plant.command_unit, plant.force_unit

    axes = {name: {HOLDING: component_table(_rounded(part, units(name)), units(name))} for name, part in trial.parts.items()}
    return toml({"controller": {"axes": axes}})


def _rounded(part: Component, units: tuple[str, str]) -> Component:
    """Return a component with numbers of three digits in the units that people write them in."""
    found = {}
    for name, parameter in ((name, known.for_plant(*units)) for name, known in type(part).parameters.items()):
        value = getattr(part, name)
        if isinstance(value, float) and math.isfinite(value) and not parameter.whole:
            shown = parameter.display or parameter.unit
            found[name] = to_si(f"{from_si(value, shown):.3g} {shown}", parameter.unit) if shown else float(f"{value:.3g}")
    made: Component = part.replace(**found)
    return made


def _summary(study: BacklashStudy, machine: Machine) -> dict[str, Any]:
    """Return a study as JSON holds it, SI throughout, frequencies in Hz."""
    circle, recommended = study.circle, study.recommended
    return {
        "axes": {one.axis: _axis_summary(one) for one in study.axes},
        "on_circle": None if circle is None else dict(zip(circle.axes, zip(circle.backlash, circle.deviation, strict=True), strict=True)),
        "trials": [_trial_summary(trial) for trial in study.trials],
        "recommended": recommended.name,
        "toml": _snippet(recommended, machine) if recommended.parts else None,
        "remarks": list(study.remarks),
    }


def _axis_summary(one: AxisGap) -> dict[str, Any]:
    pair, seen = one.pair, one.motor_side
    return {
        "backlash_gap": one.gap,
        "lost_motion": one.lost_motion,
        "from_motor_and_load": None
        if pair is None
        else {"lost_motion": pair.lost_motion, "deviation": pair.lost_motion_deviation, "gap": pair.gap},
        "from_motor_alone": None if seen is None else dict(zip(("gap", "deviation", "confidence"), seen, strict=True)),
        "describing_function": None
        if one.prediction is None
        else [_cycle_summary(cycle) | {"validity": cycle.validity} for cycle in one.prediction],
        "limit_cycles": None if one.orbits is None else [_cycle_summary(orbit) for orbit in one.orbits.orbits],
        "remarks": list(one.remarks),
    }


def _cycle_summary(cycle: LimitCycle | PeriodicOrbit) -> dict[str, Any]:
    return {"frequency": cycle.frequency / (2.0 * math.pi), "amplitude": cycle.amplitude, "stable": cycle.stable}


def _trial_summary(trial: Trial) -> dict[str, Any]:
    error = None if trial.metrics is None else trial.metrics.part_error
    return {
        "name": trial.name,
        "part_error_rms": None if error is None else error.rms,
        "part_error_max": None if error is None else error.max,
    }
