"""A scenario that is written and read again is the same."""

import pytest

from contourlab.scenario import load_scenario
from contourlab.scenario.dump import case_tables, dump

SHIPPED = ("demo-part", "gecer-ulu/contour", "gecer-ulu/contour-simulated", "emps/circle", "backlash/part", "ubc/lead-lag")


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_scenarios_are_the_same_after_writing_and_reading(name, tmp_path):
    first = load_scenario(f"builtin:{name}")
    file = tmp_path / "again.toml"
    file.write_text(dump(first), encoding="utf-8")
    again = load_scenario(file)
    assert [case.name for case in again.cases()] == [case.name for case in first.cases()]
    for one, other in zip(first.cases(), again.cases(), strict=True):
        assert case_tables(one) == case_tables(other)
        assert (one.learning is None) == (other.learning is None)
