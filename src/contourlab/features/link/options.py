"""Options of ``contourlab link``."""

from __future__ import annotations

from contourlab.app.options import Options, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, OfScenario, Schemes


@options
class Network(Options):
    """The network between base and axes."""

    division: tuple[str, ...] = option((), "What moves into the axis, with commas: drive, observer, controller.", listed=True)
    ways: tuple[str, ...] = option((), "Messages in both directions or in one: both or one.", listed=True)
    within: str | None = option(None, "Allowed error above that of the undivided loop; by default 10 %.")
    message_period: str | None = option(None, "Message period of the network; by default the servo period.")
    delay: str | None = option(None, "Delay of a message in each direction; by default none.")
    jitter: str | None = option(None, "Jitter of a message in each direction; by default none.")
    loss: str | None = option(None, "Share of lost messages; by default none.")
    longest: str | None = option(None, "Longest time to test; by default 100 ms.", advanced=True)

    @property
    def network(self) -> dict[str, str]:
        """Quantities of the network that are given, as typed."""
        given = {name: getattr(self, name) for name in ("message_period", "delay", "jitter", "loss")}
        return {name: text for name, text in given.items() if text is not None}


@options
class Link(Network, Schemes):
    """Divide controllers between base and axes: find the lowest message rate that holds."""

    vary: tuple[str, ...] = option(
        (), "What to vary, with commas: message-period, delay, jitter, loss; by default all; the others stay as given.", listed=True
    )
    axes: tuple[str, ...] = option((), "Axes whose controllers are divided, with commas; by default all.", listed=True)
    figure: str = option("rms", "Figure of the contour error: rms, max or integral.")
    tolerance: str | None = option(None, 'Largest allowed error instead of --within, e.g. "15 um".')
    extrapolate: bool = option(False, "Extrapolate from the last two messages instead of holding the last.")
    seeds: int | None = option(None, "Runs with jitter or loss; the worst counts; by default 8.", advanced=True)
    quick: bool = option(False, "Answer within a minute: few values, a limit lies between two.")


@options
class Files(OfScenario, Drawn):
    """The argument, and what is saved."""


COMMANDS = {"link": Command("contourlab.features.link.command:link", Link, Files)}
