"""Cross-coupled learning: from the errors of the axes and from the contour error."""

from __future__ import annotations

from contourlab.components.contract import param
from contourlab.components.learning.error_law import ErrorLaw
from contourlab.components.learning.law import Array, LearningProblem, TrialRecord


class CrossCoupledLearning(ErrorLaw):
    """u <- Q (u + L e + L_c eps): the tracking error e and the contour error eps, the vector from the tool to the path.

    In the plane eps = (-C_x, C_y) eps with the coupling gains of the contour, u_x <- Q (u_x + L_x e_x - C_x L_c eps) and
    u_y <- Q (u_y + L_y e_y + C_y L_c eps); as a vector it is the same in any number of axes. Across the path both gains act, along it only
    L: with matched axes the deviation across the path shrinks by Q (1 - (L + L_c) G) from trial to trial.

    References
    ----------
    Barton & Alleyne, "A cross-coupled iterative learning control design for precision motion control", IEEE Trans. Control Systems
    Technology 16 (2008).
    """

    kind = "cross-coupled"
    example = {"gain": 20.0, "contour_gain": 30.0, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Barton & Alleyne 2008"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="L: command for a tracking error")
    contour_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="L_c: command for a contour error")

    @property
    def needs_contour_error(self) -> bool:
        return True

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        contour = trial.contour_error
        assert contour is not None  # asked for above
        return self.gain * trial.tracking_error + self.contour_gain * contour
