"""Compute a value once for all processes of a test run."""

from __future__ import annotations

import pickle
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

PATIENCE = 1200.0
"""Seconds after which a process that waits for another one gives up."""


def once(factory: pytest.TempPathFactory, worker: str, name: str, make: Callable[[], Any]) -> Any:
    """Return the result of `make`: the first process computes and pickles it, the others read it.

    Parameters
    ----------
    factory : pytest.TempPathFactory
    worker : str
        Name of this process, ``"master"`` if it is the only one.
    name : str
        Name of the value.
    make : callable
    """
    base = factory.getbasetemp()
    folder = base if worker == "master" else base.parent
    result, claim = folder / f"{name}.pickle", folder / f"{name}.claimed"
    try:
        claim.mkdir()
    except FileExistsError:
        return _awaited(result)
    try:
        record: dict[str, Any] = {"made": make()}
    except BaseException as error:
        record = {"failed": f"{type(error).__name__}: {error}"}
        raise
    finally:
        part = result.with_suffix(".part")
        part.write_bytes(pickle.dumps(record))
        part.replace(result)
    return record["made"]


def _awaited(result: Path) -> Any:
    end = time.monotonic() + PATIENCE
    while not result.is_file():
        if time.monotonic() > end:
            pytest.fail(f"{result.name} was not made by another process within {PATIENCE:g} s")
        time.sleep(0.2)
    record = pickle.loads(result.read_bytes())
    if "failed" in record:
        pytest.fail(f"{result.name} failed in another process: {record['failed']}")
    return record["made"]
