"""A feed drive as a chain of inertias: motor, coupling, screw, nut, table, with a shaft and perhaps backlash between any two."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import LinearModel, param
from contourlab.components.mechanics.chain_mechanics import JOINT, chain_step
from contourlab.components.plant.plant import Plant
from contourlab.components.plant.two_inertia import COARSEST, CONTACT_MODEL, TwoInertia
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, ParameterError

JOINT_LISTS = ("stiffnesses", "shaft_dampings", "backlash_gaps", "backlash_angles")


class InertiaChain(Plant):
    """Chain of inertias from motor to load, J_i w_i' = T_(i-1) - T_i, where T_i = k_i theta_i + d_i theta_i' behind the free travel.

    The first is the motor's: a command and the motor's damping and friction act on it. The last is the load's: it carries the mass, and
    loads, the guide's damping and friction act on it. All states are lengths at the table, as in `two-inertia`, which is the chain of two;
    each joint has backlash of its own, or none. Lists of joints have one value a joint, from the motor on, or a single one for all.

    Outputs are those of `two-inertia`: ``shaft_force`` is what is handed on to the load, ``gap_state`` that of the joint with backlash that
    is nearest the load. The integration is that of `contourlab.components.mechanics.chain_mechanics`.

    References
    ----------
    Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011) 779-796, section on models of several
    masses; contact as in Nordin, Galic & Gutman, Int. J. Adaptive Control and Signal Processing 11 (1997) 49-63.
    """

    kind = "inertia-chain"
    reference = "Altintas et al., CIRP Annals 60 (2011); Nordin, Galic & Gutman 1997"
    command_unit = "N*m"
    two_sided = True
    rest_depends = ("start_in_gap", "lead")
    inputs, outputs = TwoInertia.inputs, TwoInertia.outputs
    example = {
        "inertias": (3e-3, 2.2e-3, 4.4e-3),
        "mass": 30.0,
        "lead": 0.016,
        "stiffnesses": (3000.0, 950.0),
        "shaft_dampings": (0.2, 0.1),
        "motor_damping": 2e-3,
        "load_damping": 3e-3,
        "backlash_gaps": (0.0, 20e-6),
        "backlash_angles": (1e-3, 0.0),
        "start_in_gap": 0.5,
    }
    without_effect = ("start_in_gap",)  # it is where a run starts
    inertias: tuple[float, ...] = param(
        vector=True, unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="of the rotating parts, motor first"
    )
    mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="of the table, beside the last inertia: it counts (l/2 pi)^2 of it")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass that the axis carries besides its own")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    stiffnesses: tuple[float, ...] = param(vector=True, unit="N*m/rad", minimum=0.0, exclusive=True, doc="of the joints, k_i")
    shaft_dampings: tuple[float, ...] = param(default=(0.0,), vector=True, unit="N*m*s/rad", minimum=0.0, doc="of the same, d_i")
    motor_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous, on the motor's side, c_m")
    load_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous, on the load's side, as the shaft sees it, c_l")
    torque_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="torque that comes per torque that was asked for, g")
    backlash_gaps: tuple[float, ...] = param(
        default=(0.0,), vector=True, unit="m", minimum=0.0, display="um", doc="free travel of the joints, as lengths at the table"
    )
    backlash_angles: tuple[float, ...] = param(
        default=(0.0,), vector=True, unit="rad", minimum=0.0, doc="free travel of the joints at the motor"
    )
    start_in_gap: float = param(default=0.0, minimum=-1.0, maximum=1.0, doc="initial place of each joint in its gap, as of two-inertia")
    contact_model: str = CONTACT_MODEL

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        n = len(self.inertias)
        if n < 2:
            raise ParameterError("inertias", "one of them", "two or more: a motor and a load")
        for name in JOINT_LISTS:
            if len(getattr(self, name)) not in (1, n - 1):
                raise ParameterError(name, f"{len(getattr(self, name))} values", f"{n - 1}, one for each joint, or one for all")
        inner = (Port("inner_positions", n - 2), Port("inner_velocities", n - 2)) if n > 2 else ()
        ends = (Port("motor_position"), Port("motor_velocity"), Port("position"), Port("velocity"))
        object.__setattr__(self, "states", (*ends, *inner, Port("sides", n - 1), Port("twists", n - 1)))
        rows = (*(f"mobility_{i}" for i in range(n)), *(f"{name}_{j}" for j in range(n - 1) for name in JOINT))
        object.__setattr__(self, "derived", ("force_value", "motor_decay", "load_decay", *rows))

    def _of_joints(self, name: str) -> tuple[float, ...]:
        values, joints = getattr(self, name), len(self.inertias) - 1
        return tuple(values) if len(values) == joints else tuple(values) * joints

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        turn = 2.0 * math.pi / par.lead
        masses = [inertia * turn * turn for inertia in self.inertias]
        masses[-1] = masses[-1] + par.mass + par.carried_mass
        joints: list[Any] = []
        for k, d, length, angle in zip(*(self._of_joints(name) for name in JOINT_LISTS), strict=True):
            # Without damping a shaft unwinds at once, and there is no twist to follow.
            unwinding = k / d if d > 0.0 else 0.0
            joints += [k * turn * turn, d * turn * turn, 0.5 * (length + angle / turn), 0.0 if length + angle > 0.0 else 1.0, unwinding]
        decays = (par.motor_damping * turn * turn / masses[0], par.load_damping * turn * turn / masses[-1])
        return (par.torque_gain * turn, *decays, *(1.0 / mass for mass in masses), *joints)

    @property
    def gaps(self) -> tuple[float, ...]:
        """Free travel of each joint [m], from the motor on."""
        lead = self.lead / (2.0 * math.pi)
        return tuple(length + angle * lead for length, angle in zip(*map(self._of_joints, JOINT_LISTS[2:]), strict=True))

    def gap_at(self, position: float) -> float:
        """Return the free travel of all joints together [m]; it is the same at any position."""
        return sum(self.gaps)

    def joined(self, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Any:
        for side, friction in (("motor", motor), ("load", load)):
            if friction.law not in ("smooth", "sticking"):
                raise ComponentError(
                    f"a {self.kind} takes no friction of law {friction.law!r}: {side} {friction.kind}; give it a smooth or a sticking one, "
                    "or take a two-inertia plant, which takes bristles"
                )
        loose = [j for j, gap in enumerate(self.gaps) if gap > 0.0]
        shown = loose[-1] if loose else len(self.gaps) - 1
        return chain_step(len(self.inertias), shown, self.contact_model == "physical", motor, load, motor_view, load_view)

    def at_rest(self, position: float) -> tuple[dict[str, Any], dict[str, Any]]:
        ahead = np.cumsum(0.5 * self.start_in_gap * np.array(self.gaps[::-1]))[::-1] + position
        states: dict[str, Any] = {"position": position, "motor_position": float(ahead[0])}
        inner = {"inner_positions": tuple(map(float, ahead[1:]))} if len(ahead) > 1 else {}
        return {**states, **inner}, states

    def rigid_model(self) -> tuple[float, float]:
        turn = 2.0 * math.pi / self.lead
        whole = sum(self.inertias) * turn * turn + self.mass + self.carried_mass
        return self.torque_gain * turn / whole, (self.motor_damping + self.load_damping) * turn * turn / whole

    def linear(self) -> Any:
        return self.replace(backlash_gaps=(0.0,), backlash_angles=(0.0,))

    def matrices(self) -> tuple[Array, Array, Array]:
        """Return masses (n,) [kg], stiffness (n, n) [N/m] and damping (n, n) [N*s/m] at the table, all joints in contact."""
        d, n = self.constants(), len(self.inertias)
        masses = np.array([1.0 / getattr(d, f"mobility_{i}") for i in range(n)])
        stiffness, damping = np.zeros((n, n)), np.zeros((n, n))
        for j in range(n - 1):
            pair = np.zeros(n)
            pair[j], pair[j + 1] = 1.0, -1.0
            stiffness += getattr(d, f"stiffness_value_{j}") * np.outer(pair, pair)
            damping += getattr(d, f"damper_value_{j}") * np.outer(pair, pair)
        damping[0, 0] += d.motor_decay * masses[0]
        damping[-1, -1] += d.load_decay * masses[-1]
        return masses, stiffness, damping

    def linearize(self) -> LinearModel:
        """Return the model of the contact: the drive without its gaps. States are all positions, then all velocities."""
        masses, stiffness, damping = self.matrices()
        n = len(masses)
        a, b = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 2))
        a[:n, n:] = np.eye(n)
        a[n:, :n], a[n:, n:] = -stiffness / masses[:, None], -damping / masses[:, None]
        b[n, 0], b[-1, 1] = self.constants().force_value / masses[0], 1.0 / masses[-1]
        names = ("position", "velocity", "motor_position", "motor_velocity")
        return LinearModel(a, b, np.eye(2 * n)[[n - 1, 2 * n - 1, 0, n]], np.zeros((4, 2)), ("command", "load"), names)

    def frequencies(self) -> Array:
        """Return the natural frequencies of the chain in contact (n - 1,) [Hz], without damping, lowest first."""
        masses, stiffness, _ = self.matrices()
        squares = np.linalg.eigvalsh(stiffness / np.sqrt(np.outer(masses, masses)))[1:]
        return np.asarray(np.sqrt(np.maximum(squares, 0.0)) / (2.0 * math.pi))

    def mobilities(self) -> tuple[float, ...]:
        masses, _, _ = self.matrices()
        return float(1.0 / masses[-1]), float(1.0 / masses[0])

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        masses, _, damping = self.matrices()
        highest = float(self.frequencies()[-1])
        damped = float(np.linalg.eigvalsh(damping / np.sqrt(np.outer(masses, masses)))[-1])
        wanted = max(2.0 * math.pi * highest * dt / COARSEST, damped * dt)
        return max(1, math.ceil(wanted - 1e-9)), f"a chain whose highest frequency is {highest:.4g} Hz"
