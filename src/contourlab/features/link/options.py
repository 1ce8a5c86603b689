"""Options of ``contourlab link``."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from contourlab.app.options import Options, option, options, positive
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, OfScenario, Schemes
from contourlab.errors import ParameterError

if TYPE_CHECKING:
    from contourlab.components.link import network

LONGEST = 10.0
"""Longest message period and delay of a network [s]."""
SEEDS, MOST_SEEDS = 8, 256
"""Runs with jitter or loss: the worst counts. A batch runs all seeds of 32 values at once."""


@options
class Network(Options):
    """The network between base and axes."""

    division: tuple[str, ...] = option(
        (), "What moves into the axis, with commas: drive, observer, controller.", listed=True, choices=("drive", "observer", "controller")
    )
    ways: tuple[str, ...] = option((), "Messages in both directions or in one: both or one.", listed=True, choices=("both", "one"))
    within: str | None = option(None, "Allowed error above that of the undivided loop; by default 10 %.")
    message_period: str | None = option(None, "Message period of the network; by default the servo period.")
    delay: str | None = option(None, "Delay of a message in each direction; by default none.")
    jitter: str | None = option(None, "Jitter of a message in each direction; by default none.")
    loss: str | None = option(None, "Share of lost messages; by default none.")
    longest: str | None = option(None, "Longest time to test; by default 100 ms.", advanced=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, part in self.PARTS.items():
            names = getattr(self, name)
            twice = next((item for item in names if names.count(item) > 1), None) if part.option.listed else None
            if twice is not None:
                raise ParameterError(part.typed, repr(",".join(names)), f"different names: {twice} is given twice")
        _ = self.share, self.span, self.network  # refuse what is wrong before any work

    @property
    def divisions(self) -> tuple[str, ...]:
        """The divisions to test, by default all."""
        return self.division or self.PARTS["division"].option.choices

    @property
    def directions(self) -> tuple[str, ...]:
        """The ways of messages to test, by default all."""
        return self.ways or self.PARTS["ways"].option.choices

    @property
    def share(self) -> float:
        """Allowed error above that of the undivided loop, as a share; a number of 1 or more needs a unit: it may be percent or a factor."""
        text = "10 %" if self.within is None else self.within
        part = positive("--within", text, "", 'a quantity, such as "10 %" or 0.1', or_zero=True)
        if part >= 1.0 and not re.search("%|percent", text):
            raise ParameterError("--within", text, f'below 1, or in %: "{part:g} %" or "{100.0 * part:g} %"')
        return part

    @property
    def span(self) -> float:
        """The longest time to test [s]."""
        text = "100 ms" if self.longest is None else self.longest
        longest = positive("--longest", text, "s", 'a quantity, such as "100 ms"')
        if longest > LONGEST:
            raise ParameterError("--longest", text, f"up to {LONGEST:g} s, the limit of a link")
        return longest

    @property
    def given(self) -> dict[str, str]:
        """Quantities of the network that are given, as typed."""
        return {name: text for name in ("message_period", "delay", "jitter", "loss") if (text := getattr(self, name)) is not None}

    @property
    def network(self) -> network.Network:
        """The network in each direction."""
        from contourlab.components.link.network import Network

        forms = {name: ("", '"10 %" or 0.1') if name == "loss" else ("s", '"2 ms"') for name in self.given}
        forms = {name: (unit, f"a quantity, such as {example}") for name, (unit, example) in forms.items()}
        values = {name: positive(self.PARTS[name].typed, text, *forms[name], or_zero=True) for name, text in self.given.items()}
        return Network(**values, between="extrapolate" if getattr(self, "extrapolate", False) else "hold")


@options
class Link(Network, Schemes):
    """Divide controllers between base and axes: find the lowest message rate that holds."""

    vary: tuple[str, ...] = option(
        (),
        "What to vary, with commas: message-period, delay, jitter, loss; by default all; the others stay as given.",
        listed=True,
        choices=("message-period", "delay", "jitter", "loss"),
    )
    axes: tuple[str, ...] = option((), "Axes whose controllers are divided, with commas; by default all.", listed=True)
    figure: str = option("rms", "Figure of the contour error: rms, max or integral.")
    tolerance: str | None = option(None, 'Largest allowed error instead of --within, e.g. "15 um".')
    extrapolate: bool = option(False, "Extrapolate from the last two messages instead of holding the last.")
    seeds: int | None = option(None, "Runs with jitter or loss; the worst counts; by default 8.", advanced=True)
    quick: bool = option(False, "Answer within a minute: few values, a limit lies between two.")

    def __post_init__(self) -> None:
        given: Any = self.vary or ()
        texts = [given] if isinstance(given, str) else given
        object.__setattr__(self, "vary", [str(text).replace("_", "-") for text in texts])  # JSON writes message_period
        super().__post_init__()
        if self.seeds is not None and not 1 <= self.seeds <= MOST_SEEDS:
            raise ParameterError("--seeds", f"{self.seeds}", f">= 1 and <= {MOST_SEEDS}")
        if self.tolerance is not None and self.within is not None:
            wanted = "given without --tolerance: only one of the two can limit the error"
            raise ParameterError("--within", f"{self.within} with --tolerance", wanted)

    @property
    def quantities(self) -> tuple[str, ...]:
        """The quantities to vary, by default all."""
        return tuple(name.replace("-", "_") for name in self.vary or self.PARTS["vary"].option.choices)


@options
class Files(OfScenario, Drawn):
    """The argument, and what is saved."""


COMMANDS = {"link": Command("contourlab.features.link.command:link", Link, Files)}
