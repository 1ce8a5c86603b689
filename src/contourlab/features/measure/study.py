"""Judge a measured run with the same figures as a simulation."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from contourlab.arrays import Array, Flags, Index, true_spans
from contourlab.errors import ResultError, refuse
from contourlab.features.measure.causes import measured_causes
from contourlab.features.measure.measured_path import farthest, fitted_shift, last_lap, moving, path_of_samples, progress_along, size_of
from contourlab.features.measure.plausibility import columns_of, motion_findings, period_findings, same_column_findings
from contourlab.features.run.outcome import judged_spikes
from contourlab.features.run.verdict import unexplained
from contourlab.feed import Reference
from contourlab.feed.reference import CUTTING, RAPIDS, Judged
from contourlab.feed.route import Correspondence, Route
from contourlab.findings import Finding, finding
from contourlab.geometry import Path
from contourlab.logs import Log
from contourlab.logs.clock import EVEN
from contourlab.metrics.circles import circles_of
from contourlab.metrics.figures import AxisFigures, Metrics, summarise
from contourlab.metrics.judge import judge
from contourlab.rendering.data import JudgedRun
from contourlab.result import Result, Signal
from contourlab.scenario.placing import placed

ACTUAL = ("tool_position", "position", "axis_position")
"""Signals for the tool position, the best first; a measured log has encoder positions only."""
STILL = 1e-9
"""Distance [m] beyond the ends of a path from which the tool counts as off the path; smaller errors count as zero."""
NO_REFERENCE = {"reference": "places on the path"}
"""Attribute of a result whose log has no reference; it has no tracking error."""
NEXT_TO = 1e-12
"""Distance [m] by which a sample counts as before the place where it is."""
RISE = 1e-13
"""Least step [m] between places of successive samples on the programmed path, so that they rise."""
COARSE = 0.5
"""Share of the largest contour error by which the path may bulge between two samples."""
FOLLOWS = 0.5
"""Smallest share of the reference's variance that the position of an axis must follow."""


@dataclass(frozen=True, eq=False)
class Measured(JudgedRun):
    """A measured run, judged.

    Attributes
    ----------
    shift : dict of str to float [m], or None
        Shift of the path in the coordinates of the log, by axis.
    """

    shift: dict[str, float] | None = None


