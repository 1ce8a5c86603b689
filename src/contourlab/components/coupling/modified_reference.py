"""Couplings that modify the reference of the axes."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port, ports
from contourlab.primitives import add, lincomb, sub


class _Modified(Component):
    family = "coupling"
    calibrated = ("weight",)
    example = {"weight": 0.75}
    inputs = ports("reference", "position", "foot_position", "error_vector", size=-1)
    outputs = (Port("modified_reference", -1),)

    weight: float = param(default=0.75, minimum=0.0, maximum=0.99, doc="lambda: weight of the contour error against the tracking error")


class ModifiedReference(_Modified):
    """r' = (1 - lambda) r(theta) + lambda r(theta_hat): the axes follow a point between reference and foot point.

    Since r' - p = (1 - lambda)(r - p) + lambda (r(theta_hat) - p), the error across the path keeps its gain and the error along it is
    weighted by 1 - lambda: contouring has priority over progress. Raise lambda together with the gains; alone it makes the tool lag.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section II and Fig 3.
    """

    kind = "modified-reference"
    reference = "Ghaffari & Ulsoy, section II"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (lincomb(1.0 - par.weight, inp.reference, par.weight, inp.foot_position),)


class ModifiedError(_Modified):
    """e' = (1 - lambda)(r - p) + lambda e_n, with e_n the contour-error vector, in place of each axis' own error.

    It is the modified reference with the projection on the normal in place of the vector to the foot point: the two are equal once the
    estimator has converged. The axes receive it as the reference p + e'.

    References
    ----------
    Ghaffari & Ulsoy, "Dynamic contour error estimation and feedback modification for high-precision contouring", IEEE/ASME Transactions on
    Mechatronics 21 (2016).
    """

    kind = "modified-error"
    reference = "Ghaffari & Ulsoy 2016"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (add(inp.position, lincomb(1.0 - par.weight, sub(inp.reference, inp.position), par.weight, inp.error_vector)),)
