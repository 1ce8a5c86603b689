"""Options of ``contourlab run``, ``demo`` and ``learn``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import Options, argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, Judged, Motion, OfScenario, Saved, Schemes
from contourlab.errors import check_known


@options
class Interval(Options):
    """Whether to compute an interval."""

    interval: bool | None = option(None, "Compute an uncertainty interval of the part error from the stated deviations, as by default.")


@options
class Run(Motion, Interval):
    """Simulate a scenario or a part program, judge the contour, write a report."""

    check: bool = option(False, "Read and check everything, simulate nothing.")


@options
class Trials(Schemes, Judged, Interval):
    """Schemes, and how many trials those that learn run."""

    trials: int | None = option(None, "Largest number of trials after the first; by default as in the scenario.", least=1)


@options
class Compare(Trials):
    """Run schemes of a scenario side by side; or compare finished runs from their files."""

    program: Path | None = option(None, "Part program of finished runs: its path counts.")
    tolerance: str | None = option(None, 'Largest contour error of finished runs that passes, e.g. "25 um".', unit="m")


@options
class Learn(Trials):
    """Repeat the motion of a scenario, learn from each trial, keep the result; predicts whether it converges."""

    table: Path | None = option(None, "A learned table to start with.")


@options
class Demo(Interval):
    """Run a shipped part on a shipped machine under several controllers, and compare them."""


@options
class Reported(Drawn):
    """What a run saves."""

    pdf: bool = option(False, "Also write report.pdf, one page to print.")
    signals: tuple[str, ...] = option((), "Write only this signal; repeatable; by default all.")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.signals:
            from contourlab.loop.simulate import UNITS
            from contourlab.result.signals import JUDGED

            known = (*UNITS, *JUDGED)
            for name in self.signals:
                check_known("signals", name, known)


@options
class RunFiles(Reported):
    """The argument, and what is saved."""

    file: Path = argument("SCENARIO|PART", "A scenario (.toml), or a part program in G-code.")


@options
class CompareFiles(OfScenario, Reported):
    """The arguments, and what is saved."""

    others: tuple[str, ...] = argument(
        "[RUN]...", "To compare finished runs, name at least two: logs, results (.nc) or folders of results.", ()
    )


@options
class DemoFiles(Saved):
    """What is saved."""

    out: Path = option(Path("results/demo"), "Folder for the results; created if missing.")


COMMANDS = {
    "run": Command("contourlab.features.run.command:run", Run, RunFiles),
    "compare": Command("contourlab.features.measure.command:compare", Compare, CompareFiles),
    "learn": Command("contourlab.features.run.command:learn_schemes", Learn, OfScenario, Reported),
    "demo": Command("contourlab.features.run.demo:demo", Demo, DemoFiles),
}
