"""What each family of components must have: ports, methods, base class.

Loader, conformance test and `docs/reference/ports.md` use this table.
"""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Method:
    """A method that a class must define.

    Attributes
    ----------
    call : str
        Name and arguments; with `self` it is an ordinary method, otherwise a static one.
    doc : str
        What it returns.
    """

    call: str
    doc: str

    @property
    def name(self) -> str:
        """Name of the method."""
        return self.call.partition("(")[0]

    @property
    def arguments(self) -> list[str]:
        """Names of its arguments."""
        return self.call.partition("(")[2].rstrip(")").split(", ")

    @property
    def static(self) -> bool:
        """Whether it is a static method."""
        return self.arguments[0] != "self"


@dataclass(frozen=True)
class Form:
    """One way to write a class of a family.

    Attributes
    ----------
    base : str
        Module and name of the base class; empty for `Component`.
    law : str
        The class attribute `law` that selects this form.
    constants : dict of str to str
        Names in `par`, as parameters or derived, and the method that may be written instead; empty where there is none.
    states : tuple of str
        States that it must have.
    attributes : dict of str to str
        Further class attributes or properties, and an example.
    """

    methods: tuple[Method, ...] = ()
    base: str = ""
    law: str = ""
    constants: dict[str, str] = field(default_factory=dict)
    states: tuple[str, ...] = ()
    attributes: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Family:
    """A family of components.

    Attributes
    ----------
    doc : str
        What it does.
    slot : str
        Its key in a machine or controller.
    inputs : tuple of str
        What the slot offers.
    outputs : tuple of str
        What it expects.
    forms : tuple of Form
        The ways to write a class.
    chooses : bool
        Whether a class may leave inputs out.
    either : bool
        Whether one of the outputs is enough.
    """

    doc: str
    slot: str
    inputs: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    forms: tuple[Form, ...] = ()
    chooses: bool = False
    either: bool = False


ALONE = ("arc_length", "contour_error_estimate", "feedrate", "curvature", "rate")
"""Ports of estimators and couplings with one number; their other ports have one for each axis."""
ACROSS = ("estimator", "coupling")
"""Families that see all axes: declare their vectors with ``Port(name, -1)``."""

TWO_SIDED = (
    *("force_value", "motor_mobility", "motor_decay", "load_mobility", "load_decay"),
    *("stiffness_value", "damper_value", "half_gap", "bonded", "unwinding"),
)
"""Constants of a plant with two sides: force per command; mobility and decay of either mass; shaft; gap; decay of a twist."""


def size_of(family: str, port: str) -> int:
    """Return the size of a port of a family's slot: 0 for a number, -1 for one number for each axis."""
    return -1 if family in ACROSS and port not in ALONE else 0


ESTIMATES = ("foot_position", "error_vector", "contour_error_estimate", "tangent")
"""Outputs of an estimator."""
_ASKED = ("reference", "reference_velocity", "reference_acceleration")
_SIDES = ("motor_position", "motor_velocity", "load_position", "load_velocity")
_ADVANCE = Method("step(par, x, inp, clock)", "`x_next, out`: next states and outputs, tuples in the order of `states` and `outputs`")
_STEP = (Form((_ADVANCE,)),)
_PLANTS = (
    Form(
        (Method("drive_force(par, command)", "the force of the drive"),),
        "contourlab.components.plant.plant.SingleMass",
        constants={"mobility_value": "mobility", "decay_value": "decay"},
    ),
    Form((), "contourlab.components.plant.two_sided.TwoSided", constants=dict.fromkeys(TWO_SIDED, "")),
)
_LAGGED = Form(
    (Method("rates(self, par)", "mobility, decay, rate of the lag, force per command and back-action, as in `LaggedMass`"),),
    "contourlab.components.plant.lagged_mass.LaggedMass",
)
_FOLLOWER = Form(
    (Method("pull(par, count, rate, position, velocity)", "the force of a step count, which moves at a rate, on the axis"),),
    "contourlab.components.plant.stepper.Follower",
    constants=dict.fromkeys(("mobility_value", "decay_value", "stiffness_value", "damper_value", "feed_value", "step_value"), ""),
)
_OWN = Form((_ADVANCE,), "contourlab.components.plant.plant.Plant")
_FRICTIONS = (
    Form((Method("force(par, v)", "the friction force at the velocity v, with the sign of v"),), law="smooth"),
    Form(
        (
            Method("held(par)", "the largest force that it holds at rest"),
            Method("sliding(par, speed)", "the resistance at a speed, >= 0, continued smoothly below zero"),
        ),
        law="sticking",
    ),
    Form(
        (Method("level(par, v)", "the friction of steady sliding without its viscous part, > 0"),),
        law="bristle",
        constants=dict.fromkeys(("stiffness", "bristle_damping", "viscous"), ""),
        states=("bristle",),
    ),
)
_CHOICE = {"reasons": '("too fast", "slow again")', "n_controller": "2"}
_ESTIMATE = Method("path_step(self, view, n_axis)", "the `Step` on a path; take `contourlab.components.estimator.newton` as a pattern")
_REVISE = Method("revised(self, table, trial, problem)", "the next table, a new array; arguments as in `LearningLaw.update`")

