"""Any value that a step can reach changes, in any order: machine code follows, with a warm cache as with an empty one."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from outer_values import imported, outputs

from contourlab.engine import fused
from contourlab.engine.step import Port, Step, ports
from contourlab.native import llvm, store

SOURCE = """
import enum
import types
from typing import NamedTuple

import numpy as np
from contourlab.primitives import *

K, FLAG = 1.0, 1.0
ROW, LIST, DEEP = (1.0, 2.0), [1.0, 2.0, 3.0], [1.0, (2.0, [3.0])]
TABLE = {"a": 1.0, "b": {"c": [1.0]}}
ARRAY = np.array([[1.0, 2.0], [3.0, 4.0]])
library = types.ModuleType("library")
library.K, library.sub = 1.0, types.SimpleNamespace(k=1.0)


class Mode(enum.Enum):
    A = 1.5
    B = 2.5


class Pair(NamedTuple):
    a: float
    b: float = 1.0


class Base:
    K = 1.0


class Derived(Base):
    @property
    def twice(self):
        return 2.0 * LIST[0]


def make(k):
    def scaled(x):
        return x * k

    def change(value):
        nonlocal k
        k = value

    return scaled, change


def with_default(x, k=1.0, *, m=1.0):
    return x * k + m


def one(x):
    return x + K


def two(x):
    return x - K


scaled, change = make(1.0)
other, change_other = make(1.0)
chosen, mode, thing, pair = one, Mode.A, Derived(), Pair(1.0)


def step(par, x, inp, clock):
    u, total = inp.u, 0.0
    for value in LIST:
        total = total + value * u
    branch = library.K if FLAG > 0.5 else TABLE["a"]
    if mode is Mode.A:
        branch = branch + ARRAY[1, 0]
    return (), (
        u * K, u * ROW[1], total, u * DEEP[1][1][0], u * TABLE["b"]["c"][0], u * ARRAY[0, 1], u * branch, u * library.sub.k,
        scaled(u) - other(u), with_default(u), chosen(u), u * mode.value, u * thing.K, u * thing.twice, Pair(u).b * pair.a,
    )
"""
STEP_LENGTH = 15
CHANGES: dict[str, Callable[[ModuleType, Any], None]] = {
    "global": lambda m, v: setattr(m, "K", v),
    "flag": lambda m, v: setattr(m, "FLAG", v),
    "tuple": lambda m, v: setattr(m, "ROW", (1.0, v)),
    "item of a list": lambda m, v: m.LIST.__setitem__(0, v),
    "length of a list": lambda m, v: setattr(m, "LIST", [2.0] * (1 + abs(int(v)))),
    "deep item": lambda m, v: m.DEEP[1][1].__setitem__(0, v),
    "item of a dict": lambda m, v: m.TABLE.__setitem__("a", v),
    "deep item of a dict": lambda m, v: m.TABLE["b"].__setitem__("c", [v]),
    "item of an array": lambda m, v: m.ARRAY.__setitem__((0, 1), v),
    "other item of an array": lambda m, v: m.ARRAY.__setitem__((1, 0), v),
    "another array": lambda m, v: setattr(m, "ARRAY", np.asfortranarray(m.ARRAY + v)),
    "attribute of a module": lambda m, v: setattr(m.library, "K", v),
    "attribute of names": lambda m, v: setattr(m.library.sub, "k", v),
    "other names": lambda m, v: setattr(m.library, "sub", type("Names", (), {"k": v})()),
    "variable around": lambda m, v: m.change(v),
    "variable around another": lambda m, v: m.change_other(v),
    "the same function": lambda m, v: setattr(m, "other", m.scaled),
    "default": lambda m, v: setattr(m.with_default, "__defaults__", (v,)),
    "default by name": lambda m, v: setattr(m.with_default, "__kwdefaults__", {"m": v}),
    "function": lambda m, v: setattr(m, "chosen", m.one if v > 0 else m.two),
    "member": lambda m, v: setattr(m, "mode", m.Mode.A if v > 0 else m.Mode.B),
    "attribute of a base class": lambda m, v: setattr(m.Base, "K", v),
    "attribute of an instance": lambda m, v: setattr(m.thing, "K", v),
    "default of a named tuple": lambda m, v: setattr(m.Pair.__new__, "__defaults__", (v,)),
    "named tuple": lambda m, v: setattr(m, "pair", m.Pair(v)),
}
NUMBERS = st.sampled_from([0.0, -0.0, 1, 1.0, True, 2.5, -3.0, np.float64(1.0), 1e-3])
OBJECT_CODE = cache(llvm.object_code)
"""Compiles the same translation once, wherever it comes from."""
DRAWN = st.lists(st.tuples(st.sampled_from(sorted(CHANGES)), NUMBERS), min_size=2, max_size=6)


@given(DRAWN)
@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_machine_code_follows_every_change(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch, drawn: list[tuple[str, Any]]
) -> None:
    place = tmp_path_factory.mktemp("step")
    file, warm = place / "made.py", place / "warm"
    file.write_text(SOURCE, encoding="utf-8")
    warm.mkdir()
    module = imported(file)
    step = Step("made", module.step, inputs=(Port("u"),), outputs=ports(*(f"y{n}" for n in range(STEP_LENGTH))))
    memory: dict[str, Any] = {}
    monkeypatch.setattr(llvm, "object_code", OBJECT_CODE)

    def run(folder: Path, loops: dict[str, Any]) -> bytes:
        monkeypatch.setattr(store, "folder", lambda: folder)
        monkeypatch.setattr(fused, "_loops", loops)
        return outputs(step, True).tobytes()  # type: ignore[no-any-return]

    for change, value in [("global", 1.0), *drawn]:
        CHANGES[change](module, value)
        in_process, in_another = run(warm, memory), run(warm, {})
        empty = run(tmp_path_factory.mktemp("empty"), {})
        assert in_process == in_another == empty, change
        np.testing.assert_allclose(np.frombuffer(empty), outputs(step, False), rtol=1e-15, atol=1e-15)
