"""Calibration: the paper's sequential procedure, a global search beside it, and what their answer means on a drive."""

from contourlab.studies.space.bounds import Bounds
from contourlab.studies.space.values import with_values
from contourlab.studies.tune.checked import Checked, checked
from contourlab.studies.tune.drive_terms import DriveTerms, drive_terms
from contourlab.studies.tune.globally import Searched, globally
from contourlab.studies.tune.guards import Guards
from contourlab.studies.tune.line import PLATEAUS, LineRule, Step, line_search
from contourlab.studies.tune.linuxcnc import LinuxCNCGains, linuxcnc_gains, linuxcnc_law
from contourlab.studies.tune.objective import FIGURES, Goal, Judged, Objective
from contourlab.studies.tune.placed import fastest, placed_gains
from contourlab.studies.tune.repair import repaired
from contourlab.studies.tune.sequential import Path, sequential
from contourlab.studies.tune.tune import METHODS, STARTS, Tuned, TuneSettings, tune
from contourlab.studies.tune.values import axes_of

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
