"""The fused loop against its steps called one by one: joining nodes changes no bit."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from translated_group import TranslatedGroup

import contourlab as cl
from contourlab.engine.runner import CompiledGroup
from contourlab.engine.step import rows
from contourlab.engine.translate.maths import LANES, SINGLE
from contourlab.engine.translate.step_graph import graph_of
from contourlab.loop.feeding import Feed
from contourlab.loop.template import build

QUICK = ["ghaffari/demo-stage", "gecer-ulu/contour", "emps/circle", "ubc/lead-lag"]
CASES = [*QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in ("backlash/part", "demo-part"))]
TICKS = 300


@pytest.mark.parametrize("name", CASES)
@pytest.mark.slow
def test_nodes_one_by_one_give_the_same_bits(name: str) -> None:
    case = cl.load_scenario(f"builtin:{name}").cases()[-1]
    feed = Feed(case.machine, case.controller, case.reference(), None, None)
    first, fed = feed.block(0, TICKS)
    loop = build(case.machine, case.controller, case.reference().path, first.position[0], float(first.arc_length[0]), fed=feed.names)
    schedule = loop.schedule
    signals = list(range(rows(schedule.externals), schedule.n_row))
    # One variant calls the mathematical library, lanes use polynomials.
    for width, maths in ((1, SINGLE), (32, LANES)):
        fused = CompiledGroup(schedule, width, slice(0, width))
        apart = TranslatedGroup(schedule, graph=partial(graph_of, contract=True, primitives=maths))
        found, wanted = fused.run(fed, signals), apart.run(fed, signals)
        np.testing.assert_array_equal(found, np.broadcast_to(wanted, found.shape), err_msg=case.name)
        for one, other in zip(fused.state, apart.state, strict=True):
            np.testing.assert_array_equal(one, np.broadcast_to(other, one.shape))
