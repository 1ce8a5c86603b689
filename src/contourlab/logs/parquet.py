"""Read Apache Parquet with pyarrow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import LogError
from contourlab.extras import extra_module
from contourlab.findings import finding
from contourlab.logs.reading import name_and_unit
from contourlab.logs.record import Channel, Record

MAGIC = b"PAR1"


def matches(file: Path, head: bytes) -> bool:
    """Tell whether the first bytes are those of Parquet."""
    return head.startswith(MAGIC)


def read(file: Path) -> Record:
    """Read columns of numbers and times; units are in brackets in the name, or under ``unit`` in the metadata.

    Raises
    ------
    LogError
        If the file cannot be read.
    """
    arrow = extra_module("pyarrow")
    parquet = extra_module("pyarrow.parquet")
    try:
        table = parquet.ParquetFile(file).read()
    except (arrow.ArrowException, OSError, ValueError) as error:
        raise LogError(f"cannot be read as Parquet: {str(error).splitlines()[0]}", file=file) from error
    channels = [_channel(field, table.column(i)) for i, field in enumerate(table.schema)]
    left_out = [field.name for field, channel in zip(table.schema, channels, strict=True) if channel is None]
    findings = (finding("CL425", columns=left_out),) if left_out else ()
    return Record(file, "parquet", tuple(channel for channel in channels if channel), findings=findings)


def _channel(field: Any, column: Any) -> Channel | None:
    from pyarrow import types

    name, unit = name_and_unit(field.name)
    own_unit = (field.metadata or {}).get(b"unit", b"").decode("utf-8", errors="replace")
    kind = field.type
    if types.is_timestamp(kind) or types.is_duration(kind):
        # Counted from the first: doubles cannot hold nanoseconds since 1970.
        valid = column.is_valid().to_numpy(zero_copy_only=False)
        ticks = column.drop_null().cast("int64").to_numpy(zero_copy_only=False)
        values = np.full(valid.size, np.nan)
        values[valid] = (ticks - ticks[:1]) * {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}[kind.unit]
        return Channel(name, values, "s", is_timestamp=types.is_timestamp(kind))
    if types.is_integer(kind) or types.is_floating(kind) or types.is_boolean(kind) or types.is_decimal(kind):
        values = np.array([np.nan if v is None else float(v) for v in column.to_pylist()]) if column.null_count else column.to_numpy()
        return Channel(name, np.asarray(values, dtype=np.float64), own_unit or unit)
    return None
