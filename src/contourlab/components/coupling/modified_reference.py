"""Coupling by the modified reference."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import lincomb


class ModifiedReference(Component):
    """r' = (1 - lambda) r(theta) + lambda r(theta_hat): the axes follow a point between the leading one and the nearest one.

    Since r' - p = (1 - lambda)(r - p) + lambda (r(theta_hat) - p), the error across the path keeps its gain and the error along it is
    weighted by 1 - lambda: contouring comes before keeping up. Raise lambda together with the gains; on its own it makes the tool lag.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section II and Fig 3.
    """

    family = "coupling"
    kind = "modified-reference"
    calibrated = ("weight",)
    example = {"weight": 0.75}
    reference = "Ghaffari & Ulsoy, section II"
    inputs = (Port("reference", -1), Port("position", -1), Port("foot_position", -1), Port("error_vector", -1))
    outputs = (Port("modified_reference", -1),)

    weight: float = param(default=0.75, minimum=0.0, maximum=0.99, doc="lambda: 0 follows the leading point, towards 1 the nearest one")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (lincomb(1.0 - par.weight, inp.reference, par.weight, inp.foot_position),)
