"""The path with the errors of each run drawn along its normal, magnified."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.feed.reference import CUTTING, LAST_LAP, WHOLE
from contourlab.figures import figure, listing
from contourlab.geometry import Path
from contourlab.metrics.figures import range_of
from contourlab.rendering.charts import Curve, Magnified, PathChart, PathScene, Place, SceneRun
from contourlab.rendering.comparison import judged_words
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.lead import lines_at
from contourlab.rendering.samples import keep_changes, largest_magnitude, signal, times
from contourlab.rendering.style import BAND, INK, REFERENCE, magnification
from contourlab.thinning import extremes_of, keep_extremes

MM, UM = 1e3, 1e6
DRAWN = "The path is to scale. The error of each run is magnified and drawn from the nearest point of the path."
FLAT = 1e-3
"""An axis with an extent below this share of the largest gets no view."""
PEAKS, APART, SOON = 5, 40, 0.25
"""Most worst places of a run; the share of the run, 1 / APART, that lies between two; and the longest effect of a reversal [s]."""


class _Drawn(NamedTuple):
    """The drawn points of a run: foot points and errors (n, n_axis) [m], and its look.

    A point of nan ends the line between two judged stretches.
    """

    foot: Array
    error: Array
    look: tuple[str, str, str]

    def magnified(self, columns: list[int]) -> Magnified:
        """Return some axes of the run."""
        return Magnified(self.foot[:, columns] * MM, self.error[:, columns] * UM, *self.look)


def path_charts(data: ReportData, points: int) -> tuple[PathChart, ...]:
    """Return one chart per view of the path: XY, in space also XZ and YZ; none for a single axis.

    A run has at most `points` points.
    """
    if len(data.axes) == 1:
        return ()
    s = _places(data.asked, points)
    asked = data.asked.position(s)
    runs = [_run(data, scheme, points) for scheme in data.schemes]
    calm = [largest_magnitude(run.error) for run, scheme in zip(runs, data.schemes, strict=True) if scheme.result.status.ok]
    scale = magnification(float(np.max(np.ptp(asked, axis=0))), max(calm, default=0.0))
    return tuple(_chart(data, pair, s, asked, runs, scale, i) for i, pair in enumerate(_views(asked)))


def _views(planned: Array) -> list[tuple[int, int]]:
    """Return the pairs of axes to show; a flat path has one view."""
    extent = np.ptp(planned, axis=0)
    pairs = list(combinations(range(extent.size), 2))
    good = [pair for pair in pairs if min(extent[list(pair)]) > FLAT * max(extent)]
    # A straight line along one axis appears in the first plane that contains it.
    return good or [next((pair for pair in pairs if int(np.argmax(extent)) in pair), (0, 0))]


def _places(path: Path, points: int) -> Array:
    """Return arc lengths for drawing a path: evenly spread, and both sides of each corner."""
    even = np.linspace(0.0, path.length, points)
    corners = np.asarray(path.corners, dtype=np.float64).ravel()
    junctions = np.asarray(path.breaks, dtype=np.float64).ravel()
    if junctions.size > points:  # many short moves: draw the outermost junctions
        junctions = junctions[keep_extremes(path.position(junctions), max(points, 8 * path.n_axis))]
        corners = corners[:0]
    hair = 1e-9 * path.length
    s = np.unique(np.concatenate([even, junctions, corners - hair, corners + hair]))
    return np.asarray(s[(s >= 0.0) & (s <= path.length)], dtype=np.float64)


def _run(data: ReportData, scheme: JudgedRun, points: int) -> _Drawn:
    """Return the points of a run, in the window of its figures: many where the error changes.

    With many laps drawn, each would have too few points, and lines between them would cut corners.
    """
    result, judged, stops = scheme.result, scheme.metrics.judged.samples, [stop for _, stop in scheme.metrics.judged.ranges]
    size, along = np.abs(signal(result, "part_error")[judged]), signal(result, "foot_arc_length")[judged]
    good = np.flatnonzero(np.isfinite(size) & np.isfinite(along))
    kept = good[keep_changes(size[good], points)] if good.size else good
    foot = np.asarray(data.asked.position(along[kept]), dtype=np.float64)
    gaps = np.flatnonzero(np.diff(np.searchsorted(stops, judged[kept], side="right"))) + 1
    foot, error = (np.insert(part, gaps, np.nan, axis=0) for part in (foot, signal(result, "tool_position")[judged[kept]] - foot))
    return _Drawn(foot, error, data.looks[scheme.name])


def _chart(data: ReportData, pair: tuple[int, int], s: Array, asked: Array, runs: list[_Drawn], scale: float, index: int) -> PathChart:
    """Return one view."""
    columns, names = list(pair), [data.axes[i] for i in pair]
    view = "".join(names).upper() if "".join(names).isalpha() else " and ".join(names)
    x, y = MM * asked[:, columns].T
    outlines = [Curve(x, y, "programmed path", INK, "solid", 1.0)]
    if data.is_blended:
        x, y = MM * data.planned.position(_places(data.planned, s.size))[:, columns].T
        outlines.append(Curve(x, y, "planned path", REFERENCE, "dash", 1.0))
    return PathChart(
        f"path-{index}",
        "Path with magnified error",
        f"{DRAWN} Shown: {judged_words(data.schemes[0])}.",
        view,
        tuple(f"{name} [mm]" for name in names),
        tuple(run.magnified(columns) for run in runs),
        scale,
        tuple(outlines),
        _tolerance(data, asked, s, columns, scale),
        _worst(data, columns),
    )


def _tolerance(data: ReportData, asked: Array, s: Array, columns: list[int], scale: float) -> tuple[Magnified, ...]:
    """Return the edges of the tolerance of a plane path, unless they are far from it."""
    if data.tolerance is None or min(columns) == max(columns):
        return ()
    size = float(np.max(np.ptp(asked, axis=0)))
    off_plane = np.delete(asked, columns, axis=1)
    if data.tolerance * scale > 0.3 * size or (off_plane.size and largest_magnitude(np.ptp(off_plane, axis=0)) > FLAT * size):
        return ()
    tangent = data.asked.tangent(s)[:, columns]
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) * data.tolerance * UM
    name = f"tolerance ±{figure(data.tolerance, 'um', 6)}"
    foot = asked[:, columns] * MM
    return tuple(Magnified(foot, side * normal, name, BAND, "dot") for side in (1.0, -1.0))


def _worst(data: ReportData, columns: list[int]) -> tuple[Magnified, ...]:
    """Return the worst error of every run that was judged."""
    places = []
    for scheme in data.schemes:
        worst = None if scheme.verdict is None else scheme.verdict.worst
        if worst is not None and 0 <= worst.sample < scheme.result.n_sample:
            along = signal(scheme.result, "foot_arc_length")[worst.sample : worst.sample + 1]
            foot = np.asarray(data.asked.position(along), dtype=np.float64)
            error = signal(scheme.result, "tool_position")[worst.sample] - foot
            name = f"{scheme.name}: worst {figure(worst.value, 'um')}"
            places.append(Magnified(foot[:, columns] * MM, error[:, columns] * UM, name, data.looks[scheme.name][1]))
    return tuple(places)


def path_scene(data: ReportData, points: int) -> PathScene | None:
    """Return the path in space with the runs along it, each curve with at most `points` points (>= 32); None for a single axis.

    Of more than three axes, those that move most are shown.
    """
    if len(data.axes) == 1:
        return None
    s = _places(data.asked, points // 2)
    asked = data.asked.position(s)
    shown = sorted(int(i) for i in np.argsort(-np.ptp(asked, axis=0), kind="stable")[:3])
    first, flat = data.schemes[0], np.zeros((1, 3 - len(shown)))

    def column(points: Array) -> Array:
        return np.hstack([points[:, shown], np.broadcast_to(flat, (len(points), flat.size))])

    runs = tuple(_scene_run(data, scheme, column, points) for scheme in data.schemes)
    calm = [largest_magnitude(run.error) / UM for run, scheme in zip(runs, data.schemes, strict=True) if scheme.result.status.ok]
    part = first.metrics.judged
    ends = np.ravel([(start, stop - 1) for start, stop in part.ranges])
    place = first.reference.programmed_arc_length(first.result.at("arc_length", ends))
    begun, ended = place[::2].searchsorted(s, side="right"), place[1::2].searchsorted(s)
    judged = (begun > ended) | (part.basis in (LAST_LAP, WHOLE))
    caption = f"The path is to scale, the error is magnified and drawn from the nearest point of the path. Shown: {judged_words(first)}."
    if len(data.axes) > len(shown):
        caption += f" Of {listing(data.axes)} the {len(shown)} axes that move most are drawn."
    return PathScene(
        "path-space",
        "Path with magnified error",
        caption,
        tuple(data.axes[i] for i in shown),
        _rounded(column(asked) * MM, 17),
        lines_at(first.reference, s),
        judged,
        "rapids" if part.basis == CUTTING else "not judged",
        runs,
        None if data.tolerance is None else data.tolerance * UM,
        magnification(float(np.max(np.ptp(asked, axis=0))), max(calm, default=0.0)),
    )


def _scene_run(data: ReportData, scheme: JudgedRun, column: Callable[[Array], Array], points: int) -> SceneRun:
    """Return a run from its first to its last judged sample."""
    result, ranges = scheme.result, scheme.metrics.judged.ranges
    start, stop = ranges[0][0], ranges[-1][1]

    def seen(first: int, last: int) -> Array:
        """Return what must keep its extremes: the error, and the tool, which looks as if it were on the path."""
        part = result.window(start + first, start + last)
        return np.column_stack([np.abs(signal(part, "part_error")), column(signal(part, "tool_position"))])

    kept, step = extremes_of(seen, stop - start, 4, points // 2), max((stop - start) // (2 * points), 1)
    changes = keep_changes(np.nan_to_num(np.abs(signal(result, "part_error")[start:stop:step])), points // 4)
    ends = [place for first, last in ranges for place in (first, last - 1)] if 2 * len(ranges) <= points else []
    kept = np.union1d(np.union1d(kept, step * changes) + start, [*ends, scheme.metrics.part_error.worst.sample - result.start])
    kept = kept[np.isfinite(result.at("foot_arc_length", kept)) & np.isfinite(result.at("part_error", kept))]
    along, size = result.at("foot_arc_length", kept), np.abs(result.at("part_error", kept))
    time, lines = times(result, kept), scheme.lines(kept)
    foot, stretch = column(data.asked.position(along)), range_of(scheme.metrics.judged, kept)
    off = column(result.at("tool_position", kept)) - foot
    following = result.at("foot_arc_length", np.minimum(kept + 1, result.n_sample - 1))
    speed = result.at("feedrate", kept) if "feedrate" in result else (following - along) / result.servo_period
    worst = tuple(
        Place(tuple((foot[i] * MM).tolist()), tuple((off[i] * UM).tolist()), float(size[i]) * UM, float(time[i]),
              int(lines[i]), _cause(scheme, int(kept[i])))
        for i in _peaks(np.where(stretch > 0, size, 0.0), kept, (stop - start) // APART + 1)
    )  # fmt: skip
    drawn = (_rounded(foot * MM, 17), _rounded(off * UM, 14), _rounded(size * UM, 14), time)
    return SceneRun(*data.looks[scheme.name][:2], *drawn, _rounded(np.abs(speed) * 6e4, 12), lines, stretch, worst)


def _peaks(error: Array, samples: Index, near: int) -> list[int]:
    """Return which of ascending samples (n,) have the largest errors, `near` samples apart and none below half of the largest."""
    left, peaks, most = error.copy(), list[int](), error.max(initial=0.0)
    while len(peaks) < PEAKS and left.max(initial=0.0) > 0.5 * most:
        peaks.append(int(left.argmax()))
        left[np.abs(samples - samples[peaks[-1]]) < near] = 0.0
    return peaks


def _cause(scheme: JudgedRun, sample: int) -> str:
    """Return the largest cause at the worst sample; elsewhere the reversal before it, if there is one."""
    verdict, time = scheme.verdict, float(times(scheme.result, np.array([sample]))[0])
    if verdict is not None and verdict.causes and verdict.worst.sample == sample:
        return max(verdict.causes, key=lambda cause: cause.contribution).words
    before = [spike for spike in scheme.spikes if spike.time <= time <= spike.time + SOON]
    return f"reversal of {max(before, key=lambda spike: abs(spike.height)).axis}" if before else ""


def _rounded(values: Array, bits: int) -> Array:
    """Round to `bits` bits of the widest column, more than a screen shows: numbers that end in zeros take half the space."""
    spread = float(np.max(np.ptp(values, axis=0))) if values.size else 0.0
    step = 2.0 ** (np.floor(np.log2(spread)) - bits) if 0.0 < spread < np.inf else 1.0
    return np.asarray(np.round(values / step) * step if spread > 0.0 else values)
