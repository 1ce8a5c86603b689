"""The public names of contourlab by subject, and the page that lists them."""

from __future__ import annotations

import contourlab

GROUPS = {
    "Read": (
        "Scenarios, part programs and drawings.",
        ("load_scenario", "Scenario", "read_program", "parse_program", "Program", "Reading", "read_contour"),
    ),
    "Machine and controller": (
        "What a scenario contains, or a script builds.",
        ("Machine", "Axis", "Limits", "AxisError", "Controller", "AxisController", "Division", "message_rate"),
    ),
    "Path and motion": (
        "The path, and the plan along it.",
        (
            "Path",
            "contour",
            "contour_names",
            "Route",
            "route_from_path",
            "route_from_program",
            "blended",
            "AxisLimits",
            "plan",
            "uniform",
            "Reference",
            "limit_report",
        ),
    ),
    "Simulate": (
        "One run, many variants at once, or a run larger than memory.",
        ("simulate", "simulate_batch", "BatchResult", "parameter_names", "simulate_to_file", "Change"),
    ),
    "Judge": (
        "Contour error, part error, verdict, circles, reversals and backlash.",
        (
            "judge",
            "summarise",
            "Metrics",
            "verdict",
            "circles_of",
            "reversal_spikes",
            "backlash_from_circle",
            "backlash_of_runs",
            "lost_motion_from_pair",
        ),
    ),
    "Results": ("Signals with units, how a run ended, and one page about runs.", ("Result", "Signal", "Status", "report")),
    "Analyse": ("Margins without a run.", ("contour_margins", "internal_stability")),
    "Learn": ("Learning from trial to trial.", ("learn", "Stopping", "LearnedTable", "Learned", "learning_analysis")),
    "Components": (
        "Find, write, check and translate the parts of a machine.",
        (
            "component",
            "load_plugin",
            "Component",
            "Port",
            "param",
            "text_param",
            "check_component",
            "translate",
            "reflected_mass",
            "reflected_inertia",
        ),
    ),
    "Errors": ("Every error of contourlab is a `ContourlabError`.", ("ContourlabError", "DivergenceError")),
}
API = """\
# Python

`import contourlab as cl` gives the names of this page; what is not on it may change without notice. All values are in SI units
(m, s, N, rad); arrays of signals are `(n_sample, n_axis)`. [Examples](../examples/index.rst) show them at work.
"""


def api_page() -> str:
    """Return the page of all public names.

    Raises
    ------
    ValueError
        If a name of `contourlab.__all__` is in no group or in two, or a group has a name that is not public.
    """
    listed = sorted(name for _, names in GROUPS.values() for name in names)
    public = sorted(name for name in contourlab.__all__ if name != "__version__")
    if listed != public:
        odd = sorted(set(listed) ^ set(public)) or sorted({name for name in listed if listed.count(name) > 1})
        raise ValueError(f"docs/api.py: each name of contourlab.__all__ belongs in one group: {', '.join(odd)}")
    parts = [API, "```{eval-rst}\n.. currentmodule:: contourlab\n```\n"]
    for head, (text, names) in GROUPS.items():
        rows = "\n".join(f"   {name}" for name in names)
        table = f".. autosummary::\n   :toctree: api\n   :nosignatures:\n\n{rows}"
        parts.append(f"## {head}\n\n{text}\n\n```{{eval-rst}}\n{table}\n```\n")
    return "\n".join(parts)
