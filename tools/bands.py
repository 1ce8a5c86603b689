"""Write the bands of a reproduction: ``contourlab reproduce PAPER --json | python tools/bands.py PAPER``.

A row that has a band keeps it; ``--renew`` makes all bands anew: 2 % on each side of our figure, or the tolerance around a derived figure
or an identity. Widen by hand, in ``bands.csv``, what differs more between machines.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import sys
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parents[1] / "src" / "contourlab" / "papers"
WIDTH = 0.02


def band(row: dict[str, Any]) -> tuple[float, float]:
    """Return the band of a row as JSON has it."""
    here = math.nan if row["here"] is None else row["here"]
    if row["kind"] in ("derived", "identity") and row["tolerance"] is not None:
        middle, width = row["paper"], row["tolerance"]
        if abs(here - middle) <= width:
            return middle - width, middle + width
    width = WIDTH * abs(here)
    return here - width, here + width


def main() -> int:
    """Read rows from standard input and write the bands of the paper."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("paper", choices=sorted(file.name for file in FOLDER.iterdir() if (file / "study.py").exists()))
    parser.add_argument("--renew", action="store_true", help="centre all bands again")
    options = parser.parse_args()
    file = FOLDER / options.paper / "bands.csv"
    rows = json.load(sys.stdin)
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(("name", "case", "low", "high"))
        for row in rows:
            low, high = band(row) if options.renew or row["band"] is None else row["band"]
            writer.writerow((row["name"], row["case"], *(f"{math.nan if limit is None else limit:.12g}" for limit in (low, high))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
