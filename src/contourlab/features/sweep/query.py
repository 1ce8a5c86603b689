"""Questions to a store: what it holds, SQL, worst variants, export, and the rows that answers are about."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from functools import cached_property
from itertools import chain
from pathlib import Path
from sys import getsizeof
from threading import TIMEOUT_MAX, Timer
from typing import Any

import numpy as np

from contourlab.app.options import positive
from contourlab.app.session import Answer
from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError, check_known, error_text, refuse
from contourlab.extras import extra_module
from contourlab.features.sweep.store import SCHEMA, Store
from contourlab.features.sweep.vary import belongs, heads_of
from contourlab.figures import FACTORS, number, shown_unit
from contourlab.findings import Finding, finding
from contourlab.metrics.run_figures import FORMS
from contourlab.rendering.table import Column, Table
from contourlab.result.atomic import replacing
from contourlab.result.stamp import stamp
from contourlab.study.statistics import share_of, wilson

QUANTILES = {"minimum": 0.0, "p5": 0.05, "median": 0.5, "p95": 0.95, "p99": 0.99, "maximum": 1.0}
PIECE = 4096
"""Rows between two looks at the memory of a query."""
JUDGED = "part_error_max"
"""The figure that a tolerance bounds, as in ``contourlab run``."""


@dataclass(frozen=True)
class Spread:
    """The distribution of a figure over the variants that ended.

    Attributes
    ----------
    unit : str
        SI unit of the figure.
    mean, minimum, p5, median, p95, p99, maximum : float or None [unit]
        None without a variant that ended.
    """

    unit: str
    mean: float | None
    minimum: float | None
    p5: float | None
    median: float | None
    p95: float | None
    p99: float | None
    maximum: float | None


@dataclass(frozen=True)
class Yield:
    """The share of variants within the tolerance.

    Attributes
    ----------
    figure : str
    tolerance : float [m]
    passed, judged : int
        A variant that diverged is judged, and fails. A refused one is not judged.
    share, low, high : float
        Share, and its Wilson interval of 95 %; of variants that share modules or draws with their `effective_size`.
    """

    figure: str
    tolerance: float
    passed: int
    judged: int
    share: float
    low: float
    high: float


@contextmanager
def connected(store: Store, memory: float = math.inf) -> Iterator[Any]:
    """Yield a DuckDB connection with the view ``results``, which can read nothing else and write nothing; `memory` is its limit [B]."""
    duckdb = extra_module("duckdb")
    options = {"enable_external_access": "false", "python_enable_replacements": "false", "temp_directory": ""}
    options |= {"memory_limit": f"{max(memory, 1.0):.0f}B"} if math.isfinite(memory) else {}
    with duckdb.connect(":memory:", config=options) as connection:
        connection.register("results", store.dataset)
        connection.execute("SET lock_configuration = true")
        yield connection


def rows(store: Store, sql: str, memory: str = "", time: str = "") -> tuple[list[str], list[tuple[Any, ...]]]:
    """Return the names of the columns and the rows of a query over ``results``.

    Parameters
    ----------
    store : Store
    sql : str
    memory, time : str
        Most memory, of DuckDB and of the rows each, and longest time, such as ``"2 GB"`` and ``"60 s"``; empty for no limit.

    Raises
    ------
    ParameterError
        If the query fails, or takes more; names the option.
    """
    duckdb, found, held = extra_module("duckdb"), list[tuple[Any, ...]](), 0
    most = _limit("--memory", memory, "byte", "2 GB") / 8.0  # SI counts bits
    longest = min(_limit("--time", time, "s", "60 s"), TIMEOUT_MAX)
    limits = (("--memory", memory, "8 GB"), ("--time", time, "10 min"))
    large, slow = (ParameterError(name, text, f"more for this query, such as {example!r}") for name, text, example in limits)
    with connected(store, most) as connection:
        timer = Timer(longest, connection.interrupt)
        timer.start()
        try:
            answer = connection.execute(sql)
            while some := answer.fetchmany(PIECE):
                found += some
                held += sum(map(getsizeof, chain(some, chain.from_iterable(some)))) if memory else 0
                if held > most:
                    raise large
                if timer.finished.is_set():  # between two pieces there is nothing to interrupt
                    raise slow
        except duckdb.InterruptException as error:
            raise slow from error
        except duckdb.OutOfMemoryException as error:
            raise large from error
        except duckdb.Error as error:
            raise ParameterError("query", repr(sql), f"SQL over the view results: {error_text(error)}") from error
        finally:
            timer.cancel()
        return [column[0] for column in answer.description or ()], found


def _limit(option: str, text: str, unit: str, example: str) -> float:
    return positive(option, text, unit, f"more than 0, such as {example!r}") if text else math.inf


def spreads(store: Store) -> dict[str, Spread]:
    """Return the distribution of each figure; equal rows give equal bits, which sums of DuckDB's threads do not."""
    figures = {}
    for name, unit in store.manifest.figures.items():
        values = np.sort(store.dataset.to_table(columns=[name])[name].drop_null().to_numpy())
        places = np.quantile(values, [*QUANTILES.values()]).tolist() if len(values) else [None] * len(QUANTILES)
        figures[name] = Spread(unit, float(values.mean()) if len(values) else None, **dict(zip(QUANTILES, places, strict=True)))
    return figures