def measure(
    result: Result,
    route: Route | None = None,
    axes: tuple[str, ...] | None = None,
    *,
    shift: Array | Literal["fit"] | None = None,
    lines: Index | None = None,
    rapid: Flags | None = None,
    tolerance: float | None = None,
    program: tuple[str, ...] = (),
) -> Measured:
    """Judge a measured run.

    Parameters
    ----------
    result : Result
        With a position, one of `ACTUAL`; and ``reference`` unless a route is given.
    route : Route, optional
        The part program: its cutting moves are judged. By default the path through the samples of the reference is.
    axes : tuple of str, optional
        Axes of the contour, in the order of the path's coordinates; by default all.
    shift : ndarray (n_axis,) [m] or "fit", optional
        Zero of the path in the coordinates of the result; ``"fit"`` for the shift closest to the commanded positions, or else to the tool.
    lines : ndarray (n_sample,) of int, optional
        Program line at each sample; a route has its own.
    rapid : ndarray (n_sample,) of bool, optional
        Whether the log says of each sample that it is of a rapid move.
    tolerance : float [m], optional
        Largest part error that passes; by default there is no verdict.
    program : tuple of str
        Lines of the part program.

    Raises
    ------
    ResultError
        If a signal is missing or not finite, nothing moves, the tool is far from the path, a shift is given without a path, or a tolerance
        without any cutting move.

    Notes
    -----
    A reference in the result is what the control commanded: its distance from the program is the planning deviation.
    """
    run = _of_axes(result, axes or result.axes)
    position, *asked = _signals_of(run, route)
    findings = [*period_findings(result.servo_period), *motion_findings(position, result.servo_period)]
    period, of_axes, of_time, shifts, cutting = result.servo_period, ("sample", "axis"), ("sample",), None, None
    if route is None:
        if shift is not None:
            raise ResultError("a shift needs a part program: the reference in the log already has the coordinates of the log")
        reference = asked[0]
        motion = _followed(reference, period, lines)
    else:
        is_commanded = "reference" in run and bool(np.isfinite(run["reference"]).all())
        followed = run["reference"] if is_commanded else position
        begin, curve = _first_cut(route, lines, followed)
        programmed, of_curves, rapid = Path(route.path.curves[curve:]), route.source_line[curve:], route.rapid[curve:]
        if shift is not None:
            cut = float(programmed.breaks[np.argmin(rapid)])
            move = fitted_shift(programmed, followed[begin:], is_commanded=is_commanded, cut=cut) if isinstance(shift, str) else shift
            findings += [finding("CL406")] if isinstance(shift, str) and not is_commanded else []
            programmed, shifts = placed(programmed, move.tolist()), dict(zip(run.axes, move.tolist(), strict=True))
        place, distance = progress_along(programmed, followed[begin:])
        if begin:
            way, along = path_of_samples(np.vstack([followed[: begin - 1], programmed.position([0.0])]))
            programmed, place = Path([*way.curves, *programmed.curves]), np.append(along, way.length + place)
            of_curves, rapid = (np.append([first] * len(way.curves), own) for first, own in ((0, of_curves), (True, rapid)))
        curves = programmed.curve_index(np.maximum(place - NEXT_TO, 0.0))
        cutting = ~rapid[curves]
        if begin and lines is not None:
            cutting &= np.isin(lines, of_curves[~rapid])
        else:
            lines = of_curves[curves]
        if is_commanded:
            reference = followed
            motion = _followed(reference, period, lines, programmed, place)
        else:
            findings.append(finding("CL407", distance=float(distance)))
            reference, run = programmed.position(place), replace(run, attributes={**run.attributes, **NO_REFERENCE})
            motion = Reference.from_samples(reference, period, programmed, arc_length=place, source_lines=of_curves)
    along = motion.block(0, motion.n_sample).arc_length
    if is_known := not NO_REFERENCE.items() <= run.attributes.items():
        findings += _reference_findings(run.axes, reference, position)
    simulated = run.with_signals(
        tool_position=Signal(position, of_axes, "m"),
        reference=Signal(reference, of_axes, "m"),
        arc_length=Signal(along, of_time, "m"),
        feedrate=Signal(np.abs(np.gradient(along, period)), of_time, "m/s"),
        reference_velocity=Signal(np.gradient(reference, period, axis=0), of_axes, "m/s"),
    )
    judged, window = judge(simulated, motion), moving(reference)
    stated = _stated(run)
    if is_known:
        begin, end = window
        window, left_out = _on_the_path(judged, motion, window)
        if stated is not None:
            kept = window[0] if window[0] > begin else 0, window[1] if window[1] < end else run.n_sample
            ranges = ((max(first, kept[0]), min(last, kept[1])) for first, last in stated.ranges)
            stated = stated._replace(ranges=tuple(part for part in ranges if part[0] < part[1]) or (window,))
        findings += [finding("CL408", samples=left_out)] if left_out else []
        findings += _last_lap_findings(judged, motion, window) if route is None else []
        _check_near(judged, motion.path, window)
    findings += _outlier_findings(judged, window)
    part = stated or _part(window, cutting, rapid)
    if part.basis == RAPIDS:
        cure = "choose another --window, or omit the tolerance"
        refuse(tolerance is not None, ResultError, f"no cutting move is among the samples, and rapid moves have no tolerance: {cure}")
        findings.append(finding("CL418"))
    motion = replace(motion, chosen=part)
    judged = replace(judged, motion=motion)
    metrics = _known_metrics(summarise(judged, motion, part), run, None if stated else window)
    verdict = None if tolerance is None else unexplained(motion, judged, tolerance, program, is_whole=stated is not None)
    if verdict is not None and is_known:
        verdict = replace(verdict, causes=measured_causes(motion, judged, verdict.worst.sample))
    if is_known and stated is None:
        findings += _sampling_findings(reference[slice(*window)], metrics.contour_error.max)
    circles, spikes = circles_of(judged, motion), judged_spikes(judged, motion)
    return Measured(run.scheme, motion, judged, metrics, verdict, circles, spikes, tuple(findings), shift=shifts)


