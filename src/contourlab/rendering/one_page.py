"""Reports on one page: one report to print, and a page that leads to several, with a badge for each run and the magnified paths."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any

from contourlab.figures import figure, number
from contourlab.rendering.charts import PathChart
from contourlab.rendering.data import ReportData
from contourlab.rendering.html import page_template, template_file
from contourlab.rendering.lead import sentence
from contourlab.rendering.matplotlib_view import draw_chart, draw_path, escaped, new_figure, picture_bytes
from contourlab.rendering.path_picture import path_charts
from contourlab.rendering.plots import POINTS
from contourlab.rendering.run_pictures import error_charts
from contourlab.rendering.style import BAND, INK, LIMIT, MUTED
from contourlab.result import write_bytes_atomic, write_text_atomic

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

A4 = (8.27, 11.69)
"""Size of the page [in]."""
LETTERS, MOST_RUNS = 92, 12
"""Letters in a line, and runs in the table."""


def write_page(data: ReportData, file: str | Path) -> Path:
    """Write the report as a PDF of one page; parameters and errors as in `contourlab.rendering.html.write_html`."""
    write_bytes_atomic(Path(file), *picture_bytes(lambda: _page(data), "pdf"))
    return Path(file)


def _page(data: ReportData) -> Figure:
    """Draw words, path and error over time, one below the other."""
    page = new_figure(A4[1], A4[0])
    page.get_layout_engine().set(rect=(0.06, 0.04, 0.88, 0.92))  # type: ignore[union-attr,call-arg]
    heights = (1.0 + 0.16 * min(len(data.schemes), MOST_RUNS), 4.4, 1.7)
    text, picture, course = page.subplots(3, 1, height_ratios=heights)
    _words(text, data)
    chart = next(iter(path_charts(data, POINTS)), None)
    if chart is None:
        picture.set_visible(False)
    else:
        draw_path(picture, chart)
        longest = max(map(len, picture.get_legend_handles_labels()[1]))
        picture.legend(loc="upper left", bbox_to_anchor=(0.0, -0.09), ncols=3 if longest < LETTERS // 3 else 2, fontsize=7)
    draw_chart(error_charts(data, POINTS), place=course)
    return page


def _words(place: Axes, data: ReportData) -> None:
    """Write title, sentence, the table of runs and the next command."""
    place.set_axis_off()
    lines: list[tuple[str, dict[str, Any]]] = [(data.title, {"size": 15, "weight": "bold"})]
    lines += [(line, {"size": 10.5}) for line in wrap(sentence(data), LETTERS)]
    answers: dict[int, tuple[str, str]] = {}
    for scheme in data.schemes[:MOST_RUNS]:
        verdict, size = scheme.verdict, scheme.metrics.part_error
        where = f", at line {verdict.worst.line}" if verdict is not None and verdict.worst.line else ""
        words = f"{scheme.name}: largest part error {figure(size.max, 'um')}{where}, rms {number(1e6 * size.rms)} um"
        lines.append((words, {"size": 8.5, "color": data.looks[scheme.name][1]}))
        if verdict is not None:
            answers[len(lines) - 1] = ("PASS", BAND) if verdict.passed else ("FAIL", LIMIT)
    typed = [f"Next: {command}" for _, command in data.next_steps[:1]]
    typed.append(f"contourlab {data.provenance.version}: {data.provenance.command}")
    lines += [(line, {"size": 7.5, "color": MUTED, "family": "monospace"}) for text in typed for line in wrap(text, LETTERS)]
    height = sum(look["size"] for _, look in lines)
    at = 1.0
    for i, (text, look) in enumerate(lines):
        pieces = [(0.0, escaped(text), look)]
        if i in answers:
            answer, colour = answers[i]
            pieces = [(0.0, answer, {**look, "color": colour, "weight": "bold"}), (0.08, escaped(text), look)]
        for left, words, style in pieces:
            shown = place.text(left, at, words, transform=place.transAxes, va="top", **{"color": INK, **style})
            shown.set_in_layout(False)  # long words must not narrow the pictures
        at -= look["size"] / height


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
    chart = path_charts(data, POINTS)[0]
    dotted = "; dotted: the tolerance" if chart.tolerance else ""
    caption = f"Errors drawn {chart.magnification:g} times as large. Dark: the programmed path{dotted}; rings: the largest errors."
    picture = {"picture": _picture(chart), "caption": f"{caption} Colours as above."}
    return {"page": address, "data": data, "sentence": sentence(data), "colours": colours, **picture}


def _picture(chart: PathChart) -> str:
    """Return a view of the path as SVG in base64, so small that a phone can show it; the badges are its legend."""

    def drawn() -> Figure:
        figure = new_figure(SIZE[1], SIZE[0])
        draw_path(figure.add_subplot(), chart).set_title("")
        return figure

    return base64.b64encode(*picture_bytes(drawn, "svg")).decode("ascii")
