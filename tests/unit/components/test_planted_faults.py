"""The conformance test must find and name each planted fault."""

from __future__ import annotations

import re

import faulty_components as faults
import pytest
from each import each

from contourlab.components.conformance import check_component
from contourlab.components.contract import Component
from contourlab.errors import ComponentError

IN_PLAIN_PYTHON = [
    (faults.WallClock, "perf_counter cannot be called"),
    (faults.Dice, "random cannot be called.* uniform"),
    (faults.Loaded, "two runs differ"),
    (faults.Tired, "in its states"),
    (faults.Hoarder, r"assign to MEMORY\[0\].*state"),
    (faults.Scribbler, r"assign to par\.scratch\[0\]"),
    (faults.Reassigner, r"assign to par\.gain"),
    (faults.Counter, "range of a number"),
    (faults.Summed, "sum cannot be called.* dot"),
    (faults.Branching, "derive must take arrays.* numpy"),
    (faults.Idle, "parameter trim"),
    (faults.IdleWord, "parameter rule"),
    (faults.Enclosed, r"gain from par.* par\.gain"),
    (faults.Named, r"gain from par.* par\.gain"),
    (faults.Nameless, r"shape: .*cannot be called as step\(par, x, inp, clock\)"),
    (faults.NotANumber, "finite"),
    (faults.Overflowing, "finite"),
    (faults.RottenInside, "finite"),
    (faults.Divider, "fails.*ZeroDivisionError"),
    (faults.Misspelt, "no name 'nonsense'"),
    (faults.Talkative, "2 outputs.*declares 1"),
    (faults.Forgetful, "0 states.*declares 1"),
    (faults.HalfVector, "tuple of 1 for output modified_reference.* 2"),
    (faults.WrongInput, "drive.*input 'comand'.* command"),
    (faults.WrongOutput, "'applied'.*outputs"),
    (faults.Deaf, "'command'.*inputs"),
    (faults.Boundless, "gain .*no bound"),
    (faults.Undocumented, "gain .*no doc"),
    (faults.Mute, "docstring"),
    (faults.BadDefault, "default of gain"),
    (faults.ExampleText, "example = .*not a dict"),
    (faults.ReferenceTuple, "reference = .*not a str"),
    (faults.BadExample, "example.*gain = -1"),
    (faults.NoExample, "example.*gain = not"),
    (faults.ForgottenDerived, "derive returns 0 numbers.* half"),
    (faults.Lawless, r"law 'magic'.*smooth.*force\(par, v\).*sticking.*bristle"),
    (faults.Clash, "parameter 'mass'"),
    (faults.LyingGain, r"linear model.*command to applied.* 2\+0j.* 1\+0j"),
    (faults.LyingName, "linear model.*'current'.* command"),
    (faults.LyingType, "linearize returns 1.0.* LinearModel"),
    (faults.LyingShape, "linear model.*shapes"),
    (faults.LyingPole, "linear model.*command to (position|velocity)"),
    (faults.LyingSign, "linear model.*to disturbance_estimate"),
    (faults.Pusher, "energy.* 1e-07 m/s"),
    (faults.Puller, "energy"),
]


def test_the_faultless_pattern_passes() -> None:
    check_component(faults.Amplifier)
    assert "every parameter has an effect (2)" in check_component(faults.Worded)


@each("faulty, said", IN_PLAIN_PYTHON)
def test_a_fault_is_found_in_plain_python(faulty: type[Component], said: str) -> None:
    with pytest.raises(ComponentError, match=said) as caught:
        check_component(faulty, jit=False)
    assert re.match(rf"{re.escape(faults.__file__)}:\d+: {faulty.__name__}: ", str(caught.value)), caught.value
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("faulty", "said"),
    [
        (faults.WideInteger, "the compiled form and plain Python differ"),
        (faults.Uncompilable, "cannot use an f-string"),
        (faults.Loaded, "two runs differ"),
        (faults.NotANumber, "finite"),
    ],
)
def test_a_fault_is_found_with_the_compiler(faulty: type[Component], said: str) -> None:
    with pytest.raises(ComponentError, match=said) as caught:
        check_component(faulty)
    assert faulty.__name__ in str(caught.value)


def test_a_class_that_is_no_component_is_refused() -> None:
    for thing in (3, faults.Amplifier(), Component, object):
        with pytest.raises(ComponentError, match="not a component"):
            check_component(thing)  # type: ignore[arg-type]


def test_an_unknown_family_is_refused_at_once() -> None:
    with pytest.raises(ComponentError, match=r"^Gearbox: .*\bplant\b"):
        type("Gearbox", (Component,), {"family": "gearbox", "kind": "two-speed"})
