"""Setup of Gecer Ulu, Ulu & Cakmakci: tables, machines, controllers, contour, and runs over trials.

The shipped files ``gecer-ulu/*.toml`` and docs/explanation/gecer-ulu.md explain what the paper leaves open and how we read it.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

from contourlab.components.learning.law import LearningLaw
from contourlab.components.sensor.encoder import Encoder
from contourlab.features.learn import LearningRun, Stopping, learn
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.scenario import BUILTIN, Case, load_scenario

Triple = tuple[float, float, float]
"""Rms of x, y and contour error [nm]."""

SIMULATION, EXPERIMENT, COUNTING, PERIOD_30MS = "simulation", "experiment", "simulation with 25 nm encoder", "simulation at 30 ms"
FILES = {
    SIMULATION: "gecer-ulu/contour-simulated",
    EXPERIMENT: "gecer-ulu/contour",
    COUNTING: "gecer-ulu/contour-simulated",
    PERIOD_30MS: "gecer-ulu/contour-30ms",
}
KAPPA = 0.3
"""C_cc over C_fb in the shipped scenarios."""

TABLE_2: dict[str, Triple] = {
    "FB": (11.30, 111.27, 29.04),
    "FB CCC": (15.42, 110.65, 32.36),
    "FB ILC": (3.47, 2.17, 2.73),
    "FB CCC ILC": (1.09, 2.11, 0.78),
}
TABLE_3: dict[str, Triple] = {
    "FB": (46.84, 113.05, 57.08),
    "FB CCC": (42.06, 94.66, 43.49),
    "FB ILC": (25.81, 79.14, 39.33),
    "FB CCC ILC": (21.28, 66.69, 27.52),
}
"""Printed figures; Table 2 has no unit, read as nm."""

TO_THE_END = Stopping(improvement=0.0, divergence=1e12, growth=10**9)
"""Never stop: run the paper's number of trials in any case."""


@cache
def case_of(setting: str, scheme: str = "FB CCC ILC") -> Case:
    """Return a shipped case."""
    return load_scenario(f"{BUILTIN}{FILES[setting]}").case(scheme)


def machine_of(setting: str) -> Machine:
    """Return the machine of a setting."""
    machine = case_of(setting).machine
    if setting != COUNTING:
        return machine
    return replace(machine, axes=tuple(replace(axis, sensor=Encoder(resolution=25e-9)) for axis in machine.axes))


@cache
def reference_of(setting: str, slower: float = 1.0) -> Reference:
    """Return the reference of a setting, with the feed divided by `slower`."""
    return case_of(setting).reference(1.0 / slower)


def controller_of(setting: str, kappa: float = KAPPA) -> Controller:
    """Return the controller with C_cc = kappa C_fb; without coupling if kappa is 0."""
    controller = case_of(setting).controller
    coupling: Any = controller.coupling
    if kappa == 0.0:
        return replace(controller, estimator=None, coupling=None)
    return replace(controller, coupling=coupling.replace(gain=coupling.gain * kappa / KAPPA))


def law_of(setting: str) -> LearningLaw:
    """Return the law of eq (9), gamma = 0.2 and M = 11."""
    settings = case_of(setting).learning
    assert settings is not None and isinstance(settings.law, LearningLaw)  # the shipped scenarios learn
    return settings.law


def course(setting: str, kappa: float, trials: int, seed: int = 0, slower: float = 1.0) -> LearningRun:
    """Learn over trials 0 (nothing learned) to `trials`, with coupling if kappa > 0; each course runs once."""
    return _course(setting, float(kappa), trials, seed, float(slower))


@cache
def _course(setting: str, kappa: float, trials: int, seed: int, slower: float) -> LearningRun:
    parts = (machine_of(setting), controller_of(setting, kappa), reference_of(setting, slower))
    return learn(*parts, law_of(setting), trials=trials, seed=seed, stopping=TO_THE_END, part="none")


def rms(run: LearningRun, trial: int) -> Triple:
    """Return the rms of x, y and contour error [nm] in a trial."""
    x, y = run.trials[trial].tracking_rms
    return 1e9 * x, 1e9 * y, 1e9 * run.trials[trial].contour_rms
