"""Ghaffari & Ulsoy, against their reference 6: integral sliding mode, modified error, and the variable-gain coupling that both replace.

Reference 6 (IEEE/ASME Trans. Mechatronics 21, 2016) modifies the error of each axis and rejects disturbances by integral sliding mode. The
paper prints no figure of it, nor of a variable-gain coupling. So these rows have nothing to compare with.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.coupling.laws import CrossCoupled, ModifiedError
from contourlab.components.estimator.local import KorenLo
from contourlab.components.observer.integral_sliding import IntegralSliding
from contourlab.components.observer.super_twisting import SuperTwisting
from contourlab.loop import Controller, simulate
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge
from contourlab.papers.ghaffari.setup import TABLE_3, Reading, circle, controller, machine
from contourlab.papers.rows import Row, identity, ours

READING = Reading()
LIMITS = (1.0, 2.0)
"""Largest estimates M of the integral sliding mode, over full scale: what a drive can give, and enough for the model of Table III."""
RATE = 10.0
"""Largest rate of the disturbance for super-twisting [full scale/s]."""
SAME_WEIGHT = 1.0 / (1.0 - READING.weight) - 1.0
"""Gain of a coupling over K_P that weights the error across the path against that along it as lambda does."""
COUNT = 1e6 * READING.resolution
"""A count of the encoder [um]."""
_MICRO = 1e6


def reference_6_rows() -> Iterator[Row]:
    """Yield the rows on couplings and observers, for both configurations."""
    for first in (1, 2):
        base = controller(first, TABLE_3, READING)
        _, stated = _run(first, base)
        error = replace(base, coupling=ModifiedError(weight=READING.weight))
        integral, position = _run(first, error)
        name, apart = "modified error and modified reference: positions apart, at most", _MICRO * float(np.abs(position - stated).max())
        yield identity(name, f"A3-A{first}", 0.0, apart, "um", 2.01 * COUNT, "two counts of the encoder are allowed")
        yield _row(first, "modified error", integral, "one number, lambda; the loops of the axes stay, as under the modified reference")
        gain = SAME_WEIGHT * TABLE_3[first].position_gain * 1e3
        for words, rate, number in (("P", 0.0, "one number"), ("PI", TABLE_3[first].integral_gain, "two numbers")):
            coupling = CrossCoupled(gain=gain, integral_rate=rate)
            integral, _ = _run(first, replace(base, estimator=KorenLo(), coupling=coupling))
            note = f"{number} in G_c, and the gains C_1 and C_2 at each tick; {SAME_WEIGHT:g} K_P weights the normal as lambda does"
            yield _row(first, f"variable-gain coupling, {words}", integral, note)
        for limit in LIMITS:
            sliding = _observed(error, partial(_sliding, limit))
            note = f"reference 6 as we read it; modulus margins {_margins(first, sliding)}, with the observer {_margins(first, error)}"
            yield _row(first, f"integral sliding, M {limit:g}, modified error", _run(first, sliding)[0], note)
        twisting = _observed(base, _twisting)
        yield _row(first, f"super-twisting, L {RATE:g} 1/s", _run(first, twisting)[0], "no bandwidth to choose, and no margins")


def _row(first: int, words: str, integral: float, note: str) -> Row:
    case, name = f"A3-A{first}, {words}", "contour error integral beside reference 6"
    return ours(name, case, integral, "um s", f"the paper prints no figure; {note}")


def _sliding(limit: float, seen: Any) -> Component:
    return IntegralSliding(limit=limit, bandwidth=READING.bandwidth, model_gain=seen.model_gain, model_damping=seen.model_damping)


def _twisting(seen: Any) -> Component:
    return SuperTwisting(disturbance_rate=RATE, model_gain=seen.model_gain, model_damping=seen.model_damping)


def _observed(made: Controller, observer: Callable[[Any], Component]) -> Controller:
    return replace(made, axes={name: replace(part, observer=observer(part.observer)) for name, part in made.axes.items()})


def _run(first: int, made: Controller) -> tuple[float, Array]:
    """Return the integral [um s] over the second lap, and the positions [m] (n_sample, 2)."""
    reference = circle(READING)
    judged = judge(simulate(machine(first, READING), made, reference), reference)
    return _MICRO * summarise(judged, reference).contour_error.integral, judged.signals["position"].data


def _margins(first: int, made: Controller) -> str:
    """Return the modulus margins of both axes, inside the layer."""
    stage = machine(first, READING)
    loops = (sampled_loop(axis, made.axes[axis.name], READING.servo_period) for axis in stage.axes)
    return " and ".join(f"{loop.margins().modulus:.2f}" for loop in loops)
