"""Learning laws: the record of a trial, the model of the machine, the interface of a law, and the laws."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex
from contourlab.components.contract import Component, param, text_param
from contourlab.errors import ComponentError, ParameterError


@dataclass(frozen=True, eq=False)
class TrialRecord:
    """Record of a trial, as a real controller has it.

    Attributes
    ----------
    tracking_error : ndarray (n_sample, n_axis) [m]
        Reference minus measured position.
    feedback_command : ndarray (n_sample, n_axis) [command unit]
        Command of controllers and coupling due to errors: the command that the drive accepted, minus the learned table, minus the
        feedforward of the reference.
    excess : ndarray (n_sample, n_axis) [command unit]
        Part of the command beyond the drive's limit; zero where it did not saturate.
    contour_error : ndarray (n_sample, n_axis) [m] or None
        Vector from the measured tool position to the path; only for laws with `LearningLaw.needs_contour_error`.
    """

    tracking_error: Array
    feedback_command: Array
    excess: Array
    contour_error: Array | None = None


class InputModel:
    """Linear model of each axis from the learned input to the measured position: convolution with an impulse response, by FFT.

    Nothing wraps around: input and output have the length of a trial and are zero before it.

    Parameters
    ----------
    impulse : ndarray (n, n_axis) [m per unit of the input], n <= n_sample
        Position at sample i after an input of 1 at sample 0; zero from n on.
    n_sample : int
    """

    def __init__(self, impulse: Array, n_sample: int) -> None:
        from scipy.fft import next_fast_len, rfft

        self.impulse, self.n_sample = impulse[:n_sample], n_sample
        self.length = int(next_fast_len(n_sample + len(self.impulse) - 1, real=True))
        self.response: Complex = rfft(self.impulse, self.length, axis=0)

    def through(self, signal: Array, response: Complex | Array) -> Array:
        """Return a signal (n_sample, n_axis) filtered by a frequency response (as long as `self.response`)."""
        from scipy.fft import irfft, rfft

        # Contiguous columns: in sample order each transform would stride over the axes.
        columns = np.ascontiguousarray(signal.T)
        return np.asarray(irfft(rfft(columns, self.length) * response.T, self.length)[:, : self.n_sample].T)

    def forward(self, signal: Array) -> Array:
        """Return the positions G u (n_sample, n_axis) [m] that an input u (n_sample, n_axis) causes."""
        return self.through(signal, self.response)

    def adjoint(self, signal: Array) -> Array:
        """Return G' e (n_sample, n_axis), the transpose of `forward`, of errors e (n_sample, n_axis) [m]."""
        return self.through(signal, self.response.conj())


def _no_motion() -> tuple[Array, Array]:
    raise ComponentError("a law that learns gains of a whole motion has no frequency response")


@dataclass(frozen=True, eq=False)
class LearningProblem:
    """Data known before the first trial.

    Attributes
    ----------
    servo_period : float [s]
    tangent : ndarray (n_sample, n_axis) [m/m]
        Unit tangent of the path at the reference.
    impulses : callable
        Returns the impulse responses (m, n_axis) from the learned input to the position; called only by laws that use a model.
    motion : callable
        Returns velocity [m/s] and acceleration [m/s^2] of the reference, (n_sample, n_axis) each; called only by laws that use them.
        Raises `ComponentError` where there is no reference, as in an analysis by frequency.
    """

    servo_period: float
    tangent: Array
    impulses: Callable[[], Array]
    motion: Callable[[], tuple[Array, Array]] = _no_motion

    @cached_property
    def model(self) -> InputModel:
        """Model of the axes, computed once."""
        return InputModel(self.impulses(), len(self.tangent))

    def across(self, vectors: Array) -> Array:
        """Return the part of vectors (n_sample, n_axis) that is normal to the path, v - t (t.v)."""
        return np.asarray(vectors - self.tangent * (self.tangent * vectors).sum(axis=1, keepdims=True))


