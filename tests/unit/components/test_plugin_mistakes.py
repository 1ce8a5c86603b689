"""Each mistake of a stranger's plug-in is one line with file, line and class: an error of Python, and exit code 2 of the command."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from refusals import mentions
from strangers import SOUND, spoilt

import contourlab as cl
from contourlab.cli.main import main
from contourlab.components import registry
from contourlab.errors import ComponentError

CLASS, GAIN = "class Mine", "    gain: float"
ERROR = "        error = inp.reference - inp.position\n"
RETURN = "return (), (par.gain * error,)"
STEP = "    @staticmethod\n    def step(par, x, inp, clock):\n"


def uses(line: str) -> tuple[str, str, str]:
    """Return a controller whose step has a further first line."""
    return "controller", ERROR, f"        {line}\n{ERROR}"


def gives(value: str) -> tuple[str, str, str]:
    return "controller", RETURN, value


def extended(text: str) -> tuple[str, str, str]:
    return "controller", "", f"\n{text}\n"


# Pattern, old text, new text; the text in whose line the fault is ("" for none); what the message says.
IN_A_CLASS = [
    # what a class declares
    (("controller", '    family = "controller"\n', ""), CLASS, "family ''"),
    (("controller", '"controller"', '"regulator"'), CLASS, "plant, friction"),
    (("controller", '    kind = "mine"\n', ""), CLASS, "has no kind"),
    (("controller", '"mine"', "3"), CLASS, "kind = 3"),
    (("controller", '"mine"', '"my own"'), CLASS, "'my own'"),
    (("controller", '"mine"', '"pid"'), CLASS, "contourlab.components.controller.pid"),
    (("controller", '    """A proportional controller."""\n', ""), CLASS, "docstring"),
    (("controller", '    example = {"gain": 2.0}\n', ""), CLASS, "mine.gain = not given"),
    (("controller", '{"gain": 2.0}', '{"gian": 2.0}'), CLASS, "did you mean 'gain'"),
    (("controller", '{"gain": 2.0}', '{"gain": -2.0}'), CLASS, ">= 0 command/m"),
    (("controller", '{"gain": 2.0}', '{"gain": "2"}'), CLASS, "a number in command/m"),
    (("controller", '{"gain": 2.0}', '["gain"]'), CLASS, "not a dict"),
    (("controller", "class Mine", "from dataclasses import dataclass\n\n@dataclass\nclass Mine"), "@dataclass", "leave the decorator out"),
    (("controller", STEP, f"    def __init__(self, gain):\n        self.gain = gain\n\n{STEP}"), "self.gain = gain", "frozen"),
    # parameters
    (("controller", 'unit="{command}/m"', 'unit="{volt}/m"'), GAIN, "{command}"),
    (("controller", 'unit="{command}/m"', 'unit="furlongz"'), CLASS, "unknown unit"),
    (("controller", 'unit="{command}/m"', 'unit="m", display="s"'), CLASS, "display unit 's'"),
    (("controller", 'unit="{command}/m"', 'unit="A/furlongs"'), CLASS, "SI unit"),
    (("controller", " minimum=0.0,", ""), CLASS, "no bound"),
    (("controller", "minimum=0.0", 'minimum="0"'), GAIN, "a number"),
    (("controller", "minimum=0.0", "minimum=3.0, maximum=1.0"), GAIN, "at most the maximum"),
    (("controller", ', doc="gain"', ""), GAIN, "'doc'"),
    (("controller", 'doc="gain"', 'doc=""'), CLASS, "no doc"),
    (("controller", 'unit="{command}/m"', 'unit="rad/s", display="Hz"'), CLASS, "display unit"),
    (("controller", "param(unit", 'param(default="2", unit'), CLASS, "default of gain"),
    (("controller", "param(unit", "param(default=-2.0, unit"), CLASS, "default of gain"),
    (("controller", 'param(unit="{command}/m", minimum=0.0, doc="gain")', "2.0"), CLASS, "no parameter 'gain'"),
    (("controller", GAIN, "    values: float = param(default=1.0, minimum=0.0, doc='v')\n" + GAIN), CLASS, "attribute of Component"),
    (("controller", RETURN, "return (), (2.0 * error,)"), CLASS, "gain has no effect"),
    # ports
    (("controller", 'Port("position")', 'Port("positon")'), CLASS, "its inputs are: reference, "),
    (("controller", 'Port("command")', 'Port("force")'), CLASS, 'write outputs = (Port("command"),)'),
    (("controller", '(Port("command"),)', '(Port("command"))'), CLASS, "not a tuple"),
    (("controller", '(Port("reference"), Port("position"))', '("reference", "position")'), CLASS, "Port('reference')"),
    (("controller", 'Port("position")', 'Port("position"), Port("position")'), CLASS, "twice"),
    (("controller", 'Port("position")', 'Port("position", -1)'), CLASS, 'write Port("position")'),
    (("controller", "    inputs", '    states = (Port("last value"),)\n    inputs'), CLASS, "'last value'"),
    (("controller", "    inputs", '    ring = "applied"\n    inputs'), CLASS, "reference, position"),
    (("controller", "    inputs", '    tables = ("curve",)\n    inputs'), CLASS, "table_values"),
    # methods
    (("controller", "def step", "def steps"), CLASS, "step(par, x, inp, clock)"),
    (("controller", "(par, x, inp, clock)", "(par, x, inp)"), "@staticmethod", "as step(par, x, inp, clock)"),
    (("controller", "    @staticmethod\n", ""), "def step", "@staticmethod"),
    (("controller", "    inputs", '    derived = ("half",)\n    inputs'), CLASS, "half"),
    (("smooth", '    law = "smooth"\n', ""), CLASS, "sliding(par, speed)"),
    (("smooth", '"smooth"', '"magic"'), CLASS, "level(par, v)"),
    (("smooth", "def force", "def resistance"), CLASS, "force(par, v)"),
    (("smooth", "force(par, v)", "force(par)"), "@staticmethod", "as force(par, v)"),
    (("smooth", "return par.coefficient * v * fabs(v)", "par.coefficient * v"), "@staticmethod", "None, not a number"),
    (("smooth", "return par", "return -par"), CLASS, "adds energy"),
    (("sticking", "def held", "def hold"), CLASS, "held(par)"),
    (("sticking", "def sliding", "def slide"), CLASS, "sliding(par, speed)"),
    (("bristle", "def level", "def lever"), CLASS, "level(par, v)"),
    (("bristle", '    states = (Port("bristle"),)\n', ""), CLASS, "Port('bristle')"),
    (("bristle", "stiffness", "rigidity"), CLASS, "'stiffness'"),
    (("plant", "def drive_force", "def push"), CLASS, "drive_force(par, command)"),
    (("plant", '"mobility_value"', '"mobilities_value"'), CLASS, "mobility(par)"),
    (("plant", "(SingleMass)", "(Component)"), CLASS, "family ''"),
    (("plant", "1.0 / total", "max(1.0, 1.0 / total)"), "def derive", "numpy"),
    (("learning", "def revised", "def revise"), CLASS, "revised(self, table, trial, problem)"),
    (("learning", "trial.tracking_error", "trial.tracking_error[:-1]"), "return table", "ValueError"),
    (("learning", '    without_effect = ("target",)\n', ""), CLASS, "`without_effect`"),
    (("supervisor", "(Supervisor)", "(Component)"), CLASS, "family ''"),
    (("supervisor", '(Supervisor):\n    """F', '(Component):\n    family = "supervisor"\n    """F'), CLASS, ".Supervisor"),
    (("plant", '(SingleMass):\n    """A', '(Component):\n    family = "plant"\n    """A'), CLASS, "SingleMass"),
    (("learning", '(LearningLaw):\n    """L', '(Component):\n    family = "learning"\n    """L'), CLASS, "LearningLaw"),
    (("supervisor", "    n_controller = 2\n", ""), CLASS, "n_controller = 2"),
    (("supervisor", '    reasons = ("the axis is fast", "the axis is slow")\n', ""), CLASS, "reasons = ("),
    # results of a step
    (gives("return (1.0,), (par.gain * error,)"), "@staticmethod", "1 states, but declares 0"),
    (gives("return (), (par.gain * error, 1.0)"), "@staticmethod", "2 outputs, but declares 1"),
    (gives("return (), (par.gain * error)"), "@staticmethod", "(value,)"),
    (gives("return par.gain * error"), "@staticmethod", "return x_next, out"),
    (gives("out = par.gain * error"), "@staticmethod", "returns nothing"),
    (gives('return "full"'), "@staticmethod", "'full'"),
    (gives("return [], [par.gain * error]"), "return", "a list: use a tuple"),
    (gives("return (), (par.gain / (error - error),)"), "return", "ZeroDivisionError"),
    (gives("return (), (par.gain * sqrt(error),)"), CLASS, "not finite"),
    (gives('return (), (par.gain * error * float("nan"),)'), CLASS, "not finite"),
    # the language of steps
    (gives("return (), (sum((par.gain * error, 0.0)),)"), "return", "dot"),
    (gives("return (), (sum((1.0, 2.0)) * par.gain * error,)"), "return", "dot"),
    (gives("return (), (sorted((par.gain * error, 0.0))[0],)"), "return", "sorted"),
    (gives("return (), (max(error, 0.0, key=abs) * par.gain,)"), "return", "called so"),
    (gives("return (), (round(par.gain * error, 2),)"), "return", "called so"),
    (gives("return (), (sum((par.gain, error)),)"), "return", "dot"),
    (gives("return (), (par.gain * ~(error > 0.0),)"), "return", "~"),
    (gives("return (), (par.gain * err,)"), "return", "'err'"),
    (gives("return (), (par.Gain * error,)"), "return", "par has: gain"),
    (gives("return (), (par.gain * inp.velocity,)"), "return", "inp has: reference, position"),
    (uses("import math"), "import math", "import"),
    (uses("print(inp.position)"), "print", "leave it out"),
    (uses('name = f"{inp.position}"'), 'f"', "f-string"),
    (uses("global SUM"), "global", "global"),
    (uses("assert inp.position < 1.0"), "assert", "assert"),
    (uses("try:\n            y = 1.0\n        except ValueError:\n            y = 0.0"), "try", "try"),
    (uses('d = {"a": 1.0}'), "{", "dict"),
    (uses("par.gain = 3.0"), "par.gain = ", "par.gain"),
]
"""Faults whose message names the class."""

OF_A_FILE = [
    (("controller", "class Mine(Component):", "class Mine(Component)"), CLASS, "SyntaxError"),
    (("controller", "        return", "\treturn"), "\treturn", "TabError"),
    (("controller", '"""A plug-in."""', "import no_such_package"), "import no_such", "ModuleNotFoundError"),
    (("controller", "import Component", "import Komponent"), "Komponent", "ImportError"),
    (extended("def f():\n    return 1 / 0\n\nf()"), "1 / 0", "ZeroDivisionError"),
    (extended("raise SystemExit"), "raise", "SystemExit"),
    (extended('raise RuntimeError("two\\nlines")'), "raise", "RuntimeError: two lines"),
    (("controller", "(Component)", ""), "", "subclass of Component"),
]
"""Faults of a file that are in no class."""


@pytest.fixture(autouse=True)
def fresh(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    """Work in an empty folder, and forget the plug-ins at the end."""
    monkeypatch.setattr(registry, "_plugins", {})
    monkeypatch.chdir(tmp_path)
    yield
    sys.modules.pop(str(tmp_path / "mine.py").replace(".", "_"), None)


def said_of(text: str | bytes, capsys: pytest.CaptureFixture[str]) -> str:
    """Return what both loader and command say of a plug-in, which must be the same line."""
    Path("mine.py").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ComponentError) as caught:
        for kind in cl.load_plugin("mine.py"):
            cl.check_component(kind)
    assert main(["components", "--plugin", "mine.py"]) == 2
    out, err = capsys.readouterr()
    assert (out, err) == ("", f"contourlab: {caught.value}\n")
    assert err.count("\n") == 1 and str(Path.cwd()) not in err
    return str(caught.value)


def place(text: str, at: str) -> str:
    """Return file and line of the last line that contains a text."""
    return f"mine.py:{text[: text.rindex(at)].count(chr(10)) + 1}: " if at else "mine.py: "


@pytest.mark.parametrize("pattern", SOUND)
def test_a_sound_plugin_passes(pattern: str) -> None:
    Path("mine.py").write_text(spoilt(pattern), encoding="utf-8")
    (kind,) = cl.load_plugin("mine.py")
    assert len(cl.check_component(kind)) > 1


@pytest.mark.parametrize(("how", "at", "words"), IN_A_CLASS, ids=lambda value: None if isinstance(value, tuple) else "")
def test_a_mistake_in_a_class_names_file_line_and_class(
    how: tuple[str, str, str], at: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = spoilt(*how)
    said = said_of(text, capsys)
    assert said.startswith(f"{place(text, at)}Mine: ") and words in said, said


@pytest.mark.parametrize(("how", "at", "words"), OF_A_FILE, ids=lambda value: None if isinstance(value, tuple) else "")
def test_a_file_that_cannot_be_imported_names_its_line(
    how: tuple[str, str, str], at: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = spoilt(*how)
    said = said_of(text, capsys)
    assert said.startswith(place(text, at)) and words in said, said


@pytest.mark.parametrize("data", [spoilt("controller", "proportional", "prüf").encode("latin-1"), spoilt("controller").encode("utf-16")])
def test_a_file_in_another_encoding_is_told_to_be_saved_as_utf_8(data: bytes, capsys: pytest.CaptureFixture[str]) -> None:
    assert "UTF-8" in said_of(data, capsys)


def test_two_classes_of_one_kind_name_each_other(capsys: pytest.CaptureFixture[str]) -> None:
    second = SOUND["controller"].replace("class Mine", "class Other")
    text = spoilt("controller", "", second)
    said = said_of(text, capsys)
    assert said.startswith(place(text, "class Other")) and mentions([said], "Mine", "mine.py")


def test_a_function_beside_the_class_is_named_with_the_class(capsys: pytest.CaptureFixture[str]) -> None:
    text = spoilt("controller", RETURN, "return (), (half(par.gain * error),)") + "\n\ndef half(v):\n    return sum((v, 0.5 * v))\n"
    assert said_of(text, capsys).startswith(f"{place(text, 'sum(')}Mine: half: sum cannot be called")


# --- in a run


def run_with(text: str, slot: str, capsys: pytest.CaptureFixture[str]) -> str:
    """Return what a run with a plug-in says, which must fail with 2 and one line."""
    Path("mine.py").write_text(text, encoding="utf-8")
    scenario = f'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\ncontour = {{name = "circle", radius = "5 mm"}}\n{slot}\n'
    Path("circle.toml").write_text(f'{scenario}[feed]\nfeedrate = "500 mm/min"\n', encoding="utf-8")
    code = main(["run", "circle.toml", "--plugin", "mine.py", "--out", "results"])
    said = capsys.readouterr().err
    assert code == 2 and said.count("\n") == 1, said
    return said.removeprefix("contourlab: ")


DERIVE = "    def derive(self, par, dt):\n        return "
FRICTION = 'axes.x.friction = {kind = "mine", coefficient = "40 N*s^2/m^2"}'


@pytest.fixture
def unloaded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("contourlab.scenario.load._loaded", set())


@pytest.mark.parametrize(
    ("how", "slot", "at", "words"),
    [
        (("smooth", "def force", "def resistance"), FRICTION, CLASS, "Mine: "),
        (
            ("smooth", "return par.coefficient * v * fabs(v)", "return sum((v, 0.0)) * par.coefficient"),
            FRICTION,
            "return",
            "Mine.force: sum",
        ),
        (("smooth", "    @static", f"{DERIVE}par.c\n\n    @static"), FRICTION, "par.c\n", "Mine.derive: AttributeError"),
        (("smooth", "    @static", f"{DERIVE}1.0\n\n    @static"), FRICTION, "def derive", "Mine: derive returns 1.0"),
        (("smooth", "class Mine(Component):", "class Mine(Component)"), FRICTION, CLASS, "SyntaxError"),
    ],
)
@pytest.mark.usefixtures("unloaded")
def test_a_run_names_file_line_and_class(
    how: tuple[str, str, str], slot: str, at: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = spoilt(*how)
    said = run_with(text, slot, capsys)
    assert said.startswith(place(text, at)) and words in said, said
