"""
Does a controller of my own do better?
======================================

Where an axis reverses, friction changes its sign, and an integral needs time to follow. This
controller, written in one class, changes the sign of its integral at once.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import contourlab as cl

# %%
# A component declares parameters, states and ports, and computes one tick from plain numbers. It is
# compiled with the rest of the loop.

ASKED = ("reference", "reference_velocity", "reference_acceleration")


class FlippingIntegral(cl.Component):
    """PI position control whose integral changes its sign at a reversal."""

    family = "controller"
    kind = "flipping-integral"
    reference = "friction changes its sign with the velocity"
    states = (cl.Port("integral"), cl.Port("direction"))
    inputs = tuple(cl.Port(name) for name in (*ASKED, "position", "velocity"))
    outputs = (cl.Port("command"),)
    example = {"velocity_gain": 100.0, "position_gain": 4000.0}
    example |= {"integral_gain": 12.0, "model_gain": 0.9, "model_damping": 30.0}

    velocity_gain: float = cl.param(unit="{command}*s/m", minimum=0.0, doc="K_V")
    position_gain: float = cl.param(unit="{command}/m", minimum=0.0, doc="K_P")
    integral_gain: float = cl.param(unit="1/s", minimum=0.0, doc="K_I")
    model_gain: float = cl.param(unit="m/s^2/{command}", minimum=1e-6, doc="a")
    model_damping: float = cl.param(unit="1/s", minimum=0.0, doc="b")

    @staticmethod
    def step(par, x, inp, clock):
        velocity = inp.reference_velocity
        error = inp.reference - inp.position
        integral = -x.integral if x.direction * velocity < 0.0 else x.integral
        integral += clock.dt * error
        direction = velocity if velocity != 0.0 else x.direction
        ahead = inp.reference_acceleration + par.model_damping * velocity
        damped = par.velocity_gain * (velocity - inp.velocity)
        stiff = par.position_gain * (error + par.integral_gain * integral)
        return (integral, direction), (ahead / par.model_gain + damped + stiff,)


print(*cl.check_component(FlippingIntegral), sep="\n")

# %%
# It takes the gains of the shipped position loop, and its place on each axis.

case = cl.load_scenario("builtin:demo-part").case("position loop")
machine = case.machine
program = cl.parse_program("G17 G21 G90 G94\nG0 X26 Y0\nG3 I-26 J0 F2400\nM2\n")
route = cl.route_from_program(program)
reference = cl.plan(route, machine.planner_limits(), machine.servo_period)
axes = {}
for name, axis in case.controller.axes.items():
    shipped = axis.controller
    gains = {key: getattr(shipped, key) for key in FlippingIntegral.example}
    axes[name] = replace(axis, controller=FlippingIntegral(**gains))
own = replace(case.controller, axes=axes)
controllers = {"shipped": case.controller, "own": own}

# %%
# A controller is only as good as the model that it was tried on. Friction that jumps at the
# reversal suits this one. If the guides give way like a spring first, as in the LuGre model, the
# sign changes too early.

lugre = cl.component("friction", "lugre")
soft = lugre(coulomb=103.0, breakaway=130.0, stiffness=5e6, bristle_damping=3e3)
springy = tuple(replace(axis, friction=soft, substeps=4) for axis in machine.axes)
machines = {"Coulomb": machine, "LuGre, 5 N/um": replace(machine, axes=springy)}

figure = plt.figure(figsize=(10, 4.2), layout="constrained")
graphs = figure.subplots(1, 2, sharey=True)
deviation = {}
for graph, (friction, tried) in zip(graphs, machines.items(), strict=True):
    for name, controller in controllers.items():
        result = cl.judge(cl.simulate(tried, controller, reference), reference)
        turn = cl.circles_of(result, reference)[0]
        deviation[friction, name] = size = 1e6 * turn.circular_deviation
        angle, label = np.degrees(np.unwrap(turn.angle)), f"{name}: G = {size:.0f} um"
        graph.plot(angle, 1e6 * turn.deviation, linewidth=1, label=label)
    graph.set(title=f"{friction} friction", xlabel="angle [degrees]")
    graph.set_xticks(range(0, 361, 90))
    graph.legend()
graphs[0].set_ylabel("radial deviation [um]")
plt.show()
