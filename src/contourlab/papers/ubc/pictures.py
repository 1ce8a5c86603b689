"""Pictures of the UBC table: measured and simulated tracking and contour errors of both runs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from contourlab.papers.ubc.runs import read_runs
from contourlab.rendering.charts import traces_chart
from contourlab.rendering.plots import write_charts


def draw(logs: str | Path | None, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Read the logs and write the pictures into a folder; return the files."""
    charts = []
    for name, run in read_runs(logs).items():
        times, signals = run.times(), run.once()
        for j, axis in enumerate(run.machine.axis_names):
            traces = {"measured": (times, 1e6 * run.measured[:, j]), "simulated": (times, 1e6 * signals[:, j])}
            title = f"UBC table, {name}: tracking error of {axis}"
            charts.append(traces_chart(f"ubc-{name}-{axis}", title, ("time [s]", f"tracking error of {axis} [um]"), traces))
        errors = {}
        for label, judged in (("measured", run.judged()), ("simulated", run.judged(signals))):
            errors[label] = 1e3 * judged.result["foot_arc_length"], 1e6 * judged.result["contour_error"]
        labels = "distance along the path [mm]", "contour error [um]"
        charts.append(traces_chart(f"ubc-{name}-contour", f"UBC table, {name}: contour error", labels, errors))
    return write_charts(charts, folder, formats)
