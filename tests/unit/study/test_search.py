"""The global search, on functions with a known minimum."""

from __future__ import annotations

import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from contourlab.errors import ParameterError
from contourlab.study import search
from contourlab.study.search import SPREAD, _Spared

STARTS = np.array([[0.9, 0.1, 0.9], [0.1, 0.9, 0.5]])


def bowl(points: np.ndarray) -> np.ndarray:
    return 1.0 + ((points - np.array([0.3, 0.6, 0.45])) ** 2 * np.array([1.0, 30.0, 4.0])).sum(axis=1)


def valley(points: np.ndarray) -> np.ndarray:
    x, y, z = (4.0 * points - 2.0).T
    return 100.0 * (y - x * x) ** 2 + (1.0 - x) ** 2 + 100.0 * (z - y * y) ** 2 + (1.0 - y) ** 2


def test_what_the_search_spares_itself_no_other_thread_misses() -> None:
    finder = _Spared(threading.get_ident())
    with pytest.raises(ModuleNotFoundError):
        finder.find_spec("scipy.stats")
    finder.find_spec("scipy.linalg")
    with ThreadPoolExecutor(1) as other:
        other.submit(finder.find_spec, "scipy.stats").result()


def test_a_search_leaves_the_list_of_finders_as_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another thread may be walking through it, and would skip one."""

    class Walked(list[object]):
        def insert(self, *_: object) -> None:
            raise AssertionError

        remove = insert

    finders = list(sys.meta_path)
    monkeypatch.setattr(sys, "meta_path", Walked(finders))
    monkeypatch.delitem(sys.modules, "cma", raising=False)  # so that it is loaded again
    search(bowl, STARTS, budget=100, tolerance=0.0)
    assert "cma" in sys.modules and sys.meta_path == finders


def test_points_are_those_of_the_package_within_bounds() -> None:
    """Bit by bit: here the box is entered for all starts at once; the minimum lies outside."""
    tried = list[np.ndarray]()

    def corner(points: np.ndarray) -> np.ndarray:
        tried.append(points.copy())
        return ((points - np.array([-0.3, 1.2, 0.5])) ** 2).sum(axis=1)

    search(corner, np.array([[0.9, 0.0, 0.3], [0.5, 0.5, 0.5]]), budget=1000, seed=3, population=16, tolerance=0.0)
    generator = np.random.default_rng(3)
    options = {"bounds": [0.0, 1.0], "popsize": 16, "verbose": -9, "tolfun": 0.0, "tolfunhist": 0.0, "seed": np.nan}
    options |= {"randn": lambda *shape: generator.standard_normal(shape)}
    package = sys.modules["cma"].CMAEvolutionStrategy([0.9, 1e-3, 0.3], SPREAD, options)
    generations = [points[:16] for points in tried[1:]]
    for points in generations:
        asked = package.ask()
        np.testing.assert_array_equal(asked, points)
        package.tell(asked, corner(points).tolist())
    assert len(generations) > 20 and (generations[-1][:, 0] < 0.1).any()


def test_finds_the_minimum_of_a_bowl() -> None:
    found = search(bowl, STARTS, budget=6000, tolerance=0.0)
    np.testing.assert_allclose(found.point, [0.3, 0.6, 0.45], atol=1e-4)
    assert found.value == pytest.approx(1.0, abs=1e-7)
    assert found.runs <= 6000
    assert np.ptp(found.per_start) < 1e-6
    assert (np.diff(found.course[:, 1]) <= 0.0).all()


def test_follows_a_curved_valley() -> None:
    found = search(valley, STARTS, budget=20000, tolerance=0.0)
    np.testing.assert_allclose(found.point, [0.75, 0.75, 0.75], atol=1e-3)


def test_minimum_on_the_border() -> None:
    found = search(lambda p: p.sum(axis=1), STARTS, budget=6000, tolerance=0.0)
    assert found.value == pytest.approx(0.0, abs=1e-3)


def test_same_seed_same_search_and_no_global_state() -> None:
    state = np.random.get_state()[1].copy()  # noqa: NPY002
    first, second = (search(bowl, STARTS, budget=2000, seed=3) for _ in range(2))
    np.testing.assert_array_equal(first.course, second.course)
    np.testing.assert_array_equal(np.random.get_state()[1], state)  # noqa: NPY002
    assert not np.array_equal(first.course, search(bowl, STARTS, budget=2000, seed=4).course)


def test_never_worse_than_a_start() -> None:
    found = search(bowl, np.array([[0.3, 0.6, 0.45]]), budget=1)
    assert (found.value, found.runs) == (1.0, 1)


def test_failed_runs_are_skipped() -> None:
    found = search(lambda p: np.where(p[:, 0] > 0.5, np.nan, bowl(p)), STARTS, budget=4000, tolerance=0.0)
    assert found.value == pytest.approx(1.0, abs=1e-6)


def test_a_search_without_a_feasible_value_is_refused() -> None:
    with pytest.raises(ParameterError, match="holds"):
        search(lambda p: np.full(len(p), np.nan), STARTS, budget=200)


def test_one_parameter_is_searched_too() -> None:
    found = search(lambda p: (p[:, 0] - 0.3) ** 2, np.array([[0.9], [0.1]]), budget=2000, tolerance=0.0)
    assert found.point.shape == (1,) and found.point[0] == pytest.approx(0.3, abs=1e-4)


def test_ctrl_c_ends_a_stoppable_search_with_the_best_so_far() -> None:
    values: list[float] = []

    def stopped(points: np.ndarray) -> np.ndarray:
        if len(values) > 200:
            raise KeyboardInterrupt
        values.extend(bowl(points).tolist())
        return bowl(points)

    found = search(stopped, STARTS, budget=6000, stoppable=True)
    assert found.interrupted and found.value == min(values) and found.runs == len(values)
    with pytest.raises(KeyboardInterrupt):
        search(stopped, STARTS, budget=6000)
