"""Which files of a folder of results contourlab wrote: a list beside them, so that nothing else is ever replaced."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

LIST = ".contourlab.json"
"""Name of the list."""
OURS = (
    *("report.html", "signals/*.nc", "switches/*.csv", "learned/*.nc", "controllers/*.toml"),
    *("plots/*.png", "plots/*.svg", "plots/*.pdf"),
    *("swap.json", "summary.json"),
)
"""What may be in it; a summary comes last, so that where it is the rest is complete."""
SINGLE = "single"
"""Stands for the summary of files that go with none."""
PRODUCTS = "learned/"
"""What is no report but a product is single, whatever it was written with."""


@dataclass(frozen=True)
class WrittenFiles:
    """Files that contourlab wrote into a folder, by the summary that they go with; names are relative to the folder, as POSIX has them."""

    sets: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @staticmethod
    def of(folder: Path) -> WrittenFiles:
        """Read the list of a folder, as far as its files are there; nothing is known to be ours where it is damaged or missing."""
        try:
            told = json.loads((folder / LIST).read_text(encoding="utf-8"))["files"]
            sets = {str(summary): frozenset(names) for summary, names in told.items()}
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return WrittenFiles()
        there = {path.relative_to(folder).as_posix() for pattern in OURS for path in folder.glob(pattern)}
        return WrittenFiles({summary: names & there for summary, names in sets.items()})

    @property
    def names(self) -> frozenset[str]:
        """All of them."""
        return frozenset().union(*self.sets.values())

    def beside(self, summary: str) -> frozenset[str]:
        """Return those that newer results with that summary take the place of; none without a summary."""
        return self.sets.get(summary, frozenset()) if summary else frozenset()

    def after(self, summary: str, new: Iterable[str]) -> WrittenFiles:
        """Return what there is once `new` has come, with that summary or with none."""
        written = frozenset(new)
        single = frozenset(name for name in written if not summary or name.startswith(PRODUCTS))
        sets = {one: names - written for one, names in self.sets.items() if one != summary}
        sets[SINGLE] = sets.get(SINGLE, frozenset()) | single
        return WrittenFiles({**sets, summary: written - single} if summary else sets)

    def with_more(self, summary: str, names: Iterable[str]) -> WrittenFiles:
        """Return these and others that go with that summary."""
        return WrittenFiles({**self.sets, summary: self.sets.get(summary, frozenset()) | frozenset(names)})

    def save(self, file: Path) -> None:
        """Write the list."""
        files = {summary: sorted(names) for summary, names in sorted(self.sets.items()) if names}
        file.write_text(json.dumps({"schema": "contourlab-files/1", "files": files}, indent=2) + "\n", encoding="utf-8")
