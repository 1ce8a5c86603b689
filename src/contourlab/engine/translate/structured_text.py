"""Print a controller as a function block in Structured Text of IEC 61131-3, plain or as a TwinCAT object."""

from __future__ import annotations

import math
import uuid
from collections.abc import Iterable
from typing import ClassVar

from contourlab.engine.translate.control import Control, ControlWriter, Field
from contourlab.engine.translate.graph import CONDITION, MismatchError, Op

_LARGEST = "1.7976931348623157E+308"
_WHOLE = "4503599627370496.0"
"""2^52: a number that is added to it and subtracted again is rounded to a whole number."""


def plain(made: Control) -> str:
    """Return the function block as plain text.

    Raises
    ------
    MismatchError
        If the controller draws random numbers, or has a constant that is no number.
    """
    declared, body = _parts(made)
    return f"{declared}\n{body}\nEND_FUNCTION_BLOCK\n"


def twincat(made: Control) -> str:
    """Return the function block as a ``.TcPOU`` file of TwinCAT 3; raises as `plain`."""
    declared, body = _parts(made)
    return f"""<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">
  <POU Name="FB_{made.name}" Id="{{{uuid.uuid5(uuid.NAMESPACE_OID, declared + body)}}}" SpecialFunc="None">
    <Declaration><![CDATA[{declared}]]></Declaration>
    <Implementation>
      <ST><![CDATA[{body}]]></ST>
    </Implementation>
  </POU>
</TcPlcObject>
"""


def _parts(made: Control) -> tuple[str, str]:
    """Return declaration and implementation."""
    writer = _Writer(made)
    writer.block(made.tick.graph.top, "    ")
    writer.block(made.tick.body, "    ")
    states, place = list(made.states.values()), input_name(made.feedback)
    after = [f"    s_{made.states[row].name} := {writer.value(op)};" for row, op in made.carried()]
    arrays = [*made.banks, *made.rings]
    ranges = [f"{memory.name} : ARRAY[0..{len(memory.fields) - 1}] OF LREAL;" for memory in arrays]
    inputs = [Field(input_name(field.name), field.unit, field.doc) for field in made.inputs.values()]
    ticks = ["s_tick : LREAL; (* number of the call *)"] if made.counts_ticks else []
    constants = [
        _declared(field, initial=True) for field in (Field("PERIOD", "s", "between two calls", made.period), *made.constants.values())
    ]
    listed = [[literal(field.value).strip("()") for field in table.fields] for table in made.tables]
    constants += [
        f"{table.name} : ARRAY[0..{len(table.fields) - 1}] OF LREAL := [{', '.join(numbers)}];"
        for table, numbers in zip(made.tables, listed, strict=True)
    ]
    kinds = {kind: [name for name, its in writer.locals.items() if its == kind] for kind in ("LREAL", "BOOL")}
    kinds["LREAL"] = [*(f"x_{state.name}" for state in states), *kinds["LREAL"]]
    kinds["LINT"] = [f"{name}_n" for name in writer.indices]
    temporary = [f"{', '.join(names[k : k + 8])} : {kind};" for kind, names in kinds.items() for k in range(0, len(names), 8)]
    declared = [
        *(f"(* {note} *)" for note in made.notes),
        f"FUNCTION_BLOCK FB_{made.name}",
        *_section("VAR_INPUT", ["enable : BOOL; (* FALSE: command 0, state of rest *)", *map(_declared, inputs)]),
        *_section("VAR_INPUT", (_declared(field, initial=True) for field in made.parameters.values())),
        *_section("VAR_OUTPUT", [_declared(made.output)]),
        *_section("VAR", ["running : BOOL;", *(f"s_{field.name} : LREAL;" for field in states), *ranges, *ticks]),
        *_section("VAR_TEMP", temporary),
        *_section("VAR CONSTANT", constants),
    ]
    body = [
        "IF enable AND NOT running THEN",
        *(f"    s_{state.name} := {state.at_rest(place, literal)};" for state in states),
        *(f"    {memory.name}[{k}] := {field.at_rest(place, literal)};" for memory in arrays for k, field in enumerate(memory.fields)),
        *(["    s_tick := 0.0;"] if ticks else []),
        "END_IF",
        "running := enable;",
        "command := 0.0;",
        "IF enable THEN",
        *(f"    x_{state.name} := s_{state.name};" for state in states),
        *writer.lines,
        *after,
        *(["    s_tick := s_tick + 1.0;"] if ticks else []),
        f"    {made.output.name} := {writer.value(made.result)};",
        "END_IF",
    ]
    return "\n".join(declared), "\n".join(body)


def input_name(name: str) -> str:
    """Return the name of an input; REFERENCE is a word of TwinCAT."""
    return "reference_position" if name == "reference" else name


def _section(head: str, lines: Iterable[str]) -> list[str]:
    inner = [f"    {line}" for line in lines]
    return [head, *inner, "END_VAR"] if inner else []


