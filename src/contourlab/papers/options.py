"""Options of ``contourlab reproduce``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import Options, option, options
from contourlab.app.session import Command, Commands
from contourlab.app.shared_options import PICTURES, Saved


@options
class Ghaffari(Options):
    """Ghaffari and Ulsoy: component swapping modularity for distributed precision contouring; Figs 6 to 9."""


@options
class GecerUlu(Options):
    """Gecer Ulu, Ulu and Cakmakci: learning based cross-coupled control for precision positioning; Figs 9 and 10."""


@options
class Shahin(Options):
    """Shahin, ElMaraghy and ElBeheiry: nonlinearity control of CNC feed drives, backlash and switching controllers; Figs 7 to 13."""


@options
class Emps(Options):
    """Janot, Gautier and Brunot: data set and reference models of the EMPS, a linear axis identified from its log."""

    log: Path | None = option(None, "DATA_EMPS.mat of the benchmark: the log to identify from.")
    validation: Path | None = option(None, "DATA_EMPS_PULSES.mat: a second log, to check the parameters.")


@options
class Ubc(Options):
    """XY table of the UBC course MECH 467: two measured line-circle runs and the machine identified from them."""

    log_folder: Path | None = option(None, "Folder with line_circle_lli.mat and line_circle_pp.mat.")
    unseen: bool = option(True, "Also fit with parts of the runs left out; takes minutes.")


@options
class Reproduce(Ubc, Emps):
    """Recompute the figures of a paper or a log, and compare."""


@options
class Files(Saved):
    """What is shown and saved."""

    out: Path = option(Path("results"), "Folder of the pictures; created if missing.")
    plots: tuple[str, ...] = option((), "Also draw the pictures of the paper or log as png, svg or pdf; repeatable.", choices=PICTURES)
    whole: bool = option(False, "Print every row, not only the table of computed figures.", name="--all")


OF_PAPERS = {"ghaffari": Ghaffari, "gecer_ulu": GecerUlu, "shahin": Shahin, "emps": Emps, "ubc": Ubc}
COMMANDS = {
    "reproduce": Commands(
        "Recompute the figures of a paper or a log, and compare.",
        {name.replace("_", "-"): Command(f"contourlab.papers.run:{name}", kind, Files) for name, kind in OF_PAPERS.items()},
    )
}
