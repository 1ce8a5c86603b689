"""The public names of contourlab by subject, and the page that lists them."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from typing import Any, get_args

import contourlab
from contourlab import errors
from contourlab.app.session import Answer

GROUPS = {
    "Ask": (
        "What the commands answer: each function has the name and the options of its command.",
        (
            "run",
            "compare",
            "learn",
            "check",
            "measure",
            "record",
            "circle",
            "limits",
            "identify",
            "refine",
            "interpolate",
            "analyse",
            "backlash",
            "sensitivity",
            "tune",
            "notch",
            "swap",
            "link",
            "sweep",
            "commission",
            "precompensate",
            "export",
            "reproduce",
        ),
    ),
    "Read": (
        "Scenarios, part programs, drawings and logs; and a file of what a script built.",
        ("load_scenario", "Scenario", "read_program", "parse_program", "Program", "Reading", "read_contour", "load_log", "save"),
    ),
    "Machine and controller": (
        "What a scenario contains, or a script builds.",
        ("Machine", "Axis", "Limits", "AxisError", "Controller", "AxisController", "Division", "message_rate"),
    ),
    "Path and motion": (
        "The path, and the plan along it.",
        (
            "Path",
            "Line",
            "Arc",
            "Nurbs",
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
        ("simulate", "Loop", "simulate_batch", "BatchResult", "parameter_names", "with_values", "simulate_to_file", "Change"),
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
    "Results": (
        "Signals with units, how a run ended, one page about runs, and the viewer in a notebook.",
        ("Result", "Signal", "Status", "cite", "report", "show"),
    ),
    "Analyse": ("Margins and matrices without a run.", ("contour_margins", "internal_stability", "linear", "from_system")),
    "Learn": ("Learning from trial to trial.", ("Stopping", "LearnedTable", "Learned", "learning_analysis")),
    "Components": (
        "Find, write, check and translate the parts of a machine.",
        (
            "component",
            "load_plugin",
            "Component",
            "Plant",
            "Port",
            "param",
            "text_param",
            "check_component",
            "translate",
            "reflected_mass",
            "reflected_inertia",
        ),
    ),
    "Errors": ("Every error is a `ContourlabError`; `contourlab.errors` has all.", ("ContourlabError", "DivergenceError")),
}
TYPES = "Classes of values that the names above take, return or hold; few people need to import them."
API = """\
# Python

`import contourlab as cl` gives the names of this page; what is not on it may change without notice. All values are in SI units
(m, s, N, rad); arrays of signals are `(n_sample, n_axis)`. [Examples](../examples/index.rst) show them at work.
"""


def members(kind: type) -> Iterator[tuple[str, Any]]:
    """Yield the public methods and properties of a class itself, without those that a base class describes."""
    for name, member in vars(kind).items():
        function = function_of(member)
        if name[0] == "_" or name in getattr(kind, "__dataclass_fields__", ()) or function is None:
            continue
        if function.__doc__ or not any(hasattr(base, name) for base in kind.__mro__[1:]):
            yield name, member


def function_of(member: Any) -> Any:
    """Return the function of a method or property, or None."""
    member = getattr(member, "fget", None) or getattr(member, "func", None) or getattr(member, "__func__", member)
    return member if inspect.isfunction(member) else None


def types() -> dict[str, type]:
    """Return by full name the classes in the signatures of public names and of each other; components have a page of their own."""
    found: dict[str, type] = {}
    waiting = [getattr(contourlab, name) for name in contourlab.__all__ if name != "__version__"]
    public = set(waiting)
    while waiting:
        target = waiting.pop()
        if inspect.isclass(target) and issubclass(target, Answer):
            continue  # what it holds is on the page of results as JSON
        own = [vars(target).get("__init__"), *(member for _, member in members(target))] if inspect.isclass(target) else []
        for function in (target, *filter(None, map(function_of, own))):
            scope = vars(sys.modules[target.__module__])
            words = {word for kind in function.__annotations__.values() for word in re.findall(r"\w+", str(kind))}
            parts = [part for word in sorted(words) if word in scope for part in (scope[word], *get_args(scope[word]))]
            for kind in filter(inspect.isclass, parts):
                name = f"{kind.__module__}.{kind.__qualname__}"
                listed = kind in public or name in found or issubclass(kind, Exception) or getattr(kind, "kind", "")
                if kind.__module__.startswith("contourlab.") and not listed:
                    found[name] = kind
                    waiting.append(kind)
    return found


def links() -> dict[str, str]:
    """Return the full name of each class that has a page, by its short name; where two have the same name, neither."""
    public = {name: f"contourlab.{name}" for name in contourlab.__all__ if inspect.isclass(getattr(contourlab, name))}
    short: dict[str, list[str]] = {name: [full] for name, full in public.items()}
    for full in (*types(), *(f"contourlab.errors.{name}" for name in errors.__all__)):
        short.setdefault(full.rpartition(".")[2], []).append(full)
    return {name: full[0] for name, full in short.items() if name in public or len(full) == 1}


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
    raised = (f"~errors.{name}" for name in errors.__all__ if not hasattr(contourlab, name))
    groups = GROUPS | {"Errors": (GROUPS["Errors"][0], (*GROUPS["Errors"][1], *raised))}
    by_name = sorted(types(), key=lambda name: name.rpartition(".")[2])
    groups["Types"] = (TYPES, tuple(f"~{name.removeprefix('contourlab.')}" for name in by_name))
    for head, (text, names) in groups.items():
        rows = "\n".join(f"   {name}" for name in names)
        table = f".. autosummary::\n   :toctree: api\n   :nosignatures:\n\n{rows}"
        parts.append(f"## {head}\n\n{text}\n\n```{{eval-rst}}\n{table}\n```\n")
    return "\n".join(parts)