def _first_cut(route: Route, lines: Index | None, followed: Array) -> tuple[int, int]:
    """Return the sample and the curve of the first cutting move, if the log moves before and has its line; else 0 and 0.

    Where an approach comes from, no program says: the log does.
    """
    curve = int(np.argmin(route.rapid))
    begin = 0 if lines is None or route.rapid[curve] else int(np.argmax(lines == route.source_line[curve]))
    return (begin, curve) if begin > 1 and np.ptp(followed[:begin], axis=0).any() else (0, 0)


def _followed(
    reference: Array, period: float, lines: Index | None, programmed: Path | None = None, place: Array | None = None
) -> Reference:
    """Return the motion along the path through commanded samples (n, n_axis) [m], with their program lines (n,).

    They correspond to places (n,) [m] on a programmed path, if there is one. A sample where two curves meet belongs to the first.
    """
    path, along = path_of_samples(reference, lines)
    own: dict[str, Any] = {"arc_length": np.maximum(along - NEXT_TO, 0.0), "programmed": programmed}
    if lines is not None:
        middles = np.searchsorted(along, 0.5 * (path.breaks[1:] + path.breaks[:-1]))
        own["source_lines"] = lines[middles.clip(0, len(along) - 1)]
    if place is not None:
        new = np.append(True, np.diff(along) > 0.0)
        own["correspondence"] = Correspondence(along[new], place[new] + RISE * np.arange(np.count_nonzero(new)))
    return Reference.from_samples(reference, period, path, **own)


def _part(window: tuple[int, int], cutting: Flags | None, rapid: Flags | None) -> Judged:
    """Return the samples to judge: the cutting ones of the window, or all of it if it has none, or none is known to be rapid."""
    inside = slice(*window)
    if (cutting is not None and not cutting[inside].any()) or (cutting is None and rapid is not None and rapid[inside].all()):
        return Judged((window,), RAPIDS)
    if cutting is None or cutting[inside].all():
        return Judged((window,), "moving part")
    return Judged(tuple((window[0] + start, window[0] + stop) for start, stop in true_spans(cutting[inside])), CUTTING)


def _check_near(judged: Result, path: Path, window: tuple[int, int]) -> None:
    """Refuse a tool that is far off the path of its reference, as with exchanged columns or different units."""
    off, size = float(np.sqrt(np.mean(judged["contour_error"][slice(*window)] ** 2))), size_of(path)
    moved = float(np.ptp(judged["tool_position"], axis=0).max())
    if off > farthest(min(size, moved)):
        sizes = f"{off * 1e3:.4g} mm rms, on a path of {size * 1e3:.4g} mm in size, and moves by {moved * 1e3:.4g} mm"
        cure = "do position and reference have the right columns, axes, coordinates and units?"
        raise ResultError(f"the tool is off the path of its reference by {sizes}: {cure}")


