"""One page that leads to several reports: a sentence, a badge for each run, and the magnified path of each report."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from contourlab.rendering.charts import PathChart
from contourlab.rendering.data import ReportData
from contourlab.rendering.html import page_template, template_file
from contourlab.rendering.lead import sentence
from contourlab.rendering.path_picture import path_charts
from contourlab.rendering.plots import POINTS
from contourlab.result import write_text_atomic

SIZE = (4.2, 3.8)
"""Width and height of a picture [in]."""


def write_overview(file: str | Path, answer: str, reports: Mapping[str, ReportData], next_step: str) -> Path:
    """Write the page.

    Parameters
    ----------
    answer : str
        The sentence on top.
    reports : mapping of str to ReportData
        Address of each report, relative to the page, and its data; every run has a verdict.
    next_step : str
        The command to type next.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    parts = [_part(address, data) for address, data in reports.items()]
    text = page_template("demo.html.j2").render(sentence=answer, parts=parts, next=next_step, style=template_file("report.css"))
    write_text_atomic(Path(file), str(text))
    return Path(file)


def _part(address: str, data: ReportData) -> dict[str, Any]:
    colours = [colour for _, colour, _ in data.looks.values()]
    chart = next(chart for chart in path_charts(data, POINTS) if isinstance(chart, PathChart))
    dotted = "; dotted: the tolerance" if chart.tolerance else ""
    caption = f"Errors drawn {chart.magnification:g} times as large. Dark: the programmed path{dotted}; rings: the largest errors."
    picture = {"picture": _picture(chart), "caption": f"{caption} Colours as above."}
    return {"page": address, "data": data, "sentence": sentence(data), "colours": colours, **picture}


def _picture(chart: PathChart) -> str:
    """Return a view of the path as SVG in base64, so small that a phone can show it; the badges are its legend."""
    import matplotlib
    from matplotlib.figure import Figure

    from contourlab.rendering.matplotlib_view import LOOKS, draw_path, picture_bytes

    with matplotlib.rc_context(fname=LOOKS):
        figure = Figure(figsize=SIZE, layout="constrained")
        draw_path(figure.add_subplot(), chart).set_title("")
        return base64.b64encode(picture_bytes(figure, "svg")).decode("ascii")
