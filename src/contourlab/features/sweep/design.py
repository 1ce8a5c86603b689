"""Designs: where in the unit cube the variants of a chunk lie. Any chunk is computed alone, from the seed and its number."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array

DESIGNS = ("random", "sobol", "latin-hypercube", "grid", "list")
SCRAMBLE = 1 << 64
"""Number in place of that of a chunk, for what all chunks share."""


@dataclass(frozen=True)
class Design:
    """Places of variants in the unit cube.

    Attributes
    ----------
    kind : str
        One of `DESIGNS`.
    variants : int
    chunk : int
        Variants of a chunk, a power of two.
    levels : tuple of int
        Number of values of each dimension of a grid or list; 0 in other designs.
    seed : int
    factor : tuple of tuple of float
        Lower triangular factor of the correlations of a Gaussian copula (n_dimension, n_dimension); empty without correlations.
    """

    kind: str
    variants: int
    chunk: int
    levels: tuple[int, ...]
    seed: int = 0
    factor: tuple[tuple[float, ...], ...] = ()

    @property
    def chunks(self) -> int:
        """Number of chunks; the last one may have fewer variants."""
        return -(-self.variants // self.chunk)

    def numbers(self, chunk: int) -> range:
        """Return the numbers of the variants of a chunk."""
        return range(chunk * self.chunk, min((chunk + 1) * self.chunk, self.variants))

    def places(self, chunk: int) -> Array:
        """Return cumulative probabilities (n_variant, n_dimension), 0 to 1, of the variants of a chunk.

        Notes
        -----
        Random numbers come from the counter-based generator Philox, keyed by seed and chunk. ``"latin-hypercube"`` is replicated: each
        chunk is a Latin hypercube of its own, so that its memory does not grow with the study, and the chunks are independent estimates.

        >>> design = Design("grid", 6, 4, (2, 3))
        >>> (design.places(1) * [2, 3]).astype(int).tolist()
        [[1, 1], [1, 2]]
        """
        numbers, n = self.numbers(chunk), len(self.levels)
        if self.kind in ("grid", "list"):
            row = np.arange(numbers.start, numbers.stop)
            index = np.unravel_index(row, self.levels) if self.kind == "grid" else [row] * n
            return np.column_stack([(i + 0.5) / count for i, count in zip(index, self.levels, strict=True)])
        cube = self._cube(chunk, n)[: len(numbers)]
        if not self.factor:
            return cube
        from scipy.special import ndtr, ndtri

        normal = ndtri(np.clip(cube, 2.0**-60, 1.0 - 2.0**-53))
        # One sum after another: a matrix product may round differently for another number of rows.
        mixed = [sum((normal[:, j] * weight for j, weight in enumerate(row) if weight), np.zeros(len(cube))) for row in self.factor]
        return np.asarray(ndtr(np.column_stack(mixed)))

    def _cube(self, chunk: int, n: int) -> Array:
        if self.kind == "random":
            return _generator(self.seed, chunk).random((self.chunk, n))
        from scipy.stats import qmc

        if self.kind == "latin-hypercube":
            return np.asarray(qmc.LatinHypercube(n, rng=_generator(self.seed, chunk)).random(self.chunk))
        sequence = qmc.Sobol(n, scramble=True, rng=_generator(self.seed, SCRAMBLE))
        if chunk:
            sequence.fast_forward(chunk * self.chunk)
        return np.asarray(sequence.random(self.chunk))


def _generator(seed: int, chunk: int) -> np.random.Generator:
    return np.random.Generator(np.random.Philox(np.random.SeedSequence([seed, chunk])))
