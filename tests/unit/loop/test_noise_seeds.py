"""Noise depends on seed, trial, axis and slot, whatever stream a component names; each variant may have a seed of its own."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from refusals import refuses
from stages import PERIOD, control, make, stage

import contourlab as cl
from contourlab.components.contract import NOISE_STREAM, Component
from contourlab.components.link.network import Network
from contourlab.engine.step import ports
from contourlab.errors import ParameterError
from contourlab.loop import Division
from contourlab.loop.template import build
from contourlab.primitives import normal

NOISE = 2e-6


class _Dither(Component):
    """A user's filter that makes noise."""

    family = "filter"
    kind = "dither"
    inputs = ports("command")
    outputs = ports("command")

    stream: float = NOISE_STREAM

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command + 1e-6 * normal(par.stream, clock.k),)


def noisy(stream: float) -> tuple[cl.Machine, cl.Controller]:
    """Return a machine and a controller in which every slot that may makes noise, with the same stream."""
    machine = stage(
        friction=make("friction", "none"),
        sensor=make("sensor", "encoder", resolution=1e-12, noise=NOISE, stream=stream),
        disturbance=make("disturbance", "low-passed-noise", rms=0.01, bandwidth=50.0, stream=stream),
    )
    link = Division("observer", Network(loss=0.2, stream=stream), Network(loss=0.2, stream=stream))
    axes = {name: replace(axis, link=link, filters=(("dither", _Dither(stream=stream)),)) for name, axis in control().axes.items()}
    return machine, replace(control(), axes=axes)


def streams(stream: float, seed: int, trial: int) -> dict[str, float]:
    """Return the stream of each node that makes noise."""
    machine, controller = noisy(stream)
    loop = build(machine, controller, cl.contour("circle", radius=5e-3), np.zeros(2), seed=seed, trial=trial)
    return {node.name: float(node.parameters["stream"]) for node in loop.schedule.nodes if "stream" in node.step.parameters}


def sensor_noise(seed: int, stream: float = 7.0) -> np.ndarray:
    """Return what the encoders add (n_sample, n_axis)."""
    machine, _ = noisy(stream)
    run = cl.simulate(machine, control(coupled=False), cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 2, PERIOD), seed=seed)
    return np.asarray(run["position"] - run["axis_position"])


def test_no_two_sources_share_noise_by_accident() -> None:
    """Slots, axes, seeds, trials and streams all differ; only the signals of a message share its fate."""
    seen: Counter[float] = Counter()
    for stream, seed, trial in ((0.0, 1, 0), (7.0, 1, 0), (8.0, 1, 0), (7.0, 2, 0), (7.0, 1, 1)):
        found = streams(stream, seed, trial)
        messages = {name: value for name, value in found.items() if ".down_" in name or ".up_" in name}
        assert len(set(messages.values())) == 4  # two axes, two directions
        seen.update({value for name, value in found.items() if name not in messages} | set(messages.values()))
        assert len(found) - len(messages) == 6  # sensor, disturbance and filter of two axes
    assert len(seen) == 5 * (6 + 4) and set(seen.values()) == {1}


def test_a_named_stream_follows_seed_and_axis() -> None:
    """Twice two axes, seeds 1 and 2, streams 7 and 8: each pair of series is uncorrelated, and the same run is bit-equal."""
    runs = [sensor_noise(1), sensor_noise(2), sensor_noise(1, stream=8.0)]
    series = np.hstack(runs).T
    assert series.std(axis=1) == pytest.approx(NOISE, rel=0.1)
    bound = 5.0 / np.sqrt(series.shape[1])
    assert all(abs(np.corrcoef(series[i], series[j])[0, 1]) < bound for i, j in combinations(range(6), 2))
    assert np.array_equal(runs[0], sensor_noise(1))


@pytest.mark.parametrize("stream", [0.0, 7.0])
def test_a_variant_with_a_seed_equals_a_single_run(stream: float, circle: cl.Reference) -> None:
    machine, controller = noisy(stream)
    seeds, gains = [3, 1, 2**62], np.array([1.0, 1.1, 1.2])
    batch = cl.simulate_batch(machine, controller, circle, {"axes.*.plant.gain": gains}, seed=seeds, keep=("axis_position",))
    one = cl.simulate_batch(machine, controller, circle, {"axes.*.plant.gain": gains}, seed=1, keep=("axis_position",))
    assert np.array_equal(batch.signals["axis_position"][:, :, 1], one.signals["axis_position"][:, :, 1])
    for i, (seed, gain) in enumerate(zip(seeds, gains.tolist(), strict=True)):
        axes = tuple(replace(axis, plant=axis.plant.replace(gain=gain)) for axis in machine.axes)
        alone = cl.simulate(replace(machine, axes=axes), controller, circle, seed=seed)
        assert np.abs(batch.signals["axis_position"][:, :, i] - alone["axis_position"]).max() <= 1e-9 * 5e-3


def test_a_varied_stream_equals_that_of_the_machine(circle: cl.Reference) -> None:
    machine, controller = noisy(0.0)
    names = ("axes.*.sensor", "axes.*.disturbance", "controller.axes.*.link.*", "controller.axes.*.filters.dither")
    batch = cl.simulate_batch(machine, controller, circle, {f"{name}.stream": [0, 7] for name in names}, seed=4, keep=("axis_position",))
    for i, stream in enumerate((0.0, 7.0)):
        alone = cl.simulate(*noisy(stream), circle, seed=4)
        assert np.abs(batch.signals["axis_position"][:, :, i] - alone["axis_position"]).max() <= 1e-9 * 5e-3


def test_seeds_alone_make_variants(circle: cl.Reference) -> None:
    machine, controller = noisy(0.0)
    drawn = cl.simulate_batch(machine, controller, circle, {}, seed=range(40))
    again = cl.simulate_batch(machine, controller, circle, {}, seed=np.arange(39, 19, -1))
    assert np.unique(drawn.figures["contour_error_rms"]).size == 40
    assert np.array_equal(drawn.figures["contour_error_rms"][:19:-1], again.figures["contour_error_rms"])


@pytest.mark.parametrize(
    ("seed", "name"), [([1, 2], "variants"), ([], "variants"), ([1, -1, 2], "seed"), ([1, 1.5, 2], "seed"), (None, "seed")]
)
def test_seeds_are_whole_numbers_one_for_each_variant(seed: Any, name: str, circle: cl.Reference) -> None:
    with refuses(ParameterError, name=name):
        cl.simulate_batch(stage(), control(), circle, {"axes.x.plant.gain": [1.0, 1.1, 1.2]}, seed=seed)
