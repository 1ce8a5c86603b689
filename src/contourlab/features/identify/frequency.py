"""Frequency response of an axis from logs of sines, a chirp, noise or a multisine, and drive models fitted to it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from contourlab.analysis.identification.drive_fit import (
    DriveFit,
    damping_ratio,
    fit_linear_motor,
    fit_load_share,
    fit_two_inertia,
    fit_two_mass,
    held_response,
    resonances,
)
from contourlab.analysis.identification.filtered_motion import filtered_motion
from contourlab.analysis.identification.frequency_response import (
    Measured,
    MeasuredResponse,
    is_sweep,
    periodic_response,
    repeating,
    response_findings,
    sine_responses,
    sine_stretch,
    spectral_response,
    swept_response,
)
from contourlab.analysis.identification.inverse_dynamics import mass_findings
from contourlab.arrays import Array, Complex
from contourlab.components.plant.two_mass import TwoMass
from contourlab.errors import ParameterError
from contourlab.features.identify.axis_tables import forces_of, plant_numbers, rigid_tables, two_inertia_numbers, two_inertia_tables
from contourlab.features.identify.records import TRAVEL, AxisRecord, common_unit, newton_option, reference_name
from contourlab.features.identify.result import Drawn, Graph, Identified, Picture, Propagated, Row, Tables, assumed, figures, propagate
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.rendering.table import Column, Table

PRINTED = 24
"""Largest number of points printed; the JSON has all."""
FEW = 40
"""Largest number of points drawn with their deviations."""
COHERENT = 0.5
EXCITATIONS = ("reference", "command")
"""What excites an axis: the reference where it moves, else the command; or the command in any case."""
MODEL_POINTS = 400
"""Points of a model curve."""
BEYOND, BELOW_NYQUIST = 2.0, 0.4
"""Cut-off for accelerations: relative to the highest fitted frequency, and at most relative to the sampling frequency."""
TWO_MASS_UNITS = {"resonance": "Hz", "damping_ratio": "", "load_share": ""}
"""Parameters of the plant besides those of a rigid one."""
EQUAL = 0.5
"""Share of the load where it is not known."""
SMOOTHED, SLOW, RARELY = 0.005, 0.1, 0.05
"""Interval [s] for a speed, share of the top speed that counts as motion, share of the samples that counts as reversing."""


def identify_response(records: Sequence[AxisRecord], excitation: str = EXCITATIONS[0]) -> Identified:
    """Measure the frequency response of an axis with coherence and deviations.

    Parameters
    ----------
    records : sequence of AxisRecord
        With command or force; in closed loop with the reference.
    excitation : str
        ``"reference"``: the reference where it moves, else the command; ``"command"`` if a test signal is added to the command.

    Raises
    ------
    ResultError
        If a log has no command, or commands have different units.
    LogError
        If command or position of a record do not change; names the log.
    ParameterError
        If a record is too short, or its response is noise.
    """
    response, unit = measured_response(records, excitation), records[0].unit
    weak = int(np.count_nonzero(response.coherence < COHERENT))
    low = [finding("CL507", limit=COHERENT, count=weak, points=response.frequency.size)] if weak else []
    doubts = response_findings(response)
    title = f"Frequency response of axis {records[0].axis}"
    return Identified(
        "frequency-response",
        records[0].axis,
        tuple(record.source for record in records),
        {},
        None,
        weak < 0.9 * response.frequency.size and not doubts,
        (*response.findings, *low, *doubts),
        details={"method": response.method, "points": _json_points(response, unit)},
        lines=(response.method,),
        points=_point_table(response, unit),
        pictures=(Picture("bode", title, _bode_graphs(response, unit), response.method),),
    )


def identify_linear_motor(records: Sequence[AxisRecord], excitation: str = EXCITATIONS[0]) -> Identified:
    """Fit mass, damping and delay of a drive to its frequency response.

    Parameters
    ----------
    excitation : str
        Both as in `identify_response`.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted.
    """
    response = measured_response(records, excitation)
    fit, forces = fit_linear_motor(response), forces_of(records)
    uncertainty = propagated(records, fit, lambda x: plant_numbers(forces, 1.0 / x["M"], x["B"] / x["M"]) | {"drive.delay": x["delay"]})
    tables: Tables = {}
    if fit.usable:
        tables = rigid_tables(
            records,
            forces,
            1.0 / fit["M"],
            fit["B"] / fit["M"],
            uncertainty.origin,
            delay=fit["delay"],
            peak=largest_acceleration(records, fit),
        )
    return identified_drive("linear-motor", records, response, fit, tables, uncertainty)


def identify_two_inertia(
    records: Sequence[AxisRecord],
    side: str = "motor",
    lead: float | None = None,
    motor_inertia: float | None = None,
    excitation: str = EXCITATIONS[0],
) -> Identified:
    """Fit two inertias, their shaft, damping and delay of a drive to its frequency response.

    Parameters
    ----------
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``.
    lead : float [m], optional
        Travel per turn; required for an axis file.
    motor_inertia : float [kg m^2], optional
        Inertia of motor and screw, from a data sheet. The response at the load does not show it, and an axis file needs it. Used only with
        a lead and commands that are forces.
    excitation : str
        As in `identify_response`.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted; if the motor inertia is given with side "motor", or exceeds the
        total inertia.
    """
    if motor_inertia is not None and side == "motor":
        raise ParameterError("motor_inertia", f"{motor_inertia:g} kg*m^2", "omitted: with the position of the motor it is identified")
    response, unit = measured_response(records, excitation), records[0].unit
    fit = fit_two_inertia(response, side)
    if motor_inertia is not None and lead is not None and unit == "N" and fit.usable:
        arm = lead / (2.0 * math.pi)
        if motor_inertia >= fit["mass"] * arm**2:
            bound = f"below the total inertia of the response, {fit['mass'] * arm**2:.4g}"
            raise ParameterError("motor_inertia", f"{motor_inertia:.4g}", bound, "kg*m^2")
        fit = fit_load_share(response, fit, motor_inertia / arm**2)
    tables: Tables = {}
    uncertainty, findings = Propagated(), []
    missing = [] if lead is not None else [TRAVEL]
    missing += ["--motor-inertia, of motor and screw"] if side == "load" and motor_inertia is None else []
    missing += [] if unit == "N" else [newton_option(records[0].logged)]
    if fit.usable and missing:
        findings.append(finding("CL504", options=tuple(dict.fromkeys(missing))))
    elif fit.usable and lead is not None:
        note = "frequency response at the load, with the motor's inertia as given" if fit.given else "frequency response"
        uncertainty = propagated(records, fit, lambda x: two_inertia_numbers(lead, {**fit.given, **x}), note)
        peak = largest_acceleration(records, fit)
        tables = two_inertia_tables(records, lead, fit.parameters, fit.given, uncertainty.origin, peak)
    return identified_drive("two-inertia", records, response, fit, tables, uncertainty, findings)


def identify_two_mass(records: Sequence[AxisRecord], side: str = "motor", excitation: str = EXCITATIONS[0]) -> Identified:
    """Fit an axis with one structural resonance to its frequency response.

    Parameters
    ----------
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``. The response at the load does not show the load's share of the mass.
    excitation : str
        As in `identify_response`.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted.
    """
    response = measured_response(records, excitation)
    fit = fit_two_mass(response, side)
    tables: Tables = {}
    uncertainty, findings = Propagated(), []
    if fit.usable and records[0].unit != "N":
        findings.append(finding("CL504", options=(newton_option(records[0].logged),)))
    elif fit.usable:
        names = {"delay": "drive.delay"}
        uncertainty = propagated(records, fit, lambda x: {names.get(name, f"plant.{name}"): value for name, value in x.items()})
        tables = _two_mass_tables(records, fit, uncertainty, side)
    return identified_drive("two-mass", records, response, fit, tables, uncertainty, findings)


def _two_mass_tables(records: Sequence[AxisRecord], fit: DriveFit, uncertainty: Propagated, side: str) -> Tables:
    """Return the axis file: that of a rigid axis with the resonance, its encoder on the side measured."""
    mass, peak, origin = fit["mass"], largest_acceleration(records, fit), uncertainty.origin
    tables = dict(rigid_tables(records, forces_of(records), 1.0 / mass, fit["damping"] / mass, origin, delay=fit["delay"], peak=peak))
    plant: dict[str, Row] = {**tables["plant"], "kind": (TwoMass.kind, "", None)}
    plant |= {name: (fit[name], unit, origin(f"plant.{name}")) for name, unit in TWO_MASS_UNITS.items() if name in fit.parameters}
    if "load_share" not in fit.parameters:
        plant["load_share"] = (EQUAL, "", assumed("equal shares: the response at the load does not show them"))
    tables["plant"] = plant
    if side == "motor" and "sensor" in tables:
        tables["motor_sensor"] = tables.pop("sensor")
    return tables


def measured_response(records: Sequence[AxisRecord], excitation: str = EXCITATIONS[0]) -> MeasuredResponse:
    """Return position over command of an axis, measured by the method that fits the excitation, one of `EXCITATIONS`."""
    if excitation not in EXCITATIONS:
        raise ParameterError("--excitation", repr(excitation), f"one of {', '.join(EXCITATIONS)}")
    common_unit(records, "one response")
    runs = [_run(record, excitation) for record in records]
    excitations = [run.command if run.outside is None else run.outside for run in runs]
    if any(sine_stretch(excitation, run.period) is not None for excitation, run in zip(excitations, runs, strict=True)):
        return sine_responses(runs, [record.source for record in records])
    if len(runs) > 1:
        return spectral_response(runs)
    repeated = repeating(excitations[0])
    if repeated is not None:
        lap, stretch = repeated
        return periodic_response(runs[0].part(stretch), lap)
    return swept_response(runs[0]) if is_sweep(excitations[0]) else spectral_response(runs)


def _run(record: AxisRecord, excitation: str) -> Measured:
    # A moving reference means a closed loop. The reference, unlike the command, has no noise.
    closed = excitation == "reference" and record.reference is not None and np.ptp(record.reference) > 0.0
    with about(record.source):
        return Measured(record.period, record.driven(), record.position, record.reference if closed else None)


def propagated(
    records: Sequence[AxisRecord],
    fit: DriveFit,
    numbers: Callable[[Mapping[str, float]], Mapping[str, float]],
    note: str = "frequency response",
) -> Propagated:
    """Return the uncertainty of the parameters of an axis file that `numbers` computes from those of the fit."""
    of = fit.found
    return propagate(numbers, of.names, of.values, of.robust_deviations, of.correlation, reference_name(records), note)


def largest_acceleration(records: Sequence[AxisRecord], fit: DriveFit) -> float:
    """Return the largest acceleration [m/s^2] up to the fitted frequencies; above them encoder counts and noise dominate."""
    peaks = []
    for record in records:
        cutoff = min(BEYOND * float(fit.frequency[-1]), BELOW_NYQUIST / record.period)
        ends = math.ceil(1.0 / (cutoff * record.period))
        acceleration = filtered_motion(record.position, record.period, cutoff=cutoff).acceleration
        peaks.append(float(np.abs(acceleration[ends:-ends]).max(initial=0.0)))
    return max(peaks)


def identified_drive(
    model: str,
    records: Sequence[AxisRecord],
    response: MeasuredResponse,
    fit: DriveFit,
    tables: Tables,
    uncertainty: Propagated,
    findings: Sequence[Finding] = (),
) -> Identified:
    """Return the result of a model fitted to a response."""
    unit, estimate = records[0].unit, fit.found
    force = unit or "command"
    mass, loss = ("kg", "N*s/m") if unit == "N" else (f"{force}*s^2/m", f"{force}*s/m")
    units = dict.fromkeys(("M", "mass", "motor_mass", "load_mass"), mass) | dict.fromkeys(("B", "damping", "shaft_damping"), loss)
    units |= {"delay": "s", "stiffness": f"{force}/m"} | TWO_MASS_UNITS
    on_mass, possible = mass_findings(fit.whole_mass) if unit == "N" else ([], True)
    findings = [*response.findings, *fit.findings, *findings, *on_mass, *_turning_findings(records, response)]
    if unit != "N":
        findings.append(finding("CL503", unit=units["mass"], option=newton_option(records[0].logged)))
    fitted = f"fitted to {fit.frequency.size} points, {fit.frequency[0]:.4g} to {fit.frequency[-1]:.4g} Hz"
    return Identified(
        model,
        records[0].axis,
        tuple(record.source for record in records),
        figures(estimate.names, estimate.values, estimate.deviations, estimate.robust_deviations, units.__getitem__),
        fit.fit,
        fit.usable and possible,
        tuple(findings),
        details={"method": response.method, "condition_number": estimate.condition_number, "points": _json_points(response, unit)},
        lines=(response.method, fitted, *(_resonance_lines(fit) if model != "linear-motor" else ())),
        tables=tables,
        correlations=uncertainty.correlations if tables else (),
        pictures=_pictures(records[0].axis, model, response, fit, unit),
    )


def _resonance_lines(fit: DriveFit) -> tuple[str, ...]:
    """Return a line on resonance and antiresonance of two masses; none at the load, where the resonance is a parameter."""
    if "load_share" in fit.parameters:
        return (f"antiresonance {fit['resonance'] * math.sqrt(1.0 - fit['load_share']):.4g} Hz",)
    if "resonance" in fit.parameters:
        return ()
    resonance, antiresonance = resonances(fit.parameters)
    given = "".join(f", {name} {value:.4g} as given" for name, value in fit.given.items())
    ratio = damping_ratio(fit.parameters)
    return (f"resonance {resonance:.4g} Hz with a damping ratio of {ratio:.3g}, antiresonance {antiresonance:.4g} Hz{given}",)


def _turning_findings(records: Sequence[AxisRecord], response: MeasuredResponse) -> list[Finding]:
    """Return a finding on logs in which the axis reverses but no harmonics show its friction."""
    if not np.isnan(response.distortion).all():
        return []
    turning = []
    for record in records:
        stride = max(1, round(SMOOTHED / record.period))
        speed = np.diff(record.position[::stride])
        moving = speed[np.abs(speed) > SLOW * np.abs(speed).max()]
        if min(np.mean(moving > 0.0), np.mean(moving < 0.0)) > RARELY:
            turning.append(record.source)
    return [finding("CL506", logs=tuple(turning))] if turning else []


def _json_points(response: MeasuredResponse, unit: str) -> list[dict[str, Any]]:
    """Return the points for JSON: gain of the position [m per command], phase, relative deviation, coherence, distortion."""
    r = response
    columns = {
        "frequency": r.frequency,
        "gain": [abs(h) for h in r.response],
        "phase_deg": [np.degrees(np.angle(h)) for h in r.response],
        "relative_deviation": r.deviation,
        "coherence": r.coherence,
        "harmonic_distortion": r.distortion,
    }
    return [{"unit": f"m/{unit}" if unit else "m", **dict(zip(columns, row, strict=True))} for row in zip(*columns.values(), strict=True)]


def _point_table(response: MeasuredResponse, unit: str) -> Table:
    chosen = np.arange(response.frequency.size)
    if chosen.size > PRINTED:
        wanted = np.geomspace(response.frequency[0], response.frequency[-1], PRINTED)
        chosen = np.unique(np.searchsorted(response.frequency, wanted).clip(0, chosen.size - 1))
    heads = ("frequency [Hz]", f"velocity [mm/s/{unit or 'command'}]", "phase [deg]", "deviation [%]", "coherence", "harmonics [%]")
    table = Table([Column(head) for head in heads])
    for i in chosen:
        velocity, harmonics = response.velocity[i], response.distortion[i]
        table.add(
            f"{response.frequency[i]:.4g}",
            f"{1e3 * abs(velocity):.4g}",
            f"{np.degrees(np.angle(velocity)):.4g}",
            f"{100.0 * response.deviation[i]:.2g}",
            f"{response.coherence[i]:.3f}",
            "" if np.isnan(harmonics) else f"{100.0 * harmonics:.2g}",
        )
    return table


def _bode_graphs(response: MeasuredResponse, unit: str, model: tuple[Array, Complex] | None = None) -> tuple[Graph, ...]:
    """Return magnitude, phase and coherence over frequency, with the velocity response of a model if given."""
    f, velocity = response.frequency, response.velocity
    size, phase = 1e3 * np.abs(velocity), np.degrees(np.unwrap(np.angle(velocity)))
    gains: dict[str, Drawn] = {"measured": (f, size)}
    phases: dict[str, Drawn] = {"measured": (f, phase)}
    coherence: dict[str, Drawn] = {"coherence": (f, response.coherence)}
    if f.size <= FEW:
        gains = {"measured ± 2 deviations": (f, size, 2.0 * size * response.deviation)}
        phases = {"measured ± 2 deviations": (f, phase, np.degrees(2.0 * response.deviation))}
        coherence = {"coherence": (f, response.coherence, np.zeros(f.size))}
    if model is not None:
        turn = np.degrees(np.unwrap(np.angle(model[1])))
        turn += 360.0 * round((float(np.interp(f[0], model[0], turn)) - phase[0]) / -360.0)
        gains["model"] = (model[0], 1e3 * np.abs(model[1]))
        phases["model"] = (model[0], turn)
    return (
        Graph("frequency [Hz]", f"velocity [mm/s/{unit or 'command'}]", gains, log_x=True, log_y=True),
        Graph("frequency [Hz]", "phase [deg]", phases, log_x=True),
        Graph("frequency [Hz]", "coherence", coherence, log_x=True),
    )


def _pictures(axis: str, model: str, response: MeasuredResponse, fit: DriveFit, unit: str) -> tuple[Picture, ...]:
    f = np.geomspace(response.frequency[0], response.frequency[-1], MODEL_POINTS)
    velocity = 2j * np.pi * f * held_response(fit.transfer, f, response.period)
    ratio = fit.measured / fit.predicted

    def residual(key: str, unit: str, values: Array) -> Graph:
        of = fit.frequency
        drawn: Drawn = (of, values, np.zeros(of.size)) if of.size <= FEW else (of, values)
        return Graph("frequency [Hz]", f"{key} [{unit}]", {key: drawn}, log_x=True)

    left = residual("magnitude", "%", 100.0 * (np.abs(ratio) - 1.0)), residual("phase", "deg", np.degrees(np.angle(ratio)))
    return (
        Picture("bode", f"Frequency response of axis {axis}, {model}", _bode_graphs(response, unit, (f, velocity)), response.method),
        Picture("residual", "Residual of the response", left, "Size: measured over model, minus one. Phase: measured minus model."),
    )
