"""Arguments of runs that would give a wrong result without a word are refused by name."""

from __future__ import annotations

import math
from contextlib import nullcontext
from typing import Any

import numpy as np
import pytest
from faulty_components import Amplifier, Enclosed, Named, Shaped
from refusals import refuses
from stages import PERIOD, make, with_axis

import contourlab as cl
from contourlab.components.contract import param
from contourlab.errors import ParameterError
from contourlab.geometry import Path
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import Learned
from contourlab.loop.batch import check_together
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
    made = cl.contour("circle", radius=5e-3)
    reference, equal = (cl.uniform(Path(made.curves, made.closed), 0.1, 1, PERIOD) for _ in range(2))
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


class Matched(Amplifier):
    """Checks its values together, in a way that takes numbers only."""

    kind = "matched"
    low: float = param(default=1.0, minimum=0.0, doc="gain")
    high: float = param(default=2.0, minimum=0.0, doc="gain")

    def check_values(self) -> None:
        if np.max([self.low, -self.high]) > 4.0 or not (self.high / self.low).is_integer():
            raise ParameterError("high", f"{self.high:g}", "a multiple of low, which is at most 4")


@pytest.mark.parametrize(("values", "good"), [([2.0, 4.0, 6.0], True), ([2.0, 4.5, 6.0], False), ([4.0, 10.0, 12.0], False)])
def test_a_plugin_checks_each_variant_on_its_own(
    values: list[float], good: bool, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference
) -> None:
    moved = with_axis(machine, "x", drive=Matched(low=1.0, high=2.0))
    variants = {"axes.x.drive.high": values, "axes.x.drive.low": [1.0, values[0] / 2.0, values[0] / 2.0 if good else 5.0]}
    with nullcontext() if good else refuses(ParameterError, name="high"):
        assert cl.simulate_batch(moved, controller, circle, variants).failed_at.size == 3


@pytest.mark.parametrize(("pair", "wanted"), [((3e-6, 2e-6), "backlash_gap"), ((1e-6, 2e-6), "")])
def test_values_that_do_not_fit_together_are_refused_in_any_variant(pair: tuple[float, float], wanted: str) -> None:
    """Checked for all variants at once, with the words of one."""
    part = make("compensation", "adaptive-backlash-inverse", backlash_gap=1e-6, largest_gap=2e-6)
    known = {f"c.{name}": (part, name) for name in ("backlash_gap", "largest_gap")}
    columns = {name: np.repeat([[1e-6, 2e-6]], 50, axis=0)[:, i] for i, name in enumerate(known)}
    for (name, column), value in zip(columns.items(), pair, strict=True):
        columns[name] = np.insert(column, 31, value)
    with refuses(ParameterError, name=wanted) if wanted else nullcontext():
        check_together(known, columns)


def test_a_whole_number_is_whole_in_every_variant(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    noisy = with_axis(machine, "x", disturbance=make("disturbance", "low-passed-noise", rms=0.01, bandwidth=200.0, stream=1.0))
    with refuses(ParameterError, name="stream"):
        cl.simulate_batch(noisy, controller, circle, {"axes.x.disturbance.stream": [0.0, 2.1, 7.0]})


@pytest.mark.parametrize("values", [np.ones((4, 2)) + 1j, np.array([["a", "b"]]), np.ones(4), [[math.nan, 0.0]], np.array([[None, 1.0]])])
def test_learned_tables_are_real_and_finite(values: Any) -> None:
    for name in ("command", "reference"):
        with refuses(ParameterError, name=f"learned.{name}"):
            Learned(**{name: values})
