"""Components from outside: loose files and installed packages."""

from __future__ import annotations

import importlib.metadata
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
from refusals import refuses

import contourlab as cl
from contourlab.cli.main import main
from contourlab.components import registry
from contourlab.components.contract import Component
from contourlab.errors import ComponentError

ROOT = Path(__file__).parents[3]
TEMPLATE = '''
"""A plug-in."""
from contourlab import Component, Port, param

class {name}(Component):
    """A force that is always there."""
    family = "disturbance"
    kind = "{kind}"
    example = {{"force": 2.0}}
    unbounded = ("force",)
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    force: float = param(default={default}, unit="{{force}}", doc="its size")

    @staticmethod
    def step(par, x, inp, clock):
        return (), (par.force,)
'''


def source(kind: str, name: str = "Push", default: float = 1.0) -> str:
    return TEMPLATE.format(kind=kind, name=name, default=default)


@pytest.fixture(autouse=True)
def fresh(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Forget plug-ins and entry points at the end of each test."""
    monkeypatch.setattr(registry, "_plugins", {})
    yield
    registry._built_in.cache_clear()
    for name in [name for name in sys.modules if name.endswith("_py")]:  # a plug-in is the module of its file's name
        del sys.modules[name]


def write(folder: Path, text: str, name: str = "push.py") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


# --- loose files ---------------------------------------------------------------------------------------------------------------------


def test_a_loaded_file_is_registered(tmp_path: Path) -> None:
    with pytest.raises(ComponentError, match="disturbance 'push'"):
        registry.component("disturbance", "push")
    (kind,) = cl.load_plugin(write(tmp_path, source("push")))
    assert registry.component("disturbance", "push") is kind
    assert kind in registry.components("disturbance") and kind in registry.components()
    cl.check_component(kind, jit=False)


def test_classes_imported_by_a_file_are_not_its_own(tmp_path: Path) -> None:
    text = "from contourlab.components.drive.saturation import Saturation\n" + source("push")
    assert [kind.kind for kind in cl.load_plugin(write(tmp_path, text))] == ["push"]


def test_an_edited_file_replaces_its_old_version(tmp_path: Path) -> None:
    file = write(tmp_path, source("push"))
    (old,) = cl.load_plugin(file)
    write(tmp_path, source("push", default=3.0) + source("pull", "Pull"))
    kinds = cl.load_plugin(str(file))
    assert {kind.kind for kind in kinds} == {"push", "pull"}
    found = registry.component("disturbance", "push")
    assert found is not old and found().force == 3.0  # type: ignore[attr-defined]
    write(tmp_path, source("pull", "Pull"))
    cl.load_plugin(file)
    assert "push" not in {kind.kind for kind in registry.components()}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("class Push(\n", r"push\.py:1: .*SyntaxError"),
        ("import no_such_package\n", "ModuleNotFoundError: .*'no_such_package'"),
        ("raise KeyError('x')\n", "imported: KeyError"),
        ("x = 1\n", "no component: .*subclass"),
        ("from contourlab.components.drive.saturation import Saturation\n", "no component"),
        (source("push").replace('kind = "push"', ""), "Push: has no kind"),
        (source("push").replace('"disturbance"', '"gearbox"'), "'gearbox'.* plant, friction"),
        (source("constant"), "disturbance 'constant' already"),
        (source("push") + source("push", "Second"), "disturbance 'push' already"),
        ("", "no component"),
        (source("push").replace("{force}", "{for#e}"), "'{for#e}'"),
        (source("push").replace("{force}", "{force}*s/}"), "unit"),
    ],
)
def test_a_bad_file_is_refused_with_advice(tmp_path: Path, text: str, said: str) -> None:
    file = write(tmp_path, text)
    before = registry.components()
    with pytest.raises(ComponentError, match=said) as caught:
        cl.load_plugin(file)
    assert str(file) in str(caught.value)
    assert registry.components() == before


def test_nothing_of_a_bad_file_is_kept(tmp_path: Path) -> None:
    with pytest.raises(ComponentError, match="'constant' already"):
        cl.load_plugin(write(tmp_path, source("push") + source("constant", "Second")))
    assert "push" not in {kind.kind for kind in registry.components()}
    cl.load_plugin(write(tmp_path, source("push"), "other.py"))


def test_two_files_with_the_same_kind_are_refused(tmp_path: Path) -> None:
    cl.load_plugin(write(tmp_path, source("push")))
    with pytest.raises(ComponentError, match="'push' already"):
        cl.load_plugin(write(tmp_path, source("push"), "other.py"))


def test_two_files_of_the_same_name_coexist(tmp_path: Path) -> None:
    for kind in ("push", "pull"):
        (tmp_path / kind).mkdir()
        cl.load_plugin(write(tmp_path / kind, source(kind)))
    assert {"push", "pull"} <= {kind.kind for kind in registry.components("disturbance")}


@pytest.mark.parametrize("name", ["none.py", ".", "notes.txt", "no/such/folder/drag.py"])
def test_a_file_that_is_not_python_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "notes.txt").write_text(source("push"))
    with pytest.raises(ComponentError, match="Python file"):
        cl.load_plugin(tmp_path / name)


# --- the example of the guide --------------------------------------------------------------------------------------------------------


def blocks(language: str) -> list[str]:
    guide = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", guide, re.DOTALL)


@pytest.fixture
def drag(tmp_path: Path) -> Path:
    return write(tmp_path, next(block for block in blocks("python") if "class Drag(Component)" in block), "drag.py")


def test_the_plant_in_the_guide_keeps_the_contract(tmp_path: Path) -> None:
    (kind,) = cl.load_plugin(write(tmp_path, next(block for block in blocks("python") if "class Covered(Plant)" in block), "covered.py"))
    assert "linear model agrees with the step" in cl.check_component(kind)


@pytest.mark.slow
def test_the_command_in_the_guide_works(drag: Path) -> None:
    line = next(line for block in blocks("sh") for line in block.splitlines() if "--plugin" in line)
    program, *arguments = line.split()
    assert program == "contourlab"
    command = [sys.executable, "-m", "contourlab.cli.main", *arguments]
    if (script := Path(sys.executable).with_name("contourlab")).is_file():
        command = [str(script), *arguments]
    done = subprocess.run(command, cwd=drag.parent, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert all(word in done.stdout for word in ("friction/drag", "Resistance", "coefficient"))


@pytest.mark.slow
def test_the_code_in_the_guide_works(drag: Path) -> None:
    lines = next(block for block in blocks("python") if "load_plugin" in block)
    done = subprocess.run([sys.executable, "-c", lines], cwd=drag.parent, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr


def test_the_drag_in_the_guide_slows_an_axis_as_the_closed_form_says(drag: Path) -> None:
    """m v' = -c v^2 has the solution v = v0/(1 + c v0 t/m)."""
    from component_rig import make, run_alone

    (kind,) = cl.load_plugin(drag)
    mass, c, v0, n = 8.0, 40.0, 0.5, 400
    plant = make("plant", "mass-damper", mass=mass, force_constant=1.0)
    out = run_alone(plant, {"command": [0.0] * n}, friction=kind(coefficient=c), initial={"velocity": v0})
    t = 1e-3 * n
    assert out["velocity"][-1] == pytest.approx(v0 / (1.0 + c * v0 * t / mass), rel=1e-11)


# --- entry points --------------------------------------------------------------------------------------------------------------------


def offer(monkeypatch: pytest.MonkeyPatch, **values: object) -> None:
    """Simulate installed packages: one entry point per name; an exception is raised on loading."""

    class Entry:
        def __init__(self, name: str, thing: object) -> None:
            self.name, self.value, self.thing = name, f"stranger.{name}", thing

        def load(self) -> object:
            if isinstance(self.thing, Exception):
                raise self.thing
            return self.thing

    entries = [Entry(name, thing) for name, thing in values.items()]
    monkeypatch.setattr(importlib.metadata, "entry_points", lambda *, group: entries if group == "contourlab.components" else [])
    registry._built_in.cache_clear()


def strangers() -> type[Component]:
    scope: dict[str, object] = {"__name__": "stranger"}
    exec(source("strange-push"), scope)
    return scope["Push"]  # type: ignore[return-value]


def test_a_class_from_an_entry_point_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = strangers()
    offer(monkeypatch, push=kind)
    assert registry.component("disturbance", "strange-push") is kind
    assert registry.component("plant", "rigid-axis").kind == "rigid-axis"


def test_a_module_from_an_entry_point_brings_all_its_components(monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType("stranger")
    module.Push = strangers()  # type: ignore[attr-defined]
    module.Component = Component  # type: ignore[attr-defined]
    offer(monkeypatch, push=module)
    assert registry.component("disturbance", "strange-push") is module.Push  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("thing", "said"),
    [
        (ImportError("no such wheel"), r"entry point push = stranger\.push .*such wheel"),
        (RuntimeError("boom"), "loaded: .*boom"),
        (3, "push: 3 .*not a component"),
        (Component, "not a component"),
        (ModuleType("empty"), "push: .*no component"),
    ],
)
def test_an_entry_point_without_a_component_is_never_skipped(monkeypatch: pytest.MonkeyPatch, thing: object, said: str) -> None:
    offer(monkeypatch, push=thing)
    with pytest.raises(ComponentError, match=said):
        registry.components()


def test_an_entry_point_cannot_replace_a_built_in_component(monkeypatch: pytest.MonkeyPatch) -> None:
    scope: dict[str, object] = {"__name__": "stranger"}
    exec(source("constant"), scope)
    offer(monkeypatch, push=scope["Push"])
    with pytest.raises(ComponentError, match=r"entry point push: .*'constant'"):
        registry.components()


def test_unknown_families_and_kinds_are_answered_with_the_valid_ones() -> None:
    with pytest.raises(ComponentError, match=r"'gearbox'.*\bplant\b"):
        registry.components("gearbox")
    plants = ", ".join(kind.kind for kind in registry.components("plant"))
    with pytest.raises(ComponentError, match=rf"'lathe'.* {plants}, .*--plugin"):
        registry.component("plant", "lathe")


@pytest.mark.parametrize(("family", "kind", "meant"), [("plant", "rigid axis", "rigid-axis"), ("controller", "p-pi", "cascade")])
def test_a_kind_by_another_name_is_answered_with_ours(family: str, kind: str, meant: str, capsys) -> None:
    with refuses(ComponentError, meant):
        registry.component(family, kind)
    assert main(["components", f"{family}/{kind}"]) == 2
    assert meant in capsys.readouterr().err
