"""contourlab: contour errors of multi-axis machines, and the controllers that reduce them.

The names below are the public interface. Each is imported at first use, so that ``import contourlab`` is fast.

>>> import contourlab as cl
>>> path = cl.contour("circle", radius=0.02)
>>> round(path.length, 4)
0.1257
"""

from __future__ import annotations

import importlib
from typing import Any

__version__ = "0.1.0"

_HOMES = {
    "contourlab.app.cite": ("cite",),
    "contourlab.analysis.learning.learning_analysis": ("learning_analysis",),
    "contourlab.analysis.linear.contour_transfer": ("contour_margins", "internal_stability"),
    "contourlab.analysis.linear.systems": ("from_system", "linear"),
    "contourlab.components.conformance": ("check_component",),
    "contourlab.components.contract": ("Component", "Port", "param", "text_param"),
    "contourlab.components.registry": ("component", "load_plugin"),
    "contourlab.scenario.translation": ("translate",),
    "contourlab.contours": ("read_contour",),
    "contourlab.errors": ("ContourlabError", "DivergenceError"),
    "contourlab.feed": (
        "AxisLimits",
        "Reference",
        "Route",
        "blended",
        "limit_report",
        "plan",
        "route_from_path",
        "route_from_program",
        "uniform",
    ),
    "contourlab.geometry": ("Path", "contour", "contour_names"),
    "contourlab.geometry.line_and_arc": ("Arc", "Line"),
    "contourlab.geometry.nurbs": ("Nurbs",),
    "contourlab.logs": ("load_log",),
    "contourlab.loop": (
        "Axis",
        "AxisController",
        "AxisError",
        "BatchResult",
        "Change",
        "Controller",
        "Division",
        "Learned",
        "Limits",
        "Loop",
        "Machine",
        "parameter_names",
        "simulate",
        "simulate_batch",
        "with_values",
    ),
    "contourlab.components.plant.plant": ("Plant", "reflected_inertia", "reflected_mass"),
    "contourlab.metrics.circles": ("backlash_from_circle", "backlash_of_runs", "circles_of"),
    "contourlab.metrics.figures": ("Metrics", "summarise"),
    "contourlab.metrics.judge": ("judge",),
    "contourlab.metrics.lost_motion": ("lost_motion_from_pair",),
    "contourlab.metrics.reversals": ("reversal_spikes",),
    "contourlab.program": ("Program", "Reading", "parse_program", "read_program"),
    "contourlab.result": ("Result", "Signal", "Status"),
    "contourlab.scenario": ("Scenario", "load_scenario", "save"),
    "contourlab.features.analyse.command": ("analyse",),
    "contourlab.features.backlash.command": ("backlash",),
    "contourlab.features.check.program_check": ("check",),
    "contourlab.features.circle.command": ("circle",),
    "contourlab.features.commission.command": ("commission",),
    "contourlab.features.export.command": ("export",),
    "contourlab.features.identify.command": ("identify",),
    "contourlab.features.interpolate.command": ("interpolate",),
    "contourlab.features.learn": ("LearnedTable", "Stopping"),
    "contourlab.features.limits.command": ("limits",),
    "contourlab.features.link.command": ("link",),
    "contourlab.features.link.cost": ("message_rate",),
    "contourlab.features.measure.command": ("compare", "measure"),
    "contourlab.features.notch.command": ("notch",),
    "contourlab.features.precompensate.command": ("precompensate",),
    "contourlab.features.record.command": ("record",),
    "contourlab.features.refine.command": ("refine",),
    "contourlab.features.run.command": ("learn", "run"),
    "contourlab.features.run.record": ("simulate_to_file",),
    "contourlab.features.sensitivity.command": ("sensitivity",),
    "contourlab.features.swap.command": ("swap",),
    "contourlab.features.sweep.command": ("sweep",),
    "contourlab.features.tune.command": ("tune",),
    "contourlab.papers.run": ("reproduce",),
    "contourlab.features.run.report": ("report",),
    "contourlab.features.run.show": ("show",),
    "contourlab.features.run.verdict": ("verdict",),
}
_WHERE = {name: home for home, names in _HOMES.items() for name in names}

__all__ = ["__version__", *sorted(_WHERE)]


def __getattr__(name: str) -> Any:
    if name in _WHERE:
        return getattr(importlib.import_module(_WHERE[name]), name)
    raise AttributeError(f"module 'contourlab' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