FAMILY = {
    "plant": Family(
        "moves under command and load",
        "axes.NAME.plant",
        ("command", "load"),
        ("position", "velocity", "acceleration"),
        (_LAGGED, _FOLLOWER, *_PLANTS, _OWN),
    ),
    "friction": Family("resists the motion", "axes.NAME.friction", forms=_FRICTIONS),
    "drive": Family("limits and delays the command", "axes.NAME.drive", ("command",), ("applied",), _STEP),
    "sensor": Family("measures the position", "axes.NAME.sensor", ("position",), ("position",), _STEP),
    "predictor": Family(
        "predicts the position at which commands under way will act; declares a `ring` to look back",
        "controller.axes.NAME.predictor",
        ("position", "applied"),
        ("position",),
        _STEP,
    ),
    "velocity": Family("computes the velocity", "controller.axes.NAME.velocity", ("position",), ("velocity",), _STEP),
    "disturbance": Family("pushes the axis", "axes.NAME.disturbance", ("position",), ("force",), _STEP),
    "observer": Family(
        "estimates the disturbance",
        "controller.axes.NAME.observer",
        ("position", "velocity", "applied"),
        ("disturbance_estimate",),
        _STEP,
        chooses=True,
    ),
    "gap_observer": Family(
        "estimates state and size of the gap, its own confidence, and the load, from motor and command",
        "controller.axes.NAME.gap_observer",
        ("motor_position", "motor_velocity", "reference_velocity", "applied"),
        ("gap_state", "gap", "gap_deviation", "confidence", "load_position", "load_velocity"),
        _STEP,
        chooses=True,
    ),
    "feedforward": Family(
        "turns the reference into `reference_shift`, `command` or both; `ahead(dt)` ticks of look-ahead",
        "controller.axes.NAME.feedforward",
        (*_ASKED, "reference_ahead"),
        ("reference_shift", "command"),
        _STEP,
        chooses=True,
        either=True,
    ),
    "compensation": Family(
        "turns the reference and both sides of the drive into `reference_shift`, `command` or both",
        "controller.axes.NAME.compensation",
        (*_ASKED, *_SIDES, "gap_estimate"),
        ("reference_shift", "command"),
        _STEP,
        chooses=True,
        either=True,
    ),
    "supervisor": Family(
        "chooses the active controller and gives a reason, both as numbers",
        "controller.axes.NAME.supervisor",
        (*_ASKED, *_SIDES, "position", "velocity", "gap_state", "gap_estimate", "confidence", "arc_length", "source_line", "accepted"),
        ("active", "reason"),
        (Form((_ADVANCE,), "contourlab.components.supervisor.switching.Supervisor", attributes=_CHOICE),),
        chooses=True,
    ),
    "controller": Family(
        "command = own law + `feedforward` - `disturbance_estimate`",
        "controller.axes.NAME.controller",
        (*_ASKED, *_SIDES, "position", "velocity", "gap_estimate", "disturbance_estimate", "feedforward", "applied", "accepted"),
        ("command",),
        _STEP,
        chooses=True,
    ),
    "filter": Family(
        "turns the controller's command into the drive's; its states are commands, all equal at rest",
        "controller.axes.NAME.filters.LABEL",
        ("command",),
        ("command",),
        _STEP,
    ),
    "estimator": Family(
        "turns positions and path into the contour-error vector",
        "controller.estimator",
        ("position", "arc_length"),
        ESTIMATES,
        (Form((_ESTIMATE,)),),
    ),
    "coupling": Family(
        "sees all axes; gives `modified_reference` or `correction`, and `rate`: planned time per time, which decides the progress",
        "controller.coupling",
        (
            *_ASKED,
            *("arc_length", "feedrate", "curvature", "position", "velocity", "disturbance_estimate"),
            *ESTIMATES,
            "command",
            "accepted",
        ),
        ("modified_reference", "correction", "rate"),
        _STEP,
        chooses=True,
        either=True,
    ),
    "link": Family(
        "turns a signal sent into the one received, from base to axis or back",
        "controller.axes.NAME.link.down` and `.up",
        ("sent",),
        ("received",),
        _STEP,
    ),
    "learning": Family(
        "turns the record of a trial into the next table",
        "learning.law",
        forms=(Form((_REVISE,), "contourlab.components.learning.law.LearningLaw"),),
    ),
}
"""The families, in the order in which `contourlab components` lists them."""

FAMILIES = tuple(FAMILY)
