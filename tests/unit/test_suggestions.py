"""A mistyped name suggests the nearest."""

from __future__ import annotations

import pytest

import contourlab as cl
from contourlab.errors import ContourlabError

SCENARIO = cl.load_scenario("builtin:demo-part")
GAINS = SCENARIO.controller.axes["x"].controller
RESULT = cl.Result("run", ("x",), 1e-3, {"position": cl.Signal([[0.0]], ("sample", "axis"), "m")})


@pytest.mark.parametrize(
    ("mistyped", "meant"),
    [
        (lambda: cl.component("controller", "positon"), "position"),
        (lambda: GAINS.replace(positon_gain=1.0), "position_gain"),
        (lambda: cl.contour("circel"), "circle"),
        (lambda: cl.contour("circle", raduis=1.0), "radius"),
        (lambda: RESULT["postion"], "position"),
        (lambda: cl.load_scenario("builtin:demo-prt"), "demo-part"),
        (lambda: SCENARIO.case("positin loop"), "position loop"),
    ],
)
def test_the_nearest_name_is_suggested(mistyped, meant):
    with pytest.raises(ContourlabError) as caught:
        mistyped()
    assert repr(meant) in str(caught.value)


def test_a_number_for_a_name_is_refused():
    for refused in (lambda: RESULT[0], lambda: cl.contour(3)):
        with pytest.raises(ContourlabError):
            refused()
