"""Plug-ins as a stranger writes them: one sound file of each kind, to be spoilt by a test."""

from __future__ import annotations

HEAD = '''"""A plug-in."""
from contourlab import Component, Port, param
from contourlab.components.learning.law import LearningLaw
from contourlab.components.plant.plant import SingleMass
from contourlab.components.supervisor.switching import Supervisor, settled
from contourlab.primitives import fabs, sqrt

'''

SOUND = {
    "controller": '''
class Mine(Component):
    """A proportional controller."""

    family = "controller"
    kind = "mine"
    example = {"gain": 2.0}
    inputs = (Port("reference"), Port("position"))
    outputs = (Port("command"),)

    gain: float = param(unit="{command}/m", minimum=0.0, doc="gain")

    @staticmethod
    def step(par, x, inp, clock):
        error = inp.reference - inp.position
        return (), (par.gain * error,)
''',
    "smooth": '''
class Mine(Component):
    """Resistance of air."""

    family = "friction"
    kind = "mine"
    law = "smooth"
    example = {"coefficient": 40.0}

    coefficient: float = param(unit="{force}*s^2/m^2", minimum=0.0, doc="force at unit speed")

    @staticmethod
    def force(par, v):
        return par.coefficient * v * fabs(v)
''',
    "sticking": '''
class Mine(Component):
    """A constant resistance."""

    family = "friction"
    kind = "mine"
    law = "sticking"
    example = {"coulomb": 0.2}

    coulomb: float = param(unit="{force}", minimum=0.0, doc="resistance")

    @staticmethod
    def held(par):
        return par.coulomb

    @staticmethod
    def sliding(par, speed):
        return par.coulomb
''',
    "bristle": '''
class Mine(Component):
    """A constant resistance with presliding."""

    family = "friction"
    kind = "mine"
    law = "bristle"
    states = (Port("bristle"),)
    example = {"coulomb": 0.2, "stiffness": 1e4, "bristle_damping": 30.0, "viscous": 2.0}

    coulomb: float = param(unit="{force}", minimum=0.0, exclusive=True, doc="resistance")
    stiffness: float = param(unit="{force}/m", minimum=0.0, exclusive=True, doc="bristle stiffness")
    bristle_damping: float = param(unit="{force}*s/m", minimum=0.0, doc="bristle damping")
    viscous: float = param(unit="{force}*s/m", minimum=0.0, doc="viscous coefficient")

    @staticmethod
    def level(par, v):
        return par.coulomb
''',
    "plant": '''
class Mine(SingleMass):
    """A mass."""

    kind = "mine"
    derived = ("mobility_value", "decay_value")
    example = {"mass": 2.0, "damping": 3.0}

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="mass")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass on top")
    damping: float = param(unit="N*s/m", minimum=0.0, doc="viscous damping")

    def derive(self, par, dt):
        total = par.mass + par.carried_mass
        return 1.0 / total, par.damping / total

    @staticmethod
    def drive_force(par, command):
        return command
''',
    "learning": '''
class Mine(LearningLaw):
    """Learning with a constant gain."""

    kind = "mine"
    without_effect = ("target",)
    example = {"gain": 0.5}

    gain: float = param(unit="{command}/m", minimum=0.0, doc="gain")

    def revised(self, table, trial, problem):
        return table + self.gain * trial.tracking_error
''',
    "supervisor": '''
class Mine(Supervisor):
    """Follow the speed."""

    kind = "mine"
    inputs = (Port("velocity"),)
    reasons = ("the axis is fast", "the axis is slow")
    n_controller = 2
    example = {"dwell_time": 3e-3}

    @staticmethod
    def step(par, x, inp, clock):
        fast = 1.0 if inp.velocity > 0.5 else 0.0
        return settled(x.active, x.since, fast, 2.0 - fast, par.dwell_time, clock.dt)
''',
}


def spoilt(pattern: str, old: str = "", new: str = "") -> str:
    """Return a sound plug-in with a text replaced; the text must be there."""
    text = HEAD + SOUND[pattern]
    assert old in text
    return text.replace(old, new) if old else text + new
