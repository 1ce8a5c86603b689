"""Ghaffari & Ulsoy: our components against the equations, and rows that notice a component that is off."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
import pytest

from contourlab.components.contract import Component, LinearModel
from contourlab.components.controller.position import PositionController
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.papers.ghaffari.bench import PERIOD, drive_open_loop, rise_time
from contourlab.papers.ghaffari.linear import closed_loop, crossing, equation_16, linear_rows
from contourlab.papers.ghaffari.observer import compensated_axis, exact_compensated, observer_rows
from contourlab.papers.ghaffari.setup import AXES, TABLE_2, TABLE_3, Gains, Reading
from contourlab.papers.rows import Row, banded, read_bands


@pytest.mark.parametrize("table", [TABLE_2, TABLE_3], ids=["II", "III"])
@pytest.mark.parametrize("number", [1, 2, 3])
def test_the_responses_of_the_observer_solve_its_two_equations(number: int, table: dict[int, Gains]) -> None:
    """s v = -b v + a (u_c - e + d) and e = w_d/(s + w_d) ((w_z s/(s + w_z) + b_hat) v/a_hat - (u_c - e)), for (v, e) at each s."""
    w = np.geomspace(0.01, 5000.0, 25)
    gains, plant, reading = table[number], AXES[number], Reading()
    response = compensated_axis(number, gains, w)
    exact = exact_compensated(number, gains, reading, 1j * w)
    for i, s in enumerate(1j * w):
        low = reading.bandwidth / (s + reading.bandwidth)
        inverse = (reading.filter_bandwidth * s / (s + reading.filter_bandwidth) + gains.observer_damping) / gains.observer_gain
        matrix = np.array([[s + plant.damping, plant.gain], [-low * inverse, 1.0 - low]])
        driven, loaded = (np.linalg.solve(matrix, right)[0] for right in ([plant.gain, -low], [plant.gain, 0.0]))
        assert response.compensated[i] * 1e3 == pytest.approx(driven, rel=1e-8)
        assert s * response.compliance[i] * 1e3 == pytest.approx(loaded, rel=1e-8)
        assert (exact[0][i], exact[1][i]) == (pytest.approx(driven, rel=1e-8), pytest.approx(loaded, rel=1e-8))


def test_the_closed_loop_is_one_at_low_frequency_and_falls_with_the_cube() -> None:
    """P/R' of eq (16): 1 as s -> 0, a' K_P K_I/s^3 as s -> infinity."""
    w = np.array([1e-4, 1e6])
    far = TABLE_3[1].model_gain * TABLE_3[1].position_gain * TABLE_3[1].integral_gain / (1j * w[1]) ** 3
    for closed in (closed_loop, equation_16):
        assert closed(TABLE_3[1], w)[0] == pytest.approx(1.0, abs=1e-4)
        assert closed(TABLE_3[1], w)[1] == pytest.approx(far, rel=1e-3)


def _failed(rows: Callable[[], Iterable[Row]]) -> list[str]:
    """Return the names of the rows that leave their shipped bands."""
    return [row.name for row in banded(rows(), read_bands("ghaffari")) if row.passed is False]


@pytest.mark.parametrize(
    ("part", "name", "rows", "noticed"),
    [
        (PositionController, "position_gain", linear_rows, {"Fig 8 P/R'": 1}),
        (DisturbanceObserver, "model_damping", observer_rows, {"V/U_c": 1, "V/D": 1}),
        (DisturbanceObserver, "filter_bandwidth", observer_rows, {"V/U_c": 1, "V/D": 1}),
    ],
)
@pytest.mark.slow
def test_a_component_that_is_one_percent_off_fails_its_rows(
    part: type[Component], name: str, rows: Callable[[], Iterable[Row]], noticed: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    true = part.linearize

    def wrong(self: Component) -> LinearModel | None:
        return true(self.replace(**{name: 1.01 * getattr(self, name)}))

    assert not _failed(rows)
    monkeypatch.setattr(part, "linearize", wrong)
    failed = _failed(rows)
    assert {head: sum(its.startswith(head) for its in failed) for head in noticed} == noticed


def test_a_simulated_axis_answers_a_step_like_its_model() -> None:
    """v = u a/b (1 - exp(-b t)), and zero below the stiction."""
    command = np.full(500, 0.07)
    _, velocity = drive_open_loop(command)
    time = PERIOD * np.arange(500.0)
    for column, plant in enumerate(AXES.values()):
        wanted = 0.07e-3 * plant.gain / plant.damping * -np.expm1(-plant.damping * time)
        np.testing.assert_allclose(velocity[:, column], wanted, rtol=1e-9, atol=1e-15)
    position, _ = drive_open_loop(command, friction=True)
    assert position[-1, 0] > 0.0  # stiction 0.055
    assert (position[:, 1:] == 0.0).all()  # 0.088 and 0.077


def test_the_rise_time_of_an_exponential_is_its_time_constant() -> None:
    time = PERIOD * np.arange(2000.0)
    assert rise_time(1.0 - np.exp(-time / 0.15)) == pytest.approx(0.15, rel=1e-5)


def test_a_crossing_is_located_to_a_millionth() -> None:
    assert crossing(lambda x: x**3 - 40.0**3, 1.0, 1e4) == pytest.approx(40.0, rel=1.1e-6)