def counts(store: Store) -> dict[str, int]:
    """Return the number of variants of each status, and ``unsure``."""
    sql = "SELECT status, count(*), count(*) FILTER (unsure > 0 AND status = 'ok') FROM results GROUP BY status ORDER BY status"
    found = rows(store, sql)[1]
    return {status: count for status, count, _ in found} | {"unsure": sum(unsure for *_, unsure in found)}


def yield_of(store: Store) -> Yield | None:
    """Return the share of variants within the tolerance; None without a tolerance or its figure, and of a search."""
    tolerance = store.tolerance
    if tolerance is None or JUDGED not in store.manifest.figures:
        return None
    rows = _judged(store, JUDGED, ["variant", *store.manifest.modules, JUDGED])
    if not rows.table.num_rows:
        return Yield(JUDGED, tolerance, 0, 0, math.nan, *wilson(0, 0))
    passed, *share = share_of(rows.values <= tolerance, rows.clusters)
    return Yield(JUDGED, tolerance, passed, len(rows.values), *share)


def records(store: Store, which: str) -> list[dict[str, Any]]:
    """Return whole rows of ``results``, each by column; `which` is the end of the query."""
    names, found = rows(store, f"SELECT * FROM results {which}")
    return [dict(zip(names, row, strict=True)) for row in found]


def quoted(name: str) -> str:
    """Return a name of a column as SQL writes it."""
    return '"' + name.replace('"', '""') + '"'


@dataclass(frozen=True)
class Export(Answer):
    """A file of rows.

    Attributes
    ----------
    file : Path
    done, variants : int
        Rows of the file, and variants of the study.
    """

    file: Path
    done: int
    variants: int

    @property
    def text(self) -> str:
        """Text for the terminal."""
        return f"{self.file}: {self.done} of {self.variants} variants"


def export(store: Store, file: Path) -> Export:
    """Write one row per variant, in their order, as CSV or Parquet; the same results give the same bytes.

    Raises
    ------
    ParameterError
        If the name of the file ends in neither.
    OutputError
        If it cannot be written.
    """
    parquet, csv, arrow = (extra_module(name) for name in ("pyarrow.parquet", "pyarrow.csv", "pyarrow"))
    suffix = file.suffix.lower()
    refuse(suffix not in (".csv", ".parquet"), ParameterError, "--to", repr(str(file)), "a file that ends in .csv or .parquet")
    schema, is_csv = store.schema, suffix == ".csv"
    if is_csv:
        schema = arrow.schema([field.with_name(head) for field, head in zip(schema, heads_of(schema), strict=True)])
    schema = schema.with_metadata({"made_by": stamp(**{key: store.manifest.identity[key][:16] for key in ("scenario", "study")})})

    def opened(path: Path) -> Any:
        return csv.CSVWriter(str(path), schema) if is_csv else parquet.ParquetWriter(path, schema, compression="zstd")

    with replacing(file) as temporary, opened(temporary) as writer:
        for number in sorted(store.parts):
            writer.write_table(parquet.read_table(store.parts[number], schema=store.schema).rename_columns(schema.names))
    return Export(file, store.done, store.manifest.variants)


