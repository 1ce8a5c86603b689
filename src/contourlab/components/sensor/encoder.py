"""An incremental encoder."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import NOISE_STREAM, Component, param
from contourlab.primitives import normal, rint


class Encoder(Component):
    """Position in whole counts: q = r round((p + noise)/r), r the resolution after interpolation.

    Noise is normal and white; the same seed gives the same noise.
    """

    family = "sensor"
    kind = "encoder"
    example = {"resolution": 1e-5, "noise": 1e-5, "stream": 7.0}
    reference = "uniform quantiser"

    resolution: float = param(unit="m", minimum=0.0, exclusive=True, display="um", doc="travel per count, interpolation included")
    noise: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="standard deviation before quantisation")
    stream: float = NOISE_STREAM

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.resolution * rint((inp.position + par.noise * normal(par.stream, clock.k)) / par.resolution),)
