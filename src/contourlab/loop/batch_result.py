"""The figures of many variants."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError
from contourlab.figures import number
from contourlab.metrics.run_figures import FIGURES
from contourlab.notebook import Figure, Frame, curves, facts_line, facts_table, frame, grid, svg


@dataclass(frozen=True, repr=False)
class BatchResult:
    """Figures of each variant, arrays (n_variant,).

    Attributes
    ----------
    figures : mapping of str to ndarray (n_variant,)
        ``contour_error_rms``, ``contour_error_mean``, ``contour_error_max`` and ``contour_error_signed_mean`` [m] (in space the last is the
        mean magnitude), ``contour_error_integral`` [m s], ``contour_error_max_time`` [s], ``tracking_error_rms`` and ``tracking_error_max``
        [m]. With `part`, ``part_error_max`` and ``part_error_rms`` [m]. With `effort`, ``command_energy`` [s], the integral of the squared
        accepted commands, and ``command_largest``, both relative to each drive's limit (in command units if it has none), and
        ``limited_share``, the share of time at which a drive did not accept the whole command. NaN for a variant that failed.
    failed_at : ndarray (n_variant,) of int
        Sample at which the variant left its following-error limit, or produced a non-finite command; the last one if its tool hardly left
        the start (`contourlab.metrics.judge.stands_still`); -1 for none of these.
    unsure : ndarray (n_variant,)
        Samples of a variant that failed whose foot point is in doubt; 0 for all others, whose figures are those of `judge`.
    signals : mapping of str to ndarray (n_sample, n, n_variant)
        The requested signals: views of `log`.
    log : ndarray (n_group, n_sample, n_row, n_lane) [SI]
        Memory of the signals, in the layout of the lanes.
    variants : mapping of str to ndarray (n_variant,)
        The parameters that differ [SI].
    units : mapping of str to str
        SI unit of each parameter and figure; "" for none.
    """

    figures: Mapping[str, Array]
    failed_at: Index
    unsure: Array
    signals: Mapping[str, Array]
    log: Array
    variants: Mapping[str, Array]
    units: Mapping[str, str]

    def to_pandas(self) -> Frame:
        """Return a row for each variant: the parameters that differ, the figures, and `failed_at`; all in SI, see `units`.

        >>> import contourlab as cl
        >>> case = cl.load_scenario("builtin:ghaffari/demo-stage").base
        >>> circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
        >>> table = cl.simulate_batch(case.machine, case.controller, circle, {"axes.1.plant.gain": [1.0, 1.1]}).to_pandas()
        >>> table[["axes.1.plant.gain", "contour_error_max"]].shape
        (2, 2)
        """
        return frame({**self.variants, **self.figures, "failed_at": self.failed_at})

    def plot(self, figure: str = "contour_error_max") -> Figure:
        """Draw a figure over the first parameter that differs; as points where others differ independently, or of one variant.

        Parameters
        ----------
        figure : str
            One of `figures`.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        ParameterError
            If there is no such figure.
        """
        if figure not in self.figures:
            raise ParameterError("figure", repr(figure), "one of " + ", ".join(self.figures))
        name, values = next(iter(self.variants.items()))
        order = np.argsort(values, kind="stable")
        factor, unit = self._shown(figure)
        labels = _labelled(name, self._shown(name)[1]), _labelled(figure.replace("_", " "), unit)
        picture = curves([(*labels, [("", values[order], factor * self.figures[figure][order])])])
        if len(values) == 1 or not all(np.array_equal(values, others) for others in self.variants.values()):
            picture.axes[0].lines[0].set(linestyle="", marker=".")
        return picture

    def _shown(self, name: str) -> tuple[float, str]:
        """Return factor and unit in which people read a figure; parameters are in SI."""
        return (FIGURES[name].factor, FIGURES[name].display) if name in self.figures else (1.0, self.units[name])

    def _facts(self) -> dict[str, object]:
        """Return how many variants there are, of which parameters, and how many failed."""
        return {"variants": len(self.failed_at), "parameters": ", ".join(self.variants), "failed": int((self.failed_at >= 0).sum())}

    def __repr__(self) -> str:
        return facts_line("BatchResult", {**self._facts(), "figures": ", ".join(self.figures)})

    def _repr_html_(self) -> str:
        rows = {}
        for name, values in {**self.variants, **self.figures}.items():
            factor, unit = self._shown(name)
            known = values[np.isfinite(values)] * factor
            spread = (known.min(), np.median(known), known.max()) if known.size else (np.nan,) * 3
            rows[_labelled(name, unit)] = [number(value, 4) for value in spread]
        picture = svg(self.plot()) if "contour_error_max" in self.figures else ""
        return facts_table(self._facts()) + grid(("", "smallest", "median", "largest"), rows) + picture


def _labelled(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name
