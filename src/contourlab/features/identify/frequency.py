"""Frequency response of an axis from logs of sines, a chirp, noise or a multisine, and drive models fitted to it; a resonance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from contourlab.analysis.identification import drive_fit
from contourlab.analysis.identification.drive_fit import DriveFit
from contourlab.analysis.identification.filtered_motion import filtered_motion
from contourlab.analysis.identification.frequency_response import Measured, MeasuredResponse, measured_response, response_findings
from contourlab.analysis.identification.least_squares import mass_findings
from contourlab.analysis.identification.resonance import identify_resonance
from contourlab.arrays import Array, Complex
from contourlab.components.plant.two_sided import TwoMass
from contourlab.errors import ParameterError
from contourlab.features.identify.axis_tables import forces_of, plant_numbers, rigid_tables, two_inertia_numbers, two_inertia_tables
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import TRAVEL, AxisRecord, common_unit, log_names, newton_option, reference_name
from contourlab.features.identify.result import Identification, Numbers, Propagated, Tables, assumed, figures, propagate
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table

PRINTED = 24
"""Largest number of points printed; the JSON has all."""
FEW = 40
"""Largest number of points drawn with their deviations."""
COHERENT = 0.5
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


def identify_response(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Measure the frequency response of an axis with coherence and deviations.

    Parameters
    ----------
    records : sequence of AxisRecord
        With command or force; in closed loop with the reference.

    Raises
    ------
    ResultError
        If a log has no command, or commands have different units.
    LogError
        If command or position of a record do not change; names the log.
    ParameterError
        If a record is too short, or its response is noise.
    """
    response, unit = _measured(records, options), records[0].unit
    weak = int(np.count_nonzero(response.coherence < COHERENT))
    low = [finding("CL507", limit=COHERENT, count=weak, points=response.frequency.size)] if weak else []
    doubts = response_findings(response)
    return Identification(
        "frequency-response",
        records[0].axis,
        log_names(records),
        {},
        None,
        weak < 0.9 * response.frequency.size and not doubts,
        (*response.findings, *low, *doubts),
        details={"method": response.method, "points": _json_points(response, unit)},
        lines=(response.method,),
        points=_point_table(response, unit),
        charts=(_bode(f"Frequency response of axis {records[0].axis}", response, unit),),
    )


