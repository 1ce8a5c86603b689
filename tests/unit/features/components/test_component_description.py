"""`contourlab components`: complete, in the units of files, and readable by programs."""

import json
import math

import pytest

from contourlab.cli.main import main
from contourlab.components.registry import component
from contourlab.components.registry import components as known
from contourlab.features.components.description import _default, _range, _unit


def listed(capsys, *arguments):
    assert main(["components", *arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_json_lists_every_component_with_every_parameter(capsys):
    found = {(entry["family"], entry["kind"]): entry for entry in listed(capsys)}
    assert set(found) == {(kind.family, kind.kind) for kind in known()}
    for kind in known():
        entry = found[kind.family, kind.kind]
        assert [parameter["name"] for parameter in entry["parameters"]] == list(kind.parameters)
        assert entry["doc"]
        for shown, parameter in zip(entry["parameters"], kind.parameters.values(), strict=True):
            assert shown["minimum"] == (parameter.minimum if math.isfinite(parameter.minimum) else None)
            assert shown["doc"] == parameter.doc


def test_family_and_kind_select_components(capsys):
    assert {entry["family"] for entry in listed(capsys, "plant")} == {"plant"}
    (entry,) = listed(capsys, "rigid-axis")
    assert (entry["family"], entry["kind"]) == ("plant", "rigid-axis")
    assert listed(capsys, "plant/rigid-axis") == [entry]


def test_the_overview_names_every_component(capsys):
    assert main(["components"]) == 0
    shown = capsys.readouterr().out
    for kind in known():
        assert kind.kind in shown


def cells(kind, parameter):
    """Return unit, bounds and default of one parameter as the table shows them."""
    found = component(*kind).parameters[parameter]
    return _unit(found), _range(found), _default(found)


def test_numbers_are_in_the_unit_of_files(capsys):
    breakaway = component("friction", "coulomb").parameters["stribeck_velocity"]
    assert (breakaway.unit, breakaway.display, breakaway.default) == ("m/s", "mm/s", 1e-3)
    assert cells(("friction", "coulomb"), "stribeck_velocity") == ("mm/s", "> 0", "1")
    assert main(["components", "coulomb"]) == 0
    assert "stribeck_velocity" in capsys.readouterr().out


def test_units_of_the_plant_are_words_and_a_missing_default_is_required():
    unit, _, default = cells(("friction", "coulomb"), "coulomb")
    assert (unit, default) == ("force", "required")


PLUGIN = '''
from contourlab.components.contract import Component, Port, param

class Step(Component):
    """A force [with brackets] that begins at once."""

    family = "disturbance"
    kind = "cli-test-step"
    example = {"force": 1.0}
    unbounded = ("force",)
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    force: float = param(unit="{force}", doc="its size [any]")

    @staticmethod
    def step(par, x, inp, clock):
        return (), (par.force,)
'''


@pytest.fixture
def plugin(tmp_path, monkeypatch):
    from contourlab.components import registry

    monkeypatch.setattr(registry, "_plugins", {})
    file = tmp_path / "step.py"
    file.write_text(PLUGIN, encoding="utf-8")
    return file


def test_a_plugin_is_listed_with_literal_brackets(plugin, capsys):
    assert main(["components", "cli-test-step", "--plugin", str(plugin)]) == 0
    shown = capsys.readouterr().out
    assert "[with brackets]" in shown
    assert "[any]" in shown


def test_a_missing_plugin_exits_with_2(tmp_path, capsys):
    assert main(["components", "--plugin", str(tmp_path / "none.py")]) == 2
    assert "none.py" in capsys.readouterr().err
