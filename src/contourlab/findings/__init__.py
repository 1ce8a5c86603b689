"""Findings: remarks, warnings and conclusions about a result, as values with a code.

Create a finding where it is detected, from its code and the values for its text:

    finding("CL201", place="axis x", time=0.5)

The catalogue (``catalogue/*.toml`` beside this file) has a name, severity, text, meaning and remedy for each code.
Terminal, report and JSON render the finding; ``contourlab explain CODE`` prints its page.
"""

from __future__ import annotations

import re
import string
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any

from contourlab.figures import figure, listing

__all__ = ["SEVERITIES", "Entry", "Finding", "catalogue", "finding"]

SEVERITIES = ("info", "warning", "error")


@dataclass(frozen=True)
class Entry:
    """The catalogue entry of a code.

    Attributes
    ----------
    code, name : str
        For example ``CL201`` and ``change-after-the-end``.
    severity : str
        One of `SEVERITIES`.
    text : str
        One line; a field such as ``{time:s}`` takes a value of the finding and a display unit.
    meaning, remedy : str
        Meaning for the result, and what to do.
    """

    code: str
    name: str
    severity: str
    text: str
    meaning: str
    remedy: str

    @property
    def outline(self) -> str:
        """The text with names in place of values, such as ``<time>``."""
        return re.sub(r"\{(\w+)[^}]*\}", lambda field: f"<{field[1].replace('_', ' ')}>", self.text)


@dataclass(frozen=True)
class Finding:
    """One remark, warning or conclusion.

    Attributes
    ----------
    code : str
        A code of the catalogue.
    values : mapping
        Values for the text: numbers in SI, names, sequences of names.
    place : str
        What the finding concerns: ``axis x``, ``line 48``, the name of a log; empty for the whole.
    """

    code: str
    values: Mapping[str, Any] = field(default_factory=dict)
    place: str = ""

    @property
    def entry(self) -> Entry:
        """The entry in the catalogue."""
        return catalogue()[self.code]

    @property
    def text(self) -> str:
        """The line of text, with the place in front."""
        words = _Words().vformat(self.entry.text, (), self.values)
        return f"{self.place}: {words}" if self.place else words

    def __str__(self) -> str:
        return f"{self.code} {self.entry.severity}: {self.text}"


def finding(code: str, place: str = "", **values: Any) -> Finding:
    """Create a finding; see `Finding`."""
    return Finding(code, values, place)


@cache
def catalogue() -> dict[str, Entry]:
    """Return the entries of all codes, in order of code."""
    entries: dict[str, Entry] = {}
    for file in sorted(files(__package__).joinpath("catalogue").iterdir(), key=lambda file: file.name):
        for code, fields in tomllib.loads(file.read_text(encoding="utf-8")).items():
            entries[code] = Entry(code, **{key: " ".join(text.split()) for key, text in fields.items()})
    return dict(sorted(entries.items()))


class _Words(string.Formatter):
    """Format fields: numbers in the field's display unit, sequences as a list of names."""

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, bool | str):
            return str(value)
        if isinstance(value, int) and not format_spec:
            return str(value)
        if isinstance(value, list | tuple):
            return listing([str(item) for item in value])
        return figure(float(value), format_spec)
