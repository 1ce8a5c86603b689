"""The frequency response of an axis out of logs with sines, a chirp, random noise or a multisine in them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.frequency_response import (
    Measured,
    MeasuredResponse,
    is_sweep,
    period_of,
    periodic_response,
    response_doubts,
    spectral_response,
    swept_response,
)
from contourlab.analysis.identification.sine_response import sine_responses, sine_stretch
from contourlab.features.identify.finding import Drawn, Finding, Graph, Picture
from contourlab.features.identify.signals import AxisRecord, one_unit
from contourlab.logs.error_context import about

Complex = NDArray[np.complex128]
SHOWN = 24
"""Points that are printed; all are in the JSON."""
FEW = 40
"""Points up to which each is drawn with its deviation."""
COHERENT = 0.5


def measured_response(records: Sequence[AxisRecord]) -> MeasuredResponse:
    """Return position over command of an axis, by the method that its excitation asks for.

    Parameters
    ----------
    records : sequence of AxisRecord
        With the command, or the force; where the loop was closed with the reference.

    Raises
    ------
    ResultError
        If a log has no command, or commands are in different units.
    LogError
        If command or position of a record do not change; says which.
    ParameterError
        If a record is too short, or has nothing that can be trusted.
    """
    one_unit(records, "one response")
    runs = [_run(record) for record in records]
    excitations = [run.command if run.outside is None else run.outside for run in runs]
    if any(sine_stretch(excitation, run.period) is not None for excitation, run in zip(excitations, runs, strict=True)):
        return sine_responses(runs, [record.source for record in records])
    if len(runs) > 1:
        return spectral_response(runs)
    repeats = period_of(excitations[0])
    if repeats is not None:
        return periodic_response(runs[0], repeats)
    return swept_response(runs[0]) if is_sweep(excitations[0]) else spectral_response(runs)


def _run(record: AxisRecord) -> Measured:
    with about(record.source):
        return Measured(record.period, record.driven(), record.position, _outside(record))


def _outside(record: AxisRecord) -> Any:
    """Return the reference where it moves: the loop is closed then, and it is what is free of noise."""
    return None if record.reference is None or not np.ptp(record.reference) > 0.0 else record.reference


def response_points(found: MeasuredResponse, unit: str) -> list[dict[str, Any]]:
    """Return the points for JSON: gain of the position [m per command], phase, relative deviation, coherence, distortion."""
    return [
        {
            "frequency": float(f),
            "gain": float(abs(h)),
            "unit": f"m/{unit}" if unit else "m",
            "phase_deg": float(np.degrees(np.angle(h))),
            "relative_deviation": float(d),
            "coherence": float(c),
            "harmonic_distortion": None if np.isnan(t) else float(t),
        }
        for f, h, d, c, t in zip(found.frequency, found.response, found.deviation, found.coherence, found.distortion, strict=True)
    ]


def identify_response(records: Sequence[AxisRecord]) -> Finding:
    """Return the frequency response of an axis with coherence and deviations.

    Parameters
    ----------
    records : sequence of AxisRecord

    Raises
    ------
    ResultError, ParameterError
        As of `measured_response`.
    """
    found = measured_response(records)
    unit = records[0].unit
    weak = int(np.count_nonzero(found.coherence < COHERENT))
    remarks = list(found.remarks)
    if weak:
        remarks.append(
            f"{weak} of {found.frequency.size} points have a coherence below {COHERENT:g}: noise, friction or too little excitation"
        )
    doubts = response_doubts(found)
    remarks += doubts
    usable = weak < 0.9 * found.frequency.size and not doubts
    chart = Picture("bode", f"Frequency response of axis {records[0].axis}", bode_graphs(found, unit), found.method)
    return Finding(
        "frequency-response",
        records[0].axis,
        tuple(record.source for record in records),
        (),
        None,
        usable,
        tuple(remarks),
        pictures=(chart,),
        lines=(found.method, *_table(found, unit)),
        more={"method": found.method, "points": response_points(found, unit)},
    )


def _table(found: MeasuredResponse, unit: str) -> tuple[str, ...]:
    chosen = np.arange(found.frequency.size)
    if chosen.size > SHOWN:
        wanted = np.geomspace(found.frequency[0], found.frequency[-1], SHOWN)
        chosen = np.unique(np.searchsorted(found.frequency, wanted).clip(0, chosen.size - 1))
    rows = [f"frequency [Hz]  velocity [mm/s/{unit or 'command'}]  phase [deg]  deviation  coherence  harmonics"]
    for i in chosen:
        harmonics = "" if np.isnan(found.distortion[i]) else f"{100.0 * found.distortion[i]:.2g} %"
        gain, phase = 1e3 * abs(found.velocity[i]), np.degrees(np.angle(found.velocity[i]))
        deviation = f"{100.0 * found.deviation[i]:.2g} %"
        rows.append(f"{found.frequency[i]:14.4g}  {gain:16.4g}  {phase:11.4g}  {deviation:>9}  {found.coherence[i]:9.3f}  {harmonics:>9}")
    return tuple(rows)


def bode_graphs(found: MeasuredResponse, unit: str, model: tuple[NDArray[np.float64], Complex] | None = None) -> tuple[Graph, ...]:
    """Return magnitude, phase and coherence over frequency, with a model's curve where there is one.

    Parameters
    ----------
    found : MeasuredResponse
    unit : str
        Of the command.
    model : (frequency, velocity response), optional
    """
    f, velocity = found.frequency, found.velocity
    size, phase = 1e3 * np.abs(velocity), np.degrees(np.unwrap(np.angle(velocity)))
    gains: dict[str, Drawn] = {"measured": (f, size)}
    phases: dict[str, Drawn] = {"measured": (f, phase)}
    alike: dict[str, Drawn] = {"coherence": (f, found.coherence)}
    if f.size <= FEW:
        gains = {"measured, two deviations": (f, size, 2.0 * size * found.deviation)}
        phases = {"measured, two deviations": (f, phase, np.degrees(2.0 * found.deviation))}
        alike = {"coherence": (f, found.coherence, np.zeros(f.size))}
    if model is not None:
        turn = np.degrees(np.unwrap(np.angle(model[1])))
        turn += 360.0 * round((float(np.interp(f[0], model[0], turn)) - phase[0]) / -360.0)
        gains["model"] = (model[0], 1e3 * np.abs(model[1]))
        phases["model"] = (model[0], turn)
    return (
        Graph("frequency [Hz]", f"velocity [mm/s/{unit or 'command'}]", gains, log_x=True, log_y=True),
        Graph("frequency [Hz]", "phase [deg]", phases, log_x=True),
        Graph("frequency [Hz]", "coherence", alike, log_x=True),
    )
