"""Where benchmarks keep their figures."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from pathlib import Path
from typing import Any


def write(name: str, rows: Sequence[dict[str, Any]]) -> None:
    """Write rows to a file in benchmarks/out, with the platform."""
    file = Path(__file__).resolve().parent / "out" / name
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps({"platform": platform.platform(), "rows": rows}, indent=2), encoding="utf-8")
