"""Machine and controller as values: axes, limits, error maps, and the division of a controller; nothing here runs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from contourlab.arrays import Array, ByValue
from contourlab.components.contract import Component, fault
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import Saturation
from contourlab.components.families import ESTIMATES
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealLink, IdealSensor, TrueVelocity
from contourlab.components.origin import Origin
from contourlab.components.plant.plant import Plant
from contourlab.controls.contract import ControlFile
from contourlab.errors import FeedError, ParameterError, refuse
from contourlab.feed import AxisLimits
from contourlab.feed.bounds import RANGES, Grbl, LinuxCNC
from contourlab.figures import listing
from contourlab.notebook import facts_line
from contourlab.units import setting

GRBL = ("junction_deviation", "arc_tolerance", "planner_blocks")
"""Keys of the planner of grbl."""
LINUXCNC = ("kink_ratio", "planner_blocks", "gap_cycles", "largest_override")
"""Keys of the planner of LinuxCNC."""
Planner: TypeAlias = Literal["jerk", "grbl", "linuxcnc"]
"""How a control plans."""


@dataclass(frozen=True)
class Limits:
    """Limits of an axis.

    Attributes
    ----------
    velocity : float [m/s], > 0
    acceleration : float [m/s^2], > 0
    jerk : float [m/s^3], > 0
    following_error : float [m], > 0
        A larger tracking error ends the run as diverged, as a drive would trip.
    travel : tuple of two floats, or float > 0 [m]
        Lowest and highest position of the axis, or the length alone: feed moves must then fit into it, wherever they lie.
    floating : bool
        Whether only the length of the travel counts, because nobody knows where a program's zero lies in it; G53 knows.
    origins : mapping of str to Origin
        Source of each number, by name.
    file : str
        File that holds the limits; empty if there is none.

    Raises
    ------
    ParameterError
        If a limit is not positive, or the travel is empty.
    """

    velocity: float = field(default=math.inf, metadata=setting("m/s", "mm/min", *RANGES["velocity"]))
    acceleration: float = field(default=math.inf, metadata=setting("m/s^2", "", *RANGES["acceleration"]))
    jerk: float = field(default=math.inf, metadata=setting("m/s^3", "", *RANGES["jerk"]))
    following_error: float = field(default=0.05, metadata=setting("m", "mm", minimum=0.0, maximum=1.0, exclusive=True))
    travel: tuple[float, float] | float = field(default=(-math.inf, math.inf), metadata=setting("m", "mm"))
    floating: bool = False
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)
    file: str = field(default="", compare=False, repr=False)

    def __post_init__(self) -> None:
        for name in ("velocity", "acceleration", "jerk", "following_error"):
            value = getattr(self, name)
            refuse(not value > 0.0, ParameterError, f"limits.{name}", f"{value:g}", "> 0")
        low, high = self.travel if isinstance(self.travel, tuple) else (0.0, self.travel)
        if not low < high:
            raise ParameterError("limits.travel", f"{self.travel}", "two positions, the lower one first, or a length > 0", "m")

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest position; infinite where unknown."""
        return self.travel if isinstance(self.travel, tuple) and not self.floating else (-math.inf, math.inf)

    @property
    def extent(self) -> float:
        """Length of a travel whose ends are unknown; infinite otherwise."""
        if isinstance(self.travel, tuple):
            return self.travel[1] - self.travel[0] if self.floating else math.inf
        return self.travel

    @property
    def bounded(self) -> bool:
        """Whether the travel is known, by its ends or by its length."""
        return any(map(math.isfinite, (*self.ends, self.extent)))