class LearningLaw(Component):
    """Base of all laws: a law computes the next table; this class prevents wind-up.

    Where the drive saturated, the table does not move further in that direction.
    """

    family: ClassVar[str] = "learning"

    target: str = text_param(default="command", choices=("command", "reference"), doc="what the table is added to")

    @property
    def needs_contour_error(self) -> bool:
        """Whether the law needs `TrialRecord.contour_error`."""
        return False

    def update(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the table of the next trial.

        Parameters
        ----------
        table : ndarray (n_sample, n_axis) [command unit, or m for the reference]
            The table of the trial.
        trial : TrialRecord
        problem : LearningProblem

        Returns
        -------
        ndarray (n_sample, n_axis)
            A new array.
        """
        wanted = self.revised(table, trial, problem)
        if not trial.excess.any():
            return wanted
        return np.asarray(np.where(trial.excess * (wanted - table) > 0.0, table, wanted))

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the next table (n_sample, n_axis) without protection against wind-up; arguments as in `update`."""
        raise NotImplementedError

    def passed(self, signal: Array, servo_period: float) -> Array:
        """Return a signal (n_sample, n_axis) after the filter of the law, if it has one."""
        return signal


def moving_average(signal: Array, half_width: int, passes: int = 1) -> Array:
    """Return the mean over 2 M + 1 samples around each one, `passes` times.

    Parameters
    ----------
    signal : ndarray (n_sample, n_axis)
    half_width : int, M >= 0
    passes : int, >= 0

    Notes
    -----
    H_M(w) = sin((2 M + 1) w T_s/2) / ((2 M + 1) sin(w T_s/2)).
    """
    from scipy.ndimage import uniform_filter1d

    for _ in range(passes):
        signal = uniform_filter1d(signal, 2 * half_width + 1, axis=0, mode="reflect")
    return signal


def advanced(signal: Array, samples: int) -> Array:
    """Return x(k + samples); zero beyond the end, so that nothing is learned from unknown samples."""
    if not samples:
        return signal
    later = np.zeros_like(signal)
    later[: max(len(signal) - samples, 0)] = signal[samples:]
    return later


def q_response(frequency: ArrayLike, bandwidth: float, order: float, servo_period: float) -> Array:
    """Return the gain (n,) of `q_filter` at frequencies (n,) [rad/s], from 0 to the Nyquist frequency."""
    w = np.asarray(frequency, dtype=float)
    if bandwidth * servo_period >= math.pi:
        return np.ones(w.shape)
    ratio = np.tan(np.minimum(0.5 * w * servo_period, 0.5 * math.pi)) / math.tan(0.5 * bandwidth * servo_period)
    # At the Nyquist frequency itself rounding decides the sign of the tangent.
    return np.asarray(1.0 / (1.0 + np.minimum(np.abs(ratio), 1e9) ** (2.0 * order)))


def q_filter(signal: Array, bandwidth: float, order: int, servo_period: float) -> Array:
    """Return a signal after a Butterworth low-pass run forwards and backwards, 1/(1 + (tan(w T_s/2)/tan(w_q T_s/2))^(2 order)).

    Parameters
    ----------
    signal : ndarray (n_sample, n_axis)
    bandwidth : float [rad/s], > 0
        w_q, where the gain is 1/2; no filter from the Nyquist frequency on.
    order : int, >= 1
    servo_period : float [s]

    Notes
    -----
    The gain is the squared magnitude of the sampled filter; for w far below the Nyquist frequency 1/(1 + (w/w_q)^(2 order)).
    """
    if bandwidth * servo_period >= math.pi:
        return signal
    from scipy.fft import dct, idct

    n = len(signal)
    gain = q_response(np.pi * np.arange(n) / (n * servo_period), bandwidth, order, servo_period)
    # Mirror images at both ends leave only cosines: the filter is this product, without padding.
    return np.asarray(idct(dct(np.ascontiguousarray(signal.T)) * gain).T)


class FilteredLaw(LearningLaw):
    """Base of laws with a Q-filter: u <- Q (u + addition), Q a Butterworth low-pass run forwards and backwards."""

    bandwidth: float = param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="w_q of the Q-filter; inf: no filter")
    order: float = param(default=2.0, minimum=1.0, maximum=8.0, whole=True, doc="of the Butterworth filter")

    def passed(self, signal: Array, servo_period: float) -> Array:
        return q_filter(signal, self.bandwidth, int(self.order), servo_period)


