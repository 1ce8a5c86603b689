"""Motions that are impossible for a machine."""

from __future__ import annotations

import pytest
from refusals import refuses
from texts_of_scenarios import SCENARIO

import contourlab as cl
from contourlab.errors import ScenarioError
from contourlab.scenario import parse_scenario


def scenario(*changes: tuple[str, str]) -> cl.Scenario:
    text = SCENARIO
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return parse_scenario(text)


def test_a_uniform_law_respects_the_axis_limits() -> None:
    """R = 20 mm: 125.7 mm/s and 0.79 m/s^2 at 1 Hz; 157.1 mm/s (limit 150 mm/s) at 1.25 Hz; 2.1 m/s^2 at 1.25 Hz needs R = 34 mm."""
    assert scenario(("0.5 Hz", "1 Hz")).base.reference().n_sample == 2000
    with pytest.raises(cl.ContourlabError, match=r"circle: axis x .*157\.1 mm/s.* 150 mm/s.*0\.955"):
        scenario(("0.5 Hz", "1.25 Hz")).base.reference()
    free = scenario(("0.5 Hz", "1.25 Hz"), ('velocity = "150 mm/s"', 'velocity = "1 m/s"'))
    with pytest.raises(cl.ContourlabError, match=r"1\.234 m/s\^2.* 1 m/s\^2.* 0\.9 "):
        free.base.reference()


def test_a_motion_of_months_is_refused_at_once() -> None:
    with pytest.raises(cl.ContourlabError, match=r"2e\+07 s.*2e\+10 samples.* 1e\+08 "):
        scenario(("0.5 Hz", "1e-7 Hz")).base.reference()


def test_a_scheme_cannot_name_an_unknown_axis() -> None:
    scheme = '[schemes.off]\ncontroller.axes."9".observer = "none"\n'
    with refuses(ScenarioError, "'9'.*x, y", key="schemes.off.controller.axes.9"):
        parse_scenario(SCENARIO + scheme)
    named = SCENARIO.replace('controller.axes."*".controller]', "controller.axes.x.controller]").replace(
        "[controller.axes.y.observer]",
        '[controller.axes.y.controller]\nkind = "position"\nposition_gain = "4 full_scale/mm"\n[controller.axes.y.observer]',
    )
    assert named != SCENARIO
    with refuses(ScenarioError, "'9'.*x, y", key="schemes.off.controller.axes.9"):
        parse_scenario(named + scheme)
    assert parse_scenario(named + scheme.replace('"9"', "y")).case("off").controller.axes["y"].observer is None


def test_a_friction_too_steep_for_the_step_is_refused() -> None:
    """a F_s / v_e = 1.1 * 0.06 / 1e-5 = 6600 1/s: 6.6 per millisecond, while Runge-Kutta is stable up to 2.78."""
    smooth = (
        'kind = "coulomb"\ncoulomb = "0.05 full_scale"',
        'kind = "smooth-coulomb"\ncoulomb = "0.05 full_scale"\nbreakaway = "0.06 full_scale"',
    )
    with refuses(ScenarioError, r"axes\.y\.substeps = 1: .*\b3\b.*smooth-coulomb", key="machine"):
        scenario(smooth)
    assert scenario(smooth, ('mounted_on = "x"', "substeps = 3")).machine.axis("y").substeps == 3
    assert scenario(smooth, ('breakaway = "0.06 full_scale"', 'breakaway = "0.06 full_scale"\nsmoothing_velocity = "0.1 mm/s"'))


def test_a_structure_that_moves_by_its_integral_needs_an_integral_gain() -> None:
    with pytest.raises(cl.ContourlabError, match=r"integral_gain = 0.*: must be > 0 with structure"):
        scenario(('kind = "position"\n', 'kind = "position"\nstructure = "ipv"\n'))