@dataclass(frozen=True, eq=False)
class AxisError(ByValue):
    """Error of the tool's position that the encoder of an axis cannot see.

    Attributes
    ----------
    position, lead_error : ndarray (n,) [m]
        Error of the tool's position over ascending axis positions, linear in between; empty for none.
    repeatability : float [m], >= 0
        Unidirectional repeatability by ISO 230-2 (4 s): each reversal draws a new offset of the tool, normal with s = a quarter of it.
    backlash : float [m], >= 0
        Play behind the encoder: the axis rests where friction holds it until the motor has crossed the play. It begins in the middle.
    origins : mapping of str to Origin
        Source of each number, by name.

    Raises
    ------
    ParameterError
        If the table is not finite or not ascending, or repeatability or backlash is negative.
    """

    position: Array = field(default_factory=lambda: np.zeros(0), metadata=setting("m", "mm"))
    lead_error: Array = field(default_factory=lambda: np.zeros(0), metadata=setting("m", "um"))
    repeatability: float = field(default=0.0, metadata=setting("m", "um", minimum=0.0))
    backlash: float = field(default=0.0, metadata=setting("m", "um", minimum=0.0))
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.position.shape != self.lead_error.shape or np.any(np.diff(self.position) <= 0.0):
            raise ParameterError("error.position", "a table", "as long as lead_error, with increasing positions", "m")
        if not (np.isfinite(self.position).all() and np.isfinite(self.lead_error).all()):
            raise ParameterError("error.lead_error", "a table", "finite", "m")
        for name in ("repeatability", "backlash"):
            refuse(not getattr(self, name) >= 0.0, ParameterError, f"error.{name}", f"{getattr(self, name):g}", ">= 0", "m")


DIVISIONS = {
    "drive": "drive and sensors in the axis, everything else in the base, which sends commands",
    "observer": "drive, sensors and disturbance observer in the axis, which subtracts its own estimate from the commands of the base",
    "controller": "the whole controller in the axis; contour estimator and coupling in the base, which sends the reference",
}
"""What runs in the axis: the fewest parts first, the whole controller last."""

_LOCAL = {"drive": ("velocity", "filters"), "observer": ("velocity", "observer", "filters")}
"""Slots in the axis; with "controller" all of them."""


@dataclass(frozen=True)
class Division:
    """An axis' controller divided into a base, the same for any axis, and a local part that moves with the axis.

    Each wire between the two goes through the link of its direction. Plant, filters, drive and sensors are always in the axis, and so is
    the velocity, unless a predictor in the base precedes it. Contour estimator, coupling, reference and learned tables are always in the
    base.

    Attributes
    ----------
    division : {"drive", "observer", "controller"}
        What is in the axis: see `DIVISIONS`.
    down : Component
        Link from the base to the axis.
    up : Component or None
        Link from the axis to the base. None if nothing comes back: the base sees no position, so the controller must be local. Use the
        ideal link if the base has its own wires to the sensors and messages go one way.

    Raises
    ------
    ParameterError
        If the division is unknown, or leaves the base without a position that it needs.

    References
    ----------
    Ghaffari & Ulsoy, Fig 1 and section IV; one way and both ways: Cakmakci & Ulsoy, IEEE/ASME Trans. Mechatronics 14 (2009), 307-316.
    """

    division: str = field(default="observer", metadata=setting(choices=DIVISIONS))
    down: Component = field(default_factory=IdealLink)
    up: Component | None = field(default_factory=IdealLink)

    def __post_init__(self) -> None:
        refuse(self.division not in DIVISIONS, ParameterError, "link.division", repr(self.division), "one of " + ", ".join(DIVISIONS))
        if self.up is None and self.division != "controller":
            bound = f'a link, because with division = "{self.division}" the base needs measurements; "ideal" if it has its own wires'
            raise ParameterError("link.up", '"none"', bound)

    def is_local(self, slot: str) -> bool:
        """Return whether a slot of an axis' controller is in the axis; ``others.NAME`` is where ``controller`` is."""
        return self.division == "controller" or slot in _LOCAL[self.division]


