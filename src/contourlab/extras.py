"""Packages of extras: imported on demand, with a clear error if missing."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from contourlab.errors import MissingPackageError

EXTRAS = {
    "cvxpy": "design", "ezdxf": "cad", "svgelements": "cad", "pyarrow": "parquet", "pyarrow.parquet": "parquet", "pyarrow.csv": "parquet",
    "pyarrow.dataset": "parquet", "pyarrow.compute": "parquet",
    "duckdb": "sweep", "optuna": "optimise", "cmaes": "optimise", "dask": "cluster", "distributed": "cluster", "dask_jobqueue": "cluster",
    "cryptography": "cluster", "anywidget": "notebook", "control": "control",
}  # fmt: skip
"""The extra that installs each module."""


def extra_module(name: str) -> Any:
    """Import a module of an extra.

    Raises
    ------
    MissingPackageError
        If it is not installed.
    """
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        raise MissingPackageError(name.partition(".")[0].replace("_", "-"), EXTRAS[name]) from error
