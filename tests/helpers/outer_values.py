"""Steps that read a value from outside, in every way that Python has; and the value of each, compiled and in plain Python.

As a script: ``python outer_values.py FOLDER`` runs each step of a folder and prints the values as JSON.
"""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest.mock import patch

import numpy as np

from contourlab.engine.runner import make_group
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.errors import EngineError

CALL = "helper(par.force)"
HELPER = "def helper(x, {}k=VALUE):\n    return x * k\n"
INNER = "def helper(x):\n    return x * VALUE\n"
MAKER = "def make(k):\n    def made(x):\n        return x * {}\n    return made\n"
DATA = "from dataclasses import dataclass\n@dataclass\nclass Config:\n    k: float = 0.0\n"
NAMED = "from typing import NamedTuple\nclass Named(NamedTuple):\n    a: float\n"
NUMPY = "import numpy as np\n"
ENUM = "import enum\nclass Mode(enum.{}):\n    A = VALUE\n    B = 7.0\n"
KINDS: dict[str, tuple[str, ...]] = {
    "literal in the step": ("par.force * VALUE",),
    "float": ("par.force * K", "K = VALUE"),
    "truth value or number": ("par.force * (5.0 if K is True else 7.0)", "K = True if VALUE > 2.0 else 1"),
    "sign of zero": ("copysign(par.force, K)", "K = 0.0 * (2.5 - VALUE)"),
    "tuple": ("par.force * K[0]", "K = (VALUE, 1.0)"),
    "list": ("par.force * K[0]", "K = [VALUE, 1.0]"),
    "list in a list": ("par.force * K[1][0]", "K = [1.0, [VALUE]]"),
    "dict": ("par.force * K['k']", "K = {'k': VALUE}"),
    "dict of a tuple": ("par.force * K[1, 'k']", "K = {(1, 'k'): VALUE}"),
    "ordered dict": ("par.force * K['k']", "from collections import OrderedDict\nK = OrderedDict(k=VALUE)"),
    "read-only dict": ("par.force * K['k']", "from types import MappingProxyType\nK = MappingProxyType({'k': VALUE})"),
    "set": ("par.force * (5.0 if 2.0 in S else 7.0)", "S = {VALUE}"),
    "range": ("par.force * len(K)", "K = range(int(VALUE))"),
    "slice": ("par.force * len((1.0, 2.0, 3.0)[S])", "S = slice(0, int(VALUE))"),
    "text": ("par.force * len(S)", "S = 'a' * int(VALUE)"),
    "array": ("par.force * K[0]", NUMPY + "K = np.array([VALUE, 1.0])"),
    "array of two axes": ("par.force * K[1, 0]", NUMPY + "K = np.array([[1.0], [VALUE]])"),
    "shape of an array": ("par.force * K.shape[0]", NUMPY + "K = np.zeros(int(VALUE))"),
    "array of objects": ("par.force * K[0]", NUMPY + "K = np.array([VALUE, 'a'], dtype=object)"),
    "number of an array": ("par.force * K", NUMPY + "K = np.float64(VALUE)"),
    "number of single precision": ("par.force * float(K)", NUMPY + "K = np.float32(VALUE) / np.float32(3)"),
    "array in a tuple": ("par.force * K[0][0]", NUMPY + "K = (np.array([VALUE]),)"),
    "array in a tuple, tenth digit": ("par.force * K[0][0]", NUMPY + "K = (np.array([1.0 + 1e-10 * VALUE]),)"),
    "attribute of a module": ("par.force * library.K", "import library", "pass", "K = VALUE"),
    "name from a module": ("par.force * K", "from library import K", "pass", "K = VALUE"),
    "function of a module": ("library.helper(par.force)", "import library", "pass", INNER),
    "function from a module": (CALL, "from library import helper", "pass", INNER),
    "name in a module of a function": (CALL, "from library import helper", "pass", "K = VALUE\ndef helper(x):\n    return x * K\n"),
    "class in a module": ("par.force * library.Sub.K", "import library", "pass", "class Sub:\n    K = VALUE\n"),
    "function in place of a primitive": (
        "names.tanh(par.force)",
        "import types\nnames = types.SimpleNamespace()\n" + INNER + "names.tanh = helper",
    ),
    "attribute of the class": ("par.force * Mine.K", "", "K = VALUE"),
    "list of the class": ("par.force * Mine.K[0]", "", "K = [VALUE]"),
    "attribute of a base class": ("par.force * Derived.K", "class Base:\n    K = VALUE\nclass Derived(Base):\n    pass\n"),
    "static method": ("Mine.helper(par.force)", "", "@staticmethod\n    def helper(x): return x * VALUE"),
    "static method of another class": ("H.f(par.force)", "class H:\n    f = staticmethod(lambda x: x * VALUE)\n"),
    "default": (CALL, HELPER.format("")),
    "default that is a list": ("helper(par.force)[0] * 1.0", "def helper(x, k=[VALUE]):\n    return (x * k[0],)\n"),
    "default by name": (CALL, HELPER.format("*, ")),
    "default of a lambda": (CALL, "helper = lambda x, k=VALUE: x * k"),
    "default of the step": ("par.force * k", "", "pass", "", ", k=VALUE"),
    "default of a function in the step": ("(lambda x, k=K: x * k)(par.force)", "K = VALUE"),
    "instance of a data class": ("par.force * CONFIG.k", DATA + "CONFIG = Config(VALUE)"),
    "default of a data class": ("par.force * CONFIG.k", DATA.replace("0.0", "VALUE") + "CONFIG = Config()"),
    "instance in an instance": ("par.force * CONFIG.k.k", DATA + "CONFIG = Config(Config(VALUE))"),
    "instances in a list": ("par.force * CONFIGS[1].k", DATA + "CONFIGS = [Config(1.0), Config(VALUE)]"),
    "names": ("par.force * CONFIG.k", "from types import SimpleNamespace\nCONFIG = SimpleNamespace(k=VALUE)"),
    "property": ("par.force * o.k", "class O:\n    k = property(lambda self: VALUE)\no = O()"),
    "property of another value": ("par.force * o.k", "HERE = [VALUE]\nclass O:\n    k = property(lambda self: HERE[0])\no = O()"),
    "item of an instance": ("par.force * o['k']", "class O:\n    def __getitem__(self, i):\n        return VALUE\no = O()"),
    "member": ("par.force * Mode.A.value", ENUM.format("Enum")),
    "member that is chosen": (
        "par.force * (5.0 if NOW is Mode.A else 7.0)",
        ENUM.format("Enum") + "NOW = Mode.A if VALUE > 2.0 else Mode.B",
    ),
    "member that is equal": (
        "par.force * (5.0 if NOW == Mode.A else 7.0)",
        ENUM.format("Enum") + "NOW = Mode(VALUE if VALUE > 2.0 else 7.0)",
    ),
    "member of numbers": (
        "par.force * (5.0 if NOW == 2 else 7.0)",
        "import enum\nclass Mode(enum.IntEnum):\n    A = 2\n    B = 3\nNOW = Mode(int(VALUE))",
    ),
    "member as a key": ("par.force * K[Mode.A]", ENUM.format("Enum") + "K = {Mode.B: 1.0, Mode.A: VALUE}"),
    "named tuple": ("par.force * P.a", NAMED + "P = Named(VALUE)"),
    "default of a named tuple": ("Named(par.force).k", NAMED + "    k: float = VALUE\n"),
    "fields of a named tuple": (
        "P(par.force, 7.0).a",
        "from collections import namedtuple\nP = namedtuple('P', 'a b' if VALUE > 2.0 else 'b a')",
    ),
    "function in a tuple": ("F[0](par.force)", INNER + "F = (helper,)"),
    "function in a dict": ("F['f'](par.force)", INNER + "F = {'f': helper}"),
    "attribute of a function": ("par.force * helper.k", INNER.replace("VALUE", "1.0") + "helper.k = VALUE"),
    "variable around": ("f(par.force)", MAKER.format("k") + "f = make(VALUE)"),
    "list around": ("f(par.force)", MAKER.format("k[0]") + "f = make([VALUE])"),
    "array around": ("f(par.force)", NUMPY + MAKER.format("k[0]") + "f = make(np.array([VALUE]))"),
    "function around a function": (
        "f(par.force)",
        MAKER.format("k") + "def twice(f):\n    return lambda x: f(f(x))\nf = twice(make(VALUE))",
    ),
    "other function of the same code": (
        "f(par.force) + g(par.force)",
        MAKER.format("k") + "f = make(2.0)\ng = f if VALUE == 2.0 else make(VALUE)",
    ),
    "which function": ("f(par.force)", "def one(x):\n    return x\ndef two(x):\n    return x + x\nf = one if VALUE > 2.0 else two"),
    "whether there is one": ("par.force * (5.0 if K is None else 7.0)", "K = None if VALUE > 2.0 else object()"),
    "name of Python": ("par.force * float(len((1.0, 2.0)))", "if VALUE > 2.0:\n    def len(items):\n        return 7.0\n"),
    "partial function": ("g(par.force)", "from functools import partial\n" + HELPER.format("") + "g = partial(helper, k=VALUE)"),
    "function with a cache": (CALL, "from functools import cache\n@cache\n" + INNER),
    "method": ("o.f(par.force)", "class O:\n    def f(self, x):\n        return x * VALUE\no = O()"),
}
"""By name: the force, and if needed what stands before the class, in it, in the module `library`, and after the arguments of the step."""
REFUSED = ("partial function", "function with a cache", "method")
"""Kinds that a step cannot call."""
VALUES = ("2.0", "3.0")


