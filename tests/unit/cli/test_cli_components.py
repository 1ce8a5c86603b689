"""`contourlab components`: complete, in the units of files, and readable by programs."""

import json
import math

import pytest

from contourlab.cli.main import main
from contourlab.components.registry import component
from contourlab.components.registry import components as known


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


def test_a_family_a_kind_and_both_choose(capsys):
    assert {entry["family"] for entry in listed(capsys, "plant")} == {"plant"}
    (entry,) = listed(capsys, "rigid-axis")
    assert (entry["family"], entry["kind"]) == ("plant", "rigid-axis")
    assert listed(capsys, "plant/rigid-axis") == [entry]


def test_the_overview_names_every_component(capsys):
    assert main(["components"]) == 0
    shown = capsys.readouterr().out
    for kind in known():
        assert kind.kind in shown


def row_of(capsys, kind, parameter):
    """Return the cells of one parameter's row in the table of one component."""
    assert main(["components", kind]) == 0
    rows = [[cell.strip() for cell in line.strip("│").split("│")] for line in capsys.readouterr().out.splitlines() if "│" in line]
    return next(row for row in rows if row[0] == parameter)


def test_numbers_stand_in_the_unit_that_files_use(capsys):
    breakaway = component("friction", "coulomb").parameters["stribeck_velocity"]
    assert (breakaway.unit, breakaway.display, breakaway.default) == ("m/s", "mm/s", 1e-3)
    _, unit, bounds, default, meaning, _ = row_of(capsys, "coulomb", "stribeck_velocity")
    assert (unit, bounds, default) == ("mm/s", "> 0", "1")
    assert meaning == breakaway.doc


def test_units_of_the_plant_are_words_and_required_is_said(capsys):
    _, unit, _, default, _, _ = row_of(capsys, "friction/coulomb", "coulomb")
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


def test_a_plugin_is_listed_with_its_brackets(plugin, capsys):
    assert main(["components", "cli-test-step", "--plugin", str(plugin)]) == 0
    shown = capsys.readouterr().out
    assert "A force [with brackets] that begins at once." in shown
    assert "its size [any]" in shown


def test_a_plugin_that_is_not_there_is_2(tmp_path, capsys):
    assert main(["components", "--plugin", str(tmp_path / "none.py")]) == 2
    assert "none.py" in capsys.readouterr().err
