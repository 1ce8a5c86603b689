"""Frequency responses of large, sparse tick matrices: states that only copy another state one tick later become powers of 1/z.

A transport delay is a chain of such states. Without them the system to solve at each frequency stays small, however long the delay.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
_Terms = list[tuple[int, Array]]


class DelayForm:
    """C (z I - A)^-1 B, prepared for many z.

    Parameters
    ----------
    a : ndarray (n, n)
    b : ndarray (n, n_input)
    c : ndarray (n_output, n)
    """

    def __init__(self, a: Array, b: Array, c: Array) -> None:
        kept = _read(a, c)
        a, b, c = a[np.ix_(kept, kept)], b[kept], c[:, kept]
        root, lag = _chains(a, b)
        heads = np.flatnonzero(lag == 0)
        place = np.searchsorted(heads, root)
        self._b = b[heads].astype(complex)
        self._a, self._c = (_terms(rows, place, lag, heads.size) for rows in (a[heads], c))
        self.longest = int(lag.max(initial=0))

    def __call__(self, z: Complex) -> Complex:
        """Return the responses (n, n_output, n_input) at z (n,)."""
        matrix = z[:, None, None] * np.eye(len(self._b)) - _sum(self._a, z)
        return np.asarray(_sum(self._c, z) @ np.linalg.solve(matrix, np.broadcast_to(self._b, (z.size, *self._b.shape))))


def _read(a: Array, c: Array) -> NDArray[np.intp]:
    """Return the states that reach an output; all remaining ones if none does."""
    kept = np.arange(len(a))
    while True:
        seen = a[np.ix_(kept, kept)].any(axis=0) | c[:, kept].any(axis=0)
        if seen.all() or not seen.any():
            return kept
        kept = kept[seen]


def _chains(a: Array, b: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return for each state the one that it copies, and how many ticks late; itself and 0 for all others."""
    n = len(a)
    before = np.argmax(a != 0.0, axis=1)
    passes = ((a != 0.0).sum(axis=1) == 1) & (a[np.arange(n), before] == 1.0) & ~b.any(axis=1)
    root, lag = np.arange(n), np.zeros(n, dtype=np.intp)
    for i in range(n):
        at, ticks = i, 0
        while passes[at] and ticks < n:
            at, ticks = int(before[at]), ticks + 1
        # A ring that copies only itself has no head: it stays.
        if ticks < n:
            root[i], lag[i] = at, ticks
    return root, lag


def _terms(rows: Array, place: NDArray[np.intp], lag: NDArray[np.intp], n: int) -> _Terms:
    """Sort columns by their lag: rows x = sum of term_d z^-d x_heads."""
    found = []
    for ticks in np.unique(lag):
        term = np.zeros((len(rows), n))
        of = np.flatnonzero(lag == ticks)
        np.add.at(term.T, place[of], rows[:, of].T)
        if term.any() or ticks == 0:
            found.append((int(ticks), term))
    return found


def _sum(terms: _Terms, z: Complex) -> Complex:
    """Return the sum of term_d z^-d for each z."""
    total = np.zeros((z.size, *terms[0][1].shape), dtype=complex)
    for ticks, term in terms:
        total += (z**-ticks)[:, None, None] * term
    return total
