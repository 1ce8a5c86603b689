"""An axis with one structural resonance from logs: mass, resonance and its damping, damping and delay, from the frequency response."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from contourlab.analysis.identification.drive_fit import DriveFit, fit_two_mass
from contourlab.components.origin import Origin
from contourlab.components.plant.two_mass import TwoMass
from contourlab.features.identify.axis_tables import forces_of, rigid_tables
from contourlab.features.identify.frequency import EXCITATIONS, identified_drive, largest_acceleration, measured_response, propagated
from contourlab.features.identify.records import AxisRecord, newton_option, reference_name
from contourlab.features.identify.result import Identified, Propagated, Row, Tables, assumed
from contourlab.findings import finding

UNITS = {"resonance": "Hz", "damping_ratio": "", "load_share": ""}
"""Parameters of the plant besides those of a rigid one."""
EQUAL = 0.5
"""Share of the load where it is not known."""


def identify_two_mass(records: Sequence[AxisRecord], side: str = "motor", excitation: str = EXCITATIONS[0]) -> Identified:
    """Fit an axis with one structural resonance to its frequency response.

    Parameters
    ----------
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``. The response at the load does not show the load's share of the mass.
    excitation : str
        As in `contourlab.features.identify.frequency.identify_response`.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured or the model cannot be fitted.
    """
    response = measured_response(records, excitation)
    fit = fit_two_mass(response, side)
    tables: Tables = {}
    uncertainty, findings = Propagated({}), []
    if fit.usable and records[0].unit != "N":
        findings.append(finding("CL504", options=(newton_option(records[0].logged),)))
    elif fit.usable:
        uncertainty = propagated(fit, _numbers)
        tables = _tables(records, fit, uncertainty, side)
    return identified_drive("two-mass", records, response, fit, tables, uncertainty, findings)


def _numbers(x: Mapping[str, float]) -> dict[str, float]:
    return {"drive.delay" if name == "delay" else f"plant.{name}": value for name, value in x.items()}


def _tables(records: Sequence[AxisRecord], fit: DriveFit, uncertainty: Propagated, side: str) -> Tables:
    """Return the axis file: that of a rigid axis with the resonance, its encoder on the side measured."""

    def origin(name: str, note: str = "") -> Origin:
        return uncertainty.origin(reference_name(records), name, note or "frequency response")

    mass, peak = fit["mass"], largest_acceleration(records, fit)
    tables = dict(rigid_tables(records, forces_of(records), 1.0 / mass, fit["damping"] / mass, origin, delay=fit["delay"], peak=peak))
    plant: dict[str, Row] = {**tables["plant"], "kind": (TwoMass.kind, "", None)}
    plant |= {name: (fit[name], unit, origin(f"plant.{name}")) for name, unit in UNITS.items() if name in fit.parameters}
    if "load_share" not in fit.parameters:
        plant["load_share"] = (EQUAL, "", assumed("equal shares: the response at the load does not show them"))
    tables["plant"] = plant
    if side == "motor" and "sensor" in tables:
        tables["motor_sensor"] = tables.pop("sensor")
    return tables
