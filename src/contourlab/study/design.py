"""Designs: where in the unit cube the variants of a chunk lie. Any chunk is computed alone, from the seed and its number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.study.space import TAILS

INDEPENDENT, FIXED = ("random", "sobol", "latin-hypercube"), ("grid", "list")
DRAWN = (*INDEPENDENT, "saltelli")
"""Designs that draw their variants; each draw on its own, or, in `FIXED`, the values of the study."""
LEVELS = 4
"""Levels of Morris' design."""
SCRAMBLE = 1 << 64
"""Number in place of that of a chunk, for what all chunks share."""


@dataclass(frozen=True)
class Modules:
    """Modules of one kind, drawn once each and paired with all modules of the other kinds.

    Attributes
    ----------
    name : str
        Beginning of the names of their parameters, such as ``axes.x``.
    count : int
    dimensions : tuple of int
        Dimensions of the design that belong to a module.
    listed : tuple of int
        Those of them that a file lists, one value for each module.
    """

    name: str
    count: int
    dimensions: tuple[int, ...]
    listed: tuple[int, ...] = ()

    @property
    def column(self) -> str:
        """Column of the number of the module."""
        return f"{self.name}.module"


class Chunked:
    """Variants, by number, in chunks of equal size; the last one may have fewer."""

    variants: int
    chunk: int

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return -(-self.variants // self.chunk)

    def numbers(self, chunk: int) -> range:
        """Return the numbers of the variants of a chunk."""
        return range(chunk * self.chunk, min((chunk + 1) * self.chunk, self.variants))


@dataclass(frozen=True)
class Design(Chunked):
    """Places of variants in the unit cube.

    Attributes
    ----------
    kind : str
        One of `DRAWN` or `FIXED`.
    variants : int
    chunk : int
        Variants of a chunk, a power of two.
    levels : tuple of int
        Number of values of each dimension of a grid or list; 0 in other designs, and for what belongs to modules.
    seed : int
    factor : tuple of tuple of float
        Lower triangular factor of the correlations of a Gaussian copula (n_dimension, n_dimension); empty without correlations.
    modules : tuple of Modules
        Each variant is a pairing of one module of each kind, in every combination with the values of the other dimensions.
    """

    kind: str
    variants: int
    chunk: int
    levels: tuple[int, ...]
    seed: int = 0
    factor: tuple[tuple[float, ...], ...] = ()
    modules: tuple[Modules, ...] = ()

    @property
    def group(self) -> int:
        """Number of successive variants that share a draw."""
        return len(self.levels) + 2 if self.kind == "saltelli" else 1

    def places(self, chunk: int) -> Array:
        """Return cumulative probabilities (n_variant, n_dimension), 0 to 1, of the variants of a chunk.

        Notes
        -----
        Random numbers come from the counter-based generator Philox, keyed by seed and chunk. ``"latin-hypercube"`` is replicated: each
        chunk is a Latin hypercube of its own, so that its memory does not grow with the study, and the chunks are independent estimates.
        ``"saltelli"`` has groups of n_dimension + 2 variants: two draws A and B, and A with one dimension after the other from B.

        >>> design = Design("grid", 6, 4, (2, 3))
        >>> (design.places(1) * [2, 3]).astype(int).tolist()
        [[1, 1], [1, 2]]
        """
        rows, n = len(self.numbers(chunk)), len(self.levels)
        if self.kind == "saltelli":
            return self._saltelli(chunk, n)
        if self.kind not in FIXED and not self.modules:
            return self._mixed(self._cube(chunk, n, self.chunk)[:rows])
        places, index = np.empty((rows, n)), self._index(chunk)
        for one, which in zip(self.modules, index, strict=False):
            dimensions = list(one.dimensions)
            places[:, dimensions] = self._drawn(one)[which][:, dimensions]
            places[:, list(one.listed)] = ((which + 0.5) / one.count)[:, None]
        gridded = [i for i, count in enumerate(self.levels) if count]
        for i, which in zip(gridded, index[len(self.modules) :], strict=True):
            places[:, i] = (which + 0.5) / self.levels[i]
        return places

    def members(self, chunk: int) -> dict[str, Index]:
        """Return the number of the module of each kind (n_variant,), by its column."""
        return {one.column: which for one, which in zip(self.modules, self._index(chunk), strict=False)} if self.modules else {}

    def _index(self, chunk: int) -> Sequence[Index]:
        """Return the module of each kind, then the value of each dimension that has levels."""
        numbers = self.numbers(chunk)
        row = np.arange(numbers.start, numbers.stop)
        if self.kind == "list":
            return [row] * len(self.levels)
        return np.unravel_index(row, [*(one.count for one in self.modules), *filter(None, self.levels)])

    def _drawn(self, modules: Modules) -> Array:
        """Return the places (n_module, n_dimension) of all modules of a kind, drawn apart from the other kinds."""
        key = SCRAMBLE + 1 + self.modules.index(modules)
        return self._mixed(self._cube(key, len(self.levels), modules.count))

    def _mixed(self, cube: Array) -> Array:
        """Return places with the correlations, within `TAILS`."""
        cube = np.clip(cube, *TAILS)
        if not self.factor:
            return cube
        from scipy.special import ndtr, ndtri

        normal = ndtri(cube)
        # One sum after another: a matrix product may round differently for another number of rows.
        mixed = [sum((normal[:, j] * weight for j, weight in enumerate(row) if weight), np.zeros(len(cube))) for row in self.factor]
        return np.asarray(np.clip(ndtr(np.column_stack(mixed)), *TAILS))

    def _saltelli(self, chunk: int, n: int) -> Array:
        numbers = self.numbers(chunk)
        group, which = np.divmod(np.arange(numbers.start, numbers.stop), self.group)
        both = self._sobol(2 * n, SCRAMBLE, int(group[0]), int(group[-1] - group[0]) + 1)[group - group[0]]
        from_second = (which == 1)[:, None] | (which[:, None] - 2 == np.arange(n))
        return np.asarray(np.clip(np.where(from_second, both[:, n:], both[:, :n]), *TAILS))

    def _cube(self, key: int, n: int, rows: int) -> Array:
        """Return places (rows, n) of a chunk, or of modules whose keys begin at `SCRAMBLE` + 1."""
        if self.kind == "random":
            return _generator(self.seed, key).random((rows, n))
        if self.kind == "latin-hypercube":
            from scipy.stats import qmc

            return np.asarray(qmc.LatinHypercube(n, rng=_generator(self.seed, key)).random(rows))
        return self._sobol(n, max(key, SCRAMBLE), key * rows if key < SCRAMBLE else 0, rows)

    def _sobol(self, n: int, key: int, first: int, rows: int) -> Array:
        """Return points (rows, n) of a scrambled Sobol' sequence."""
        from scipy.stats import qmc

        sequence = qmc.Sobol(n, scramble=True, rng=_generator(self.seed, key))
        if first:
            sequence.fast_forward(first)
        return np.asarray(sequence.random(1 << (rows - 1).bit_length())[:rows])


def _generator(seed: int, chunk: int) -> np.random.Generator:
    return np.random.Generator(np.random.Philox(np.random.SeedSequence([seed, chunk])))


# --- the designs of SALib ---


def salib_problem(n: int) -> dict[str, Any]:
    """Return n parameters from 0 to 1 as SALib takes them."""
    return {"num_vars": n, "names": [f"p{j}" for j in range(n)], "bounds": [[0.0, 1.0]] * n}


def saltelli_points(n: int, base: int, second: bool = False, seed: int = 0) -> Array:
    """Return the points of Saltelli's sampling in the unit cube: base (n + 2) points, or base (2 n + 2) for second order.

    Parameters
    ----------
    n : int, >= 2
        Number of parameters.
    base : int
        A power of two, which balances a Sobol sequence. The points of a smaller base are the first points of a larger one.
    second : bool
        Whether to sample for second-order indices.
    seed : int

    References
    ----------
    A. Saltelli et al., "Variance based sensitivity analysis of model output", Computer Physics Communications 181 (2010), 259-270.
    """
    from SALib.sample import sobol

    return np.asarray(sobol.sample(salib_problem(n), base, calc_second_order=second, seed=seed), dtype=float)


def morris_points(n: int, trajectories: int, seed: int = 0) -> Array:
    """Return the points of Morris' design in the unit cube: trajectories (n + 1) points, on four levels.

    References
    ----------
    M. D. Morris, "Factorial sampling plans for preliminary computational experiments", Technometrics 33 (1991), 161-174.
    """
    from SALib.sample import morris

    return np.asarray(morris.sample(salib_problem(n), trajectories, num_levels=LEVELS, seed=seed), dtype=float)
