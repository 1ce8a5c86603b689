"""A whole controller for printing: named inputs, states, parameters and constants around the graph of its tick; its C99.

The C99 is a header and a source with structs for state and parameters, and a bench that replays a recorded run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from contourlab.arrays import Array
from contourlab.engine.step import Schedule, rows
from contourlab.engine.translate.c99 import HASH, Writer, literal
from contourlab.engine.translate.graph import LIBRARY, Op, prune
from contourlab.engine.translate.maths import EXACT
from contourlab.engine.translate.step_graph import Rows, TickGraph, tick_graph

IN_PLACE = ("constant", "parameter", "external", "before", "table", "size", "ring", "tick", "time", "period")
"""Kinds of operations that are printed without a variable of their own."""


@dataclass(frozen=True)
class Field:
    """A named number.

    Attributes
    ----------
    name, unit, doc : str
        The unit is empty for a plain number.
    value : float
        Of a parameter or constant; of a state at rest at position 0.
    slope : float
        Of a state: change of the value at rest for each metre of position.
    """

    name: str
    unit: str = ""
    doc: str = ""
    value: float = 0.0
    slope: float = field(default=0.0, metadata={"json": ""})

    def at_rest(self, position: str, literal: Callable[[float], str]) -> str:
        """Return the text of a state at rest at a position."""
        if self.slope == 0.0:
            return literal(self.value)
        moved = position if self.slope == 1.0 else f"({literal(self.slope)} * {position})"
        return moved if self.value == 0.0 else f"{literal(self.value)} + {moved}"


@dataclass(frozen=True)
class Memory:
    """An array of the controller: the members of a bank, a ring of past values, or a read-only table.

    Attributes
    ----------
    name : str
    first : int
        Row of memory where it begins; of a table its number.
    fields : tuple of Field
    """

    name: str
    first: int
    fields: tuple[Field, ...]


@dataclass(frozen=True)
class Control:
    """A controller to print.

    Attributes
    ----------
    name : str
        An identifier in every language.
    notes : tuple of str
        Lines of the head of every file: origin, hash, limits.
    period : float [s]
    tick : TickGraph
    result : Op
        The command.
    output : Field
    inputs, parameters, constants, states : dict of int to Field
        By row, those that are used. Parameters may be changed while it runs. Constants may not: others were computed from them.
    banks, rings, tables : tuple of Memory
    """

    name: str
    notes: tuple[str, ...]
    period: float
    tick: TickGraph
    result: Op
    output: Field
    inputs: dict[int, Field] = field(default_factory=dict)
    parameters: dict[int, Field] = field(default_factory=dict)
    constants: dict[int, Field] = field(default_factory=dict)
    states: dict[int, Field] = field(default_factory=dict)
    banks: tuple[Memory, ...] = ()
    rings: tuple[Memory, ...] = ()
    tables: tuple[Memory, ...] = ()

    @property
    def operations(self) -> list[Op]:
        """All operations of a tick, those of inner blocks included."""
        return [*self.tick.graph.top.every(), *self.tick.body.every()]

    @property
    def counts_ticks(self) -> bool:
        """Whether it uses the number of the tick."""
        return bool(self.rings) or any(op.kind in ("tick", "time") for op in self.operations)

    @property
    def feedback(self) -> str:
        """The input that says where the axis is when the controller is switched on."""
        names = [field.name for field in self.inputs.values()]
        return next((name for name in ("position", "motor_position") if name in names), "reference")

    def array(self, op: Op) -> Memory:
        """Return the table, ring or bank that an operation takes or stores in."""
        if op.kind in ("table", "size"):
            return next(table for table in self.tables if table.first == (op.extra if op.kind == "table" else op.extra[1]))
        return next(memory for memory in (*self.rings, *self.banks) if 0 <= op.extra[0] - memory.first < len(memory.fields))

    def carried(self) -> list[tuple[int, Op]]:
        """Return the row of each state and its value after the tick."""
        return [(row, after) for _, row, after in self.tick.carried]


def control_of(
    schedule: Schedule,
    places: Rows,
    rest: Array,
    slope: Array,
    *,
    output: str,
    command: Field,
    inputs: Mapping[str, Field],
    parameters: Mapping[str, Field],
    constants: Mapping[str, Field],
    name: str,
    notes: tuple[str, ...],
) -> Control:
    """Return the controller that a schedule computes.

    Parameters
    ----------
    schedule : Schedule
    places : Rows
        Where memory has everything.
    rest, slope : ndarray (n_row,)
        Memory at rest at position 0, and its change for each metre of position.
    output : str
        Signal of the command.
    command : Field
        Its description.
    inputs, parameters, constants : mapping of str to Field
        Descriptions: of inputs by port, of the others by ``node.parameter``. A parameter in neither is a constant without a unit.
    name, notes : str, tuple of str
        As in `Control`.

    Raises
    ------
    EngineError
        If a step uses what cannot be translated; names file and line.
    """
    made = tick_graph(schedule, places, [schedule.row(output)], EXACT, contract=False)
    (result,) = made.log
    prune([made.graph.top, made.body], [*(op for _, _, op in made.carried), result])
    used = (*made.graph.top.every(), *made.body.every())
    reached = {(op.kind, op.extra) for op in used if op.kind in ("parameter", "external", "table")}
    free: dict[int, Field] = {}
    fixed: dict[int, Field] = {}
    states: dict[int, Field] = {}
    banks: list[Memory] = []
    rings: list[Memory] = []
    tables: list[Memory] = []

    def at(name: str, row: int) -> Field:
        return Field(name, "", "", float(rest[row]), float(slope[row]))

    def memory(name: str, first: int, size: int) -> Memory:
        return Memory(name, first, tuple(at("", first + k) for k in range(size)))

    for i, node in enumerate(schedule.nodes):
        label = _plain(node.name)
        for r, parameter in enumerate(node.step.parameters):
            row, key = places.parameters[i] + r, f"{node.name}.{parameter}"
            if ("parameter", row) in reached:
                known = parameters.get(key) or constants.get(key) or Field("")
                (free if key in parameters else fixed)[row] = Field(f"{label}_{parameter}", known.unit, known.doc, float(rest[row]))
        own = [f"{label}_{row}" for port in node.step.own_states for row in _rows_of(port.name, port.size)]
        states |= {places.states[i] + r: at(state, places.states[i] + r) for r, state in enumerate(own)}
        if node.step.bank:
            first = places.states[i] + len(own)
            banks.append(memory(f"{label}_members", first, rows((node.step.bank.port,))))
        if node.step.ring:
            rings.append(memory(f"{label}_past", places.rings[i], places.ring_lengths[i]))
        for table in node.step.tables:
            values = tuple(Field("", value=float(v)) for v in node.tables[table].ravel())
            tables.append(Memory(f"{label}_{table}", len(tables), values))
    late = {row: signal for signal, row in reversed(schedule.row_of.items())}
    for _, row, _ in made.carried:
        if row not in states:
            states[row] = at("last_" + _plain(late[row]), row)
    fed = [row for port in schedule.externals for row in _rows_of(port.name, port.size)]
    taken = {row: inputs[port] for row, port in enumerate(fed) if ("external", row) in reached}
    arrays = (tuple(banks), tuple(rings), tuple(table for table in tables if ("table", table.first) in reached))
    return Control(name, notes, schedule.period, made, result, command, taken, free, fixed, states, *arrays)


def _rows_of(name: str, size: int) -> Sequence[str]:
    return [f"{name}_{k}" for k in range(size)] if size else [name]


def _plain(signal: str) -> str:
    """Return an identifier for the signal of an axis, without the name of the axis."""
    return "".join(c if c.isalnum() else "_" for c in signal.partition(".")[2]).rstrip("_")


INCLUDES = ("#include <math.h>", "#include <stdbool.h>", "#include <stdint.h>")


def header_of(made: Control) -> str:
    """Return the header."""
    name, guard = made.name, f"{made.name.upper()}_H"
    return "\n".join(
        [
            comment(made.notes),
            f"#ifndef {guard}",
            f"#define {guard}",
            "",
            f"#define {name.upper()}_PERIOD {literal(made.period)} /* [s] between two calls */",
            "",
            *types_of(made),
            f"extern const {name}_parameters {name}_defaults;",
            "",
            "/* Rest at a position [m]; call it before the first step, and whenever the axis is enabled. */",
            f"void {name}_init({name}_state *state, double position);",
            "",
            f"/* Return the {made.output.doc} [{made.output.unit}]. */",
            f"double {name}_step({name}_state *state, const {name}_parameters *par, const {name}_inputs *in);",
            "",
            "#endif",
            "",
        ]
    )


def types_of(made: Control) -> list[str]:
    """Return the lines that define the structs; all their members are numbers of type double."""
    name, arrays = made.name, [Field(f"{memory.name}[{len(memory.fields)}]") for memory in (*made.banks, *made.rings)]
    states = [*made.states.values(), *arrays, *([Field("tick", "", "number of the call")] if made.counts_ticks else [])]
    return [
        "/* Inputs of one call. */",
        *_struct(f"{name}_inputs", made.inputs.values()),
        "/* Parameters that may be changed between two calls. */",
        *_struct(f"{name}_parameters", made.parameters.values()),
        "/* State, kept from call to call. */",
        *_struct(f"{name}_state", states),
    ]


def source_of(made: Control) -> str:
    """Return the source."""
    return "\n".join([comment(made.notes), *INCLUDES, f'#include "{made.name}.h"', "", body_of(made)])


def body_of(made: Control, storage: str = "") -> str:
    """Return the definitions of a source, without head; `storage`, such as ``"static "``, goes before functions and defaults."""
    name, writer = made.name, ControlWriter(made)
    writer.block(made.tick.graph.top, "    ")
    writer.block(made.tick.body, "    ")
    after = [f"    state->{made.states[row].name} = {writer.value(op)};" for row, op in made.carried()]
    used = {id(arg) for op in made.operations for arg in (*op.args, *(end for block in op.blocks for end in block.ends))}
    used |= {id(op) for _, op in (*made.carried(), (0, made.result))}
    loads = [
        f"    const double x_{made.states[row].name} = state->{made.states[row].name};"
        for op, row, _ in made.tick.carried
        if id(op) in used
    ]
    unused = [] if any(op.kind == "parameter" and op.extra in made.parameters for op in made.operations) else ["    (void)par;"]
    kinds = {op.kind for op in made.operations}
    return "\n".join(
        [
            *([HASH] if "uniform" in kinds else []),
            *([f"static const double PERIOD = {literal(made.period)};"] if kinds & {"period", "time"} else []),
            *(f"static const double {c.name} = {literal(c.value)};{_meaning(c)}" for c in made.constants.values()),
            *(
                f"static const double {table.name}[{len(table.fields)}] = {{{', '.join(literal(field.value) for field in table.fields)}}};"
                for table in made.tables
            ),
            "",
            f"{storage}const {name}_parameters {name}_defaults = {{",
            *(f"    {literal(p.value)},{_meaning(p, p.name + ': ')}" for p in made.parameters.values()),
            *([] if made.parameters else ["    0.0"]),
            "};",
            "",
            f"{storage}void {name}_init({name}_state *state, double position)",
            "{",
            *([] if any(f.slope for f in made.states.values()) else ["    (void)position;"]),
            *(f"    state->{state.name} = {state.at_rest('position', literal)};" for state in made.states.values()),
            *(line for memory in (*made.banks, *made.rings) for line in _filled(memory)),
            *(["    state->tick = 0.0;"] if made.counts_ticks else []),
            "}",
            "",
            f"{storage}double {name}_step({name}_state *state, const {name}_parameters *par, const {name}_inputs *in)",
            "{",
            *unused,
            *loads,
            *writer.lines,
            *after,
            *(["    state->tick = state->tick + 1.0;"] if made.counts_ticks else []),
            f"    return {writer.value(made.result)};",
            "}",
            "",
        ]
    )


def bench_of(made: Control) -> str:
    """Return a program that replays a recorded run and compares the commands: exit code 0 if they agree."""
    name, columns = made.name, [f"in.{field.name}" for field in made.inputs.values()]
    allowed = "1e-12 * largest" if any(op.kind in LIBRARY for op in made.operations) else "0.0"
    return f"""{comment([f"Replay a recorded run: {name}_bench {name}_run.csv", *made.notes[:2]])}
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "{name}.h"

