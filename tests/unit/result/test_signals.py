"""Labelled signals in memory."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.errors import ResultError
from contourlab.result import Result, Signal, Status


def a_result(n: int = 6, start: int = 0) -> Result:
    both = np.arange(2.0 * n).reshape(n, 2)
    signals = {"position": Signal(both, ("sample", "axis"), "m"), "feedrate": Signal(both[:, 0], ("sample",), "m/s")}
    status = Status(False, 5, "y", "following error 60 mm passes the limit of 50 mm")
    return Result("cascade", ("x", "y"), 1e-3, signals, status, {"machine": "gantry", "seed": 7}, start)


def test_signals_by_name() -> None:
    result = a_result()
    assert result["position"].shape == (6, 2)
    assert "feedrate" in result
    assert "jerk" not in result
    assert result.n_sample == 6
    with pytest.raises(ResultError, match=r"'jerk'.*cascade.*position, feedrate"):
        result["jerk"]


def test_returned_arrays_are_read_only() -> None:
    data = np.zeros((4, 1))
    result = Result("made", ("x",), 1e-3, {"position": Signal(data, ("sample", "axis"), "m")})
    with pytest.raises(ValueError, match="read-only"):
        result["position"][0, 0] = 1.0
    # The creator may still write to its own array.
    data[0, 0] = 1.0


def test_integers_become_floats() -> None:
    assert Signal(np.arange(3), ("sample",), "m").data.dtype == np.float64  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("shape", "dims"),
    [((3,), ("sample", "axis")), ((3, 2), ("sample",)), ((3, 2), ("axis", "sample")), ((), ()), ((3, 2, 1), ("sample", "axis", "lane"))],
)
def test_shapes_that_do_not_fit_their_dimensions(shape: tuple[int, ...], dims: tuple[str, ...]) -> None:
    with pytest.raises(ResultError, match="dimensions"):
        Signal(np.zeros(shape), dims, "m")


def test_signals_of_different_lengths() -> None:
    signals = {"a": Signal(np.zeros(3), ("sample",), "m"), "b": Signal(np.zeros(4), ("sample",), "m")}
    with pytest.raises(ResultError, match=r"different lengths: \[3, 4\]"):
        Result("made", ("x",), 1e-3, signals)


def test_columns_that_are_not_the_axes() -> None:
    with pytest.raises(ResultError, match=r"position.*\b3\b.*\b2\b"):
        Result("made", ("x", "y"), 1e-3, {"position": Signal(np.zeros((4, 3)), ("sample", "axis"), "m")})


def test_time_is_a_product_not_a_sum() -> None:
    """Ten million steps of 0.1 ms: a running sum would be off by some 1e-7 s."""
    n, period = 10_000_000, 1e-4
    result = Result("long", ("x",), period, {"e": Signal(np.broadcast_to(0.0, n), ("sample",), "m")})
    assert result.time[-1] == (n - 1) * period
    assert a_result(start=10_000_000).time[0] == 10_000.0


def test_window_keeps_time() -> None:
    result = a_result(start=3)
    part = result.window(2, 5)
    assert np.array_equal(part.time, result.time[2:5])
    assert np.array_equal(part["position"], result["position"][2:5])
    assert np.array_equal(part.window(1, 2).time, result.time[3:4])
    assert (part.axes, part.status, part.attributes) == (result.axes, result.status, result.attributes)


def test_added_signals_leave_the_old_result_unchanged() -> None:
    result = a_result()
    more = result.with_signals(contour_error=Signal(np.zeros(6), ("sample",), "m"))
    assert "contour_error" in more
    assert "contour_error" not in result
    with pytest.raises(ResultError, match="different lengths"):
        result.with_signals(short=Signal(np.zeros(5), ("sample",), "m"))


def test_as_xarray() -> None:
    result = a_result(start=4)
    data = result.to_xarray()
    assert data["position"].dims == ("sample", "axis")
    assert data["position"].attrs["units"] == "m"
    assert data["feedrate"].attrs["units"] == "m/s"
    assert np.array_equal(data["time"], result.time)
    assert data["time"].attrs["units"] == "s"
    assert data["position"].sel(axis="y").values.tolist() == result["position"][:, 1].tolist()
    assert data.attrs["scheme"] == "cascade"
    assert data.attrs["attribute_seed"] == 7
    # The data set belongs to the user: writing to it leaves the result unchanged.
    data["position"][0, 0] = 99.0
    assert result["position"][0, 0] == 0.0


def test_no_signals() -> None:
    empty = Result("none", ("x",), 1e-3, {})
    assert empty.n_sample == 0
    assert empty.time.size == 0
