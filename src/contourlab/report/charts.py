"""Pictures before they are drawn: what plotly and matplotlib are both told."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Curve:
    """One line, in the units of its panel.

    Parameters
    ----------
    x, y : ndarray (n,)
    name : str
        In the legend; curves of one name share an entry and are switched together.
    colour : str
    dash : str
        ``"solid"``, ``"dash"`` or ``"dot"``.
    width : float [px]
    half : ndarray (n,), optional
        Half the height of the bar at each point: points are drawn then, without a line between them.
    """

    x: Array
    y: Array
    name: str
    colour: str
    dash: str = "solid"
    width: float = 1.3
    half: Array | None = None


@dataclass(frozen=True)
class Level:
    """A limit: a horizontal line at `value` with its text."""

    value: float
    label: str


@dataclass(frozen=True)
class Tick:
    """A mark on the x axis at `x`, told when pointed at."""

    x: float
    label: str
    kind: str


@dataclass(frozen=True, eq=False)
class Panel:
    """One pair of axes.

    Parameters
    ----------
    x_label, y_label : str
        With unit.
    curves : tuple of Curve
    levels : tuple of Level
    band : (low, high) or None
        Drawn as a shaded band: the tolerance.
    band_label : str
    span : (low, high) or None
        Of x, drawn as a shaded span: what a fit was made to.
    span_label : str
    ticks : tuple of Tick
    log_x, log_y : bool
    y_range : (low, high) or None
        None lets the drawing choose.
    far : bool
        Whether the levels are so far from the curves that the range leaves them out.
    y_ticks : tuple of (value, text)
        In place of numbers on the y axis.
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


@dataclass(frozen=True, eq=False)
class Chart:
    """Panels under one another with one x axis.

    Parameters
    ----------
    key, title, caption : str
    panels : tuple of Panel
    panel_height : int [px]
        Of each; 0 for the usual one.
    loops : bool
        Whether curves go back and forth: values are told by the nearest point, and the ends are kept clear of the frame.
    """

    key: str
    title: str
    caption: str
    panels: tuple[Panel, ...]
    panel_height: int = 0
    loops: bool = False


@dataclass(frozen=True, eq=False)
class PolarChart:
    """Radial deviation round a circle; the nominal circle is where the deviation is 0.

    Parameters
    ----------
    curves : tuple of Curve
        x is the angle [deg], y the deviation [um].
    division : float [um]
        Between two rings.
    reach : (low, high) [um]
        Deviation at the centre and at the rim.
    radius : float [m]
    marks : tuple of Curve
        Points to mark, as curves: reversal spikes.
    """

    key: str
    title: str
    caption: str
    curves: tuple[Curve, ...]
    division: float
    reach: tuple[float, float]
    radius: float
    marks: tuple[Curve, ...] = ()

    def rings(self) -> list[tuple[float, str]]:
        """Return each ring [um] with its text; every second one is numbered, those in the middle are not."""
        count = round(self.reach[1] / self.division)
        texts = {k: f"{k * self.division:+g}" for k in range(-count, count - 1) if k % 2 == 0}
        texts |= {0: "0", count: f"{self.reach[1]:+g} um"}
        return [(k * self.division, texts.get(k, "")) for k in range(-2 * count, count + 1)]


@dataclass(frozen=True, eq=False)
class Magnified:
    """One run drawn beside the path: ``foot + magnification * error``.

    Parameters
    ----------
    foot : ndarray (n, 2) [mm]
    error : ndarray (n, 2) [um]
        From the foot point on the path to where the machine was.
    name, colour, dash : str
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
class PathChart:
    """The path, seen along one axis, with the errors of the runs magnified.

    Parameters
    ----------
    view : str
        For example ``"XY"``.
    labels : (str, str)
        Of the two axes, with unit.
    lines : tuple of Curve
        Planned and programmed path [mm].
    runs : tuple of Magnified
    tolerance : tuple of Magnified
        The edges of the tolerance, if there is one.
    worst : tuple of Magnified
        Each of one point: the worst error of a run.
    magnification : float
        To begin with.
    """

    key: str
    view: str
    title: str
    caption: str
    labels: tuple[str, str]
    lines: tuple[Curve, ...]
    runs: tuple[Magnified, ...]
    tolerance: tuple[Magnified, ...]
    worst: tuple[Magnified, ...]
    magnification: float
