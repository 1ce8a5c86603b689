"""The servo loop as one linear map from tick to tick, computed from the steps that run.

Each state in turn is set to one, and one tick runs. For linear components this gives the exact matrix of the sampled system, hold and delay
included. Its eigenvalues are the poles of the sampled loop, not of a continuous approximation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from contourlab.arrays import Array, Complex, Flags, Index
from contourlab.engine.runner import make_group
from contourlab.engine.step import Node, Schedule, rows
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.errors import ComponentError
from contourlab.native.kernel import kernel

TOGETHER = 256
"""Most variants whose matrices are computed together."""


@dataclass(frozen=True, eq=False)
class TickMap:
    """x(k + 1) = A x(k) + B u(k), where x(k + 1) holds all states, rings and signals at the end of tick k.

    Attributes
    ----------
    a : ndarray (n, n)
    b : ndarray (n, n_external)
        One column for each external of the schedule.
    """

    a: Array
    b: Array
    schedule: Schedule

    def row(self, signal: str) -> int:
        """Return the row of a signal, such as ``"x.plant.position"``, in x."""
        return len(self.a) - self.schedule.n_row + self.schedule.row(signal)

    def column(self, external: str) -> int:
        """Return the row of an external, such as ``"in.reference"``, in u: externals are the first signals."""
        return self.schedule.row(external)


class Probe:
    """Run one tick of `width` variants from any state and inputs."""

    def __init__(self, schedule: Schedule, width: int = 1, first: int = 0, jit: bool = False) -> None:
        self.group = make_group(schedule, width, slice(first, first + width), jit)
        self.n_input, places = rows(schedule.externals), self.group.places
        states = [np.arange(len(part)) + first for first, part in zip(places.states, self.group.state, strict=True)]
        rings = [np.arange(length) + first for first, length in zip(places.rings, places.ring_lengths, strict=False)]
        signals = np.arange(len(self.group.signals))
        self.before = np.concatenate([*states, *rings, signals])
        # Roll ring buffers back by one, so that every tick reads the same entries.
        self.behind = np.concatenate([*states, *(np.roll(ring, -1) for ring in rings), signals])
        self.size, self._no_log = self.before.size, np.empty((1, 0, width))
        # A tick overwrites all signals: of the last tick it reads those of the node itself and of later ones.
        nodes, size = zip(schedule.sources, schedule.first_row, strict=True), self.size - len(signals)
        late = {row for sources, own in nodes for row in sources if isinstance(row, int) and row >= own}
        self.read = [*range(size), *(size + row for row in sorted(late))]
        self.at_rest = self.after(np.zeros(self.size), np.zeros(self.n_input))

    def take(self, nodes: Sequence[Node]) -> None:
        """Take the parameters of nodes that differ from those of the schedule in values only."""
        self.group.take(nodes)
        self.at_rest = self.after(np.zeros(self.size), np.zeros(self.n_input))

    def __call__(self, state: Array, inputs: Array) -> Array:
        """Return the state (n, width) after a tick, without the constants that steps add."""
        return self.after(state, inputs) - self.at_rest

    def after(self, state: Array, inputs: Array) -> Array:
        """Return the state (n, width) after a tick."""
        self.group.memory[self.before] = state[:, None]
        self.group.tick = 0
        self.group.run(inputs[None, :], [], self._no_log)
        return np.asarray(self.group.memory[self.behind])

    def state_matrix(self) -> Array:
        """Return A (n, n, width)."""
        a, none = np.zeros((self.size, self.size, self.group.width)), np.zeros(self.n_input)
        for i in self.read:
            a[:, i] = self(np.eye(1, self.size, i)[0], none)
        return a

    def matrices(self, inputs: Sequence[int] | None = None) -> tuple[Array, Array]:
        """Return A (n, n, width) and B (n, n_input, width); `inputs` are the rows of some externals, instead of all."""
        units = np.eye(self.n_input) if inputs is None else np.eye(self.n_input)[inputs]
        try:
            a = self.state_matrix()
            b = np.stack([self(np.zeros(self.size), unit) for unit in units], axis=1)
            self._check_linear(a, b, units)
        except ArithmeticError as fault:
            raise ComponentError(f"a step cannot be run from a unit state, so the loop has no frequency response: {fault}") from fault
        return a, b

    def _check_linear(self, a: Array, b: Array, units: Array) -> None:
        """Raise `ComponentError` unless the tick agrees with A x + B u at two random points."""
        rng = np.random.default_rng(1)
        for _ in range(2):
            x, u = rng.normal(size=self.size), rng.normal(size=len(units))
            expected, scale = x @ a + u @ b, np.abs(x) @ np.abs(a) + np.abs(u) @ np.abs(b)
            wrong = np.flatnonzero(~(np.abs(self(x, u @ units) - expected) <= 1e-9 * scale).all(axis=1))
            if wrong.size:
                raise ComponentError(f"{self._owners()[wrong[0]]} is not linear, so the loop has no frequency response")

    def _owners(self) -> list[str]:
        """Return the node of each entry of the state."""
        nodes = self.group.schedule.nodes
        parts = [*zip(nodes, self.group.state, strict=True), *zip(nodes, self.group.rings, strict=True)]
        owners = [node.name for node, part in parts for _ in part]
        return [*owners, *["in"] * self.n_input, *(node.name for node in nodes for _ in range(rows(node.step.outputs)))]


def tick_matrix(schedule: Schedule) -> Array:
    """Return the matrix (n, n) that takes all states, rings and signals of a schedule to the next tick, inputs at zero.

    Parameters
    ----------
    schedule : Schedule
        Linear steps, each run at every tick; constants that a step adds are subtracted.
    """
    return np.ascontiguousarray(Probe(schedule).state_matrix()[:, :, 0])


def tick_map(schedule: Schedule) -> TickMap:
    """Return the map from states and externals to the next tick.

    Parameters
    ----------
    schedule : Schedule
        Each step run at every tick.

    Raises
    ------
    ComponentError
        If a step is not linear; it names the node.
    """
    a, b = Probe(schedule).matrices()
    return TickMap(np.ascontiguousarray(a[:, :, 0]), np.ascontiguousarray(b[:, :, 0]), schedule)


def lane_probes(schedule: Schedule, n: int, jit: bool) -> list[Probe]:
    """Return probes of the n variants of a schedule."""
    return [Probe(schedule, -(-min(n - first, TOGETHER) // VECTOR) * VECTOR, first, jit) for first in range(0, n, TOGETHER)]


def lane_matrices(probes: Sequence[Probe], n: int, inputs: Sequence[int] | None = None) -> tuple[Array, Array]:
    """Return A (n, m, m) and B (n, m, n_input) of n variants, computed together; `inputs` as of `Probe.matrices`.

    Raises
    ------
    ComponentError
        If a step is not linear; it names the node.
    """
    parts = [probe.matrices(inputs) for probe in probes]
    a, b = (np.concatenate([np.moveaxis(part[i], 2, 0) for part in parts])[:n] for i in (0, 1))
    return a, b


def spectral_radius(schedule: Schedule) -> float:
    """Return the largest magnitude of the poles of the sampled loop: below 1 it is stable.

    States that only store a value (a start position, values of the watch) and sums that nothing reads (an integral without a gain) do not
    count.
    """
    return float(np.abs(poles_of(tick_matrix(schedule))).max(initial=0.0))


def poles_of(matrix: Array) -> Complex:
    """Return the eigenvalues of a tick matrix that belong to the loop; some eigenvalues at zero are left out."""
    kept = loop_states(matrix)
    return np.asarray(np.linalg.eigvals(matrix[np.ix_(kept, kept)]), dtype=complex)


def poles_of_each(matrices: Array) -> Complex:
    """Return `poles_of` for matrices (n_variant, n, n) as (n_variant, n), filled up with zeros; infinite where one is not finite."""
    poles = np.zeros(matrices.shape[:2], dtype=complex)
    finite = np.isfinite(matrices).all(axis=(1, 2))
    poles[~finite] = np.inf
    # A gain of zero in one variant takes states out of its loop, so variants of the same form go together.
    form = np.concatenate([matrices != 0.0, matrices == np.eye(matrices.shape[1])], axis=1).reshape(len(matrices), -1)
    first, kind = np.arange(len(form))[:1], np.zeros(len(form), dtype=np.intp)
    if (form != form[:1]).any():
        _, first, kind = np.unique(np.packbits(form, axis=1), axis=0, return_index=True, return_inverse=True)
    for k, i in enumerate(first):
        rows, kept = np.flatnonzero((kind == k) & finite), loop_states(matrices[i])
        poles[rows, : kept.size] = np.linalg.eigvals(matrices[np.ix_(rows, kept, kept)])
    return poles


SQUARINGS, GROWN = 14, 1e4
"""Most squarings of a matrix to prove that it is stable, and the largest norm on the way: below it rounding does not matter."""


def proved_stable(matrices: Array | Complex) -> Flags:
    """Return for which matrices (n_variant, n, n) a power has a norm below 1: all their eigenvalues lie inside the unit circle.

    This takes a fraction of the time of eigenvalues. It leaves open whether the others are stable.
    """
    proved = np.zeros(len(matrices), dtype=bool)
    left = np.flatnonzero(_norms(matrices) < GROWN)
    power = matrices[left]
    for _ in range(SQUARINGS):
        power = power @ power
        norm = _norms(power)
        going = (norm >= 0.5) & (norm < GROWN)
        if not going.all():
            proved[left[norm < 0.5]] = True
            power, left = power[going], left[going]
    return proved


def _norms(matrices: Array | Complex) -> Array:
    parts = np.ascontiguousarray(matrices).view(float)
    return np.asarray(np.sqrt(np.einsum("vij,vij->v", parts, parts)))


def loop_states(matrix: Array) -> Index:
    """Return the states of a tick matrix that belong to the loop: not those that only store a value, and sums that nothing reads."""
    moved = matrix != np.eye(len(matrix))
    kept = np.flatnonzero(moved.any(axis=1) & moved.any(axis=0))
    # States outside the loop only add eigenvalues at zero, whose chains amplify rounding.
    return kept[live_states(matrix[np.ix_(kept, kept)] != 0.0)]


def live_states(links: Flags, driven: Flags | bool = False, read: Flags | bool = False) -> Index:
    """Return the states that a state or input drives, and that a state or output reads.

    Parameters
    ----------
    links : ndarray (n, n) of bool
        Whether the column's state drives the row's state.
    driven, read : ndarray (n,) of bool, optional
        Whether an input drives a state, and whether an output reads it.
    """
    n = len(links)
    return _live(links.tobytes(), np.broadcast_to(driven, n).tobytes(), np.broadcast_to(read, n).tobytes())


@lru_cache(256)  # variants of one loop have the same links
def _live(linked: bytes, driving: bytes, reading: bytes) -> Index:
    driven, read = (np.frombuffer(flags, bool) for flags in (driving, reading))
    kept, links = np.arange(driven.size), np.frombuffer(linked, bool).reshape(2 * driven.shape)
    while True:
        part = links[np.ix_(kept, kept)]
        live = (part.any(axis=1) | driven[kept]) & (part.any(axis=0) | read[kept])
        if live.all():
            return kept
        kept = kept[live]


class DelayForm:
    """C (z I - A)^-1 B, prepared for many z.

    States that only copy another state one tick later, as in a transport delay, become powers of 1/z: the system to solve at each frequency
    stays small, however long the delay.

    Parameters
    ----------
    a : ndarray (n, n)
    b : ndarray (n, n_input)
    c : ndarray (n_output, n)
    """

    def __init__(self, a: Array, b: Array, c: Array) -> None:
        kept = live_states(a != 0.0, True, (c != 0.0).any(axis=0))
        kept = kept if kept.size else np.arange(min(1, len(a)))  # no state reaches an output: any one will do
        a, b, c = a[np.ix_(kept, kept)], b[kept], c[:, kept]
        root, lag = _chains((a != 0.0).tobytes(), (a == 1.0).tobytes(), b.any(axis=1).tobytes())
        heads = np.flatnonzero(lag == 0)
        place = np.searchsorted(heads, root)
        self._shape = (len(c), b.shape[1])
        self._numbers = (*_terms(a[heads], place, lag, heads.size), *_terms(c, place, lag, heads.size), b[heads].copy())
        self.longest = int(lag.max(initial=0))

    def __call__(self, z: Complex) -> Complex:
        """Return the responses (n, n_output, n_input) at z (n,)."""
        found = np.empty((z.size, *self._shape), dtype=complex)
        n = len(self._numbers[-1])
        parts = np.ascontiguousarray(z, dtype=complex).view(float).reshape(-1, 2)
        respond(parts, *self._numbers, np.empty((n, n + self._shape[1], 2)), found.view(float))
        return found


def _power(z, n):  # type: ignore[no-untyped-def]
    """Return the n-th power of a complex number, n >= 0."""
    found = complex(1.0, 0.0)
    while n > 0:
        found = found * z if n & 1 else found
        z, n = z * z, n >> 1
    return found


@kernel("f8[:,:] i8[:] f8[:,:,:] i8[:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:,:]")
def respond(z, lags, a, lags_out, c, b, rows, found):  # type: ignore[no-untyped-def]
    """Solve (z I - sum of a_d z^-lag_d) x = b at each z (n, 2), by elimination; write the sum of c_d z^-lag_d x into `found`.

    Complex numbers are pairs of numbers at the end of an array. `rows` (m, m + n_input, 2) is memory for the system.
    """
    m, columns = rows.shape[0], rows.shape[1]
    for i in range(z.shape[0]):
        at = complex(z[i, 0], z[i, 1])
        back = 1.0 / at
        for j in range(m):
            for k in range(columns):
                rows[j, k, 0], rows[j, k, 1] = b[j, k - m] if k >= m else at.real if j == k else 0.0, at.imag if j == k else 0.0
        for d in range(lags.size):
            turn = _power(back, lags[d])  # type: ignore[no-untyped-call]
            for j in range(m):
                for k in range(m):
                    rows[j, k, 0], rows[j, k, 1] = rows[j, k, 0] - turn.real * a[d, j, k], rows[j, k, 1] - turn.imag * a[d, j, k]
        for j in range(m):
            best = j
            for k in range(j + 1, m):
                if abs(rows[k, j, 0]) + abs(rows[k, j, 1]) > abs(rows[best, j, 0]) + abs(rows[best, j, 1]):
                    best = k
            for k in range(j, columns if best > j else j):
                for part in range(2):
                    rows[j, k, part], rows[best, k, part] = rows[best, k, part], rows[j, k, part]
            pivot = 1.0 / complex(rows[j, j, 0], rows[j, j, 1])
            for k in range(j + 1, m):
                factor = complex(rows[k, j, 0], rows[k, j, 1]) * pivot
                for q in range(j + 1, columns if factor != 0.0 else j + 1):
                    value = complex(rows[k, q, 0], rows[k, q, 1]) - factor * complex(rows[j, q, 0], rows[j, q, 1])
                    rows[k, q, 0], rows[k, q, 1] = value.real, value.imag
        for q in range(m, columns):
            for j in range(m - 1, -1, -1):
                value = complex(rows[j, q, 0], rows[j, q, 1])
                for k in range(j + 1, m):
                    value -= complex(rows[j, k, 0], rows[j, k, 1]) * complex(rows[k, q, 0], rows[k, q, 1])
                value = value / complex(rows[j, j, 0], rows[j, j, 1])
                rows[j, q, 0], rows[j, q, 1] = value.real, value.imag
            for out in range(found.shape[1]):
                value = complex(0.0, 0.0)
                for d in range(lags_out.size):
                    total = complex(0.0, 0.0)
                    for j in range(m):
                        total += c[d, out, j] * complex(rows[j, q, 0], rows[j, q, 1])
                    value += _power(back, lags_out[d]) * total  # type: ignore[no-untyped-call]
                found[i, out, 2 * (q - m)], found[i, out, 2 * (q - m) + 1] = value.real, value.imag


@lru_cache(256)
def _chains(linked: bytes, equal: bytes, driven: bytes) -> tuple[Index, Index]:
    """Return for each state the state that it copies and the delay in ticks; itself and 0 if it is not a copy.

    Parameters
    ----------
    linked, equal : bytes
        Which of A (n, n) are not 0, and which are 1.
    driven : bytes
        Which states an input drives.
    """
    n = len(driven)
    links, ones = (np.frombuffer(flags, bool).reshape(n, n) for flags in (linked, equal))
    before = np.argmax(links, axis=1)
    passes = (links.sum(axis=1) == 1) & ones[np.arange(n), before] & ~np.frombuffer(driven, bool)
    root, lag = np.arange(n), np.zeros(n, dtype=np.intp)
    for i in range(n):
        at, ticks = i, 0
        while passes[at] and ticks < n:
            at, ticks = int(before[at]), ticks + 1
        # A closed ring of copies has no head: keep its states.
        if ticks < n:
            root[i], lag[i] = at, ticks
    return root, lag


def _terms(rows: Array, place: Index, lag: Index, n: int) -> tuple[Index, Array]:
    """Group columns by their lag: return the lags, and the terms (n_lag, n_row, n) of rows x = sum of term_d z^-lag_d x_heads."""
    ticks, of = np.unique(np.append(0, lag), return_inverse=True)
    terms = np.zeros((ticks.size, n, len(rows)))
    np.add.at(terms, (of[1:], place), rows.T)
    used = np.flatnonzero(terms.any(axis=(1, 2)))
    return ticks[used], terms[used].transpose(0, 2, 1).copy()
