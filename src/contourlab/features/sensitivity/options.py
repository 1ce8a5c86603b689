"""Options of ``contourlab sensitivity``."""

from __future__ import annotations

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, Judged, OfScenario, Seeded, Varied, Workers


@options
class SensitivityOptions(Workers, Seeded, Varied, Judged):
    """Find the parameters that the contour error depends on, and in which order to calibrate them.

    It keeps its runs in the folder of the results: after an interrupt repeat the command, and it continues.
    """

    scheme: str = option("", "Scheme of the scenario; by default the scenario itself.")
    figure: str = option("integral", "integral, rms or max of the contour error.")
    width: float = option(2.0, "Range of a parameter without bounds: from value / WIDTH to value * WIDTH.", advanced=True)
    parts: tuple[str, ...] = option((), "Analyses, separated by commas: curves, local, morris, sobol; by default all.", listed=True)
    values: int = option(41, "Values of each curve.", advanced=True)
    base: int = option(512, "N of Saltelli's sampling, a power of two: N (parameters + 2) runs.", advanced=True)
    second_order: bool = option(False, "Add Sobol indices of pairs: N (2 parameters + 2) runs.", advanced=True)
    trajectories: int = option(32, "Trajectories of Morris' design; each takes one run per parameter and one more.", advanced=True)
    distribution: str = option("uniform", "For morris and sobol between the bounds: uniform, log-uniform or normal.")
    deviation: tuple[str, ...] = option(
        (),
        'Standard deviation, e.g. "5 %" or "3.model_gain=20 mm/s^2/full_scale": the parameter is then normal; repeatable.',
        metavar="[NAME=]DEVIATION",
    )
    transform: str = option("log", "log or none: whether morris and sobol use the logarithm of the figure.", advanced=True)
    servo_period: str | None = option(None, 'Servo period in place of the machine\'s, e.g. "0.1 ms".', unit="s")
    quick: bool = option(False, "Answer within a minute; what does not fit is made smaller: --values, --base, --trajectories.")


@options
class Files(OfScenario, Drawn):
    """The argument, and what is saved."""


COMMANDS = {"sensitivity": Command("contourlab.features.sensitivity.command:sensitivity", SensitivityOptions, Files)}
