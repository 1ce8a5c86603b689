"""The viewer in a notebook."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from functools import cache, partial
from hashlib import sha256
from html import escape
from importlib import import_module
from itertools import chain
from typing import Any
from uuid import uuid4

import numpy as np

from contourlab.app.session import Answer
from contourlab.errors import ParameterError, check_known, refuse
from contourlab.extras import extra_module
from contourlab.features.run.report import Results, data_of
from contourlab.feed import Reference
from contourlab.loop.batch import BatchResult
from contourlab.program import Program
from contourlab.rendering.charts import Picture, traces_chart
from contourlab.rendering.html import packed_viewer, picture_groups, template_file
from contourlab.rendering.message import message
from contourlab.result import Result, Signal

MOST_SAMPLES = 1_000_000
"""Longest reference that is shown."""
COORDINATES = "xyzabcuvw"


def show(
    what: Answer | Results | Reference | BatchResult,
    *keys: str,
    reference: Reference | None = None,
    tolerance: float | None = None,
    program: Program | None = None,
) -> Any:
    """Show the viewer of reports in a notebook, without a network; needs the extra ``notebook``.

    Parameters
    ----------
    what : answer, Result, sequence of Result, mapping of str to Result, Reference or BatchResult
        What a question answers, such as `run`, `measure`, `circle` or `sweep`; runs along one path, as `report` takes them; a motion, shown
        as a machine without error makes it; or a study of variants.
    *keys : str
        Which pictures; by default all, the first two open.
    reference : Reference, optional
        Of results that do not know their own.
    tolerance : float [m], > 0 and < 1, optional
        Largest part error that passes, for results.
    program : Program, optional
        The part program of results, for the line of each place.

    Returns
    -------
    anywidget.AnyWidget
        It shows itself as the last value of a cell, or with IPython's ``display``.

    Raises
    ------
    MissingPackageError
        If anywidget is not installed.
    ParameterError
        If there is nothing that the viewer draws, or no picture of a key; or as `report` raises it.
    ResultError
        As `report` raises it.

    Notes
    -----
    A saved notebook keeps tables and a still picture: they show where no kernel runs, and in files that nbconvert writes.
    """
    widget, pictures = _widget(), {picture.key: picture for picture in pictures_of(what, reference, tolerance, program)}
    for key in keys:
        check_known("keys", key, pictures)
    return widget(message=message(pictures[key] for key in keys or pictures), still=_still(what))


def pictures_of(
    what: object, reference: Reference | None = None, tolerance: float | None = None, program: Program | None = None
) -> list[Picture]:
    """Return all pictures that the viewer draws of an object; parameters and errors as in `show`."""
    if isinstance(what, Answer):
        pictures = list(what._pictures())
    elif isinstance(what, BatchResult):
        pictures = _study_charts(what)
    else:
        results: Any = _followed(what) if isinstance(what, Reference) else what
        known = isinstance(results, Result | Sequence | Mapping)
        refuse(not known, ParameterError, "what", type(what).__name__, "an answer, runs, a motion or a study")
        pictures = list(chain.from_iterable(picture_groups(data_of(results, reference, tolerance, program)).values()))
    refuse(not pictures, ParameterError, "what", type(what).__name__, "something with pictures in the viewer; see its plot()")
    return pictures


def _followed(reference: Reference) -> Result:
    """Return the run of a machine that follows a reference without an error."""
    fits = reference.n_sample <= MOST_SAMPLES
    refuse(not fits, ParameterError, "what", f"a reference of {reference.n_sample} samples", f"of at most {MOST_SAMPLES}; see its plot()")
    block = reference.block(0, reference.n_sample)
    axes = ("sample", "axis")
    signals = {name: Signal(block.position, axes, "m") for name in ("reference", "tool_position", "axis_position")}
    signals |= {"reference_velocity": Signal(block.velocity, axes, "m/s"), "feedrate": Signal(block.feedrate, axes[:1], "m/s")}
    signals |= {"reference_acceleration": Signal(block.acceleration, axes, "m/s^2"), "arc_length": Signal(block.arc_length, axes[:1], "m")}
    return Result("planned motion", tuple(COORDINATES[: reference.n_axis]), reference.servo_period, signals, motion=reference)


def _study_charts(batch: BatchResult) -> list[Picture]:
    """Return the share of variants up to each value of an error, and the errors over each parameter."""
    errors = [name for name in batch.figures if name.endswith(("error_max", "error_rms"))]
    values = {name.replace("_", " "): 1e6 * batch.figures[name] for name in errors}
    ended = {name: np.sort(some[np.isfinite(some)]) for name, some in values.items()}
    below = {name: (some, 100.0 * np.arange(1, some.size + 1) / len(batch.failed_at)) for name, some in ended.items()}
    caption = f"Share of {len(batch.failed_at)} variants with at most this error; {np.count_nonzero(batch.failed_at >= 0)} failed."
    charts: list[Picture] = [
        traces_chart("distribution", "Distribution of the errors", ("error [um]", "up to here [%]"), below, caption=caption)
    ]
    for name, varied in batch.variants.items():
        unit = f" [{batch.units[name]}]" if batch.units[name] else ""
        points = {error: (varied, some, np.zeros(some.size)) for error, some in values.items()}
        charts.append(traces_chart(name, f"Errors over {name}", (name + unit, "error [um]"), points, level=None))
    return charts


def _still(what: Any) -> str:
    """Return tables and a picture for a notebook without a kernel."""
    from contourlab.rendering.matplotlib_view import drawing, picture_bytes

    shown = [what] if hasattr(what, "_repr_html_") else what.values() if hasattr(what, "values") else what
    text = "".join(each._repr_html_() for each in shown)
    chart = next(iter(what._charts()), None) if isinstance(what, Answer) else None
    if chart is None:
        return text
    (png,) = picture_bytes(partial(drawing, chart), "png")
    return f'{text}<img alt="{escape(chart.title)}" width="720" src="data:image/png;base64,{b64encode(png).decode()}">'


@cache
def _widget() -> Any:
    """Return the class of the widget."""
    base: Any = extra_module("anywidget").AnyWidget
    display: Any = import_module("IPython.display").display
    import traitlets

    class Viewer(base):  # type: ignore[misc]
        _esm = template_file("widget.js").replace("DIGEST", sha256(packed_viewer()).hexdigest())
        viewer = traitlets.Bytes(packed_viewer()).tag(sync=True)
        message = traitlets.Bytes().tag(sync=True)
        name = traitlets.Unicode().tag(sync=True)

        def __init__(self, message: bytes, still: str) -> None:
            self._still = still
            super().__init__(message=message, name=f"contourlab-{uuid4().hex}")

        def _ipython_display_(self) -> None:
            """Show a still picture, which the viewer hides when it draws, and the viewer."""
            display({"text/html": f'<div class="{self.name}">{self._still}</div>', "text/plain": ""}, raw=True)
            display({**self._repr_mimebundle_()[0], "text/plain": ""}, raw=True)

    return Viewer
