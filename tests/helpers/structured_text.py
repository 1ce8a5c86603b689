"""A small interpreter of function blocks in Structured Text, over the syntax trees of blark.

blark takes 0.25 ms a character, so it parses each shape of statement once: assignments that differ only in the names of variables, or
where a subscript begins, share a tree, and of the names in a list that differ only in digits it parses the first.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable
from functools import cache, partial
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
    **{name.upper(): getattr(math, name) for name in ("tan", "asin", "acos", "atan")},
    "EXPT": math.pow,
    "LREAL_TO_LINT": round,
    "LINT_TO_LREAL": float,
}
_ZERO = {"LREAL": 0.0, "BOOL": False, "LINT": 0}


_LIST = re.compile(r"^ +(\w+(?:,\s+\w+)+) : ", re.MULTILINE)
_ASSIGNMENT = re.compile(r" *[A-Za-z]\w*(?:\[[^]:;]*\])? := ([^:;]*);")
_ROW = "assignments_in_a_row"
_WORD = re.compile(r"(?<![\w.])[A-Za-z]\w*|(?<=\[)\d+\b")  # or the first number of a subscript


def _shorter(short: dict[str, str], word: re.Match[str]) -> str:
    return short.get(word[0], word[0])


@cache
def _assignment(shape: str) -> Any:
    from blark.parse import parse_source_code

    parsed = parse_source_code(shape, starting_rule="statement_list")
    assert parsed.exception is None, shape
    (statement,) = parsed.transform().items[0].statements
    return statement


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
        from blark.parse import parse, parse_source_code

        self.rows: list[list[tuple[Any, dict[str, str]]]] = []
        self.names: dict[str, str] = {}
        self.alike: dict[str, list[str]] = {}
        # Of TwinCAT: declaration and implementation.
        parts = [parse_source_code(self._shortened(file.read_text()))] if file.suffix == ".st" else list(parse(file))
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
        assert {name for row in self.rows for _, names in row for name in names.values() if not name.isdigit()} <= set(self.kinds)

    def _shortened(self, text: str) -> str:
        """Return the source with one name for those of a list that differ only in digits, and one statement for assignments in a row."""
        text = _LIST.sub(self._first_ones, text)
        declared = set(re.findall(r"^ +(\w+) : ", text, re.MULTILINE))
        declared |= {name for names in self.alike.values() for name in names}
        lines: list[str] = []
        row: list[tuple[Any, dict[str, str]]] = []
        for line in text.splitlines():
            if _ASSIGNMENT.fullmatch(line):
                variables = dict.fromkeys(word for word in _WORD.findall(line) if word in declared or word.isdigit())
                short = {name: f"n{number}" for number, name in enumerate(variables)}
                shape = _WORD.sub(partial(_shorter, short), line.strip())
                if not row:
                    self.rows.append(row)
                    lines.append(f"{_ROW} := {len(self.rows) - 1};")
                row.append((_assignment(shape), dict(zip(short.values(), short, strict=True))))
            else:
                row = []
                lines.append(line)
        return "\n".join(lines)

    def _first_ones(self, found: re.Match[str]) -> str:
        first: dict[str, str] = {}
        for name in re.findall(r"\w+", found[1]):
            model = first.setdefault(re.sub(r"\d+", "0", name), name)
            self.alike.setdefault(model, []).append(name)
        return f"    {', '.join(first.values())} : "

    def _declare(self, section: Any, item: Any) -> None:
        kind = str(getattr(item.init.spec, "type", "")).split()[-1]
        first = [str(declared.variable.name) for declared in item.variables]
        for name in (name for one in first for name in self.alike.get(one, [one])):
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
        for statement in block.statements if block else ():
            getattr(self, f"_{type(statement).__name__.lower()}")(statement)

    def _assignmentstatement(self, statement: Any) -> None:
        (target,) = statement.variables
        if str(target.name) == _ROW:
            for assignment, names in self.rows[int(str(statement.expression.value))]:
                self.names = names
                self._assignmentstatement(assignment)
            self.names = {}
            return
        value = self._value(statement.expression)
        name = self._name(getattr(target.name, "name", target.name))
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

    def _name(self, tree: Any) -> str:
        return self.names.get(str(tree), str(tree))

    def _value(self, tree: Any) -> Any:
        kind = type(tree).__name__
        if kind == "SimpleVariable":
            name = self._name(tree.name)
            if name.isdigit():
                return int(name)
            return self.now[name] if name in self.temporary else self.kept[name]
        if kind == "MultiElementVariable":
            return self.kept[self._name(tree.name.name)][self._index(tree)]
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
        assert 0 <= value < len(self.kept[self._name(tree.name.name)])
        return value
