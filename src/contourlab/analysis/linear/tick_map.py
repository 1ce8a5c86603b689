"""The loop as one linear map from tick to tick, taken from the very steps that are simulated.

Every state is moved by one unit in turn and one tick is run in plain Python; for a loop of linear components this gives the exact matrix of
the sampled system, hold and delay included. Its eigenvalues are the poles of what runs, not of a continuous idealisation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.runner import make_group
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import rows
from contourlab.errors import ComponentError

Array = NDArray[np.float64]

@dataclass(frozen=True, eq=False)
class TickMap:
    """x(k + 1) = A x(k) + B u(k), where x(k + 1) holds all states, rings and signals as they stand at the end of tick k.

    Attributes
    ----------
    a : ndarray (n, n)
    b : ndarray (n, n_external)
        One column for each row of the schedule's externals.
    schedule : Schedule
        What it was taken from.
    """

    a: Array
    b: Array
    schedule: Schedule

    def row(self, signal: str) -> int:
        """Return where a signal, such as ``"x.plant.position"``, stands in x."""
        return len(self.a) - self.schedule.n_row + self.schedule.row(signal)

    def column(self, external: str) -> int:
        """Return where an external, such as ``"in.reference"``, stands in u: externals are the first signals."""
        return self.schedule.row(external)


class _Prober:
    """One tick of a schedule, run from any state under any inputs."""

    def __init__(self, schedule: Schedule) -> None:
        self.group = make_group(schedule, 1, slice(0, 1), False)
        self.parts = [*self.group.state, *self.group.rings, self.group.signals]
        self.n_input = rows(schedule.externals)
        self.size = sum(part.size for part in self.parts)
        self.at_rest = self._after(np.zeros(self.size), np.zeros(self.n_input))

    def __call__(self, state: Array, inputs: Array) -> Array:
        """Return what a tick makes of a state and inputs, beyond the constants that steps add of their own."""
        return self._after(state, inputs) - self.at_rest

    def _after(self, state: Array, inputs: Array) -> Array:
        start = 0
        for part in self.parts:
            part[:] = state[start : start + part.size].reshape(part.shape)
            start += part.size
        self.group.tick = 0
        self.group.run(inputs[None, :], [])
        # Rings are written round and round: turned back by one, they stand at the next tick as they stood at this one.
        for ring in self.group.rings:
            ring[:] = np.roll(ring, -1, axis=0)
        return np.concatenate([part.ravel() for part in self.parts])

    def owners(self) -> list[str]:
        """Return what each entry of the state belongs to, for messages."""
        nodes: list[str] = []
        for group in (self.group.state, self.group.rings):
            for node, part in zip(self.group.schedule.nodes, group, strict=True):
                nodes += [node.name] * part.size
        signals = ["in"] * self.n_input
        for node in self.group.schedule.nodes:
            signals += [node.name] * rows(node.step.outputs)
        return nodes + signals


def tick_matrix(schedule: Schedule) -> Array:
    """Return the matrix (n, n) that takes all states, rings and signals of a schedule to the next tick, inputs at zero.

    Parameters
    ----------
    schedule : Schedule
        Of linear steps, each run at every tick; constants that a step adds of its own are taken out.
    """
    return _states_of(_Prober(schedule))


def tick_map(schedule: Schedule) -> TickMap:
    """Return the same matrix with that of the externals, for steps that are made sure to be linear.

    Parameters
    ----------
    schedule : Schedule
        Each step run at every tick.

    Raises
    ------
    ComponentError
        If a step is not linear; it names the node.
    """
    probe = _Prober(schedule)
    try:
        a = _states_of(probe)
        b = np.column_stack([probe(np.zeros(probe.size), unit) for unit in np.eye(probe.n_input)])
        # Any point will do, as long as it is of no special kind: two steps that agree with A x + B u at all of them are not by chance.
        rng = np.random.default_rng(1)
        for _ in range(2):
            x, u = rng.normal(size=probe.size), rng.normal(size=probe.n_input)
            scale = np.abs(a) @ np.abs(x) + np.abs(b) @ np.abs(u)
            wrong = np.flatnonzero(~(np.abs(probe(x, u) - a @ x - b @ u) <= 1e-9 * scale))
            if wrong.size:
                raise ComponentError(f"{probe.owners()[wrong[0]]} is not linear, so the loop has no frequency response")
    except ArithmeticError as fault:
        raise ComponentError(f"a step cannot be run from a unit of its states, so the loop has no frequency response: {fault}") from fault
    return TickMap(a, b, schedule)


def spectral_radius(schedule: Schedule) -> float:
    """Return the largest magnitude of the poles of the sampled loop: below 1 it is stable.

    States that only remember what they were given at the start (where an axis stood, what the watch has noted), and those that sum up
    what nothing reads (an integral without a gain), are no part of the loop.
    """
    return float(np.abs(poles_of(tick_matrix(schedule))).max(initial=0.0))


def poles_of(matrix: Array) -> NDArray[np.complex128]:
    """Return the eigenvalues of a tick matrix that are part of the loop; those at zero, which end at once, may be left out."""
    apart = matrix != np.eye(len(matrix))
    kept = np.flatnonzero(apart.any(axis=1) & apart.any(axis=0))
    while True:
        part = matrix[np.ix_(kept, kept)]
        # What nothing reads, and what takes in nothing, adds a zero only: without them fewer zeros stand in chains, where rounding grows.
        moves = part.any(axis=1) & part.any(axis=0)
        if moves.all():
            return np.asarray(np.linalg.eigvals(part), dtype=complex)
        kept = kept[moves]


def _states_of(probe: _Prober) -> Array:
    none = np.zeros(probe.n_input)
    return np.column_stack([probe(unit, none) for unit in np.eye(probe.size)])