@dataclass(frozen=True)
class Axis:
    """One axis: plant, friction, drive and sensors.

    Parameters
    ----------
    name : str
    plant : Plant
    friction, drive : Component
    sensor : Component
        Measures the load, as a linear scale does.
    disturbance : Component or None
    error : AxisError
    limits : Limits
    mounted_on : str
        Name of the axis that carries this one; empty for none.
    alignment : float
        Cosine of the angle to the direction of the axis `mounted_on`, 0 for crossed axes. If it is not 0, each axis feels the other's
        acceleration, one tick late: the moved mass of the upper axis times that acceleration and the cosine. Positions stay along each
        axis' own guide.
    stage_mass : float [kg], >= 0
        Mass of the whole module, moved mass included, as carried by the axis `mounted_on`.
    substeps : int, >= 1
        Integration steps of the plant for each servo period.
    motor_friction : Component
        Acts on the motor side, if the motor can differ in position.
    motor_sensor : Component
        The motor's encoder, in load units.
    origins : mapping of str to Origin
        Source of `stage_mass`; components, limits and error have their own.
    correlations : tuple of (str, str, float)
        Pairs of values fitted together: their names, such as ``plant.mass`` and ``friction.coulomb``, and the coefficient.
    """

    name: str
    plant: Plant
    friction: Component = field(default_factory=NoFriction)
    drive: Component = field(default_factory=Saturation)
    sensor: Component = field(default_factory=IdealSensor)
    disturbance: Component | None = None
    error: AxisError = field(default_factory=AxisError)
    limits: Limits = field(default_factory=Limits)
    mounted_on: str = field(default="", metadata=setting(check=str))
    alignment: float = field(default=0.0, metadata=setting(minimum=-1.0, maximum=1.0))
    stage_mass: float = field(default=0.0, metadata=setting("kg", minimum=0.0))
    substeps: int = field(default=1, metadata=setting(minimum=1, maximum=1000))
    motor_friction: Component = field(default_factory=NoFriction)
    motor_sensor: Component = field(default_factory=IdealSensor)
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)
    correlations: tuple[tuple[str, str, float], ...] = field(default=(), compare=False, repr=False)

    def __repr__(self) -> str:
        slots = {slot: getattr(self, slot) for slot in ("plant", "friction", "drive", "sensor")}
        return facts_line("Axis", {"name": self.name, **{slot: part.kind for slot, part in slots.items()}})


