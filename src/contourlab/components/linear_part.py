"""Linear parts given by matrices or by polynomials: checks, discretisation, and the step, which multiplies by one matrix."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, param, text_param
from contourlab.components.mechanics.matrix_step import matrix_step
from contourlab.engine.step import Step, ports
from contourlab.errors import ParameterError, refuse

HIGHEST_ORDER = 12

_SIZES = "A (n, n), row by row; n up to 12", "B (n, inputs), row by row", "C (n)"
MATRICES = tuple(param(default=(), vector=True, doc=doc) for doc in _SIZES)
POLYNOMIALS = (
    param(vector=True, doc="coefficients in falling powers of s [rad/s], or of z"),
    param(vector=True, doc="coefficients likewise, of degree 12 at most"),
)
METHOD = text_param("tustin", ("tustin", "zero-order-hold"), doc="sampling: trapezoidal rule, or exact for an input held over the period")
PERIOD: Any = param(
    default=0.0, unit="s", minimum=0.0, display="ms", structural=True, doc="servo period of discrete numbers; 0: continuous"
)

EDGE = 1e-6
"""How far a pole may lie beyond the edge of stability, as a part of the fastest: rounding moves multiple poles."""
HIDDEN = 1e-13
"""Largest distance from a mode that no input reaches, or no output shows, relative to the matrix."""

System = tuple[Array, Array, Array, Array]
"""A (n, n), B (n, n_input), C (1, n), D (1, n_input)."""


def from_matrices(part: Any, n_input: int) -> System:
    """Return the matrices of a part; raise ParameterError if their sizes do not fit."""
    n = math.isqrt(len(part.a))
    wanted = f"n^2 numbers, row by row, n at most {HIGHEST_ORDER}"
    refuse(n * n != len(part.a) or n > HIGHEST_ORDER, ParameterError, f"{part.kind}.a", f"{len(part.a)} numbers", wanted)
    found = []
    for name, shape in {"a": (n, n), "b": (n, n_input), "c": (1, n), "d": (1, n_input)}.items():
        values = getattr(part, name, (0.0,) * n_input)  # a plant has no D
        wrong, wanted = len(values) != math.prod(shape), f"{math.prod(shape)}, as A is {n} by {n}"
        refuse(wrong, ParameterError, f"{part.kind}.{name}", f"{len(values)} numbers", wanted)
        found.append(np.array(values, dtype=float).reshape(shape))
    return tuple(found)  # type: ignore[return-value]


def from_polynomials(part: Any) -> System:
    """Return matrices of numerator over denominator, in units of time in which the coefficients are about 1."""
    above, below = (np.trim_zeros(np.array(numbers), "f") for numbers in (part.numerator, part.denominator))
    n = below.size - 1
    refuse(below.size == 0, ParameterError, f"{part.kind}.denominator", f"{list(part.denominator)}", "not 0")
    refuse(n > HIGHEST_ORDER, ParameterError, f"{part.kind}.denominator", f"of degree {n}", f"of degree {HIGHEST_ORDER} or less")
    refuse(above.size == 0, ParameterError, f"{part.kind}.numerator", f"{list(part.numerator)}", "not 0")
    if above.size > below.size:
        raise ParameterError(f"{part.kind}.numerator", f"of degree {above.size - 1}", f"of degree {n} at most, that of the denominator")
    power = np.arange(1, n + 1)
    rate = float((np.abs(below[1:] / below[0]) ** (1.0 / power)).max(initial=0.0)) or 1.0
    p, q = below[1:] / below[0] / rate**power, np.pad(above, (n + 1 - above.size, 0)) / below[0] / rate ** np.arange(n + 1.0)
    a = np.eye(n, k=1)
    a[-1:] = -p[::-1]
    return rate * a, rate * np.eye(n)[:, -1:], (q[1:] - q[0] * p)[None, ::-1], q[:1, None]


def checked(part: Any, system: System, furthest: float = math.inf) -> System:
    """Return the system with states in even units; raise ParameterError if a mode is hidden, or a pole lies beyond the edge of stability.

    `furthest` is how far it may, as a part of the fastest.
    """
    a, b, c, d = system
    if not len(a):
        return system
    from scipy.linalg import matrix_balance

    even, (unit, _) = matrix_balance(a, permute=False, separate=True)
    reach, show, poles = b / unit[:, None], c * unit, np.linalg.eigvals(even)
    size = float(np.linalg.norm(even)) or 1.0
    place = "a" if "a" in part.parameters else "denominator"
    for pole in poles:
        free = pole * np.eye(len(a)) - even
        reached, shown = np.hstack([free, _sized(reach, size)]), np.vstack([free, _sized(show, size)])
        for sides, why in ((reached, "no input reaches"), (shown, "no output shows")):
            if np.linalg.svd(sides, compute_uv=False)[-1] <= HIDDEN * size:
                bound = f"left out or cancelled: {why} it"
                raise ParameterError(f"{part.kind}.{place}", f"a mode at {complex(pole):.4g}", bound)
        beyond = abs(pole) - 1.0 if part.discrete else pole.real / max(float(np.abs(poles).max()), 1e-300)
        if beyond > furthest:
            edge = "inside the unit circle" if part.discrete else "in the left half plane"
            raise ParameterError(f"{part.kind}.{place}", f"a pole at {complex(pole):.4g}", edge)
    return np.asarray(even, dtype=float), reach, show, d


def _sized(matrix: Array, size: float) -> Array:
    return matrix * (size / (float(np.linalg.norm(matrix)) or 1.0))


def sampled(part: Any, system: System, dt: float) -> System:
    """Return the matrices of x(k + 1) = A x + B u, y = C x + D u at the period dt [s].

    Raises
    ------
    ParameterError
        If the part is discrete at another period.
    """
    a, b, c, d = system
    n, m = b.shape
    if part.discrete:
        if not math.isclose(part.period, dt, rel_tol=1e-9):
            raise ParameterError(f"{part.kind}.period", f"{1e3 * part.period:g}", f"{1e3 * dt:g} ms, the period at which it runs", "ms")
        return system
    if getattr(part, "method", "") == "tustin":
        half = np.linalg.inv(np.eye(n) - 0.5 * dt * a)
        into, out = dt * half @ b, c @ half
        return half @ (np.eye(n) + 0.5 * dt * a), into, out, d + 0.5 * c @ into
    from scipy.linalg import expm

    held = expm(dt * np.block([[a, b], [np.zeros((m, n + m))]]))
    return held[:n, :n], held[:n, n:], c, d


class LinearPart(Component):
    """Base of the kinds "state-space" and "transfer-function" of all families.

    Attributes
    ----------
    system : tuple of ndarray
        A, B, C and D as they are sampled.
    """

    reference = "Franklin, Powell & Workman, Digital Control of Dynamic Systems, chapters 4, 6 and 9"
    without_effect = ("period",)  # the examples are continuous
    system: System

    def __init__(self, **values: Any) -> None:
        super().__init__(**{name: tuple(np.ravel(value).tolist()) if np.ndim(value) > 1 else value for name, value in values.items()})

    @property
    def discrete(self) -> bool:
        """Whether its numbers are for discrete time."""
        part: Any = self
        return bool(part.period > 0.0)

    def given(self, n_input: int = 1) -> System:
        """Return the matrices as given."""
        return from_matrices(self, n_input) if "a" in self.parameters else from_polynomials(self)

    def prepare(self, system: System, height: int, width: int) -> None:
        """Take a system, its states, and the names of the matrix (height, width) of the step."""
        entries = tuple(f"entry_{i}_{j}" for i in range(height) for j in range(width))
        names = ports(*(f"state_{i + 1}" for i in range(len(system[0]))))
        for name, value in {"system": system, "states": names, "derived": entries}.items():
            object.__setattr__(self, name, value)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        a, b, c, d = sampled(self, self.system, dt)
        return tuple(np.block([[a, b], [c, d]]).ravel().tolist())

    def step_function(self) -> Any:
        return matrix_step(self.states, self.inputs, self.outputs, 0)

    def make_step(self, n_axis: int = 1) -> Step:
        name = f"{self.family}/{self.kind}"
        return Step(name, self.step_function(), self.derived, (), "", self.states, self.inputs, self.outputs)
