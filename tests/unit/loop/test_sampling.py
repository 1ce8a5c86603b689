"""The compiled samples of a reference against `Reference.block`, which other tests compare with closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import contourlab as cl
from contourlab.feed import Reference
from contourlab.geometry import Line
from contourlab.loop.sampling import sample_compiled
from contourlab.program import parse_program

PERIOD = 1e-3
PART = """
G17 G21 G90 G94 F1800
G0 X5 Y-3 Z2
G1 X12 Y4
G2 X20 Y-4 I8 J0
G3 X20 Y-4 Z-3 I-4 J2
G4 P0.05
G1 X20 Y-4.0004
G18 G2 X30 Z-3 I5 K0
G1 Z1
M2
"""


def program(text: str = PART, period: float = PERIOD) -> Reference:
    limits = cl.AxisLimits([0.2] * 3, [1.5] * 3, [40.0] * 3)
    return cl.plan(cl.route_from_program(parse_program(text)), limits, period)


def compare(reference: Reference, start: int, stop: int) -> None:
    """Check each value to rounding: progress to a few bits of the length, the rest as it follows from progress."""
    plain, compiled = reference.block(start, stop), reference.block(start, stop, sample_compiled)
    length = reference.path.length * max(len(reference.laps), 1)
    speed, bend = float(plain.feedrate.max(initial=0.0)), 1.0 / 0.5e-3
    change = float(np.abs(plain.acceleration).max(initial=0.0))
    # Within rounding of a joint either curve is right.
    along = np.mod(plain.arc_length, reference.path.length) if reference.path.closed else plain.arc_length
    clear = np.abs(along[:, None] - reference.path.breaks).min(axis=1) > 1e-13 * length
    assert clear.mean() > 0.9 or not clear.size
    for name, scale in (
        ("arc_length", length),
        ("feedrate", 0.2),
        ("position", length + 0.05),
        ("velocity", speed * (1.0 + length * bend)),
        ("acceleration", (change + 1.0) * (1.0 + length * bend)),
    ):
        gap = np.abs(getattr(plain, name) - getattr(compiled, name))[clear].max(initial=0.0)
        assert gap <= 64.0 * np.finfo(float).eps * scale, (name, gap)
    assert compiled.table.shape == plain.table.shape


CONTOURS: dict[str, dict[str, Any]] = {"circle": {}, "diamond": {}, "star": {}, "ellipse": {}, "lemniscate": {}, "butterfly": {}}


@pytest.mark.parametrize("name", CONTOURS)
@pytest.mark.parametrize("laps", [1, 3])
def test_contours_at_constant_frequency(name: str, laps: int) -> None:
    reference = cl.uniform(cl.contour(name), 0.5, laps, PERIOD)
    compare(reference, 0, reference.n_sample)
    compare(reference, 1990, reference.n_sample - 5)


@pytest.mark.parametrize("name", CONTOURS)
def test_contours_as_planned(name: str) -> None:
    reference = cl.plan(cl.route_from_path(cl.contour(name), 0.05), cl.AxisLimits([0.2] * 2, [1.5] * 2, [40.0] * 2), PERIOD, laps=2)
    compare(reference, 0, reference.n_sample)


@pytest.mark.parametrize("period", [1e-3, 1.25e-4, 7.3e-3])
def test_a_program_with_lines_arcs_helix_dwell_and_a_piece_shorter_than_a_sample(period: float) -> None:
    reference = program(period=period)
    compare(reference, 0, reference.n_sample)


@settings(max_examples=60, deadline=None)
@given(data=st.data())
@pytest.mark.slow
def test_any_block_is_a_part_of_the_whole(data: st.DataObject) -> None:
    reference = program()
    start = data.draw(st.integers(0, reference.n_sample))
    stop = data.draw(st.integers(start, reference.n_sample))
    whole = reference.block(0, reference.n_sample, sample_compiled).table
    assert np.array_equal(whole[start:stop], reference.block(start, stop, sample_compiled).table)


def test_joints_belong_to_the_curve_that_begins_there() -> None:
    """One sample exactly at each corner of a square has the direction of the next side."""
    square = cl.Path([Line(a, b) for a, b in zip(CORNERS, CORNERS[1:] + CORNERS[:1], strict=True)], closed=True)
    reference = cl.uniform(square, 2.0**-4, 2, 2.0**-5)
    velocity = reference.block(0, reference.n_sample, sample_compiled).velocity
    at = reference.n_sample // 8
    for corner in range(8):
        side = np.subtract(CORNERS[(corner + 1) % 4], CORNERS[corner % 4])
        np.testing.assert_array_equal(np.sign(velocity[corner * at]), np.sign(side))
        np.testing.assert_array_equal(
            np.sign(velocity[corner * at - 1]), np.sign(np.subtract(CORNERS[corner % 4], CORNERS[(corner - 1) % 4]))
        )


CORNERS = [(0.0, 0.0), (0.25, 0.0), (0.25, 0.25), (0.0, 0.25)]


def test_recorded_positions_are_not_sampled() -> None:
    path = cl.Path([Line((0.0, 0.0), (0.1, 0.0))])
    reference = Reference.from_samples(path.position(np.linspace(0.0, 0.1, 50)), PERIOD, path)
    assert np.array_equal(reference.block(3, 40, sample_compiled).table, reference.block(3, 40).table)
