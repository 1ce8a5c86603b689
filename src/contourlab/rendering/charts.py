"""Charts as data, before the viewer or matplotlib draws them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.rendering.samples import largest_magnitude
from contourlab.rendering.style import BAND, LIMIT, round_down, scheme_style

MARKS = {"reversal": "^", "corner": "D", "first zero": "o", "curvature step": "v", "peak": "^"}
"""Kinds of marks on the x axis, and their symbols."""
_BEYOND = ", off scale"


@dataclass(frozen=True, eq=False)
class Picture:
    """What every chart has: a key, which names its file, a title and a caption."""

    key: str
    title: str
    caption: str


@dataclass(frozen=True, eq=False)
class Curve:
    """One line, in the units of its panel.

    Parameters
    ----------
    x, y : ndarray (n,)
    name : str
        Legend entry; curves with the same name share it.
    dash : {"solid", "dash", "dot"}
    width : float [px]
    half : ndarray (n,), optional
        Half the height of the error bar at each point; draws points without a line.
    numbers : ndarray (n,) of int, optional
        Number of each point, which appears on hover.
    """

    x: Array
    y: Array
    name: str
    colour: str
    dash: str = "solid"
    width: float = 1.3
    half: Array | None = None
    numbers: Index | None = None


@dataclass(frozen=True)
class Level:
    """A limit: a horizontal line at `value` with its text."""

    value: float
    label: str


@dataclass(frozen=True)
class Tick:
    """A mark on the x axis; its label appears on hover."""

    x: float
    label: str
    mark: str


@dataclass(frozen=True, eq=False)
class Panel:
    """One pair of axes.

    Parameters
    ----------
    x_label, y_label : str
        With unit.
    band : (low, high), optional
        Shaded band: the tolerance.
    span : (low, high), optional
        Shaded span of x: the window of a fit.
    y_range : (low, high), optional
        None lets the renderer choose.
    far : bool
        Whether the levels are so far from the curves that the range leaves them out.
    y_ticks : tuple of (value, text)
        Texts instead of numbers on the y axis.
    """

    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    levels: tuple[Level, ...] = ()
    band: tuple[float, float] | None = None
    band_label: str = ""
    span: tuple[float, float] | None = None
    span_label: str = ""
    ticks: tuple[Tick, ...] = ()
    log_x: bool = False
    log_y: bool = False
    y_range: tuple[float, float] | None = None
    far: bool = False
    y_ticks: tuple[tuple[float, str], ...] = ()

    @property
    def notes(self) -> Iterator[tuple[str, str]]:
        """The texts above the right end of the panel, with their colours: band, span and levels."""
        if self.band is not None:
            outside = self.y_range is not None and self.band[1] > self.y_range[1]
            yield self.band_label + (_BEYOND if outside else ""), BAND
        if self.span is not None:
            yield self.span_label, BAND
        for level in self.levels:
            if level.label:
                yield level.label + (_BEYOND if self.far else ""), LIMIT

    @property
    def marks(self) -> Iterator[tuple[str, str, list[Tick]]]:
        """The marks by kind: kind, its symbol, and the ticks."""
        for kind, symbol in MARKS.items():
            if ticks := [tick for tick in self.ticks if tick.mark == kind]:
                yield kind, symbol, ticks


@dataclass(frozen=True, eq=False)
class Chart(Picture):
    """Panels above one another with a common x axis.

    Parameters
    ----------
    panel_height : int [px]
        0 for the default.
    loops : bool
        Whether curves go back and forth along x.
    """

    panels: tuple[Panel, ...]
    panel_height: int = 0
    loops: bool = False


Traces = Mapping[str, tuple[Array, ...]]
"""Curves (x, y) by name; with a third array: points, and half the heights of their error bars."""


def traces_chart(
    key: str,
    title: str,
    labels: tuple[str, str],
    traces: Traces,
    *,
    caption: str = "",
    level: Level | None = Level(0.0, ""),
    below: Mapping[str, Traces] | None = None,
    panel_height: int = 0,
    log_y: bool = False,
    **panel: Any,
) -> Chart:
    """Return curves in one panel, in the units of its labels, and further panels with a linear y axis below it, by their y labels.

    A name looks the same in all panels: they share the legend. `panel` are parameters of every `Panel`.
    """
    parts = {labels[1]: traces, **(below or {})}
    names = list(dict.fromkeys(name for some in parts.values() for name in some))
    looks = {name: scheme_style(i, len(names)) for i, name in enumerate(names)}
    levels, panels = () if level is None else (level,), []
    for label, some in parts.items():
        curves = (Curve(x, y, name, *looks[name], half=half[0] if half else None) for name, (x, y, *half) in some.items())
        panels.append(Panel(labels[0], label, tuple(curves), levels, log_y=log_y and some is traces, **panel))
    return Chart(key, title, caption, tuple(panels), panel_height)


@dataclass(frozen=True, eq=False)
class PolarChart(Picture):
    """Radial deviation around a circle; the nominal circle is where the deviation is 0.

    Parameters
    ----------
    curves : tuple of Curve
        x is the angle [deg], y the deviation [um].
    radius : float [m]
    marks : tuple of Curve
        Marked points: reversal spikes.
    """

    curves: tuple[Curve, ...]
    radius: float
    marks: tuple[Curve, ...] = ()

    @cached_property
    def spacing(self) -> tuple[float, float]:
        """Distance between two rings, and deviation at the rim [um]: the curves fill the outer part of the chart."""
        largest = max(largest_magnitude(curve.y) for curve in self.curves)
        if largest <= 0.0:
            return 1.0, 3.0
        division = round_down(largest / 2.0)
        return division, division * float(np.ceil(1.05 * largest / division))

    @property
    def reach(self) -> tuple[float, float]:
        """Deviation at the centre and at the rim [um]."""
        return -2.0 * self.spacing[1], self.spacing[1]

    def rings(self) -> list[tuple[float, str]]:
        """Return each ring [um] with its text; every second one has a number, those in the middle have none."""
        division, rim = self.spacing
        count = round(rim / division)
        texts = {k: f"{k * division:+g}" for k in range(-count, count - 1) if k % 2 == 0}
        texts |= {0: "0", count: f"{rim:+g} um"}
        return [(k * division, texts.get(k, "")) for k in range(-2 * count, count + 1)]


@dataclass(frozen=True, eq=False)
class Magnified:
    """One run beside the path: ``foot + magnification * error``.

    Parameters
    ----------
    foot : ndarray (n, 2) [mm]
    error : ndarray (n, 2) [um]
        From the foot point on the path to the machine.
    """

    foot: Array
    error: Array
    name: str
    colour: str
    dash: str = "solid"

    def drawn(self, magnification: float) -> Array:
        """Return the points (n, 2) [mm] to draw."""
        return np.asarray(self.foot + self.error * (1e-3 * magnification), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class PathChart(Picture):
    """The path, seen along one axis, with the magnified errors of the runs.

    Parameters
    ----------
    view : str
        For example ``"XY"``.
    labels : tuple of str
        Labels of the two axes, with unit.
    lines : tuple of Curve
        Programmed path, then perhaps the planned one [mm].
    tolerance : tuple of Magnified
        Edges of the tolerance.
    worst : tuple of Magnified
        One point each: the worst error of a run.
    """

    view: str
    labels: tuple[str, ...]
    runs: tuple[Magnified, ...]
    magnification: float
    lines: tuple[Curve, ...]
    tolerance: tuple[Magnified, ...]
    worst: tuple[Magnified, ...]


@dataclass(frozen=True)
class Place:
    """A place of a run where the error is large.

    Parameters
    ----------
    foot : tuple of 3 float [mm]
        Nearest point of the path.
    error : tuple of 3 float [um]
        From there to the tool.
    size : float [um]
    time : float [s]
    line : int
        Line of the program; 0 for none.
    cause : str
        Empty if unknown.
    """

    foot: tuple[float, ...]
    error: tuple[float, ...]
    size: float
    time: float
    line: int
    cause: str


@dataclass(frozen=True, eq=False)
class SceneRun:
    """A run in space, thinned; its figures cover the stretches with a number, and lines join only points of the same one.

    Parameters
    ----------
    foot : ndarray (n, 3) [mm]
        Nearest points of the path.
    error : ndarray (n, 3) [um]
        From there to the tool.
    size : ndarray (n,) [um]
        Of the part error.
    time : ndarray (n,) [s]
        Ascending.
    feedrate : ndarray (n,) [mm/min]
    lines : ndarray (n,) of int
        Line of the program; 0 for none.
    stretch : ndarray (n,) of int
        Number of the judged stretch, from 1; 0 where nothing is judged.
    worst : tuple of Place
        Largest first.
    """

    name: str
    colour: str
    foot: Array
    error: Array
    size: Array
    time: Array
    feedrate: Array
    lines: Index
    stretch: Index
    worst: tuple[Place, ...]


@dataclass(frozen=True, eq=False)
class PathScene(Picture):
    """The path in space, and the runs along it.

    Parameters
    ----------
    axes : tuple of str
        Names of the two or three axes shown; without a third one z is 0.
    path : ndarray (n, 3) [mm]
        The programmed path.
    lines : ndarray (n,) of int
        Line of the program; 0 for none.
    judged : ndarray (n,) of bool
        Whether figures cover the path there.
    unjudged : str
        What the rest is: rapids, for example.
    runs : tuple of SceneRun
    tolerance : float or None [um]
    magnification : float
        Of the errors; initial value.
    """

    axes: tuple[str, ...]
    path: Array
    lines: Index
    judged: Flags
    unjudged: str
    runs: tuple[SceneRun, ...]
    tolerance: float | None
    magnification: float


@dataclass(frozen=True, eq=False)
class Tile:
    """One of several small pictures, with its own x axis.

    Parameters
    ----------
    marks : tuple of (x, y, colour)
        Rings: minima of curves.
    here : tuple of (x, colour)
        Vertical lines: present values.
    shaded : tuple of (low, high)
        Spans of x in which runs fail.
    """

    title: str
    x_label: str
    curves: tuple[Curve, ...]
    marks: tuple[tuple[float, float, str], ...] = ()
    here: tuple[tuple[float, str], ...] = ()
    shaded: tuple[tuple[float, float], ...] = ()
    log_x: bool = False


@dataclass(frozen=True, eq=False)
class Multiples(Picture):
    """Small pictures side by side with a common logarithmic y axis."""

    y_label: str
    tiles: tuple[Tile, ...]


@dataclass(frozen=True, eq=False)
class Series:
    """Bars of one colour: values (n,) and half the widths of their intervals (n,)."""

    name: str
    values: Array
    intervals: Array
    colour: str


@dataclass(frozen=True, eq=False)
class Bars(Picture):
    """Horizontal bars beside their names, from top to bottom."""

    x_label: str
    names: tuple[str, ...]
    series: tuple[Series, ...]


@dataclass(frozen=True, eq=False)
class Matrix(Picture):
    """A matrix (n, n) in colours, red above 0 and blue below; NaN is blank, doubtful values get a question mark."""

    label: str
    names: tuple[str, ...]
    values: Array
    doubtful: Flags


@dataclass(frozen=True, eq=False)
class Heat(Picture):
    """A value in each cell of a grid (n_y, n_x), in colours; NaN is dark.

    Parameters
    ----------
    x_label, y_label, unit : str
    x_names, y_names : tuple of str
        Names of the columns, and of the rows from the bottom up.
    low, high : float
        Values at the ends of the scale.
    colours : tuple of (float, str)
        Places on the scale, 0 to 1 and ascending, and their colours; two at one place are a step.
    """

    x_label: str
    y_label: str
    unit: str
    x_names: tuple[str, ...]
    y_names: tuple[str, ...]
    values: Array
    low: float
    high: float
    colours: tuple[tuple[float, str], ...]


@dataclass(frozen=True, eq=False)
class CircleTrace:
    """One run of a circle test.

    Parameters
    ----------
    angle : ndarray (n,) [deg]
    deviation : ndarray (n,) [um]
    curves : ndarray (n_cause, n) [um]
        What each cause adds to the deviation.
    """

    name: str
    colour: str
    angle: Array
    deviation: Array
    curves: Array


@dataclass(frozen=True, eq=False)
class CircleCauses(Picture):
    """The runs of a circle test, with a slider for each cause that scales its curve."""

    axes: tuple[str, ...]
    causes: tuple[str, ...]
    runs: tuple[CircleTrace, ...]
    radius: float


class Exact:
    """Marks a class whose arrays keep every bit in a message."""


@dataclass(frozen=True, eq=False)
class LivePath(Exact):
    """A path in quintic pieces.

    At arc length s, ``start[i] <= s < start[i + 1]``, axis j is at the sum of ``coefficients[i, j, k] * (s - start[i]) ** k``.

    Parameters
    ----------
    start : ndarray (n_piece + 1,) [m]
        The last is the length of the path.
    coefficients : ndarray (n_piece, n_axis, 6) [m, 1, 1/m ...]
    closed : bool
        Whether s counts laps.
    """

    start: Array
    coefficients: Array
    closed: bool


@dataclass(frozen=True, eq=False)
class LiveMotion(Exact):
    """A planned motion along a path, in spans of constant jerk.

    With dt = t - t0 of the last span that has begun, progress is ``s = s0 + dt (v0 + dt (a0 / 2 + dt j / 6))``. Sample k is at the time
    ``k * period``; from `duration` on, the motion rests at the progress `length`. Velocity is ``r' v``, acceleration ``r'' v^2 + r' a``.

    Parameters
    ----------
    period : float [s]
    n_sample : int
    spans : ndarray (5, n_span) [s, m, m/s, m/s^2, m/s^3]
        t0, s0, v0, a0, j.
    duration : float [s]
    length : float [m]
    path : LivePath
    """

    period: float
    n_sample: int
    spans: Array
    duration: float
    length: float
    path: LivePath


@dataclass(frozen=True)
class LiveParameter:
    """A parameter that can be changed.

    Parameters
    ----------
    name : str
        Dotted, as ``run --set`` takes it.
    word : int
        Place of its value.
    value : float or None
        In SI; None for infinity.
    unit, display : str
        SI unit, and the unit for people.
    factor : float
        From SI to `display`.
    minimum, maximum : float or None
        Bounds in SI; None for none. `exclusive`: the minimum itself is not allowed; `whole`: whole numbers only.
    first : bool
        Whether to show it without being asked: gains, bandwidths of observers, friction, backlash.
    """

    name: str
    word: int
    value: float | None
    unit: str
    display: str
    factor: float
    minimum: float | None
    maximum: float | None
    exclusive: bool
    whole: bool
    first: bool


@dataclass(frozen=True, eq=False)
class LiveRun(Exact):
    """A run of the report as a WebAssembly module; places are words of 8 bytes. `contourlab.loop.PortableLoop` says how to run it.

    Parameters
    ----------
    name : str
        That of its run in `PathScene`.
    code : ndarray (n,) of uint8
    n_word : int
        Size of the memory.
    words : tuple of (int, ndarray (n,))
        What memory holds before the first tick, besides the inputs: numbers, from a word on. The rest is 0.
    inputs : int
        First word of the inputs, `motion.n_sample` words each: position of every axis, velocity, acceleration, then arc length, feedrate,
        and for each number of `ahead` the position of that axis so many ticks later; beyond the end the last one.
    ahead : tuple of int
    log, n_log : int
        First word of the log, and its columns; each tick has a row.
    position : tuple of int
        Columns: position of each axis [m].
    part_error, foot : int
        Columns: part error, and arc length of its foot point on `asked` [m]; meaningless where nothing is judged.
    doubt : int
        Column: 1 where the judge of the module is not sure. There the part error is the distance to the nearest point of `asked` in a
        window around the place of the reference: three times the largest tracking error plus 0.1 mm, at most half of a closed path,
        plus `planning`.
    place : int
        First word of the place of the reference on `asked` [m], one for each tick.
    planning : float [m]
        The largest distance of the reference from `asked`.
    asked : LivePath
        The programmed path.
    judged : tuple of (int, int)
        Samples [start, stop) that figures cover.
    figures : tuple of (str, int)
        Word of each figure [SI]; those of the part error know nothing of ticks in doubt.
    failed_at : int
        Word of the sample at which the run failed, or -1.
    state : tuple of (int, int)
        Begin and end of the words that change while ticks run, besides the log.
    parameters : tuple of LiveParameter
    short : (int, int)
        Samples [start, stop) around the worst place, for a short run. It begins there, or earlier, with the words of `state` of this run.
    controller : str
        The controller's file (TOML), with ``"@NAME@"`` in place of the value of each of its parameters.
    """

    name: str
    code: Array
    n_word: int
    words: tuple[tuple[int, Array], ...]
    motion: LiveMotion
    inputs: int
    ahead: tuple[int, ...]
    log: int
    n_log: int
    position: tuple[int, ...]
    part_error: int
    foot: int
    doubt: int
    place: int
    planning: float
    asked: LivePath
    judged: tuple[tuple[int, int], ...]
    figures: tuple[tuple[str, int], ...]
    failed_at: int
    state: tuple[tuple[int, int], ...]
    parameters: tuple[LiveParameter, ...]
    short: tuple[int, int]
    controller: str


@dataclass(frozen=True, eq=False)
class LiveLoop(Picture):
    """Runs whose parameters can be changed in the page.

    Parameters
    ----------
    command : str
        Runs the report again; ``--set NAME=VALUE`` is appended.
    """

    runs: tuple[LiveRun, ...]
    command: str
