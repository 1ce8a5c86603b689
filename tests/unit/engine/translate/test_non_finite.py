"""Every primitive with NaN, infinities, and indices outside: plain Python, one variant, lanes, C99 and Structured Text alike."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from structured_text import FunctionBlock
from tests.unit.engine.translate.test_production import PERIOD, TABLE, WIDTHS, run, schedule_of

from contourlab.engine.runner import CompiledGroup, InterpretedGroup
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.engine.translate import c99, structured_text
from contourlab.engine.translate.control import Field, control_of
from contourlab.engine.translate.step_graph import graph_of
from contourlab.primitives import (
    clip,
    copysign,
    cos,
    delayed,
    exp,
    fabs,
    floor,
    log,
    lookup,
    maximum,
    minimum,
    normal,
    rint,
    sin,
    sqrt,
    tanh,
    uniform,
)

NAN, INF = math.nan, math.inf
VALUES = (NAN, INF, -INF, 0.0, -0.0, -1.0, -0.5, 1.5, 14.9, 15.0, 15.9, 16.0, 1e6, -1e30, -700.0, 709.0, 800.0)
BEYOND = (NAN, INF, -INF, -1.0, -2.0, 16.0, 17.0, 1e9, 1e19, 1e300, -1e9, -1e300)
FED = [(a, b) for a in (*VALUES, *BEYOND) for b in VALUES]
PRIMITIVES: dict[str, Callable[..., Any]] = {
    "exp": lambda a, b, par, clock: exp(a),
    "log": lambda a, b, par, clock: log(a),
    "tanh": lambda a, b, par, clock: tanh(a),
    "sin": lambda a, b, par, clock: sin(clip(a, -1e6, 1e6) if fabs(a) < INF else a),
    "cos": lambda a, b, par, clock: cos(clip(a, -1e6, 1e6) if fabs(a) < INF else a),
    "sqrt": lambda a, b, par, clock: sqrt(a),
    "sqrt of a constant": lambda a, b, par, clock: sqrt(-1.0) + a,
    "fabs": lambda a, b, par, clock: fabs(a),
    "floor": lambda a, b, par, clock: floor(a),
    "rint": lambda a, b, par, clock: rint(a),
    "copysign": lambda a, b, par, clock: copysign(a, b),
    "copysign of a constant": lambda a, b, par, clock: copysign(1.0, a),
    "minimum": lambda a, b, par, clock: minimum(a, b),
    "maximum": lambda a, b, par, clock: maximum(a, b),
    "minimum with a constant": lambda a, b, par, clock: minimum(a, 2.0) + minimum(2.0, a),
    "maximum with zero": lambda a, b, par, clock: copysign(1.0, maximum(a, 0.0)) + copysign(0.5, maximum(-0.0, a)),
    "clip": lambda a, b, par, clock: clip(a, -2.0, b),
    "lookup": lambda a, b, par, clock: lookup(par.table, a),
    "delayed": lambda a, b, par, clock: delayed(par.ring, clock, floor(a)),
    "uniform": lambda a, b, par, clock: uniform(3.0, a, b),
    "normal": lambda a, b, par, clock: normal(a, clock.k),
}  # fmt: skip
OF_BOTH = ("copysign", "minimum", "maximum", "uniform")


def same(found: Any, wanted: Any, name: str = "") -> None:
    """Polynomials and the mathematical library differ in their last digits; what is not finite, and signs, may not."""
    np.testing.assert_allclose(found, wanted, rtol=1e-14, atol=2e-16, equal_nan=True, err_msg=name)
    finite = np.isfinite(wanted) & (np.abs(wanted) != 0.0)
    np.testing.assert_array_equal(np.signbit(found)[finite], np.signbit(wanted)[finite], err_msg=name)


@pytest.mark.parametrize("name", PRIMITIVES)
def test_a_nan_stays_a_nan(name: str) -> None:
    schedule = schedule_of(PRIMITIVES[name])
    plain = run(schedule, FED, 1, InterpretedGroup)[:, 0]
    a, b = np.array(FED).T
    assert np.isnan(plain[np.isnan(a)]).all()
    if name in OF_BOTH:
        assert np.isnan(plain[np.isnan(b)]).all()
    for width in WIDTHS:
        same(run(schedule, FED, width)[:, width - 1], plain)


def test_arguments_without_a_result_give_nan_and_the_ends_give_the_limits() -> None:
    assert math.isnan(sqrt(-1.0)) and math.isnan(log(-1.0)) and math.isnan(sin(INF)) and math.isnan(cos(-INF))
    assert (log(0.0), log(INF), sqrt(INF), tanh(-INF), exp(-INF)) == (-INF, INF, INF, -1.0, 0.0)
    assert exp(INF) == exp(709.0) == math.exp(709.0)
    assert (floor(-INF), rint(INF), clip(INF, -1.0, 2.0), clip(-INF, -1.0, 2.0)) == (-INF, INF, 2.0, -1.0)


@pytest.mark.parametrize("width", WIDTHS)
def test_an_index_outside_of_a_table_gives_nan(width: int) -> None:
    schedule = schedule_of(lambda a, b, par, clock: lookup(par.table, a))
    assert np.isnan(run(schedule, [(a, 0.0) for a in BEYOND], width)).all()
    inside = [(0.0, 0.0), (-0.0, 0.0), (-0.5, 0.0), (0.9, 0.0), (1.0, 0.0), (15.0, 0.0), (15.99, 0.0)]
    assert run(schedule, inside, width)[:, -1].tolist() == [0.0, 0.0, 0.0, 0.0, 1.0, 15.0, 15.0]
    constant = schedule_of(lambda a, b, par, clock: lookup(par.table, 16.0))
    assert np.isnan(run(constant, [(0.0, 0.0)], width)).all()


@pytest.mark.parametrize("width", WIDTHS)
def test_a_delay_beyond_the_past_that_is_kept_gives_nan(width: int) -> None:
    schedule = schedule_of(lambda a, b, par, clock: delayed(par.ring, clock, b))
    fed = [(float(k), n) for k, n in enumerate([0.0, 1.0, 2.0, 7.0, 7.0, 7.0, 7.0, 7.0, 8.0, -1.0, NAN, INF, 1e300, 0.0])]
    np.testing.assert_array_equal(run(schedule, fed, width)[:, -1], [0, 0, 0, 0, 0, 0, 0, 0, NAN, NAN, NAN, NAN, NAN, 13])


@pytest.mark.parametrize("width", WIDTHS)
def test_each_table_has_its_own_size_and_each_lane_its_own_index(width: int) -> None:
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (lookup(par.short, par.i), lookup(par.long, par.i))

    made = Step("made", step, ("i",), ("short", "long"), outputs=(Port("a"), Port("b")))
    index = np.arange(-2.0, width - 2.0) if width > 1 else np.array([3.0])
    schedule = Schedule((Node("s", made, {}, {"i": index}, {"short": np.arange(3.0), "long": 10.0 + np.arange(20.0)}),), (), PERIOD, 1)
    found = CompiledGroup(schedule, width, slice(0, width)).run(np.empty((1, 0)), [0, 1])[0]
    np.testing.assert_array_equal(found[0], np.where((index >= 0) & (index < 3), index, NAN))
    np.testing.assert_array_equal(found[1], np.where((index >= 0) & (index < 20), 10.0 + index, NAN))


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_c99_gives_what_plain_python_gives(tmp_path: Path) -> None:
    """With a trap for undefined behaviour, such as a NaN that becomes a whole number."""
    schedules = [schedule_of(primitive) for primitive in PRIMITIVES.values()]
    rows = ", ".join(f"{{{c99.literal(a)}, {c99.literal(b)}}}" for a, b in FED)
    files = [f"step{n}.c" for n in range(len(schedules))]
    for n, (file, schedule) in enumerate(zip(files, schedules, strict=True)):
        run_it = f"""
