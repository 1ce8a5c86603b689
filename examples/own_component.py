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


class FlippingIntegral(cl.Component):
    """PI position control whose integral changes its sign when the reference reverses."""

    family = "controller"
    kind = "flipping-integral"
    reference = "friction changes its sign with the velocity"
    example = {"velocity_gain": 100.0, "position_gain": 4000.0, "integral_gain": 11.8, "model_gain": 0.9, "model_damping": 30.0}
    states = (cl.Port("integral"), cl.Port("direction"))
    inputs = tuple(map(cl.Port, ("reference", "reference_velocity", "reference_acceleration", "position", "velocity")))
    outputs = (cl.Port("command"),)

    velocity_gain: float = cl.param(unit="{command}*s/m", minimum=0.0, doc="K_V")
    position_gain: float = cl.param(unit="{command}/m", minimum=0.0, doc="K_P")
    integral_gain: float = cl.param(unit="1/s", minimum=0.0, doc="K_I")
    model_gain: float = cl.param(unit="m/s^2/{command}", minimum=1e-6, doc="acceleration of the axis per command, a")
    model_damping: float = cl.param(unit="1/s", minimum=0.0, doc="decay rate of its velocity, b")

    @staticmethod
    def step(par, x, inp, clock):
        error = inp.reference - inp.position
        reversed_ = x.direction * inp.reference_velocity < 0.0
        integral = (-x.integral if reversed_ else x.integral) + clock.dt * error
        direction = inp.reference_velocity if inp.reference_velocity != 0.0 else x.direction
        ahead = (inp.reference_acceleration + par.model_damping * inp.reference_velocity) / par.model_gain
        loop = par.velocity_gain * (inp.reference_velocity - inp.velocity) + par.position_gain * (error + par.integral_gain * integral)
        return (integral, direction), (loop + ahead,)


print(*cl.check_component(FlippingIntegral), sep="\n")

# %%
# It takes the gains of the shipped position loop, and its place on each axis.

case = cl.load_scenario("builtin:demo-part").case("position loop")
program = cl.parse_program("G17 G21 G90 G94\nG0 X26 Y0\nG3 I-26 J0 F2400\nM2\n")
reference = cl.plan(cl.route_from_program(program), case.machine.planner_limits(), case.machine.servo_period)
axes = {}
for name, axis in case.controller.axes.items():
    gains = {gain: getattr(axis.controller, gain) for gain in FlippingIntegral.example}
    axes[name] = replace(axis, controller=FlippingIntegral(**gains))
controllers = {"shipped": case.controller, "own": replace(case.controller, axes=axes)}

# %%
# A controller is only as good as the model that it was tried on. Friction that jumps at the
# reversal suits this one. If the guides give way like a spring first, as in the LuGre model, the
# sign changes too early.

soft = cl.component("friction", "lugre")(coulomb=103.0, breakaway=130.0, stribeck_velocity=2e-3, stiffness=5e6, bristle_damping=3e3)
springy = tuple(replace(axis, friction=soft, substeps=4) for axis in case.machine.axes)
machines = {"Coulomb friction": case.machine, "LuGre friction, 5 N/um": replace(case.machine, axes=springy)}

figure, graphs = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained", sharey=True)
deviation = {}
for graph, (title, machine) in zip(graphs, machines.items(), strict=True):
    for name, controller in controllers.items():
        turn = cl.circles_of(cl.judge(cl.simulate(machine, controller, reference), reference), reference)[0]
        deviation[title, name] = size = turn.circular_deviation
        graph.plot(np.degrees(np.unwrap(turn.angle)), 1e6 * turn.deviation, linewidth=1, label=f"{name}: G = {1e6 * size:.0f} um")
    graph.set(xlabel="angle on the circle [degrees]", xticks=range(0, 361, 90), title=title)
    graph.legend()
graphs[0].set_ylabel("radial deviation [um]")
plt.show()
