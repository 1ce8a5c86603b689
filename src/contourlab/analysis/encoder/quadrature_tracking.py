"""The recursive fit of quadrature signals over a record, by the very step that the sensor component runs at each tick.

References
----------
E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.encoder.quadrature import QuadratureConstants
from contourlab.components.quadrature import DERIVED, LEAST_COVARIANCE, STATES, TABLES, TUNING, arctangents, followed
from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Node, Schedule
from contourlab.engine.step import Port, Step
from contourlab.errors import ParameterError
from contourlab.loop.simulate import jit_enabled

Array = NDArray[np.float64]
Whole = NDArray[np.int64]
BLOCK = 1 << 16


@dataclass(frozen=True, eq=False)
class Tracked:
    """Signals corrected on line.

    Parameters
    ----------
    u1, u2 : ndarray (n,)
        Corrected, over the nominal amplitude.
    sample : ndarray of int (m,)
        Samples at which the fit is told.
    coefficients : ndarray (m, 5)
        A .. E there, of the signals over the nominal amplitude.
    amplitude : float
        The nominal one.
    updated : ndarray of bool (n,)
        Samples from which the fit has learnt.
    """

    u1: Array
    u2: Array
    sample: Whole
    coefficients: Array
    amplitude: float
    updated: NDArray[np.bool_]

    def constants(self, index: int = -1) -> QuadratureConstants:
        """Return the constants at one of the samples that are told, the last by default, in the unit of the signals.

        Raises
        ------
        ParameterError
            If the coefficients are those of no ellipse.
        """
        found = QuadratureConstants.from_coefficients(*(float(value) for value in self.coefficients[index]))
        scaled = {name: getattr(found, name) * self.amplitude for name in ("offset_1", "offset_2", "amplitude")}
        return replace(found, **scaled)


def _track(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    states, (u1, u2) = followed(par, x, inp.u1 / par.amplitude, inp.u2 / par.amplitude, x.turns)
    return states, (u1, u2, states[4], states[3])


def track_ellipse(
    u1: ArrayLike,
    u2: ArrayLike,
    start: QuadratureConstants,
    *,
    forgetting: float = 0.998,
    initial_covariance: float = 10.0,
    update_travel: float = 1.0 / 32.0,
    told: int = 1024,
) -> Tracked:
    """Correct signals sample by sample, as a controller does: recursive least squares with forgetting and covariance resetting.

    Parameters
    ----------
    u1, u2 : array_like (n,)
        Measured; each sample is corrected with what was known before it. Not finite values are for the caller to refuse.
    start : QuadratureConstants
        What is known at the beginning; its amplitude is the nominal one.
    forgetting : float, 0.9 to 1
        lambda, for each update; 0.995 to 0.9995 is usual. The memory is 1/(1 - lambda) updates.
    initial_covariance : float, >= 40 (1 - lambda)
        Of each coefficient, over the squared noise. Greater: what is known at the beginning counts for less.
    update_travel : float, > 0
        Travel between two updates, in pitches. An axis that stands, or dithers within a pitch, causes none.
    told : int, >= 2
        At how many samples the coefficients are kept.

    Raises
    ------
    ParameterError
        If a number is out of its range.
    """
    first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
    if first.ndim != 1 or first.shape != second.shape or first.size == 0:
        raise ParameterError("signals", f"{first.shape} and {second.shape}", "two records of one length")
    for name, value, low, high in (
        ("forgetting", forgetting, 0.9, 1.0),
        ("initial_covariance", initial_covariance, LEAST_COVARIANCE * (1.0 - forgetting), 1e6),
        ("update_travel", update_travel, 1e-4, 10.0),
        ("told", told, 2, 1 << 30),
    ):
        if not low <= value <= high:
            raise ParameterError(name, value, f"from {low:g} to {high:g}")
    size = start.amplitude
    theta = replace(start, offset_1=start.offset_1 / size, offset_2=start.offset_2 / size, amplitude=1.0).coefficients()
    group, rows = _group({**dict(zip(DERIVED, theta, strict=True)), "amplitude": size}, (forgetting, initial_covariance, update_travel))
    n = first.size
    chosen = np.unique(np.linspace(0, n - 1, min(n, told)).astype(np.int64))
    out, kept = np.empty((3, n)), []
    for at in range(0, n, BLOCK):
        part = slice(at, min(at + BLOCK, n))
        log = group.run(np.column_stack([first[part], second[part]]), rows)[:, :, 0]
        out[:, part] = log[:, [0, 1, 7]].T
        kept.append(log[chosen[(chosen >= at) & (chosen < part.stop)] - at, 2:7])
    # The place of the last update moves with each one, and the first sample is one.
    updated = np.diff(out[2], prepend=np.nan) != 0.0
    return Tracked(out[0], out[1], chosen, np.concatenate(kept), size, updated)


def _group(parameters: dict[str, float], tuning: tuple[float, float, float]) -> tuple[Group, list[int]]:
    """Return the engine's group that runs the recursive fit, and the rows of its outputs."""
    outputs = (Port("u1"), Port("u2"), Port("theta", 5), Port("used"))
    step = Step("quadrature", _track, ("amplitude", *TUNING, *DERIVED), TABLES, "", STATES, (Port("u1"), Port("u2")), outputs)
    values = {**parameters, **dict(zip(TUNING, tuning, strict=True))}
    node = Node("fit", step, {"u1": "in.u1", "u2": "in.u2"}, values, {"arctangent": arctangents()})
    schedule = Schedule((node,), step.inputs, 1.0, 1)
    first = schedule.row("fit.u1")
    return make_group(schedule, 1, slice(0, 1), jit=jit_enabled()), list(range(first, first + 8))
