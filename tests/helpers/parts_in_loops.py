"""Every shipped component in a loop of two axes."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from component_rig import make
from stages import control, stage

import contourlab as cl
from contourlab.components.contract import Component
from contourlab.components.registry import components
from contourlab.loop import Division

KINDS = [kind for kind in components() if kind.family != "learning"]
_SUBSTEPS = {"two-inertia": 2, "smooth-coulomb": 4}
_TAKES_POSITIONS = ("step-drive", "stepper", "position-lag", "step-generator", "steps")


def _example(family: str, kind: str) -> Component:
    return make(family, kind, **next(one for one in KINDS if (one.family, one.kind) == (family, kind)).example)


def _each_axis(given: cl.Controller, /, **parts: Any) -> cl.Controller:
    return replace(given, axes={name: replace(axis, **parts) for name, axis in given.axes.items()})


def loop_with(kind: type[Component]) -> tuple[cl.Machine, cl.Controller]:
    """Return a machine and its controller with the example of a component in each axis."""
    part: Any = kind(**kind.example)
    family, name = kind.family, kind.kind
    moved: dict[str, Any] = {"substeps": _SUBSTEPS.get(name, 1)}
    controller = control()
    if name in _TAKES_POSITIONS:
        moved |= {
            "plant": _example("plant", "stepper"),
            "drive": make("drive", "step-generator"),
            "sensor": make("sensor", "ideal"),
            "substeps": 8,
        }
        controller = cl.Controller({axis: cl.AxisController(make("controller", "steps")) for axis in "xy"})
    elif family in ("supervisor", "gap_observer") or "zone" in name:
        moved |= {"plant": _example("plant", "two-inertia"), "substeps": 2}
    if family in ("plant", "friction", "drive", "sensor", "disturbance"):
        moved |= {family: part}
    elif family == "link":
        controller = _each_axis(controller, link=Division("controller", part, part))
    elif family == "filter":
        controller = _each_axis(controller, filters=(("one", part),))
    elif family == "supervisor":
        others = tuple((f"other{i}", _example("controller", "cascade")) for i in range(1, part.n_controller))
        watched = _example("gap_observer", "multiple-model") if part.takes("confidence") else None
        controller = _each_axis(controller, supervisor=part, others=others, gap_observer=watched)
    elif family in ("estimator", "coupling"):
        controller = replace(controller, **{family: part})
    else:
        controller = _each_axis(controller, **{family: part})
    return stage(**moved), controller
