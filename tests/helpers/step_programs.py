"""Random steps over the whole language: numbers, whole numbers, truth values, branches, loops, tables, past values."""

from __future__ import annotations

import importlib.util
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.engine.step import Node, Port, Schedule, Step, ports

TABLE = (0.5, -1.0, 2.25, 0.0, -0.0, 7.5, 0.1, -3.0)
INPUTS = (0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -3.25, 1e3)
DIVISORS = (49.0, 0.003, 3.0, 0.1, -7.0, 98.0)
HEAD = """from contourlab.primitives import *


def wrapped(a, b):
    return a - b * floor(a / b)


def value(par, a, b, c, u, clock):
    n, m = 0, 1
"""
FOOT = """

def step(par, x, inp, clock):
    y = value(par, x.a, x.b, x.c, inp.u, clock)
    return (x.a, x.b, 0.25 * y), (y + x.c,)
"""
LEAVES = ["a", "b", "c", "u", "a", "b", "c", "u", "par.g"]
ARITHMETIC = ["({} + {})", "({} - {})", "({} * {})", "({} * {} + {})", "({} * {} - {})", "fabs({})", "floor({})", "rint({})",
              "(-{})", "({} / par.d)"]  # fmt: skip
WHOLE = ["({} + {})", "({} - {})", "(-{})", "({} * -1)", "({} * -2)", "({} if c > 0.5 else {})", "product", "truth", "truth"]
MORE = [
    "({} / 49.0)", "({} / (fabs({}) + 0.5))", "wrapped({}, par.d)", "wrapped(clock.t, par.d)", "copysign({}, {})",
    "clip({}, -2.0, {})", "sqrt(fabs({}))", "dot(({}, {}), ({}, {}))", "lookup(par.tab, clip(floor({}), 0.0, 7.0))",
    "delayed(par.ring, clock, clip(floor({}), 0.0, 7.0))", "uniform(par.s, clock.k, rint(clip({}, -50.0, 50.0)))",
]  # fmt: skip
LIBRARY = [
    "exp(minimum({}, 3.0))", "tanh({})", "sin(clip({}, -1e3, 1e3))", "cos(clip({}, -1e3, 1e3))", "log(clip(fabs({}), 0.25, 1e9))",
    "normal(par.s, clock.k + rint(clip({}, 0.0, 9.0)))",
]  # fmt: skip


class Writer:
    """Writes random statements over the numbers a, b, c and the whole numbers n, m."""

    def __init__(self, seed: int) -> None:
        self.random, self.count = random.Random(seed), 0
        self.forms = [ARITHMETIC, ARITHMETIC + MORE, ARITHMETIC + MORE + LIBRARY][seed % 3]

    def number(self, depth: int = 3) -> str:
        draw = self.random
        if depth == 0 or draw.random() < 0.25:
            return draw.choice([*LEAVES, "n", "0.0", "-0.0", "1.0", "0.5", "-2.0", "7.25", "0", "-1"])
        form = draw.choice([*self.forms, "minimum({}, {})", "maximum({}, {})", "select", "if", "whole"])
        if form == "whole":
            return self.whole(depth - 1)
        numbers = iter(lambda: self.number(depth - 1), None)
        if form in ("select", "if"):
            parts = next(numbers), self.condition(depth - 1), next(numbers)
            return ("select({1}, {0}, {2})" if form == "select" else "({0} if {1} else {2})").format(*parts)
        return form.format(*(next(numbers) for _ in range(form.count("{}"))))

    def whole(self, depth: int = 2) -> str:
        """Return an expression that Python computes in whole numbers and truth values; at most 1e9."""
        draw = self.random
        if depth <= 0 or draw.random() < 0.3:
            return draw.choice(["n", "m", "n", "m", "0", "1", "-1", "3"])
        form = draw.choice(WHOLE)
        if form == "product":
            return f"({draw.choice('nm')} * {self.whole(0)})"
        if form == "truth":
            return draw.choice(["(-{})", "({0} - {1})", "({0} * n)", "({0} + 1)", "{0}"]).format(self.condition(0), self.condition(0))
        return form.format(*(self.whole(depth - 1) for _ in range(form.count("{}"))))

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
        plain = ["assign", "change", "swap", "whole", "truth"]
        kind = draw.choice([*plain, "if", "for", "break", "while"] if depth else plain)
        self.count += 1
        name = f"n{self.count}"
        if kind == "assign":
            yield f"{pad}{draw.choice('abc')} = {self.number()}"
        elif kind == "change":
            yield f"{pad}{draw.choice('abc')} {draw.choice('+-*')}= {self.number(2)}"
        elif kind == "swap":
            yield f"{pad}{', '.join(draw.sample('abc', 2))} = {self.number(2)}, {self.number(2)}"
        elif kind == "whole":
            one = draw.choice("nm")
            yield f"{pad}{one} = {self.whole()}"
            yield f"{pad}{one} = {one} if -1000 < {one} < 1000 else 0"
        elif kind == "truth":  # a number on one side, a condition on the other
            yield f"{pad}{draw.choice('abc')} = {self.number(2)} if {self.condition(1)} else {self.condition(1)}"
        elif kind == "if":
            yield f"{pad}if {self.condition()}:"
            yield from self.block(depth - 1, inner)
            yield f"{pad}else:"
            yield from self.block(depth - 1, inner)
        elif kind == "while":
            yield f"{pad}{name} = {draw.choice(['0', '0.0'])}"
            yield f"{pad}while {name} < 5.0 and {self.condition()}:"
            yield from self.block(depth - 1, inner)
            yield f"{inner}{name} += {draw.choice(['1', '1.0'])}"
        else:
            yield f"{pad}for {name} in range({draw.choice(['2', '3', '9', '4, -2, -1'])}):"
            yield from self.block(depth - 1, inner)
            if kind == "break":
                yield f"{inner}c = -{name} * 0.5"
                yield f"{inner}if {self.condition()}:"
                yield f"{inner}    break"
                yield from self.block(0, inner)
            elif draw.random() < 0.5:
                yield f"{inner}c = c + {name}"

    def program(self) -> str:
        lines = [*self.block(3, "    "), f"    if {self.condition()}:", f"        return {self.number()}", *self.block(1, "    ")]
        return HEAD + "\n".join(lines) + f"\n    return {self.number()}" + FOOT


def step_of(file: Path, source: str) -> Step:
    """Return the step that a source defines."""
    file.write_text(source)
    spec: Any = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    layout = {"states": ports("a", "b", "c"), "inputs": (Port("u"),), "outputs": (Port("y"),)}
    return Step(file.stem, module.step, ("g", "d", "s"), tables=("tab",), ring="u", **layout)


def schedule_of(step: Step, seed: int, lanes: int) -> Schedule:
    """Return a schedule of the step alone, with parameters and states for each lane."""
    draw = random.Random(seed)
    drawn = {name: np.array([draw.choice([*INPUTS, draw.gauss(0.0, 2.0)]) for _ in range(lanes)]) for name in "abg"}
    values = {"g": drawn.pop("g"), "d": draw.choice(DIVISORS), "s": float(seed)}
    tables = {"tab": np.array(TABLE)}
    node = Node("s", step, {"u": "in.u"}, values, tables, initial=drawn, ring_length=8, repeat=draw.choice([1, 2, 2, 3]))
    return Schedule((node,), (Port("u"),), 1e-3, 1)
