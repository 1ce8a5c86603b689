"""Every component: its translated step computes what plain Python computes, bit for bit."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from each import each
from translated_group import Maker, TranslatedGroup, in_c, in_machine_code

from contourlab.components.conformance import PERIOD, subject
from contourlab.components.contract import Component
from contourlab.components.mechanics.core import friction_prefix, link
from contourlab.components.registry import components
from contourlab.engine.runner import InterpretedGroup
from contourlab.engine.step import Node, Schedule, Step, rows
from contourlab.engine.translate.step_graph import StepGraph, graph_of
from contourlab.errors import ComponentError

KINDS = [kind for kind in components() if kind.family != "learning"]
PAIRS = [(plant, friction) for plant in components("plant") for friction in components("friction")]
TICKS = 150


def named(kind: type[Component]) -> str:
    return f"{kind.family}/{kind.kind}"


def alone(step: Step, values: dict[str, Any], tables: dict[str, Any], ring: int = 0, repeat: int = 1) -> Schedule:
    wires = {port.name: f"in.{port.name}" for port in step.inputs}
    return Schedule((Node("part", step, wires, values, tables, ring_length=ring, repeat=repeat),), step.inputs, PERIOD, 1)


def excitation(schedule: Schedule, scale: float) -> np.ndarray:
    channel, t = np.arange(rows(schedule.externals)), 0.05 * np.arange(TICKS)[:, None]
    waves: np.ndarray = scale * (np.sin((1.0 + 0.37 * channel) * t + channel) + 0.4 * np.sin((3.1 + 0.23 * channel) * t))
    return waves


def assert_same_bits(
    schedule: Schedule, *scales: float, make: Maker = in_machine_code, graph: Callable[[Step], StepGraph] = graph_of
) -> None:
    """Check that a schedule computes the same bits in both forms; its steps are translated once."""
    graph_once = cache(graph)
    for scale in scales:
        plain, translated = InterpretedGroup(schedule, 1, slice(0, 1)), TranslatedGroup(schedule, make, graph_once)
        fed = excitation(schedule, scale)
        logged = list(range(schedule.n_row))
        np.testing.assert_array_equal(translated.run(fed, logged), plain.run(fed, logged), err_msg=f"at {scale}")
        for one, other in zip(translated.state, plain.state, strict=True):
            np.testing.assert_array_equal(one, other, err_msg=f"at {scale}")


@pytest.mark.parametrize("kind", KINDS, ids=named)
def test_a_component_is_translated_bit_for_bit(kind: type[Component]) -> None:
    part = kind(**kind.example)
    step, values, tables = subject(part)
    assert_same_bits(alone(step, values, tables, part.ring_length(PERIOD), 3 if kind.family == "plant" else 1), 0.01, 1.0, 100.0)


@pytest.mark.slow
@pytest.mark.parametrize(("plant", "friction"), PAIRS, ids=[f"{plant.kind}, {friction.kind}" for plant, friction in PAIRS])
def test_every_plant_with_every_friction(plant: type[Component], friction: type[Component]) -> None:
    table, rubbing = plant(**plant.example), friction(**friction.example)
    try:
        step = link(table, rubbing)
    except ComponentError:
        pytest.skip("this plant does not take this friction")
    values = {f"{friction_prefix(table)}{row}": value for row, value in rubbing.block(PERIOD).items()}
    assert_same_bits(alone(step, {**table.block(PERIOD), **values}, table.table_values(), repeat=2), 3.0)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_c99_computes_the_same_bits(tmp_path: Path) -> None:
    schedules = {}
    for kind in KINDS:
        part = kind(**kind.example)
        schedules[kind] = alone(*subject(part), part.ring_length(PERIOD))
    graphs = {schedule.nodes[0].step: graph_of(schedule.nodes[0].step) for schedule in schedules.values()}
    make = in_c([*graphs.values()], tmp_path, "-O2")

    @each("kind", KINDS, named)
    def same_bits(kind: type[Component]) -> None:
        assert_same_bits(schedules[kind], 1.0, make=make, graph=graphs.__getitem__)

    same_bits()


@each("kind", KINDS, named)
def test_the_graph_stays_small(kind: type[Component]) -> None:
    """Loops stay loops: no step is written out into thousands of operations."""
    made = graph_of(subject(kind(**kind.example))[0])
    bank = made.step.bank
    assert sum(1 for _ in made.graph.top.every()) < 2000 * (bank.count if bank else 1)
