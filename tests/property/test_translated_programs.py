"""Random steps: machine code, for one variant and in lanes, computes the bits of plain Python."""

from __future__ import annotations

import importlib.util
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from contourlab.arrays import Array, aligned
from contourlab.engine.runner import CompiledGroup, InterpretedGroup
from contourlab.engine.schedule import Node, Schedule
from contourlab.engine.step import Port, Step
from contourlab.engine.translate import llvm_ir, tick_loop
from contourlab.engine.translate.maths import EXACT
from contourlab.engine.translate.tick_graph import tick_graph

LANES, TICKS = 32, 3
INPUTS = (0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -3.25, 1e3)
HEAD = "from contourlab.primitives import fabs, floor, maximum, minimum, rint, select\n\n\ndef value(a, b):\n    c = 0.5\n"
FOOT = "\n\n\ndef step(par, x, inp, clock):\n    y = value(par.a, par.b)\n    return (y,), (y + x.z,)\n"


class Writer:
    """Writes random statements over the names a, b and c."""

    def __init__(self, seed: int) -> None:
        self.random, self.count = random.Random(seed), 0

    def number(self, depth: int = 3) -> str:
        draw = self.random
        if depth == 0 or draw.random() < 0.25:
            return draw.choice(["a", "b", "c", "a", "b", "c", "0.0", "-0.0", "1.0", "0.5", "-2.0", "7.25"])
        one, other = self.number(depth - 1), self.number(depth - 1)
        plain = ["({} + {})", "({} - {})", "({} * {})", "fabs({})", "floor({})", "rint({})", "(-{})"]
        form = draw.choice([*plain, "min", "max", "select", "if"])
        if form == "select":
            return f"select({self.condition(depth - 1)}, {one}, {other})"
        if form == "if":
            return f"({one} if {self.condition(depth - 1)} else {other})"
        return f"{form}imum({one}, {other})" if form in ("min", "max") else form.format(one, other)

    def condition(self, depth: int = 2) -> str:
        draw, least = self.random, min(depth, 1)
        plain = f"({self.number(least)} {draw.choice(['<', '>', '<=', '>=', '==', '!='])} {self.number(least)})"
        if depth == 0 or draw.random() < 0.6:
            return plain
        chain = f"({self.number(0)} < c <= {self.number(0)})"
        other = self.condition(depth - 1)
        return draw.choice([f"({plain} and {other})", f"({plain} or {other})", f"(not {other})", chain])

    def block(self, depth: int, pad: str) -> Iterator[str]:
        for _ in range(self.random.randrange(1, 4)):
            yield from self.statement(depth, pad)

    def statement(self, depth: int, pad: str) -> Iterator[str]:
        draw, inner = self.random, pad + "    "
        kind = draw.choice(["assign", "change", "swap", "if", "for", "break", "while"] if depth else ["assign", "change", "swap"])
        self.count += 1
        name = f"n{self.count}"
        if kind == "assign":
            yield f"{pad}{draw.choice('abc')} = {self.number()}"
        elif kind == "change":
            yield f"{pad}{draw.choice('abc')} {draw.choice('+-*')}= {self.number(2)}"
        elif kind == "swap":
            yield f"{pad}{', '.join(draw.sample('abc', 2))} = {self.number(2)}, {self.number(2)}"
        elif kind == "if":
            yield f"{pad}if {self.condition()}:"
            yield from self.block(depth - 1, inner)
            yield f"{pad}else:"
            yield from self.block(depth - 1, inner)
        elif kind == "while":
            yield f"{pad}{name} = 0.0"
            yield f"{pad}while {name} < 5.0 and {self.condition()}:"
            yield from self.block(depth - 1, inner)
            yield f"{inner}{name} += 1.0"
        else:
            yield f"{pad}for {name} in range({draw.choice([2, 3, 9])}):"
            yield from self.block(depth - 1, inner)
            if kind == "break":
                yield f"{inner}if {self.condition()}:"
                yield f"{inner}    break"
                yield from self.block(0, inner)
            elif draw.random() < 0.5:
                yield f"{inner}c = c + {name}"

    def program(self) -> str:
        lines = [*self.block(3, "    "), f"    if {self.condition()}:", f"        return {self.number()}", *self.block(1, "    ")]
        return HEAD + "\n".join(lines) + f"\n    return {self.number()}" + FOOT


def step_of(file: Path, source: str) -> Step:
    file.write_text(source)
    spec: Any = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return Step(file.stem, module.step, ("a", "b"), states=(Port("z"),), outputs=(Port("y"),))


def run(schedule: Schedule, lanes: int, width: int, part: slice) -> Array:
    """Run without contraction, so that nothing is rounded otherwise than in Python."""
    group = CompiledGroup(schedule, width, part)
    made = tick_graph(schedule, group._places, (0,), EXACT, contract=False)
    loop = llvm_ir.loaded(llvm_ir.object_code(tick_loop.source_of(made, lanes, width)), "run", tick_loop.SIGNATURE)
    log, nothing = aligned((TICKS, 1, width)), np.zeros(1)
    for lane in range(0, width, lanes):
        loop(group.memory.ctypes.data, 0, nothing.ctypes.data, 0, 0, log.ctypes.data, 0, TICKS, schedule.period, lane)
    return log


@pytest.mark.parametrize("seed", [*range(40), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(40, 400))])
def test_a_random_step_computes_the_same_bits(seed: int, tmp_path: Path) -> None:
    draw = random.Random(seed)
    values = {name: np.array([draw.choice([*INPUTS, draw.gauss(0.0, 2.0)]) for _ in range(LANES)]) for name in "ab"}
    schedule = Schedule((Node("s", step_of(tmp_path / f"step_{seed}.py", Writer(seed).program()), {}, values),), (), 1e-3, 1)
    plain = InterpretedGroup(schedule, LANES, slice(0, LANES)).run(np.zeros((TICKS, 0)), [0])
    for found, wanted in ((run(schedule, 16, LANES, slice(0, LANES)), plain), (run(schedule, 1, 1, slice(7, 8)), plain[:, :, 7:8])):
        np.testing.assert_array_equal(found, wanted)
        sound = ~np.isnan(wanted)  # the sign of a NaN depends on the processor
        np.testing.assert_array_equal(np.signbit(found)[sound], np.signbit(wanted)[sound])
