"""Linear designs of a swap: each module modelled as a/(s (s + b)), with and without the observer, and the loss of base gains on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from contourlab.analysis.linear.modular_design import (
    GAINS,
    LinearAxis,
    LqWeights,
    ModularDesign,
    blind_swaps,
    direct_design,
    lmi_design,
    three_step_design,
)
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.features.swap.variants import Variant
from contourlab.findings import Finding, finding
from contourlab.loop import Controller

SEEN = 5e-4
"""Smallest difference of the sum of J/J* that shows in print."""
SLOWEST, FASTEST = 2.0, 60.0
"""Frequency range [rad/s] of the fit of a/(s (s + b)) to a module."""


@dataclass(frozen=True, eq=False)
class LinearSwap:
    """The loss of linear base and local gains.

    Attributes
    ----------
    axis : str
        The swapped axis.
    case : str
        ``"raw drive"`` or ``"behind the observer"``.
    modules : tuple of str
    models : tuple of LinearAxis
    blind : ndarray (n, n)
        J/J* of the optimal gains of module i on module j.
    designs : tuple of ModularDesign
    findings : tuple of Finding
    """

    axis: str
    case: str
    modules: tuple[str, ...]
    models: tuple[LinearAxis, ...]
    blind: Array
    designs: tuple[ModularDesign, ...]

    json_derived: ClassVar = ("findings",)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Designs that are not optimal."""
        place = f"axis {self.axis}, {self.case}"
        return tuple(
            finding("CL718", place, method=more.method, more=more.local or ("nothing",), fewer=fewer.local or ("nothing",))
            for more, fewer in self.not_optimal
        )

    @property
    def not_optimal(self) -> tuple[tuple[ModularDesign, ModularDesign], ...]:
        """Pairs (design, better one): same method, the better one has a subset of its local gains and a smaller loss."""
        found = []
        for design in self.designs:
            fewer = [one for one in self.designs if one.method == design.method and set(one.local) < set(design.local)]
            best = min(fewer, key=lambda one: float(one.ratio.sum()), default=design)
            if design.ratio.sum() > best.ratio.sum() + SEEN:
                found.append((design, best))
        return tuple(found)


def first_order(variant: Variant, controller: Controller, name: str, observer: bool) -> LinearAxis:
    """Fit a and b of an axis, with or without its observer, to the response of its sampled loop.

    Raises
    ------
    ComponentError
        If the axis has no linear model.
    ParameterError
        If the fit gives a gain a that is not positive.

    Notes
    -----
    Least squares on the inverse of the velocity response, (s + b)/a = 1/V, weighted by |V| so that errors are relative.
    """
    machine, mine = variant.machine, controller.axes[name]
    part = mine if observer else replace(mine, observer=None)
    loop = sampled_loop(machine.axis(name), part, machine.servo_period, machine.carried_mass(name))
    w = np.geomspace(SLOWEST, min(FASTEST, 0.5 * loop.nyquist), 60)
    response = loop.response(w).compensated
    s = 1j * w
    matrix = np.stack([s, np.ones_like(s)], axis=1) * response[:, None]
    inverse, slope = np.linalg.lstsq(np.vstack([matrix.real, matrix.imag]), np.append(np.ones(w.size), np.zeros(w.size)), rcond=None)[0]
    refuse(not inverse > 0.0, ParameterError, name, "a response without mass", "close to a/(s (s + b)) for a linear design")
    return LinearAxis(1e3 / inverse, slope / inverse)


def linear_swap(variants: Sequence[Variant], controller: Controller, name: str, methods: Sequence[str]) -> tuple[LinearSwap, ...]:
    """Return the loss of linear designs at a swap of one axis: as raw drive, and behind the observer if there is one.

    Parameters
    ----------
    variants : sequence of Variant
    controller : Controller
        Contains the observer.
    name : str
        The axis.
    methods : sequence of str
        ``"direct"``, ``"three-step"`` and ``"lmi"``.
    """
    modules: dict[str, Variant] = {}
    for variant in variants:
        modules.setdefault(dict(variant.modules)[name], variant)
    found = []
    for case, observer in (("raw drive", False), ("behind the observer", True)):
        if observer and controller.axes[name].observer is None:
            continue
        models, weights = tuple(first_order(variant, controller, name, observer) for variant in modules.values()), LqWeights()
        designs: list[ModularDesign] = []
        for method in methods:
            if method == "lmi":
                designs.append(lmi_design(models, weights)[0])
            else:  # nothing local, then each gain alone
                design = direct_design if method == "direct" else three_step_design
                designs += [design(models, local, weights) for local in ((), *((gain,) for gain in GAINS))]
        found.append(LinearSwap(name, case, tuple(modules), models, blind_swaps(models, weights), tuple(designs)))
    return tuple(found)
