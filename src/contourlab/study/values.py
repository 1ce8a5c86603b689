"""Parameters of a machine and its controller by dotted name: order them, and find the axes they affect."""

from __future__ import annotations

from contourlab.components.contract import Component
from contourlab.loop import Controller, Machine


def axes_of(name: str, machine: Machine) -> tuple[str, ...]:
    """Return the axes that a parameter affects: its own axis, or all axes for a parameter of the coupling."""
    words = name.split(".")
    return (words[words.index("axes") + 1],) if "axes" in words[:-1] else machine.axis_names


def calibration_order(machine: Machine, controller: Controller) -> tuple[str, ...]:
    """Return the dotted names of all parameters to calibrate, from the innermost loop to the outermost, feedforward last.

    Notes
    -----
    First the disturbance observers, then the position controllers, then a coupling that corrects commands, then feedforward; in each group
    the last axis comes first. For the paper's stage this is the paper's order (section IV): b_hat_3, a_hat_3, b_hat_2, a_hat_2, K_V3, K_P3,
    K_I3, K_V2, K_P2, K_I2, b'_3, a'_3, b'_2, a'_2. Its lambda, a choice between contour and tracking error, is not calibrated.

    A component names its parameters to calibrate in `calibrated` and `calibrated_ahead`.
    """
    axes = [(name, controller.axes[name]) for name in reversed(machine.axis_names)]
    names: list[str] = []

    def collect(prefix: str, part: Component | None, ahead: bool) -> None:
        if part is not None:
            names.extend(f"{prefix}.{name}" for name in (part.calibrated_ahead if ahead else part.calibrated))

    for slot in ("observer", "controller"):
        for name, axis in axes:
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), False)
    if controller.coupling is not None and any(port.name == "correction" for port in controller.coupling.outputs):
        collect("controller.coupling", controller.coupling, False)
    for name, axis in axes:
        for slot in ("controller", "feedforward"):
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), True)
    return tuple(names)