@dataclass(frozen=True)
class Machine:
    """Axes in the order of the path's coordinates.

    Parameters
    ----------
    name : str
    axes : tuple of Axis
    servo_period : float [s], > 0
    squareness : mapping of (str, str) to float [rad]
        Deviation from 90 degrees of two axes: the tool moves along the first one by `squareness` times the second one's position.
    origins : mapping of str to Origin
        Sources of `servo_period` and the angles (``squareness.x-y``).
    correlations : tuple of (str, str, float)
        Of values fitted together on two axes, such as ``x.plant.damping``; those within one axis are in `Axis`.
    control : ControlFile or None
        The control's own file from which it was read.
    path_velocity : float [m/s], > 0
        Largest velocity along a planned path, rapids included.
    planner : {"jerk", "grbl", "linuxcnc"} or None
        How the control plans, see `contourlab.feed.trapezoids`; None stands for ``"jerk"``.
    junction_deviation, arc_tolerance : float [m], or None
        Of the planner of grbl; None stands for its defaults.
    planner_blocks : int or None
        Of this planner or LinuxCNC's; the same.
    kink_ratio, gap_cycles, largest_override : float [1], or None
        Of the planner of LinuxCNC; the same.

    Raises
    ------
    ParameterError
        If the servo period is not positive, names repeat, axes carry each other in a circle, or an axis does not fit its plant.
    """

    name: str = field(metadata=setting(maximum=200))
    axes: tuple[Axis, ...]
    servo_period: float = field(metadata=setting("s", "ms", minimum=0.0, maximum=1.0, exclusive=True))
    squareness: Mapping[tuple[str, str], float] = field(default_factory=dict)
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)
    correlations: tuple[tuple[str, str, float], ...] = field(default=(), compare=False, repr=False)
    control: ControlFile | None = field(default=None, compare=False, repr=False)
    path_velocity: float = field(default=math.inf, metadata=setting("m/s", "mm/min", *RANGES["velocity"]))
    planner: Planner | None = None
    junction_deviation: float | None = field(default=None, metadata=setting("m", "um", minimum=0.0, maximum=1.0))
    arc_tolerance: float | None = field(default=None, metadata=setting("m", "um", minimum=1e-9, maximum=1.0))
    planner_blocks: int | None = field(default=None, metadata=setting(minimum=3, maximum=1000))
    kink_ratio: float | None = field(default=None, metadata=setting(minimum=0.001, maximum=0.7071))
    gap_cycles: float | None = field(default=None, metadata=setting(minimum=0.0, maximum=1000.0))
    largest_override: float | None = field(default=None, metadata=setting(minimum=1.0, maximum=100.0))

    def __post_init__(self) -> None:
        if not (math.isfinite(self.servo_period) and self.servo_period > 0.0):
            raise ParameterError("servo_period", f"{self.servo_period:g}", "> 0", "s")
        names = self.axis_names
        if not names or len(set(names)) != len(names):
            raise ParameterError("axes", ", ".join(names) or "none", "at least one axis, all with different names")
        for axis in self.axes:
            if axis.mounted_on and (axis.mounted_on not in names or axis.name in self.carriers(axis.name)):
                raise ParameterError(f"axes.{axis.name}.mounted_on", axis.mounted_on, "another axis of the machine, without a cycle")
            self._check_masses(axis)
            self._check_motor_side(axis)
            self._check_step(axis)
            self._check_drive(axis)
        for pair in self.squareness:
            if len(pair) != 2 or pair[0] == pair[1] or not set(pair) <= set(names):
                raise ParameterError("squareness", "-".join(pair), "two different axes of the machine")

    def __repr__(self) -> str:
        period = f"{1e3 * self.servo_period:g} ms"
        return facts_line("Machine", {"name": self.name, "axes": ", ".join(self.axis_names), "servo period": period})

    def check_modelled(self) -> None:
        """Refuse an axis with a stand-in for its plant, because the control's own file does not say how it answers.

        Raises
        ------
        ParameterError
            If there is one.
        """
        if self.control is not None and self.control.unmodelled:
            names, why = list(self.control.unmodelled), next(iter(self.control.unmodelled.values()))
            given = f'machine = {{file = "{self.control.file.name}"}} and [axes.{names[0]}] file = "axis.toml"'
            bound = f"given in a scenario, with {given}: {why}"
            raise ParameterError("plant", f"unknown for {listing(names)}", bound)

    def planned_as(self, planner: Planner | None) -> Machine:
        """Return the machine with another planner, without the buffer of its own; the same for None."""
        if planner in (None, self.planner):
            return self
        return replace(self, planner=planner, planner_blocks=None if self.planner else self.planner_blocks)

    @property
    def own_planner(self) -> Grbl | LinuxCNC | None:
        """The planner of the control, if it has no limits of jerk."""
        own = LINUXCNC if self.planner == "linuxcnc" else GRBL
        given = {name: value for name in own if (value := getattr(self, name)) is not None}
        if self.planner == "linuxcnc":
            return LinuxCNC(cycle=self.servo_period, **given)
        steps = tuple(getattr(axis.plant, "pulse", 0.0) for axis in self.axes)
        return Grbl(**given, steps=steps) if self.planner == "grbl" else None

    def planner_limits(self) -> AxisLimits:
        """Return the limits of the axes and of the path, for the planner.

        Raises
        ------
        FeedError
            If an axis has no velocity limit, or neither an acceleration nor a jerk limit.
        """
        free = [axis for axis in self.axes if not np.isfinite(axis.limits.velocity)]
        if free:
            raise FeedError(f"{self._place(free[0])} has no velocity limit: set limits.velocity")
        per_axis = [axis.limits for axis in self.axes]
        planner = self.own_planner
        jerk = np.inf if planner is not None else [x.jerk for x in per_axis]
        moving = [x.velocity for x in per_axis], [x.acceleration for x in per_axis]
        limits = AxisLimits(*moving, jerk, path_velocity=self.path_velocity, planner=planner)
        if limits.unbounded.any():
            steep = self.axes[int(np.argmax(limits.unbounded))]
            raise FeedError(f"{self._place(steep)} has no acceleration or jerk limit: set limits.acceleration, limits.jerk, or both")
        return limits

    def _place(self, axis: Axis) -> str:
        """Return an axis in words, with the file of its limits."""
        return f"{axis.limits.file}: axis {axis.name} of {self.name}".removeprefix(": ")

    def _check_masses(self, axis: Axis) -> None:
        """Raise if a loaded plant is known by its response only: its moved mass is unknown."""
        carried = self.carried_mass(axis.name)
        if carried and not axis.plant.knows_mass:
            bound = f"a plant with a carried_mass, because the axis carries {carried:g} kg; or delete stage_mass"
            raise ParameterError(f"axes.{axis.name}.plant", f'"{axis.plant.kind}"', bound)
        below = self.axis(axis.mounted_on).plant if axis.mounted_on and axis.alignment else axis.plant
        for plant in (axis.plant, below):
            if axis.alignment and not ({"mass", "carried_mass"}.issubset((*plant.numeric(), *plant.derived)) and plant.force_unit == "N"):
                bound = f'0 with a "{plant.kind}" plant, which has no mass and carried_mass'
                raise ParameterError(f"axes.{axis.name}.alignment", f"{axis.alignment:g}", bound)

    def _check_step(self, axis: Axis) -> None:
        """Raise if the axis needs more sub-steps: the Runge-Kutta step is stable up to a decay by friction of 2.78 per step."""
        plant = self.loaded_plant(axis.name)
        for slot, friction in (("friction", axis.friction), ("motor_friction", axis.motor_friction)) if plant.steps_itself else ():
            if not isinstance(friction, NoFriction) and (slot == "motor_friction" or not plant.mobilities()):
                why = "takes no friction at its motor" if slot == "motor_friction" else 'names no "mobility_value" of its load'
                bound = f'"none": a {plant.kind} {why}; or put the friction into its step'
                raise ParameterError(f"axes.{axis.name}.{slot}", f'"{friction.kind}"', bound)
        asked: Any = plant.fewest_substeps(self.servo_period)
        if not (isinstance(asked, tuple) and len(asked) == 2):
            raise fault(type(plant), f"fewest_substeps returns {asked!r}: write a number and the reason", type(plant).fewest_substeps)
        wanted, why = asked
        refuse(axis.substeps < wanted, ParameterError, f"axes.{axis.name}.substeps", f"{axis.substeps}", f"at least {wanted} for {why}")
        for friction, mobility in zip((axis.friction, axis.motor_friction), () if plant.steps_itself else plant.mobilities(), strict=False):
            steepest = getattr(type(friction), "steepest", None)
            decay = mobility * steepest(friction.constants()) * self.servo_period if steepest is not None else 0.0
            if decay / axis.substeps > 2.78:
                fewest = math.ceil(decay / 2.5)
                bound = f"at least {fewest} for so steep a {friction.kind} friction; or make it less steep, or use one that sticks"
                raise ParameterError(f"axes.{axis.name}.substeps", f"{axis.substeps}", bound)

    def _check_motor_side(self, axis: Axis) -> None:
        """Raise if a plant without a separate motor has parts on the motor side."""
        for slot in ("motor_friction", "motor_sensor"):
            part = getattr(axis, slot)
            if not axis.plant.two_sided and not isinstance(part, NoFriction | IdealSensor):
                bound = f"left out: a {axis.plant.kind} has no separate motor side"
                raise ParameterError(f"axes.{axis.name}.{slot}", f'"{part.kind}"', bound)

    def _check_drive(self, axis: Axis) -> None:
        """Raise if a drive cannot pass on the commands of the plant: positions begin where the axis stands, all others at zero."""
        drive, plant = axis.drive, axis.plant
        fits = drive.command_unit == "m"
        fits = fits or drive == Saturation() if plant.takes_position else not fits
        if not fits:
            fitting = '"step-generator", "position-lag", or left out' if plant.takes_position else "another one"
            bound = f"{fitting}: the commands of a {plant.kind} are in {plant.command_unit}"
            raise ParameterError(f"axes.{axis.name}.drive", f'"{drive.kind}"', bound)

    @property
    def axis_names(self) -> tuple[str, ...]:
        """Names of the axes, in order."""
        return tuple(axis.name for axis in self.axes)

    def axis(self, name: str) -> Axis:
        """Return an axis by name."""
        return next(axis for axis in self.axes if axis.name == name)

    def carriers(self, name: str) -> list[str]:
        """Return the axes that carry `name`, nearest first."""
        carriers: list[str] = []
        below = self.axis(name).mounted_on
        while below and below not in carriers:
            carriers.append(below)
            below = self.axis(below).mounted_on
        return carriers

    def carried_mass(self, name: str) -> float:
        """Return the mass [kg] of all modules mounted on an axis."""
        return sum(axis.stage_mass for axis in self.axes if name in self.carriers(axis.name))

    def loaded_plant(self, name: str) -> Plant:
        """Return the plant of an axis with everything mounted on it."""
        plant: Plant = self.axis(name).plant.loaded(self.carried_mass(name))
        return plant

    def swapped(self, name: str, other: Axis) -> Machine:
        """Return the machine with one axis exchanged for another module, which takes its name and place."""
        placed = replace(other, name=name, mounted_on=self.axis(name).mounted_on, alignment=self.axis(name).alignment)
        apart = tuple(pair for pair in self.correlations if name not in (one.partition(".")[0] for one in pair[:2]))
        return replace(self, axes=tuple(placed if axis.name == name else axis for axis in self.axes), correlations=apart)


