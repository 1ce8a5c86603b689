"""Read MATLAB files, versions 4 to 7.3: variables, structures, and captures of ControlDesk."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, refuse
from contourlab.logs.reading import COLUMNS, NUMBERS, Channel, Record, check_limit, name_and_unit

HDF = b"\x89HDF\r\n\x1a\n"
SHORTEST = 2
"""Least numbers of a channel; a single one is a constant."""


def matches(file: Path, head: bytes) -> bool:
    """Tell by the first bytes, or by the suffix."""
    return head.startswith(b"MATLAB ") or (file.suffix.lower() == ".mat" and not head.startswith(b"PAR1"))


def read(file: Path) -> Record:
    """Read a MATLAB file.

    A variable of numbers is a channel, a single number a constant. Fields of a structure are ``output.CH1in``; the name of a single
    structure is left out. Columns of a matrix are numbered. A capture has times in a field X, and fields Y with name, data and unit.

    Raises
    ------
    LogError
        If it cannot be read, or holds no numbers.
    """
    with file.open("rb") as stream:
        # Version 7.3 has MATLAB's own text before the HDF5 signature.
        head = stream.read(520)
    if HDF in (head[:8], head[512:520]):
        tree = _HdfTree(file).read()
    else:
        from scipy.io import loadmat

        tree = {name: _plain(value) for name, value in loadmat(file, squeeze_me=True, struct_as_record=False).items()}
    tree = {name: value for name, value in tree.items() if not name.startswith(("__", "#"))}
    while len(tree) == 1 and isinstance(inner := next(iter(tree.values())), Mapping):
        tree = dict(inner)
    period = None
    if isinstance(tree.get("X"), Mapping) and "Data" in tree["X"] and isinstance(tree.get("Y"), list | Mapping):
        try:
            channels, period = _capture(tree)
            constants: dict[str, float] = {}
        except (AttributeError, KeyError, TypeError, ValueError) as error:
            raise LogError(f"looks like a capture (X and Y), but a part of it is missing or wrong: {error}", file=file) from error
    else:
        columns = []
        for column in _leaves(tree, ""):
            columns.append(column)
            check_limit(len(columns), COLUMNS, "columns", file)
        named = [(*name_and_unit(name), value) for name, value in columns if value.size >= SHORTEST]
        channels = [Channel(name, value, unit) for name, unit, value in named]
        constants = {name: float(value[0]) for name, value in columns if value.size == 1}
    refuse(not channels, LogError, "contains no columns of numbers", file=file)
    return Record(file, "matlab", tuple(channels), period, constants)


def _plain(value: Any) -> Any:
    """Return structures as mappings, arrays of structures as lists of them."""
    if hasattr(value, "_fieldnames"):
        return {name: _plain(getattr(value, name)) for name in value._fieldnames}
    if isinstance(value, np.ndarray) and value.dtype == object:
        return [_plain(item) for item in value.ravel()]
    return value


class _HdfTree:
    """Items of version 7.3: groups are structures, references lead to items, text is stored as numbers."""

    def __init__(self, file: Path) -> None:
        self.file, self.count = file, 0

    def read(self) -> dict[str, Any]:
        """Return the items of the file."""
        import h5py

        with h5py.File(self.file, "r") as stored:
            return self.fields(stored)

    def fields(self, group: Any) -> dict[str, Any]:
        """Return the items of a group; links to other files and broken links are left out."""
        import h5py

        links = {name: group.get(name, getlink=True) for name in group if not name.startswith("#")}
        # An item that cannot be opened is damaged; a soft link may lead nowhere.
        own = {name: link for name, link in links.items() if not isinstance(link, h5py.ExternalLink)}
        items = {name: group[name] if isinstance(link, h5py.HardLink) else group.get(name) for name, link in own.items()}
        return {name: self.plain(item) for name, item in items.items() if isinstance(item, h5py.Group | h5py.Dataset)}

    def plain(self, item: Any) -> Any:
        import h5py

        if isinstance(item, h5py.Group):
            fields = self.fields(item)
            lists = [value for value in fields.values() if isinstance(value, list)]
            # An array of structures is a structure of arrays of references.
            if fields and len(lists) == len(fields) and len({len(value) for value in lists}) == 1:
                return [dict(zip(fields, values, strict=True)) for values in zip(*lists, strict=True)]
            return fields
        if item.attrs.get("MATLAB_empty", 0) or item.external or item.is_virtual or item.shape is None:
            return np.empty(0)  # numbers in other files are not read
        self.count += item.size
        check_limit(self.count, NUMBERS, "numbers", self.file)
        if item.dtype == h5py.ref_dtype:
            return [self.plain(item.file[reference]) if reference else np.empty(0) for reference in np.ravel(item[()])]
        if item.dtype.kind not in "biuf":
            return np.empty(0)
        if item.attrs.get("MATLAB_class", b"") == b"char":
            return "".join(chr(code) for code in np.ravel(item[()]))
        # MATLAB stores columns first.
        return np.squeeze(item[()].T)


def _capture(tree: Mapping[str, Any]) -> tuple[list[Channel], float | None]:
    time = _numbers(tree["X"]["Data"])
    channels = []
    for row in tree["Y"] if isinstance(tree["Y"], list) else [tree["Y"]]:
        # "Model Root"/"Encoder Feedback X"/"x [mm]" becomes Encoder Feedback X/x [mm].
        parts = [part.strip('" ') for part in str(row.get("Name", "")).split('"/"')]
        name, unit = name_and_unit("/".join(part for part in parts if part and part != "Model Root"))
        own = row.get("Unit")
        channels.append(Channel(name, _numbers(row["Data"]), own if isinstance(own, str) and own else unit, time))
    period = tree.get("Capture", {}).get("SamplingPeriod") if isinstance(tree.get("Capture"), Mapping) else None
    return channels, float(period) if period is not None and np.size(period) == 1 and float(period) > 0.0 else None


def _leaves(tree: Any, name: str) -> Iterator[tuple[str, Array]]:
    """Yield the columns of numbers with their full names."""
    if isinstance(tree, Mapping):
        for key, value in tree.items():
            yield from _leaves(value, f"{name}.{key}" if name else key)
    elif isinstance(tree, list):
        for i, value in enumerate(tree):
            yield from _leaves(value, f"{name}.{i + 1}")
    elif isinstance(tree, str | bytes):
        return
    else:
        values = np.asarray(tree)
        if not (np.issubdtype(values.dtype, np.number) or values.dtype == bool) or np.iscomplexobj(values):
            return
        if values.ndim <= 1 or 1 in values.shape:
            yield name, _numbers(values)
        elif values.ndim == 2:
            columns = values.T if values.shape[0] >= values.shape[1] else values
            yield from ((f"{name}.{i + 1}", _numbers(column)) for i, column in enumerate(columns))


def _numbers(values: Any) -> Array:
    return np.asarray(values, dtype=np.float64).ravel()
