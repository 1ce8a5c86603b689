"""What a notebook shows: tables for pandas, pictures with the values in them."""

from __future__ import annotations

import numpy as np
import pytest

import contourlab as cl
from contourlab.errors import ParameterError, ResultError


@pytest.fixture(scope="module")
def run():
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    reference = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    return case, reference, cl.judge(cl.simulate(case.machine, case.controller, reference), reference)


def test_a_table_has_a_column_for_each_axis(run):
    result = run[2]
    frame = result.to_pandas()
    assert np.array_equal(frame["reference 3"], result["reference"][:, 1])
    assert np.array_equal(frame["contour_error"], result["contour_error"]) and np.array_equal(frame.index, result.time)


def test_a_picture_shows_path_and_error(run):
    path, error = run[2].plot().axes
    assert [line.get_label() for line in path.lines] == ["reference", "axes"]
    assert np.array_equal(error.lines[0].get_ydata(), 1e6 * run[2]["contour_error"])
    assert "<svg" in run[2]._repr_html_() and len(repr(run[2])) < 200


def test_a_result_without_positions_has_a_table_only(run):
    from dataclasses import replace

    bare = replace(run[2], signals={"contour_error": run[2].signals["contour_error"]})
    assert "<svg" not in bare._repr_html_()
    with pytest.raises(ResultError):
        bare.plot()


def test_a_batch_becomes_a_table_and_a_curve(run):
    case, reference, _ = run
    gains = np.array([1.1, 0.9, 1.0])
    batch = cl.simulate_batch(case.machine, case.controller, reference, {"axes.*.plant.gain": gains})
    frame = batch.to_pandas()
    assert np.array_equal(frame["axes.3.plant.gain"], gains)
    assert np.array_equal(frame["contour_error_max"], batch.figures["contour_error_max"])
    line = batch.plot("contour_error_rms").axes[0].lines[0]
    assert line.get_xdata().tolist() == [0.9, 1.0, 1.1] and line.get_ydata()[-1] == 1e6 * batch.figures["contour_error_rms"][0]
    assert "<svg" in batch._repr_html_() and len(repr(batch)) < 500
    with pytest.raises(ParameterError):
        batch.plot("error")