def require_loops(machine: Machine) -> None:
    """Raise ParameterError if every axis takes positions: then the control closes no loop that has gains or margins."""
    if all(axis.plant.takes_position for axis in machine.axes):
        kinds = ", ".join(dict.fromkeys(axis.plant.kind for axis in machine.axes))
        raise ParameterError("plant", kinds, "one whose loop the control closes: this one takes positions, and has no gains and no margins")


AXIS_SLOTS = ("plant", "friction", "motor_friction", "drive", "sensor", "motor_sensor", "disturbance")
"""Component slots of an axis."""

CONTROLLER_SLOTS = ("predictor", "velocity", "observer", "gap_observer", "feedforward", "compensation", "supervisor", "controller")
"""Component slots of an axis' controller, in the order of a tick."""

NAMED_SLOTS = ("others", "filters")
"""Slots of an axis' controller that hold any number of components, each with a name."""

SIDES = ("load", "motor")


@dataclass(frozen=True)
class AxisController:
    """Components of an axis' controller.

    Parameters
    ----------
    controller, velocity : Component
    observer, predictor, feedforward : Component or None
    local : tuple of str
        Parameters that move with the axis when it is swapped. The base of a `link` is the same for all axes, so they may only be of the
        part in the axis.
    gap_observer, compensation : Component or None
    supervisor : Component or None
        Chooses between `controller`, number 0, and those of `others`, numbers 1, 2 ...
    others : dict of str: Component, kept as a tuple of pairs
        Further controllers by name.
    filters : dict of str: Component, kept as a tuple of pairs
        Filters by name, in the order in which the command passes them on its way to the drive.
    feedback, velocity_feedback : {"load", "motor"}
        Side of a drive with backlash on which position and velocity are measured.
    link : Division or None
        Puts part of the controller in the axis and the rest in the base.

    Raises
    ------
    ParameterError
        If components do not fit together, or `local` names a parameter that cannot move with the axis.
    """

    controller: Component = field(default_factory=PositionController)
    velocity: Component = field(default_factory=TrueVelocity)
    observer: Component | None = None
    predictor: Component | None = None
    feedforward: Component | None = None
    local: tuple[str, ...] = field(default=(), metadata=setting())
    gap_observer: Component | None = None
    compensation: Component | None = None
    supervisor: Component | None = None
    others: tuple[tuple[str, Component], ...] = ()
    filters: tuple[tuple[str, Component], ...] = ()
    feedback: str = field(default="load", metadata=setting(choices=SIDES))
    velocity_feedback: str = field(default="motor", metadata=setting(choices=SIDES))
    link: Division | None = None

    @property
    def controllers(self) -> dict[str, Component]:
        """All controllers of the axis by name, in the order of their numbers; the first is called ``controller``."""
        return {"controller": self.controller, **dict(self.others)}

    @property
    def parts(self) -> dict[str, Component]:
        """All components of the axis' controller by their slots, such as ``others.NAME``; those of a link are not among them."""
        slots = {slot: getattr(self, slot) for slot in CONTROLLER_SLOTS}
        slots |= {f"{slot}.{label}": part for slot in NAMED_SLOTS for label, part in getattr(self, slot)}
        return {slot: part for slot, part in slots.items() if part is not None}

    def __post_init__(self) -> None:
        for slot in NAMED_SLOTS:
            try:
                object.__setattr__(self, slot, tuple(dict(getattr(self, slot)).items()))
            except (TypeError, ValueError) as error:
                raise ParameterError(slot, repr(getattr(self, slot)), "components by their names") from error
        for name in ("feedback", "velocity_feedback"):
            refuse(getattr(self, name) not in SIDES, ParameterError, name, repr(getattr(self, name)), "one of " + ", ".join(SIDES))
        if bool(self.others) != (self.supervisor is not None):
            shown = '"none"' if self.supervisor is None else f'"{self.supervisor.kind}"'
            raise ParameterError("supervisor", shown, "given if the axis has several controllers, and only then")
        chosen_from = getattr(self.supervisor, "n_controller", 1)
        if chosen_from != 1 + len(self.others):
            bound = f"{chosen_from - 1}: the supervisor chooses from {chosen_from}"
            raise ParameterError("others", f"{len(self.others)} controllers", bound)
        uses = any(part is not None and part.takes("velocity") for part in (self.controller, self.observer))
        if self.predictor is not None and uses and isinstance(self.velocity, TrueVelocity):
            raise ParameterError("velocity", '"true"', 'computed from the predicted position, for example by "filtered-difference"')
        if self.link is not None:
            self._check_link(self.link)

    def __repr__(self) -> str:
        return facts_line("AxisController", {slot: part.kind for slot, part in self.parts.items()})

    def _check_link(self, link: Division) -> None:
        if self.predictor is not None and link.division == "observer":
            wanted = '"drive" or "controller": the observer needs the velocity after the predictor, which is in the base'
            raise ParameterError("link.division", '"observer"', wanted)
        for name in self.local:
            if not link.is_local(name.partition(".")[0]):
                wanted = f'a parameter of a part in the axis; division = "{link.division}" leaves this one in the base'
                raise ParameterError("local", repr(name), wanted)

    @property
    def local_parameters(self) -> tuple[str, ...]:
        """Names of the parameters that may move with the axis: `local`, or else all parameters of the parts in the axis."""
        if self.local or self.link is None:
            return self.local
        local = {slot: part for slot, part in self.parts.items() if self.link.is_local(slot.partition(".")[0])}
        return tuple(f"{slot}.{name}" for slot, part in local.items() for name in part.numeric())


