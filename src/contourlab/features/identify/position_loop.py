"""Closed position loops of axes, from commanded and actual position alone: a machine and a controller that `run` predicts with.

The reference r arrives late by a delay, and perhaps through a resonance or another lag of second order. The loop is T p'' + p' =
K_v (r - p) + a r', a `step-drive`, with the velocity gain K_v, perhaps a share a of velocity feedforward, and perhaps the lag T of the
velocity loop. Friction may hold the axis back by an offset. A term stays only where it predicts parts of the log that it was not fitted
to.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.analysis.identification.descent import DescentSettings
from contourlab.analysis.identification.least_squares import Free, OutputFit, descended, deviation_findings
from contourlab.arrays import Array
from contourlab.components.controller.steps import Steps
from contourlab.components.drive.step_generator import PositionLag
from contourlab.components.friction.laws import Coulomb, NoFriction
from contourlab.components.origin import Origin
from contourlab.components.plant.stepper import StepDrive
from contourlab.errors import ResultError, refuse
from contourlab.features.identify.axis_tables import position_limits
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, log_names, samples_digest
from contourlab.features.identify.result import Identification, Row, Tables, figures, propagate
from contourlab.features.measure.measured_path import moving
from contourlab.features.measure.study import FOLLOWS, measure
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table
from contourlab.result import Result, Signal
from contourlab.study import Setting

TERMS = {
    "feedforward": ("velocity_feedforward",),
    "lag": ("lag",),
    "resonance": ("resonance", "resonance_damping"),
    "friction": ("friction_offset",),
}
"""What a loop may have besides gain and delay: the parameters of each."""
UNITS = {
    "Kv": "1/s",
    "delay": "s",
    "velocity_feedforward": "",
    "lag": "s",
    "resonance": "Hz",
    "resonance_damping": "",
    "friction_offset": "m",
}
CLEAR = 3.0
"""Least size of the first parameter of a term, in deviations."""
FULL = ("velocity_feedforward", 1.0)
"""A common choice, clear although it is at a bound and so has no deviation."""
RUN_IN = 0.5
"""Time [s] that is simulated before the log: at rest, or at its first speed."""
DESCENT = DescentSettings(difference=1e-3, visible=1e-3, most_iterations=200, least_gain=1e-7)
"""The model is smooth: steps of the differences may be short, and gain and delay are hard to tell apart."""
SCREENED = 25
"""Iterations from each start, before the best is followed to its end."""
BEFORE, AFTER = 0.1, 0.3
"""Time [s] before the first and after the last motion that counts."""
SUBSTEPS, FASTEST = 8, 0.25
"""Integration steps in a sample period, and the shortest lag of the velocity loop, in sample periods: it stands for a faster one."""
REVERSED = 1e-6
"""Least travel [m] each way of a reversal."""
LEAST = 30.0
"""Least share [percent] of the variation of the following error that the model of a loop explains."""
WELL = 0.3
"""Share of the following error that stays, from which there is a finding."""


@dataclass(frozen=True, eq=False)
class LoopModel:
    """The loop of one axis with some terms, along the commanded positions of a log."""

    record: AxisRecord
    terms: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters."""
        return ("Kv", "delay", *(name for term in self.terms for name in TERMS[term]))

    @cached_property
    def free(self) -> dict[str, Free]:
        """Parameters with bounds."""
        period = self.record.period
        every = {
            "Kv": Free(min(20.0, 0.1 / period), 0.2, 0.5 / period, 10.0),
            "delay": Free(2.0 * period, period, period + 0.2, period),
            "velocity_feedforward": Free(0.5, 0.0, 1.0, 0.5),
            "lag": Free(period, FASTEST * period, 0.2, period),
            "resonance": Free(0.05 / period, 0.002 / period, 0.4 / period, 0.02 / period),
            "resonance_damping": Free(0.7, 0.05, 3.0, 0.5),
            "friction_offset": Free(1e-6, 0.0, 1e-3, 1e-6),
        }
        return {name: every[name] for name in self.names}

    def axis(self, x: Mapping[str, float]) -> Axis:
        """Return the axis with parameters."""
        values: dict[str, dict[str, float]] = {"plant": {}, "drive": {}, "friction": {}}
        for place, value in self.numbers(x).items():
            slot, _, name = place.partition(".")
            values[slot][name] = float(value)
        friction = Coulomb(**values["friction"]) if values["friction"] else NoFriction()
        return Axis(self.record.axis, StepDrive(**values["plant"]), friction, PositionLag(**values["drive"]), substeps=SUBSTEPS)

    def numbers(self, x: Mapping[str, Any]) -> dict[str, Any]:
        """Return the parameters by their names in an axis file, in SI; values may be arrays."""
        period = self.record.period
        gain, lag = x["Kv"], x.get("lag", FASTEST * period)
        numbers = {
            "plant.natural_frequency": np.sqrt(gain / lag) / (2.0 * math.pi),
            "plant.damping_ratio": 0.5 / np.sqrt(gain * lag),
            "drive.delay": x["delay"] - period,
        }
        others = {
            "plant.velocity_feedforward": ("velocity_feedforward", 1.0),
            "drive.frequency": ("resonance", 1.0),
            "drive.damping_ratio": ("resonance_damping", 1.0),
            "friction.coulomb": ("friction_offset", StepDrive.parameters["load_stiffness"].default),
        }
        return numbers | {place: factor * x[name] for place, (name, factor) in others.items() if name in self.names}

    @cached_property
    def setting(self) -> Setting:
        """What is simulated: one axis along the reference, which begins before the log at the speed at which the log begins."""
        axis, controller = self.axis({name: part.start for name, part in self.free.items()}), AxisController(controller=Steps())
        reference = run_in(self.record.asked(), self.record.period)
        low, high = float(reference.min()) - 1.0, float(reference.max()) + 1.0
        along = Path(Line.many(np.array([[low]]), np.array([[high]])))
        motion = Reference.from_samples(reference[:, None], self.record.period, along, arc_length=np.zeros(reference.size))
        return Setting(Machine(axis.name, (axis,), self.record.period), Controller({axis.name: controller}), motion)

    def positions(self, points: Sequence[Mapping[str, float]]) -> Array:
        """Return the positions (m, n) [m] of m sets of parameters."""
        x = {name: np.array([point[name] for point in points]) for name in self.names}
        columns = {f"axes.{self.record.axis}.{place}": values for place, values in self.numbers(x).items()}
        batch = self.setting.batch(columns, keep=("position",), judge=False)
        return np.asarray(batch.signals["position"][-self.record.position.size :, 0].T)


