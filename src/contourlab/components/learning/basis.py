"""Learning of a few feedforward gains instead of a table."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param
from contourlab.components.learning.law import LearningLaw, LearningProblem, TrialRecord


class BasisFunctions(LearningLaw):
    """Learn three gains of each axis: its table is u = k_v r_v + k_a r_a + k_f tanh(r_v/v_e), a combination of basis functions.

    Notes
    -----
    With Psi the functions as columns and G the model from table to position, the gains theta change after a trial with the error e by

        delta = alpha arg min |e - G Psi delta|^2.

    An error that the functions cannot cause stays. In return noise and model errors cannot grow at high frequencies, and the gains hold for
    any motion: `contourlab learn` prints them as a feedforward `inverse-dynamics`. If the inverse of the axis is a combination of the
    functions and the model is exact, one trial removes the error, on any reference; a model G with the gain g times the true one leaves
    1 - alpha/g of it. Gains that the motion cannot tell apart come out smallest: let every axis reverse and change its speed.

    References
    ----------
    Van de Wijdeven & Bosgra, "Using basis functions in iterative learning control: analysis and design theory", Int. J. Control 83 (2010);
    Bolder & Oomen, "Rational basis functions in iterative learning control", IEEE Trans. Control Systems Technology 23 (2015): derivatives
    of the reference as functions, so that what is learned extrapolates to other references. On learning less than a table: Pipeleers &
    Moore, "Reduced-order iterative learning control and a design strategy for optimal performance tradeoffs", IEEE Trans. Automatic Control
    57 (2012), reference 11 of Gecer Ulu et al.
    """

    kind = "basis-functions"
    example = {"gain": 0.8, "smoothing_velocity": 5e-3}
    without_effect = ("target",)  # the model contains the target
    reference = "van de Wijdeven & Bosgra 2010"

    gain: float = param(default=1.0, minimum=0.0, maximum=1.0, exclusive=True, doc="share of the change in each trial, alpha")
    smoothing_velocity: float = param(
        default=3e-4, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which the friction changes its sign, v_e"
    )

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        functions = self.functions(problem)
        images = [problem.model.forward(function) for function in functions]
        gains = _fitted(functions, table) + self.gain * _fitted(images, trial.tracking_error)
        return np.asarray(sum(gain * function for gain, function in zip(gains, functions, strict=True)))

    def gains(self, table: Array, problem: LearningProblem) -> list[dict[str, float]]:
        """Return the gains of each axis that make up a table (n_sample, n_axis), as parameters of `inverse-dynamics`."""
        names = ("velocity_gain", "acceleration_gain", "friction")
        fitted = _fitted(self.functions(problem), table).T.tolist()
        return [dict(zip(names, gains, strict=True), smoothing_velocity=self.smoothing_velocity) for gains in fitted]

    def functions(self, problem: LearningProblem) -> tuple[Array, Array, Array]:
        """Return the functions, (n_sample, n_axis) each."""
        velocity, acceleration = problem.motion()
        return velocity, acceleration, np.tanh(velocity / self.smoothing_velocity)


def _fitted(functions: list[Array] | tuple[Array, ...], signals: Array) -> Array:
    """Return the coefficients (n_function, n_axis) with which functions fit signals (n_sample, n_axis); the smallest if not unique."""
    coefficients = np.zeros((len(functions), signals.shape[1]))
    for j in range(signals.shape[1]):
        columns = np.column_stack([function[:, j] for function in functions])
        size = np.sqrt((columns**2).sum(axis=0))
        size[size == 0.0] = 1.0
        coefficients[:, j] = np.linalg.lstsq(columns / size, signals[:, j], rcond=1e-6)[0] / size
    return coefficients
