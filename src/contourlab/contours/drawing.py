"""The contents of a drawing: its chains, the omitted entities, and the choice of one chain."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path as File

import numpy as np

from contourlab.contours.chains import Chain, Strand, chains_of
from contourlab.contours.shapes import Shape
from contourlab.errors import GeometryError, UnitError
from contourlab.units import to_si

TOLERANCE = 1e-6
"""Default largest gap [m] between ends that meet."""
OUTERMOST = 1e9
"""Larger coordinates [m] are mistakes."""
LISTED = 20


@dataclass(frozen=True)
class LeftOut:
    """An entity that is not part of any contour.

    Attributes
    ----------
    kind : str
        Name in the file: ``TEXT``.
    """

    kind: str
    layer: str = ""
    why: str = ""


@dataclass(frozen=True, eq=False)
class Drawing:
    """The contours of a drawing.

    Attributes
    ----------
    chains : tuple of Chain
        In the order of the file.
    left_out : tuple of LeftOut
        Entities without a contour, such as texts.
    notes : tuple of str
        Omitted duplicates and very short entities.
    layers : tuple of str
        Layers of all entities; empty if the format has none.
    """

    file: File
    chains: tuple[Chain, ...]
    left_out: tuple[LeftOut, ...] = ()
    notes: tuple[str, ...] = ()
    layers: tuple[str, ...] = ()

    def refuse_left_out(self, ignore: Sequence[str]) -> None:
        """Raise a GeometryError for entities without a contour, unless their kind is in `ignore`."""
        ignored = {kind.upper() for kind in ignore}
        counts = Counter((item.kind, item.layer, item.why) for item in self.left_out if item.kind.upper() not in ignored)
        if not counts:
            return
        listed = [
            f"{n} {kind}{f' on layer {layer}' if layer else ''}{f' ({why})' if why else ''}" for (kind, layer, why), n in counts.items()
        ]
        kinds = ", ".join(f'"{kind}"' for kind in dict.fromkeys(kind for kind, _, _ in counts))
        choice = "choose a layer without them, or " if self.layers else ""
        raise GeometryError(f"{self.file}: contains {_some(listed)}, which are not contours: {choice}write ignore = [{kinds}]")

    def chosen(self, chain: int | None = None) -> Chain:
        """Return the only chain, or the one with a number, counted from 1.

        Raises
        ------
        GeometryError
            If the number does not exist, or there are several chains and none is chosen; lists them.
        """
        if not self.chains:
            layers = f"; its layers are {', '.join(self.layers)}" if self.layers else ""
            notes = f"; notes: {_some(self.notes)}" if self.notes else ""
            raise GeometryError(f"{self.file}: contains no contour{layers}{notes}")
        if chain is None and len(self.chains) == 1:
            return self.chains[0]
        if chain is not None and 1 <= chain <= len(self.chains):
            return self.chains[chain - 1]
        if chain is not None:
            raise GeometryError(f"{self.file}: chain = {chain} does not exist: {self._listed()}")
        layer = ', layer = "..."' if len(self.layers) > 1 else ""
        raise GeometryError(f"{self.file}: {self._listed()}; write for example chain = 1{layer}, or a tolerance above the gaps")

    def _listed(self) -> str:
        rows = []
        for number, chain in enumerate(self.chains, 1):
            place = ", ".join(f"{1e3 * x:.6g}" for x in chain.start)
            layers = f", layer {' and '.join(chain.layers)}" if any(chain.layers) else ""
            kind = "closed" if chain.closed else "open"
            rows.append(f"{number}: {kind}, {1e3 * chain.length:.6g} mm long, from ({place}) mm{layers}")
        count = "there is 1 chain" if len(rows) == 1 else f"there are {len(rows)} separate chains"
        return f"{count}: {_some(rows)}"


def _some(rows: Sequence[str]) -> str:
    return "; ".join(rows[:LISTED]) + (f"; and {len(rows) - LISTED} more" if len(rows) > LISTED else "")


def strand_of(shapes: Iterable[Shape], file: File, what: str, layer: str = "") -> Strand:
    """Return the curves of an entity.

    Raises
    ------
    GeometryError
        If its data do not define curves, or reach too far; names the entity.
    """
    try:
        shapes = list(shapes)
        reach = max((float(np.abs(bound).max()) for shape in shapes for bound in shape.extent()), default=0.0)
        if not reach <= OUTERMOST:
            raise GeometryError(f"reaches {reach:.3g} m from the origin, more than {OUTERMOST:g} m: check the unit")
        return Strand(tuple(curve for shape in shapes for curve in shape.curves()), what, layer)
    except GeometryError as error:
        raise GeometryError(f"{file}: {what}{f' on layer {layer}' if layer else ''}: {error}") from error


def drawing_of(
    file: File,
    strands: Sequence[Strand],
    tolerance: float | None,
    left_out: Sequence[LeftOut],
    notes: Sequence[str],
    layers: Sequence[str] = (),
) -> Drawing:
    """Create a drawing from strands.

    Raises
    ------
    GeometryError
        If the tolerance is out of range.
    """
    gap = TOLERANCE if tolerance is None else tolerance
    if not (0.0 < gap < math.inf):
        raise GeometryError(f"tolerance = {tolerance!r} m: must be > 0 and finite")
    chains, dropped = chains_of(strands, gap)
    return Drawing(file, tuple(chains), tuple(left_out), (*notes, *dropped), tuple(layers))


def unit_size(unit: str) -> float:
    """Return the size of a unit of length [m].

    Raises
    ------
    UnitError
        If it is not a unit of length.

    >>> unit_size("inch")
    0.0254
    """
    size = 0.0
    if re.fullmatch(r"[A-Za-zµμ_]{1,30}", unit):
        try:
            size = to_si(f"1 {unit}", "m")
        except UnitError as error:
            raise UnitError(f'unit = "{unit}": {error}') from error
        except Exception:  # the unit parser may raise anything
            size = 0.0
    if not (size > 0.0 and math.isfinite(size)):
        raise UnitError(f'{unit!r} is not a unit of length: write for example "mm" or "inch"')
    return size
