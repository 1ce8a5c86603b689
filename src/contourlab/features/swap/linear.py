"""The linear view of a swap: each module as a/(s (s + b)), with the observer and without, and what base gains lose on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

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
from contourlab.errors import ParameterError
from contourlab.features.swap.variants import Variant
from contourlab.loop import Controller

Array = NDArray[np.float64]
METHODS = ("direct", "three-step", "lmi")
SEEN = 5e-4
"""So much of the sum of J/J* is seen in what is printed."""
SLOWEST, FASTEST = 2.0, 60.0
"""Frequencies [rad/s] between which a module is taken for a/(s (s + b)): where the loops of such axes live."""


@dataclass(frozen=True, eq=False)
class LinearSwap:
    """What linear base and local gains lose.

    Attributes
    ----------
    axis : str
        The axis that is swapped.
    case : str
        ``"raw drive"`` or ``"behind the observer"``.
    modules : tuple of str
    models : tuple of LinearAxis
    blind : ndarray (n, n)
        J/J* of the optimal gains of module i on module j.
    designs : tuple of ModularDesign
    """

    axis: str
    case: str
    modules: tuple[str, ...]
    models: tuple[LinearAxis, ...]
    blind: Array
    designs: tuple[ModularDesign, ...]

    @property
    def not_optimal(self) -> tuple[tuple[ModularDesign, ModularDesign], ...]:
        """Designs that lose more than one of the same method with fewer local gains, each with that one: they contain it."""
        found = []
        for design in self.designs:
            fewer = [one for one in self.designs if one.method == design.method and set(one.local) < set(design.local)]
            best = min(fewer, key=lambda one: float(one.ratio.sum()), default=design)
            if design.ratio.sum() > best.ratio.sum() + SEEN:
                found.append((design, best))
        return tuple(found)


def first_order(variant: Variant, controller: Controller, name: str, observer: bool) -> LinearAxis:
    """Return a and b of an axis, behind its observer or without, as its sampled loop responds.

    Raises
    ------
    ComponentError
        If the axis has no linear model.
    ParameterError
        If what it does is nothing like a/(s (s + b)).

    Notes
    -----
    Least squares of the inverse of the velocity's response, (s + b)/a = 1/V, each frequency weighed by |V|, so that parts of it count.
    """
    machine, mine = variant.machine, controller.axes[name]
    part = mine if observer else replace(mine, observer=None)
    loop = sampled_loop(machine.axis(name), part, machine.servo_period, machine.carried_mass(name))
    w = np.geomspace(SLOWEST, min(FASTEST, 0.5 * loop.nyquist), 60)
    response = loop.response(w).compensated
    s = 1j * w
    matrix = np.stack([s, np.ones_like(s)], axis=1) * response[:, None]
    inverse, slope = np.linalg.lstsq(np.vstack([matrix.real, matrix.imag]), np.append(np.ones(w.size), np.zeros(w.size)), rcond=None)[0]
    if not inverse > 0.0:
        raise ParameterError(name, "a response without mass", "one like a/(s (s + b)) for a linear design")
    return LinearAxis(1e3 / inverse, slope / inverse)


def linear_swap(
    variants: Sequence[Variant], controller: Controller, name: str, methods: Sequence[str] = METHODS, weights: LqWeights | None = None
) -> tuple[LinearSwap, ...]:
    """Return what linear designs lose when an axis is swapped: raw drives, and behind the observer where there is one.

    Parameters
    ----------
    variants : sequence of Variant
    controller : Controller
        Whose observer it is.
    name : str
        The axis.
    methods : sequence of str
        Of `METHODS`.
    weights : LqWeights, optional

    Raises
    ------
    ParameterError
        If a method is unknown.
    """
    weights = weights or LqWeights()
    for method in methods:
        if method not in METHODS:
            raise ParameterError("design", repr(method), "of " + ", ".join(METHODS))
    modules: dict[str, Variant] = {}
    for variant in variants:
        modules.setdefault(dict(variant.modules)[name], variant)
    found = []
    for case, observer in (("raw drive", False), ("behind the observer", True)):
        if observer and controller.axes[name].observer is None:
            continue
        models = tuple(first_order(variant, controller, name, observer) for variant in modules.values())
        designs = tuple(design for method in methods for design in _designs(method, models, weights))
        found.append(LinearSwap(name, case, tuple(modules), models, blind_swaps(models, weights), designs))
    return tuple(found)


def _designs(method: str, models: Sequence[LinearAxis], weights: LqWeights) -> list[ModularDesign]:
    """Return the designs of a method: nothing local, then each gain alone where the method can have that."""
    if method == "lmi":
        return [lmi_design(models, weights)[0]]
    design = direct_design if method == "direct" else three_step_design
    return [design(models, local, weights) for local in ((), *((gain,) for gain in GAINS))]
