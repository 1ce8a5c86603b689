"""What ``contourlab interpolate`` says and writes, out of its figures."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray


def summary_json(summary: dict[str, Any]) -> bytes:
    """Return the figures as a JSON document."""
    return (json.dumps(summary, indent=2, allow_nan=False) + "\n").encode()


def summary_text(summary: dict[str, Any]) -> str:
    """Return the figures in words."""
    return "\n".join(_lines(summary))


def _lines(summary: dict[str, Any]) -> Iterator[str]:
    pitch, travel = summary["pitch"], summary["travel"]
    yield f"{summary['file']}: {summary['n_sample']} samples of {' and '.join(summary['columns'])}"
    yield _row("pitch", f"{1e6 * pitch:.6g} um, travelled {travel / pitch:.5g} of them ({1e3 * travel:.6g} mm)")
    yield _row("resolution", f"{1e9 * summary['resolution']:.6g} nm, by sinusoids of order {summary['order']} counted fourfold")
    if summary["method"] == "recursive":
        yield _row("fit", f"recursive, forgetting {summary['forgetting']:g}, {summary['updates']} updates; constants at the end:")
    else:
        yield _row("fit", "one ellipse through all samples:")
    yield from _constants(summary)
    yield from _errors(summary["subdivisional_error"], summary["settled_from_sample"])
    counts = summary["counts"]
    yield _row("counts", f"from {counts['first']} to {counts['last']}, least {counts['least']}, greatest {counts['greatest']}")
    yield _row("fastest", f"{summary['fastest']:.3g} pitches from one sample to the next; up to 0.5 can be counted")
    missed = summary["missed"]
    if missed["n_sample"]:
        yield _row(
            "missed periods",
            f"YES: at {missed['n_sample']} samples, the first in line {missed['first_line']}; positions from there are wrong",
        )
    else:
        yield _row("missed periods", "none seen")
    if summary["weak_samples"]:
        yield _row("weak signals", f"{summary['weak_samples']} samples below half the amplitude")
    yield from (_row("written" if i == 0 else "", file) for i, file in enumerate(summary.get("files", {}).values()))


def _row(name: str, text: str) -> str:
    return f"  {name:<22}{text}"


def _constants(summary: dict[str, Any]) -> Iterator[str]:
    constants = summary["constants"]
    unit = f" {constants['unit']}".rstrip()
    yield _row("  offsets", f"{constants['offset_1']:.5g} and {constants['offset_2']:.5g}{unit}")
    yield _row("  amplitude", f"{constants['amplitude']:.5g}{unit}, {constants['ratio']:.6g} times the second")
    yield _row("  phase error", f"{math.degrees(constants['phase_error']):.4g} deg")
    yield _row("  scatter", f"{100.0 * summary['scatter']:.3g} % of the radius, rms round the ellipse through all samples")


def _errors(errors: dict[str, Any], settled: int) -> Iterator[str]:
    against = errors["against"] == "reference"
    for name in ("before", "after"):
        found = errors[name]
        if found is None:
            yield _row(f"error {name}", "cannot be told: the record is shorter than two pitches or 72 samples")
            continue
        orders = ", ".join(f"{1e9 * value:.3g}" for value in found["orders"][:4])
        yield _row(f"error {name}", f"{1e9 * found['peak']:.4g} nm peak within a pitch; once, twice, 3 and 4 times a pitch: {orders} nm")
    if against:
        yield _row("", "against the reference, a constant and a straight line taken out")
    else:
        yield _row("", "without a reference: before, what the fitted constants make; after, how far the corrected")
        yield _row("", "signals stray from their circle. Errors that keep the circle round cannot be seen.")
    if settled:
        yield _row("", f"after: from sample {settled} on, when the recursive fit has settled")


def counts_csv(
    summary: dict[str, Any], time: NDArray[np.float64] | None, counts: NDArray[np.int64], position: NDArray[np.float64]
) -> bytes:
    """Return the table of counts and positions, with pitch and constants above it."""
    constants = summary["constants"]
    head = [
        f"# pitch {summary['pitch']:.12g} m, resolution {summary['resolution']:.12g} m, fit: {summary['method']}",
        "# "
        + ", ".join(f"{name} {value!r}" for name, value in constants.items() if name != "unit")
        + (f" ({constants['unit']})" * bool(constants["unit"])),
    ]
    if time is None:
        rows = [f"{n},{x:.12g}" for n, x in zip(counts.tolist(), position.tolist(), strict=True)]
        head.append("count,position [m]")
    else:
        rows = [f"{t:.12g},{n},{x:.12g}" for t, n, x in zip(time.tolist(), counts.tolist(), position.tolist(), strict=True)]
        head.append("t [s],count,position [m]")
    return ("\n".join([*head, *rows]) + "\n").encode()
