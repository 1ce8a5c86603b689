"""Every scheme on one machine, for `learning.py`: the schemes and their comparison."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.analysis.linear.zpetc import zpetc_design
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.controller.position import PositionController
from contourlab.components.controller.state_feedback import StateFeedback
from contourlab.components.plant.lagged_mass import LinearMotor
from contourlab.components.registry import component
from contourlab.features.learn import Stopping, learn
from contourlab.features.run.outcome import tick_cost
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine, simulate
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge

PERIOD, DELAY, LAG, KAPPA, TRIALS = 1e-3, 3e-3, 15e-3, 0.4, 10
MOTOR = {"resistance": 2.0, "inductance": 2e-3, "back_emf": 20.0, "force_constant": 20.0, "viscous_friction": 10.0, "amplifier_gain": 5.0}
MASSES = (2.0, 2.6)  # kg; all controllers are designed for the first
FRICTION = 3.0  # N
ESTIMATORS: dict[str, dict[str, Any]] = {
    "constant-gain": {"direction": (1.0, 1.0)},
    "tangent": {},
    "koren-lo": {},
    "osculating-circle": {},
    "taylor": {},
    "newton": {"iterations": 1, "start": "warm"},
    "newton ": {},  # the defaults: two iterations from both starts
}


def model() -> tuple[float, float, float]:
    """Return G, zeta and w_n of the first axis, from K_amp K_f/(s (L m s^2 + (R m + b L) s + R b + K_b K_f))."""
    m = MASSES[0]
    stiff = MOTOR["resistance"] * MOTOR["viscous_friction"] + MOTOR["back_emf"] * MOTOR["force_constant"]
    natural = math.sqrt(stiff / (MOTOR["inductance"] * m))
    damped = MOTOR["resistance"] * m + MOTOR["viscous_friction"] * MOTOR["inductance"]
    return MOTOR["amplifier_gain"] * MOTOR["force_constant"] / stiff, damped / (2.0 * natural * MOTOR["inductance"] * m), natural


def machine() -> Machine:
    """Return two unlike linear motors with friction, an encoder of 25 nm and a delay of 3 ms."""
    friction = component("friction", "smooth-coulomb")(coulomb=FRICTION, breakaway=1.2 * FRICTION, smoothing_velocity=1e-3)
    drive, sensor = component("drive", "delayed-saturation")(limit=10.0, delay=DELAY), component("sensor", "encoder")(resolution=25e-9)
    axes = tuple(
        Axis(name, LinearMotor(**MOTOR, mass=mass), friction, drive, sensor, limits=Limits(following_error=0.05))
        for name, mass in zip("xy", MASSES, strict=True)
    )
    return Machine("two linear motors", axes, PERIOD)


def controllers() -> dict[str, Any]:
    """Return one controller of each kind for the first axis."""
    gain, damping, natural = model()
    a, b = LinearMotor(**MOTOR, mass=MASSES[0]).rigid_model()
    second = {"dc_gain": gain, "damping_ratio": damping, "natural_frequency": natural}
    k = 1.0 / (gain * LAG)
    return {
        "pid": component("controller", "pid")(proportional_gain=0.8 * k, integral_gain=2.0 * k, derivative_gain=3e-3 * k),
        "speed-pid": component("controller", "speed-pid")(**second, time_constant=LAG, acceleration_bandwidth=2000.0),
        "cascade": Cascade(**Cascade.tune(90.0, 1.0, a, b), command_limit=10.0),
        "lead-lag": LeadLag(**LeadLag.design(math.radians(60.0), 40.0, a, b, delay=DELAY + 0.5 * PERIOD)),
        "state-feedback": StateFeedback(
            **StateFeedback.place_second_order([-50.0 + 30.0j, -50.0 - 30.0j, -15.0, -700.0], **second), acceleration_bandwidth=2000.0
        ),
        "position": PositionController(**PositionController.place(55.0, 0.9, 15.0, a, b)),
    }


@dataclass(frozen=True, eq=False)
class Scheme:
    """One row: a controller, with or without a learning law."""

    group: str
    name: str
    controller: Controller
    law: Any = None


def loops(**parts: Any) -> Controller:
    """Return a controller with the same parts on both axes."""
    velocity = component("velocity", "filtered-difference")(bandwidth=2000.0)
    return Controller({name: AxisController(velocity=velocity, **parts) for name in "xy"})


def schemes() -> Iterator[Scheme]:
    """Yield all rows; later groups change the first row, except that feedforward changes `pid`."""
    made = controllers()
    base, pid = loops(controller=made["speed-pid"]), loops(controller=made["pid"])
    for name in ("speed-pid", *(other for other in made if other != "speed-pid")):
        yield Scheme("controller", name, loops(controller=made[name]))
    gain, damping, natural = model()
    smith = component("predictor", "smith")(dc_gain=gain, damping_ratio=damping, natural_frequency=natural, delay=DELAY)
    yield Scheme("predictor", "speed-pid, smith", loops(controller=made["speed-pid"], predictor=smith))
    inverse = component("feedforward", "inverse-dynamics")(velocity_gain=1.0 / gain, acceleration_gain=2.0 * damping / (gain * natural))
    force = MOTOR["force_constant"] * MOTOR["amplifier_gain"] / MOTOR["resistance"]
    rubbing = component("feedforward", "friction")(
        coulomb=FRICTION, breakaway=1.2 * FRICTION, smoothing_velocity=1e-3, force_constant=force
    )
    zero_phase = zpetc_design(sampled_loop(machine().axes[0], pid.axes["x"], PERIOD, 0.0))
    for name, part in (("inverse-dynamics", inverse), ("friction", rubbing), ("zpetc", zero_phase)):
        yield Scheme("feedforward", f"pid, {name}", loops(controller=made["pid"], feedforward=part))
    k = 1.0 / (gain * LAG)
    filtered = {"numerator": (1.0 / natural**2, 2.0 * damping / natural, 1.0), "denominator": (1e-6, 2e-3, 1.0)}
    couplings = {
        "cross-coupled": component("coupling", "cross-coupled")(gain=KAPPA * k),
        "cross-coupled, PI": component("coupling", "cross-coupled")(gain=KAPPA * k, integral_rate=5.0),
        "cross-coupled-filter": component("coupling", "cross-coupled-filter")(gain=KAPPA * k, **filtered),
        "modified-reference": component("coupling", "modified-reference")(weight=0.5),
        "modified-error": component("coupling", "modified-error")(weight=0.5),
    }
    for kind, coupling in couplings.items():
        for estimator, values in ESTIMATORS.items():
            part: Any = component("estimator", estimator.strip())(**values)
            shown = f"newton, {part.iterations:g} {part.start}" if part.kind == "newton" else estimator
            yield Scheme(kind, shown, replace(base, estimator=part, coupling=coupling))
    coupled = replace(base, estimator=component("estimator", "tangent")(), coupling=couplings["cross-coupled"])
    laws: dict[str, Any] = {
        "zero-phase": {"gain": 0.5, "half_width": 12, "passes": 2, "lead": LAG},
        "p-type": {"gain": 0.4 * k, "bandwidth": 120.0, "lead": LAG},
        "pd-type": {"gain": 0.4 * k, "derivative_gain": 0.2 * k * LAG, "bandwidth": 120.0, "lead": LAG},
        "cross-coupled": {"gain": 0.3 * k, "contour_gain": 0.2 * k, "bandwidth": 120.0, "lead": LAG},
        "plant-inversion": {"gain": 0.5, "regularisation": 1e-4, "bandwidth": 120.0},
        "norm-optimal": {"change_weight": 0.05},
    }
    for name, values in laws.items():
        law = component("learning", name)(**values)
        yield Scheme("learning", name, base, law)
        yield Scheme("learning with cross-coupled", name, coupled, law)


def compared(quick: bool) -> list[dict[str, Any]]:
    """Return contour error and tick of every scheme; the tick is the shortest of several rounds."""
    lap = uniform(contour("lissajous", axes=2), 0.25, 2, PERIOD)
    plant, rows = machine(), []
    found = list(schemes())
    for scheme in found:
        rows.append({"group": scheme.group, "name": scheme.name} | _errors(plant, scheme, lap))
    ticks: dict[int, float] = {}
    for _ in range(2 if quick else 6):
        for i, scheme in enumerate(found):
            # A learned table uses the feedforward wire of the controller, so it does not change the tick.
            ticks[i] = min(ticks.get(i, math.inf), tick_cost(plant, scheme.controller, lap))
    for i, row in enumerate(rows):
        row |= {"tick": ticks[i], "over_base": ticks[i] - ticks[0]}
    return rows


def _errors(plant: Machine, scheme: Scheme, lap: Reference) -> dict[str, Any]:
    if scheme.law is None:
        figures = summarise(judge(simulate(plant, scheme.controller, lap), lap), lap).contour_error
        return {"rms": figures.rms, "max": figures.max}
    spent = []
    for trials in (2, TRIALS):
        begun = time.process_time()
        run = learn(plant, scheme.controller, lap, scheme.law, trials=trials, part="none", stopping=Stopping(improvement=0.0))
        spent.append(time.process_time() - begun)
    best, more = run.trials[run.best], max(len(run.trials) - 3, 1)
    taken = (spent[1] - spent[0]) / more / lap.n_sample
    return {"rms": best.contour_rms, "max": best.contour_max, "status": run.status, "trial": run.best, "per_sample": taken}
