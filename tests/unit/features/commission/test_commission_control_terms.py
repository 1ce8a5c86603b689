"""The terms of other controls against the law of HAL's pid, and against their definitions."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from contourlab.errors import ParameterError
from contourlab.features.commission.control_terms import CONTROLS, Cascade, cascade_of, terms_of
from contourlab.features.commission.loop import AxisModel, Law, law_output
from contourlab.features.commission.options import LinuxCNC

PERIOD = 1e-3
ROW = np.array([20e3, 400.0, 150.0, 0.0, 36.0, 0.45, 0.0])
MODEL = AxisModel(gain=2.0, damping=30.0, friction=0.04, delay=0.3e-3)


def axis(previous: bool, play: float = 20e-6) -> Any:
    return SimpleNamespace(model=MODEL, law=Law(PERIOD, previous), play=play)


def values(control: str, cascade: Cascade) -> dict[str, float]:
    return {term.name: term.values["x"] for term in terms_of(control, {"x": cascade})}


@pytest.mark.parametrize("previous", [False, True])
def test_cascade_is_the_pid_on_its_axis(previous: bool) -> None:
    n = 3000
    time = PERIOD * np.arange(n)
    command = 0.01 * (1.0 - np.cos(2.0 * np.pi * (0.5 + 0.5 * time) * time))
    measured = 0.97 * np.concatenate([np.zeros(3), command[:-3]])
    cascade = cascade_of(ROW, axis(previous))
    rate, velocity = (np.diff(part, prepend=part[:1]) / PERIOD for part in (command, measured))
    error = command - measured
    # With the previous target the integral lags too: by Ts r in all.
    summed = PERIOD * np.cumsum(error) - (PERIOD * (command - command[0]) if previous else 0.0)
    ahead = cascade.weight * rate + cascade.ahead * np.diff(rate, prepend=rate[:1]) / PERIOD
    wanted = cascade.kv * (error + summed / cascade.reset) + ahead
    output = law_output(command, measured, ROW.tolist(), Law(PERIOD, previous))
    lag = cascade.lag - MODEL.delay
    assert (wanted - velocity) / lag == pytest.approx(MODEL.gain * output - MODEL.damping * velocity, abs=1e-9)


def test_parameters_have_the_units_of_their_control() -> None:
    cascade = cascade_of(ROW, axis(True))
    gain = 150.0 + 30.0 / 2.0
    siemens, beckhoff, generic = (values(control, cascade) for control in ("sinumerik", "twincat", "generic"))
    # 1 (m/min)/mm is a following error of 1 mm at 1 m/min.
    assert siemens["MD32200 POSCTRL_GAIN"] * 1.0 / 60.0 / 1e-3 == pytest.approx(cascade.kv) == pytest.approx(20e3 / gain)
    assert siemens["MD32810 EQUIV_SPEEDCTRL_TIME"] == pytest.approx(1.0 / (2.0 * gain) + 0.3e-3)
    assert siemens["MD32450 BACKLASH"] == beckhoff["MC_BacklashCompensation.Backlash"] == pytest.approx(0.02)
    # This step of the set velocity makes the velocity loop reverse the friction.
    assert siemens["MD32520 FRICT_COMP_CONST_MAX"] / 6e4 * gain == pytest.approx(2.0 * 0.04 / 2.0)
    assert beckhoff["Position control: Proportional Factor Kv"] == pytest.approx(cascade.kv)
    assert beckhoff["Position control: Integral Action Time Tn"] == pytest.approx(50.0)
    assert generic["velocity feedforward"] == pytest.approx(100.0 * (150.0 + 36.0 - 20.0) / gain)
    assert generic["velocity loop: gain Kp"] == pytest.approx(0.15)
    assert generic["friction feedforward"] == pytest.approx(0.02)


def test_feedforward_weight_ends_at_one_where_the_control_does() -> None:
    cascade = replace(cascade_of(ROW, axis(True)), weight=1.2)
    assert values("sinumerik", cascade)["MD32610 VELO_FFW_WEIGHT"] == 1.0
    assert values("twincat", cascade)["Feedforward Velocity: Pre-Control Weighting"] == 1.0
    assert values("generic", cascade)["velocity feedforward"] == pytest.approx(120.0)


def test_without_gain_in_the_velocity_loop_the_damping_of_the_axis_is_it() -> None:
    row = np.array([2e3, 0.0, 0.0, 0.0, 17.0, 0.0, 0.0])
    cascade = cascade_of(row, axis(True))
    assert cascade.kv == pytest.approx(2e3 * 2.0 / 30.0)
    assert cascade.weight == pytest.approx(1.0)
    assert np.isinf(cascade.reset)


def test_unknown_control_is_refused() -> None:
    log = Path("log.csv")
    with pytest.raises(ParameterError):
        LinuxCNC(log=(log,), for_="fanuc")
    assert [LinuxCNC(log=(log,), for_=control).for_ for control in CONTROLS] == list(CONTROLS)
