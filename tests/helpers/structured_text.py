"""A small interpreter of function blocks in Structured Text, over the syntax tree of blark."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from pathlib import Path
from typing import Any

_OPERATORS: dict[str, Callable[..., Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "MOD": math.fmod,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
    "=": operator.eq,
    "<>": operator.ne,
    "AND": lambda a, b: bool(a) and bool(b),
    "OR": lambda a, b: bool(a) or bool(b),
}
_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "SEL": lambda condition, a, b: b if condition else a,
    "ABS": abs,
    "SQRT": lambda x: math.sqrt(x) if x >= 0.0 else math.nan,
    "TRUNC": int,
    "EXP": math.exp,
    "LN": math.log,
    "SIN": math.sin,
    "COS": math.cos,
    "LREAL_TO_LINT": round,
    "LINT_TO_LREAL": float,
}
_ZERO = {"LREAL": 0.0, "BOOL": False, "LINT": 0}


def _flat(values: Any) -> Any:
    """Yield the values of a list, which the parser nests."""
    for value in values:
        inner = getattr(value, "element", value)
        yield from _flat(inner.elements) if hasattr(inner, "elements") else [inner]


class _Exit(Exception):  # noqa: N818
    """EXIT of a loop."""


class FunctionBlock:
    """An instance of the only function block of a source.

    Parameters
    ----------
    file : Path
        ``.st``, or ``.TcPOU`` of TwinCAT.
    """

    def __init__(self, file: Path) -> None:
        from blark.parse import parse

        parts = list(parse(file))  # of TwinCAT: declaration and implementation
        assert [part.exception for part in parts if part.exception] == []
        trees = [part.transform().items[0] for part in parts]
        self.tree, self.body = trees[0], trees[0].body if len(trees) == 1 else trees[1]
        self.kept: dict[str, Any] = {}
        self.temporary: dict[str, str] = {}
        self.kinds: dict[str, str] = {}
        self.constants: set[str] = set()
        for section in self.tree.declarations:
            for item in section.items:
                self._declare(section, item)

    def _declare(self, section: Any, item: Any) -> None:
        kind = str(getattr(item.init.spec, "type", "")).split()[-1]
        for declared in item.variables:
            name = str(declared.variable.name)
            assert name.lower() not in map(str.lower, self.kinds), f"{name} is declared twice"
            self.kinds[name] = kind
            if type(section).__name__ == "TemporaryVariableDeclarations":
                self.temporary[name] = kind
            elif hasattr(item.init.spec, "subranges"):
                first, last = (int(str(end)) for end in str(item.init.spec.subranges[0]).split(".."))
                values = getattr(item.init.value, "elements", None) or getattr(item.init.value, "values", None)
                assert first == 0
                self.kept[name] = [0.0] * (last + 1) if not values else [self._value(value) for value in _flat(values)]
            else:
                self.kept[name] = _ZERO[kind] if item.init.value is None else self._value(item.init.value)
            if getattr(section, "attrs", None) is not None and "CONSTANT" in str(section.attrs):
                self.constants.add(name)

    def __call__(self, **inputs: Any) -> float:
        """Run the body once; return the output ``command``."""
        assert set(inputs) <= set(self.kept)
        self.kept |= inputs
        self.now = {name: math.nan if kind == "LREAL" else None for name, kind in self.temporary.items()}
        self._run(self.body)
        return float(self.kept["command"])

    def _run(self, block: Any) -> None:
        for statement in block.statements:
            getattr(self, f"_{type(statement).__name__.lower()}")(statement)

    def _assignmentstatement(self, statement: Any) -> None:
        (target,) = statement.variables
        value = self._value(statement.expression)
        name = str(getattr(target.name, "name", target.name))
        assert name not in self.constants
        assert isinstance(value, {"LREAL": float, "BOOL": bool, "LINT": int}[self.kinds[name]]), f"{statement}"
        if hasattr(target, "elements"):
            self.kept[name][self._index(target)] = value
        else:
            (self.now if name in self.temporary else self.kept)[name] = value

    def _ifstatement(self, statement: Any) -> None:
        if self._value(statement.if_expression):
            self._run(statement.statements)
        elif statement.else_clause is not None:
            self._run(statement.else_clause.statements)

    def _whilestatement(self, statement: Any) -> None:
        try:
            while self._value(statement.expression):
                self._run(statement.statements)
        except _Exit:
            pass

    def _forstatement(self, statement: Any) -> None:
        for n in range(self._value(statement.from_), self._value(statement.to) + 1):
            self.now[str(statement.control.name)] = n
            self._run(statement.statements)

    def _exitstatement(self, statement: Any) -> None:
        raise _Exit

    def _value(self, tree: Any) -> Any:
        kind = type(tree).__name__
        if kind == "SimpleVariable":
            name = str(tree.name)
            return self.now[name] if name in self.temporary else self.kept[name]
        if kind == "MultiElementVariable":
            return self.kept[str(tree.name.name)][self._index(tree)]
        if kind == "ParenthesizedExpression":
            return self._value(tree.expr)
        if kind == "BinaryOperation":
            value = _OPERATORS[str(tree.op)](self._value(tree.left), self._value(tree.right))
            return int(value) if str(tree.op) == "MOD" else value
        if kind == "UnaryOperation":
            value = self._value(tree.expr)
            return not value if str(tree.op) == "NOT" else -value
        if kind == "FunctionCall":
            return _FUNCTIONS[str(tree.name.name)](*(self._value(given.value) for given in tree.parameters))
        return {"Real": float, "Integer": int, "Boolean": lambda text: text == "TRUE"}[kind](str(tree.value))

    def _index(self, tree: Any) -> int:
        ((subscript,),) = [part.subscripts for part in tree.elements]
        value = self._value(subscript)
        assert isinstance(value, int)
        assert 0 <= value < len(self.kept[str(tree.name.name)])
        return value
