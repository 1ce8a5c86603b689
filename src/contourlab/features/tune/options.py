"""Options of ``contourlab tune``."""

from __future__ import annotations

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, Margins, Motion, Seeded, Varied, Workers, WrittenController


@options
class Tune(Workers, Seeded, Varied, Margins, Motion):
    """Tune gains, innermost loop first, within margins and drive limits; write a controller file."""

    scheme: str | None = option(None, "Scheme of the scenario; by default the scenario itself.")
    method: str = option(
        "both",
        "sequential, global, or both: the better result; relay: by rules, after a simulated relay experiment.",
        choices=("sequential", "global", "both", "relay"),
    )
    start: str = option("scenario", "scenario, or placed: poles as fast as the margins allow.", choices=("scenario", "placed"))
    objective: str = option(
        "part", "part (largest part error, then rms), max, rms, integral, tracking, energy; or a sum, integral=1,energy=0.1."
    )
    limited: float = option(0.0, "Largest share of the time at a drive limit, 0 to 1.", least=0.0, most=1.0)
    command: float | None = option(None, "Largest command, relative to the drive limit.", above=0.0)
    passes: int = option(1, "Largest number of passes of the sequential procedure.", least=1, most=100, advanced=True)
    lanes: int = option(32, "Most values tried per line search; a small budget allows fewer.", least=8, most=1024, advanced=True)
    plateau: str = option(
        "robust", "Which of equally good values to take: robust, largest or best.", choices=("robust", "best", "largest"), advanced=True
    )
    within: float = option(
        0.01, "Values worse than the best by up to this share count as equally good.", least=0.0, most=1.0, advanced=True
    )
    budget: int = option(6000, "Runs of the global search.", least=32, most=10_000_000, advanced=True)
    starts: int = option(5, "Starts of the global search.", least=1, most=100, advanced=True)


@options
class Files(WrittenController, Drawn):
    """The argument, and what is saved."""

    file: str = argument("SCENARIO", "A scenario (.toml), or a part program.")


COMMANDS = {"tune": Command("contourlab.features.tune.command:tune", Tune, Files)}
