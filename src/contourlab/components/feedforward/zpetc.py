"""Zero-phase-error tracking: the reference filtered by an inverse of the closed loop, with look-ahead."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, delayed, dot, lookup

MAX_ORDER = 8
"""Highest order of the denominator: the most closed-loop zeros that can be cancelled."""


class ZPETC(Component):
    """Shift of the reference by F(z) r - r, F(z) = z^L (n_0 + n_1 z^-1 + ...)/(d_0 + d_1 z^-1 + ...), from the reference L ticks ahead.

    `contourlab.analysis.linear.zpetc.zpetc_design` computes the coefficients for a closed loop, so that position over reference has zero
    phase at all frequencies. The step computes the shift from differences to the current reference: F is 1 at rest, so large coefficients
    of opposite sign lose no digits at rest.

    The shift is zero until the window of the filter is filled, and is then faded in over as many ticks.

    References
    ----------
    Tomizuka, "Zero phase error tracking algorithm for digital control", J. Dynamic Systems, Measurement, and Control 109 (1987) 65-68.
    """

    family = "feedforward"
    kind = "zpetc"
    reference = "Tomizuka 1987"
    example = {"numerator": (1.5, -0.9, 0.3, -0.1), "denominator": (1.0, -0.3, 0.1, 0.0), "lead": 3}
    unbounded = ("numerator", "denominator")
    states = tuple(Port(f"shift_{i}") for i in range(1, MAX_ORDER + 1))
    inputs = (Port("reference_ahead"),)
    outputs = (Port("reference_shift"),)
    derived = ("lead_ticks", "n_tap", *(f"d_{i}" for i in range(1, MAX_ORDER + 1)))
    tables = ("taps_table",)
    ring = "reference_ahead"

    numerator: tuple[float, ...] = param(vector=True, doc="n_0, n_1 ... of the reference ahead, in falling powers of z")
    denominator: tuple[float, ...] = param(vector=True, doc="d_0, d_1 ..., with zeros inside the unit circle; (1,) for none")
    lead: float = param(minimum=0.0, maximum=1000.0, whole=True, structural=True, doc="look-ahead in servo periods, L")

    def check_values(self) -> None:
        n, d = np.array(self.numerator), np.array(self.denominator)
        if d.size > MAX_ORDER + 1:
            raise ParameterError("denominator", f"of order {d.size - 1}", f"of order {MAX_ORDER} or less")
        if d[0] == 0.0 or np.abs(np.roots(d)).max(initial=0.0) >= 1.0:
            raise ParameterError("denominator", f"{list(self.denominator)}", "with d_0 not 0 and all zeros inside the unit circle")
        if not abs(n.sum() - d.sum()) <= 1e-6 * abs(d.sum()):
            raise ParameterError("numerator", f"a list with sum {n.sum():.9g}", f"one with sum {d.sum():.9g}, as the denominator has")

    @property
    def taps(self) -> Array:
        """Weights of the shift on the reference L, L - 1, ... ticks ahead: numerator minus the denominator delayed by L, over d_0."""
        lead = int(self.lead)
        found = np.zeros(max(len(self.numerator), lead + len(self.denominator)))
        found[: len(self.numerator)] += self.numerator
        found[lead : lead + len(self.denominator)] -= self.denominator
        return found / self.denominator[0]

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        back = np.zeros(MAX_ORDER)
        back[: len(self.denominator) - 1] = np.array(self.denominator[1:]) / self.denominator[0]
        return self.lead, float(self.taps.size), *back.tolist()

    def table_values(self) -> dict[str, Array]:
        return {"taps_table": self.taps}

    def ring_length(self, dt: float) -> int:
        return int(self.taps.size)

    def ahead(self, dt: float) -> int:
        return int(self.lead)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        now = delayed(par.ring, clock, par.lead_ticks)
        drive, i = 0.0, 0.0
        while i < par.n_tap:
            drive += lookup(par.taps_table, i) * (delayed(par.ring, clock, i) - now)
            i += 1.0
        known = clock.k - (par.n_tap - 1.0)
        drive = drive if known >= 0.0 else 0.0
        back = (par.d_1, par.d_2, par.d_3, par.d_4, par.d_5, par.d_6, par.d_7, par.d_8)
        past = (x.shift_1, x.shift_2, x.shift_3, x.shift_4, x.shift_5, x.shift_6, x.shift_7, x.shift_8)
        shift = drive - dot(back, past)
        return (shift, *past[:7]), (shift * clip(known / par.n_tap, 0.0, 1.0),)
