"""Records as identification takes them: signals of one length, finite, evenly sampled."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError

Array = NDArray[np.float64]
JITTER = 1e-3
"""Share of the period by which times may be uneven: a clock that is read rather than counted jitters by parts in a hundred thousand."""


def even_record(time: ArrayLike, signals: Mapping[str, ArrayLike], shortest: int = 50, jitter: float = JITTER) -> tuple[float, list[Array]]:
    """Return the period [s] of a record, and its times and signals as arrays (n,), checked.

    Parameters
    ----------
    time : array_like (n,) [s]
    signals : mapping of str to array_like (n,)
        By the names that messages have.
    shortest : int
        Fewest samples.
    jitter : float
        Share of the period by which times may be uneven.

    Raises
    ------
    ParameterError
        If there are too few samples, a signal is of another length or not finite, or time does not rise evenly.
    """
    t = np.asarray(time, dtype=float)
    if t.ndim != 1:
        raise ParameterError("time", f"shape {t.shape}", "one record, (n,)")
    if t.size < shortest:
        raise ParameterError("time", f"{t.size} samples", f"a record of at least {shortest}")
    found = []
    for name, values in (("time", t), *signals.items()):
        array = np.asarray(values, dtype=float)
        if array.shape != t.shape:
            raise ParameterError(name, f"shape {array.shape}", f"as long as time, {t.shape}")
        bad = np.flatnonzero(~np.isfinite(array))
        if bad.size:
            raise ParameterError(name, f"{array[bad[0]]} at sample {bad[0]}", "finite")
        found.append(array)
    period = float(t[-1] - t[0]) / (t.size - 1)
    if not (period > 0.0 and np.all(np.abs(np.diff(t) - period) <= jitter * period)):
        raise ParameterError("time", "a record", "rising and evenly spaced: resample it first")
    return period, found
