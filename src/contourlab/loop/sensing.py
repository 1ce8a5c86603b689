"""Measured positions and velocities on both sides of a drive, as the controller of the axis sees them."""

from __future__ import annotations

from typing import Any

from contourlab.components.ideal import IdealSensor, TrueVelocity
from contourlab.engine.schedule import Late, Node
from contourlab.engine.step import Port, Step
from contourlab.errors import ParameterError
from contourlab.loop.builder import Builder
from contourlab.loop.machine import SIDES, Axis
from contourlab.primitives import select


class Sensing:
    """Sensors, predictor and velocity of one axis: adds the nodes and returns the wires.

    For a single-mass plant both sides are the same.

    Parameters
    ----------
    builder : Builder
        Collects the nodes.
    at : float [m]
        Initial position of the axis.
    """

    def __init__(self, builder: Builder, axis: Axis, at: float) -> None:
        self.builder, self.axis, self.name, self.at = builder, axis, axis.name, at
        self.parts = builder.controller.axes[axis.name]
        self._velocities: dict[str, str] = {}
        for side, slot in zip(SIDES, ("sensor", "motor_sensor"), strict=True):
            sensor = getattr(axis, slot)
            if not isinstance(sensor, IdealSensor):
                start = at if slot == "sensor" else builder.motor_start(axis.name)
                wires = {"position": Late(self._signal(side, "position"))}
                builder.add(f"{axis.name}.{slot}", sensor, f"axes.{axis.name}.{slot}", wires, start)
        prefix = f"controller.axes.{self.name}"
        if self.parts.predictor is not None:
            seen = {"position": self.measured, "applied": self.sent}
            builder.add(f"{self.name}.predictor", self.parts.predictor, f"{prefix}.predictor", seen, at)
        # Computed before every part that may need it.
        self.velocity_on(self.parts.velocity_feedback)

    def _signal(self, side: str, what: str) -> str:
        return f"{self.name}.plant.{'motor_' if side == 'motor' and self.axis.plant.two_sided else ''}{what}"

    def position_on(self, side: str) -> Any:
        """Return the wire of the position measured on a side."""
        slot = "motor_sensor" if side == "motor" and self.axis.plant.two_sided else "sensor"
        ideal = isinstance(getattr(self.axis, slot), IdealSensor)
        return Late(self._signal(side, "position")) if ideal else f"{self.name}.{slot}.position"

    def velocity_on(self, side: str) -> Any:
        """Return the wire of the velocity on a side, computed from the position measured there."""
        if isinstance(self.parts.velocity, TrueVelocity):
            return Late(self._signal(side, "velocity"))
        if not self.axis.plant.two_sided:
            side = self.parts.velocity_feedback
        if side not in self._velocities:
            predicted = self.parts.predictor is not None and side == self.parts.velocity_feedback
            node = f"{self.name}.velocity" if side == self.parts.velocity_feedback else f"{self.name}.{side}_velocity"
            wires = {"position": self.position if predicted else self.position_on(side)}
            start = self.builder.motor_start(self.name) if side == "motor" else self.at
            self.builder.add(node, self.parts.velocity, f"controller.axes.{self.name}.velocity", wires, start)
            self._velocities[side] = f"{node}.velocity"
        return self._velocities[side]

    @property
    def measured(self) -> Any:
        """Wire of the position that the position loop uses."""
        return self.position_on(self.parts.feedback)

    @property
    def sent(self) -> Any:
        """Wire of the last command that the drive accepted, as a predictor knows it; in the base it does not know the filters."""
        return self.builder.accepted(self.name) if self.builder.controlled_from_base(self.name) else self.builder.drive_accepted(self.name)

    @property
    def position(self) -> Any:
        """Wire of the position that the controller sees: measured, or predicted."""
        return self.measured if self.parts.predictor is None else f"{self.name}.predictor.position"

    @property
    def velocity(self) -> Any:
        """Wire of the velocity that the controller sees."""
        return self.velocity_on(self.parts.velocity_feedback)

    def both_sides(self, port: str) -> Any:
        """Return the wire of a measured signal, such as ``motor_position`` or ``load_velocity``.

        With feedback from the motor side and a gap observer, the observer's estimates replace the measurements of the load.
        """
        side, _, what = port.partition("_")
        if side == "load" and self.parts.gap_observer is not None and self.parts.feedback == "motor":
            return f"{self.name}.gap_observer.{port}"
        return self.position_on(side) if what == "position" else self.velocity_on(side)

    def observed_gap(self, port: str) -> Any:
        """Return the wire of an output of the gap observer; the gap estimate is zero without an observer or below `SURE`.

        Raises
        ------
        ParameterError
            If a part needs the state of the gap and there is no gap observer.
        """
        if self.parts.gap_observer is None:
            if port == "gap_estimate":
                return 0.0
            raise ParameterError(f"controller.axes.{self.name}.gap_observer", '"none"', "given: the supervisor needs its outputs")
        observer, node = f"{self.name}.gap_observer", f"{self.name}.trusted_gap"
        if port != "gap_estimate":
            return f"{observer}.{port}"
        if all(known.name != node for known in self.builder.nodes):
            wires = {"gap": f"{observer}.gap", "confidence": f"{observer}.confidence"}
            self.builder.nodes.append(Node(node, _TRUSTED, wires, {}))
        return f"{node}.gap"


SURE = 0.9
"""Confidence from which the size of an observed gap replaces the controllers' own `backlash_gap`."""


def _trusted(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (select(inp.confidence >= SURE, inp.gap, 0.0),)


_TRUSTED = Step("trusted gap", _trusted, (), (), "", (), (Port("gap"), Port("confidence")), (Port("gap"),))
