"""Pictures as a message to the viewer, or to any other front end: contract ``contourlab-page/1``.

A message is compressed by gzip. Inside: the length of the header (4 bytes, little-endian), the header (JSON in UTF-8, padded with spaces to
a multiple of 8 bytes together with its length), and the numbers of all arrays. The header is
``{"contract": "contourlab-page/1", "pictures": [...]}``. A dataclass is an object of its fields and its ``kind``, the name of the class. An
array is ``{"dtype": "f4" | "f8" | "i4" | "u1", "at": byte, "shape": [...]}``: little-endian, row by row, from that byte of the numbers on;
equal arrays share their place.
Only arrays hold numbers that are not finite. Types: ``viewer/contract.json``, JSON Schema.
"""

from __future__ import annotations

import gzip
import json
import struct
from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from contourlab.rendering.charts import Chart, CircleCauses, Exact, Heat, LiveLoop, PathScene, Picture, PolarChart

CONTRACT = "contourlab-page/1"
"""Later versions may add kinds and fields; one that changes a meaning has another number."""
Drawn = Chart | PolarChart | PathScene | Heat | CircleCauses | LiveLoop
"""What the viewer draws."""
SINGLE = 64.0
"""Largest magnitude over spread for float32: rounding to 2^-24 of the value is then 2^-18 of the spread, far below a pixel."""


def message(pictures: Iterable[Picture]) -> bytes:
    """Return pictures as a message; the same pictures give the same bytes.

    >>> len(message([])) < 100
    True
    """
    packer = _Packer()
    header = {"contract": CONTRACT, "pictures": [packer.values(picture) for picture in pictures]}
    text = json.dumps(header, allow_nan=False, separators=(",", ":"), ensure_ascii=False).encode("utf-8", "replace")
    text += b" " * (-(len(text) + 4) % 8)
    return gzip.compress(struct.pack("<I", len(text)) + text + bytes(packer.numbers), 6, mtime=0)


class _Packer:
    """Collects the numbers of arrays; equal arrays share their place."""

    def __init__(self) -> None:
        self.numbers = bytearray()
        self.places: dict[tuple[str, bytes], int] = {}

    def values(self, value: Any, exact: bool = False) -> Any:
        """Return a value for JSON."""
        if isinstance(value, np.ndarray):
            return self.placed(value, _exactly(value) if exact else _seen(value))
        if is_dataclass(value):
            known = {one.name: self.values(getattr(value, one.name), isinstance(value, Exact)) for one in fields(value)}
            return {"kind": type(value).__name__, **known}
        if isinstance(value, tuple | list):
            return [self.values(item, exact) for item in value]
        return value.item() if isinstance(value, np.generic) else value

    def placed(self, array: np.ndarray[Any, Any], kind: str) -> dict[str, Any]:
        """Return the place of an array."""
        packed = array.astype("<" + kind).tobytes()
        if (kind, packed) not in self.places:
            self.numbers.extend(b"\0" * (-len(self.numbers) % 8))
            self.places[kind, packed] = len(self.numbers)
            self.numbers.extend(packed)
        return {"dtype": kind, "at": self.places[kind, packed], "shape": list(array.shape)}


def _seen(array: np.ndarray[Any, Any]) -> str:
    """Return how an array of a picture travels: as float32 if that is precise enough."""
    return "i4" if array.dtype.kind in "bui" else "f4" if _fits_single(array) else "f8"


def _exactly(array: np.ndarray[Any, Any]) -> str:
    """Return the smallest kind that holds every bit of numbers, as float64."""
    bits = array.astype(np.float64).view(np.int64)
    with np.errstate(invalid="ignore", over="ignore"):
        kinds = (kind for kind in ("u1", "i4", "f4") if np.array_equal(array.astype(kind).astype(np.float64).view(np.int64), bits))
        return next(kinds, "f8")


def _fits_single(values: np.ndarray[Any, Any]) -> bool:
    """Return whether rounding to float32 is invisible, even at a hundredfold zoom."""
    good = values[np.isfinite(values)]
    if good.size == 0:
        return True
    largest, spread = float(np.max(np.abs(good))), float(np.ptp(good))
    return largest < 1e37 and (spread == 0.0 or largest <= SINGLE * spread)
