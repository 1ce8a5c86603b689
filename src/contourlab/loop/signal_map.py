"""Which signals of the servo loop a result can have."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from contourlab.engine.schedule import Late
from contourlab.loop.builder import Builder
from contourlab.loop.sensing import Sensing
from contourlab.loop.sum_nodes import constant_node

NOTHING = "none.value"
"""Signal of an axis that has not got what others have: zero."""

_OBSERVED = {
    "gap_estimate": "gap",
    "gap_deviation": "gap_deviation",
    "gap_state_estimate": "gap_state",
    "gap_confidence": "confidence",
    "load_position_estimate": "load_position",
    "load_velocity_estimate": "load_velocity",
}


def signal_map(builder: Builder, sensing: Mapping[str, Sensing]) -> dict[str, tuple[str, ...]]:
    """Return where the signals of a result stand: name -> one signal per axis, or one for the machine."""

    def plain(wire: Any) -> str:
        return str(wire.signal if isinstance(wire, Late) else wire)

    found = {
        "position": tuple(plain(sensing[name].measured) for name in builder.names),
        "axis_position": tuple(f"{name}.plant.position" for name in builder.names),
        "axis_velocity": tuple(f"{name}.plant.velocity" for name in builder.names),
        "velocity": tuple(plain(sensing[name].velocity) for name in builder.names),
        "command": tuple(builder.arrived.get(name, builder.command(name)) for name in builder.names),
        "applied_command": tuple(f"{name}.drive.applied" for name in builder.names),
    }
    found |= _inside(builder)
    if all(builder.controller.axes[name].observer is not None for name in builder.names):
        found["disturbance_estimate"] = tuple(f"{name}.observer.disturbance_estimate" for name in builder.names)
    if builder.controller.estimator is not None:
        found["contour_error_estimate"] = ("estimator.contour_error_estimate",)
    for output, signal in (("modified_reference", "modified_reference"), ("correction", "coupling_command")):
        if builder.coupled(output):
            found[signal] = tuple(f"coupling.{output}[{j}]" for j in range(len(builder.names)))
    return found


def _inside(builder: Builder) -> dict[str, tuple[str, ...]]:
    """Return the signals of what only some axes have inside: zero, or those of the load, for the others."""
    split = {axis.name: axis.plant.two_sided for axis in builder.machine.axes}
    led = {name: builder.controller.axes[name].supervisor is not None for name in builder.names}
    watched = {name: builder.controller.axes[name].gap_observer is not None for name in builder.names}
    groups: tuple[tuple[dict[str, bool], dict[str, tuple[str, str]]], ...] = (
        (split, {f"motor_{what}": (f"plant.motor_{what}", f"plant.{what}") for what in ("position", "velocity")}),
        (split, {"gap_state": ("plant.gap_state", NOTHING), "shaft_force": ("plant.shaft_force", NOTHING)}),
        (led, {"active_controller": ("supervisor.active", NOTHING), "switch_reason": ("supervisor.reason", NOTHING)}),
        (watched, {signal: (f"gap_observer.{port}", NOTHING) for signal, port in _OBSERVED.items()}),
    )
    found: dict[str, tuple[str, ...]] = {}
    for having, signals in groups:
        for signal, (there, otherwise) in signals.items() if any(having.values()) else ():
            found[signal] = tuple(f"{name}.{there if having[name] else otherwise}" for name in builder.names)
    for name in {wire.partition(".")[0] for wires in found.values() for wire in wires if wire.endswith(NOTHING)}:
        builder.nodes.append(constant_node(f"{name}.{NOTHING.partition('.')[0]}"))
    return found
