"""The report of a circle test: a polar picture with the deviation magnified, and a slider for each cause."""

from __future__ import annotations

import base64
import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.features.circle.fit import CircleFit
from contourlab.features.circle.result import CircleTest, plus_minus, value_text
from contourlab.rendering.html import page_template, template_file
from contourlab.rendering.style import scheme_style
from contourlab.result import write_text_atomic

POINTS = 2400
"""Most points of a run in the picture."""


def write_page(test: CircleTest, fit: CircleFit, file: str | Path) -> None:
    """Write the report as one HTML file that needs no network."""
    script = template_file("circle.js")
    rows = [
        {"name": cause.name, "adds": plus_minus(cause.contribution, cause.deviation), "value": value_text(cause), "sure": cause.is_sure}
        for cause in test.causes
    ]
    text = page_template("circle.html.j2").render(
        test=test,
        rows=rows,
        data=json.dumps(_data(test, fit), separators=(",", ":")).replace("</", "<\\/"),
        style=template_file("report.css"),
        script=script,
        hash="sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii"),
        colours=[scheme_style(k, len(fit.runs))[0] for k in range(len(fit.runs))],
    )
    write_text_atomic(Path(file), str(text))


def _data(test: CircleTest, fit: CircleFit) -> dict[str, Any]:
    """Return angles [rad], deviations and the curve of each cause [um] for each run."""
    curves: dict[str, list[Array]] = {}
    for cause in test.causes:
        if cause.cause == "reversal spikes":
            curves[cause.name] = fit.spike_curves(cause.axis)
            continue
        # Terms of one name add up: two vibrations.
        alike = [fit.curves(term) for term in fit.terms if (term.cause, term.axis) == (cause.cause, cause.axis)]
        curves[cause.name] = [np.sum(parts, axis=0) for parts in zip(*alike, strict=True)]
    runs = []
    for k, run in enumerate(fit.runs):
        # The last whole turn, evenly thinned.
        last = np.flatnonzero(np.abs(run.turned - run.turned[-1]) <= 2.0 * np.pi)
        kept = last[:: max(len(last) // POINTS, 1)]
        runs.append(
            {
                "clockwise": run.clockwise,
                "colour": scheme_style(k, len(fit.runs))[0],
                "angle": np.round(run.angle[kept], 5).tolist(),
                "deviation": _um(run.deviation[kept]),
                "curves": [_um(parts[k][kept]) for parts in curves.values()],
            }
        )
    return {"axes": fit.axes, "causes": list(curves), "runs": runs}


def _um(values: Array) -> list[float]:
    rounded: list[float] = np.round(1e6 * values, 4).tolist()
    return rounded
