"""The runner of candidates: what is stored, what is run again, and where it runs change no figure."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.study import Runner, Setting
from contourlab.study.checkpoint import Checkpoint

GAIN = "axes.1.plant.gain"


@pytest.fixture(scope="module")
def setting() -> Setting:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    return Setting(case.machine, case.controller, circle)


class Elsewhere:
    """Workers that get copies, as those of another process do."""

    count = 3

    def __init__(self) -> None:
        self.values: dict[str, bytes] = {}
        self.sizes: list[int] = []

    def shared(self, value: object) -> str:
        self.values["key"] = pickle.dumps(value)
        return "key"

    def map(self, work: Callable[[Any, Any], Any], key: str, items: Iterable[Any]) -> list[Any]:
        chosen = list(items)
        self.sizes += [len(item[0][GAIN]) for item in chosen]
        return [work(pickle.loads(self.values[key]), item) for item in chosen]


def test_workers_elsewhere_give_the_same_figures(setting: Setting) -> None:
    columns = {GAIN: np.linspace(0.9, 1.1, 70)}
    here, elsewhere = Runner(setting, ("limited_share",)), Runner(setting, ("limited_share",), pool=cast(Any, Elsewhere()))
    expected, figures = here(columns), elsewhere(columns)
    assert expected.keys() == figures.keys() and "limited_share" in figures and "part_error_max" not in figures
    for name, values in figures.items():
        np.testing.assert_array_equal(values, expected[name])
    assert cast(Elsewhere, elsewhere.pool).sizes == [32, 32, 6] and here.runs == elsewhere.runs == 70
    with pytest.raises(ParameterError):
        elsewhere({"axes.1.plant.colour": columns[GAIN]})


def test_a_stored_chunk_without_a_figure_is_run_again(setting: Setting, tmp_path: Path) -> None:
    columns = {GAIN: np.linspace(0.9, 1.1, 5)}

    def run(*figures: str) -> tuple[Runner, dict[str, np.ndarray]]:
        runner = Runner(setting, figures, store=Checkpoint(tmp_path, "study"))
        return runner, runner(columns)

    assert run()[0].runs == 5 and run()[0].reused == 5
    first, figures = run("part_error_max")
    again, stored = run("part_error_max")
    assert (first.runs, first.reused, again.runs, again.reused) == (5, 0, 0, 5)
    np.testing.assert_array_equal(stored["part_error_max"], figures["part_error_max"])


def test_a_run_that_counts_twice_is_reused_once(setting: Setting, tmp_path: Path) -> None:
    columns = {GAIN: np.array([1.0])}
    for expected in ((1, 0), (0, 1)):
        runner = Runner(setting, store=Checkpoint(tmp_path, "study"))
        assert all(np.array_equal(one, other) for one, other in zip(runner(columns).values(), runner(columns).values(), strict=True))
        assert (runner.runs, runner.reused) == expected
