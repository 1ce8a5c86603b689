"""Reports that several tests read; made once, since nothing changes them."""

from __future__ import annotations

import pytest
import synthetic

from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.report.data import ReportData


@pytest.fixture(scope="session")
def circle() -> ReportData:
    """Two runs round a circle."""
    return synthetic.report()


@pytest.fixture(scope="session")
def single() -> ReportData:
    """One run, without a verdict."""
    return synthetic.report((8e-6,))


@pytest.fixture(scope="session")
def square() -> ReportData:
    """One run round a square on its corner, which has corners and no circle."""
    path = contour("diamond", side=0.02)
    reference = uniform(path, 0.5, 2, 1e-3)
    data = synthetic.report((8e-6,))
    return synthetic.around(data, path, reference)
