"""Models ``rigid`` and ``rigid-by-direction``: inverse dynamics by least squares."""

from __future__ import annotations

from dataclasses import replace

from contourlab.analysis.inverse_dynamics import InverseDynamicsSettings
from contourlab.errors import ParameterError
from contourlab.session.identification.request import Request
from contourlab.session.log_choice import open_log, positive
from contourlab.studies.identification.finding import Figure, Finding, Graph, Picture
from contourlab.studies.identify import AxisFit, axis_tables, correlations, identify_rigid, units_of

__all__ = ["study"]

FRICTION = {"rigid": "symmetric", "rigid-by-direction": "asymmetric"}


def study(request: Request) -> Finding:
    """Identify mass, friction and offset of an axis."""
    cutoff = positive("--cutoff", request.cutoff, "Hz", 'a frequency, such as "100 Hz"')
    settings = InverseDynamicsSettings(FRICTION[request.model], cutoff=cutoff, decimation=request.decimation)
    if request.full_scale is not None:
        raise ParameterError("--full-scale", request.full_scale, f"left out: model {request.model} takes forces, by --gain")
    if len(request.choices) > 1:
        raise ParameterError("LOG", f"{len(request.choices)} logs", f"one: model {request.model} takes a single run and --validation")
    log = request.logs()[0]
    second = None if request.validation is None else open_log(replace(request.choices[0], file=request.validation))
    return _finding(identify_rigid(log, request.axis, request.force_gain(), settings, second), request.model)


def _finding(found: AxisFit, model: str) -> Finding:
    fit, there = found.fit, found.validation
    rows = zip(fit.names, fit.values.tolist(), units_of(fit.names), fit.deviations.tolist(), fit.robust_deviations.tolist(), strict=True)
    lines = [f"relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}"]
    if there is not None:
        lines.append(f"on the second log: fit {there.fit:.4g} %, relative error {there.relative_error:.4g} %")
    checked = None if there is None else {"fit_percent": there.fit, "relative_error_percent": there.relative_error}
    return Finding(
        model=model,
        axis=found.axis,
        sources=(found.source,),
        figures=tuple(Figure(*row) for row in rows),
        fit=fit.fit,
        usable=fit.usable,
        remarks=fit.remarks,
        tables=axis_tables(found) if fit.usable else {},
        correlations=tuple(correlations(found)) if fit.usable else (),
        pictures=_pictures(found),
        lines=tuple(lines),
        more={"relative_error_percent": fit.relative_error, "condition_number": fit.condition_number, "validation": checked},
    )


def _pictures(found: AxisFit) -> tuple[Picture, ...]:
    fit = found.fit
    force = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}
    rest = fit.force - fit.predicted
    over_time = Graph("time [s]", "force [N]", {"residual": (fit.time, rest)})
    over_speed = Graph("velocity [mm/s]", "force [N]", {"residual": (1e3 * fit.velocity, rest)})
    return (
        Picture("force", f"Force of axis {found.axis}, {found.source}", (Graph("time [s]", "force [N]", force),)),
        Picture("residual", "What the model leaves of the force", (over_time,)),
        Picture("residual-speed", "What the model leaves of the force, over speed", (over_speed,)),
    )
