"""Guards, the constraints on a design: margins of every axis, a stable coupling, drives below their limits; and poles that keep them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from contourlab.analysis.linear.contour_transfer import internal_stability
from contourlab.analysis.linear.margins import Margins, RoughMargins
from contourlab.analysis.linear.sampled_loop import AxisLanes, LaneLoops, SampledLoop, lane_loops, margin_factors, sampled_loop, unstable_by
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.errors import ComponentError, ParameterError, refuse
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.scenario.build import model_of
from contourlab.study.space import ROUNDING

SLACK = (0.02, 0.05)
"""Additional margin [dB, degrees] required in a search, where margins come from a grid."""


@dataclass(frozen=True)
class Bounds:
    """The guards.

    Attributes
    ----------
    gain_margin : float [dB], >= 0
        Of each axis, with the loop opened at its drive.
    phase_margin : float [deg], >= 0
    limited : float, 0 to 1
        Largest share of the evaluated time for which a drive is at its limit.
    command : float, > 0
        Largest command, as a share of the drive's limit.
    """

    gain_margin: float = 6.0
    phase_margin: float = 30.0
    limited: float = 0.0
    command: float = math.inf

    def __post_init__(self) -> None:
        for name, high, unit in (("gain_margin", 60.0, "dB"), ("phase_margin", 90.0, "deg"), ("limited", 1.0, "")):
            if not 0.0 <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name):g}", f"0 to {high:g}", unit)
        refuse(not self.command > 0.0, ParameterError, "command", f"{self.command:g}", "> 0, as a part of the drive's limit")

    @property
    def margin_words(self) -> str:
        """The margins, as text."""
        return f"gain margin at least {self.gain_margin:g} dB, phase margin at least {self.phase_margin:g} deg"

    @property
    def words(self) -> str:
        """The guards, as text."""
        parts = [self.margin_words]
        limited = f"drives at their limits for at most {100.0 * self.limited:g} % of the time"
        parts.append(limited if self.limited else "drives never at their limits")
        if math.isfinite(self.command):
            parts.append(f"commands up to {100.0 * self.command:g} % of the drive")
        return ", ".join(parts)

    def missing(self, margins: Margins | RoughMargins, slack: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return the relative shortfall of margins: 0 if they are kept, infinite for an unstable loop."""
        pairs = zip((self.gain_margin, self.phase_margin), slack, in_db_and_degrees(margins), strict=True)
        short = sum(np.maximum(0.0, bound + more - margin) / max(bound, 1.0) for bound, more, margin in pairs if bound)
        return np.where(margins.stable, short, math.inf)

    def broken(self, margins: Margins) -> str:
        """Return the margins that are too small, with their values; empty if there are none."""
        if not margins.stable:
            return "unstable"
        gain, phase = in_db_and_degrees(margins)
        texts = {f"gain margin {gain:.2f} dB": gain < self.gain_margin - ROUNDING}
        texts |= {f"phase margin {phase:.1f} deg": phase < self.phase_margin - ROUNDING}
        return ", ".join(text for text, small in texts.items() if small)


def in_db_and_degrees(margins: Margins | RoughMargins) -> tuple[Any, Any]:
    """Return gain margin [dB] and phase margin [deg]; nan for an unstable loop."""
    return 20.0 * np.log10(margins.gain), np.degrees(np.abs(margins.phase))