class ErrorLaw(FilteredLaw):
    """Base of laws that add gains times the errors `lead` later."""

    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="advance of the errors, in whole servo periods")
    stiffness: float = param(
        default=math.inf,
        unit="{command}/m",
        minimum=0.0,
        exclusive=True,
        display="{command}/mm",
        doc='divides the gains with target = "reference": command per metre of reference',
    )

    def check_values(self) -> None:
        if self.target == "reference" and math.isinf(self.stiffness):
            raise ParameterError("stiffness", "not given", 'given with target = "reference", because the gains are divided by it')

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the addition from a trial (n_sample, n_axis) [command unit], before lead and filter."""
        raise NotImplementedError

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        added = advanced(self.addition(trial, problem), round(self.lead / problem.servo_period))
        return self.passed(table + (1.0 if self.target == "command" else 1.0 / self.stiffness) * added, problem.servo_period)


class PType(ErrorLaw):
    """u <- Q (u + L e(k + lead)): the tracking error times a gain.

    With G from the learned table to the position, a trial multiplies the deviation from the limit by Q (1 - L G): convergence is monotonic
    if its magnitude is below 1 at all frequencies. Without Q, |1 - L G| > 1 beyond the frequency where the phase of G passes -90 degrees;
    set the Q-filter below it.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), eqs (6) and (17).
    """

    kind = "p-type"
    example = {"gain": 30.0, "bandwidth": 120.0, "lead": 2e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, exclusive=True, display="{command}/mm", doc="command per error, L")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        return self.gain * trial.tracking_error


class PDType(ErrorLaw):
    """u <- Q (u + L_p e + L_d e'): the tracking error and its derivative, by central differences.

    The derivative adds phase lead, so that it can learn up to higher frequencies than P-type. The rest is as for P-type.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), section "PD-type".
    """

    kind = "pd-type"
    example = {"gain": 30.0, "derivative_gain": 0.5, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per error, L_p")
    derivative_gain: float = param(unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="command per error rate, L_d")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        error = trial.tracking_error
        if len(error) < 2:
            return self.gain * error
        return self.gain * error + self.derivative_gain * np.asarray(np.gradient(error, problem.servo_period, axis=0))


class CrossCoupledLearning(ErrorLaw):
    """u <- Q (u + L e + L_c eps): the tracking error e and the contour error eps, the vector from the tool to the path.

    In the plane eps = (-C_x, C_y) eps with the coupling gains of the contour, u_x <- Q (u_x + L_x e_x - C_x L_c eps) and u_y <- Q
    (u_y + L_y e_y + C_y L_c eps); the vector form holds for any number of axes. Across the path both gains act, along it only L: with
    matched axes each trial multiplies the deviation across the path by Q (1 - (L + L_c) G).

    References
    ----------
    Barton & Alleyne, "A cross-coupled iterative learning control design for precision motion control", IEEE Trans. Control Systems
    Technology 16 (2008).
    """

    kind = "cross-coupled"
    example = {"gain": 20.0, "contour_gain": 30.0, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Barton & Alleyne 2008"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per tracking error, L")
    contour_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per contour error, L_c")

    @property
    def needs_contour_error(self) -> bool:
        return True

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        contour = trial.contour_error
        assert contour is not None  # see needs_contour_error
        return self.gain * trial.tracking_error + self.contour_gain * contour


class ZeroPhase(LearningLaw):
    """Add the feedback command, averaged over 2 M + 1 samples, to the feedforward: u_ff <- u_ff + gamma H_M u_fb (eq 9).

    With ``target = "reference"`` the tracking error is averaged instead. Let T be the closed loop from the learned table to the averaged
    signal, advanced by `lead`. A trial multiplies the deviation from the limit by 1 - gamma H_M T: learning converges if its magnitude is
    below 1 at all frequencies. H_M is negative beyond its first zero, at 1/((2 M + 1) T_s): there a single average slowly amplifies where
    Re T > 0; ``passes = 2`` squares it. Choose M so that the first zero lies below the frequency at which the phase of T is -90 degrees, or
    give a `lead` for the delay of the loop.

    Only the command that the drive accepted counts, so that the table of a saturating trial stays within reach of the drive. At the ends of
    a trial the mirror image of the feedback continues it. With a predictor the loop follows a position ahead of the measured one, and so
    does the table: use a law of the tracking error there.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eq (9), gamma = 0.2 and M = 11; Tan, Dou, Chen & Lee, IEEE Trans. Control Systems Technology 9 (2001).
    """

    kind = "zero-phase"
    example = {"gain": 0.2, "half_width": 11, "passes": 1, "lead": 2e-3}
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eq 9"

    gain: float = param(default=0.2, minimum=0.0, maximum=2.0, exclusive=True, doc="gamma", source="Gecer Ulu et al., section 3.1")
    half_width: float = param(
        default=11.0, minimum=0.0, maximum=1e6, whole=True, doc="M: mean over 2 M + 1 samples", source="Gecer Ulu et al., section 3.1"
    )
    passes: float = param(default=1.0, minimum=1.0, maximum=2.0, whole=True, doc="number of averagings")
    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="advance of the feedback, in whole servo periods")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        signal = trial.feedback_command if self.target == "command" else trial.tracking_error
        return table + self.gain * self.passed(advanced(signal, round(self.lead / problem.servo_period)), problem.servo_period)

    def passed(self, signal: Array, servo_period: float) -> Array:
        return moving_average(signal, int(self.half_width), int(self.passes))


class BasisFunctions(LearningLaw):
    """Learn three gains of each axis: its table is u = k_v r_v + k_a r_a + k_f tanh(r_v/v_e), a combination of basis functions.

    Notes
    -----
    Let the columns of Psi be the functions, and G the model from table to position. After a trial with the error e the gains change by

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
    reference = "van de Wijdeven & Bosgra 2010; Bolder & Oomen 2015"

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


