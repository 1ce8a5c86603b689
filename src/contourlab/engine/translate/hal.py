"""Print a controller as a component of LinuxCNC's HAL, for `halcompile`, and the lines that load it in place of `pid`."""

from __future__ import annotations

import sys

from contourlab.engine.translate.c99 import literal
from contourlab.engine.translate.control import INCLUDES, Control, body_of, types_of

_LARGEST = sys.float_info.max
PINS = {
    "reference": "command",
    "reference_velocity": "command_deriv",
    "reference_acceleration": "command_deriv2",
    "position": "feedback",
    "velocity": "feedback_deriv",
    "motor_position": "motor_feedback",
    "motor_velocity": "motor_feedback_deriv",
}
"""Names of the inputs as pins, as `pid` has them."""


def component_of(made: Control) -> str:
    """Return the source of the component."""
    inputs, states = [field.name for field in made.inputs.values()], len(made.states) + made.counts_ticks
    pins = [f'pin in float {PINS[name]} "{_meaning(name)}";' for name in dict.fromkeys(["reference", made.feedback, *inputs])]
    size = states + sum(len(memory.fields) for memory in (*made.banks, *made.rings))
    return "\n".join(
        [
            f'component {made.name} "{made.notes[0]}";',
            f'description """{chr(10).join(made.notes)}""";',
            'pin in bit enable "while FALSE the output is 0 and the state is that of rest";',
            *pins,
            f'pin out float output "{made.output.doc} [{made.output.unit}]";',
            'pin out float error "command - feedback";',
            'pin out bit fault "TRUE if the thread has another period, or a number is not finite: the output is 0";',
            'param rw float scale = 1000.0 "machine units in a metre: 1000 for mm, 39.3700787402 for inch; degrees in a radian";',
            *_derive(inputs),
            # halcompile sets the value before any include: it knows no INFINITY.
            *(
                f'param rw float {p.name} = {literal(min(max(p.value, -_LARGEST), _LARGEST))} "{p.doc}{f" [{p.unit}]" if p.unit else ""}";'
                for p in made.parameters.values()
            ),
            f"variable double memory[{max(size, 1)}];",
            "variable double before[2];",
            "variable int running;",
            "option singleton yes;",
            "option no_convenience_defines yes;",
            "function _ fp;",
            'author "contourlab";',
            'license "BSD-3-Clause";',
            ";;",
            *INCLUDES,
            *types_of(made),
            body_of(made, "static "),
            *_function(made, inputs),
            "",
        ]
    )


def _derive(inputs: list[str]) -> list[str]:
    if not {"reference_velocity", "reference_acceleration"} & set(inputs):
        return []
    return ['param rw bit derive = 1 "TRUE: velocity and acceleration of the command by differences; FALSE: from the pins";']


def _function(made: Control, inputs: list[str]) -> list[str]:
    """Return the lines of the function that the thread calls."""
    name, derived, before = made.name, _derive(inputs), "inst->before"
    differences = [
        "        /* Exact for lines and parabolas: no lag. */",
        f"        const double speed = ((3.0 * command) - (4.0 * {before}[0]) + {before}[1]) / {literal(2.0 * made.period)};",
        f"        const double rate = (command - (2.0 * {before}[0]) + {before}[1]) / {literal(made.period**2)};",
        "        (void)speed; (void)rate;",
    ]
    rates = {"reference_velocity": "speed", "reference_acceleration": "rate"}
    plain = {field: f"*inst->{PINS[field]} / inst->scale" for field in inputs}
    plain |= {field: f"inst->derive ? {rates[field]} : ({plain[field]})" for field in rates if field in inputs}
    return [
        "#define FUNCTION(name) static void name(struct __comp_state *inst, long period)",
        "FUNCTION(_)",
        "{",
        f"    {name}_state *const state = ({name}_state *)(void *)inst->memory; /* numbers of type double alone */",
        f"    const {name}_parameters par = {{{', '.join(f'inst->{p.name}' for p in made.parameters.values()) or '0.0'}}};",
        "    const double command = *inst->command / inst->scale;",
        f"    const bool timely = fabs(((double)period * 1e-9) - {literal(made.period)}) <= {literal(0.01 * made.period)};",
        "    double output = 0.0;",
        f"    *inst->error = *inst->command - *inst->{PINS[made.feedback]};",
        "    if (!(*inst->enable && timely && (inst->running != 0))) {",
        f"        {name}_init(state, *inst->{PINS[made.feedback]} / inst->scale);",
        "        inst->before[0] = command;",
        "        inst->before[1] = command;",
        "    }",
        "    inst->running = (*inst->enable && timely) ? 1 : 0;",
        "    if (inst->running != 0) {",
        *(differences if derived else []),
        f"        const {name}_inputs in = {{",
        *(f"            {plain[field]}," for field in inputs),
        "        };",
        f"        output = {name}_step(state, &par, &in);",
        "    }",
        "    inst->before[1] = inst->before[0];",
        "    inst->before[0] = command;",
        "    *inst->fault = *inst->enable && !(timely && isfinite(output));",
        "    *inst->output = isfinite(output) ? output : 0.0;",
        "}",
    ]


def lines_of(made: Control, joint: int) -> str:
    """Return the HAL lines that load the component in place of the `pid` of a joint."""
    axis = made.name.removeprefix("axis_")
    pin, words = made.name.replace("_", "-"), [field.name for field in made.inputs.values()]
    measured = [PINS[name].replace("_", "-") for name in dict.fromkeys([made.feedback, *words]) if not name.startswith("reference")]
    signals = {"feedback": f"{axis}-pos-fb"}
    return "\n".join(
        [
            *(f"# {note}" for note in made.notes),
            "#",
            f"# Build once:  halcompile --install {made.name}.comp",
            f"# Then write these lines in place of those of pid. {axis}-pos-fb and {axis}-output stand for your signals.",
            f"loadrt {made.name}",
            f"addf {pin} servo-thread               # after motion-controller, where pid was",
            f"setp {pin}.scale 1000                 # machine units in a metre: 1000 for mm",
            f"net {axis}-pos-cmd joint.{joint}.motor-pos-cmd => {pin}.command",
            *(f"net {signals.get(name, f'{axis}-{name}')} => {pin}.{name}" for name in measured),
            f"net {axis}-enable joint.{joint}.amp-enable-out => {pin}.enable",
            f"net {axis}-output {pin}.output           # [{made.output.unit}]",
            "",
        ]
    )


def _meaning(name: str) -> str:
    rate = {"velocity": " for each second", "acceleration": " for each second squared"}.get(name.rpartition("_")[2], "")
    what = "reference" if name.startswith("reference") else "measured at the motor" if name.startswith("motor") else "measured"
    return f"{what} [machine units{rate}]"
