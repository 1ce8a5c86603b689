"""One HTML file that holds everything: it opens without a network and asks for nothing from outside."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from contourlab.figures import figure, number
from contourlab.report.axis_pictures import axis_charts, bode_charts
from contourlab.report.comparison import compare
from contourlab.report.data import ReportData, SchemeReport
from contourlab.report.decimate import share
from contourlab.report.error_pictures import circle_tables, error_charts, polar_charts
from contourlab.report.feed_picture import feed_charts
from contourlab.report.hysteresis_picture import FINER, hysteresis_charts
from contourlab.report.limit_table import limit_tables
from contourlab.report.path_picture import path_charts
from contourlab.report.plotly_view import Figure, line_figure, path_figure, polar_figure
from contourlab.report.reversal_table import reversal_table
from contourlab.report.style import scheme_style
from contourlab.report.switching import strip_charts, switch_tables
from contourlab.report.tables import interval_rows, origin_tables
from contourlab.report.trials import trial_charts
from contourlab.result.atomic import write_text_atomic

MOST_POINTS = 4000
"""Most points of a curve: two for every pixel of a wide screen."""

TOTAL_POINTS = 400_000
"""Most points of all curves of a report together, which bounds the file at about 4.8 MB + 400 000 x 11 bytes."""

MOST_TEXT = 500_000  # characters of a scenario or program printed in full
CONTEXT = 12  # lines of the program shown on each side of the worst place
TEMPLATES = Path(__file__).parent / "templates"


def write_html(data: ReportData, file: str | Path) -> Path:
    """Write the report as one HTML file.

    Parameters
    ----------
    data : ReportData
    file : str or Path
        Replaced as a whole or not at all.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    OutputError
        If it cannot be written.
    ResultError
        If a result has not been judged.

    Notes
    -----
    Linear in the number of samples; the size of the file does not depend on it, see `MOST_POINTS` and `TOTAL_POINTS`.
    """
    target = Path(file)
    write_text_atomic(target, render_html(data))
    return target


def render_html(data: ReportData) -> str:
    """Return the text of the report; the same data give the same text."""
    points = _points(data)
    groups = _figures(data, points)
    figures = {figure["id"]: figure.pop("spec") for group in groups.values() for figure in group}
    scripts = {"plotly": _plotly(), "page": _file("report.js")}
    return str(
        _template().render(
            data=data,
            comparison=compare(data),
            groups=groups,
            circle_tables=circle_tables(data),
            limit_tables=limit_tables(data),
            reversals=reversal_table(data),
            switch_tables=switch_tables(data),
            trust={"tables": origin_tables(data), "rows": interval_rows(data)},
            verdicts=[_verdict(scheme, index, len(data.schemes)) for index, scheme in enumerate(data.schemes)],
            program=_program(data),
            scenario=_clipped(data.provenance.scenario),
            facts=_facts(data, points),
            figures=_inert(figures),
            scripts=scripts,
            style=_file("report.css"),
            hashes=[_digest(text) for text in scripts.values()],
        )
    )


def _points(data: ReportData) -> int:
    """Return the points each curve may have: the total is shared among all curves that may be drawn."""
    n_scheme, n_axis = len(data.schemes), len(data.axes)
    n_view = 3 if n_axis > 2 else 1
    n_circle = sum(len(scheme.circles) for scheme in data.schemes)
    # A magnified run takes as much room as three plain curves.
    n_loop = FINER * sum(len(scheme.gaps) for scheme in data.schemes)
    n_curve = n_scheme * (2 + 4 * n_axis + 3 * n_view) + n_circle + 4 * n_axis + 8 * n_view + n_loop
    return max(16, share(TOTAL_POINTS, n_curve, MOST_POINTS))


def _figures(data: ReportData, points: int) -> dict[str, list[dict[str, Any]]]:
    """Return the figures by section."""
    return {
        "path": [_entry(chart, path_figure(chart), view=chart.view) for chart in path_charts(data, points)],
        "circles": [_entry(chart, polar_figure(chart)) for chart in polar_charts(data, points)],
        "errors": [_entry(chart, line_figure(chart)) for chart in error_charts(data, points)],
        "axes": [_entry(chart, line_figure(chart)) for chart in (*feed_charts(data.feed), *axis_charts(data, points))],
        "backlash": [_entry(chart, line_figure(chart)) for chart in hysteresis_charts(data, points)],
        "switches": [_entry(chart, line_figure(chart)) for chart in strip_charts(data)],
        "trials": [_entry(chart, line_figure(chart)) for chart in trial_charts(data)],
        "bode": [_entry(chart, line_figure(chart)) for chart in bode_charts(data, points)],
    }


def _entry(chart: Any, spec: Figure, view: str = "") -> dict[str, Any]:
    """Return what the template needs of a figure."""
    text = {"id": chart.key, "title": chart.title, "caption": chart.caption, "view": view}
    return {**text, "spec": spec, "height": spec["layout"]["height"]}


def _inert(value: Any) -> str:
    """Return JSON that can stand in a script element: no text in it can end the element or start another."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"), ensure_ascii=True)
    return text.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e")