class Equation(NamedTuple):
    """The equation (G' Q G + S + R) d = b and its preconditioner."""

    problem: LearningProblem
    model: InputModel
    tracking: float
    contour: float
    on_input: Array
    on_change: Array
    inverse: Array

    @classmethod
    def of(cls, problem: LearningProblem, tracking: float, contour: float, on_input: float, on_change: float) -> Equation:
        """Return the equation; the last two weights are relative to max |G|^2 of each axis."""
        model = problem.model
        square = np.abs(model.response) ** 2
        largest = square.max(axis=0)
        held = (on_input * largest, on_change * largest)
        # Mean part of each axis across the path, in place of its changing direction.
        across = 1.0 - (problem.tangent**2).mean(axis=0)
        return cls(problem, model, tracking, contour, *held, 1.0 / ((tracking + contour * across) * square + held[0] + held[1]))

    def weighted(self, error: Array) -> Array:
        """Return Q e. Gamma is a projection: Gamma' Gamma = Gamma."""
        return self.tracking * error + (self.contour * self.problem.across(error) if self.contour else 0.0)

    def __matmul__(self, change: Array) -> Array:
        return self.model.adjoint(self.weighted(self.model.forward(change))) + (self.on_input + self.on_change) * change

    def solved(self, right: Array, tolerance: float, iterations: int) -> Array:
        """Return d by preconditioned conjugate gradients, from zero, to a residual of `tolerance` times the right-hand side."""
        found, left = np.zeros_like(right), right.copy()
        enough = tolerance**2 * _dot(right, right)
        direction, product = np.zeros_like(right), 1.0
        for _ in range(iterations):
            if _dot(left, left) <= enough:
                break
            steep = self.model.through(left, self.inverse)
            product, before = _dot(left, steep), product
            direction = steep + (product / before) * direction
            image = self @ direction
            step = product / _dot(direction, image)
            found += step * direction
            left -= step * image
        return found


