"""A loop with backlash as matrices, and its limit cycles from the describing function.

The loop is linear except for the torque, which acts through a gap and a spring::

    x' = a x + e (r, r', r'') - b T,      theta_d = c x,      T = k dz(theta_d, h)

with h half of the gap and dz the dead zone. With shaft damping the torque is that of Nordin, Galic & Gutman: k (theta_d -+ h) + d theta_d'
in contact, which ends where this torque would change its sign; in the gap the twist of the shaft relaxes at the rate k/d. Units are
angles and torques, or lengths and forces.

The loop of a machine's axis joins the linear models of its components in continuous time. The hold of the servo loop and the delay of the
drive become one rational delay of second order (Pade): half a servo period plus the delay of the drive. A filtered difference gets the
bandwidth that gives it the delay of its sampled form. Friction, limits and quantisation are left out.

A limit cycle solves 1 + N(A, w) G(j w) = 0. N is the torque's first harmonic over a sinusoidal motor-load difference. Without shaft damping
it is that of a dead zone, N = k (1 - 2/pi (asin(h/A) + h/A sqrt(1 - (h/A)^2))). With it, contact begins where the motor meets the relaxing
shaft and ends where the torque falls to 0; in between the torque is a sine, and its harmonics are closed forms.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex, Flags
from contourlab.components.contract import Component, LinearModel, response_of
from contourlab.components.ideal import TrueVelocity
from contourlab.components.mechanics.propagator import low_pass_weight
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop.machine import Axis, AxisController

N_REFERENCE = 3
"""Reference, its velocity and its acceleration."""


def dead_zone(difference: ArrayLike, half_gap: float) -> Array:
    """Return how far a motor-load difference lies beyond the gap, with its sign: eq (4) of Shahin, ElMaraghy & ElBeheiry.

    >>> [float(value) for value in dead_zone([-3.0, 0.5, 1.5], 1.0)]
    [-2.0, 0.0, 0.5]
    """
    d = np.asarray(difference, dtype=float)
    return np.asarray(d - np.clip(d, -half_gap, half_gap))


@dataclass(frozen=True, eq=False)
class BacklashLoop:
    """A closed loop around a gap.

    Attributes
    ----------
    a : ndarray (n, n)
        Dynamics without torque: the gap mode.
    b : ndarray (n,)
        Input of the transmitted torque: x' = a x - b T.
    c : ndarray (n,)
        Motor-load difference theta_d = c x. c b = 0: a torque moves no position at once.
    stiffness : float, > 0
        Of the transmission, k.
    half_gap : float, > 0
        Half of the total gap, h.
    shaft_damping : float, >= 0
        d; 0 is the dead-zone model.
    e : ndarray (n, 3), optional
        Input of the reference, its velocity and its acceleration; zero by default.
    contact_a : ndarray (n, n), optional
        Dynamics without torque in contact, if the controller changes in the gap; `a` by default.
    contact_e : ndarray (n, 3), optional
        Input of the reference in contact; `e` by default.
    """

    a: Array
    b: Array
    c: Array
    stiffness: float
    half_gap: float
    shaft_damping: float = 0.0
    e: Array | None = None
    contact_a: Array | None = None
    contact_e: Array | None = None
    states: tuple[str, ...] = ()

    @property
    def n(self) -> int:
        """Number of states."""
        return len(self.b)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the states."""
        return self.states or tuple(f"state {i + 1}" for i in range(self.n))

    @property
    def reference_input(self) -> Array:
        """`e`, or zeros (n, 3)."""
        return np.zeros((self.n, N_REFERENCE)) if self.e is None else self.e

    @property
    def rate(self) -> Array:
        """Row of the velocity of the motor-load difference, theta_d' = c a x (n,)."""
        return np.asarray(self.c @ self.a)

    @property
    def torque_row(self) -> Array:
        """Row of the torque in contact, T = (k c + d c a) x -+ k h, without its constant (n,)."""
        return self.stiffness * self.c + self.shaft_damping * self.rate

    @property
    def gap_matrix(self) -> Array:
        """Dynamics in the gap (n, n)."""
        return self.a

    @property
    def contact_matrix(self) -> Array:
        """Dynamics in contact (n, n), about its point of rest."""
        return (self.a if self.contact_a is None else self.contact_a) - np.outer(self.b, self.torque_row)

    @cached_property
    def balance(self) -> Array:
        """Powers of 2 (n,), exact in floating point: divide the states by them to scale `a` and the contact matrix well."""
        from scipy.linalg import matrix_balance

        _, (scale, _) = matrix_balance(np.abs(self.gap_matrix) + np.abs(self.contact_matrix), permute=False, separate=True)
        return np.asarray(scale, dtype=float)

    def transfer(self, frequency: ArrayLike) -> Complex:
        """Return G(j w) = c (j w - a)^-1 b (n,), from the negative torque to the motor-load difference, at w (n,) [rad/s].

        Raises
        ------
        ParameterError
            If the controller changes with the mode: there is no single linear part.
        """
        self.require_one_controller("a transfer function")
        scale, w = self.balance, np.asarray(frequency, dtype=float)
        a, b, c = self.a * scale / scale[:, None], self.b / scale, self.c * scale
        return np.asarray(response_of(a, b[:, None], c[None, :], 0.0, 1j * w.ravel()).reshape(w.shape))

    def at(self, frequency: float) -> complex:
        """Return G(j w) at one frequency [rad/s]."""
        return complex(self.transfer(np.array([frequency]))[0])

    def require_one_controller(self, what: str) -> None:
        """Raise `ParameterError` if the controller changes with the mode."""
        if self.contact_a is not None and not np.array_equal(self.contact_a, self.a):
            raise ParameterError("contact_a", "another matrix than a", f"left out for {what}: it needs one linear part for gap and contact")


