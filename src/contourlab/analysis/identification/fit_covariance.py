"""How well a fit knows its parameters: deviations with the colour of the residual, and which parameters go together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.coloured_residual import bartlett, flat_top, long_run, memory, usual_lags

Array = NDArray[np.float64]

UNTOLD = 1e-10
"""Eigenvalue of the normal matrix, columns of length one, over the largest, from which down a direction counts as without effect."""
FADED = 0.1
"""Autocorrelation that counts as none."""
LONGEST = 4
"""The longest lag is this part of a record."""


@dataclass(frozen=True, eq=False)
class FitCovariance:
    """Covariance of parameters found by least squares.

    Attributes
    ----------
    covariance : ndarray (p, p)
        That allows for a residual correlated over neighbouring rows and across channels; infinite on the diagonal where a parameter is
        not told.
    deviations, white_deviations : ndarray (p,)
        Standard deviations from it; and as they would be were the residual white.
    correlation : ndarray (p, p)
        Of the parameters, by the shape of the problem alone.
    lags : int
        Rows over which the residual counts as correlated.
    untold : ndarray (p,) of bool
        Parameters, or mixtures of them, without effect on the residual.
    """

    covariance: Array
    deviations: Array
    white_deviations: Array
    correlation: Array
    lags: int
    untold: NDArray[np.bool_]


def fit_covariance(jacobians: Sequence[Array], residuals: Sequence[Array], floor: float = 0.0) -> FitCovariance:
    """Return the covariance of the parameters at the least sum of squares.

    Parameters
    ----------
    jacobians : sequence of ndarray (n_k, c_k, p)
        Slopes of the residuals, a record each: rows in time, channels that were recorded together.
    residuals : sequence of ndarray (n_k, c_k)
        Weighted to one size.
    floor : float
        Root mean square of what every residual holds though it may not show: half of an encoder's count either way.

    Notes
    -----
    (J'J)^-1 S (J'J)^-1 with S the sum of the autocovariances of J'r under a window that is flat up to the lag at which the residual has
    forgotten itself, and falls to nothing at twice that lag: what a model lacks lasts longer than the usual rule of thumb for the number of
    lags allows for, and a window that falls from the start (Bartlett's) makes deviations too small by a tenth and more. Such a window may
    give a variance that is far too small, even below zero: no deviation is told that is below that of Bartlett's window, or the white one.
    Where the sum of squares has several minima beside each other, none of this knows of them.

    References
    ----------
    As of `contourlab.analysis.identification.coloured_residual`.
    """
    p = jacobians[0].shape[-1]
    if p == 0:  # all parameters are at the bounds of their ranges
        nothing, none = np.zeros(0), np.zeros((0, 0))
        return FitCovariance(none, nothing, nothing, none, 0, np.zeros(0, dtype=bool))
    flat = np.concatenate([j.reshape(-1, p) for j in jacobians])
    left = np.concatenate([r.ravel() for r in residuals])
    normal = flat.T @ flat
    lengths = np.sqrt(np.diag(normal))
    size = np.where(lengths > 0.0, lengths, 1.0)
    values, vectors = np.linalg.eigh(normal / np.outer(size, size))
    lost = values <= UNTOLD * max(float(values[-1]), 1e-300)
    untold: NDArray[np.bool_] = (lengths == 0.0) | (np.abs(vectors[:, lost]) > 0.2).any(axis=1)
    inverse = (vectors[:, ~lost] / values[~lost]) @ vectors[:, ~lost].T / np.outer(size, size)
    spare = max(left.size - p, 1)
    white = np.sqrt(np.maximum(np.diag(inverse), 0.0) * (float(left @ left) + floor**2 * left.size) / spare)
    lags = max(_remembered(r) for r in residuals)
    pushed = [np.einsum("ncp,nc->np", j, r) for j, r in zip(jacobians, residuals, strict=True)]
    windows = flat_top(lags), bartlett(2 * lags - 1)
    found = [inverse @ sum(long_run(part, window) for part in pushed) @ inverse * (left.size / spare) for window in windows]
    # Never less than under Bartlett's window, which is never negative, nor than were the residual white; correlations stay.
    covariance, own = found[0], np.diag(found[0]).copy()
    least = np.maximum(np.diag(found[1]), white**2)
    raised = np.sqrt(np.where(own > 0.0, np.maximum(own, least) / np.where(own > 0.0, own, 1.0), 0.0))
    covariance = covariance * np.outer(raised, raised)
    np.fill_diagonal(covariance, np.maximum(own, least))
    covariance[untold, untold] = np.inf
    scale = np.sqrt(np.where(np.diag(inverse) > 0.0, np.diag(inverse), 1.0))
    deviations = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return FitCovariance(covariance, deviations, np.where(untold, np.inf, white), inverse / np.outer(scale, scale), lags, untold)


def _remembered(residual: Array) -> int:
    """Return over how many rows a record's residual (n, c) counts as correlated."""
    n = residual.shape[0]
    longest = max(n // LONGEST, 1)
    reached = max(memory(column - column.mean(), FADED, longest) for column in residual.T)
    return int(min(max(usual_lags(n), reached), longest))
