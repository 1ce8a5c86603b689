"""Numbers of a file that the wizard writes, each with where it is from."""

from __future__ import annotations

from typing import Any

from contourlab.components.origin import Origin
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted


def given(value: Any, note: str = "") -> Noted:
    """Return a number that somebody answered with, off a data sheet."""
    return _sourced(value, Origin("datasheet", reference="as given", note=note))


def guessed(value: Any, note: str) -> Noted:
    """Return a number that nobody gave."""
    return _sourced(value, Origin("assumed", note=note))


def designed(value: Any, note: str) -> Noted:
    """Return a number that was worked out for a controller, and is exactly what it says."""
    return _sourced(value, Origin("design", note=note))


def _sourced(value: Any, origin: Origin) -> Noted:
    return Noted(origin_table(value, origin, str))