def gap_findings(log: Log, measured: Measured, *, of_samples: bool) -> list[Finding]:
    """Return a finding if the largest contour error lies where samples are missing.

    Parameters
    ----------
    measured : Measured
        The log, judged.
    of_samples : bool
        Whether the path comes from the log's own reference. A gap replaces part of such a path by a straight bridge.

    Notes
    -----
    An error belongs to a gap if its sample lies in a gap of a position, or its foot point on the bridge over a gap of a reference. A tool
    that lags reaches the bridge after the gap; a tool that leads reaches it before.
    """
    result, period, worst = measured.result, measured.result.servo_period, measured.metrics.contour_error.worst.time
    if inside := log.gaps_at(worst):
        return [finding("CL411", time=worst, channels=tuple(inside), windows=log.clocks[inside[0]].windows)]
    along, foot = result["arc_length"], result["foot_arc_length"][round(worst / period)]
    bridged: dict[str, None] = {}
    for name, start, stop in log.gaps("reference") if of_samples else ():
        edges = np.array([np.floor(start / period + EVEN), np.ceil(stop / period - EVEN)], dtype=np.int64)
        before, behind = along[np.clip(edges, 0, len(along) - 1)]
        if before <= foot <= behind:
            bridged[name] = None
    return [finding("CL412", time=worst, channels=tuple(bridged), windows=log.clocks[next(iter(bridged))].windows)] if bridged else []


def move_findings(log: Log, measured: Measured) -> list[Finding]:
    """Return the contour error of the cutting moves and of the rapid moves, if the log tells them apart."""
    at, lines, rapid = log.block, log.lines, log.rapid
    if at is None or lines is None or rapid is None:
        return []
    error, judged = np.abs(measured.result["contour_error"]), measured.metrics.judged.samples
    judged = judged[at[judged] >= 0]
    is_rapid, findings = rapid[judged], []
    for place, samples in (("cutting moves", judged[~is_rapid]), ("rapid moves", judged[is_rapid])):
        if samples.size:
            worst, rms = samples[np.argmax(error[samples])], float(np.sqrt(np.mean(error[samples] ** 2)))
            largest, line = float(error[worst]), int(lines[worst])
            findings.append(finding("CL414", place, samples=samples.size, rms=rms, largest=largest, line=line))
    return findings


def _signals_of(run: Result, route: Route | None) -> list[Array]:
    """Return the position (n_sample, n_axis) [m], and without a route the reference; raise one error for all that are missing."""
    wanted = {"position": next((name for name in ACTUAL if name in run), "position")}
    wanted |= {"reference": "reference"} if route is None else {}
    missing = []
    for kind, name in wanted.items():
        if name not in run:
            cure = "" if kind == "position" else ", or the part program with --program part.ngc"
            missing.append(f"no {kind} in {run.source}: name its columns, such as --column '{kind}.x=NAME [mm]'{cure}")
            continue
        known = np.isfinite(run[name])
        whole = np.asarray(known.all(axis=0) if kind == "position" else known.any(axis=0))
        if axes := [axis for axis, is_known in zip(run.axes, whole.tolist(), strict=True) if not is_known]:
            cure = f"name its column, such as --column '{kind}.{axes[0]}=NAME [mm]', or exclude the axis with --axes"
            missing.append(f"no {kind} of {', '.join(axes)} in {run.source}: {cure}")
    refuse(missing, ResultError, "; ".join(missing))
    return [run[name] for name in wanted.values()]


def _reference_findings(axes: tuple[str, ...], reference: Array, position: Array) -> list[Finding]:
    """Return findings on axes whose position hardly follows the reference, or equals it."""
    left, whole = np.var(reference - position, axis=0), np.var(reference, axis=0)
    unlike = tuple(axis for axis, off, size in zip(axes, left, whole, strict=True) if off > (1.0 - FOLLOWS) * size > 0.0)
    return [*([finding("CL405", axes=unlike)] if unlike else []), *same_column_findings(axes, reference, position)]