#include <stdio.h>
void run{n}(void)
{{
    static const double table[] = {{{", ".join(map(repr, TABLE.tolist()))}}}, fed[][2] = {{{rows}}};
    const double *const tables[] = {{table}};
    const int64_t sizes[] = {{{len(TABLE)}}};
    double ring[8] = {{0.0}}, none[1], out[1];
    for (int k = 0; k < {len(FED)}; ++k) {{
        ring[k & 7] = fed[k][0];
        step{n}(none, none, fed[k], k, k * {PERIOD!r}, {PERIOD!r}, tables, sizes, ring, 7, none, out);
        printf("%a\\n", out[0]);
    }}
}}
"""
        (tmp_path / file).write_text(c99.source_of(graph_of(schedule.nodes[0].step), f"step{n}") + run_it)
    calls = [f"run{n}();" for n in range(len(files))]
    declared = [f"void run{n}(void);" for n in range(len(files))]
    (tmp_path / "main.c").write_text("\n".join([*declared, "int main(void) {", *calls, "return 0; }"]))
    flags = ["-std=c99", "-O1", "-ffp-contract=off", "-fsanitize=undefined,float-cast-overflow", "-fsanitize-undefined-trap-on-error"]
    subprocess.run(["gcc", *flags, "-o", "steps", "main.c", *files, "-lm"], cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "steps"], capture_output=True, text=True, check=True)
    found = [float.fromhex(line) if "nan" not in line else NAN for line in done.stdout.split()]
    for name, schedule, of_one in zip(PRIMITIVES, schedules, np.reshape(found, (len(schedules), len(FED))), strict=True):
        same(of_one, run(schedule, FED, 1, InterpretedGroup)[:, 0], name)


@pytest.mark.parametrize("form", [lambda u, par, clock: lookup(par.table, u), lambda u, par, clock: delayed(par.ring, clock, floor(u))])
def test_structured_text_gives_what_plain_python_gives(form: Callable[..., Any], tmp_path: Path) -> None:
    pytest.importorskip("blark")

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (form(inp.u, par, clock),)

    made = Step("made", step, (), ("table",), "u", inputs=(Port("u"),), outputs=(Port("y"),))
    schedule = Schedule((Node("x.s", made, {"u": "in.u"}, {}, {"table": TABLE}, ring_length=8),), (Port("u"),), PERIOD, 1)
    group = CompiledGroup(schedule, 1, slice(0, 1))
    rest = group.memory[:, 0].copy()
    control = control_of(
        schedule, group.places, rest, np.zeros_like(rest), output="x.s.y", command=Field("command"),
        inputs={"u": Field("u")}, parameters={}, constants={}, name="made", notes=("a note",),
    )  # fmt: skip
    (tmp_path / "made.st").write_text(structured_text.plain(control))
    block = FunctionBlock(tmp_path / "made.st")
    values = [0.0, 0.9, 1.5, 2.0, 6.7, 15.0, 15.9, *BEYOND, 3.0, 7.0]
    found = [block(enable=True, u=value) for value in values]
    np.testing.assert_array_equal(found, run(schedule, [(value,) for value in values], 1, InterpretedGroup)[:, 0])


def test_portable_assembly_of_a_gpu_loads_from_inside_only() -> None:
    from contourlab.engine.translate import llvm_ir, maths, step_graph, tick_loop

    schedule = schedule_of(lambda a, b, par, clock: lookup(par.table, a))
    group = CompiledGroup(schedule, 64, slice(0, 64))
    places = step_graph.Rows(group.places.states, group.places.parameters)
    made = step_graph.tick_graph(schedule, places, [schedule.n_row - 1], maths.LANES)
    source = tick_loop.source_of(made, 1, 64, gpu=True)
    (index,) = [line.split()[4] for line in source.splitlines() if "fptosi" in line]
    assert any(line.split()[:3] == [index, "=", "select"] for line in source.splitlines())
    assert ".entry run" in llvm_ir.assembly(source, "nvptx64-nvidia-cuda", "sm_60")
