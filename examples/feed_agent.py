"""
An environment for agents that decide the feed
==============================================

A servo loop becomes a Gymnasium environment in thirty lines. An agent sees errors and speeds, and
decides the feed every 5 ms. Any library of reinforcement learning can train in it; here a search
tries a policy of three numbers.
"""

import gymnasium
import matplotlib.pyplot as plt
import numpy as np
from gymnasium.utils.env_checker import check_env

import contourlab as cl

case = cl.load_scenario("builtin:demo-part").base
machine = case.machine
program = """G17 G21 G90 G94
G1 X18 F4500
G3 X20 Y2 J2
G1 Y18
G3 X18 Y20 I-2
G1 X2
G3 X0 Y18 J-2
G1 Y2
G3 X2 Y0 I2
M2
"""
route = cl.route_from_program(cl.parse_program(program))
plan = cl.plan(route, machine.planner_limits(), machine.servo_period)

# %%
# The environment: a square with rounded corners. The reward is the way done [mm], less what errors
# above 10 um cost.


class FeedEnv(gymnasium.Env):
    """Decide the feed: 0.2 to 2.0 times the planned one."""

    action_space = gymnasium.spaces.Box(-1.0, 1.0, (1,))
    observation_space = gymnasium.spaces.Box(-1e3, 1e3, (5,))
    ticks = round(5e-3 / machine.servo_period)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        noise = int(self.np_random.integers(1 << 30))
        self.loop = cl.Loop(machine, case.controller, plan, inputs=("rate",), seed=noise)
        self.loop.step()
        return self.observed(), {}

    def observed(self):
        loop = self.loop
        behind = 1e6 * (loop["reference"] - loop["position"])
        seen = [1e6 * loop["contour_error_estimate"], *behind, 1e3 * loop["feedrate"]]
        return np.clip(seen, -1e3, 1e3).astype(np.float32)

    def step(self, action):
        before = self.loop["arc_length"]
        self.loop.step(self.ticks, rate=1.1 + 0.9 * float(action[0]))
        observed = self.observed()
        reward = 1e3 * (self.loop["arc_length"] - before)
        reward -= 0.1 * max(abs(float(observed[0])) - 10.0, 0.0)
        return observed, reward, self.loop.done, False, {}


check_env(FeedEnv(), skip_render_check=True)

# %%
# A policy: a feed that falls with the error, the faster the tool moves. The cross-entropy method keeps
# the best of some policies, and draws the next ones around them.


def episode(policy, environment):
    """Return what an episode earns."""
    seen, _ = environment.reset(seed=1)
    earned, done = 0.0, False
    while not done:
        feed = policy[0] - policy[1] * abs(seen[0]) / 10.0 - policy[2] * seen[4] / 75.0
        action = np.clip([(feed - 1.1) / 0.9], -1.0, 1.0)
        seen, reward, done, _, _ = environment.step(action)
        earned += reward - 0.05  # time costs
    return earned


draw, environment = np.random.default_rng(1), FeedEnv()
middle, spread = np.array([1.0, 0.0, 0.0]), np.array([0.4, 0.4, 0.4])
start = episode(middle, environment)
planned = environment.loop.result()
history = [start]
for _ in range(6):
    policies = draw.normal(middle, spread, (12, 3))
    earned = np.array([episode(policy, environment) for policy in policies])
    best = policies[np.argsort(earned)[-4:]]
    middle, spread = best.mean(axis=0), best.std(axis=0) + 0.02
    history.append(episode(middle, environment))

# %%
# What it found, beside the plan.

found = environment.loop.result()
figure, graph = plt.subplots(figsize=(9, 3.5), layout="constrained")
largest, taken = {}, {}
for name, run in {"as planned": planned, "found": found}.items():
    judged = cl.judge(run, run.motion)
    error = 1e6 * np.abs(judged["contour_error"])
    largest[name], taken[name] = error.max(), run.motion.duration
    label = f"{name}: {largest[name]:.1f} um, {taken[name]:.2f} s"
    graph.plot(1e3 * judged["arc_length"], error, linewidth=1, label=label)
graph.set(xlabel="along the path [mm]", ylabel="contour error [um]")
graph.legend()
plt.show()