def run_in(reference: Array, period: float) -> Array:
    """Return a reference (n,) preceded by a motion at the speed at which it begins."""
    before = np.arange(-round(RUN_IN / period), 0)
    return np.concatenate([reference[0] + before * (reference[1] - reference[0]), reference])


@dataclass(frozen=True, eq=False)
class Rung:
    """A fit with some terms.

    Attributes
    ----------
    stays, left_out : float
        Rms of what stays over rms of the following error: of the log, and of parts of it that were not fitted.
    """

    model: LoopModel
    fit: OutputFit
    stays: float
    left_out: float

    @property
    def known(self) -> list[tuple[str, float, float]]:
        """Parameters with their values and deviations: 0 at a bound, infinite if the log does not determine one."""
        return list(zip(self.fit.names, self.fit.values.tolist(), self.fit.robust_deviations.tolist(), strict=True))

    def betters(self, other: Rung) -> bool:
        """Return whether it predicts better than another, and shows clearly what it has in addition."""
        first = {TERMS[term][0] for term in self.model.terms if term not in other.model.terms}
        clear = (0.0 < CLEAR * deviation < abs(value) or (name, value) == FULL for name, value, deviation in self.known if name in first)
        return self.left_out < other.left_out and all(clear)


_LAGS = (), ("lag",), ("resonance",)
LADDER = tuple((*feedforward, *lag) for feedforward in ((), ("feedforward",)) for lag in _LAGS)
"""Terms that are tried; then friction, where the axis reverses."""


