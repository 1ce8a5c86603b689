"""Pictures as a message to the viewer, or to any other front end: contract ``contourlab-page/1``.

A message is compressed by gzip. Inside: the length of the header (4 bytes, little-endian), the header (JSON in UTF-8, padded with spaces to
a multiple of 8 bytes together with its length), and the numbers of all arrays. The header is
``{"contract": "contourlab-page/1", "pictures": [...]}``. A dataclass is an object of its fields and its ``kind``, the name of the class. An
array is ``{"dtype": "f4" | "f8" | "i4", "at": byte, "shape": [...]}``: little-endian, row by row, from that byte of the numbers on.
Only arrays hold numbers that are not finite. Types: ``viewer/contract.json``, JSON Schema.
"""

from __future__ import annotations

import gzip
import json
import struct
from collections.abc import Iterable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from contourlab.rendering.charts import Chart, CircleCauses, Heat, PathChart, Picture, PolarChart

CONTRACT = "contourlab-page/1"
"""Later versions may add kinds and fields; one that changes a meaning has another number."""
Drawn = Chart | PolarChart | PathChart | Heat | CircleCauses
"""What the viewer draws."""
SINGLE = 64.0
"""Largest magnitude over spread for float32: rounding to 2^-24 of the value is then 2^-18 of the spread, far below a pixel."""


def message(pictures: Iterable[Picture]) -> bytes:
    """Return pictures as a message; the same pictures give the same bytes.

    >>> len(message([])) < 100
    True
    """
    numbers = bytearray()
    header = {"contract": CONTRACT, "pictures": [_values(picture, numbers) for picture in pictures]}
    text = json.dumps(header, allow_nan=False, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-(len(text) + 4) % 8)
    return gzip.compress(struct.pack("<I", len(text)) + text + bytes(numbers), 9, mtime=0)


def _values(value: Any, numbers: bytearray) -> Any:
    """Return a value for JSON; append its arrays to the numbers."""
    if isinstance(value, np.ndarray):
        return _placed(value, numbers)
    if is_dataclass(value):
        parts = {field.name: _values(getattr(value, field.name), numbers) for field in fields(value)}
        return {"kind": type(value).__name__, **parts}
    if isinstance(value, Mapping):
        return {key: _values(item, numbers) for key, item in value.items()}
    if isinstance(value, tuple | list):
        return [_values(item, numbers) for item in value]
    return value.item() if isinstance(value, np.generic) else value


def _placed(array: np.ndarray[Any, Any], numbers: bytearray) -> dict[str, Any]:
    """Append an array, as float32 if that is precise enough for a picture, and return its place."""
    if array.dtype.kind in "bui":
        kind = "i4"
    else:
        array = np.asarray(array, dtype=np.float64)
        kind = "f4" if _fits_single(array) else "f8"
    numbers.extend(b"\0" * (-len(numbers) % 8))
    place = {"dtype": kind, "at": len(numbers), "shape": list(array.shape)}
    numbers.extend(array.astype("<" + kind).tobytes())
    return place


def _fits_single(values: np.ndarray[Any, Any]) -> bool:
    """Return whether rounding to float32 is invisible, even at a hundredfold zoom."""
    good = values[np.isfinite(values)]
    if good.size == 0:
        return True
    largest, spread = float(np.max(np.abs(good))), float(np.ptp(good))
    return largest < 1e37 and (spread == 0.0 or largest <= SINGLE * spread)
