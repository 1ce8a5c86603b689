"""Read contours from DXF drawings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path as File
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.contours.drawing import ConicShape, Drawing, LeftOut, LineShape, Shape, SplineShape, drawing_of, strand_of, unit_size
from contourlab.errors import ContourlabError, GeometryError, refuse
from contourlab.extras import extra_module

FLAT = 1e-9
"""Largest difference of heights [m] in one plane."""
UNITS = {
    1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 1e-3, 5: 1e-2, 6: 1.0, 7: 1e3, 8: 2.54e-8, 9: 2.54e-5, 10: 0.9144, 11: 1e-10, 12: 1e-9, 13: 1e-6,
    14: 0.1, 15: 10.0, 16: 100.0, 21: 1200.0 / 3937.0,
}  # fmt: skip
"""Size [m] of the units that ``$INSUNITS`` numbers."""
SPLINE_FRAME = 16
"""Flag of a vertex that is a control point, not a point, of a fitted polyline."""


def read_dxf(
    file: str | File,
    *,
    unit: str | None = None,
    tolerance: float | None = None,
    layer: str | None = None,
    scale: float = 1.0,
    axes: int = 2,
) -> Drawing:
    """Read the contours in the model space of a DXF drawing, blocks resolved.

    Parameters
    ----------
    unit : str, optional
        Unit of the numbers in the file; by default ``$INSUNITS``.
    tolerance : float [m], > 0
        Largest gap between ends that meet, 1 um by default.
    layer : str, optional
        The only layer to read; case-insensitive.
    scale : float, > 0
        Factor on all coordinates.
    axes : {2, 3}
        x and y, or x, y and z.

    Returns
    -------
    Drawing
        LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and POLYLINE as analytic curves; others in `left_out`.

    Raises
    ------
    GeometryError
        If the file cannot be read, states no unit, lacks the layer, or is not flat although `axes` is 2.
    UnitError
        If `unit` is not a unit of length.

    References
    ----------
    Autodesk, "DXF Reference", sections ENTITIES and HEADER.
    """
    path = File(file)
    document = _opened(path)
    size = _unit_of(document, path, unit) * scale
    entities = _Entities(path, layer.casefold() if layer is not None else None)
    try:
        entities.add(document.modelspace())
    except ContourlabError:
        raise
    except Exception as error:  # dangling references
        raise _damaged(path, error) from error
    if layer is not None and entities.layer not in {name.casefold() for name in entities.layers}:
        raise GeometryError(f"{path}: layer {layer!r} is missing or empty; the layers are {', '.join(entities.layers) or 'all empty'}")
    matrix = size * np.eye(3)[:axes]
    if axes == 2:
        _check_flat(path, entities.shapes, size)
    strands = [
        strand_of([shape.mapped(matrix, np.zeros(axes)) for shape in shapes], path, what, on) for shapes, what, on in entities.shapes
    ]
    return drawing_of(path, strands, tolerance, entities.left_out, entities.notes, tuple(entities.layers))


def _opened(path: File) -> Any:
    ezdxf = extra_module("ezdxf")
    try:
        document = ezdxf.readfile(path)
        with path.open("rb") as stream:
            stream.seek(max(0, path.stat().st_size - 64))
            end = stream.read()
    except OSError as error:
        # ezdxf raises an OSError for other kinds of files too.
        raise GeometryError(f"{path}: cannot be read: {error.strerror or 'it is not a DXF drawing'}") from error
    except Exception as error:  # ezdxf may raise anything for a damaged file
        raise _damaged(path, error) from error
    if not end.rstrip(b"\x00\x1a \t\r\n").endswith(b"EOF"):
        # A file truncated between two entities can be read, but is incomplete.
        raise GeometryError(f"{path}: is truncated (no EOF): export it again")
    return document


def _damaged(path: File, error: Exception) -> GeometryError:
    why = str(error).strip() or "it is truncated or inconsistent"
    return GeometryError(f"{path}: is damaged or not a DXF drawing ({why}): export it again")


def _unit_of(document: Any, path: File, unit: str | None) -> float:
    if unit is not None:
        return unit_size(unit)
    code = document.header.get("$INSUNITS", 0)
    if code not in UNITS:
        unit_stated = "no unit" if code == 0 else f"an unsuitable unit ($INSUNITS = {code})"
        raise GeometryError(f'{path}: has {unit_stated}: write unit = "mm", or the unit of its numbers')
    return UNITS[code]


def _check_flat(path: File, entities: list[tuple[list[Shape], str, str]], size: float) -> None:
    heights = [size * float(bound[2]) for shapes, _, _ in entities for shape in shapes for bound in shape.extent()]
    low, high = min(heights, default=0.0), max(heights, default=0.0)
    if high - low > FLAT:
        raise GeometryError(
            f"{path}: its z runs from {1e3 * low:.6g} to {1e3 * high:.6g} mm: write axes = 3 for a contour in space, or choose a flat layer"
        )


@dataclass
class _Entities:
    """Collects the shapes of entities, of all layers or one (case-folded)."""

    file: File
    layer: str | None
    shapes: list[tuple[list[Shape], str, str]] = field(default_factory=list)
    left_out: list[LeftOut] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    layers: dict[str, None] = field(default_factory=dict)

    def add(self, entities: Iterable[Any], inherited: str | None = None) -> None:
        """Add entities; those on layer 0 of a block are on the layer of the block reference."""
        for entity in entities:
            kind, layer = entity.dxftype(), entity.dxf.get("layer", "0")
            if layer == "0" and inherited is not None:
                layer = inherited
            if kind == "INSERT":
                self._add_block(entity, layer)
            elif self._is_chosen(layer):
                self._add_shapes(entity, kind, layer)

    def _is_chosen(self, layer: str) -> bool:
        self.layers[layer] = None
        return self.layer is None or layer.casefold() == self.layer

    def _add_block(self, insert: Any, layer: str) -> None:
        def skipped(entity: Any, reason: str) -> None:
            on = entity.dxf.get("layer", "0")
            if self._is_chosen(layer if on == "0" else on):
                self.left_out.append(LeftOut(entity.dxftype(), on, reason))

        for reference in insert.multi_insert() if insert.mcount > 1 else [insert]:
            self.add(reference.virtual_entities(skipped_entity_callback=skipped), layer)
        for attribute in insert.attribs:
            if self._is_chosen(attribute.dxf.get("layer", "0")):
                self.left_out.append(LeftOut("ATTRIB", attribute.dxf.get("layer", "0")))

    def _add_shapes(self, entity: Any, kind: str, layer: str) -> None:
        read = READERS.get(kind)
        if read is None or (kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)):
            self.left_out.append(LeftOut(kind, layer))
            return
        handle = entity.dxf.get("handle")
        what = f"{kind} #{handle}" if handle else f"{kind} of a block"
        try:
            shapes = read(entity)
            _check_finite(shapes)
        except (GeometryError, ValueError, TypeError, ArithmeticError) as error:
            raise GeometryError(f"{self.file}: {what} on layer {layer}: {error}") from error
        if shapes:
            self.shapes.append((shapes, what, layer))
        else:
            self.notes.append(f"{what}: left out, because it has no length")


# --- entities ------------------------------------------------------------------------------------------------------------------------


def _check_finite(shapes: Iterable[Shape]) -> None:
    for shape in shapes:
        angles = (shape.start, shape.end) if isinstance(shape, ConicShape) else ()
        if not all(np.isfinite(part).all() for part in (*shape.extent(), angles)):
            raise GeometryError("a coordinate or angle is not finite: correct the drawing")


def _point(vector: Any) -> Array:
    return np.array([vector.x, vector.y, vector.z])


def _axes(entity: Any) -> tuple[Array, Array, Array]:
    """Return the axes of the entity's coordinate system in world coordinates."""
    ocs = entity.ocs()
    return _point(ocs.ux), _point(ocs.uy), _point(ocs.uz)


