"""Signals recognised from the column names that controls and people use."""

from __future__ import annotations

from each import each

from contourlab.logs.mapping import meant
from contourlab.logs.reading import name_and_unit


@each(
    "name, meaning",
    [
        ("Encoder Feedback X/x", ("position", "x")),
        ("Feed Reference DataY/RefCommand", ("reference", "y")),
        ("joint.0.motor-pos-cmd", ("reference", "x")),
        ("joint.2.motor-pos-fb", ("position", "z")),
        ("axis.1.vel-cmd", ("reference_velocity", "y")),
        ("X actual position", ("position", "x")),
        ("position.b", ("position", "b")),
        ("Zeit", ("time", "")),
        # TwinCAT, whose axes are counted from 1
        ("ActPos X", ("position", "x")),
        ("SETPOS_X", ("reference", "x")),
        ("ActVelo Y", ("velocity", "y")),
        ("SetVelo Y", ("reference_velocity", "y")),
        ("Axes.Axis 1.ToPlc.ActPos", ("position", "x")),
        ("Axes.Axis Z.ToPlc.SetPos", ("reference", "z")),
        ("MAIN.fbAxis2.NcToPlc.ActPos", ("position", "y")),
        ("MAIN.fbAxis2.NcToPlc.SetPos", ("reference", "y")),
        ("GVL.stAxis1.NcToPlc.ActPos", ("position", "x")),
        ("Axis 1 SetPos", ("reference", "x")),
        # Aerotech, Heidenhain, and logs of milling machines
        ("PosCmd (X)", ("reference", "x")),
        ("PosFbk (X)", ("position", "x")),
        ("VelCmd (X)", ("reference_velocity", "x")),
        ("Noml. pos X", ("reference", "x")),
        ("Actual pos X", ("position", "x")),
        ("X1_CommandPosition", ("reference", "x")),
        ("X1_ActualPosition", ("position", "x")),
        ("Position Command X", ("reference", "x")),
        ("Position Feedback X", ("position", "x")),
        ("X Demand Position", ("reference", "x")),
        ("DES_POS X", ("reference", "x")),
        ("Lagesollwert X", ("reference", "x")),
        ("current position X", ("position", "x")),
        ("Position of the X axis", ("position", "x")),
        ("x_pos_mm", ("position", "x")),
        ("ActPos X (mm)", ("position", "x")),
        ("output.x_act", ("position", "x")),
        ("x vel mm/min", ("velocity", "x")),
        ("Position setpoint (64 bit) X", ("reference", "x")),
        ("x pos #2", ("position", "x")),
        ("axis.x.pos-cmd", ("reference", "x")),
        ("datax ref", ("reference", "x")),
    ],
)
def test_unambiguous_names(name: str, meaning: tuple[str, str]) -> None:
    assert meant(name) == meaning


@each(
    "name",
    [
        *("excitation", "spindle speed", "x", "Command X", "set x"),
        # Not a position: an actual value of something else, or a difference
        *("PosErr (X)", "MAIN.fbAxis1.NcToPlc.PosDiff", "MAIN.fbAxis1.NcToPlc.ActTorque", "X1_CurrentFeedback", "X1_CommandAcceleration"),
        *("Axes.Axis 1.ToPlc.ModuloActPos", "Axes.Axis 1.ToPlc.TargetPos", "X Lag", "REF ACTL X"),
        # Acceleration, velocity and voltage rather than axes of these letters
        *("a actual", "V ACTUAL", "V (NOM RPM)", "U nominal"),
        # The axis is uncertain
        *("ENC1_POS|1", "DES_POS|1", "G.axis[1].NcToPlc.ActPos", "Axis0 SetPos", "ActPos", "axis[1].pos", "Axis 3 X ActPos"),
        # Errors, currents and torques in German
        *("Schleppfehler x ist", "Strom ist X", "Strom soll X", "Drehmoment ist X", "Lageistwert X Abweichung", "Soll Moment X", "i_act_x"),
        # An unknown word may change the meaning of the others
        *("MAIN.fbAxis1.NcToPlc.CmdNo", "X1_CommandPositionDelta", "joint.0.free-pos-cmd", "joint.0.in-position", "in position X"),
        *("X axis position reached", "X pos act valid", "Actual pos X status", "joint.0.home-pos", "X position latch"),
        *("x trigger position", "x position window", "x position gain", "x act distance to go", "x compensation act", "d/dt x act"),
        *("x_act_std", "min x act", "x_act_old", "x_act model", "Position X g\u00fcltig", "\u0394x pos"),
        # The second of its kind, a formula, the opposite sign, an additional number or unit
        *("X2_ActualPosition", "encoder 2 x", "x act^2", "x pos'", "-x act", "1 pos x", "t mm"),
        # Of an unspecified motor, program or feed
        *("motor cmd X", "MAIN.fbAxis1.Cmd", "encoder current X", "feed act X"),
    ],
)
def test_ambiguous_names_give_nothing(name: str) -> None:
    assert meant(name) is None


def test_an_axis_in_brackets_is_not_a_unit() -> None:
    assert name_and_unit("PosFbk (X)") == ("PosFbk (X)", "")
    assert name_and_unit("PosFbk (X) (mm)") == ("PosFbk (X)", "mm")