@dataclass(frozen=True)
class Controller:
    """One controller for each axis, and their coupling.

    Parameters
    ----------
    axes : mapping of str to AxisController
    estimator : Component or None
        Contour-error estimator.
    coupling : Component or None
        Sees all axes; requires an estimator if it takes an estimate.

    Raises
    ------
    ParameterError
        If there is a coupling without the estimator that it needs, or an axis sends the base no position.
    """

    axes: Mapping[str, AxisController]
    estimator: Component | None = None
    coupling: Component | None = None

    def __post_init__(self) -> None:
        needed = [name for name in ESTIMATES if self.coupling is not None and self.coupling.takes(name)]
        if self.coupling is not None and needed and self.estimator is None:
            raise ParameterError("controller.coupling", self.coupling.kind, f"given with an estimator, because it uses its {needed[0]}")
        blind = [name for name, axis in self.axes.items() if axis.link is not None and axis.link.up is None]
        for slot, part in (("estimator", self.estimator), ("coupling", self.coupling)):
            if part is not None and blind:
                wanted = f"left out, because axis {blind[0]} sends no position to the base: its link goes one way"
                raise ParameterError(f"controller.{slot}", f'"{part.kind}"', wanted)

    def __repr__(self) -> str:
        parts = {"estimator": self.estimator, "coupling": self.coupling}
        kinds = {slot: part.kind for slot, part in parts.items() if part is not None}
        return facts_line("Controller", {**{name: axis.controller.kind for name, axis in self.axes.items()}, **kinds})
