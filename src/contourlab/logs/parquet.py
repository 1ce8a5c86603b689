"""Read Apache Parquet with pyarrow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from contourlab.extras import extra_module
from contourlab.findings import finding
from contourlab.logs.reading import COLUMNS, NUMBERS, Channel, Record, check_limit, name_and_unit

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
    parquet = extra_module("pyarrow.parquet")
    with parquet.ParquetFile(file, page_checksum_verification=True) as stored:
        schema = stored.schema_arrow
        names = [field.name for field in schema if _is_read(field.type)]
        check_limit(len(names), COLUMNS, "columns", file)
        check_limit(stored.metadata.num_rows * len(names), NUMBERS, "numbers", file)
        table = stored.read(names, use_threads=False)
    left_out = [field.name for field in schema if not _is_read(field.type)]
    findings = (finding("CL425", columns=left_out),) if left_out else ()
    channels = tuple(_channel(field, table.column(i)) for i, field in enumerate(table.schema))
    return Record(file, "parquet", channels, findings=findings)


def _is_read(kind: Any) -> bool:
    from pyarrow import types

    are_numbers = types.is_integer(kind) or types.is_floating(kind) or types.is_boolean(kind) or types.is_decimal(kind)
    return bool(are_numbers or types.is_timestamp(kind) or types.is_duration(kind))


def _channel(field: Any, column: Any) -> Channel:
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
    values = np.array([np.nan if v is None else float(v) for v in column.to_pylist()]) if column.null_count else column.to_numpy()
    return Channel(name, np.asarray(values, dtype=np.float64), own_unit or unit)
