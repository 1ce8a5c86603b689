"""Helpers for the contour tests: drawings on disk, and distances measured without the readers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path as File
from typing import Any

import ezdxf
import numpy as np
from numpy.typing import NDArray

from contourlab.geometry import Path

Array = NDArray[np.float64]
MM = 1e-3


def dxf(folder: File, draw: Callable[[Any], object], units: int = 4, name: str = "part.dxf") -> File:
    """Save a drawing whose model space `draw` fills; 4 is mm."""
    document = ezdxf.new("R2010")  # type: ignore[attr-defined]
    document.header["$INSUNITS"] = units
    draw(document.modelspace())
    file = folder / name
    document.saveas(file)
    return file


def svg(folder: File, body: str, head: str = 'width="100mm" height="80mm" viewBox="0 0 100 80"') -> File:
    """Save an SVG drawing; its user unit is 1 mm unless `head` says otherwise."""
    file = folder / "part.svg"
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{body}</svg>', encoding="utf-8")
    return file


def away(path: Path, points: Array) -> float:
    """Return the largest distance of points from a path, by a nested search that uses positions only."""
    s = np.linspace(0.0, path.length, 4001)
    sampled = path.position(s)
    found = []
    for point in points:
        at, half = s[int(np.argmin(np.linalg.norm(sampled - point, axis=1)))], s[1]
        for _ in range(12):
            near = np.clip(np.linspace(at - half, at + half, 21), 0.0, path.length)
            gaps = np.linalg.norm(path.position(near) - point, axis=1)
            at, half = near[int(np.argmin(gaps))], half / 8.0
        found.append(float(gaps.min()))
    return max(found)


def area(path: Path) -> float:
    """Return the area on the left of a closed path in the plane, by Green's theorem, curve by curve."""
    nodes, weights = np.polynomial.legendre.leggauss(20)
    total = 0.0
    for curve in path.curves:
        for k in range(8):
            s = curve.length * (k + 0.5 + 0.5 * nodes) / 8.0
            r, t = curve.derivatives(s, 1)
            total += curve.length / 16.0 * float(weights @ (r[:, 0] * t[:, 1] - r[:, 1] * t[:, 0])) / 2.0
    return total
