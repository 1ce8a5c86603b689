"""Setup of Gecer Ulu, Ulu & Cakmakci: tables, machines, controllers, contour, and runs over trials.

The shipped files ``gecer-ulu/*.toml`` and docs/explanation/gecer-ulu.md explain what the paper leaves open and how we read it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.learning.law import LearningLaw
from contourlab.components.sensor.encoder import Encoder
from contourlab.features.learn import learning_problem
from contourlab.features.learn.trial import record_of
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.loop.trials import Trials, feedforward_command
from contourlab.scenario import BUILTIN, Case, load_scenario

Triple = tuple[float, float, float]
"""Rms of x, y and contour error [nm]."""

SIMULATION, EXPERIMENT, COUNTING, DELAYED = "simulation", "experiment", "simulation with 25 nm encoder", "simulation with delay"
APART = "experiment, noise of y apart"
FILES = dict.fromkeys((EXPERIMENT, APART), "gecer-ulu/contour")
KAPPA = 2.2
"""C_cc over C_fb in the shipped scenarios."""
DELAY = 0.015
"""Identified delay [s], which the paper's design neglects."""
NOISE_OF_Y = 385e-9
"""Noise [V] on y where it is apart from that on x; the second of two values tried, with Table 3 in view."""
TRIALS = 30
"""Trials of learning; the paper does not state their number."""
COLUMNS = ("x", "y", "contour")

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


@dataclass(frozen=True, eq=False)
class Course:
    """Trials of learning; in trial 0 nothing is learned.

    Attributes
    ----------
    tracking : ndarray (n_trial, n_sample, 2) [m]
        Reference minus encoder position.
    reported : ndarray (n_trial, n_sample) [m]
        Contour error as the paper's eq (10) has it, see `reported`.
    contour : ndarray (n_trial, n_sample) [m]
        Exact contour error, positive to the left.
    position : ndarray (n_trial, n_sample, 2) [m]
        True positions.
    """

    tracking: Array
    reported: Array
    contour: Array
    position: Array

    def rms(self, trial: int) -> Triple:
        """Return the rms of x, y and reported contour error [nm] in a trial."""
        x, y = (_rms(self.tracking[trial, :, j]) for j in (0, 1))
        return x, y, _rms(self.reported[trial])

    def true_rms(self, trial: int) -> float:
        """Return the rms of the exact contour error [nm] in a trial."""
        return _rms(self.contour[trial])


def _rms(error: Array) -> float:
    return 1e9 * float(np.sqrt(np.mean(error**2)))


def reported(tracking: Array, reference: Reference) -> Array:
    """Return the contour error (n_sample,) [m] of eq (10) as printed, -C_x e_x + C_y e_y with C_i = n_i of section 3.2.

    The distance along the normal is n_x e_x + n_y e_y, so the printed sign of x counts twice.
    """
    asked = reference.block(0, reference.n_sample)
    tangent = reference.path.derivatives(asked.arc_length, order=1)[1]
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.linalg.norm(tangent, axis=1)[:, None]
    return np.asarray(-normal[:, 0] * tracking[:, 0] + normal[:, 1] * tracking[:, 1])


@cache
def case_of(setting: str) -> Case:
    """Return the shipped case with coupling and learning."""
    return load_scenario(f"{BUILTIN}{FILES.get(setting, 'gecer-ulu/contour-simulated')}").case("FB CCC ILC")


def machine_of(setting: str) -> Machine:
    """Return the machine of a setting."""
    machine = case_of(setting).machine
    changed: dict[str, Any] = {COUNTING: {"sensor": Encoder(resolution=25e-9)}, DELAYED: {"drive": DelayedSaturation(delay=DELAY)}}
    x, y = (replace(axis, **changed.get(setting, {})) for axis in machine.axes)
    pushed: Any = y.disturbance
    return replace(machine, axes=(x, replace(y, disturbance=pushed.replace(noise=NOISE_OF_Y)) if setting == APART else y))


@cache
def reference_of(setting: str) -> Reference:
    """Return the reference of a setting."""
    return case_of(setting).reference()


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


@cache
def course(setting: str, kappa: float, trials: int, seed: int = 0) -> Course:
    """Learn over trials 0 to `trials`, with coupling if kappa > 0; each course runs once."""
    return learned(machine_of(setting), controller_of(setting, kappa), reference_of(setting), law_of(setting), trials, seed)


def learned(machine: Machine, controller: Controller, reference: Reference, law: LearningLaw, trials: int, seed: int = 0) -> Course:
    """Learn over trials 0 to `trials`; never stop earlier, whatever the error."""
    runner = Trials(machine, controller, reference, seed=seed)
    problem = learning_problem(machine, controller, reference, law.target, runner.arc_length)
    beforehand = feedforward_command(machine, controller, reference)
    table, parts = np.zeros_like(beforehand), []
    for trial in range(trials + 1):
        run = runner.run(table, trial)
        record = record_of(run, runner, table, beforehand)
        error = record.tracking_error
        parts.append((error.copy(), reported(error, reference), run.contour_error.copy(), run.position.copy()))
        if trial < trials:
            table = law.update(table, record, problem)
    return Course(*(np.array(part) for part in zip(*parts, strict=True)))
