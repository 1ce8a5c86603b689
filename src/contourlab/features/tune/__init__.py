"""Calibration: the paper's sequential procedure, a global search beside it, and what their answer means on a drive."""

from contourlab.design.guards import Bounds, Guards
from contourlab.design.values import axes_of, with_values
from contourlab.features.tune.checked import Checked, checked
from contourlab.features.tune.drive_terms import DriveTerms, drive_terms
from contourlab.features.tune.globally import Searched, globally
from contourlab.features.tune.line import PLATEAUS, LineRule, Step, line_search
from contourlab.features.tune.linuxcnc import LinuxCNCGains, linuxcnc_gains, linuxcnc_law
from contourlab.features.tune.objective import FIGURES, Goal, Judged, Objective
from contourlab.features.tune.placed import fastest, placed_gains
from contourlab.features.tune.repair import repaired
from contourlab.features.tune.sequential import Path, sequential
from contourlab.features.tune.tune import METHODS, STARTS, Tuned, TuneSettings, tune

__all__ = [
    "FIGURES",
    "METHODS",
    "PLATEAUS",
    "STARTS",
    "Bounds",
    "Checked",
    "DriveTerms",
    "Goal",
    "Guards",
    "Judged",
    "LineRule",
    "LinuxCNCGains",
    "Objective",
    "Path",
    "Searched",
    "Step",
    "TuneSettings",
    "Tuned",
    "axes_of",
    "checked",
    "drive_terms",
    "fastest",
    "globally",
    "line_search",
    "linuxcnc_gains",
    "linuxcnc_law",
    "placed_gains",
    "repaired",
    "sequential",
    "tune",
    "with_values",
]
