"""Random steps: machine code as users run it computes the bits of its graph; without contraction and in C, the bits of plain Python."""

from __future__ import annotations

import os
import random
import shutil
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from graph_oracle import Bounded, Oracle, UnsureError
from step_programs import TABLE, Writer, schedule_of, step_of
from translated_group import TranslatedGroup, in_c

from contourlab.arrays import Array
from contourlab.engine.gpu import gpu_of_process
from contourlab.engine.runner import CompiledGroup, GpuGroup, Group, InterpretedGroup
from contourlab.engine.step import Schedule, Step
from contourlab.engine.translate import tick_loop
from contourlab.engine.translate.maths import EXACT, LANES, SINGLE
from contourlab.engine.translate.step_graph import Rows, TickGraph, graph_of, tick_graph
from contourlab.errors import EngineError
from contourlab.native import llvm

N_LANE, TICKS, FIRST, PROGRAMS = 32, 3, 4711, 8
MANY = int(os.environ.get("CONTOURLAB_RANDOM_PROGRAMS", "64"))
"""Programs that the slow tests try; a block of eight takes two seconds. Each week the workflow tries 3,200."""
IN_C = 24
"""Programs that are compiled together as C."""
CHECKED = (0, 7, 18, 31)
"""Lanes that are compared with the slow oracles."""


@dataclass
class Case:
    """A random step, what is fed to it, what plain Python computes: arrays (n_tick, lanes), and the graphs and loops made of it once."""

    seed: int
    step: Step
    schedule: Schedule
    fed: Array
    plain: Array
    graphs: dict[Any, TickGraph] = field(default_factory=dict)
    loops: dict[int, Any] = field(default_factory=dict)

    def graph(self, primitives: Any, contract: bool = True) -> TickGraph:
        """Return the graph of the tick loop, which is the same for groups of any width."""
        kind = id(primitives), contract
        if kind not in self.graphs:
            places, rows = Group(self.schedule, 1, slice(0, 1)).places, (self.schedule.row("s.y"),)
            places = Rows(places.states, places.parameters)
            self.graphs[kind] = tick_graph(self.schedule, places, rows, primitives, contract=contract)
        return self.graphs[kind]

    def run(self, group: Group) -> Array:
        group.tick = FIRST
        return group.run(self.fed, [self.schedule.row("s.y")])[:, 0]


class ExactGroup(CompiledGroup):
    """Machine code of a case without contraction."""

    def __init__(self, case: Case, width: int, lanes: slice) -> None:
        super().__init__(case.schedule, width, lanes)
        if width not in case.loops:
            code = llvm.object_code(tick_loop.source_of(case.graph(EXACT, contract=False), min(width, tick_loop.VECTOR), width))
            case.loops[width] = llvm.loaded(code, "run", tick_loop.SIGNATURE)
        self.loops[(self.schedule.row("s.y"),)] = case.loops[width]


def assert_bits(found: Any, wanted: Any) -> None:
    found, wanted = np.asarray(found), np.asarray(wanted)
    np.testing.assert_array_equal(found, wanted)
    sound = ~np.isnan(wanted)  # the sign of a NaN depends on the processor
    np.testing.assert_array_equal(np.signbit(found)[sound], np.signbit(wanted)[sound])


def cases_of(seeds: range, folder: Path) -> list[Case]:
    """Return the programs that can be translated."""
    made = []
    for seed in seeds:
        step = step_of(folder / f"step_{seed}.py", Writer(seed).program())
        schedule, draw = schedule_of(step, seed, N_LANE), random.Random(seed)
        fed = np.array([[draw.choice([0.0, -0.0, 2.0, draw.gauss(0.0, 2.0)])] for _ in range(TICKS)])
        case = Case(seed, step, schedule, fed, np.empty(0))
        try:
            case.graph(EXACT, contract=False)
        except EngineError as refusal:  # a name is a truth value before a loop and a number in it
            assert "begin with a number" in str(refusal)
            continue
        case.plain = case.run(InterpretedGroup(schedule, N_LANE, slice(0, N_LANE)))
        made.append(case)
    assert len(made) > len(seeds) // 2
    return made