def _on_the_path(judged: Result, reference: Reference, window: tuple[int, int]) -> tuple[tuple[int, int], int]:
    """Return the samples to judge, and how many were dropped.

    If a log begins in motion, a lagging tool is still before the first sample of the reference, on a path that the log does not contain.
    Its distance there is lag. The same holds for a leading tool if the log ends in motion.
    """
    path, tool, error = reference.path, judged["tool_position"], np.abs(judged["contour_error"])
    start, stop = window
    ends = np.array([0.0, path.length])
    behind, ahead = (((tool - at) @ tangent) for at, tangent in zip(path.position(ends), path.tangent(ends), strict=True))
    # The nearest point is an end. The foot points in the result may be those on a program.
    at_begin, at_end = (np.linalg.norm(tool - at, axis=1) <= error + NEXT_TO for at in path.position(ends))
    before, beyond = at_begin & (behind < -STILL), at_end & (ahead > STILL)
    first = int(np.argmin(before)) if start == 0 and not before.all() else start
    last = stop - int(np.argmin(beyond[:stop][::-1])) if stop >= len(error) - 1 and not beyond.all() else stop
    if path.closed or last - first < 2:
        return window, 0
    return (first, last), first - start + stop - last


def _last_lap_findings(judged: Result, reference: Reference, window: tuple[int, int]) -> list[Finding]:
    """Return a finding with the error of the last lap alone, which judges simulated runs: the first lap starts from rest."""
    first = last_lap(reference.path, judged["arc_length"])
    if first is None or not window[0] < first < window[1] - 2:
        return []
    error = np.abs(judged["contour_error"][first : window[1]])
    return [finding("CL409", time=float(judged.time[first]), rms=float(np.sqrt(np.mean(error**2))), largest=float(error.max()))]


def _outlier_findings(judged: Result, window: tuple[int, int]) -> list[Finding]:
    """Return a finding if the largest error exceeds twice any other: no mass moves there and back within two samples."""
    error = np.abs(judged["contour_error"][slice(*window)])
    worst = int(np.argmax(error))
    others = float(np.delete(error, worst).max(initial=0.0))
    if others > 0.5 * error[worst] or error[worst] < STILL:
        return []
    return [finding("CL410", time=float(judged.time[window[0] + worst]), others=others)]


def _sampling_findings(reference: Array, largest: float) -> list[Finding]:
    """Return a finding if the commanded path bulges between its samples by as much as counts in the largest contour error [m]."""
    chord, bend = reference[2:] - reference[:-2], np.diff(reference, 2, axis=0)
    along = chord / np.maximum(np.linalg.norm(chord, axis=1, keepdims=True), 1e-300)
    across = bend - (bend * along).sum(axis=1, keepdims=True) * along
    bulge = float(np.linalg.norm(across, axis=1).max(initial=0.0)) / 8.0  # height of an arc over its chord
    return [finding("CL417", bulge=bulge, largest=largest)] if largest > STILL and bulge > COARSE * largest else []


def _known_metrics(metrics: Metrics, run: Result, window: tuple[int, int] | None) -> Metrics:
    """Return the metrics, nan where the log lacks the signal; with a window the cycle is that of its moving part."""
    nan = float("nan")
    if NO_REFERENCE.items() <= run.attributes.items():
        metrics = replace(metrics, tracking_error=(AxisFigures(nan, nan),) * len(run.axes))
    if "applied_command" not in run:
        metrics = replace(metrics, saturation=(nan,) * len(run.axes))
    return metrics if window is None else replace(metrics, cycle_time=(window[1] - window[0]) * run.servo_period)


def _stated(run: Result) -> Judged | None:
    """Return the samples that judged a result of contourlab; None for another log."""
    text = run.attributes.get("judged")
    try:
        judged = None if text is None else Judged.parse(str(text))
    except ValueError:
        return None
    return judged if judged is not None and judged.ranges[-1][1] <= run.n_sample else None


def _of_axes(result: Result, axes: tuple[str, ...]) -> Result:
    refuse(len(set(axes)) < len(axes), ResultError, f"axes {', '.join(axes)}: one is named twice")
    columns = columns_of(result, axes)
    if axes == result.axes:
        return result
    signals = {n: replace(s, data=s.data[:, columns]) if s.data.ndim == 2 else s for n, s in result.signals.items()}
    return replace(result, axes=axes, signals=signals)