def _verdict(scheme: SchemeReport, index: int, count: int) -> dict[str, Any] | None:
    """Return a verdict in print form; None where there is none."""
    verdict = scheme.verdict
    if verdict is None:
        return None
    worst = verdict.worst
    axes = scheme.result.axes
    place = ", ".join(f"{axis} {number(p * 1e3, 6)} mm" for axis, p in zip(axes, worst.position, strict=False))
    return {
        "name": scheme.name,
        "colour": scheme_style(index, count)[0],
        "passed": bool(verdict.passed),
        "tolerance": figure(verdict.tolerance, "um", 6),
        "value": figure(worst.value, "um"),
        "line": worst.line,
        "text": worst.text,
        "place": place,
        "time": figure(worst.time, "s", 5),
        "sample": worst.sample,
        "causes": [
            {
                "name": cause.name,
                # A nanometre more or less is no finding.
                "value": figure(round(cause.contribution, 9), "um"),
                "percent": f"{100.0 * cause.share:.0f} %",
                "width": f"{min(max(100.0 * cause.share, 0.0), 100.0):.1f}",
            }
            for cause in verdict.causes
        ],
    }


def _program(data: ReportData) -> dict[str, Any] | None:
    """Return the part program with its worst lines marked; of a very long one the surroundings of those."""
    lines = list(data.program)
    if not lines:
        return None
    verdicts = [scheme.verdict for scheme in data.schemes if scheme.verdict is not None]
    worst = {int(verdict.worst.line) for verdict in verdicts} - {0}
    whole = sum(map(len, lines)) <= MOST_TEXT and len(lines) <= 20_000
    chosen = range(1, len(lines) + 1) if whole else _around(worst, len(lines))
    rows = [{"number": n, "text": lines[n - 1], "worst": n in worst} for n in chosen]
    digest = hashlib.sha256("\n".join(lines).encode("utf-8", "replace")).hexdigest()
    return {"rows": rows, "whole": whole, "count": len(lines), "digest": digest}


def _around(worst: set[int], count: int) -> list[int]:
    """Return the first lines and those around the worst ones, in order."""
    wanted = set(range(1, min(count, 2 * CONTEXT) + 1))
    for line in worst:
        wanted |= set(range(max(1, line - CONTEXT), min(count, line + CONTEXT) + 1))
    return sorted(wanted)


def _clipped(text: str) -> dict[str, Any]:
    """Return a text, or its beginning and its digest where it is too long to print."""
    if len(text) <= MOST_TEXT:
        return {"text": text, "note": ""}
    digest = hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()
    note = f"The first {MOST_TEXT} of {len(text)} characters; SHA-256 of all: {digest}."
    return {"text": text[:MOST_TEXT], "note": note}


def _facts(data: ReportData, points: int) -> list[tuple[str, str]]:
    """Return what belongs under the title and at the end of the page."""
    first, source = data.schemes[0].result, data.provenance
    samples = max(int(scheme.result.n_sample) for scheme in data.schemes)
    period = float(first.servo_period)
    facts: Iterable[tuple[str, str]] = (
        ("contourlab", source.version),
        ("Command", source.command),
        ("Platform", source.platform),
        ("Seed", "" if source.seed is None else str(source.seed)),
        ("Axes", ", ".join(data.axes)),
        ("Servo period", figure(period, "ms", 6)),
        ("Samples", f"{samples:,}".replace(",", " ") + f" in {figure(samples * period, 's', 4)}"),
        ("Path length", figure(float(data.planned.length), "mm", 6)),
        ("Drawn", f"at most {points} points a curve; the lowest and highest value of every interval are kept"),
    )
    return [(name, text) for name, text in facts if text]


@cache
def _file(name: str) -> str:
    """Return a file of the template folder."""
    return (TEMPLATES / name).read_text(encoding="utf-8")


@cache
def _plotly() -> str:
    """Return plotly.js; it must not hold what would end its script element."""
    from plotly.offline import get_plotlyjs

    return str(get_plotlyjs()).replace("</script", "<\\/script")


@cache
def _digest(script: str) -> str:
    """Return the hash by which the page allows its own scripts and no other."""
    return "sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii")


@cache
def _template() -> Any:
    """Return the page's template; whatever is put into it is escaped unless marked safe."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    loader = FileSystemLoader(TEMPLATES)
    options: dict[str, Any] = {"undefined": StrictUndefined, "trim_blocks": True, "lstrip_blocks": True}
    return Environment(loader=loader, autoescape=True, **options).get_template("report.html.j2")
