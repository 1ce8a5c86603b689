"""Pictures of a refinement: errors measured and simulated, and what is left."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from contourlab.features.refine.study import Refined
from contourlab.report import plots
from contourlab.report.charts import traces_chart


def draw(refined: Refined, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Draw each signal of each run, measured and simulated, and what is left, with the fitted window shaded; return the files."""
    charts = []
    for run, simulated, window in zip(refined.runs, refined.simulated, refined.windows, strict=True):
        time = run.times()
        # A window may reach beyond the log.
        within = None if window is None else (max(window[0], float(time[0])), min(window[1], float(time[-1])))
        marked: dict[str, Any] = {"span": within, "span_label": "fitted to what is shaded" if within else ""}
        for j, (signal, axis) in enumerate(run.channels):
            size, unit = (1e6, "um") if signal == "position" else (1.0, "")
            name = f"{'tracking error' if signal == 'position' else signal} of {axis}"
            labels = "time [s]", name + (f" [{unit}]" if unit else "")
            key = f"{run.label}-{signal}-{axis}".replace(" ", "-")
            both = {"measured": (time, size * run.measured[:, j]), "simulated": (time, size * simulated[:, j])}
            left = {"measured less simulated": (time, size * (run.measured[:, j] - simulated[:, j]))}
            charts.append(traces_chart(key, f"{run.label}: {name}", labels, both, **marked))
            charts.append(traces_chart(f"{key}-left", f"{run.label}: what is left of it", labels, left, **marked))
    return plots.write_charts(charts, folder, formats)