REFERENCE = ("reference", "reference_velocity", "reference_acceleration")
FREE = (*REFERENCE, "shaft")
"""Inputs of the loop: the reference, and the force of the shaft."""
PLANT_STATES = ("motor position", "motor velocity", "load position", "load velocity")


@dataclass(frozen=True)
class _Block:
    """A linear model, and the source of each input: ``"block.output"`` or a name of `FREE`; other inputs are zero."""

    name: str
    model: LinearModel
    wires: Mapping[str, str]


def axis_backlash_loop(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> BacklashLoop:
    """Return the loop around the gap of an axis, with lengths and forces at the table.

    Under a supervisor, `controller.controller` is the controller in contact, and the first of `controller.others` that in the gap.

    Parameters
    ----------
    axis : Axis
        Its plant is a two-inertia drive with backlash.
    servo_period : float [s], > 0
    carried_mass : float [kg]
        Mass of the axes that this one carries.

    Raises
    ------
    ComponentError
        If there is no gap, or a component has no linear model.
    """
    plant = axis.plant.loaded(carried_mass)
    if not isinstance(plant, TwoInertia) or not plant.widest_gap > 0.0:
        raise ComponentError(f"axis {axis.name}: there is no gap to analyse: its plant is not a two-inertia drive with backlash")
    if controller.predictor is not None:
        raise ComponentError(f"axis {axis.name}: predictor {controller.predictor.kind} has no linear model in continuous time")
    controller = replace(controller, velocity=_as_sampled(controller.velocity, servo_period))
    delay = 0.5 * servo_period + float(getattr(axis.drive, "delay", 0.0))
    in_contact = _closed(plant, controller, controller.controller, delay)
    in_gap = _closed(plant, controller, controller.others[0][1], delay) if controller.others else in_contact
    if in_gap[0].shape != in_contact[0].shape:
        raise ComponentError(f"axis {axis.name}: its controllers for contact and gap have different states: give both the same kind")
    (a, b, names), values = in_gap, plant.constants()
    c = np.zeros(len(a))
    c[[0, 2]] = 1.0, -1.0
    return BacklashLoop(
        a=a,
        b=-b[:, 3],
        c=c,
        stiffness=float(values.stiffness_value),
        half_gap=0.5 * plant.widest_gap,
        shaft_damping=float(values.damper_value),
        e=b[:, :3],
        contact_a=in_contact[0] if controller.others else None,
        contact_e=in_contact[1][:, :3] if controller.others else None,
        states=names,
    )


def _as_sampled(velocity: Component, period: float) -> Component:
    """Return a filtered difference in continuous time with the delay that its sampled form has at low frequencies."""
    if not isinstance(velocity, FilteredDifference) or not period > 0.0:
        return velocity
    weight = float(low_pass_weight(velocity.bandwidth, period, velocity.discretisation))
    # The difference is half a period late, the low-pass (1 - W)/W periods.
    delayed: Component = velocity.replace(bandwidth=1.0 / (period * (0.5 + (1.0 - weight) / weight)))
    return delayed


def _closed(plant: TwoInertia, controller: AxisController, law: Component, delay: float) -> tuple[Array, Array, tuple[str, ...]]:
    """Return A and B of the loop over `FREE`, plant states first, and the names of the states."""
    from scipy.linalg import block_diag

    blocks = _blocks(plant, controller, law, delay)
    place = {f"{block.name}.{port}": i for i, (block, port) in enumerate((block, port) for block in blocks for port in block.model.outputs)}
    takes = [(block, port) for block in blocks for port in block.model.inputs]
    inside, outside = np.zeros((len(takes), len(place))), np.zeros((len(takes), len(FREE)))
    for row, (block, port) in enumerate(takes):
        source = block.wires.get(port, "")
        if source in place:
            inside[row, place[source]] = 1.0
        elif source in FREE:
            outside[row, FREE.index(source)] = 1.0
    a, b, c, d = (np.asarray(block_diag(*(getattr(block.model, part) for block in blocks))) for part in "abcd")
    # Solve for outputs that depend on each other without delay.
    reach = np.linalg.solve(np.eye(len(place)) - d @ inside, np.hstack([c, d @ outside]))
    n = len(a)
    names = (*PLANT_STATES, *(f"{block.name} {i + 1}" for block in blocks[1:] for i in range(len(block.model.a))))
    return a + b @ inside @ reach[:, :n], b @ (inside @ reach[:, n:] + outside), names


def _blocks(plant: TwoInertia, controller: AxisController, law: Component, delay: float) -> list[_Block]:
    sent = "controller.command"
    filters = []
    for label, part in controller.filters:
        filters.append(_Block(f"filter {label}", _linear(part), {"command": sent}))
        sent = f"filter {label}.command"
    command = "drive.applied" if delay > 0.0 else sent
    blocks = [_Block("plant", _split(plant), {"command": command, "shaft": "shaft"})]
    if delay > 0.0:
        blocks.append(_Block("drive", _delayed(delay), {"command": sent}))
    blocks += filters
    sides = {"motor_position": "plant.motor_position", "load_position": "plant.position"}
    sides |= {"motor_velocity": "plant.motor_velocity", "load_velocity": "plant.velocity"}
    if not isinstance(controller.velocity, TrueVelocity):
        model = _linear(controller.velocity)
        for side in ("motor", "load"):
            blocks.append(_Block(f"{side} velocity", model, {"position": sides[f"{side}_position"]}))
            sides[f"{side}_velocity"] = f"{side} velocity.velocity"
    seen = {"position": sides[f"{controller.feedback}_position"], "velocity": sides[f"{controller.velocity_feedback}_velocity"]}
    if controller.observer is not None:
        blocks.append(_Block("observer", _linear(controller.observer), {"velocity": seen["velocity"], "applied": command}))
        seen["disturbance_estimate"] = "observer.disturbance_estimate"
    blocks.append(_Block("controller", _linear(law.linear()), {**{name: name for name in REFERENCE}, **sides, **seen}))
    return blocks


def _linear(part: Component) -> LinearModel:
    model = part.linearize()
    if model is None:
        raise ComponentError(f"{part.family} {part.kind} has no linear model, which the analysis of the gap needs")
    return model


def _split(plant: TwoInertia) -> LinearModel:
    """Return motor and load as separate masses, with the force of the shaft as an input."""
    d = plant.constants()
    a = np.zeros((4, 4))
    a[0, 1] = a[2, 3] = 1.0
    a[1, 1], a[3, 3] = -d.motor_decay, -d.load_decay
    b = np.zeros((4, 2))
    b[1] = d.force_value * d.motor_mobility, -d.motor_mobility
    b[3, 1] = d.load_mobility
    outputs = ("motor_position", "motor_velocity", "position", "velocity")
    return LinearModel(a, b, np.eye(4), np.zeros((4, 2)), ("command", "shaft"), outputs)


def _delayed(delay: float) -> LinearModel:
    """Return the rational delay of second order, (12 - 6 s T + s^2 T^2)/(12 + 6 s T + s^2 T^2)."""
    rate = 1.0 / delay
    a = np.array([[0.0, 1.0], [-12.0 * rate * rate, -6.0 * rate]])
    return LinearModel(a, np.array([[0.0], [1.0]]), np.array([[0.0, -12.0 * rate]]), np.ones((1, 1)), ("command",), ("applied",))


def inverse_dead_zone_gain(gain: float) -> float:
    """Return A/h at which the describing function N/k is `gain`, in (0, 1).

    >>> round(inverse_dead_zone_gain(0.391002), 5)
    2.0
    """
    from scipy.optimize import brentq

    if not 0.0 < gain < 1.0:
        raise ParameterError("gain", gain, "between 0 and 1, the range of a dead zone's describing function")
    # Over the angle p with sin p = h/A it is smooth at both ends: gain = 1 - (2 p + sin 2 p)/pi.
    angle = brentq(lambda p: 1.0 - (2.0 * p + math.sin(2.0 * p)) / math.pi - gain, 0.0, math.pi / 2.0, xtol=1e-15)
    return 1.0 / math.sin(angle)


def contact_phases(amplitude: ArrayLike, damping: ArrayLike) -> tuple[Array, Array]:
    """Return the phases (n,), (n,) at which contact above begins and ends for a difference A sin p, p = w t; nan without contact.

    Parameters
    ----------
    amplitude : array_like (n,)
        A over half of the gap.
    damping : array_like (n,)
        w d/k: damping of the shaft over its stiffness, times the frequency.
    """
    a, q = np.broadcast_arrays(np.asarray(amplitude, dtype=float), np.asarray(damping, dtype=float))
    inside = np.where(a > 1.0, a * np.hypot(1.0, q), np.nan)
    # Torque a sin p + q a cos p - 1 = 0, where it falls.
    end = math.pi - np.arcsin(1.0 / inside) - np.arctan(q)
    left = a * np.sin(end) - 1.0
    # Half a turn earlier the other side lost contact with the twist -left, which relaxes.
    low, high = end - math.pi, np.full_like(end, math.pi / 2.0)
    with np.errstate(over="ignore"):
        for _ in range(60):
            middle = 0.5 * (low + high)
            relaxed = -left * np.exp(-(middle - end + math.pi) / np.maximum(q, 1e-300))
            overrun = a * np.sin(middle) - relaxed > 1.0
            low, high = np.where(overrun, low, middle), np.where(overrun, middle, high)
    return np.where(a > 1.0, 0.5 * (low + high), np.nan), end


def harmonic(amplitude: ArrayLike, damping: ArrayLike, order: int = 1) -> Complex:
    """Return a harmonic of the torque over k A, for theta_d = A sin(w t); order 1 is the describing function N/k.

    Parameters
    ----------
    amplitude : array_like (n,)
        A over half of the gap.
    damping : array_like (n,)
        w d/k; 0 is the dead zone.
    order : int, odd
        Even harmonics are zero by symmetry.

    Returns
    -------
    ndarray (n,) of complex
        H with torque = k A Im(sum of H_n e^(j n w t)); 0 without contact.

    References
    ----------
    Gelb & Vander Velde, Multiple-Input Describing Functions, table of dead zones; Nordin, Galic & Gutman for the damped shaft.
    """
    a, q = np.broadcast_arrays(np.asarray(amplitude, dtype=float), np.asarray(damping, dtype=float))
    begin, end = contact_phases(a, q)
    n = order

    def part(m: int) -> Complex:
        """Integral of e^(j m p) over the contact."""
        if m == 0:
            return np.asarray(end - begin, dtype=complex)
        return np.asarray((np.exp(1j * m * end) - np.exp(1j * m * begin)) / (1j * m))

    # a sin p + q a cos p - 1, times e^(-j n p), over half a turn; the other half doubles it.
    sine = (part(1 - n) - part(-1 - n)) / 2j
    cosine = (part(1 - n) + part(-1 - n)) / 2.0
    return np.asarray(np.where(np.isfinite(begin), 2.0 / math.pi * 1j * (a * sine + q * a * cosine - part(-n)) / a, 0.0))


HARMONICS = (3, 5, 7, 9)
TRUSTED = 0.05
"""Largest share of higher harmonics in the motor-load difference of a good prediction."""
DOUBTFUL = 0.2
SURE = 0.25
"""Largest uncertainty of the amplitude of a good prediction."""
LARGEST = 1e4
"""Amplitude over half of the gap up to which a loop with shaft damping is searched."""


@dataclass(frozen=True)
class LimitCycle:
    """A limit cycle predicted by the describing function.

    Attributes
    ----------
    amplitude : float
        Of the motor-load difference [rad or m].
    frequency : float [rad/s]
    ratio : float
        Amplitude over half of the gap.
    stable : bool
        By Loeb's criterion on the quasi-linear loop: at a larger amplitude its critical pair decays, and no other pole grows.
    harmonics : float
        Test of the filter hypothesis: higher harmonics of the difference (root of the sum of squares up to the ninth) over the amplitude.
    sensitivity : float
        Relative change of the amplitude over a relative error of N G, for the worst phase of the error. It is large where the loop's phase
        hardly changes with frequency: there weak harmonics move the cycle far, or remove it.
    """

    amplitude: float
    frequency: float
    ratio: float
    stable: bool
    harmonics: float
    sensitivity: float

    @property
    def uncertainty(self) -> float:
        """Relative uncertainty of the amplitude, to first order: harmonics times sensitivity."""
        return self.harmonics * self.sensitivity

    @property
    def validity(self) -> str:
        """How far to trust the prediction: good, rough or poor, with the numbers behind it."""
        share = f"the loop passes {100.0 * self.harmonics:.2g} % of higher harmonics, amplitude {self.ratio:.3g} half-gaps"
        share += f", uncertain by {100.0 * self.uncertainty:.2g} %"
        if self.harmonics <= TRUSTED and self.ratio >= 2.0 and self.uncertainty <= SURE:
            return f"good: {share}"
        if self.harmonics <= DOUBTFUL and self.ratio >= 1.25 and self.uncertainty <= 2.0 * SURE:
            return f"rough: {share}"
        return f"poor: {share}; trust only the exact periodic orbit"


def predict_limit_cycles(loop: BacklashLoop) -> tuple[LimitCycle, ...]:
    """Return all limit cycles of a loop at rest that the describing function predicts, by falling amplitude.

    Parameters
    ----------
    loop : BacklashLoop
        With one controller for gap and contact.

    Returns
    -------
    tuple of LimitCycle
        Without shaft damping, every solution: N is real, so G must be real, which holds at frequencies that are eigenvalues. With shaft
        damping, the solutions at amplitudes from 1 to 10^4 half-gaps, found on a grid and refined.

    Raises
    ------
    ParameterError
        For a loop that switches its controller.

    References
    ----------
    Gelb & Vander Velde, Multiple-Input Describing Functions, 1968; Loeb's criterion there.
    """
    loop.require_one_controller("a describing function")
    pairs = _undamped(loop) if loop.shaft_damping == 0.0 else _damped(loop)
    return tuple(sorted((_cycle(loop, ratio, w) for ratio, w in pairs), key=lambda cycle: -cycle.ratio))


def real_frequencies(loop: BacklashLoop) -> list[float]:
    """Return all frequencies [rad/s] above 0 at which G(j w) is real, rising: imaginary zeros of G(s) - G(-s)."""
    from scipy.linalg import eigvals

    scale, n = loop.balance, loop.n
    a, b, c = loop.a * scale / scale[:, None], loop.b / scale, loop.c * scale
    rate = max(float(np.abs(np.linalg.eigvals(loop.contact_matrix)).max()), 1e-300)
    pencil, mass = np.zeros((2 * n + 1, 2 * n + 1)), np.eye(2 * n + 1)
    pencil[:n, :n], pencil[n : 2 * n, n : 2 * n] = a / rate, -a / rate
    pencil[: 2 * n, -1] = np.concatenate([b, b]) / np.abs(b).max()
    pencil[-1, : 2 * n] = np.concatenate([c, c]) / np.abs(c).max()
    mass[-1, -1] = 0.0
    alpha, beta = eigvals(pencil, mass, homogeneous_eigvals=True)
    finite = np.abs(beta) > 1e-13 * np.hypot(np.abs(alpha), np.abs(beta))
    zeros = rate * alpha[finite] / beta[finite]
    near = zeros[(zeros.imag > 0.0) & (np.abs(zeros.real) < 1e-3 * np.abs(zeros.imag))].imag
    return _polished(loop, np.sort(near))


def _polished(loop: BacklashLoop, near: Array) -> list[float]:
    """Refine frequencies at which G is nearly real, and drop those where G does not cross the real axis."""
    frequencies: list[float] = []
    for w in near:
        for _ in range(30):
            here = loop.transfer(np.array([w, w * (1.0 + 1e-6)]))
            slope = (here[1].imag - here[0].imag) / (1e-6 * w)
            step = here[0].imag / slope if slope != 0.0 else 0.0
            w -= float(np.clip(step, -1e-2 * w, 1e-2 * w))
            if abs(step) <= 1e-13 * w:
                break
        around = loop.transfer(w * np.array([1.0 - 1e-3, 1.0, 1.0 + 1e-3])).imag
        # Require a crossing of the real axis: far below all rates G is real everywhere, up to rounding.
        crosses = around[0] * around[2] < 0.0 and abs(around[1]) <= 1e-3 * min(abs(around[0]), abs(around[2]))
        if crosses and not any(abs(w - other) < 1e-9 * w for other in frequencies):
            frequencies.append(float(w))
    return frequencies


def _undamped(loop: BacklashLoop) -> list[tuple[float, float]]:
    """Return amplitude ratio and frequency of all solutions for a dead zone."""
    reaches = {w: -loop.stiffness * loop.at(w).real for w in real_frequencies(loop)}
    return [(inverse_dead_zone_gain(1.0 / reach), w) for w, reach in reaches.items() if reach > 1.0]


def _damped(loop: BacklashLoop) -> list[tuple[float, float]]:
    """Return amplitude ratio and frequency of the solutions with shaft damping: grid cells that may hold a zero, refined."""
    w = _frequencies(loop)
    ratios = 1.0 + np.logspace(-6.0, math.log10(LARGEST), 500)
    gain = loop.transfer(w)
    values = 1.0 + loop.stiffness * harmonic(ratios[:, None], w[None, :] * loop.shaft_damping / loop.stiffness) * gain[None, :]
    cells = np.argwhere(_may_vanish(values.real) & _may_vanish(values.imag))
    solutions: list[tuple[float, float]] = []
    for i, j in cells:
        at = _solved(loop, math.sqrt((ratios[i] - 1.0) * (ratios[i + 1] - 1.0)), math.sqrt(w[j] * w[j + 1]))
        if at is not None and not any(abs(at[0] / r - 1.0) < 1e-6 and abs(at[1] / v - 1.0) < 1e-6 for r, v in solutions):
            solutions.append(at)
    return solutions


def _frequencies(loop: BacklashLoop) -> Array:
    """Return frequencies over the range of the loop's poles, dense about oscillating poles."""
    poles = np.concatenate([np.linalg.eigvals(loop.gap_matrix), np.linalg.eigvals(loop.contact_matrix)])
    sizes = np.abs(poles)[np.abs(poles) > 1e-9 * np.abs(poles).max()]
    grids = [np.logspace(math.log10(sizes.min()) - 2.0, math.log10(sizes.max()) + 1.0, 600)]
    for pole in poles[poles.imag > 0.0]:
        width = max(abs(pole.real), 1e-9 * abs(pole))
        spread = width * np.sinh(np.linspace(0.0, math.asinh(abs(pole) / width), 60))
        grids += [pole.imag + spread, pole.imag - spread]
    w = np.unique(np.concatenate(grids))
    return np.asarray(w[w > 1e-3 * sizes.min()])


def _may_vanish(values: Array) -> Flags:
    """Return the cells whose four corners do not all have the same sign."""
    corners = np.stack([values[:-1, :-1], values[1:, :-1], values[:-1, 1:], values[1:, 1:]])
    return np.asarray((corners.min(axis=0) <= 0.0) & (corners.max(axis=0) >= 0.0))


def _solved(loop: BacklashLoop, excess: float, frequency: float) -> tuple[float, float] | None:
    """Solve 1 + N G = 0 from a start nearby, over the logarithms of A/h - 1 and w."""
    from scipy.optimize import root

    def balance(at: Array) -> list[float]:
        w = math.exp(at[1])
        gain = harmonic(1.0 + math.exp(min(at[0], 40.0)), w * loop.shaft_damping / loop.stiffness)
        value = 1.0 + loop.stiffness * complex(gain) * loop.at(w)
        return [value.real, value.imag]

    start = np.array([math.log(excess), math.log(frequency)])
    solution = root(balance, start, tol=1e-13)
    moved = np.abs(solution.x - start).max()
    if np.abs(balance(solution.x)).max() > 1e-9 or moved > 0.5:
        return None
    return 1.0 + math.exp(solution.x[0]), math.exp(solution.x[1])


def quasi_linear(loop: BacklashLoop, ratio: float, frequency: float) -> Array:
    """Return the matrix (n, n) of the loop with the torque replaced by its first harmonic at an amplitude over half of the gap."""
    gain = loop.stiffness * complex(harmonic(ratio, frequency * loop.shaft_damping / loop.stiffness))
    return np.asarray(loop.a - np.outer(loop.b, gain.real * loop.c + gain.imag / frequency * loop.rate))


def _cycle(loop: BacklashLoop, ratio: float, w: float) -> LimitCycle:
    """Return a solution with its stability, harmonics and sensitivity."""
    step = 1e-4 * (ratio - 1.0)
    growth = []
    for at in (ratio - step, ratio + step):
        poles = np.linalg.eigvals(quasi_linear(loop, at, w))
        critical = int(np.argmin(np.abs(poles - 1j * w)))
        growth.append(float(poles[critical].real))
        others = np.delete(poles, [critical, int(np.argmin(np.abs(poles + 1j * w)))])
    quiet = bool((others.real <= 1e-9 * np.abs(others).max(initial=w)).all())
    damping = w * loop.shaft_damping / loop.stiffness
    passed = [abs(loop.stiffness * complex(harmonic(ratio, damping, n)) * loop.at(n * w)) for n in HARMONICS]
    return LimitCycle(ratio * loop.half_gap, w, ratio, growth[1] < growth[0] and quiet, math.hypot(*passed), _sensitivity(loop, ratio, w))


def _sensitivity(loop: BacklashLoop, ratio: float, w: float) -> float:
    """Return |d ln A| / |d (N G)| at a solution, in the worst phase: from d ln N/d ln A, and the slopes of ln(N G) over ln w."""
    step = 1e-5

    def whole(a: float, v: float) -> complex:
        return complex(harmonic(a, v * loop.shaft_damping / loop.stiffness)) * loop.at(v) * loop.stiffness

    small = step * (1.0 - 1.0 / ratio)
    over_amplitude = -(whole(ratio * (1.0 + small), w) - whole(ratio * (1.0 - small), w)) / (2.0 * small)
    over_frequency = -(whole(ratio, w * (1.0 + step)) - whole(ratio, w * (1.0 - step))) / (2.0 * step)
    return abs(over_frequency) / max(abs((over_amplitude * over_frequency.conjugate()).imag), 1e-300)
