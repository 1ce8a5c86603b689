"""Tables, plots and the one-file HTML report; reads results only.

Inside: `data` (what a report is made of); `comparison` (the table's figures, read by `figures`) and `tables` (its
print); `path_picture`, `error_pictures`, `axis_pictures` (what is drawn: `charts`, thinned by `decimate`);
`plotly_view` and `html` (the page), `matplotlib_view` and `plots` (single files). plotly, matplotlib and
jinja2 are imported when used.
"""

from contourlab.report.data import (
    AxisBounds,
    CircleRun,
    FrequencyResponse,
    Mark,
    Provenance,
    ReportData,
    SchemeReport,
)
from contourlab.report.html import render_html, write_html
from contourlab.report.plots import write_plots
from contourlab.report.tables import comparison_markdown, comparison_text

__all__ = [
    "AxisBounds",
    "CircleRun",
    "FrequencyResponse",
    "Mark",
    "Provenance",
    "ReportData",
    "SchemeReport",
    "comparison_markdown",
    "comparison_text",
    "render_html",
    "write_html",
    "write_plots",
]
