"""The rows of a store that answers are about."""

from __future__ import annotations

from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError
from contourlab.extras import extra_module
from contourlab.features.sweep.modules import belongs
from contourlab.features.sweep.query import JUDGED, check_figure
from contourlab.features.sweep.store import Store


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
        return {name: np.unique(self.table[name].to_numpy(), return_inverse=True)[1] for name in self.store.modules}

    @cached_property
    def clusters(self) -> list[Index]:
        """Which rows share a module or a draw, for each kind of modules (n,); empty if all rows are independent."""
        group = self.store.manifest["group"]
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
        return next((kind for kind in self.store.modules if belongs(name, kind.removesuffix(".module"))), None)

    def where(self, chosen: Flags) -> Rows:
        """Return some of the rows."""
        return Rows(self.store, self.figure, self.table.filter(chosen))

    def first(self, shared: str) -> str:
        """Return the first column that an effect or subset is about."""
        return next(name for name in self.store.columns if name == shared or fnmatchcase(name, shared) or name in shared.split(", "))

    def column(self, name: str) -> tuple[Array, list[str]]:
        """Return a column (n,), nan where it is empty; of texts, their places in the list that comes with it."""
        column = self.table[name]
        if name in self._texts:
            coded = column.dictionary_encode().unify_dictionaries().combine_chunks()
            return coded.indices.to_numpy(zero_copy_only=False).astype(float), list(map(str, coded.dictionary.to_pylist()))
        return column.to_numpy().astype(float, copy=False), []

    @cached_property
    def _texts(self) -> set[str]:
        arrow = extra_module("pyarrow")
        return {name for name in self.store.columns if self.table.schema.field(name).type == arrow.string()}


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
    compute = extra_module("pyarrow.compute")
    chosen = figure or (JUDGED if JUDGED in store.figures else next(iter(store.figures)))
    check_figure(store, chosen)
    names = ["variant", *store.modules, *store.columns, *dict.fromkeys([chosen, *objectives(store)]), "status"]
    table = store.dataset.to_table(columns=names)
    table = table.filter(compute.not_equal(table["status"], "refused")).drop_columns("status")
    if not table.num_rows:
        raise ParameterError("STORE", str(store.folder), "a store with variants that were judged")
    return Rows(store, chosen, table)


def objectives(store: Store) -> list[str]:
    """Return the figures that a compromise weighs against the main one."""
    return [name for name in ("cycle_time", "command_energy") if name in store.figures]
