"""Provenance of numbers in files: reading, refusal, inheritance and writing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path

import pytest
from each import each
from hypothesis import given
from hypothesis import strategies as st
from refusals import refuses

from contourlab.components.origin import SOURCES, Origin
from contourlab.errors import ParameterError, ScenarioError
from contourlab.loop import Axis
from contourlab.scenario import builtin_names, dump, load_axis, load_machine, parse_scenario
from contourlab.scenario.build import build_axis
from contourlab.scenario.provenance import unstated
from contourlab.scenario.tree import parse_tree, settle

AXIS = """
{top}
[plant]
kind = "mass-damper"
mass = {mass}
damping = "100 N*s/m"
force_constant = "50 N/A"
[friction]
kind = "coulomb"
coulomb = {coulomb}
{more}
"""
SCENARIO = """
[machine]
name = "m"
servo_period = {{value = "1 ms", source = "measured", from = "oscilloscope"}}
axes = ["x", "y"]
[machine.squareness]
"x-y" = {{value = "20 um/m", source = "measured", note = "granite square"}}
[axes."*"]
stage_mass = {{value = "3 kg", source = "measured", from = "scales"}}
plant = {{kind = "rigid-axis", gain = {{value = "2 m/s^2/full_scale", source = "fitted", deviation = "1 %"}}, damping = "5 1/s"}}
limits.velocity = {{value = "6 m/min", source = "datasheet", from = "page 3"}}
[axes.y.error]
repeatability = {{value = "2 um", source = "datasheet"}}
[controller.axes."*"]
controller = {{kind = "position", gains = {{natural_frequency = "90 rad/s", damping = 0.8, pole = "90 rad/s"}}}}
[contour]
name = "circle"
[feed]
law = "uniform"
frequency = "1 Hz"
{more}
"""
FITTED = '{value = "20 kg", source = "fitted", deviation = "0.5 kg", from = "log.mat", note = "of three"}'


def parsed(text: str) -> Axis:
    return build_axis(settle(parse_tree(text, "axis.toml")), "x")


def axis(mass: str = FITTED, coulomb: str = '"10 N"', top: str = "", more: str = "") -> Axis:
    return parsed(AXIS.format(mass=mass, coulomb=coulomb, top=top, more=more))


def test_a_number_is_read_with_its_origin() -> None:
    found = axis()
    assert found.plant.mass == 20.0
    assert found.plant.origins == {"mass": Origin("fitted", deviation=0.5, reference="log.mat", note="of three")}
    assert found.plant == axis(mass='"20 kg"').plant, "where a number is from changes nothing of what runs"


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        ('deviation = "1.5 %"', Origin("measured", deviation=0.3)),
        ('deviation = "250 g"', Origin("measured", deviation=0.25)),
        ('range = ["19 kg", "22000 g"]', Origin("measured", span=(19.0, 22.0))),
        ('note = "by hand"', Origin("measured", note="by hand")),
    ],
)
def test_deviations_are_in_units_or_percent(said: str, wanted: Origin) -> None:
    found = axis(mass=f'{{value = "20 kg", source = "measured", {said}}}').plant.origins["mass"]
    for name in (field.name for field in fields(Origin)):
        assert getattr(found, name) == (pytest.approx(getattr(wanted, name)) if name == "deviation" else getattr(wanted, name))


@each(
    "mass, key, words",
    [
        ('{value = "20 kg"}', "plant.mass", "source"),
        ('{source = "fitted"}', "plant.mass", "key value"),
        ('{value = "20 kg", source = "guessed"}', "plant.mass.source", "measured ("),
        ('{value = "20 kg", source = "fitted", devation = "1 %"}', "plant.mass.devation", "'deviation'"),
        ('{value = "20 kg", source = "fitted", deviation = "1 mm"}', "plant.mass.deviation", "to kg"),
        ('{value = "20 kg", source = "fitted", deviation = 0.5}', "plant.mass.deviation", "no unit"),
        ('{value = "20 kg", source = "fitted", deviation = "-1 %"}', "plant.mass.deviation", "must be > 0"),
        ('{value = "20 kg", source = "fitted", deviation = "x %"}', "plant.mass.deviation", "a number and %"),
        ('{value = "20 kg", source = "fitted", range = "1 kg"}', "plant.mass.range", "list"),
        ('{value = "20 kg", source = "fitted", range = ["21 kg", "22 kg"]}', "plant.mass.range", "between"),
        ('{value = "20 kg", source = "fitted", range = ["-1 kg", "22 kg"]}', "plant.mass.range", "must be > 0"),
        ('{value = "20 kg", source = "fitted", deviation = "1 %", range = ["19 kg", "22 kg"]}', "plant.mass.range", "one distribution"),
        ('{value = "20 kg", source = "design", deviation = "1 %"}', "plant.mass.source", "no deviation"),
        ('{value = "20 kg", source = "fitted", from = ["log"]}', "plant.mass.from", "quotes"),
        ('{value = "20 kg", source = "fitted", note = "a\\nb"}', "plant.mass.note", "one line"),
        ('{value = "20 mm", source = "fitted"}', "plant.mass", "to kg"),
        ('{value = "-20 kg", source = "fitted"}', "plant.mass", "must be > 0"),
    ],
)
def test_invalid_entries_are_refused_in_words(mass: str, key: str, words: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        axis(mass=mass)
    assert caught.value.key == key
    assert words in str(caught.value)


def test_a_percentage_of_zero_is_no_deviation() -> None:
    with refuses(ScenarioError, "value is 0", key="friction.coulomb.deviation"):
        axis(coulomb='{value = "0 N", source = "fitted", deviation = "1 %"}')


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ('[limits]\nvelocity = {value = "1 m/s", source = "datasheet", deviation = "1 %"}', "simulated"),
        ('[drive]\nkind = {value = "saturation", source = "datasheet"}', "drive.kind"),
        ('[disturbance]\nkind = "force-ripple"\npitch = "20 mm"\nphases = ["0 deg"]\n'
         'amplitudes = {value = ["1 N"], source = "fitted", deviation = "1 %"}', "list"),
    ],
)  # fmt: skip
def test_only_simulated_numbers_may_have_deviations(more: str, words: str) -> None:
    with pytest.raises(ScenarioError, match=words):
        axis(more=more)


def test_gains_by_design_are_chosen_numbers() -> None:
    found = parse_scenario(SCENARIO.format(more="")).base.controller.axes["x"].controller.origins
    assert {origin.source for origin in found.values()} == {"design"} and "position_gain" in found


# --- correlations ----------------------------------------------------------------------------------------------------------------------

TWO = {"mass": FITTED, "coulomb": '{value = "10 N", source = "fitted", deviation = "1 N"}'}


def test_correlations_need_numbers_with_a_deviation() -> None:
    pair = 'correlations = [["plant.mass", "friction.coulomb", -0.3]]'
    assert axis(**TWO, top=pair).correlations == (("plant.mass", "friction.coulomb", -0.3),)
    assert axis(top=pair).correlations == (), "the friction has lost its deviation"


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ('"plant.mass"', "list"),
        ('[["plant.mass", "friction.coulomb"]]', "item 1"),
        ('[["plant.mass", "plant.mass", 0.3]]', "different"),
        ('[["plant.mass", "friction.coulomb", 1.5]]', "from -1 to 1"),
        ('[["plant.mass", "friction.coulomb", true]]', "not a coefficient"),
        ('[["plant.mas", "friction.coulomb", 0.5]]', "'plant.mass'"),
        ('[["plant.mass", "friction.coulomb", 0.5], ["friction.coulomb", "plant.mass", 0.5]]', "listed twice"),
    ],
)
def test_other_correlations_are_refused(said: str, words: str) -> None:
    with pytest.raises(ScenarioError, match=words):
        axis(**TWO, top=f"correlations = {said}")


def test_contradictory_correlations_are_refused() -> None:
    three = (
        '[["plant.mass", "friction.coulomb", 0.9], ["plant.mass", "friction.viscous", 0.9], ["friction.coulomb", "friction.viscous", -0.9]]'
    )
    viscous = '\nviscous = {value = "1 N*s/m", source = "fitted", deviation = "1 %"}'
    with pytest.raises(ScenarioError, match="contradict"):
        axis(mass=FITTED, coulomb=TWO["coulomb"] + viscous, top=f"correlations = {three}")


BETWEEN = """
[machine]
name = "m"
servo_period = "1 ms"
axes = ["x", "y"]
correlations = {pairs}
[axes."*"]
correlations = [["plant.mass", "friction.coulomb", 0.5]]
plant = {{kind = "mass-damper", mass = {{value = "50 kg", source = "fitted", deviation = "1 kg"}}, force_constant = "1 N/A"}}
friction = {{kind = "coulomb", coulomb = {{value = "10 N", source = "fitted", deviation = "1 N"}}}}
"""


def test_correlations_between_axes_belong_to_the_machine(written: Callable[..., Path]) -> None:
    pairs = '[["x.plant.mass", "y.plant.mass", 0.4]]'
    found = load_machine(written(machine=BETWEEN.format(pairs=pairs)))
    assert found.correlations == (("x.plant.mass", "y.plant.mass", 0.4),)
    assert load_machine(written(machine=dump(found))).correlations == found.correlations
    other = '[axes.y.plant]\nmass = "40 kg"\n'
    assert load_machine(written(machine=BETWEEN.format(pairs=pairs) + other)).correlations == (), "one has lost its deviation"


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ('[["x.plant.mass", "x.friction.coulomb", 0.4]]', "axis x"),
        ('[["x.plant.mass", "z.plant.mass", 0.4]]', "no number 'z.plant.mass'"),
        ('[["x.plant.mas", "y.plant.mass", 0.4]]', "'x.plant.mass'"),
        ('[["x.plant.mass", "y.plant.mass", 0.9], ["x.friction.coulomb", "y.plant.mass", -0.9]]', "contradict"),
        ('"x.plant.mass"', "list"),
    ],
)
def test_other_correlations_between_axes_are_refused(said: str, words: str, written: Callable[..., Path]) -> None:
    with pytest.raises(ScenarioError, match=words):
        load_machine(written(machine=BETWEEN.format(pairs=said)))


# --- inheritance -----------------------------------------------------------------------------------------------------------------------


def scheme(change: str) -> Origin | None:
    found: Origin | None = (
        parse_scenario(SCENARIO.format(more=f"[schemes.s]\n{change}")).case("s").machine.axes[0].plant.origins.get("gain")
    )
    return found


def test_a_replaced_number_loses_its_origin() -> None:
    assert scheme('axes.x.plant.gain = "2.1 m/s^2/full_scale"') is None
    assert scheme('axes.x.plant.damping = "6 1/s"') == Origin("fitted", deviation=0.02)
    assert scheme('axes.x.plant.gain = {value = "2.1 m/s^2/full_scale", source = "assumed"}') == Origin("assumed")
    assert scheme('axes.x.plant = {kind = "mass-damper", mass = "1 kg", force_constant = "1 N/A"}') is None


def test_an_inherited_number_can_get_its_origin_later() -> None:
    stated = scheme('axes.x.plant.damping = {source = "assumed", deviation = "10 %"}')
    assert stated == Origin("fitted", deviation=0.02)
    case = parse_scenario(SCENARIO.format(more='[schemes.s]\naxes.x.plant.damping = {source = "assumed", deviation = "10 %"}')).case("s")
    assert case.machine.axes[0].plant.damping == 5.0
    assert case.machine.axes[0].plant.origins["damping"] == Origin("assumed", deviation=0.5)


def test_an_axis_with_another_plant_drops_its_correlations(written: Callable[..., Path]) -> None:
    text = AXIS.format(**TWO, top='correlations = [["plant.mass", "friction.coulomb", -0.3]]', more="")
    machine = '[machine]\nname = "m"\nservo_period = "1 ms"\naxes = ["x"]\n[axes.x]\nfile = "axis.toml"\n'
    assert len(load_machine(written(axis=text, machine=machine)).axes[0].correlations) == 1
    other = '[axes.x.plant]\nkind = "ball-screw"\nmass = "1 kg"\ninertia = "1 kg*cm^2"\nlead = "10 mm"\ntorque_constant = "1 N*m/A"\n'
    assert load_machine(written(axis=text, machine=machine + other)).axes[0].correlations == ()


# --- round trip ------------------------------------------------------------------------------------------------------------------------


def origins_of(found: Axis) -> dict[str, object]:
    parts = {name: part.origins for name in ("plant", "friction", "drive", "sensor", "limits", "error") if (part := getattr(found, name))}
    return {**parts, "axis": found.origins, "correlations": found.correlations}


def test_a_scenario_with_all_statements_reads_back() -> None:
    first = parse_scenario(SCENARIO.format(more='[schemes.s]\naxes.x.plant.gain = "2.1 m/s^2/full_scale"'))
    again = parse_scenario(dump(first))
    assert dump(again) == dump(first)
    for one, other in zip((first.base, *first.cases()), (again.base, *again.cases()), strict=True):
        assert one.machine.origins == other.machine.origins
        assert list(one.machine.origins) == ["servo_period", "squareness.x-y"]
        assert [origins_of(axis) for axis in one.machine.axes] == [origins_of(axis) for axis in other.machine.axes]
        assert one.controller.axes["x"].controller.origins == other.controller.axes["x"].controller.origins


@given(
    st.sampled_from([source for source in SOURCES if source not in ("design", "control")]),
    st.floats(min_value=1e-9, max_value=1e9),
    st.text(st.characters(categories=["L", "N", "P", "Zs"]), max_size=60),
    st.booleans(),
)
def test_any_statement_reads_back_the_same(source: str, deviation: float, words: str, ranged: bool) -> None:
    given_ = {"span": (20.0 - 1e-10 * deviation, 20.0 + deviation)} if ranged else {"deviation": deviation}
    words = words if words.isprintable() else ""
    first = axis(mass='"20 kg"')
    stated = Origin(source, reference=words, note=words, **given_)  # type: ignore[arg-type]
    first = Axis("x", first.plant.traced({"mass": stated}), friction=first.friction)
    assert parsed(dump(first)).plant.origins == {"mass": stated}


@pytest.mark.parametrize("name", [name for name in builtin_names() if name.startswith(("ghaffari/axis", "emps/axis", "gecer-ulu/stage"))])
def test_shipped_axes_give_the_origin_of_all_their_numbers(name: str) -> None:
    found = load_axis(f"builtin:{name}")
    for part in (found.plant, found.friction, found.sensor):
        given_ = {key for key, value in part.values().items() if not part.parameters[key].choices and value != part.parameters[key].default}
        assert given_ <= set(part.origins)
    assert origins_of(parsed(dump(found))) == origins_of(found)


def test_the_identity_of_a_machine_does_not_depend_on_provenance() -> None:
    """A learned table belongs to a machine, even if the origins of its numbers change later."""
    stated = parse_scenario(SCENARIO.format(more="")).base
    plain = unstated(stated.machine)
    assert "source" in dump(stated.machine) and "source" not in dump(plain)
    assert plain.axes[0].plant == stated.machine.axes[0].plant and plain.squareness == stated.machine.squareness
    assert "source" not in dump(unstated(stated.controller), plain)


def test_an_origin_is_checked_wherever_it_is_created() -> None:
    for wrong in ({"source": "rumour"}, {"source": "fitted", "deviation": 0.0}, {"source": "fitted", "span": (2.0, 1.0)}):
        with pytest.raises(ParameterError):
            Origin(**wrong)  # type: ignore[arg-type]