int main(int argc, char **argv)
{{
    char line[{32 * (len(columns) + 2)}];
    {name}_state state;
    {name}_inputs in;
    long samples = 0;
    double largest = 0.0, worst = 0.0;
    FILE *run = (argc == 2) ? fopen(argv[1], "r") : NULL;
    if ((run == NULL) || (fgets(line, (int)sizeof line, run) == NULL)) {{
        fprintf(stderr, "name the recorded run: {name}_run.csv\\n");
        return 2;
    }}
    while (fgets(line, (int)sizeof line, run) != NULL) {{
        char *at = line;
        double wanted, command, difference;
{chr(10).join(f"        {column} = strtod(at, &at); at += (*at == ',') ? 1 : 0;" for column in columns)}
        wanted = strtod(at, NULL);
        if (samples == 0) {{
            {name}_init(&state, in.{made.feedback});
        }}
        command = {name}_step(&state, &{name}_defaults, &in);
        difference = fabs(command - wanted);
        worst = (difference <= worst) ? worst : difference; /* keeps NaN */
        largest = (fabs(wanted) > largest) ? fabs(wanted) : largest;
        ++samples;
    }}
    fclose(run);
    printf("%ld samples, largest command %.17g, largest difference %.3g\\n", samples, largest, worst);
    return ((samples > 0) && (worst <= {allowed})) ? 0 : 1;
}}
"""


def comment(lines: Iterable[str]) -> str:
    """Return a block comment."""
    return "\n".join(["/*", *(f" * {line}" for line in lines), " */"])


def _struct(name: str, fields: Iterable[Field]) -> list[str]:
    members = [f"    double {field.name};{_meaning(field)}" for field in fields] or ["    double none; /* there are none */"]
    return ["typedef struct {", *members, f"}} {name};", ""]


def _meaning(field: Field, before: str = "") -> str:
    text = f"{before}{'[' + field.unit + '] ' if field.unit else ''}{field.doc}".strip(" :")
    return f" /* {text} */" if text else ""


def _filled(memory: Memory) -> list[str]:
    """Return the statements that fill an array at rest."""
    if len(set(memory.fields)) > 1:
        return [f"    state->{memory.name}[{k}] = {field.at_rest('position', literal)};" for k, field in enumerate(memory.fields)]
    return [
        f"    for (int64_t n = 0; n < {len(memory.fields)}; ++n) {{",
        f"        state->{memory.name}[n] = {memory.fields[0].at_rest('position', literal)};",
        "    }",
    ]


class ControlWriter(Writer):
    """Writes a tick over the structs of a controller. A subclass has another language."""

    elsewhere = IN_PLACE
    parameters, arrays, tick = "par->", "state->", "state->tick"
    """What stands before the name of a parameter and of an array; the number of the call."""

    def __init__(self, made: Control) -> None:
        super().__init__()
        self.made = made

    def input(self, field: Field) -> str:
        """Return the place of an input."""
        return f"in->{field.name}"

    def value(self, op: Op) -> str:
        made = self.made
        if op.kind == "parameter":
            return self.parameters + made.parameters[op.extra].name if op.extra in made.parameters else made.constants[op.extra].name
        if op.kind == "external":
            return self.input(made.inputs[op.extra])
        if op.kind == "before":
            return f"x_{made.states[op.extra].name}"
        if op.kind in ("table", "size"):
            table = made.array(op)
            return table.name if op.kind == "table" else literal(float(len(table.fields)))
        words = {"tick": self.tick, "time": f"({self.tick} * PERIOD)", "period": "PERIOD"}
        return words.get(op.kind) or super().value(op)

    def past(self, op: Op, tick: str) -> str:
        return f"state->{self.made.array(op).name}[(int64_t){tick} & {op.extra[1] - 1}]"

    def member(self, op: Op) -> str:
        bank = self.made.array(op)
        return f"{self.arrays}{bank.name}[{self.member_row(op, op.extra[0] - bank.first)}]"

    def stored(self, op: Op) -> str:
        return self.past(op, self.tick) if op.kind == "store_ring" else self.member(op)