def _declared(field: Field, initial: bool = False) -> str:
    text = f"{'[' + field.unit + '] ' if field.unit else ''}{field.doc}"
    start = f" := {literal(field.value).strip('()')}" if initial else ""
    return f"{field.name} : LREAL{start};{f' (* {text} *)' if text else ''}"


def literal(number: float) -> str:
    """Return a number of type LREAL that reads back identical; infinity is the largest number."""
    if math.isnan(number):
        raise MismatchError("a constant that is no number: Structured Text has none")
    if math.isinf(number):
        return _LARGEST if number > 0.0 else f"(-{_LARGEST})"
    digits, _, exponent = repr(abs(number)).partition("e")
    text = (digits if "." in digits else f"{digits}.0") + (f"E{exponent}" if exponent else "")
    return text if math.copysign(1.0, number) > 0.0 else f"(-{text})"


class _Writer(ControlWriter):
    """Writes statements of Structured Text; variables are declared in `locals`."""

    parameters, arrays, tick = "", "", "s_tick"
    symbols: ClassVar = ControlWriter.symbols | {"and": "AND", "or": "OR", "not": "NOT ", "==": "=", "!=": "<>"}
    functions: ClassVar = {
        **{name: name.upper() for name in ("sqrt", "exp", "sin", "cos", "tan", "asin", "acos", "atan")},
        "fabs": "ABS",
        "log": "LN",
        "pow": "EXPT",
    }
    declares = False
    assigns, if_, else_, while_, leave = ":=", "IF {} THEN", "ELSE", "WHILE TRUE DO", "IF NOT {} THEN EXIT; END_IF"
    end_if, end_for, end_while = "END_IF", "END_FOR", "END_WHILE"

    def __init__(self, made: Control) -> None:
        super().__init__(made)
        self.locals: dict[str, str] = {}
        self.indices: list[str] = []

    def input(self, field: Field) -> str:
        return input_name(field.name)

    def value(self, op: Op) -> str:
        if op.kind != "constant":
            return super().value(op)
        return "SQRT(-1.0)" if op.extra != op.extra else str(op.extra).upper() if op.type == CONDITION else literal(op.extra)

    def name(self, op: Op, ending: str = "") -> str:
        name = super().name(op, ending)
        self.locals[name] = "BOOL" if op.type == CONDITION else "LREAL"
        return name

    def text(self, op: Op, *args: str) -> str:
        if op.kind == "select":
            return f"SEL({args[0]}, {args[2]}, {args[1]})"
        if op.kind == "copysign":
            return f"SEL({args[1]} < 0.0, ABS({args[0]}), -ABS({args[0]}))"
        if op.kind == "lookup":
            return f"{args[0]}[TRUNC({args[1]})]"
        if op.kind in ("uniform", "fmod"):
            found = "random numbers" if op.kind == "uniform" else "fmod, % and // of numbers (write a - b*floor(a/b))"
            raise MismatchError(f"{found}: Structured Text has none")
        return super().text(op, *args)

    def compute(self, op: Op, pad: str) -> None:
        if op.kind not in ("floor", "rint", "tanh", "atan2"):
            super().compute(op, pad)
            return
        # The language lacks these functions, or TwinCAT does.
        x, name = self.value(op.args[0]), self.name(op)
        sign = f"{name} := SEL({x} < 0.0, {name}, -{name});"
        if op.kind == "tanh":
            steps = [f"{name} := EXP(-2.0 * ABS({x}));", f"{name} := (1.0 - {name}) / (1.0 + {name});", sign]
        elif op.kind == "atan2":
            y, x = x, self.value(op.args[1])
            upright = f"SEL({y} < 0.0, SEL({y} > 0.0, {y}, {0.5 * math.pi}), {-0.5 * math.pi})"
            steps = [f"IF {x} = 0.0 THEN {name} := {upright}; ELSE {name} := ATAN({y} / {x}); END_IF"]
            steps += [f"IF {x} < 0.0 THEN {name} := {name} + SEL({y} < 0.0, {math.pi}, {-math.pi}); END_IF"]
        else:
            steps = [f"{name} := ABS({x});", f"IF {name} < {_WHOLE} THEN {name} := ({name} + {_WHOLE}) - {_WHOLE}; END_IF", sign]
            steps += [f"IF {name} > {x} THEN {name} := {name} - 1.0; END_IF"] if op.kind == "floor" else []
        self.lines += [pad + step for step in steps]

    def past(self, op: Op, tick: str) -> str:
        return f"{self.made.array(op).name}[(LREAL_TO_LINT({tick}) + {op.extra[1]}) MOD {op.extra[1]}]"

    def counting(self, index: str, count: int) -> list[str]:
        self.indices.append(index)
        return [f"FOR {index}_n := 0 TO {count - 1} DO", f"    {index} := LINT_TO_LREAL({index}_n);"]
