"""Pictures of a reproduction."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.report.charts import Chart, PolarChart
from contourlab.report.plots import write_charts
from contourlab.report.reproduction_pictures import circle_chart, course_chart, sweep_chart, traces_chart, turn_chart

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
    from contourlab.app.folder import staged

    write_charts((), folder, formats)
    with staged(folder):
        pass


def write_ghaffari(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write Figs 6 and 7 of Ghaffari & Ulsoy into a folder; return the files.

    Parameters
    ----------
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.
    """
    from contourlab.papers.ghaffari.sensitivity import axis_curves
    from contourlab.report.reproduction_pictures import overlaid_chart

    found = {f"axis {number}": axis_curves(number) for number in (1, 2, 3)}
    figures = {
        "fig-6a": ("Fig 6(a): observer, around Table III", ("a_hat", "b_hat")),
        "fig-6b": ("Fig 6(b): feedforward, around Table III", ("a'", "b'")),
        "fig-7": ("Fig 7: position control, around Table III", ("K_V", "K_P", "K_I")),
    }
    charts = []
    for key, (title, names) in figures.items():
        tiles = {}
        for name in names:
            members = {axis: curves[name] for axis, curves in found.items()}
            number = members["axis 1"].number
            drawn = {
                axis: (
                    np.array([number.shown(value) for value in curve.values]),
                    curve.figures * 1e6,
                    curve.number.shown(curve.number.value),
                    None if curve.minimum is None else (number.shown(curve.minimum.value), curve.minimum.figure * 1e6),
                )
                for axis, curve in members.items()
            }
            tiles[name] = (f"{name} [{number.display}]", drawn)
        charts.append(overlaid_chart(key, title, "contour error integral [um s]", tiles))
    return write_charts(charts, folder, formats)


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
    from contourlab.papers.gecer_ulu.pictures import convergence, turn
    from contourlab.papers.gecer_ulu.setup import EXPERIMENT, SIMULATION

    charts: list[Chart | PolarChart] = [
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


def write_shahin(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write Figs 7 to 13 of Shahin et al. into a folder; return the files.

    Parameters
    ----------
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.
    """
    from contourlab.papers.shahin import setup as setup
    from contourlab.papers.shahin.pictures import trace

    gap, none = setup.Setting(), setup.Setting(gap=0.0)
    baselines = {
        "on the motors, no backlash": trace("PI", none),
        "on the motors, 25 um": trace("PI", gap),
        "closed over the loads, 25 um": trace("PI on the load", gap),
    }
    charts: list[Chart | PolarChart] = [
        circle_chart(
            "fig-7-8", "Figs 7, 8: PI on the circle at 8000 mm/min", setup.RADIUS, {k: (t.angle, t.radial) for k, t in baselines.items()}
        )
    ]
    schemes = {name: trace(name, gap) for name in setup.SCHEMES}
    feeds = {f"scheme {name}": (found.time, found.axis_feed_error[:, 0] * 60.0) for name, found in schemes.items()}
    charts.append(traces_chart("fig-9", "Fig 9: feedrate error of x", ("time [s]", "feedrate error [m/min]"), feeds))
    errors = {
        f"scheme {name}, {axis}": (schemes[name].time, schemes[name].axis_error[:, j] * 1e6)
        for name in ("II", "III")
        for j, axis in enumerate(setup.AXES)
    }
    charts.append(traces_chart("fig-10", "Fig 10: axis errors of schemes II and III", ("time [s]", "axis error [um]"), errors))
    for number, (name, found) in zip((11, 12, 13), schemes.items(), strict=True):
        rate = {f"scheme {name}": (found.time, found.feedrate * 60.0)}
        title = f"Fig {number}: overall feedrate, scheme {name}"
        charts.append(traces_chart(f"fig-{number}", title, ("time [s]", "feedrate [m/min]"), rate, 8.0))
    return write_charts(charts, folder, formats)


def write_emps(log: str | Path | None, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write force, friction curve and position error of the EMPS into a folder; return the files.

    Parameters
    ----------
    log : str or Path
        DATA_EMPS.mat.
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.
    """
    from contourlab.papers.emps import pictures as drawn
    from contourlab.papers.emps.study import identified

    found = identified(log)
    force, late = ("time [s]", "force [N]"), "EMPS: reference less position"
    charts = [
        traces_chart("emps-force", "EMPS: measured and predicted force", force, drawn.predicted_force(found)),
        traces_chart("emps-force-left", "EMPS: what the model leaves of the force", force, drawn.force_left_over(found)),
        traces_chart("emps-friction", "EMPS: friction and offset", ("velocity [mm/s]", "force [N]"), drawn.friction_curves(found)),
        traces_chart("emps-error", late, ("time [s]", "position error [mm]"), drawn.position_errors(found)),
        traces_chart("emps-error-left", "EMPS: measured less simulated", ("time [s]", "position [um]"), drawn.error_left_over(found)),
    ]
    return write_charts(charts, folder, formats)


def write_ubc(folder_of_logs: str | Path | None, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write tracking and contour errors of both runs of the UBC table, measured and simulated, into a folder; return the files.

    Parameters
    ----------
    folder_of_logs : str or Path
        With line_circle_lli.mat and line_circle_pp.mat.
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.
    """
    from contourlab.papers.ubc.runs import contour_errors, read_runs, tracking_errors

    charts = []
    for name, run in read_runs(folder_of_logs).items():
        for axis, traces in tracking_errors(run).items():
            labels = "time [s]", f"tracking error of {axis} [um]"
            charts.append(traces_chart(f"ubc-{name}-{axis}", f"UBC table, {name}: tracking error of {axis}", labels, traces))
        labels = "place along the path [mm]", "contour error [um]"
        charts.append(traces_chart(f"ubc-{name}-contour", f"UBC table, {name}: contour error", labels, contour_errors(run)))
    return write_charts(charts, folder, formats)
