"""Force ripple and cogging of a linear motor over its position."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component, param
from contourlab.components.disturbance.low_passed_noise import next_noise
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import cos, floor, lookup, sin

_TURN = 2.0 * math.pi


@cache
def _make(n: int) -> Any:
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        turns = inp.position * par.inverse_pitch
        angle = _TURN * (turns - floor(turns))
        c, s = cos(angle), sin(angle)
        # Horner's rule for the sum of a_k exp(i phi_k) z^k with |z| = 1: one sine and one cosine for any number of harmonics.
        re, im = 0.0, 0.0
        for k in range(n - 1, -1, -1):
            re, im = re + lookup(par.in_phase, k), im + lookup(par.quadrature, k)
            re, im = re * c - im * s, re * s + im * c
        noise = next_noise(x.noise, par.noise, par.keep, par.stream, clock.k)
        return (noise,), (im + noise,)

    return step


class ForceRipple(Component):
    """Ripple of a motor's force over its magnets' pitch: F = sum of a_k sin(2 pi k p/P + phi_k), k = 1 ... n, and noise.

    The ripple is the same in every trial, as the reluctance of iron and the unevenness of magnets are. Noise, where its rms is given, is
    that of "low-passed-noise": other in every trial.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci name ripple forces and neglect them in their model (section 2); as a Fourier series over position: Tan, Huang
    & Lee, "Robust adaptive numerical compensation for friction and force ripple in permanent-magnet linear motors", IEEE Trans. Magnetics
    38 (2002).
    """

    family = "disturbance"
    kind = "force-ripple"
    reference = "Tan, Huang & Lee 2002: Fourier series over position"
    example = {
        "pitch": 0.7,
        "amplitudes": (1.0, 0.4, 0.2),
        "phases": (0.3, -1.0, 2.0),
        "noise": 0.3,
        "noise_bandwidth": 200.0,
        "stream": 7.0,
    }
    unbounded = ("phases",)
    states = (Port("noise"),)
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    derived = ("inverse_pitch", "keep")
    tables = ("in_phase", "quadrature")

    pitch: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel after which the ripple repeats, P")
    amplitudes: tuple[float, ...] = param(unit="{force}", minimum=0.0, vector=True, doc="of the harmonics, the fundamental first, a_k")
    phases: tuple[float, ...] = param(unit="rad", vector=True, doc="of the harmonics at position 0, phi_k; as many")
    noise: float = param(default=0.0, unit="{force}", minimum=0.0, doc="root mean square of the noise beside the ripple")
    noise_bandwidth: float = param(default=100.0, unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the noise's low-pass")
    stream: float = param(
        default=0.0,
        minimum=0.0,
        maximum=2.0**53,
        whole=True,
        doc="number of the noise stream; set by the run from its seed",
    )

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        if len(self.phases) != len(self.amplitudes):
            raise ParameterError("phases", f"{list(self.phases)}", f"as many as the amplitudes, {len(self.amplitudes)}", "rad")

    def step_function(self) -> Any:
        return _make(len(self.amplitudes))

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.pitch, np.exp(-par.noise_bandwidth * dt)

    def table_values(self) -> dict[str, NDArray[np.float64]]:
        amplitude, phase = np.array(self.amplitudes), np.array(self.phases)
        return {"in_phase": amplitude * np.cos(phase), "quadrature": amplitude * np.sin(phase)}
