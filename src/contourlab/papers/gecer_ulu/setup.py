"""Machines, controllers, contour and tables of Gecer Ulu, Ulu & Cakmakci, and the runs over trials that the reproduction is made of.

What is not in the paper, and how it is read, stands in the shipped files ``gecer-ulu/*.toml`` and in docs/gecer-ulu.md.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.learning.law import LearningLaw
from contourlab.components.sensor.encoder import Encoder
from contourlab.features.learn import LearningRun, Stopping, learn
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.scenario import BUILTIN, Case, load_scenario

Array = NDArray[np.float64]
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
"""The paper's figures; Table 2 has no unit, and is read in nm."""

TO_THE_END = Stopping(improvement=0.0, divergence=1e12, growth=10**9)
"""No verdict: the paper's number of trials is run, whatever comes of them."""


def turning_points(width: float = 17.02e-6, height: float = 90e-6, radius: float = 1e-6, bend: float = 0.3, half: int = 60) -> Array:
    """Return points of two bent legs that meet in one tight turn, from (0, 0) over (width, height/2) to (0, height).

    A hyperbola has straight legs and a turn of any tightness; a parabola added to it bends the legs.

    Parameters
    ----------
    width, height, radius : float [m]
        Excursions, and the radius of curvature in the turn.
    bend : float, 0 to 1
        Share of the parabola.
    half : int
        Points on a leg; they lie dense where the curve turns.

    Returns
    -------
    ndarray (2 half + 1, 2) [m]
    """
    tip = _tip(height**2 / (4.0 * width * radius), bend)
    along = tip * np.sinh(np.linspace(-1.0, 1.0, 2 * half + 1) * np.arcsinh(1.0 / tip))
    along[0], along[-1] = -1.0, 1.0
    legs = (np.sqrt(along**2 + tip**2) - tip) / (np.sqrt(1.0 + tip**2) - tip)
    x = width * ((1.0 - bend) * (1.0 - legs) + bend * (1.0 - along**2))
    return np.column_stack([x, 0.5 * height * (along + 1.0)])


def _tip(curvature: float, bend: float) -> float:
    """Return the size of the hyperbola's tip at which the curve has a curvature there, both in parts of width and half height."""
    wanted = (curvature - 2.0 * bend) / (1.0 - bend)
    # 1/(t (sqrt(1 + t^2) - t)) = wanted, with its root in closed form: sqrt(1 + t^2) = t + 1/(wanted t).
    return 1.0 / (wanted * np.sqrt(1.0 - 2.0 / wanted))  # type: ignore[no-any-return]


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
    """Return the reference of a setting, its feed divided by `slower`."""
    return case_of(setting).reference(1.0 / slower)


def controller_of(setting: str, kappa: float = KAPPA) -> Controller:
    """Return the controller with C_cc = kappa C_fb; without coupling for a kappa of 0."""
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
    """Learn over a number of trials, of which trial 0 has learned nothing: FB and FB ILC with a kappa of 0, FB CCC and FB CCC ILC above.

    What has been run before is not run again.
    """
    return _course(setting, float(kappa), trials, seed, float(slower))


@cache
def _course(setting: str, kappa: float, trials: int, seed: int, slower: float) -> LearningRun:
    parts = (machine_of(setting), controller_of(setting, kappa), reference_of(setting, slower))
    return learn(*parts, law_of(setting), trials=trials, seed=seed, stopping=TO_THE_END, part="none")


def rms(run: LearningRun, trial: int) -> Triple:
    """Return the figures of a trial."""
    found = run.trials[trial]
    x, y = found.tracking_rms
    return 1e9 * x, 1e9 * y, 1e9 * found.contour_rms
