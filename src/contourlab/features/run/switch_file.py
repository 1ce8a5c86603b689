"""The switches of a run as a file: one line each, for a spreadsheet or a script."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from contourlab.loop.switches import Switches
from contourlab.result.atomic import replacing

HEAD = ("time_s", "sample", "axis", "from", "to", "reason", "arc_length_m", "line")


class SwitchWriter:
    """Writes the switches of block after block to an open file."""

    def __init__(self, stream: TextIO) -> None:
        self._rows = csv.writer(stream, lineterminator="\n")
        self._rows.writerow(HEAD)

    def append(self, switches: Switches) -> None:
        """Write the switches of the next block."""
        words = [(kind.axis, kind.before, kind.after, kind.reason) for kind in switches.kinds]
        columns = (switches.time.tolist(), switches.sample.tolist(), switches.kind.tolist(), switches.arc_length.tolist())
        for time, sample, kind, along, line in zip(*columns, switches.line.tolist(), strict=True):
            place = f"{along:.12g}" if math.isfinite(along) else ""
            self._rows.writerow((f"{time:.12g}", sample, *words[kind], place, line or ""))


@contextmanager
def switch_file(file: str | Path) -> Iterator[SwitchWriter]:
    """Open a file of switches (CSV, UTF-8), which appears whole when the block ends well, and not at all otherwise.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    with replacing(file) as temporary, temporary.open("w", encoding="utf-8", errors="replace", newline="") as stream:
        yield SwitchWriter(stream)
