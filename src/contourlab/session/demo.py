"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

import html
import json
from pathlib import Path
from typing import Any

from contourlab.result import write_text_atomic
from contourlab.scenario import builtin_file, load_scenario
from contourlab.session.run import RunOutcome, prepared, run_session

__all__ = ["DEMOS", "run_demo"]

DEMOS = {
    "stage-a3a1": "ghaffari/demo-a3a1",
    "stage-a3a2": "ghaffari/demo-a3a2",
    "part": "demo-part",
}
"""Folder of each part of the demonstration -> the shipped scenario that it runs."""


def run_demo(out: str | Path, *, progress: bool = False) -> RunOutcome:
    """Run the demonstration; each part gets a folder of its own, the whole an index page and a summary.

    Parameters
    ----------
    out : str or Path
        Folder of the results.
    progress : bool
        Whether to show a bar.

    Returns
    -------
    RunOutcome
        Passed when the last scheme of every part, the best one, is within its tolerance.
    """
    folder = prepared(out)
    tables, summaries = [], {}
    passed = True
    for name, shipped in DEMOS.items():
        scenario = load_scenario(builtin_file(shipped))
        found = run_session(scenario, folder / name, command=f"contourlab run builtin:{shipped}", progress=progress)
        tables.append(f"{scenario.name}\n\n{found.table}")
        summaries[name] = found.summary
        passed = passed and _best_passed(found.summary)
    summary: dict[str, Any] = {"schema": "contourlab-demo/1", "passed": passed, "parts": summaries}
    write_text_atomic(folder / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
    write_text_atomic(folder / "report.html", _index(tables))
    verdict = "PASS" if passed else "FAIL"
    tables.append(f"{verdict}: the last scheme of each part against its tolerance; open {folder / 'report.html'}")
    return RunOutcome(passed, summary, "\n\n".join(tables))


def _best_passed(summary: dict[str, Any]) -> bool:
    last = list(summary["schemes"].values())[-1]
    return last["verdict"] is None or bool(last["verdict"]["passed"])


def _index(tables: list[str]) -> str:
    parts = [
        f'<section><pre>{html.escape(table)}</pre><p><a href="{name}/report.html">open this report</a></p></section>'
        for name, table in zip(DEMOS, tables, strict=True)
    ]
    style = (
        "body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#1b1f24}"
        "pre{overflow-x:auto;background:#f6f8fa;padding:1rem;border-radius:6px;font-size:13px}h1{font-weight:600}"
    )
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>contourlab demo</title><style>{style}</style>'
    return f"<!doctype html><html lang=en><head>{head}</head><body><h1>contourlab demo</h1>{''.join(parts)}</body></html>\n"
