"""Contours with an offset, and on machines with more axes than the path."""

from __future__ import annotations

import numpy as np
import pytest
from each import each
from refusals import mentions
from texts_of_scenarios import SCENARIO

import contourlab as cl
from contourlab.geometry import contour_names
from contourlab.geometry.nurbs import BSpline
from contourlab.geometry.parametric import EllipticalArc
from contourlab.geometry.path import Path
from contourlab.scenario import dump, parse_scenario
from contourlab.scenario.placing import placed

ON_XYZ = 'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\n[feed]\nfeedrate = "1 m/min"\n[contour]\n'


def curves() -> list[Path]:
    rest = [
        EllipticalArc((0.0, 0.0), (0.02, 0.0), (0.0, 0.01), 0.3, 2.0),
        BSpline(3, np.array([(0.0, 0.0), (0.01, 0.02), (0.03, 0.01), (0.04, 0.0)]), np.array([0.0] * 4 + [1.0] * 4)),
    ]
    return [*(cl.contour(name) for name in contour_names() if name not in ("helix", "lissajous")), *(Path([curve]) for curve in rest)]


@each("path", curves())
def test_a_path_is_shifted_and_constant_in_further_axes(path: Path) -> None:
    """A rigid shift keeps every derivative; the further coordinates have none."""
    moved = placed(path, (0.1, -0.02, 0.003))
    assert (moved.n_axis, moved.closed) == (3, path.closed)
    assert moved.length == pytest.approx(path.length, rel=1e-12)
    s = np.linspace(0.0, 0.999 * path.length, 57)
    old, new = path.derivatives(s), moved.derivatives(s)
    expected = np.column_stack([old[0], np.zeros(57)]) + np.array([0.1, -0.02, 0.003])
    np.testing.assert_allclose(new[0], expected, rtol=0, atol=1e-14)
    size = np.abs(old[1:]).max(axis=(1, 2), keepdims=True) + 1e-9
    np.testing.assert_allclose(new[1:, :, :2] / size, old[1:] / size, rtol=0, atol=1e-9)
    assert not new[1:, :, 2].any()
    np.testing.assert_allclose(moved.corners, path.corners, rtol=0, atol=1e-12)


def test_a_shifted_circle_stays_a_circle_and_a_zero_shift_changes_nothing() -> None:
    path = cl.contour("circle")
    assert placed(path, (0.0, 0.0)) is path
    (arc,) = placed(path, (0.01, 0.0, 0.0)).curves
    assert isinstance(arc, type(path.curves[0]))


def test_a_plane_contour_holds_the_third_axis_still() -> None:
    case = parse_scenario(ON_XYZ + 'name = "circle"\nradius = "10 mm"\noffset = ["30 mm", "-40 mm", "5 mm"]\n').base
    position = case.reference().path.position(np.linspace(0.0, 0.06, 9))
    np.testing.assert_allclose(np.linalg.norm(position - (0.03, -0.04, 0.005), axis=1), 0.01, rtol=1e-12)
    assert (position[:, 2] == 0.005).all()
    assert len(case.motion.notes) == 1 and mentions(case.motion.notes, "still", "z at 5 mm")


def test_an_offset_survives_a_round_trip() -> None:
    scenario = parse_scenario(ON_XYZ + 'name = "circle"\noffset = ["30 mm", "-40 mm"]\n')
    assert 'offset = ["30 mm", "-40 mm"]' in dump(scenario)
    again = parse_scenario(dump(scenario))
    assert again.motion == scenario.motion
    assert dump(again) == dump(scenario)


def test_the_offset_is_applied_before_the_check_of_the_travel() -> None:
    """A travel of 300 mm around the middle: 130 + 20 mm touches its end, one micrometre more leaves it."""
    text = ON_XYZ + 'name = "circle"\nradius = "20 mm"\noffset = ["{} mm", "0 mm"]\n'
    assert parse_scenario(text.format("130")).base.reference().n_sample
    message = r'axis x .* 110\.001 to 150\.001 mm, .*: move it with offset = \["10 mm", "10 mm", "10 mm"\] under \[contour\]'
    with pytest.raises(cl.ContourlabError, match=message):
        parse_scenario(text.format("130.001")).base.reference()


def test_corner_tolerances_need_a_blend() -> None:
    text = SCENARIO.replace('\nlaw = "uniform"\nfrequency = "0.5 Hz"\nlaps = 2\n', '\nfeedrate = "1 m/min"\n{}\n')
    for control, name, words in (
        ('path_control = "exact_path"', "corner_tolerance", 'path_control = "exact_path" blends nothing'),
        ('path_control = "exact_stop"', "merge_tolerance", 'path_control = "exact_stop" blends nothing'),
        ("", "corner_tolerance", "exactly"),
    ):
        with pytest.raises(cl.ContourlabError, match=rf"feed.{name}: .*{words}"):
            parse_scenario(text.format(f'{control}\n{name} = "5 um"'))
    blend = text.format('path_control = "blend"\ncorner_tolerance = "5 um"\nmerge_tolerance = "0 um"')
    # Inherited tolerances may be idle: a scheme then compares a blend with none.
    both = parse_scenario(blend + '[schemes.exact.feed]\npath_control = "exact_path"\n')
    assert [case.feed.path_control for case in both.cases()] == ["exact_path"]
    assert dump(parse_scenario(dump(both))) == dump(both)
