"""Print a controller as C99: a header and a source with structs for state and parameters, and a bench that replays a recorded run."""

from __future__ import annotations

from collections.abc import Iterable

from contourlab.engine.translate.c99 import HASH, Writer, literal
from contourlab.engine.translate.control import IN_PLACE, Control, Field, Memory
from contourlab.engine.translate.graph import Op

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
    allowed = "1e-12 * largest" if made.calls_library else "0.0"
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
