"""Learning in the report: the errors of each trial as picture and text, and the cost of a servo tick."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contourlab.rendering.comparison import compare
from contourlab.rendering.data import ReportData, TrialCourse
from contourlab.rendering.html import render_html
from contourlab.rendering.learning_pictures import trial_charts, trial_rows, trials_text
from contourlab.rendering.plots import write_plots


def course(n: int = 31, best: int = 17, status: str = "converged") -> TrialCourse:
    rms = 1e-6 * 0.8 ** np.arange(n)
    return TrialCourse(rms, np.column_stack([3.0 * rms, 4.0 * rms]), best, status)


@pytest.fixture
def learned(circle: ReportData) -> ReportData:
    """Return data in which the second run has learned."""
    first, second = circle.schemes
    return replace(circle, schemes=[replace(first, tick=2e-7), replace(second, trials=course(), tick=2.5e-7)])


def test_the_picture_has_the_errors_of_all_trials(learned: ReportData) -> None:
    (chart,) = trial_charts(learned)
    contour, tracking = chart.panels
    level, falling = contour.curves
    assert level.y.tolist() == [learned.schemes[0].metrics.contour_error.rms * 1e6] * 2
    np.testing.assert_allclose(falling.y, 0.8 ** np.arange(31))
    np.testing.assert_allclose(tracking.curves[0].y, 5.0 * 0.8 ** np.arange(31))
    assert contour.log_y and "converged, best trial 17 of 30" in chart.caption


def test_the_errors_of_some_trials_are_drawn_over_time(learned: ReportData) -> None:
    time, rms = np.linspace(0.0, 1.0, 5), np.ones(13)
    errors = tuple((time, np.full(5, 1e-6 * trial)) for trial in range(13))
    kept = TrialCourse(rms, np.ones((13, 2)), 7, "converged", errors)
    charts = trial_charts(replace(learned, schemes=[learned.schemes[0], replace(learned.schemes[1], trials=kept)]))
    (panel,) = charts[-1].panels
    assert [curve.name for curve in panel.curves] == [f"trial {trial}" + ", the best" * (trial == 7) for trial in (0, 1, 2, 5, 7, 10, 12)]
    assert [curve.y[0] for curve in panel.curves] == pytest.approx([0.0, 1.0, 2.0, 5.0, 7.0, 10.0, 12.0])


def test_a_report_without_learning_does_not_mention_it(circle: ReportData) -> None:
    assert trial_charts(circle) == ()
    assert trials_text(circle) == ""
    assert 'id="trials"' not in render_html(circle)
    assert not {"learning", "computing time per servo tick"} & {row.label for row in compare(circle).rows}


def test_trials_with_zero_error_and_failed_trials_leave_gaps(learned: ReportData) -> None:
    rms = np.array([1e-6, 0.0, np.nan])
    odd = replace(
        learned, schemes=[replace(learned.schemes[1], trials=TrialCourse(rms, rms[:, None], 0, "diverged, rolled back to trial 0"))]
    )
    (chart,) = trial_charts(odd)
    assert np.isnan(chart.panels[0].curves[0].y).tolist() == [False, True, True]
    assert compare(odd).rows[0].cells[0].mood == "poor" or compare(odd).rows[1].cells[0].mood == "poor"
    render_html(odd)


def test_the_text_shows_first_best_and_last(learned: ReportData) -> None:
    lines = trials_text(learned).splitlines()
    assert [int(line.split()[0]) for line in lines if line.strip()[:1].isdigit()] == [0, 1, 2, 3, 4, 5, 10, 15, 17, 20, 25, 30]
    (best,) = [line for line in lines if line.endswith("best")]
    assert best.split()[0] == "17"
    assert float(best.split()[1]) == pytest.approx(0.8**17, rel=1e-3)
    assert [row[0] for row in trial_rows(course(3, 2))] == [0, 1, 2]
    assert len(trial_rows(course(1001, 700))) <= 20


def test_the_table_shows_the_end_and_the_cost(learned: ReportData) -> None:
    rows = {row.label: [cell.text for cell in row.cells] for row in compare(learned).rows}
    assert rows["learning"][0] == "-" and rows["learning"][1].startswith("converged") and "17 of 30" in rows["learning"][1]
    assert rows["computing time per servo tick"] == ["200", "250"]


@pytest.mark.slow
def test_page_and_plots_contain_the_picture(learned: ReportData, tmp_path: Path) -> None:
    page = render_html(learned)
    assert page.count('id="trials"') == 1 and "converged, best trial 17 of 30." in page
    assert (tmp_path / "trials.png") in write_plots(learned, tmp_path)