@dataclass(eq=False)
class Guards:
    """Guards on a machine under a controller.

    Attributes
    ----------
    machine : Machine
    controller : Controller
    bounds : Bounds
    unknown : dict of str to str
        Axes without a linear model, with the reason: their margins are not checked.
    """

    machine: Machine
    controller: Controller
    bounds: Bounds = field(default_factory=Bounds)
    unknown: dict[str, str] = field(default_factory=dict)
    _sampled: dict[str, SampledLoop] = field(default_factory=dict, init=False, repr=False)
    _lanes: dict[str, AxisLanes] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        for loop in self._loops(self.machine, self.controller):
            try:
                self._sampled[loop[0].name] = sampled_loop(*loop)
                self._lanes[loop[0].name] = AxisLanes(*loop)
            except ComponentError as error:
                self.unknown[loop[0].name] = str(error)

    def _loops(self, machine: Machine, controller: Controller) -> Iterator[tuple[Axis, AxisController, float, float]]:
        """Yield what `sampled_loop` takes, for each axis that may have a linear model."""
        for axis in machine.axes:
            if axis.name not in self.unknown:
                yield axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name)

    # --- many designs at once, for searches ---

    def excess(self, columns: Mapping[str, Array], known: dict[tuple[object, ...], Array] | None = None) -> Array:
        """Return the largest violation of the margins by each design (n,): above 0 if a margin is broken.

        Parameters
        ----------
        columns : mapping of str to ndarray (n,)
            Values [SI] by dotted names.
        known : dict, optional
            Earlier results for the same axes and values, also from another machine that shares them; new results are added.
        """
        worst = np.full(len(next(iter(columns.values()))), -math.inf)
        factors = margin_factors(10.0 ** (self.bounds.gain_margin / 20.0), math.radians(self.bounds.phase_margin))
        known = {} if known is None else known
        for axis, _, _, carried in self._loops(self.machine, self.controller):
            head = f"controller.axes.{axis.name}."
            own = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name.startswith(head)}
            key = (id(axis), carried, *((name, values.tobytes()) for name, values in own.items()))
            if key not in known:
                known[key] = unstable_by(self._lanes[axis.name](own), factors)
            worst = np.maximum(worst, known[key])
        return worst

    def lanes(self, columns: Mapping[str, Array], axes: Collection[str]) -> list[LaneLoops]:
        """Return the loops of the given axes, each for all designs (n,)."""
        return [loops(columns) for name, loops in self._lanes.items() if name in axes]

    def missing(self, lanes: Sequence[LaneLoops], n: int) -> tuple[Array, Array]:
        """Return for each of n designs the largest relative shortfall of margins, and the smallest distance of a loop from -1."""
        short, nearest = np.zeros(n), np.full(n, math.inf)
        for margins in (loops.margins() for loops in lanes):
            short = np.maximum(short, self.bounds.missing(margins, SLACK))
            nearest = np.minimum(nearest, np.where(margins.stable, margins.modulus, 0.0))
        return short, nearest

    # --- one design, exactly ---

    def exact(self, values: Mapping[str, float]) -> dict[str, Margins]:
        """Return the exact margins of every axis with values [SI]."""
        sampled = self._sampled
        if values:
            sampled = {loop[0].name: sampled_loop(*loop) for loop in self._loops(*with_values(self.machine, self.controller, values))}
        return {axis: loop.margins() for axis, loop in sampled.items()}

    def broken(
        self, values: Mapping[str, float], limited: float, largest: float, exact: Mapping[str, Margins] | None = None
    ) -> tuple[str, ...]:
        """Return all guards that values [SI] break, from the exact analysis; `exact` gives margins that are already known."""
        margins = self.exact(values) if exact is None else exact
        found = [f"axis {axis}: {words}" for axis, of_axis in margins.items() if (words := self.bounds.broken(of_axis))]
        with suppress(ComponentError):
            if self.controller.coupling is not None and not self.unknown:
                stability = internal_stability(*with_values(self.machine, self.controller, values))
                found += [f"coupling: {cause.text}" for cause in stability.findings]
        if limited > self.bounds.limited + ROUNDING:
            found.append(f"at a limit of a drive for {100.0 * limited:.3g} % of the time")
        if largest > self.bounds.command * (1.0 + ROUNDING):
            found.append(f"a command of {100.0 * largest:.3g} % of the drive")
        return tuple(dict.fromkeys(found))


SPEEDS = 96
"""Number of pole speeds tried, from a ten-thousandth of the Nyquist frequency to half of it."""
SCALED = {"natural_frequency": 1.0, "bandwidth": 1.0, "crossover": 1.0, "pole": 1.4}
"""Design requests that scale with the speed; ratio of the real pole as in Ghaffari & Ulsoy, 35 to 25 rad/s."""
FIXED = {"damping": 0.7, "phase_margin": math.radians(60.0)}


def fastest_speed(machine: Machine, axis: Axis, slots: AxisController, bounds: Bounds) -> float:
    """Return the largest speed [rad/s] of placed poles that keeps the margins, or comes nearest to keeping them."""
    model = model_of(machine, axis, slots.observer)
    speeds = np.geomspace(1e-4, 0.5, SPEEDS) * math.pi / machine.servo_period
    designs: list[tuple[float, dict[str, float]]] = []
    for speed in speeds.tolist():
        try:
            designs.append((speed, designed(slots.controller, speed, model, axis.name)))
        except ParameterError as error:
            last = error
    if not designs:
        raise ParameterError("start", "placed", f"scenario: axis {axis.name} has no gains at any pole speed: {last}") from last
    head = f"controller.axes.{axis.name}.controller."
    names = [name for name, value in designs[0][1].items() if math.isfinite(value)]
    columns = {head + name: np.array([gains[name] for _, gains in designs]) for name in names}
    base = replace(slots, controller=slots.controller.replace(**designs[0][1]))
    try:
        loops = lane_loops(axis, base, machine.servo_period, machine.carried_mass(axis.name), columns)
    except ComponentError as error:
        raise ParameterError("start", "placed", f"scenario: the loop of axis {axis.name} has no linear model: {error}") from error
    missing = bounds.missing(loops.margins(), SLACK)
    least = float(missing.min())
    refuse(math.isinf(least), ParameterError, "start", "placed", f"scenario: axis {axis.name} is unstable at every pole speed")
    # If the observer alone breaks the margins, take the nearest poles; another parameter restores the margins.
    return designs[int(np.flatnonzero(missing <= least)[-1])][0]


def designed(part: Component, speed: float, model: tuple[float, float], axis: str) -> dict[str, float]:
    """Return the gains of a component for poles at a speed [rad/s]."""
    kind: Any = type(part)
    wishes: dict[str, float] = {}
    for name, parameter in kind.wishes.items():
        if name in SCALED and not (name == "pole" and parameter.default is not None and not part.values().get("integral_gain")):
            wishes[name] = SCALED[name] * speed
        elif name in FIXED:
            wishes[name] = FIXED[name]
        elif parameter.default is not None:
            wishes[name] = parameter.default
        else:
            raise ParameterError("start", "placed", f"scenario: designing {part.kind} on axis {axis} also needs {name}")
    if not set(wishes) & set(SCALED):
        raise ParameterError("start", "placed", f"scenario: {part.kind} on axis {axis} cannot be designed from poles")
    return dict(kind.designed(wishes, *model))