def oracle_runs(case: Case, kind: type[Oracle], group: CompiledGroup, primitives: Any, lane: int, ticks: int = TICKS) -> list[Any]:
    """Return what an oracle of the graph as compiled logs for a lane of a group that has not run."""
    rings = {1: (group.places.rings[0], len(group.rings[0]))}
    oracle = kind(case.graph(primitives), group.memory[:, lane].tolist(), [TABLE], rings, case.schedule.period)
    return [oracle.tick(FIRST + k, fed)[0] for k, fed in enumerate(case.fed[:ticks].tolist())]  # floats, which overflow in silence


def check_without_contraction(case: Case) -> None:
    """One variant calls the library that Python calls. Lanes have no library."""
    for lane in CHECKED:
        assert_bits(case.run(ExactGroup(case, 1, slice(lane, lane + 1)))[:, 0], case.plain[:, lane])
    if case.seed % 3 < 2:
        assert_bits(case.run(ExactGroup(case, N_LANE, slice(0, N_LANE))), case.plain)


def check_production(case: Case) -> int:
    """Compare with the oracle bit for bit, and over one tick with plain Python; return how many lanes no rounding may turn."""
    together = CompiledGroup(case.schedule, N_LANE, slice(0, N_LANE))
    wanted = {lane: oracle_runs(case, Oracle, together, LANES, lane) for lane in CHECKED}
    in_lanes, sure = case.run(together), 0
    for lane in CHECKED:
        group = CompiledGroup(case.schedule, 1, slice(lane, lane + 1))
        memory = group.memory.copy()
        of_group = oracle_runs(case, Oracle, group, SINGLE, 0)
        alone = case.run(group)[:, 0]
        assert_bits(in_lanes[:, lane], wanted[lane])
        assert_bits(alone, of_group)
        group.memory[:] = memory
        try:
            ((value, off),) = oracle_runs(case, Bounded, group, EXACT, 0, 1)
        except UnsureError:
            continue
        sure += 1
        for found in (alone[0], in_lanes[0, lane]):
            if off == 0.0:
                assert_bits(found, case.plain[0, lane])
            else:
                assert abs(found - case.plain[0, lane]) <= 2.0 * off, (found, value, off, lane)
    return sure


def check_node_by_node(case: Case) -> None:
    """A node called alone has the bits of the fused loop."""
    apart = TranslatedGroup(case.schedule, graph=partial(graph_of, contract=True, primitives=SINGLE))
    assert_bits(case.run(CompiledGroup(case.schedule, 1, slice(0, 1))), case.run(apart))


@pytest.mark.parametrize("first", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(PROGRAMS, MANY, PROGRAMS))])
def test_random_steps_compute_the_same_bits(first: int, tmp_path: Path) -> None:
    cases = cases_of(range(first, first + PROGRAMS), tmp_path)
    sure = 0
    for case in cases:
        check_without_contraction(case)
        sure += check_production(case)
        check_node_by_node(case)
    assert sure > len(cases) * len(CHECKED) / 4


@pytest.mark.parametrize("first", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(PROGRAMS, MANY // 8, PROGRAMS))])
def test_random_steps_have_the_bits_of_lanes_on_a_gpu(a_gpu: None, first: int, tmp_path: Path) -> None:
    for case in cases_of(range(first, first + PROGRAMS), tmp_path):
        lanes = case.run(CompiledGroup(case.schedule, N_LANE, slice(0, N_LANE)))
        assert_bits(case.run(GpuGroup(case.schedule, 64, slice(0, N_LANE), gpu_of_process()))[:, :N_LANE], lanes)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
@pytest.mark.parametrize("first", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(IN_C, MANY, IN_C))])
def test_random_steps_in_c_compute_the_bits_of_plain_python(first: int, tmp_path: Path) -> None:
    cases = cases_of(range(first, first + IN_C), tmp_path)
    graphs = {case.step: graph_of(case.step) for case in cases}
    make = in_c([*graphs.values()], tmp_path, "-O1")
    for case in cases:
        assert_bits(case.run(TranslatedGroup(case.schedule, make, graphs.__getitem__))[:, 0], case.plain[:, 0])
