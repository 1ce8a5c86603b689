"""Design a notch filter for the structural resonance of an axis, and the velocity gain that keeps the margins with it.

References
----------
Schmidt & Rehm, "Notch filter tuning for resonant frequency reduction in dual inertia systems", IEEE Industry Applications Conference 1999;
Ellis, "Control System Design Guide", 4th ed., 2012, on resonance; Gross, Hamann & Wiegartner, "Electrical Feed Drives in Automation", 2001.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import lane_loops, sampled_loop
from contourlab.arrays import Array
from contourlab.components.filter.biquad import Notch
from contourlab.components.plant.plant import resonance_of
from contourlab.errors import ParameterError
from contourlab.loop import AxisController, Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.study.guards import SLACK, Bounds, in_db_and_degrees

NAME = "resonance"
"""Name of the filter."""
MOVED = 0.05
"""Share by which the resonance may move: a notch is rated by its worst margins within it."""
RATIOS = (0.8, 0.9, 1.0, 1.1, 1.2)
"""Frequencies of notches to try, over the resonance."""
WIDTHS = tuple(np.geomspace(0.1, 1.0, 7))
"""Damping ratios of their poles."""
PASSES = 3
"""Most further choices of a notch."""
FACTORS = np.geomspace(1.0 / 64.0, 64.0, 73)
"""Factors on the velocity gain to try."""


@dataclass(frozen=True)
class NotchDesign:
    """A notch for the resonance of an axis.

    Attributes
    ----------
    resonance : float [Hz]
        Of the axis with its carried mass.
    damping_ratio : float
        Of the resonance.
    frequency : float [Hz]
        Of the notch.
    numerator_damping_ratio, denominator_damping_ratio : float
        Of its zeros and its poles.
    velocity_gain_before, velocity_gain_after : float [command s/m]
        Of the controller; nan if it has none.
    largest_before, largest_after : float [command s/m]
        Largest velocity gain that keeps the margins wherever the resonance moves, without and with the notch; nan if none does.
    margins_before, margins_after : Margins
        With the velocity gain before and after.
    margins_moved : tuple of Margins
        Like `margins_after`, with the resonance `MOVED` lower and higher; empty if the plant does not have it as a parameter.
    """

    resonance: float
    damping_ratio: float
    frequency: float
    numerator_damping_ratio: float
    denominator_damping_ratio: float
    velocity_gain_before: float
    velocity_gain_after: float
    largest_before: float
    largest_after: float
    margins_before: Margins
    margins_after: Margins
    margins_moved: tuple[Margins, ...]


def design_notch(machine: Machine, controller: Controller, name: str, bounds: Bounds | None = None) -> tuple[NotchDesign, Controller]:
    """Return a notch for the resonance of an axis, and the controller with it.

    The controller keeps its gains if the notch keeps the margins with them while the resonance moves by `MOVED`; else its velocity gain
    becomes the largest that does. An integral time is divided by the same factor, so that the velocity loop keeps its damping.

    Parameters
    ----------
    machine, controller
    bounds : Bounds, optional
        Margins to keep; by default 6 dB and 30 degrees.

    Raises
    ------
    ParameterError
        If the axis has no resonance, or it is not below half of the servo frequency.
    ComponentError
        If the loop of the axis has no linear model.

    Notes
    -----
    The zeros of the notch cancel the poles of the resonance, or have a tenth of the damping of the notch's own poles. Among `RATIOS` and
    `WIDTHS`, the notch is the one whose smallest margin, relative to the bounds, is largest while the resonance moves by `MOVED`.
    """
    work, found = _work(machine, name, bounds)
    own = gain = work.velocity_gain(controller)
    notch = work.best(controller, *found)
    most = work.largest(work.having(controller, notch))
    if own > 0.0 and not work.keeps(work.having(controller, notch)):
        # The best notch for gains that are too high need not be the best for the gains that it permits.
        for _ in range(PASSES):
            gain = most if most > 0.0 else gain
            other = work.best(with_velocity_gain(controller, name, gain / own), *found)
            further = work.largest(work.having(controller, other))
            if not further > (most if most > 0.0 else 0.0):
                break
            notch, most = other, further
        gain = most if most > 0.0 else own
    changed = work.having(with_velocity_gain(controller, name, gain / own) if gain != own else controller, notch)
    after, *moved = work.margins(changed)
    design = NotchDesign(
        *found,
        notch.frequency,
        notch.numerator_damping_ratio,
        notch.damping_ratio,
        own,
        gain,
        work.largest(controller),
        most,
        next(work.margins(controller)),
        after,
        tuple(moved),
    )
    return design, changed


def notched(machine: Machine, controller: Controller, name: str) -> Controller:
    """Return the controller with the best notch for its gains; parameters and errors as of `design_notch`."""
    work, found = _work(machine, name, None)
    return work.having(controller, work.best(controller, *found))


def _work(machine: Machine, name: str, bounds: Bounds | None) -> tuple[_Axis, tuple[float, float]]:
    """Return the axis to work on, and frequency and damping ratio of its resonance."""
    found = resonance_of(machine.loaded_plant(name))
    if found is None:
        raise ParameterError(f"axes.{name}.plant", f'"{machine.axis(name).plant.kind}"', "one with a resonance, such as two-mass")
    if 2.0 * found[0] * machine.servo_period >= 1.0:
        bound = f"a resonance below half of the servo frequency, {0.5 / machine.servo_period:g} Hz"
        raise ParameterError(f"axes.{name}.plant", f"{found[0]:g} Hz", bound)
    return _Axis(machine, name, bounds or Bounds()), found


def with_velocity_gain(controller: Controller, name: str, factor: float) -> Controller:
    """Return the controller with the velocity gain of an axis times a factor, and its integral time divided by it."""
    scaled = {dotted.rpartition(".")[2]: value for dotted, value in _scaled(controller, name, factor).items()}
    mine = controller.axes[name]
    made: AxisController = replace(mine, controller=mine.controller.replace(**scaled))
    return replace(controller, axes={**controller.axes, name: made})


def _scaled(controller: Controller, name: str, factor: Any) -> dict[str, Any]:
    """Return velocity gain and integral time for a factor or factors (n,) on the velocity gain, by their dotted names."""
    own, powers = controller.axes[name].controller.values(), {"velocity_gain": 1.0, "integral_time": -1.0}
    kept = {word: power for word, power in powers.items() if math.isfinite(own.get(word, math.inf))}
    return {f"controller.axes.{name}.controller.{word}": own[word] * factor**power for word, power in kept.items()}


@dataclass(frozen=True)
class _Axis:
    """The loop of one axis, with changes."""

    machine: Machine
    name: str
    bounds: Bounds

    @property
    def resonances(self) -> dict[str, Array]:
        """The resonance as it is, lower and higher (3,), by its dotted name; empty if the plant does not have it as a parameter."""
        values = self.machine.axis(self.name).plant.values()
        moves = np.array([1.0, 1.0 - MOVED, 1.0 + MOVED])
        return {f"axes.{self.name}.plant.resonance": values["resonance"] * moves} if "resonance" in values else {}

    def velocity_gain(self, controller: Controller) -> float:
        """Return the velocity gain, nan if the controller has none."""
        return float(controller.axes[self.name].controller.values().get("velocity_gain", math.nan))

    def having(self, controller: Controller, notch: Notch) -> Controller:
        """Return a controller with a notch."""
        mine = controller.axes[self.name]
        others = tuple(pair for pair in mine.filters if pair[0] != NAME)
        return replace(controller, axes={**controller.axes, self.name: replace(mine, filters=((NAME, notch), *others))})

    def margins(self, controller: Controller) -> Iterator[Margins]:
        """Yield the exact margins as it is, and wherever the resonance moves."""
        for values in zip(*(column.tolist() for column in self.resonances.values()), strict=True) if self.resonances else [()]:
            machine, _ = with_values(self.machine, controller, dict(zip(self.resonances, values, strict=True)))
            carried = machine.carried_mass(self.name)
            yield sampled_loop(machine.axis(self.name), controller.axes[self.name], machine.servo_period, carried).margins()

    def keeps(self, controller: Controller) -> bool:
        """Return whether the margins are kept wherever the resonance moves."""
        return not any(map(self.bounds.broken, self.margins(controller)))

    def scores(self, controller: Controller, columns: Mapping[str, Array]) -> Array:
        """Return the smaller of gain and phase margin, over their bounds, for each variant; minus infinity for an unstable loop."""
        machine, mine = self.machine, controller.axes[self.name]
        loops = lane_loops(machine.axis(self.name), mine, machine.servo_period, machine.carried_mass(self.name), columns)
        margins = loops.margins()
        gain, phase = in_db_and_degrees(margins)
        scores = np.minimum(gain / (self.bounds.gain_margin + SLACK[0]), phase / (self.bounds.phase_margin + SLACK[1]))
        return np.where(margins.stable, scores, -math.inf)

    def best(self, controller: Controller, frequency: float, ratio: float) -> Notch:
        """Return the best notch for the gains of a controller."""
        nyquist = 0.5 / self.machine.servo_period
        shapes = [
            (frequency * place, width, zeros)
            for place, width in product(RATIOS, WIDTHS)
            for zeros in (ratio, 0.1 * width)
            if frequency * place < nyquist and zeros < width
        ]
        places = next(iter(self.resonances.values()), np.zeros(1)).size
        columns = {name: np.tile(values, len(shapes)) for name, values in self.resonances.items()}
        for key, column in zip(_SHAPE, np.repeat(shapes, places, axis=0).T, strict=True):
            columns[f"controller.axes.{self.name}.filters.{NAME}.{key}"] = column
        worst = self.scores(self.having(controller, Notch(frequency=frequency)), columns).reshape(len(shapes), -1).min(axis=1)
        return Notch(**dict(zip(_SHAPE, shapes[int(np.argmax(worst))], strict=True)))

    def largest(self, controller: Controller) -> float:
        """Return the largest velocity gain that keeps the bounds, to 0.1 %; nan if none does."""
        own = self.velocity_gain(controller)
        if not own > 0.0:
            return math.nan

        def keeps(factor: float) -> bool:
            return self.keeps(with_velocity_gain(controller, self.name, factor))

        # Margins from a grid may miss a narrow resonance: they only say where to look.
        likely = FACTORS[self.scores(controller, _scaled(controller, self.name, FACTORS)) >= 0.9].tolist()
        low = next(filter(keeps, likely[::-1]), math.nan)
        high = min(FACTORS[low < FACTORS].tolist(), default=low)
        while high > 1.001 * low:
            middle = math.sqrt(low * high)
            low, high = (middle, high) if keeps(middle) else (low, middle)
        return own * low


_SHAPE = ("frequency", "damping_ratio", "numerator_damping_ratio")