@dataclass(frozen=True, eq=False)
class Rows:
    """The judged rows of a store.

    Attributes
    ----------
    store : Store
    figure : str
    table : pyarrow.Table
        Without refused variants.
    """

    store: Store
    figure: str
    table: Any = field(repr=False)

    @cached_property
    def values(self) -> Array:
        """The figure (n,); inf for a variant that diverged."""
        found, _ = self.column(self.figure)
        return np.where(np.isnan(found), np.inf, found)

    @property
    def tolerance(self) -> float | None:
        """Tolerance [m] of the figure, if it has one and the store has a yield."""
        return self.store.tolerance if self.figure == JUDGED else None

    @cached_property
    def members(self) -> dict[str, Index]:
        """For each kind of modules, by its column, which one is in each row (n,), counted from 0 without gaps."""
        return {name: np.unique(self.table[name].to_numpy(), return_inverse=True)[1] for name in self.store.manifest.modules}

    @cached_property
    def clusters(self) -> list[Index]:
        """Which rows share a module or a draw, for each kind of modules (n,); empty if all rows are independent."""
        group = self.store.manifest.group
        shared = [np.unique(self.table["variant"].to_numpy() // group, return_inverse=True)[1]] if group > 1 else []
        return [*self.members.values(), *shared]

    def share_of_variance(self, chosen: Flags) -> float:
        """Return the share of the variance of what ended that lies within some rows."""
        ended = np.isfinite(self.values)
        whole, part = self.values[ended], self.values[ended & chosen]
        if len(part) in (0, len(whole)):
            return float(len(part) > 0)
        total = len(whole) * float(np.var(whole))
        return min(len(part) * float(np.var(part)) / total, 1.0) if total else 0.0

    def kind(self, name: str) -> str | None:
        """Return the column of the modules that a column belongs to."""
        return next((kind for kind in self.store.manifest.modules if belongs(name, kind.removesuffix(".module"))), None)

    def where(self, chosen: Flags) -> Rows:
        """Return some of the rows."""
        return Rows(self.store, self.figure, self.table.filter(chosen))

    def first(self, shared: str) -> str:
        """Return the first column that an effect or subset is about."""
        columns = self.store.manifest.columns
        return next(name for name in columns if name == shared or fnmatchcase(name, shared) or name in shared.split(", "))

    def column(self, name: str) -> tuple[Array, list[str]]:
        """Return a column (n,), nan where it is empty; of texts, their places in the list that comes with it."""
        column = self.table[name]
        if name in self._texts:
            coded = column.dictionary_encode().unify_dictionaries().combine_chunks()
            return coded.indices.to_numpy(zero_copy_only=False).astype(float), list(map(str, coded.dictionary.to_pylist()))
        return column.to_numpy().astype(float, copy=False), []

    @cached_property
    def _texts(self) -> set[str]:
        text = extra_module("pyarrow").string()
        return {name for name in self.store.manifest.columns if self.store.schema.field(name).type == text}


def read_rows(store: Store, figure: str | None = None) -> Rows:
    """Read the columns of a store that the answers need.

    Parameters
    ----------
    store : Store
    figure : str, optional
        By default the largest part error, or else the first figure.

    Raises
    ------
    ParameterError
        If the store has no such figure, or no variant that was judged.
    """
    chosen = figure or (JUDGED if JUDGED in store.manifest.figures else next(iter(store.manifest.figures)))
    check_known("--figure", chosen, store.manifest.figures)
    about = store.manifest
    rows = _judged(store, chosen, ["variant", *about.modules, *about.columns, *dict.fromkeys([chosen, *objectives(store)])])
    refuse(not rows.table.num_rows, ParameterError, "STORE", str(store.home), "a store with variants that were judged")
    return rows


def _judged(store: Store, figure: str, names: Sequence[str]) -> Rows:
    """Return some columns of the rows that were not refused."""
    table = store.dataset.to_table(columns=[*names, "status"])
    chosen = extra_module("pyarrow.compute").not_equal(table["status"], "refused")
    return Rows(store, figure, table.filter(chosen).drop_columns("status"))


def objectives(store: Store) -> list[str]:
    """Return the figures that a compromise weighs against the main one."""
    return [name for name in ("cycle_time", "command_energy") if name in store.manifest.figures]


def remarks(store: Store, statuses: Mapping[str, int]) -> tuple[Finding, ...]:
    """Return what to know about the variants of a store: missing, refused, unsure."""
    about, refused, unsure = store.manifest, statuses.get("refused", 0), statuses.get("unsure", 0)
    known = (
        (about.schema != SCHEMA, "CL935", {"store": str(store.home)}),
        (store.done < about.variants, "CL931", {"done": store.done, "variants": about.variants}),
        (refused > 0, "CL932", {"count": refused}),
        (unsure > 0, "CL933", {"count": unsure}),
    )
    return tuple(finding(code, **values) for holds, code, values in known if holds)


def display(unit: str) -> tuple[str, float]:
    """Return the display unit of values in an SI unit, and the factor."""
    if unit in ("m", "m s"):  # errors, as elsewhere
        return FORMS[unit][0], FACTORS[FORMS[unit][0]]
    factor, shown = shown_unit(unit)
    return shown, factor


def rows_text(names: Sequence[str], rows: Sequence[Sequence[Any]], units: Mapping[str, str]) -> str:
    """Return rows of a query as a table; columns with a unit in its display unit."""
    shown = [display(units[name]) if name in units else ("", 1.0) for name in names]
    heads = [f"{name} [{unit}]" if unit else name for name, (unit, _) in zip(names, shown, strict=True)]
    texts = [any(isinstance(row[i], str) for row in rows) for i in range(len(names))]
    cells = ([_cell(value, factor) for value, (_, factor) in zip(row, shown, strict=True)] for row in rows)
    return Table([*map(Column, heads, texts)], rows=cells).text()


def _cell(value: Any, factor: float) -> str:
    return "-" if value is None else number(value * factor, 5) if isinstance(value, float) else str(value)
