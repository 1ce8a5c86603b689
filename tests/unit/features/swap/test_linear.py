"""Statements about linear designs of a swap."""

from __future__ import annotations

import numpy as np

from contourlab.analysis.linear.modular_design import GAINS, LinearAxis, direct_design, three_step_design
from contourlab.features.swap.linear import LinearSwap


def test_a_method_that_loses_more_with_more_local_gains_is_not_called_optimal() -> None:
    """Raw drives of axes 1 and 2 of the stage: by three steps, local position loses more than nothing local; by `direct` it never does."""
    axes = (LinearAxis(1687.0, 10.0), LinearAxis(646.0, 6.44))
    sets = ((), *((gain,) for gain in GAINS))
    found = [
        LinearSwap("1", "raw drive", ("a", "b"), axes, np.ones((2, 2)), tuple(method(axes, one) for one in sets))
        for method in (three_step_design, direct_design)
    ]
    assert [(design.local, fewer.local) for design, fewer in found[0].not_optimal] == [(("position",), ())]
    (more,) = found[0].findings
    assert more.code == "CL718" and more.values == {"method": "three-step", "more": ("position",), "fewer": ("nothing",)}
    assert found[1].findings == ()
