"""Machine code belongs to the outer values that it was made from: no kind of value is ever stale."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import ModuleType
from typing import Any

import faulty_components as faults
import numpy as np
import pytest
from each import each
from outer_values import KINDS, REFUSED, VALUES, answers, imported, outputs, write

import contourlab as cl
from contourlab.components.conformance import check_component
from contourlab.engine import fused
from contourlab.engine.runner import make_group
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.engine.translate import step_graph
from contourlab.engine.translate.outer import Reads
from contourlab.errors import ComponentError, EngineError
from contourlab.native import llvm, store

SCRIPT = Path(__file__).parents[3] / "helpers" / "outer_values.py"


@pytest.fixture
def translations(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """An empty cache, and a list that grows by one with each translation."""
    counted: list[int] = []
    translate = step_graph.tick_graph

    def count(*args: Any, **named: Any) -> Any:
        counted.append(1)
        return translate(*args, **named)

    (tmp_path / "cache").mkdir()
    monkeypatch.setattr(store, "folder", lambda: tmp_path / "cache")
    monkeypatch.setattr(fused, "_loops", {})
    monkeypatch.setattr(step_graph, "tick_graph", count)
    return counted


def check(kind: str, first: list[Any], second: list[Any]) -> None:
    """Check the answers of two versions: each that of plain Python, or refused in both."""
    if kind in REFUSED:
        assert first[0] == second[0] == [True, True]
    else:
        assert first[0] == first[1] and second[0] == second[1]
    assert repr(first[1]) != repr(second[1])


@pytest.mark.parametrize("kind", KINDS)
def test_no_kind_of_value_is_stale_in_one_process(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, translations: list[int]
) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setitem(sys.modules, "library", ModuleType("library"))
    found = []
    for value in (*VALUES, *VALUES):
        write(tmp_path / "kind", kind, value)
        found.append(answers(tmp_path / "kind"))
    check(kind, *found[:2])
    assert found[2:] == found[:2]
    assert len(translations) == (4 if kind in REFUSED else 2)


def processes(cache: Path, *folders: Path) -> list[dict[str, list[Any]]]:
    """Return the answers of processes that run at once, one for each folder, with one cache."""
    env = {**os.environ, "CONTOURLAB_CACHE": str(cache)}
    words = [sys.executable, "-B", str(SCRIPT)]
    run = [subprocess.Popen([*words, str(folder)], stdout=subprocess.PIPE, text=True, env=env) for folder in folders]
    return [json.loads(process.communicate()[0]) for process in run]


@pytest.fixture(scope="module")
def in_processes(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, list[Any]]]:
    """The answers of three processes with one cache: of the first value, of the second, and again of the first."""
    place, found = tmp_path_factory.mktemp("kinds"), []
    for value in (*VALUES, VALUES[0]):
        for n, kind in enumerate(KINDS):
            write(place / "kinds" / f"{n:02d}", kind, value)
        (process,) = processes(place / "cache", place / "kinds")
        found.append({kind: process[f"{n:02d}"] for n, kind in enumerate(KINDS)})
        found[-1]["files"] = [len(list((place / "cache").glob("*.code")))]
    return found


@each("kind", list(KINDS))
def test_no_kind_of_value_is_stale_in_another_process(kind: str, in_processes: list[dict[str, list[Any]]]) -> None:
    first, second, third = (answers[kind] for answers in in_processes)
    check(kind, first, second)
    assert third == first
    assert in_processes[2]["files"] == in_processes[1]["files"]  # nothing was compiled again


@pytest.mark.slow
def test_processes_may_write_at_once(tmp_path: Path) -> None:
    kinds = ["list", "property", "function of a module", "other function of the same code"]
    for n, value in enumerate((*VALUES, *VALUES)):
        for kind in kinds:
            write(tmp_path / f"{n}" / kind, kind, value)
    found = processes(tmp_path / "cache", *(tmp_path / f"{n}" for n in range(4)))
    assert found[2:] == found[:2]
    for kind in kinds:
        check(kind, found[0][kind], found[1][kind])


def step_of(source: str, folder: Path) -> tuple[ModuleType, Step]:
    """Return a module with a function `step` without arguments that matter, and its step."""
    (folder / "made.py").write_text(source, encoding="utf-8")
    module = imported(folder / "made.py")
    return module, Step("made", module.step, outputs=(Port("y"),))


BRANCHES = """K, L, FLAG = [2.0], [3.0], 1.0
def step(par, x, inp, clock):
    return (), ((K[0] if FLAG > 0.0 else L[0]) + clock.k,)