def _line(entity: Any) -> list[Shape]:
    start, end = _point(entity.dxf.start), _point(entity.dxf.end)
    return [LineShape(start, end)] if np.any(start != end) else []


def _circle(entity: Any) -> list[Shape]:
    ux, uy, _ = _axes(entity)
    centre, radius = _point(entity.ocs().to_wcs(entity.dxf.center)), abs(entity.dxf.radius)
    refuse(not math.isfinite(radius), GeometryError, f"its radius, {radius:g}, is not finite: correct the drawing")
    start, sweep = 0.0, 2.0 * math.pi
    if entity.dxftype() == "ARC":
        start = math.radians(entity.dxf.start_angle)
        sweep = math.radians((entity.dxf.end_angle - entity.dxf.start_angle) % 360.0) or 2.0 * math.pi
    return [ConicShape(centre, radius * ux, radius * uy, start, start + sweep)] if radius != 0.0 else []


def _ellipse(entity: Any) -> list[Shape]:
    start, end = entity.dxf.start_param, entity.dxf.end_param
    sweep = (end - start) % (2.0 * math.pi)
    if sweep < 1e-9:  # a full turn, 0 to 2 pi, rounded
        sweep = 2.0 * math.pi
    return [ConicShape(_point(entity.dxf.center), _point(entity.dxf.major_axis), _point(entity.minor_axis), start, start + sweep)]


