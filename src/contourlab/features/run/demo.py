"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from contourlab.app.results import staged
from contourlab.features.run.command import RunOutcome, interval_words, run_session
from contourlab.result import write_text_atomic
from contourlab.scenario import builtin_file, load_scenario

DEMOS = {
    "stage-a3a1": "ghaffari/demo-stage",
    "stage-a3a2": "ghaffari/demo-stage-a3a2",
    "part": "demo-part",
}
"""Folder of each part of the demonstration -> the shipped scenario that it runs."""


def run_demo(out: str | Path, *, progress: bool = False, interval: bool | None = None) -> RunOutcome:
    """Run the demonstration; each part gets a folder of its own, the whole an index page and a summary.

    Parameters
    ----------
    out : str or Path
        Folder of the results.
    progress : bool
        Whether to show a bar.
    interval : bool, optional
        As of `contourlab.features.run.command.run_scenario`.

    Returns
    -------
    RunOutcome
        Passed when the last scheme of every part, the best one, is within its tolerance.
    """
    folder = Path(out)
    titles, tables, summaries = {}, {}, {}
    with staged(folder, "summary.json", "report.html") as stage:
        for name, shipped in DEMOS.items():
            scenario = load_scenario(builtin_file(shipped))
            words = " ".join(["contourlab", "run", f"builtin:{shipped}", *interval_words(interval)])
            found = run_session(scenario, folder / name, command=words, progress=progress, interval=interval)
            titles[name], tables[name], summaries[name] = scenario.name, found.table, found.summary
        passed = all(_last(summary)["verdict"]["passed"] for summary in summaries.values())
        summary: dict[str, Any] = {"schema": "contourlab-demo/1", "passed": passed, "parts": summaries}
        write_text_atomic(stage / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
        write_text_atomic(stage / "report.html", _index(titles, tables))
    words = f"{'PASS' if passed else 'FAIL'}: the last scheme of each run against its tolerance. Reports: {folder / 'report.html'}"
    return RunOutcome(passed, summary, f"{_table(titles, summaries)}\n\n{words}")


def _last(summary: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = list(summary["schemes"].values())[-1]
    return found


def _table(titles: dict[str, str], summaries: dict[str, dict[str, Any]]) -> str:
    """Return one table of all runs and schemes, in um."""
    head = ("scheme", "largest", "rms", "mean", "signed", "integral", "verdict")
    units = ("", "um", "um", "um", "um", "um s", "")
    widths = (44, 9, 9, 9, 9, 9, 9)
    lines = []

    def line(cells: Sequence[str]) -> str:
        first, *others = (cell.rjust(width) if n else cell.ljust(width) for n, (cell, width) in enumerate(zip(cells, widths, strict=True)))
        return (first + "".join(others)).rstrip()

    for name, summary in summaries.items():
        schemes = summary["schemes"]
        tolerance = _last(summary)["verdict"]["tolerance"]
        lines += ["", f"{titles[name]}: part error against {tolerance * 1e6:.3g} um", line(head), line(units)]
        for scheme, found in schemes.items():
            error = found["metrics"]["part_error"]
            values = [f"{error[key] * 1e6:.3g}" for key in ("max", "rms", "mean", "signed_mean", "integral")]
            lines.append(line([scheme, *values, "pass" if found["verdict"]["passed"] else "fail"]))
    return "\n".join(lines[1:])


def _index(titles: dict[str, str], tables: dict[str, str]) -> str:
    parts = [
        f'<section><h2>{html.escape(titles[name])}</h2><p><a href="{name}/report.html">Open the report</a></p>'
        f"<pre>{html.escape(tables[name])}</pre></section>"
        for name in tables
    ]
    style = (
        "body{font:16px/1.5 system-ui,sans-serif;max-width:90rem;margin:2rem auto;padding:0 1rem;color:#1b1f24}"
        "pre{overflow-x:auto;background:#f6f8fa;padding:1rem;border-radius:6px;font-size:13px}h1,h2{font-weight:600}"
    )
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>contourlab demo</title><style>{style}</style>'
    return f"<!doctype html><html lang=en><head>{head}</head><body><h1>contourlab demo</h1>{''.join(parts)}</body></html>\n"
