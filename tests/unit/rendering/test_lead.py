"""The first sentence of a report, and the error of each program line."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import synthetic

from contourlab.rendering.judgement import FEED, Change
from contourlab.rendering.lead import lines_at, program_lines, sentence


def test_the_sentence_has_the_figures_of_the_verdict() -> None:
    data = synthetic.report()
    worst, best = (scheme.metrics.part_error.max * 1e6 for scheme in data.schemes)
    assert f"{best:.3g} um" in sentence(data) and "1 of 2" in sentence(data) and data.schemes[1].name in sentence(data)
    alone = sentence(replace(data, schemes=data.schemes[:1]))
    assert f"{worst:.3g} um" in alone and "5 um" in alone and "line 4" in alone and "reversal" in alone
    unjudged = replace(data.schemes[0], verdict=None)
    assert f"{worst:.3g} um" in sentence(replace(data, schemes=[unjudged], tolerance=None))


def test_a_price_of_many_seconds_has_no_exponent() -> None:
    data = synthetic.report((8e-6,))
    verdict = replace(data.schemes[0].verdict, changes=(Change(FEED, 4e-6, 904.0), Change("a change", 3e-6, -0.123)))
    text = sentence(replace(data, schemes=[replace(data.schemes[0], verdict=verdict)]))
    assert "4 um, +900 s" in text and "3 um, -0.12 s" in text


def test_a_line_has_the_largest_error_of_its_samples() -> None:
    data = synthetic.report()
    rows = {row.number: row for row in program_lines(data)}
    assert set(rows) == {3, 4}
    for column, scheme in enumerate(data.schemes):
        judged = scheme.metrics.judged.samples
        errors = np.abs(scheme.result["part_error"][judged]) * 1e6
        for line in (3, 4):
            largest = errors[scheme.lines(judged) == line].max()
            assert rows[line].errors[column] == (f"{largest:.3g}", largest > 1e6 * data.tolerance)


def test_of_a_long_program_the_worst_lines_are_shown() -> None:
    data = synthetic.report((8e-6,), laps=1)
    scheme = data.schemes[0]
    n = scheme.result.n_sample
    program = tuple(f"G1 X{i} " + "(" + "x" * 5000 + ")" for i in range(n))
    places = scheme.result["arc_length"]
    reference = replace(scheme.reference, line_breaks=np.append(places, np.inf), source_lines=np.arange(1, n + 1))
    verdict = replace(scheme.verdict, worst=replace(scheme.verdict.worst, line=int(scheme.verdict.worst.sample) + 1))
    rows = program_lines(replace(data, program=program, schemes=[replace(scheme, reference=reference, verdict=verdict)]))
    assert len(rows) <= 501 and max(len(row.text) for row in rows) <= 200
    judged = scheme.metrics.judged.samples
    largest = int(judged[np.abs(scheme.result["part_error"][judged]).argmax()]) + 1
    assert largest in {row.number for row in rows}


def test_a_place_has_its_line() -> None:
    data = synthetic.report()
    reference, length = data.schemes[0].reference, data.asked.length
    assert lines_at(reference, np.array([0.0, 0.49, 0.51, 1.0]) * length).tolist() == [3, 3, 4, 4]
    assert lines_at(replace(reference, source_lines=np.zeros(2, dtype=np.int64)), np.array([0.0, length])).tolist() == [0, 0]
