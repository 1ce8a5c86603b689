"""Coupling by the modified error."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import add, lincomb, sub


class ModifiedError(Component):
    """e' = (1 - lambda)(r - p) + lambda e_n, with e_n the contour-error vector, in place of each axis' own error.

    It is the modified reference with the projection on the normal in place of the vector to the foot point: the two are the same as far as
    the estimator has converged. It is handed to the axes as the reference p + e'.

    References
    ----------
    Ghaffari & Ulsoy, "Dynamic contour error estimation and feedback modification for high-precision contouring", IEEE/ASME Transactions on
    Mechatronics 21 (2016).
    """

    family = "coupling"
    kind = "modified-error"
    calibrated = ("weight",)
    example = {"weight": 0.75}
    reference = "Ghaffari & Ulsoy 2016"
    inputs = (Port("reference", -1), Port("position", -1), Port("foot_position", -1), Port("error_vector", -1))
    outputs = (Port("modified_reference", -1),)

    weight: float = param(default=0.75, minimum=0.0, maximum=0.99, doc="lambda: weight of the contour error against the tracking error")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        error = lincomb(1.0 - par.weight, sub(inp.reference, inp.position), par.weight, inp.error_vector)
        return (), (add(inp.position, error),)