def write(folder: Path, kind: str, value: str) -> None:
    """Write the step of a kind, and the module that it may import, into a folder."""
    given = KINDS[kind]
    force, before, body, library, more = (text.replace("VALUE", value) for text in given + ("", "", "pass", "", "")[len(given) :])
    step = f"@staticmethod\n    def step(par, x, inp, clock{more}):\n        return (), ({force},)\n"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "plug.py").write_text(f"from contourlab.primitives import *\n{before}\nclass Mine:\n    {body}\n    {step}", encoding="utf-8")
    (folder / "library.py").write_text(library, encoding="utf-8")


def imported(file: Path) -> ModuleType:
    """Import a file anew: byte code of an edit in the same second would pass for that of the file."""
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    with patch.object(sys, "dont_write_bytecode", True):
        spec.loader.exec_module(module)
    return module


def outputs(step: Step, jit: bool) -> Any:
    """Return the outputs of one tick of a step; its parameters and inputs are 2."""
    wires = {port.name: f"in.{port.name}" for port in step.inputs}
    schedule = Schedule((Node("node", step, wires, dict.fromkeys(step.parameters, 2.0)),), step.inputs, 1e-3, 1)
    group = make_group(schedule, 1, slice(0, 1), jit)
    return group.run(np.full((1, len(step.inputs)), 2.0), [schedule.row(f"node.{port.name}") for port in step.outputs])[0, :, 0]


def answers(folder: Path) -> list[Any]:
    """Return the force of the step in a folder, compiled and in plain Python; what is refused gives the line of its step."""
    sys.modules["library"] = imported(folder / "library.py")
    step = Step("mine", imported(folder / "plug.py").Mine.step, ("force",), outputs=(Port("load"),))
    found: list[Any] = []
    for jit in (True, False):
        try:
            found.append(float(outputs(step, jit)[0]))
        except EngineError as error:
            found.append([error.file == str(folder / "plug.py"), error.line == step.function.__code__.co_firstlineno + 2])
    return found


if __name__ == "__main__":
    sys.stdout.write(json.dumps({folder.name: answers(folder) for folder in sorted(Path(sys.argv[1]).iterdir())}))