def fit_loop(record: AxisRecord) -> tuple[Rung, tuple[Rung, ...]]:
    """Fit the loop of an axis; return the best fit, and all."""
    rungs = [fit_terms(LoopModel(record))]
    best = rungs[0]
    for terms in LADDER[1:]:
        within = [rung for rung in rungs if {*rung.model.terms} <= {*terms}]
        rungs.append(fit_terms(LoopModel(record, terms), within[-1]))
        best = rungs[-1] if rungs[-1].betters(best) else best
    if reverses(record):
        rungs.append(fit_terms(LoopModel(record, (*best.model.terms, "friction")), best))
        best = rungs[-1] if rungs[-1].betters(best) else best
    if "friction" in best.model.terms:  # what another term made up for before
        for terms in (tuple(one for one in best.model.terms if one != other) for other in best.model.terms[:-1]):
            rungs.append(fit_terms(LoopModel(record, terms), best))
            best = best if best.betters(rungs[-1]) else rungs[-1]
    return best, tuple(rungs)


def reverses(record: AxisRecord) -> bool:
    """Return whether the commanded motion changes its direction, by more than the resolution of the position."""
    steps = np.diff(record.asked())
    ways = np.sign(steps[steps != 0.0])
    turns = np.append(0, np.flatnonzero(np.diff(ways)) + 1)
    return bool(np.count_nonzero(np.abs(np.add.reduceat(steps[steps != 0.0], turns)) > REVERSED) > 1)


def fit_terms(model: LoopModel, near: Rung | None = None) -> Rung:
    """Fit a model from some starts, one of them at the parameters of a simpler model."""
    record, counts = model.record, counting(model.record)

    def output(points: Sequence[Mapping[str, float]]) -> Array:
        late = record.asked() - model.positions(points)
        return np.asarray(late[:, counts] - late[:, counts].mean(axis=1, keepdims=True))  # a constant is that of the encoder's zero

    late = (record.asked() - record.position)[counts]

    def fitted(starts: Array, iterations: int) -> OutputFit:
        settings = replace(DESCENT, most_iterations=iterations)
        return descended(output, late - late.mean(), model.free, starts, settings, equal_information=True)[0]

    fit = fitted(fitted(_starts(model, near), SCREENED).values[None], DESCENT.most_iterations)
    size = float(np.sqrt(np.mean(late**2)))
    return Rung(model, fit, float(np.sqrt(np.mean((fit.measured - fit.predicted) ** 2))) / size, fit.left_out / size)


def _starts(model: LoopModel, near: Rung | None) -> Array:
    """Return some starts of a model's parameters (k, p)."""
    known = {name: part.start for name, part in model.free.items()} | ({} if near is None else near.fit.parameters)
    others: Sequence[dict[str, float]] = [{}]
    if model.terms[-1:] == ("feedforward",):
        speed = np.gradient(model.record.asked(), model.record.period)
        lag = float(speed @ (model.record.asked() - model.record.position) / (speed @ speed))
        others = [{}, {"Kv": 25.0, "velocity_feedforward": 0.95, "delay": lag - 0.05 / 25.0}]
    elif model.terms[-1:] == ("resonance",):
        others = [{"resonance": share / model.record.period} for share in (0.03, 0.08, 0.2)]
    return np.array([[np.clip({**known, **other}[name], part.low, part.high) for name, part in model.free.items()] for other in others])


def counting(record: AxisRecord) -> slice:
    """Return the samples from shortly before the first motion to shortly after the last."""
    first, last = moving(record.asked()[:, None])
    return slice(max(first - round(BEFORE / record.period), 0), last + round(AFTER / record.period))


# --- the answer ----------------------------------------------------------------------------------------------------------------------


