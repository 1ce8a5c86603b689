"""Reports shared by several tests; built once, because nothing changes them."""

from __future__ import annotations

import pytest
import synthetic

from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.rendering.data import ReportData


@pytest.fixture(scope="session")
def circle() -> ReportData:
    """Return two runs around a circle."""
    return synthetic.report()


@pytest.fixture(scope="session")
def single() -> ReportData:
    """Return one run without a verdict."""
    return synthetic.report((8e-6,))


@pytest.fixture(scope="session")
def square() -> ReportData:
    """Return one run around a square on its corner: it has corners and no circle."""
    path = contour("diamond", side=0.02)
    reference = uniform(path, 0.5, 2, 1e-3)
    data = synthetic.report((8e-6,))
    return synthetic.around(data, path, reference)
