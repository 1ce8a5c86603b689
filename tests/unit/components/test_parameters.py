"""Parameters: bounds, units, defaults, options, lists, and the messages for refused values."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import make
from each import each
from hypothesis import given
from hypothesis import strategies as st
from refusals import refuses

from contourlab.components.contract import Component, Parameter, param, text_param
from contourlab.components.registry import components
from contourlab.errors import ComponentError, ParameterError
from contourlab.units import to_si


class Sample(Component):
    """One parameter of each kind."""

    family = "drive"
    kind = "sample"

    plain: float = param(unit="N/A", minimum=0.0, maximum=10.0, display="N/A", doc="between two bounds")
    positive: float = param(default=1.0, unit="m", minimum=0.0, exclusive=True, display="mm", doc="above zero")
    count: float = param(default=2.0, minimum=1.0, maximum=8.0, whole=True, doc="a whole number")
    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, doc="none by default")
    free: float = param(default=0.0, unit="{force}", doc="any")
    series: tuple[float, ...] = param(default=(1.0,), unit="N", minimum=-1.0, vector=True, doc="a list")  # type: ignore[arg-type]
    rule: str = text_param("left", ("left", "right"), doc="a word")


NUMBERS = [
    (kind, parameter) for kind in components() for parameter in kind.parameters.values() if not parameter.choices and not parameter.vector
]


def named(kind: type[Component], parameter: Parameter | None = None, value: float | None = None) -> str:
    return ".".join([f"{kind.family}/{kind.kind}", *([parameter.name] if parameter else []), *([] if value is None else [f"{value:g}"])])


def refused(kind: type[Component], **values: Any) -> ParameterError:
    with pytest.raises(ParameterError) as caught:
        kind(**{**kind.example, **values})
    return caught.value


# --- every parameter of every component ------------------------------------------------------------------------------------------------


@each("kind, parameter, value", [(*one, value) for value in (math.nan, math.inf, -math.inf) for one in NUMBERS], named)
def test_numbers_that_are_not_finite_are_refused_by_name(kind: type[Component], parameter: Parameter, value: float) -> None:
    if value == math.inf == parameter.default:
        try:
            kind(**{**kind.example, parameter.name: value})
        except ParameterError as error:  # some examples leave it out
            assert (error.name, error.value) == (parameter.name, "not given")
        return
    error = refused(kind, **{parameter.name: value})
    assert (error.name, error.value) == (parameter.name, f"{value:g}")
    assert "finite" in error.bound and parameter.bound in error.bound
    assert f"{parameter.name} = {error.value}" in str(error)
    assert "{" not in str(error)


@each("kind, parameter", NUMBERS, named)
def test_the_bounds_hold_to_the_last_bit(kind: type[Component], parameter: Parameter) -> None:
    for bound, beyond in ((parameter.minimum, -math.inf), (parameter.maximum, math.inf)):
        if not math.isfinite(bound):
            continue
        outside = bound if bound == parameter.minimum and parameter.exclusive else math.nextafter(bound, beyond)
        error = refused(kind, **{parameter.name: outside})
        assert error.name == parameter.name and f"{bound:g}" in error.bound
        inside = math.nextafter(bound, -beyond) if outside == bound else bound
        if not parameter.whole or inside == round(inside):
            assert parameter.check(inside) == inside
            try:
                assert getattr(kind(**{**kind.example, parameter.name: inside}), parameter.name) == inside
            except ParameterError as error:  # some are checked together: the message names both
                assert f"{inside:g}" in f"{error} {inside:g}" and error.bound != parameter.bound


@each("kind, parameter", NUMBERS, named)
def test_units_are_read_and_agree_with_the_displayed_ones(kind: type[Component], parameter: Parameter) -> None:
    for command, force in (("A", "N"), ("full_scale", "full_scale")):
        known = parameter.for_plant(command, force)
        if known.unit:
            # In SI already, and of the same quantity as the displayed unit: one metre too many would raise.
            assert to_si(f"1 {known.unit}", known.unit) == 1.0
            assert to_si(f"1 {known.display}", known.unit) > 0.0


@each("kind", components(), named)
def test_a_missing_value_without_default_is_requested(kind: type[Component]) -> None:
    for name, parameter in kind.parameters.items():
        if parameter.default is None:
            given = {key: value for key, value in kind.example.items() if key != name}
            with refuses(ParameterError, name=f"{kind.kind}.{name}", value="not given"):
                kind(**given)


@each("kind", components(), named)
def test_unknown_names_are_answered_with_those_there_are(kind: type[Component]) -> None:
    answer = f"use one of {', '.join(kind.parameters)}" if kind.parameters else "none is allowed here"
    with pytest.raises(ComponentError, match=rf"{kind.kind}: no parameter 'xyzzy': {answer}$"):
        kind(**{**kind.example, "xyzzy": 1.0})


# --- one of each kind ------------------------------------------------------------------------------------------------------------------


def test_numbers_of_any_type_become_floats() -> None:
    for five in (5, 5.0, np.float32(5.0), np.int64(5), np.float64(5.0)):
        value = Sample(plain=five).plain
        assert type(value) is float and value == 5.0


@pytest.mark.parametrize("value", [True, "5", None, [5.0], 5j, np.array([5.0]), {}])
def test_non_numbers_are_refused(value: Any) -> None:
    if value is None:
        assert refused(Sample, plain=value).bound == "given, >= 0 and <= 10 N/A"
    else:
        error = refused(Sample, plain=value)
        assert error.bound.startswith("a number") and "N/A" in str(error)


@each(
    "values, name, value, bound, unit",
    [
        ({"plain": -1.0}, "plain", "-1", ">= 0 and <= 10", "N/A"),
        ({"plain": 11.0}, "plain", "11", ">= 0 and <= 10", "N/A"),
        ({"plain": 1.0, "positive": 0.0}, "positive", "0", "> 0", "m"),
        ({"plain": 1.0, "count": 2.5}, "count", "2.5", ">= 1 and <= 8", ""),
        ({"plain": 1.0, "count": 9}, "count", "9", ">= 1 and <= 8", ""),
        ({"plain": 1.0, "limit": -1.0}, "limit", "-1", ">= 0", "command"),
        ({"plain": 1.0, "free": math.nan}, "free", "nan", "finite", "force"),
        ({"plain": 1.0, "limit": math.nan}, "limit", "nan", "finite and >= 0", "command"),
        ({"plain": 10**400}, "plain", "inf", "finite and >= 0 and <= 10", "N/A"),
        ({"plain": 1.0, "series": (0.0, -2.0)}, "series", "-2", ">= -1", "N"),
        ({"plain": 1.0, "series": ()}, "series", "()", "list", "N"),
        ({"plain": 1.0, "series": "1 2"}, "series", "'1 2'", "list", "N"),
        ({"plain": 1.0, "series": 3.0}, "series", "3.0", "list", "N"),
        ({"plain": 1.0, "series": (1.0, math.inf)}, "series", "inf", "finite and >= -1", "N"),
        ({"plain": 1.0, "rule": "up"}, "rule", "'up'", "left, right", ""),
        ({"plain": 1.0, "rule": 1.0}, "rule", "1.0", "left, right", ""),
    ],
)
def test_a_refusal_names_parameter_value_and_bound(values: dict[str, Any], name: str, value: str, bound: str, unit: str) -> None:
    error = refused(Sample, **values)
    assert (error.name, str(error.value), error.unit) == (name, value, unit)
    assert bound in error.bound and str(error).startswith(f"{name} = {value}") and unit in str(error)


def test_defaults_apply_to_missing_values() -> None:
    assert Sample(plain=1.0).values() == {
        "plain": 1.0,
        "positive": 1.0,
        "count": 2.0,
        "limit": math.inf,
        "free": 0.0,
        "series": (1.0,),
        "rule": "left",
    }


def test_numeric_rows_leave_out_options_and_lists() -> None:
    assert Sample.numeric() == ("plain", "positive", "count", "limit", "free")


@given(
    value=st.one_of(st.floats(), st.integers(), st.booleans(), st.text(max_size=3), st.none(), st.lists(st.floats(), max_size=2)),
    low=st.floats(-10.0, 10.0),
    width=st.floats(0.0, 10.0),
    exclusive=st.booleans(),
    whole=st.booleans(),
)
def test_a_value_is_in_range_or_refused(value: Any, low: float, width: float, exclusive: bool, whole: bool) -> None:
    made = param(unit="m", minimum=low, maximum=low + width, exclusive=exclusive, whole=whole, doc="d")
    try:
        found = made.check(value)
    except ParameterError as error:
        number = isinstance(value, float | int) and not isinstance(value, bool)
        inside = number and low <= value <= low + width and not (exclusive and value == low) and not (whole and value % 1)
        assert not inside
        assert error.bound
    else:
        assert type(found) is float and math.isfinite(found) and found == value
        assert low <= found <= low + width and not (exclusive and found == low) and not (whole and found % 1)


def test_a_component_is_frozen_and_compares_by_value() -> None:
    one, other = Sample(plain=1.0), Sample(plain=2.0)
    assert one != other and one == Sample(plain=1) and hash(one) == hash(Sample(plain=1))
    assert one.replace(plain=2.0) == other
    with pytest.raises(AttributeError, match=r"\.replace\(plain="):
        one.plain = 2.0  # type: ignore[misc]
    with pytest.raises(ParameterError):
        one.replace(plain=-1.0)


def test_a_force_table_needs_two_values() -> None:
    with refuses(ParameterError, "two numbers", name="forces"):
        make("disturbance", "table", time_step=0.1, forces=(1.0,))
    assert make("disturbance", "table", time_step=0.1, forces=[1, 2]).forces == (1.0, 2.0)
