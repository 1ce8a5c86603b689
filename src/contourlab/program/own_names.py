"""Named parameters that the interpreter keeps, such as #<_metric> and #<_x>."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from contourlab.program.parameters import SELECTED_SYSTEM, Parameters
from contourlab.program.state import ModalState

_VERSION = 2.9
"""The language read here is that of LinuxCNC 2.9."""
_PLANES = {"XY": 170.0, "ZX": 180.0, "YZ": 190.0}
_SYSTEMS = (540.0, 550.0, 560.0, 570.0, 580.0, 590.0, 591.0, 592.0, 593.0)


def own_names(state: ModalState, parameters: Parameters, line: Callable[[], int]) -> Mapping[str, Callable[[], float]]:
    """Return what returns the value of each name, in the units in force.

    Parameters
    ----------
    state : ModalState
    parameters : Parameters
    line : callable
        Returns the number of the line that is read.
    """
    names: dict[str, Callable[[], float]] = {
        "_vmajor": lambda: _VERSION,
        "_vminor": lambda: 0.0,
        "_line": lambda: float(line()),
        "_motion_mode": lambda: -1.0 if state.motion is None else float(state.motion),
        "_plane": lambda: _PLANES[state.plane],
        "_ccomp": lambda: 400.0,
        "_metric": lambda: float(state.millimetres),
        "_imperial": lambda: float(not state.millimetres),
        "_absolute": lambda: float(state.absolute),
        "_incremental": lambda: float(not state.absolute),
        "_inverse_time": lambda: float(state.feed_mode == "inverse_time"),
        "_units_per_minute": lambda: float(state.feed_mode == "per_minute"),
        "_units_per_rev": lambda: float(state.feed_mode == "per_turn"),
        "_coord_system": lambda: _SYSTEMS[int(parameters.number(SELECTED_SYSTEM)) - 1],
        "_tool_offset": lambda: float(any(state.frame.tool)),
        "_retract_r_plane": lambda: float(state.back_to_clearance),
        "_retract_old_z": lambda: float(not state.back_to_clearance),
        "_spindle_rpm_mode": lambda: 1.0,
        "_spindle_css_mode": lambda: 0.0,
        "_ijk_absolute_mode": lambda: float(state.absolute_centre),
        "_lathe_diameter_mode": lambda: float(state.diameter),
        "_lathe_radius_mode": lambda: float(not state.diameter),
        "_spindle_on": lambda: float(state.turning != 0),
        "_spindle_cw": lambda: float(state.turning == 1),
        "_feed": lambda: state.shown(state.feedrate) * (1.0 if state.feed_mode == "per_turn" else 60.0),
        "_rpm": lambda: state.speed,
        "_current_tool": lambda: float(state.tools.current),
        "_selected_tool": lambda: float(state.tools.selected),
        "_value": lambda: parameters.returned or 0.0,
        "_value_returned": lambda: float(parameters.returned is not None),
        "_call_level": lambda: float(parameters.depth),
        "_remap_level": lambda: 0.0,
        "_task": lambda: 0.0,
    }
    for axis, letter in enumerate("xyz"):
        names[f"_{letter}"] = lambda axis=axis: state.shown_position()[axis]  # type: ignore[misc]  # the default binds it
        names[f"_abs_{letter}"] = lambda axis=axis: state.shown(state.axes[axis])  # type: ignore[misc]
    for letter in "abcuvw":
        names[f"_{letter}"] = names[f"_abs_{letter}"] = lambda: 0.0
    return names
