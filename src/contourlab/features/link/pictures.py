"""What a network between base and axes costs: the contour error over what is varied of its links."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Chart, Curve, Level, Panel
from contourlab.report.style import scheme_style

Array = NDArray[np.float64]

_WORDS = {
    "message_period": ("message period [ms]", 1e3, "Messages less often"),
    "delay": ("delay each way [ms]", 1e3, "Messages later"),
    "jitter": ("jitter [ms]", 1e3, "Messages with jitter"),
    "loss": ("messages lost [%]", 100.0, "Messages lost"),
}


def link_chart(
    quantity: str, curves: Mapping[str, tuple[Array, Array]], levels: Mapping[str, float], what: str, scale: float, name: str = ""
) -> Chart:
    """Return the contour error over a quantity of the links, one curve a division.

    Parameters
    ----------
    quantity : str
        ``"message_period"``, ``"delay"``, ``"jitter"`` or ``"loss"``.
    curves : mapping of str to (ndarray (n,), ndarray (n,))
        Values and errors in SI; not a number where a run left its limits.
    levels : mapping of str to float
        Errors that are marked, with their texts.
    what : str
        Name of the error, with unit.
    scale : float
        From SI to that unit.
    name : str
        Of the scheme, put before the name of the picture.
    """
    label, factor, title = _WORDS[quantity]
    count = len(curves)
    drawn = tuple(
        Curve(values * factor, error * scale, text, *scheme_style(i, count)) for i, (text, (values, error)) in enumerate(curves.items())
    )
    marked = tuple(Level(value * scale, text) for text, value in levels.items())
    panel = Panel(label, what, drawn, marked, log_y=True)
    key = "-".join(filter(None, ("link", name, quantity.replace("_", "-"))))
    return Chart(
        key,
        title,
        "A curve that ends early: nothing held any more over its last values. Where chance plays a part, the worst of several runs.",
        (panel,),
    )