def identify_linear_motor(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Fit mass, damping and delay of a drive to its frequency response.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted.
    """
    response = _measured(records, options)
    fit, forces = drive_fit.fit_linear_motor(response), forces_of(records)
    uncertainty = _propagated(records, fit, lambda x: plant_numbers(forces, 1.0 / x["M"], x["B"] / x["M"]) | {"drive.delay": x["delay"]})
    tables = _rigid_tables(records, fit, fit["M"], fit["B"], uncertainty) if fit.usable else {}
    return _identified("linear-motor", records, response, fit, tables, uncertainty)


def identify_two_inertia(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Fit two inertias, their shaft, damping and delay of a drive to its frequency response.

    An axis file needs the travel per turn, commands that are forces and, at the load, the inertia of motor and screw from a data sheet: the
    response at the load does not show it.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted; if the motor inertia is given with side "motor", or exceeds the
        total inertia.
    """
    side, lead, inertia = options.side, options.si("lead"), options.si("motor_inertia")
    if inertia is not None and side == "motor":
        raise ParameterError("motor_inertia", f"{inertia:g} kg*m^2", "omitted: with the position of the motor it is identified")
    response, unit = _measured(records, options), records[0].unit
    fit = drive_fit.fit_two_inertia(response, side)
    if inertia is not None and lead is not None and unit == "N" and fit.usable:
        arm = lead / (2.0 * math.pi)
        if inertia >= fit["mass"] * arm**2:
            bound = f"below the total inertia of the response, {fit['mass'] * arm**2:.4g}"
            raise ParameterError("motor_inertia", f"{inertia:.4g}", bound, "kg*m^2")
        fit = drive_fit.fit_load_share(response, fit, inertia / arm**2)
    missing = [] if lead is not None else [TRAVEL]
    missing += ["--motor-inertia, of motor and screw"] if side == "load" and inertia is None else []
    missing += [] if unit == "N" else [newton_option(records[0].logged)]
    if missing or not fit.usable:
        findings = [finding("CL504", options=tuple(dict.fromkeys(missing)))] if fit.usable else []
        return _identified("two-inertia", records, response, fit, {}, Propagated(), findings)
    note = "frequency response at the load, with the motor's inertia as given" if fit.given else "frequency response"
    uncertainty = _propagated(records, fit, lambda x: two_inertia_numbers(lead, {**fit.given, **x}), note)
    tables = two_inertia_tables(records, lead, fit.parameters, fit.given, uncertainty.origin, _largest_acceleration(records, fit))
    return _identified("two-inertia", records, response, fit, tables, uncertainty)


def identify_two_mass(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Fit an axis with one structural resonance to its frequency response; at the load it does not show the load's share of the mass.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted.
    """
    response = _measured(records, options)
    fit = drive_fit.fit_two_mass(response, options.side)
    if not fit.usable or records[0].unit != "N":
        findings = [finding("CL504", options=(newton_option(records[0].logged),))] if fit.usable else []
        return _identified("two-mass", records, response, fit, {}, Propagated(), findings)
    names = {"delay": "drive.delay"}
    uncertainty = _propagated(records, fit, lambda x: {names.get(name, f"plant.{name}"): value for name, value in x.items()})
    # The axis file is that of a rigid axis with the resonance, its encoder on the side measured.
    tables = dict(_rigid_tables(records, fit, fit["mass"], fit["damping"], uncertainty))
    plant = {**tables["plant"], "kind": (TwoMass.kind, "", None)}
    for name, unit in TWO_MASS_UNITS.items():
        given = (EQUAL, "", assumed("equal shares: the response at the load does not show them"))
        plant[name] = (fit[name], unit, uncertainty.origin(f"plant.{name}")) if name in fit.parameters else given
    tables["plant"] = plant
    if options.side == "motor" and "sensor" in tables:
        tables["motor_sensor"] = tables.pop("sensor")
    return _identified("two-mass", records, response, fit, tables, uncertainty)


def _rigid_tables(records: Sequence[AxisRecord], fit: DriveFit, mass: float, loss: float, uncertainty: Propagated) -> Tables:
    peak, origin = _largest_acceleration(records, fit), uncertainty.origin
    return rigid_tables(records, 1.0 / mass, loss / mass, origin, delay=fit["delay"], peak=peak)


def _measured(records: Sequence[AxisRecord], options: Identify) -> MeasuredResponse:
    """Return position over command of an axis; a moving reference means a closed loop, and it, unlike the command, has no noise."""
    common_unit(records, "one response")
    runs = []
    for record in records:
        closed = options.excitation == "reference" and record.reference is not None and np.ptp(record.reference) > 0.0
        with about(record.source):
            runs.append(Measured(record.period, record.driven(), record.position, record.reference if closed else None))
    return measured_response(runs, [record.source for record in records])


def _propagated(records: Sequence[AxisRecord], fit: DriveFit, numbers: Numbers, note: str = "frequency response") -> Propagated:
    return propagate(numbers, fit.estimate, reference_name(records), note)


def _largest_acceleration(records: Sequence[AxisRecord], fit: DriveFit) -> float:
    """Return the largest acceleration [m/s^2] up to the fitted frequencies; above them encoder counts and noise dominate."""
    peaks = []
    for record in records:
        cutoff = min(BEYOND * float(fit.frequency[-1]), BELOW_NYQUIST / record.period)
        ends = math.ceil(1.0 / (cutoff * record.period))
        acceleration = filtered_motion(record.position, record.period, cutoff=cutoff).acceleration
        peaks.append(float(np.abs(acceleration[ends:-ends]).max(initial=0.0)))
    return max(peaks)


def _identified(
    model: str,
    records: Sequence[AxisRecord],
    response: MeasuredResponse,
    fit: DriveFit,
    tables: Tables,
    uncertainty: Propagated,
    findings: Sequence[Finding] = (),
) -> Identification:
    """Return the result of a model fitted to a response."""
    unit, estimate = records[0].unit, fit.estimate
    force = unit or "command"
    mass, loss = ("kg", "N*s/m") if unit == "N" else (f"{force}*s^2/m", f"{force}*s/m")
    units = dict.fromkeys(("M", "mass", "motor_mass", "load_mass"), mass) | dict.fromkeys(("B", "damping", "shaft_damping"), loss)
    units |= {"delay": "s", "stiffness": f"{force}/m"} | TWO_MASS_UNITS
    on_mass, possible = mass_findings(fit.whole_mass) if unit == "N" else ([], True)
    findings = [*response.findings, *fit.findings, *findings, *on_mass, *_turning_findings(records, response)]
    if unit != "N":
        findings.append(finding("CL503", unit=mass, option=newton_option(records[0].logged)))
    points = f"fitted to {fit.frequency.size} points, {fit.frequency[0]:.4g} to {fit.frequency[-1]:.4g} Hz"
    return Identification(
        model,
        records[0].axis,
        log_names(records),
        figures(estimate, units),
        fit.fit,
        fit.usable and possible,
        tuple(findings),
        details={"method": response.method, "condition_number": estimate.condition_number, "points": _json_points(response, unit)},
        lines=(response.method, points, *(_resonance_lines(fit) if model != "linear-motor" else ())),
        tables=tables,
        correlations=uncertainty.correlations if tables else (),
        charts=_charts(f"Frequency response of axis {records[0].axis}, {model}", response, fit, unit),
    )


def _resonance_lines(fit: DriveFit) -> tuple[str, ...]:
    """Return a line on resonance and antiresonance of two masses; none at the load, where the resonance is a parameter."""
    if "load_share" in fit.parameters:
        return (f"antiresonance {fit['resonance'] * math.sqrt(1.0 - fit['load_share']):.4g} Hz",)
    if "resonance" in fit.parameters:
        return ()
    resonance, antiresonance = drive_fit.resonances(fit.parameters)
    given = "".join(f", {name} {value:.4g} as given" for name, value in fit.given.items())
    ratio = drive_fit.damping_ratio(fit.parameters)
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
    of = f"m/{unit}" if unit else "m"
    r, names = response, ("unit", "frequency", "gain", "phase_deg", "relative_deviation", "coherence", "harmonic_distortion")
    phases = [np.degrees(np.angle(h)) for h in r.response]
    rows = zip([of] * len(phases), r.frequency, map(abs, r.response), phases, r.deviation, r.coherence, r.distortion, strict=True)
    return [dict(zip(names, row, strict=True)) for row in rows]


def _point_table(response: MeasuredResponse, unit: str) -> Table:
    chosen = np.arange(response.frequency.size)
    if chosen.size > PRINTED:
        wanted = np.geomspace(response.frequency[0], response.frequency[-1], PRINTED)
        chosen = np.unique(np.searchsorted(response.frequency, wanted).clip(0, chosen.size - 1))
    heads = ("frequency [Hz]", f"velocity [mm/s/{unit or 'command'}]", "phase [deg]", "deviation [%]", "coherence", "harmonics [%]")
    columns = (response.frequency, response.velocity, response.deviation, response.coherence, response.distortion)
    rows = (
        (
            *(f"{frequency:.4g}", f"{1e3 * abs(velocity):.4g}", f"{np.degrees(np.angle(velocity)):.4g}"),
            *(f"{100.0 * deviation:.2g}", f"{coherence:.3f}", "" if np.isnan(harmonics) else f"{100.0 * harmonics:.2g}"),
        )
        for frequency, velocity, deviation, coherence, harmonics in zip(*(column[chosen] for column in columns), strict=True)
    )
    return Table([*map(Column, heads)], rows=rows)


def _bode(title: str, response: MeasuredResponse, unit: str, model: tuple[Array, Complex] | None = None) -> Chart:
    """Return magnitude, phase and coherence over frequency, with the velocity response of a model if given."""
    f, velocity, few = response.frequency, response.velocity, response.frequency.size <= FEW
    size, phase = 1e3 * np.abs(velocity), np.degrees(np.unwrap(np.angle(velocity)))
    measured = "measured ± 2 deviations" if few else "measured"

    def points(values: Array, half: Array) -> tuple[Array, ...]:
        return (f, values, half) if few else (f, values)

    gains = {measured: points(size, 2.0 * size * response.deviation)}
    phases = {measured: points(phase, np.degrees(2.0 * response.deviation))}
    if model is not None:
        turn = np.degrees(np.unwrap(np.angle(model[1])))
        turn += 360.0 * round((float(np.interp(f[0], model[0], turn)) - phase[0]) / -360.0)
        gains["model"], phases["model"] = (model[0], 1e3 * np.abs(model[1])), (model[0], turn)
    labels = "frequency [Hz]", f"velocity [mm/s/{unit or 'command'}]"
    below = {"phase [deg]": phases, "coherence": {"coherence": points(response.coherence, np.zeros(f.size))}}
    more: dict[str, Any] = {"caption": response.method, "level": None, "log_x": True, "log_y": True}
    return traces_chart("bode", title, labels, gains, below=below, **more)


def _charts(title: str, response: MeasuredResponse, fit: DriveFit, unit: str) -> tuple[Chart, ...]:
    f = np.geomspace(response.frequency[0], response.frequency[-1], MODEL_POINTS)
    velocity = 2j * np.pi * f * drive_fit.held_response(fit.transfer, f, response.period)
    ratio, of = fit.measured / fit.predicted, fit.frequency
    points = (np.zeros(of.size),) if of.size <= FEW else ()
    size, phase = {"magnitude": (of, 100.0 * (np.abs(ratio) - 1.0), *points)}, {"phase": (of, np.degrees(np.angle(ratio)), *points)}
    caption, labels = "Size: measured over model, minus one. Phase: measured minus model.", ("frequency [Hz]", "magnitude [%]")
    more: dict[str, Any] = {"caption": caption, "level": None, "log_x": True}
    return (
        _bode(title, response, unit, (f, velocity)),
        traces_chart("residual", "Residual of the response", labels, size, below={"phase [deg]": phase}, **more),
    )


# --- from an accelerometer alone ------------------------------------------------------------------------------------------------------

RESONANCE_UNITS = {"frequency": "Hz", "damping_ratio": "1"}


def identify_ringing(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify the largest resonance in the acceleration of an axis.

    Raises
    ------
    ParameterError
        See `contourlab.analysis.identification.resonance.identify_resonance`.
    """
    (record,) = records
    fit, title = identify_resonance(record.position, record.period), f"Acceleration of axis {record.axis}, {record.source}"
    band, largest = fit.spectrum_frequency, float(fit.predicted.max())
    spectra = {"measured": (band, fit.spectrum / largest), "model": (band, fit.predicted / largest)}
    chart = traces_chart("spectrum", title, ("frequency [Hz]", "power over the model's largest"), spectra, level=None, log_y=True)
    said = f"fitted from {figure(float(band[0]), 'Hz', 4)} to {figure(float(band[-1]), 'Hz', 4)}, {band.size} lines of the spectrum"
    head = "resonance", record.axis, (record.source,), figures(fit, RESONANCE_UNITS), None, fit.usable
    return Identification(*head, fit.findings, lines=(said,), charts=(chart,))
