"""Pictures of a reproduction."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from contourlab.report.charts import Chart
from contourlab.report.plots import write_charts
from contourlab.report.reproduction_pictures import course_chart, sweep_chart, turn_chart

__all__ = ["check_choice", "write_gecer_ulu"]

RATIO = "contour rms of FB CCC ILC over FB ILC, over kappa"


def check_choice(folder: str | Path, formats: Sequence[str]) -> None:
    """See that pictures can be written.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If the folder cannot be made or written to.
    """
    from contourlab.session.folder import staged

    write_charts((), folder, formats)
    with staged(folder):
        pass


def write_gecer_ulu(rows: Sequence[dict[str, Any]], folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write Figs 9 and 10 of Gecer Ulu et al., and the gain of coupling over kappa, into a folder; return the files.

    Parameters
    ----------
    rows : sequence of dict
        Of the reproduction.
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.
    """
    from contourlab.studies.reproduce.gecer_ulu_pictures import convergence, turn
    from contourlab.studies.reproduce.gecer_ulu_setup import EXPERIMENT, SIMULATION

    charts: list[Chart] = [
        course_chart("fig-9", "Fig 9: contour rms over trials, FB CCC ILC", {name: convergence(name) for name in (SIMULATION, EXPERIMENT)})
    ]
    for name in (SIMULATION, EXPERIMENT):
        seen = turn(name)
        errors = {"FB": seen.feedback_contour, "FB CCC ILC": seen.learned_contour}
        charts.append(turn_chart(f"fig-10-{name}", f"Fig 10: around the tight turn, {name}", seen.time, errors))
    found = {float(row["case"].rpartition(" ")[2]): row["here"] for row in rows if row["name"] == RATIO}
    curve = {"here, 30 trials": list(found.values())}
    charts.append(sweep_chart("kappa", "Contour rms of FB CCC ILC over that of FB ILC", "kappa", list(found), curve, 0.78 / 2.73))
    return write_charts(charts, folder, formats)
