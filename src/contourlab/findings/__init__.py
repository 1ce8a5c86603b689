"""Findings: everything that contourlab remarks, warns of or concludes about a result, as values with a code.

A finding is made where it is found, from its code and the values that its text needs:

    finding("CL201", place="axis x", time=0.5)

The catalogue (``catalogue/*.toml`` beside this file) has for each code a name, a severity, the text, what it means and what to do.
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
    """What the catalogue has for a code.

    Attributes
    ----------
    code, name : str
        As ``CL201`` and ``change-after-the-end``.
    severity : str
        One of `SEVERITIES`.
    text : str
        One line; fields as ``{time:s}`` take a value of the finding and a display unit.
    meaning, remedy : str
        What it means for the result, and what to do.
    """

    code: str
    name: str
    severity: str
    text: str
    meaning: str
    remedy: str

    @property
    def outline(self) -> str:
        """The text with the names of its values, as ``<time>``."""
        return re.sub(r"\{(\w+)[^}]*\}", lambda field: f"<{field[1].replace('_', ' ')}>", self.text)


@dataclass(frozen=True)
class Finding:
    """One remark, warning or conclusion.

    Attributes
    ----------
    code : str
        Of the catalogue.
    values : mapping
        What the text needs: numbers in SI, names, sequences of names.
    place : str
        What it is about: ``axis x``, ``line 48``, the name of a log; empty for the whole.
    """

    code: str
    values: Mapping[str, Any] = field(default_factory=dict)
    place: str = ""

    @property
    def entry(self) -> Entry:
        """Its entry in the catalogue."""
        return catalogue()[self.code]

    @property
    def text(self) -> str:
        """Its one line, with the place ahead."""
        words = _Words().vformat(self.entry.text, (), self.values)
        return f"{self.place}: {words}" if self.place else words

    def __str__(self) -> str:
        return f"{self.code} {self.entry.severity}: {self.text}"


def finding(code: str, place: str = "", **values: Any) -> Finding:
    """Make a finding; see `Finding`."""
    return Finding(code, values, place)


@cache
def catalogue() -> dict[str, Entry]:
    """Return the entries of all codes, in order."""
    entries: dict[str, Entry] = {}
    for file in sorted(files(__package__).joinpath("catalogue").iterdir(), key=lambda file: file.name):
        for code, fields in tomllib.loads(file.read_text(encoding="utf-8")).items():
            entries[code] = Entry(code, **{key: " ".join(text.split()) for key, text in fields.items()})
    return dict(sorted(entries.items()))


class _Words(string.Formatter):
    """Format fields: numbers in the display unit that the field names, sequences as a list of names."""

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, bool | str):
            return str(value)
        if isinstance(value, int) and not format_spec:
            return str(value)
        if isinstance(value, list | tuple):
            return listing([str(item) for item in value])
        return figure(float(value), format_spec)
