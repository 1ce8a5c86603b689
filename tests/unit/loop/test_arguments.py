"""Arguments of runs that would give a wrong result without a word are refused by name."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from faulty_components import Enclosed, Named, Shaped
from refusals import refuses
from stages import PERIOD, with_axis

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import Learned
from contourlab.loop.trials import Trials

OTHERS = [view_of(cl.contour("circle", radius=6e-3)), view_of(cl.contour("ellipse")), PathView(lambda par, s: s, {}, {}), 3]


@pytest.mark.parametrize("view", OTHERS, ids=["circle", "ellipse", "made", "number"])
def test_a_view_of_another_path_is_refused(view: Any, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    gain = next(iter(cl.parameter_names(machine, controller)))
    with refuses(ParameterError, name="view"):
        cl.simulate(machine, controller, circle, view=view)
    with refuses(ParameterError, name="view"):
        cl.simulate_batch(machine, controller, circle, {gain: [1.0]}, view=view)
    with refuses(ParameterError, name="view"):
        Trials(machine, controller, circle, view=view)


def test_a_view_of_an_equal_path_is_taken(machine: cl.Machine, controller: cl.Controller) -> None:
    reference, equal = (cl.uniform(cl.contour("circle", radius=5e-3), 0.1, 1, PERIOD) for _ in range(2))
    assert equal.path is not reference.path
    given, own = (cl.simulate(machine, controller, reference, view=view) for view in (view_of(equal.path), None))
    np.testing.assert_array_equal(given["axis_position"], own["axis_position"])


@pytest.mark.parametrize(
    ("name", "value"),
    [("trial", value) for value in (-1, 1.5, math.nan, "x", None)] + [("on_failure", "x"), ("on_failure", None), ("jit", "no"), ("jit", 2)],
)
def test_arguments_out_of_range(name: str, value: Any, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    with refuses(ParameterError, name=name):
        cl.simulate(machine, controller, circle, **{name: value})


@pytest.mark.parametrize(("places", "name"), [((1, 0, 2), "machine"), ((0, 2, 1), "controller"), ((0, 1, 1), "reference")])
def test_arguments_in_exchanged_places_are_named(places: Any, name: str, machine: Any, controller: Any, circle: Any) -> None:
    given = [(machine, controller, circle)[place] for place in places]
    for call in (cl.simulate, lambda *words: cl.simulate_batch(*words, {"x": [1.0]})):
        with refuses(ParameterError, name=name):
            call(*given)


@pytest.mark.parametrize("variants", [None, [1.0], "x", 3])
def test_variants_are_a_mapping(variants: Any, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    with refuses(ParameterError, name="variants"):
        cl.simulate_batch(machine, controller, circle, variants)


@pytest.mark.parametrize(("kind", "name"), [(Enclosed, "gain"), (Named, "gain"), (Shaped, "gain"), (Shaped, "bias")])
def test_variants_share_the_step(kind: Any, name: str, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """A parameter that a step takes from its component, not from `par`, would be the same in every lane."""
    moved, wanted = with_axis(machine, "x", drive=kind(gain=1.0)), f"axes.x.drive.{name}"
    if name == "bias":
        assert len(set(cl.simulate_batch(moved, controller, circle, {wanted: [0.5, 1.0]}).figures["contour_error_max"])) == 2
    else:
        with refuses(ParameterError, name=wanted if kind in (Enclosed, Named) else "variants"):
            cl.simulate_batch(moved, controller, circle, {wanted: [0.5, 1.0]})


@pytest.mark.parametrize("values", [np.ones((4, 2)) + 1j, np.array([["a", "b"]]), np.ones(4), [[math.nan, 0.0]], np.array([[None, 1.0]])])
def test_learned_tables_are_real_and_finite(values: Any) -> None:
    for name in ("command", "reference"):
        with refuses(ParameterError, name=f"learned.{name}"):
            Learned(**{name: values})
