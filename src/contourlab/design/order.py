"""The order in which the numbers of a controller are calibrated."""

from __future__ import annotations

from contourlab.components.contract import Component
from contourlab.loop import Controller, Machine


def calibration_order(machine: Machine, controller: Controller) -> tuple[str, ...]:
    """Return the dotted names of what is calibrated, from the innermost loop to the outermost, feedforward last.

    Notes
    -----
    First the disturbance observers, then the position controllers, then a coupling that corrects commands, then feedforward; in each group
    the last axis comes first. On the paper's stage that is its own order (section IV): b_hat_3, a_hat_3, b_hat_2, a_hat_2, K_V3, K_P3,
    K_I3, K_V2, K_P2, K_I2, b'_3, a'_3, b'_2, a'_2. Its lambda, a choice between contour and tracking error, is left alone there and here.

    What a component leaves to be calibrated it says itself, in `calibrated` and `calibrated_ahead`.
    """
    axes = [(name, controller.axes[name]) for name in reversed(machine.axis_names)]
    found: list[str] = []

    def collect(prefix: str, part: Component | None, ahead: bool) -> None:
        if part is not None:
            found.extend(f"{prefix}.{name}" for name in (part.calibrated_ahead if ahead else part.calibrated))

    for slot in ("observer", "controller"):
        for name, mine in axes:
            collect(f"controller.axes.{name}.{slot}", getattr(mine, slot), False)
    if controller.coupling is not None and any(port.name == "correction" for port in controller.coupling.outputs):
        collect("controller.coupling", controller.coupling, False)
    for name, mine in axes:
        for slot in ("controller", "feedforward"):
            collect(f"controller.axes.{name}.{slot}", getattr(mine, slot), True)
    return tuple(found)
