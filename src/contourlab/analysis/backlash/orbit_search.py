"""Search for the periodic orbits of a loop with a gap: shots from every guess of the describing function and from where motions settle."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.exact_simulation import ExactRun, simulate_exact
from contourlab.analysis.backlash.limit_cycle_prediction import Prediction, predict_limit_cycles, quasi_linear
from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.analysis.backlash.mode_flow import Motion
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, close_orbit
from contourlab.errors import ParameterError

Array = NDArray[np.float64]

KICKS = (1.5, 5.0, 30.0, 200.0)
"""Starts of the motions looked at: motor-load differences over half of the gap."""
SETTLING = 60
"""Changes of side after which a motion is looked at for returns to itself."""


@dataclass(frozen=True, eq=False)
class OrbitSearch:
    """Periodic orbits that were found, and where was looked.

    Attributes
    ----------
    orbits : tuple of PeriodicOrbit
        By falling amplitude.
    searched : tuple of str
        Every start, with what became of it.
    """

    orbits: tuple[PeriodicOrbit, ...]
    searched: tuple[str, ...]

    @property
    def stable(self) -> tuple[PeriodicOrbit, ...]:
        """Those that a motion settles on."""
        return tuple(orbit for orbit in self.orbits if orbit.stable)

    def __str__(self) -> str:
        if not self.orbits:
            return "none found; looked at: " + "; ".join(self.searched)
        return "\n".join(str(orbit) for orbit in self.orbits)


def find_orbits(loop: BacklashLoop, *, prediction: Prediction | None = None, kicks: tuple[float, ...] = KICKS) -> OrbitSearch:
    """Return the limit cycles of a loop at rest.

    Parameters
    ----------
    loop : BacklashLoop
    prediction : Prediction, optional
        Of the describing function, if it was made already; a loop that switches its controller has none.
    kicks : tuple of float
        Motor-load differences, over half of the gap, from which motions are followed until they settle.

    Returns
    -------
    OrbitSearch
        That nothing was found proves nothing by itself; it says where was looked. A proof is for `energy_bound` or `popov`.
    """
    if prediction is None and loop.contact_a is None:
        prediction = predict_limit_cycles(loop)
    orbits: list[PeriodicOrbit] = []
    searched = []
    for cycle in prediction.cycles if prediction is not None else ():
        start = _predicted_start(loop, cycle.amplitude, cycle.ratio, cycle.frequency)
        found = close_orbit(loop, start, 2.0 * math.pi / cycle.frequency)
        searched.append(f"the describing function's {cycle.frequency:.4g} rad/s at {cycle.ratio:.3g} half-gaps: {_outcome(found, orbits)}")
    for kick in kicks:
        searched.append(f"motion from {kick:g} half-gaps: {_settled(loop, kick, orbits)}")
    return OrbitSearch(tuple(sorted(orbits, key=lambda orbit: -orbit.amplitude)), tuple(searched))


def find_forced_orbits(loop: BacklashLoop, amplitude: float, frequency: float, *, offset: float = 0.0, settling: int = 30) -> OrbitSearch:
    """Return the orbits of the period of a sinusoidal reference.

    Parameters
    ----------
    loop : BacklashLoop
    amplitude : float
        Of the reference.
    frequency : float [rad/s]
    offset : float
    settling : int
        Periods that a motion is followed before it is tried; shots start from the linear loop's response too.

    Returns
    -------
    OrbitSearch
    """
    motion, period = Motion.sine(amplitude, frequency, offset), 2.0 * math.pi / frequency
    orbits: list[PeriodicOrbit] = []
    searched = []
    for name, matrix in (("contact", loop.contact_matrix), ("gap", loop.gap_matrix)):
        drive = loop.reference_input @ np.array([amplitude, 1j * frequency * amplitude, -(frequency**2) * amplitude])
        shifted = 1j * frequency * np.eye(loop.n) - matrix
        start = np.linalg.lstsq(shifted, drive.astype(complex), rcond=None)[0].imag
        found = close_orbit(loop, start, period, motion)
        searched.append(f"the linear response in {name}: {_outcome(found, orbits)}")
    run = simulate_exact(loop, np.zeros(loop.n), settling * period, motion)
    if run.diverged:
        searched.append(f"motion from rest: ran away after {run.duration:.3g} s")
    else:
        end = run.spans[-1].end
        found = close_orbit(loop, end[: loop.n], period, motion, twist=float(end[loop.n]) if run.flow.twisted else 0.0)
        searched.append(f"motion from rest after {settling} periods: {_outcome(found, orbits)}")
    return OrbitSearch(tuple(sorted(orbits, key=lambda orbit: -orbit.amplitude)), tuple(searched))


def _predicted_start(loop: BacklashLoop, amplitude: float, ratio: float, w: float) -> Array:
    """Return a state on the sinusoid of the quasi-linear loop, where the difference passes its peak."""
    values, vectors = np.linalg.eig(quasi_linear(loop, ratio, w))
    vector = vectors[:, int(np.argmin(np.abs(values - 1j * w)))]
    return np.asarray((vector * (amplitude / (loop.c @ vector))).real)


def _settled(loop: BacklashLoop, kick: float, orbits: list[PeriodicOrbit]) -> str:
    """Follow a motion until it is at rest, has run away, or comes back to itself; then shoot from there."""
    start = kick * loop.half_gap * loop.c / float(loop.c @ loop.c)
    duration = _first_look(loop)
    for _ in range(10):
        try:
            run = simulate_exact(loop, start, duration, most=20_000)
        except ParameterError:
            return "changes of mode without end"
        if run.diverged:
            return f"ran away after {run.duration:.3g} s"
        if run.times.size >= SETTLING:
            break
        duration *= 2.0
    makes = [i for i, mode in enumerate(run.modes) if mode == 1]
    if run.times.size < SETTLING or len(makes) < 4:
        return f"at rest or without contact within {run.duration:.3g} s"
    return _from_returns(loop, run, makes, orbits)


def _from_returns(loop: BacklashLoop, run: ExactRun, makes: list[int], orbits: list[PeriodicOrbit]) -> str:
    """Shoot from the last contact but some, with the time between it and the contact that comes closest to it."""
    states = np.array([run.spans[i].start[: loop.n] for i in makes])
    size = np.maximum(np.abs(states).max(axis=0), 1e-300)
    last = len(makes) - 1
    earlier = range(max(0, last - 6), last)
    best = min(earlier, key=lambda i: (np.abs((states[i] - states[last]) / size).max() > 0.3, last - i))
    # Half-way through a contact a start is safe from the edges of the mode.
    span = run.spans[makes[last]]
    middle = run.flow.exponential(span.mode, 0.5 * span.duration) @ span.start
    period = float(run.times[makes[last]] - run.times[makes[best]])
    found = close_orbit(loop, middle[: loop.n], period, twist=float(middle[loop.n]) if run.flow.twisted else 0.0)
    if found is None and run.difference(run.duration * np.linspace(0.75, 1.0, 2000)).max() <= 1.001 * loop.half_gap:
        return "dies out"
    return _outcome(found, orbits)


def _first_look(loop: BacklashLoop) -> float:
    """Return a time of some turns of the slowest motion that rings in contact."""
    poles = np.linalg.eigvals(loop.contact_matrix)
    ringing = poles.imag[poles.imag > 1e-6 * np.abs(poles).max()]
    slowest = float(ringing.min()) if ringing.size else float(np.abs(poles).min())
    return 100.0 * 2.0 * math.pi / max(slowest, 1e-300)


def _outcome(found: PeriodicOrbit | None, orbits: list[PeriodicOrbit]) -> str:
    """Note an orbit, once, and say what it is."""
    if found is None:
        return "no orbit"
    if not any(_same(found, other) for other in orbits):
        orbits.append(found)
    return f"{'stable' if found.stable else 'unstable'} orbit of {found.frequency:.4g} rad/s"


def _same(one: PeriodicOrbit, other: PeriodicOrbit) -> bool:
    """Whether two orbits are one, or one of them several rounds of the other."""
    rounds = one.period / other.period
    whole = max(round(rounds), 1) if rounds >= 1.0 else 1.0 / max(round(1.0 / rounds), 1)
    return abs(rounds / whole - 1.0) < 1e-6 and abs(one.amplitude / other.amplitude - 1.0) < 1e-5