def _dot(one: Array, other: Array) -> float:
    # Not by a matrix library: these sums are short, and its threads cost more than they save.
    return float((one * other).sum())


class NormOptimal(LearningLaw):
    """The next table minimises a weighted sum of the predicted errors, the input and its change.

    J = |e|^2 q + |eps|^2 q_c + |u|^2 s + |u - u_before|^2 r, e = e_before - G (u - u_before), eps = Gamma e = e - t (t.e) across the path.
    The minimum solves (G' Q G + S + R) d = G' Q e - S u_before for the change d, Q = q + Gamma' q_c Gamma: with S = 0 the errors fall from
    trial to trial, to zero where G can cause them. A larger r slows learning and reduces the effect of noise.

    The weights have no unit: q and q_c for the errors, s and r relative to max |G|^2 of each axis. Conjugate gradients solve the equation,
    with G by FFT and the spectrum of each axis as preconditioner: memory and time grow with the number of samples, not with its square.

    References
    ----------
    Barton & Alleyne, "A norm optimal approach to time-varying ILC with application to a multi-axis robotic testbed", IEEE Trans. Control
    Systems Technology 19 (2011); Amann, Owens & Rogers, "Iterative learning control using optimal feedback and feedforward actions" (1996).
    """

    kind = "norm-optimal"
    example = {
        "tracking_weight": 1.0,
        "contour_weight": 2.0,
        "input_weight": 0.01,
        "change_weight": 0.2,
        "tolerance": 1e-4,
        "iterations": 7,
    }
    without_effect = ("target",)  # the model contains the target
    reference = "Barton & Alleyne 2011"

    tracking_weight: float = param(default=1.0, minimum=0.0, maximum=1e6, doc="weight of each axis' tracking error, q")
    contour_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="weight of the error across the path, q_c")
    input_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="weight of the table over max |G|^2, s")
    change_weight: float = param(default=0.01, minimum=1e-9, maximum=1e6, doc="weight of its change over max |G|^2, r")
    tolerance: float = param(default=1e-6, minimum=1e-14, maximum=0.5, doc="residual over right-hand side at which the solver stops")
    iterations: float = param(default=200.0, minimum=1.0, maximum=1e5, whole=True, doc="most conjugate-gradient steps")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        equation = Equation.of(problem, *(self.tracking_weight, self.contour_weight, self.input_weight, self.change_weight))
        right = equation.model.adjoint(equation.weighted(trial.tracking_error)) - equation.on_input * table
        return table + equation.solved(right, self.tolerance, int(self.iterations))


TOLERANCE, ITERATIONS = 1e-6, 20
"""The first step is exact between the ends of a trial; the others correct the ends."""


class PlantInversion(FilteredLaw):
    """u <- Q (u + alpha (G' G + rho max |G|^2)^-1 G' e): the inverse of the model G, regularised where G is small.

    With the true plant G_0 a trial multiplies the deviation from the limit by Q (1 - alpha |G|^2/(|G|^2 + rho max |G|^2) G_0/G): with an
    exact model one trial leaves 1 - alpha of the deviation where G is large. It diverges where the model's phase is off by more than
    90 degrees: Q must be small there. G is the linear model of each axis alone, without coupling.

    The inverse is that over the finite trial. An inverse by frequency alone would increase the last samples with every trial, because their
    effect lies beyond the end.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), "Plant inversion".
    """

    kind = "plant-inversion"
    example = {"gain": 0.7, "regularisation": 1e-4, "bandwidth": 200.0}
    without_effect = ("target",)  # the model contains the target
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(default=1.0, minimum=0.0, maximum=2.0, exclusive=True, doc="gain, alpha")
    regularisation: float = param(default=1e-6, minimum=0.0, maximum=1.0, exclusive=True, doc="rho, relative to max |G|^2")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        equation = Equation.of(problem, 1.0, 0.0, 0.0, self.regularisation)
        change = equation.solved(equation.model.adjoint(trial.tracking_error), TOLERANCE, ITERATIONS)
        return self.passed(table + self.gain * change, problem.servo_period)
