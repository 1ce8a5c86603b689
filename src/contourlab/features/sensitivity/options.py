"""Options of ``contourlab sensitivity``."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Self

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, Judged, OfScenario, Seeded, Varied, Workers
from contourlab.errors import ParameterError, check_known, refuse

if TYPE_CHECKING:
    from contourlab.metrics.run_figures import RunFigure

STAGES = {
    "curves": "curves, one parameter at a time",
    "local": "small changes and interactions",
    "morris": "elementary effects (Morris)",
    "sobol": "variance shares (Sobol)",
}
PARTS = tuple(STAGES)
TRANSFORMS = ("log", "none")
FINE, STEPS = 16, 5
"""Subdivisions of each of the two steps of a curve around the smallest figure, and the number of small changes tried."""
QUICK = (128, 64, 32, 16)
"""N of Saltelli's sampling in a quick study: the largest that fits; the smallest is the least that the indices permit."""
QUICK_VALUES = 11
"""Values of a curve in a quick study."""


@options
class Plan(Seeded):
    """What a study does."""

    figure: str = option("integral", "integral, rms or max of the contour error.")
    parts: tuple[str, ...] = option((), "Analyses, separated by commas: curves, local, morris, sobol; by default all.", listed=True)
    values: int = option(41, "Values of each curve.", advanced=True)
    base: int = option(512, "N of Saltelli's sampling, a power of two: N (parameters + 2) runs.", advanced=True)
    second_order: bool = option(False, "Add Sobol indices of pairs: N (2 parameters + 2) runs.", advanced=True)
    trajectories: int = option(32, "Trajectories of Morris' design; each takes one run per parameter and one more.", advanced=True)
    transform: str = option("log", "log or none: whether morris and sobol use the logarithm of the figure.", advanced=True)
    json_form: ClassVar = {name: name for name in ("parts", "figure", "values", "base", "second", "trajectories", "transform", "seed")} | {
        "parts": "chosen",
        "second": "second_order",
    }

    def __post_init__(self) -> None:
        super().__post_init__()
        for part in self.parts:
            check_known("--parts", part, PARTS)
        _ = self.judged
        refuse(self.transform not in TRANSFORMS, ParameterError, "--transform", repr(self.transform), " or ".join(TRANSFORMS))
        for name, least, part in (("values", 5, "curves"), ("trajectories", 4, "morris"), ("seed", 0, "")):
            if getattr(self, name) < least and (not part or part in self.chosen):
                raise ParameterError(f"--{name}", f"{getattr(self, name)}", f"{least} or more")
        if "sobol" in self.chosen and (self.base < 16 or self.base & (self.base - 1)):
            near = [2**k for k in range(4, 25) if 2**k <= max(2 * self.base, 16)][-2:]
            raise ParameterError("--base", f"{self.base}", f"a power of two, 16 or more, such as {' or '.join(map(str, near))}")

    @property
    def chosen(self) -> tuple[str, ...]:
        """The analyses."""
        return self.parts or PARTS

    @property
    def judged(self) -> RunFigure:
        """The figure."""
        from contourlab.metrics.run_figures import goal_named

        return goal_named(self.figure, "--figure")

    def work(self, n: int) -> list[tuple[str, int]]:
        """Return first word and largest number of runs of each stage of the study with `n` parameters.

        Raises
        ------
        ParameterError
            If the study is not possible with so few.
        """
        if "sobol" in self.chosen and n < 2:
            raise ParameterError("--parameter", f"{n}", "two or more for Sobol indices; with one, use --parts curves,local")
        runs = {
            "curves": n * (self.values + 2 * FINE + 1),
            "local": 2 * STEPS * n + 1 + 4 * n**2,
            "morris": self.trajectories * (n + 1),
            "sobol": self.base * ((2 if self.second_order else 1) * n + 2),
        }
        return [(STAGES[part], runs[part]) for part in PARTS if part in self.chosen]

    def quickly(self, n: int, fits: float) -> Self:
        """Return the largest quick study of `n` parameters whose runs fit, or the full one; if need be without the small changes.

        Raises
        ------
        ParameterError
            If no quick study fits.
        """
        from contourlab.app.quick import too_slow

        for plan in (self, *self._smaller()):
            runs = sum(count for _, count in plan.work(n))
            if runs <= fits:
                return plan
        raise too_slow(runs, fits)

    def _smaller(self) -> Iterator[Self]:
        fewer = tuple(part for part in self.chosen if part != "local")
        for parts in dict.fromkeys((self.chosen, fewer or ("local",))):
            for base in QUICK:
                yield replace(self, parts=parts, values=QUICK_VALUES, base=base, trajectories=max(base // 8, 4))


@options
class SensitivityOptions(Plan, Workers, Varied, Judged):
    """Find the parameters that the contour error depends on, and in which order to calibrate them.

    It keeps its runs in the folder of the results: after an interrupt repeat the command, and it continues.
    """

    scheme: str = option("", "Scheme of the scenario; by default the scenario itself.")
    width: float = option(2.0, "Range of a parameter without bounds: from value / WIDTH to value * WIDTH.", advanced=True)
    distribution: str = option("uniform", "For morris and sobol between the bounds: uniform, log-uniform or normal.")
    deviation: tuple[str, ...] = option(
        (),
        'Standard deviation, e.g. "5 %" or "3.model_gain=20 mm/s^2/full_scale": the parameter is then normal; repeatable.',
        metavar="[NAME=]DEVIATION",
    )
    servo_period: str | None = option(None, 'Servo period in place of the machine\'s, e.g. "0.1 ms".', unit="s")
    quick: bool = option(False, "Answer within a minute; what does not fit is made smaller: --values, --base, --trajectories.")
    json_form: ClassVar = {name: name for name in ("plan", "scheme", "width", "distribution", "judge", "quick")} | {
        "parameters": "parameter",
        "deviations": "deviation",
        "servo_period": "period",
        "executor": "where",
    }

    @property
    def plan(self) -> Plan:
        """What the study does."""
        return Plan(**{name: getattr(self, name) for name in Plan.PARTS})

    @property
    def period(self) -> str:
        """The servo period as given; empty to keep that of the machine."""
        return self.servo_period or ""

    @property
    def where(self) -> dict[str, str | int | None]:
        """Where the work is done: kind, and number of workers."""
        return {"kind": self.executor, "workers": self.workers}


COMMANDS = {"sensitivity": Command("contourlab.features.sensitivity.command:sensitivity", SensitivityOptions, OfScenario, Drawn)}
