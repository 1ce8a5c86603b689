"""
How fast may a tool take a corner?
==================================

A plan of constant feed around a square asks for a jump of the velocity at each corner. A predictive
controller looks ahead and decides both the commands of the axes and the feed: it slows down where
the corner needs it. It runs in Python, beside a loop in machine code.
"""

from dataclasses import replace
from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import osqp
import scipy.sparse as sparse

import contourlab as cl

# %%
# Two axes of the machine of the demonstration. Their observers take friction away; their own position
# loop gets a gain of zero, since the commands come from here.

case = cl.load_scenario("builtin:demo-part").base
machine = replace(case.machine, axes=case.machine.axes[:2], squareness={})
open_loop = cl.component("controller", "pid")(proportional_gain=0.0)
axes = {name: replace(case.controller.axes[name], controller=open_loop) for name in ("x", "y")}
controller = cl.Controller(axes)
SIDE, FEED = 0.02, 0.05
corners = SIDE * np.array([[0.5, 0], [1, 0], [1, 1], [0, 1], [0, 0], [0.5, 0]])
path = cl.Path([cl.Line(*ends) for ends in pairwise(corners)], closed=True)
plan = cl.uniform(path, FEED / path.length, 1, machine.servo_period)
loop = cl.Loop(machine, controller, plan, inputs=("command", "rate"))

# %%
# The model: for each axis v' = a u - b v, sampled at the period of the predictive controller, which is
# four ticks. The state after each of N periods is linear in the commands (a row for each period).

TICKS, N, LIMIT, FASTEST = 4, 30, 3.0, 1.2
period = TICKS * machine.servo_period
times = period * np.arange(1, N + 1)
planned = plan.block(0, plan.n_sample).position


def advanced(axis, h):
    """Return how position and velocity after a time h [s] depend on themselves, and on the command."""
    a, b = axis.plant.rigid_model()
    kept = np.exp(-b * h)
    moved = (1.0 - kept) / b
    return np.array([[1.0, moved], [0.0, kept]]), a * np.array([(h - moved) / b, moved])


model = []
for axis in machine.axes:
    forward, gain = advanced(axis, period)
    powers = [np.linalg.matrix_power(forward, i) for i in range(N + 1)]
    free = np.array([power[0] for power in powers[1:]])
    forced = np.zeros((N, N))
    for i in range(N):
        forced[i, : i + 1] = [powers[i - j][0] @ gain for j in range(i + 1)]
    # A command acts a tick after the measurement, and the delay of the drive later.
    under_way = advanced(axis, machine.servo_period + axis.drive.delay)
    model.append((free, forced, under_way))


def place(time):
    """Return point (n, 2) and velocity (n, 2) of the plan at times (n,)."""
    at = np.clip(time / plan.servo_period, 0.0, plan.n_sample - 1.001)
    k = at.astype(int)
    step = planned[k + 1] - planned[k]
    return planned[k] + (at - k)[:, None] * step, step / plan.servo_period


# %%
# In each period a quadratic programme chooses 2 N commands and N rates. It weighs the error across the
# path, the error along it, the change of the commands, and progress.

ACROSS, ALONG, EFFORT, PROGRESS = 1e10, 1e8, 1.0, 1e2
change = np.eye(N) - np.eye(N, k=-1)
progress = period * np.tril(np.ones((N, N)))
bounds = np.repeat([[-LIMIT, -LIMIT, 0.0], [LIMIT, LIMIT, FASTEST]], N, axis=1)
rates, command, time = np.ones(N), np.zeros(2), 0.0
while not loop.done:
    measured = np.array([loop["position"], loop["velocity"]] if loop.tick else [planned[0], [0, 0]])
    guess = np.minimum(time + progress @ rates, times[-1] + plan.duration)
    point, speed = place(guess)
    tangent = speed / np.linalg.norm(speed, axis=1)[:, None]
    normal = tangent[:, ::-1] * [-1.0, 1.0]
    # Position less planned point, linear in the commands and rates: rows for x, then for y.
    errors, offsets = [], []
    for j, (free, forced, (kept, pushed)) in enumerate(model):
        behind = -speed[:, [j]] * progress
        errors.append(np.hstack([forced if j == 0 else 0 * forced, forced if j == 1 else 0 * forced, behind]))
        offsets.append(free @ (kept @ measured[:, j] + pushed * command[j]) - point[:, j] + speed[:, j] * (guess - time))
    quadratic, linear = np.zeros((3 * N, 3 * N)), np.zeros(3 * N)
    for weight, direction in ((ACROSS, normal), (ALONG, tangent)):
        matrix = direction[:, [0]] * errors[0] + direction[:, [1]] * errors[1]
        quadratic += weight * matrix.T @ matrix
        linear += weight * matrix.T @ (direction[:, 0] * offsets[0] + direction[:, 1] * offsets[1])
    for j in range(2):
        part = slice(j * N, (j + 1) * N)
        quadratic[part, part] += EFFORT * change.T @ change
        linear[j * N] -= EFFORT * command[j]
    quadratic[2 * N :, 2 * N :] += PROGRESS * np.eye(N)
    linear[2 * N :] -= PROGRESS
    problem = osqp.OSQP()
    square = sparse.triu(sparse.csc_matrix(quadratic), format="csc")
    problem.setup(square, linear, sparse.identity(3 * N, format="csc"), *bounds, verbose=False, polishing=False)
    chosen = problem.solve(raise_error=True).x
    command, rates = chosen[[0, N]], np.append(chosen[2 * N + 1 :], chosen[-1])
    loop.step(TICKS, command=command, rate=max(chosen[2 * N], 0.0))
    time = loop["planned_time"]

# %%
# Beside it the shipped position loop and observer, which follow the plan at its feed whatever comes.
# The first half side, in which both start from rest, is left out.

shipped = cl.Controller({name: case.controller.axes[name] for name in ("x", "y")})
runs = {"predictive": loop.result(), "position loop": cl.simulate(machine, shipped, plan)}
figure = plt.figure(figsize=(9, 5), layout="constrained")
above, below = figure.subplots(2, 1, sharex=True)
largest, taken = {}, {}
for name, run in runs.items():
    judged = cl.judge(run, run.motion)
    along, error = 1e3 * judged["arc_length"], 1e6 * judged["contour_error"]
    later = along > 10.0
    largest[name], taken[name] = np.abs(error[later]).max(), run.motion.duration
    speed = np.hypot(*judged["axis_velocity"].T)
    label = f"{name}: {largest[name]:.0f} um, {taken[name]:.2f} s"
    above.plot(along[later], error[later], linewidth=1, label=label)
    below.plot(along[later], 6e4 * speed[later], linewidth=1)
above.set(ylabel="contour error [um]", xlabel="along the path [mm]")
below.set(xlabel="along the path [mm]", ylabel="speed of the tool [mm/min]")
above.legend()
plt.show()
