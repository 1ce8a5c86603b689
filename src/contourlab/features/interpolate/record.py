"""What is found in a record of quadrature signals: counts, and the errors within a pitch before and after the correction."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.encoder.interpolation import SinusoidTable, period_count
from contourlab.analysis.encoder.quadrature import EllipseFit, QuadratureConstants, Subdivisional, Tracked, subdivisional_error
from contourlab.errors import ParameterError, ResultError
from contourlab.features.interpolate.signals import QuadratureRecord

Array = NDArray[np.float64]
WEAK = 0.5
"""Part of the amplitude below which a signal is called weak."""
SCALE = 0.01
"""By how much the travels of signals and reference may differ before the pitch must be wrong."""
SETTLING = 2.0
"""Memories of the recursive fit, 1/(1 - lambda) updates each, after which it is held to account."""
BINS = 180


class InterpolatedRecord:
    """Everything that is worked out from a record and its constants."""

    def __init__(
        self,
        record: QuadratureRecord,
        pitch: float,
        order: int,
        fit: EllipseFit,
        tracked: Tracked | None,
        forgetting: float | None,
        constants: QuadratureConstants,
    ) -> None:
        self.record, self.pitch, self.order, self.fit = record, pitch, order, fit
        self.tracked, self.forgetting, self.constants = tracked, forgetting, constants
        self.resolution = pitch / (4 * order)
        size = fit.constants.amplitude
        if tracked is None:
            u1, u2 = constants.corrected(record.u1, record.u2)
            self.after = np.stack([u1, u2]) / size
        else:
            self.after = np.stack([tracked.u1, tracked.u2])
        self.before = np.stack([record.u1, record.u2]) / size
        table = SinusoidTable(order)
        self.counted = table.count(*self.after)
        self.uncorrected = table.count(*self.before)
        # What the recursive fit does while it settles is not held against it.
        updates = 0 if forgetting is None else int(min(SETTLING / max(1.0 - forgetting, 1e-4), 1e9))
        reached = np.zeros(1, dtype=np.int64) if tracked is None else np.flatnonzero(np.cumsum(tracked.updated) >= updates)
        self.settled = int(reached[0]) if reached.size and record.u1.size - int(reached[0]) >= record.u1.size // 4 else 0
        self.missed = self.counted.missed.copy()
        self.errors = None if record.reference is None else self._against_reference(record.reference)

    def _against_reference(self, true: Array) -> tuple[Array, Array]:
        """Return the errors of position before and after, whole pitches taken out; note where such were missed."""
        moved = np.abs(np.diff(true, prepend=true[:1]))
        travel = float(np.ptp(true))
        if 2.0 * float(moved.max()) < self.pitch and travel > 2.0 * self.pitch:
            slope = float(np.polyfit(true - true.mean(), self.resolution * self.counted.counts, 1)[0])
            place = f"{self.record.source.file}: the signals go {slope:.4g} of the way of {self.record.reference_name}"
            if slope < 0.0:
                raise ResultError(f"{place}: they are in the wrong order: say --columns {self.record.names[1]},{self.record.names[0]}")
            if abs(slope - 1.0) > SCALE:
                raise ResultError(f"{place}: a pitch of {self.pitch / slope * 1e6:.4g} um would fit, not {self.pitch * 1e6:.4g} um")
        found = []
        for counted in (self.uncorrected, self.counted):
            off = self.resolution * counted.counts - true
            whole = np.rint(np.diff(off, prepend=off[:1]) / self.pitch)
            if counted is self.counted:
                self.missed = whole != 0.0  # the reference knows better than the speed of the signals
            found.append(off - self.pitch * np.cumsum(whole))
        return found[0], found[1]

    def subdivisional(self) -> tuple[Subdivisional | None, Subdivisional | None]:
        """Return what repeats with the pitch, before and after; None where the record is too short to tell."""
        part = slice(self.settled, None)
        try:
            if self.record.reference is not None and self.errors is not None:
                phase = 2.0 * np.pi / self.pitch * self.record.reference
                return subdivisional_error(self.errors[0], phase), subdivisional_error(self.errors[1][part], phase[part])
            turns = np.arctan2(self.after[1], self.after[0]) / (2.0 * np.pi)
            phase = 2.0 * np.pi * (turns + period_count(turns)[0])
            return self._implied(), subdivisional_error(self._radius()[part] * self.pitch / (2.0 * np.pi), phase[part])
        except ParameterError:
            return (None if self.record.reference is not None else self._implied()), None

    def _radius(self) -> Array:
        """Return by how much the corrected signals are off their circle, over its radius."""
        radius = np.hypot(*self.after)
        return np.asarray(radius / np.median(radius) - 1.0, dtype=np.float64)

    def _implied(self) -> Subdivisional:
        """Return the error that the constants make, by their own model."""
        phase = np.linspace(0.0, 12.0 * np.pi, 4320, endpoint=False)
        return subdivisional_error(self.fit.constants.error_without(phase) * self.pitch / (2.0 * np.pi), phase)

    def over_phase(self) -> tuple[Array, Array, Array]:
        """Return phases [deg], and the mean errors there before and after [nm]."""
        centre = (np.arange(BINS) + 0.5) * 360.0 / BINS
        part = slice(self.settled, None)
        if self.record.reference is not None and self.errors is not None:
            turns = self.record.reference / self.pitch
            return centre, _binned(turns, self.errors[0]), _binned(turns[part], self.errors[1][part])
        length = self.pitch / (2.0 * np.pi)
        turns = np.arctan2(self.after[1], self.after[0]) / (2.0 * np.pi)
        implied = _binned(centre / 360.0, self.fit.constants.error_without(np.radians(centre)) * length)
        return centre, implied, _binned(turns[part], self._radius()[part] * length)

    def summary(self) -> dict[str, Any]:
        """Return the figures, in SI."""
        record, counts = self.record, self.counted.counts
        before, after = self.subdivisional()
        marked = np.flatnonzero(self.missed)
        weak = int(np.count_nonzero(np.hypot(*self.after)[self.settled :] < WEAK))
        return {
            "file": str(record.source.file),
            "n_sample": int(counts.size),
            "columns": list(record.names),
            "pitch": self.pitch,
            "resolution": self.resolution,
            "order": self.order,
            "method": "all samples" if self.tracked is None else "recursive",
            "forgetting": self.forgetting,
            "updates": None if self.tracked is None else int(self.tracked.updated.sum()),
            "settled_from_sample": self.settled,
            "constants": {
                "offset_1": self.constants.offset_1,
                "offset_2": self.constants.offset_2,
                "amplitude": self.constants.amplitude,
                "ratio": self.constants.ratio,
                "phase_error": self.constants.phase_error,
                "unit": record.unit,
            },
            "scatter": self.fit.scatter,
            "subdivisional_error": {
                "against": "shape" if record.reference is None else "reference",
                "before": _figures(before),
                "after": _figures(after),
            },
            "counts": {"first": int(counts[0]), "last": int(counts[-1]), "least": int(counts.min()), "greatest": int(counts.max())},
            "travel": float(np.ptp(counts)) * self.resolution,
            "fastest": float(np.abs(np.diff(counts, prepend=counts[:1])).max()) / (4 * self.order),
            "missed": {"n_sample": int(marked.size), "first_line": record.source.line_of(int(marked[0])) if marked.size else None},
            "weak_samples": weak,
        }

    def position(self) -> Array:
        """Return the position [m]."""
        return np.asarray(self.resolution * self.counted.counts, dtype=np.float64)


def _figures(found: Subdivisional | None) -> dict[str, Any] | None:
    return None if found is None else {"peak": found.peak, "orders": list(found.orders), "rest_rms": found.rest}


def _binned(turns: Array, error: Array) -> Array:
    """Return the mean of an error [m] in each part of a turn, less the mean of them all [nm]; nan where there is nothing."""
    place = np.clip(((turns - np.floor(turns)) * BINS).astype(np.int64), 0, BINS - 1)
    number = np.bincount(place, minlength=BINS)
    total = np.bincount(place, weights=error, minlength=BINS)
    mean = np.where(number > 0, total / np.maximum(number, 1), np.nan)
    return np.asarray(1e9 * (mean - np.nanmean(mean)), dtype=np.float64)