def _spline(entity: Any) -> list[Shape]:
    points = np.array(entity.control_points, dtype=float).reshape(-1, 3)
    if len(points):
        knots, weights = np.array(entity.knots, dtype=float), np.array(entity.weights, dtype=float)
        return [SplineShape(int(entity.dxf.degree), points, knots, weights if weights.size else None)]
    spline = entity.construction_tool()  # through its fit points
    points = np.array([(p.x, p.y, p.z) for p in spline.control_points])
    return [SplineShape(spline.degree, points, np.array(spline.knots()), None)]


def _lwpolyline(entity: Any) -> list[Shape]:
    rows = [(x, y, entity.dxf.get("elevation", 0.0), bulge) for x, y, bulge in entity.get_points("xyb")]
    return list(_through(rows, bool(entity.closed), np.array(_axes(entity))))


def _polyline(entity: Any) -> list[Shape]:
    flat = entity.is_2d_polyline
    level = entity.dxf.elevation.z if flat and entity.dxf.hasattr("elevation") else None
    rows = []
    for vertex in entity.vertices:
        if not vertex.dxf.get("flags", 0) & SPLINE_FRAME:
            place = vertex.dxf.location
            rows.append((place.x, place.y, place.z if level is None else level, vertex.dxf.get("bulge", 0.0) if flat else 0.0))
    return list(_through(rows, bool(entity.is_closed), np.array(_axes(entity)) if flat else np.eye(3)))


def _through(rows: list[tuple[float, float, float, float]], closed: bool, frame: Array) -> Iterator[Shape]:
    """Yield lines and arcs through vertices (x, y, z, bulge) in the entity's coordinates, whose axes are the rows of `frame`."""
    pairs = zip(rows, rows[1:] + rows[:1] if closed else rows[1:], strict=False)
    for (*first, bulge), (*second, _) in pairs:
        a, b = np.array(first) @ frame, np.array(second) @ frame
        chord = float(np.linalg.norm(b - a))
        if chord == 0.0:
            continue
        # A bulge is the tangent of a quarter of the arc's angle; nearly 0 means a line.
        if abs(bulge) <= 1e-11:
            yield LineShape(a, b)
            continue
        left = np.cross(frame[2], (b - a) / chord)
        centre = 0.5 * (a + b) + 0.25 * chord * (1.0 - bulge**2) / bulge * left
        yield ConicShape(centre, a - centre, np.cross(frame[2], a - centre), 0.0, 4.0 * math.atan(bulge))


READERS: dict[str, Callable[[Any], list[Shape]]] = {
    "LINE": _line,
    "ARC": _circle,
    "CIRCLE": _circle,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
    "LWPOLYLINE": _lwpolyline,
    "POLYLINE": _polyline,
}