def identify_position_loop(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify the closed position loops of axes.

    Parameters
    ----------
    records : sequence of AxisRecord
        With reference and position: one for each axis, and perhaps another of the same axis, for validation.

    Raises
    ------
    ResultError
        If a log lacks a signal, does not move, or a position does not follow its reference.
    """
    fitted: dict[str, AxisRecord] = {}
    second: list[AxisRecord] = []
    for record in records:
        if record.axis not in fitted:
            check_follows(record)
            fitted[record.axis] = record
        elif np.ptp(record.asked()) > 0.0:
            second.append(record)
    refuse(len(records) > len(fitted) and not second, ResultError, f"no axis moves in {records[-1].source}: it validates nothing")
    fits = {axis: fit_loop(record) for axis, record in fitted.items()}
    best = {axis: rung for axis, (rung, _) in fits.items()}
    runs = [_predicted(best, ones) for ones in (list(fitted.values()), second) if ones]
    findings = [doubt for axis, (rung, rungs) in fits.items() for doubt in _doubts(rung, rungs, runs[0]["axes"][axis]["stays"])]
    usable = not any(doubt.entry.severity == "error" for doubt in findings)
    findings += [finding("CL516", one.source) for one in second[:1] if samples_digest([one]) == samples_digest([fitted[one.axis]])]
    alone = len(best) == 1
    known = {axis: figures(rung.fit, UNITS) for axis, rung in best.items() if usable}
    parameters = {name if alone else f"{name} {axis}": one for axis, of_axis in known.items() for name, one in of_axis.items()}
    terms = [
        {"axis": axis, "terms": rung.model.terms, "stays": rung.stays, "left_out": rung.left_out, "chosen": rung is best[axis]}
        for axis, (_, rungs) in fits.items()
        for rung in rungs
    ]
    return Identification(
        "position-loop",
        ", ".join(best),
        log_names(list(fitted.values())),
        parameters,
        min(rung.fit.fit for rung in best.values()),
        usable,
        tuple(findings),
        details={"terms": terms, "runs": runs},
        lines=tuple(line for run in runs for line in _lines(run)),
        points=_table(fits),
        tables=_machine_tables(best) if usable else {},
        controller={f"controller.axes.{axis}": {"controller": (Steps.kind, "", None)} for axis in best if usable},
        charts=tuple(_chart(rung) for rung in best.values()),
    )


def check_follows(record: AxisRecord) -> None:
    """Raise if a position does not follow its reference."""
    asked = record.asked()
    late, of_axis = asked - record.position, f"{record.axis} in {record.source}"
    refuse(not np.ptp(asked) > 0.0, ResultError, f"the reference of {of_axis} does not move: it is the same at all samples")
    refuse(not np.ptp(late) > 0.0, ResultError, f"the position of {of_axis} is its reference: nothing of the loop shows")
    if np.var(late) > (1.0 - FOLLOWS) * np.var(asked):
        wanted = "are column, unit and direction right? A minus ahead of the column's name turns its sign"
        raise ResultError(f"the position of {of_axis} does not follow its reference: {wanted}")


def _doubts(best: Rung, rungs: Sequence[Rung], stays: float) -> Iterator[Finding]:
    """Yield findings on what the log does not tell of an axis; `stays` is the share of the following error that stays in a prediction."""
    record = best.model.record
    axis = f"axis {record.axis}"
    said_little = best.fit.fit < LEAST
    if unknown := [name for name, _, deviation in best.known if said_little or not math.isfinite(deviation)]:
        yield finding("CL591", axis, parameters=unknown)
        return
    if stays > WELL:
        yield finding("CL594", axis, stays=stays)
    for name, value, deviation in best.known:
        if deviation != 0.0:
            yield from deviation_findings(f"{axis}, {name}", value, deviation)
        elif (name, value) != FULL:
            yield finding("CL595", axis, parameter=name, value=value, unit=UNITS[name])
    for term in TERMS:
        tried = [rung.left_out for rung in rungs if term in rung.model.terms]
        if not tried or term in best.model.terms or (term == "lag" and "resonance" in best.model.terms):
            continue
        if best.left_out <= (left := min(tried)) < math.inf:
            yield finding("CL592", axis, term=term, left=left, without=best.left_out)
        else:
            yield finding("CL596", axis, term=term)
    if not reverses(record):
        yield finding("CL593", axis)


def _predicted(best: Mapping[str, Rung], records: Sequence[AxisRecord]) -> dict[str, Any]:
    """Return how well the loops predict a log: of each axis the following error and what stays, and the contour error of all."""
    model = [replace(best[one.axis].model, record=one).positions([best[one.axis].fit.parameters])[0] for one in records]
    axes = {}
    for one, position in zip(records, model, strict=True):
        late, left = one.asked() - one.position, one.position - position
        rms = float(np.sqrt(np.mean(late**2)))
        axes[one.axis] = {"following_error": rms, "stays": float(np.sqrt(np.mean(left**2))) / rms}
    run: dict[str, Any] = {"log": records[0].source, "axes": axes, "contour_error": None}
    if len(records) > 1 and len({(one.start, one.position.size) for one in records}) == 1:
        measured = [one.position for one in records]
        run["contour_error"] = {name: _contour(records, positions) for name, positions in (("measured", measured), ("predicted", model))}
    return run


def _contour(records: Sequence[AxisRecord], positions: Sequence[Array]) -> dict[str, float]:
    """Return rms and largest contour error [m] of positions along the reference of a log."""
    columns = {"reference": [one.asked() for one in records], "position": positions}
    signals = {name: Signal(np.column_stack(values), ("sample", "axis"), "m") for name, values in columns.items()}
    error = measure(Result("loop", tuple(one.axis for one in records), records[0].period, signals)).metrics.contour_error
    return {"rms": error.rms, "largest": error.max}


def _lines(run: Mapping[str, Any]) -> Iterator[str]:
    for axis, of_axis in run["axes"].items():
        yield f"{run['log']}, {axis}: following error {1e6 * of_axis['following_error']:.4g} um rms, {of_axis['stays']:.3%} stays"
    if (errors := run["contour_error"]) is not None:
        shown = (f"{name} {1e6 * error['rms']:.4g} um rms, {1e6 * error['largest']:.4g} um at most" for name, error in errors.items())
        yield f"{run['log']}, contour error: {'; '.join(shown)}"


def _table(fits: Mapping[str, tuple[Rung, Sequence[Rung]]]) -> Table:
    """Return what each term buys."""
    heads = [Column("axis", left=True), Column("gain, delay and", left=True), Column("stays [%]"), Column("not fitted [%]"), Column("")]
    rows = [
        (axis, ", ".join(rung.model.terms) or "-", *map(_percent, (rung.stays, rung.left_out)), "chosen" if rung is best else "")
        for axis, (best, rungs) in fits.items()
        for rung in rungs
    ]
    return Table(heads, rows=rows)


def _percent(share: float) -> str:
    return f"{100.0 * share:.3f}" if math.isfinite(share) else "-"


def _chart(rung: Rung) -> Chart:
    """Return the following error of an axis with the model's, and what stays."""
    record, fit = rung.model.record, rung.fit
    time, measured, model = record.time[counting(record)], 1e6 * fit.measured, 1e6 * fit.predicted
    both, below = {"measured": (time, measured), "model": (time, model)}, {"stays [um]": {"measured - model": (time, measured - model)}}
    labels = "time [s]", "following error [um]"
    return traces_chart(f"following-{record.axis}", f"Following error of axis {record.axis}, {record.source}", labels, both, below=below)


FILED = {
    "plant": (StepDrive.kind, {"natural_frequency": "Hz", "damping_ratio": "", "velocity_feedforward": ""}),
    "drive": (PositionLag.kind, {"delay": "s", "frequency": "Hz", "damping_ratio": ""}),
    "friction": (Coulomb.kind, {"coulomb": "N"}),
}
"""What a machine file has of a loop: kinds, parameters and their units."""


def _machine_tables(best: Mapping[str, Rung]) -> Tables:
    """Return the tables of a machine file."""
    first = next(iter(best.values())).model.record
    period = Origin("measured", reference=first.source, note="sample period of the log")
    machine: dict[str, Row] = {"name": ("position loops", "", None), "axes": (list(best), "", None)}
    tables: Tables = {"machine": {**machine, "servo_period": (first.period, "s", period)}}
    for axis, rung in best.items():
        place = f"axes.{axis}"
        of = propagate(rung.model.numbers, rung.fit, rung.model.record.source, "closed position loop")
        tables[place] = {"substeps": (SUBSTEPS, "", None), "correlations": ([list(pair) for pair in of.correlations], "", None)}
        values = rung.model.numbers(rung.fit.parameters)
        for slot, (kind, units) in FILED.items():
            names = [name for name in units if f"{slot}.{name}" in values]
            rows = {name: (float(values[f"{slot}.{name}"]), units[name], of.origin(f"{slot}.{name}")) for name in names}
            tables |= {f"{place}.{slot}": {"kind": (kind, "", None), **rows}} if rows else {}
        tables[f"{place}.limits"] = position_limits(rung.model.record)
    return tables
