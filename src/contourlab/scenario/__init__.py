"""Scenarios: TOML files to typed values and back, strictly.

Inside: `tree` (raw content that remembers where it stands), `files` (parts in files of their own), `quantities` (values with units),
`tables` (tables of fixed shape), `components` (tables of components), `build` (machines and controllers), `place` (a module in place of an
axis), `motion` (contour, program, feed, run), `values` (what comes out), `load` (the doors), `dump` and `toml_text` (the way back).
"""

from contourlab.scenario.case import Case, Overrides, Scenario
from contourlab.scenario.dump import dump
from contourlab.scenario.features import FEATURES, chosen
from contourlab.scenario.files import BUILTIN, builtin_file, builtin_names
from contourlab.scenario.learning import LearningSettings
from contourlab.scenario.load import load_axis, load_controller, load_machine, load_scenario, parse_scenario, scenario_from_parts
from contourlab.scenario.values import Contour, FeedSettings, Motion, PartProgram, RunSettings

__all__ = [
    "BUILTIN",
    "FEATURES",
    "Case",
    "Contour",
    "FeedSettings",
    "LearningSettings",
    "Motion",
    "Overrides",
    "PartProgram",
    "RunSettings",
    "Scenario",
    "builtin_file",
    "builtin_names",
    "chosen",
    "dump",
    "load_axis",
    "load_controller",
    "load_machine",
    "load_scenario",
    "parse_scenario",
    "scenario_from_parts",
]
