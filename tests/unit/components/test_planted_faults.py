"""The conformance test has to find each fault, and say what it is."""

from __future__ import annotations

import faulty_components as faults
import pytest

from contourlab.components.conformance import check_component
from contourlab.components.contract import Component
from contourlab.errors import ComponentError

IN_PLAIN_PYTHON = [
    (faults.WallClock, "two runs differ"),
    (faults.Dice, "two runs differ"),
    (faults.Hoarder, "all it remembers must be in its states"),
    (faults.Scribbler, "all it remembers must be in its states"),
    (faults.Reassigner, "fails in plain Python: AttributeError"),
    (faults.Counter, "fails in plain Python: TypeError: 'float'"),
    (faults.Idle, "parameter trim has no effect"),
    (faults.IdleWord, "parameter rule has no effect"),
    (faults.NotANumber, "not all finite"),
    (faults.Overflowing, "not all finite"),
    (faults.RottenInside, "not all finite"),
    (faults.Divider, "fails in plain Python: ZeroDivisionError"),
    (faults.Misspelt, "fails in plain Python: NameError: name 'nonsense'"),
    (faults.Talkative, "2 outputs are returned, 1 declared"),
    (faults.Forgetful, "0 states are returned, 1 declared"),
    (faults.HalfVector, "1 numbers are returned for output modified_reference, which has 2"),
    (faults.WrongInput, "no input 'comand' is offered to a drive; there are: command"),
    (faults.WrongOutput, "'applied' is missing in its outputs"),
    (faults.Deaf, "'command' is missing in its inputs"),
    (faults.Boundless, "parameter gain has no bound"),
    (faults.Undocumented, "parameter gain has no doc"),
    (faults.Mute, "has no docstring"),
    (faults.BadDefault, "default of gain is out of its own range"),
    (faults.BadExample, "its example does not make a component: gain = -1"),
    (faults.NoExample, "its example does not make a component: .*gain = not given"),
    (faults.ForgottenDerived, "fails in plain Python: ValueError"),
    (faults.Lawless, "law 'magic' is none of smooth, sticking, bristle"),
    (faults.Clash, "both have a parameter 'mass'"),
    (faults.LyingGain, r"its linear model is not .* from command to applied at .* 2\+0j, the step 1\+0j"),
    (faults.LyingName, "its linear model is not .* it names input 'current'; there are: command"),
    (faults.LyingShape, "its linear model is not .* shapes"),
    (faults.LyingPole, "its linear model is not .* from command to (position|velocity)"),
    (faults.LyingSign, "its linear model is not .* from applied to disturbance_estimate"),
    (faults.Pusher, "feeds energy in at 1e-07 m/s"),
    (faults.Puller, "feeds energy in at "),
]


def test_the_pattern_is_sound() -> None:
    check_component(faults.Amplifier)


@pytest.mark.parametrize(("faulty", "said"), IN_PLAIN_PYTHON, ids=lambda value: value.__name__ if isinstance(value, type) else "")
def test_a_fault_is_found_in_plain_python(faulty: type[Component], said: str) -> None:
    with pytest.raises(ComponentError, match=said) as caught:
        check_component(faulty, jit=False)
    assert faulty.__name__ in str(caught.value)


@pytest.mark.parametrize(
    ("faulty", "said"),
    [
        (faults.WideInteger, "compiled form and plain Python differ by"),
        (faults.Uncompilable, "cannot be compiled: .*format spec"),
        (faults.Hoarder, "all it remembers must be in its states"),
        (faults.Dice, "two runs differ"),
        (faults.NotANumber, "not all finite"),
    ],
)
def test_a_fault_is_found_with_the_compiler(faulty: type[Component], said: str) -> None:
    with pytest.raises(ComponentError, match=said) as caught:
        check_component(faulty)
    assert faulty.__name__ in str(caught.value)


def test_what_is_no_component_is_refused() -> None:
    for thing in (3, faults.Amplifier(), Component, object):
        with pytest.raises(ComponentError, match="a class with family and kind is wanted"):
            check_component(thing)  # type: ignore[arg-type]


def test_a_family_that_does_not_exist_is_refused_at_once() -> None:
    with pytest.raises(ComponentError, match="family 'gearbox' is none of plant, friction"):
        type("Gearbox", (Component,), {"family": "gearbox", "kind": "two-speed"})
