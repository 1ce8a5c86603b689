"""What runs: a machine under its controller along a motion, as one value."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.feed import Reference
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import BatchResult, Controller, Machine, parameters_of, simulate, simulate_batch
from contourlab.metrics.run_figures import needs
from contourlab.result import Result

if TYPE_CHECKING:
    from contourlab.scenario import Case


@dataclass(frozen=True)
class Setting:
    """A machine under its controller along a motion.

    Attributes
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
    seed : int
        Of all noise.
    moving : bool
        Whether the axes start with the velocity of the reference.
    """

    machine: Machine
    controller: Controller
    reference: Reference
    seed: int = 0
    moving: bool = False

    @staticmethod
    def of(case: Case) -> Setting:
        """Plan the motion of a case of a scenario, and return what runs."""
        return Setting(case.machine, case.controller, case.reference(), case.seed, case.moving)

    @cached_property
    def view(self) -> PathView:
        """View of the path for estimator and judge."""
        return view_of(self.reference.path)

    def single(self) -> Result:
        """Run once; raise `DivergenceError`, with the place and time of the failure, if the run fails."""
        return simulate(self.machine, self.controller, self.reference, seed=self.seed, moving=self.moving)

    def batch(self, columns: Mapping[str, ArrayLike], figures: Iterable[str] = (), **options: Any) -> BatchResult:
        """Run many candidates.

        Parameters
        ----------
        columns : mapping of str to array_like (n,)
            Values [SI] by dotted names.
        figures : iterable of str
            Names of figures that are needed besides those of contour error and tracking error.
        **options : Any
            See `contourlab.loop.simulate_batch`; `seed` replaces that of the setting.
        """
        given = {"seed": self.seed, "moving": self.moving, "view": self.view, **needs(figures), **options}
        return simulate_batch(self.machine, self.controller, self.reference, columns, **given)

    def as_it_is(self, n: int = 1) -> dict[str, Array]:
        """Return the columns of n candidates without a change: one parameter at its own value."""
        name, (part, parameter) = next(iter(parameters_of(self.machine, self.controller).items()))
        return {name: np.full(n, float(getattr(part, parameter)))}
