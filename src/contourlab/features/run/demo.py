"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values
from contourlab.app.results import staged
from contourlab.features.run.command import RunOptions, RunOutcome, run_session
from contourlab.features.run.summary import Summary
from contourlab.figures import figure, number
from contourlab.report.table import Column, Table
from contourlab.result import write_text_atomic
from contourlab.scenario import builtin_file, load_scenario


@dataclass(frozen=True)
class Demo:
    """The results of ``demo``: whether the last scheme of each part passed, and the summary of each part."""

    passed: bool
    parts: Mapping[str, Summary]
    schema: str = "contourlab-demo/1"


DEMOS = {
    "stage-a3a1": "ghaffari/demo-stage",
    "stage-a3a2": "ghaffari/demo-stage-a3a2",
    "part": "demo-part",
}
"""Folder of each part of the demonstration -> the shipped scenario that it runs."""


def run_demo(out: str | Path, *, progress: bool = False, interval: bool | None = None) -> RunOutcome:
    """Run the demonstration: a folder for each part, an index page and a summary of the whole.

    The outcome has passed when the last (best) scheme of every part is within its tolerance. Parameters are those of `RunOptions`.
    """
    folder = Path(out)
    titles: dict[str, str] = {}
    tables: dict[str, str] = {}
    summaries: dict[str, Any] = {}
    with staged(folder, "summary.json", "report.html") as stage:
        for name, shipped in DEMOS.items():
            scenario = load_scenario(builtin_file(shipped))
            options = RunOptions(folder / name, progress=progress, interval=interval)
            outcome = run_session(scenario, options, command=options.command("run", f"builtin:{shipped}", {}))
            titles[name], tables[name], summaries[name] = scenario.name, outcome.table, outcome.summary
        passed = all(_last(summary)["verdict"]["passed"] for summary in summaries.values())
        summary: dict[str, Any] = json_values(Demo(passed, summaries))
        write_text_atomic(stage / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
        write_text_atomic(stage / "report.html", _index(titles, tables))
    conclusion = f"{'PASS' if passed else 'FAIL'}: the last scheme of each run against its tolerance. Reports: {folder / 'report.html'}"
    parts = [_table(titles[name], summary) for name, summary in summaries.items()]
    return RunOutcome(passed, summary, "\n\n".join([*parts, conclusion]))


def _last(summary: dict[str, Any]) -> dict[str, Any]:
    scheme: dict[str, Any] = list(summary["schemes"].values())[-1]
    return scheme


def _table(title: str, summary: dict[str, Any]) -> str:
    """Return the part errors of all schemes of a run."""
    title = f"{title}: part error against {figure(_last(summary)['verdict']['tolerance'], 'um')}"
    keys = ("max", "rms", "mean", "signed_mean", "integral")
    heads = [Column(f"{key.replace('_', ' ')} [{'um s' if key == 'integral' else 'um'}]") for key in keys]
    table = Table([Column("scheme", left=True), *heads, Column("verdict", left=True)], title)
    for name, scheme in summary["schemes"].items():
        error, passed = scheme["metrics"]["part_error"], scheme["verdict"]["passed"]
        table.add(name, *(number(1e6 * error[key]) for key in keys), "pass" if passed else "fail")
    return table.text()


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
