"""Options of ``contourlab swap``."""

from __future__ import annotations

from contourlab.app.options import REQUIRED, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import PICTURES, Drawn, Margins, OfScenario, Plugins, Seeded, Varied, Workers
from contourlab.errors import ParameterError, refuse
from contourlab.features.link.options import Network


@options
class Swap(Network, Workers, Seeded, Varied, Margins, Plugins):
    """Find out whether one controller serves all modules of a swapped axis, or which parameters must be local."""

    axis: tuple[str, ...] = option(REQUIRED, "Axis to swap; repeat for more axes, each with its --with.")
    with_: tuple[str, ...] = option(REQUIRED, "Files of the modules that may replace it, separated by commas.")
    scheme: str | None = option(None, "Scheme of the scenario; by default its base.")
    objective: str = option("contour_error_integral", "What to minimise: contour_error_integral, contour_error_rms or contour_error_max.")
    floor: str | None = option(None, 'J_tol, the floor of J in the loss; by default "2 um*s" for the integral, else "1 um".')
    local: tuple[str, ...] = option((), "Test this set of local parameters, separated by commas, without a search; repeat for more sets.")
    exhaustive: bool = option(False, "Try all sets of local parameters by size, instead of backward elimination.", advanced=True)
    from_: tuple[str, ...] = option(
        (), "Controller file to start each search from, or one for each variant, separated by commas; repeat for more."
    )
    budget: int = option(8000, "Candidates of each search.", least=100, advanced=True)
    quick: bool = option(False, "Answer within a minute, with its uncertainty.")
    region: tuple[str, ...] = option((), "Range of a machine parameter for the coverage, e.g. axes.x.plant.gain=LOW..HIGH; repeatable.")
    tolerance: str | None = option(None, 'Largest J accepted in the region, e.g. "5 um*s"; by default the loss decides.')
    places: int | None = option(None, "Points of the region at which to search J*, a power of 2; by default 8.", advanced=True)
    linear: tuple[str, ...] = option(
        (), "Add linear designs: direct, three-step or lmi; repeatable.", choices=("direct", "three-step", "lmi")
    )
    within: str = option("10 %", "Allowed loss by the network, as a share of the wired J or of J_tol.")
    longest: str = option("100 ms", "Longest message period to test.", advanced=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        if len(self.axis) != len(self.with_):
            raise ParameterError("axis", f"{len(self.axis)} given", f"given as often as --with, {len(self.with_)}")
        if len(set(self.axis)) != len(self.axis):
            raise ParameterError("axis", ", ".join(self.axis), "given once for each axis, with all files of the axis in one --with")
        places = self.places
        faults = [
            (self.seed < 0, "seed", self.seed, "0 or more"),
            (places is not None and (places < 1 or places & (places - 1)), "places", places, "a power of 2"),
            (self.exhaustive and self.quick, "exhaustive", "given with --quick", "left out: there are too many sets for a minute"),
            (self.exhaustive and self.local, "exhaustive", "given with --local", "left out: it tries all sets, --local only a few"),
            (self.tolerance and not self.region, "tolerance", self.tolerance, "given with --region: it limits J there"),
            (places is not None and not self.region, "places", places, "given with --region: it counts points there"),
            (places is not None and self.tolerance, "places", places, "left out with --tolerance, which needs no J*"),
        ]
        for wrong, name, value, wanted in faults:
            refuse(wrong, ParameterError, name, str(value), wanted)

    @property
    def swaps(self) -> list[tuple[str, list[str]]]:
        """Each axis with the files of its modules."""
        return [(name, [one.strip() for one in text.split(",")]) for name, text in zip(self.axis, self.with_, strict=True)]

    @property
    def starts(self) -> list[list[str]]:
        """The controller files of each start."""
        return [[one.strip() for one in text.split(",")] for text in self.from_]


@options
class Files(OfScenario, Drawn):
    """The argument, and what is saved."""

    plots: tuple[str, ...] = option(("png",), "Write plots as png, svg or pdf; repeatable; by default png.", choices=PICTURES)


COMMANDS = {"swap": Command("contourlab.features.swap.command:swap", Swap, Files)}