"""


def test_what_is_read_may_depend_on_what_was_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, translations: list[int]) -> None:
    module, step = step_of(BRANCHES, tmp_path)
    changes = [(1.0, 2.0, 3.0), (-1.0, 2.0, 3.0), (-1.0, 7.0, 3.0), (-1.0, 2.0, 5.0), (1.0, 2.0, 5.0), (1.0, 4.0, 5.0)]
    for _ in range(2):
        monkeypatch.setattr(fused, "_loops", {})  # as in another process
        for module.FLAG, module.K[0], module.L[0] in changes:
            assert outputs(step, True).tolist() == [module.K[0] if module.FLAG > 0.0 else module.L[0]]
        assert len(translations) == 5
    module.K = "none"
    with pytest.raises(EngineError):
        outputs(step, True)


def test_a_function_whose_code_is_replaced_is_read_again(tmp_path: Path, translations: list[int]) -> None:
    """A notebook that reloads an edited module gives the functions that it has the new code."""
    source = "def gain(k):\n    return 2.0 + k\ndef step(par, x, inp, clock):\n    return (), (gain(clock.k),)\n"
    module, step = step_of(source, tmp_path)
    found = [outputs(step, True).tolist()]
    for name, old, new in (("gain", "2.0", "3.0"), ("step", "gain(clock.k)", "7.0 + gain(clock.k)")):
        source = source.replace(old, new)
        edited, _ = step_of(source, tmp_path)
        getattr(module, name).__code__ = getattr(edited, name).__code__
        found.append(outputs(step, True).tolist())
    assert found == [[2.0], [3.0], [10.0]] and outputs(step, False).tolist() == [10.0]


def test_a_run_from_a_snapshot_sees_a_change(tmp_path: Path, translations: list[int]) -> None:
    module, step = step_of(BRANCHES, tmp_path)
    group = make_group(Schedule((Node("node", step),), (), 1e-3, 1), 1, slice(0, 1), True)
    fresh, found = group.snapshot(), []
    for module.K in ([2.0], [3.0], [2.0]):
        group.restore(fresh)
        found.append(group.run(np.zeros((1, 0)), [0])[0, 0, 0])
    assert found == [2.0, 3.0, 2.0]


def test_a_value_that_changes_during_a_translation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, translations: list[int]) -> None:
    """The machine code belongs to the value that was folded, not to the one that is there when it is filed."""
    module, step = step_of(BRANCHES, tmp_path)
    compile_it = llvm.object_code

    def late(source: str) -> bytes:
        module.K[0] = 9.0
        return compile_it(source)

    monkeypatch.setattr(llvm, "object_code", late)
    assert outputs(step, True).tolist() == [2.0]
    monkeypatch.setattr(llvm, "object_code", compile_it)
    for module.K[0] in (9.0, 2.0):
        assert outputs(step, True).tolist() == [module.K[0]]
    assert len(translations) == 2


def test_threads_may_run_steps_of_the_same_code(translations: list[int]) -> None:
    def run(gain: float) -> float:
        return float(outputs(faults.Enclosed(gain=gain).make_step(), True)[0])

    gains = [1.0, 2.0, 3.0, 4.0] * 10
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(run, gains)) == [2.0 * gain for gain in gains]
    assert len(translations) == 4


@pytest.mark.parametrize("kind", [faults.Enclosed, faults.Shaped])
def test_a_step_that_closes_over_its_component_follows_it(kind: type[cl.Component], translations: list[int]) -> None:
    gains = (1e4, 2e4, 4e4)
    for gain in (*gains, *gains):
        step = kind(gain=gain).make_step()
        assert outputs(step, True).tolist() == outputs(step, False).tolist() == [2.0 * gain + (2.0 if kind is faults.Shaped else 0.0)]
    assert len(translations) == 3


def test_a_component_whose_machine_code_does_not_follow_it_is_found(monkeypatch: pytest.MonkeyPatch, translations: list[int]) -> None:
    assert "every parameter has an effect (2)" in check_component(faults.Shaped)
    read = Reads.read

    def without_a_note(reads: Reads, *what: Any) -> Any:
        length = len(reads.words)
        value = read(reads, *what)
        del reads.words[length:]
        return value

    monkeypatch.setattr(Reads, "read", without_a_note)
    monkeypatch.setattr(Reads, "again", lambda *_: None)
    monkeypatch.setattr(fused, "_loops", {})
    with pytest.raises(ComponentError, match=r"compiled form .*gain"):
        check_component(faults.Shaped)


AS_A_WHOLE = {
    "sum": "CONFIG + 1.0",
    "product": "inp.u * CONFIG",
    "sign": "-CONFIG",
    "float": "float(CONFIG)",
    "length": "1.0 * len(CONFIG)",
    "truth": "1.0 if CONFIG else 2.0",
    "items": "tuple(CONFIG)[0]",
    "comparison": "1.0 if CONFIG == Config() else 2.0",
    "order": "1.0 if CONFIG < CONFIG else 2.0",
    "choice": "1.0 if 2.0 in CONFIG else 2.0",
    "index": "CONFIG[CONFIG]",
    "method": "Named(1.0).twice",
    "operator": "(Sum(1.0) + Sum(2.0))[0]",
    "construction": "Twice(1.0)[0]",
    "field": "Field(1.0).a",
    "choice of pairs": "1.0 if (1, 2) in PAIRS else 2.0",
}
CONFIG = """import typing
import numpy as np
K = 2.0
PAIRS = {(1, 2)}
class Config:
    def give(self, *other): return K
    __add__ = __rmul__ = __neg__ = __float__ = __getitem__ = give
    def __len__(self): return int(K)
    def __bool__(self): return K > 1.0
    def __iter__(self): return iter((K,))
    def __eq__(self, other): return K > 1.0
    def __lt__(self, other): return K > 1.0
    def __contains__(self, other): return K > 1.0
    __hash__ = None
CONFIG = Config()
class Named(typing.NamedTuple):
    a: float
    @property
    def twice(self): return K * self.a
class Sum(Named):
    def __add__(self, other): return (K,)
class Twice(Named):
    def __new__(cls, a): return super().__new__(cls, K * a)
class Field(Named):
    a = property(lambda self: K)
"""


@pytest.mark.parametrize("form", AS_A_WHOLE)
def test_an_object_that_runs_code_of_its_own_is_refused_with_its_line(form: str, tmp_path: Path) -> None:
    _, step = step_of(f"{CONFIG}def step(par, x, inp, clock):\n    y = {AS_A_WHOLE[form]}\n    return (), (y,)\n", tmp_path)
    step = Step("made", step.function, inputs=(Port("u"),), outputs=(Port("y"),))
    outputs(step, False)  # plain Python runs it
    with pytest.raises(EngineError) as caught:
        outputs(step, True)
    assert (caught.value.file, caught.value.line) == (str(tmp_path / "made.py"), CONFIG.count("\n") + 2)
