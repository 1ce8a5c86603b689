"""The skeleton of a question: how it is asked in Python and on the command line, and what its answer can do.

A question is a function ``question(*inputs, settings, session) -> Answer``. It computes only; `Answer.save` writes. `question` makes the
public function of it, whose keywords are the options of its settings. `execute` is the command: ask, save, return the answer to print.
"""

from __future__ import annotations

import inspect
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass, field
from functools import wraps
from importlib import import_module
from operator import attrgetter
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from contourlab.app.command_line import as_typed
from contourlab.app.options import REQUIRED, Options, Part, options
from contourlab.errors import ParameterError, refuse

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

    from contourlab.rendering.stages import Stages

AnswerT = TypeVar("AnswerT")


@dataclass(frozen=True)
class Session:
    """What a question knows about where it is asked.

    Attributes
    ----------
    saving : mapping
        How its answer will be saved: the keywords of `Answer.save`, and ``out``, the folder; empty if it may not be.
    progress : bool
        Whether to show a bar.
    command : str
        The command, as typed; a question that is asked in Python gets the one that does the same, none if it is about objects.
    """

    saving: Mapping[str, Any] = field(default_factory=dict)
    progress: bool = False
    command: str = ""
    _held: ExitStack = field(default_factory=ExitStack)
    _bar: ExitStack = field(default_factory=ExitStack)

    def __enter__(self) -> Session:
        self._held.push(self._bar)
        return self

    def __exit__(self, *error: Any) -> None:
        self._held.__exit__(*error)

    @property
    def folder(self) -> Path:
        """The folder of the answer; one that never exists if the answer may not be saved."""
        return Path(self.saving.get("out", os.devnull))

    def hold(self, context: AbstractContextManager[Any]) -> None:
        """Keep a context until the answer is saved."""
        self._held.enter_context(context)

    def will_write(self, inputs: Iterable[str | os.PathLike[str]], *names: str, pictures_only: bool = False) -> None:
        """Refuse, before the work, to replace inputs or foreign files, and what cannot be written.

        Parameters
        ----------
        inputs : iterable of str or Path
            Files that the question reads.
        names : str
            Files that the answer writes into the folder for certain, the summary first.
        pictures_only : bool
            Whether pictures are all that it writes there.

        Raises
        ------
        ParameterError, OutputError
            See `contourlab.app.results.check_folder`.
        """
        from contourlab.app.results import check_file, check_folder  # the help does without

        if self.saving.get("write") is not None:
            check_file(self.saving["write"], inputs)
        if "out" in self.saving and (self.saving.get("plots") or not pictures_only):
            check_folder(self.saving["out"], *names, inputs=inputs)

    def stages(self) -> Stages:
        """Return the stages of the work; they are shown until the session is closed, or asked for new ones."""
        from contourlab.rendering.stages import shown

        self._bar.close()
        return self._bar.enter_context(shown(self.progress))

    def line(self, text: str) -> None:
        """Show a line of progress, at a terminal."""
        if self.progress:
            sys.stderr.write(text + "\n")

    def close(self) -> None:
        """Show no stages any more."""
        self._bar.close()


def interrupt(note: str = "") -> KeyboardInterrupt:
    """Return an interrupt that says what is kept, if anything."""
    end = KeyboardInterrupt()
    if note:
        end.add_note(note)
    return end


QUIET = Session()
"""Of a question that is asked in Python."""


class Answer:
    """What a question returns: figures, findings, and perhaps a verdict. Its fields are its JSON."""

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if "save" in vars(cls):
            cls.save = _stamping(cls.save)  # type: ignore[method-assign]

    def _cited(self) -> tuple[list[Any], set[str]]:
        """Return what it is about, and the words of the place of its class, the name of its question among them."""
        return [*vars(self).get("_made_from", ()), *vars(self).values()], set(type(self).__module__.split("."))

    def stamp(self) -> str:
        """Return the line that its files hold: what made them."""
        from contourlab.app.cite import stamp_of  # the help does without

        return stamp_of(self)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Return what JSON has under a key that is no attribute, as ``scheme`` of ``case.name``."""
            if name == "findings":
                return ()  # of an answer that has none
            path = vars(type(self)).get("json_form", {}).get(name, name)
            # Asked again, so that an error inside a property of this name is raised as it is.
            return object.__getattribute__(self, name) if path == name else attrgetter(path)(self)

    @property
    def text(self) -> str:
        """The answer for the terminal."""
        raise NotImplementedError

    def __str__(self) -> str:
        return self.text

    @property
    def exit_code(self) -> int:
        """Exit code of the command: 1 if a verdict failed."""
        return 1 if getattr(self, "passed", True) is False else 0

    @property
    def stopped(self) -> BaseException | None:
        """What ended the work early, if anything: the command raises it after it has printed."""
        return None

    SILENT: ClassVar[bool] = False
    """Whether the interrupt of a partial answer says all of it."""

    @property
    def asides(self) -> Sequence[object]:
        """What the command prints on standard error."""
        return ()

    @property
    def json(self) -> Any:
        """What the command prints as JSON."""
        return self

    def to_json(self) -> str:
        """Return the answer as strict JSON, without NaN or infinity, as ``--json`` prints it."""
        from contourlab.app.json_values import json_text, signed  # the help does without
        from contourlab.result.stamp import stamped

        with stamped(self.stamp()):
            return signed(json_text(self.json))

    ROWS: ClassVar[str] = ""
    """The field whose items are the rows of its table; by default the answer is a single row."""

    @property
    def rows(self) -> Sequence[dict[str, Any]]:
        """The answer as rows of a table, in SI."""
        from contourlab.app.json_values import json_values

        return list(map(json_values, getattr(self, self.ROWS) if self.ROWS else [self]))

    def to_pandas(self) -> pandas.DataFrame:
        """Return the answer as a table, in SI."""
        import pandas

        return pandas.json_normalize(list(self.rows))

    def _latex_tables(self) -> Sequence[Any]:
        """Return the tables of the answer: those of its text."""
        from contourlab.rendering.table import tables_of

        return tables_of(lambda: self.text)

    def to_latex(self) -> str:
        """Return the tables that the answer prints as LaTeX, lengths in um, for the package booktabs; a comment says what made them."""
        return "\n\n".join([f"% {self.stamp()}", *(table.latex() for table in self._latex_tables())]) + "\n"

    def _charts(self) -> Iterator[Any]:
        yield from getattr(self, "charts", ())

    def _pictures(self) -> Iterator[Any]:
        """Yield what the viewer draws."""
        from contourlab.rendering.message import Drawn

        yield from (chart for chart in self._charts() if isinstance(chart, Drawn))

    def plot(self, ax: matplotlib.axes.Axes | None = None, *, key: str = "", width: float | str | None = None) -> matplotlib.axes.Axes:
        """Draw a picture of the answer.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; by default on a new figure. A ball-bar plot and small multiples replace plain axes.
        key : str
            Which picture; by default the first.
        width : float > 0 [mm], or str, optional
            Width of a new figure for print: ``"column"`` (88.9 mm) and ``"page"`` (181 mm) are those of IEEE's journals. All letters have
            8 pt, and lines of different colours have different dashes. ``plot(...).figure.savefig("name.pdf")`` embeds the letters.

        Returns
        -------
        matplotlib.axes.Axes
        """
        from contourlab.rendering.matplotlib_view import draw_chart
        from contourlab.result.stamp import stamped

        with stamped(self.stamp()):
            return draw_chart(self._charts(), key, ax, width)

    def _draw(self, stage: Path, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
        """Write the pictures into ``plots`` in a temporary folder; return the files that they will be in `folder`."""
        if not formats:
            return ()
        from contourlab.rendering.plots import write_charts

        files = write_charts(self._charts(), stage / "plots", tuple(formats))
        return tuple(Path(folder) / file.relative_to(stage) for file in files)

    def _put(self, folder: str | Path, plots: Sequence[str], inputs: Iterable[str | os.PathLike[str]], *summary: str) -> tuple[Path, ...]:
        """Write pictures, and the answer as JSON if a `summary` is named, into a folder; return the pictures."""
        from contourlab.app.json_values import write_json
        from contourlab.app.results import staged

        if not plots and not summary:
            return ()
        with staged(folder, *summary, inputs=inputs) as stage:
            for name in summary:
                write_json(stage / name, self)
            return self._draw(stage, folder, plots)

    def save(self, folder: str | Path = "results") -> Any:
        """Write the files of the answer into a folder, if it has any; return the answer with their names."""
        return self

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Return the words of the command to type next, without the name of the program; words that are None go with the one before."""
        return None

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(self.text)}</pre>"


def _stamping(save: Callable[..., Any]) -> Callable[..., Any]:
    """Let every file that an answer saves say what made it."""

    @wraps(save)
    def saved(self: Answer, *args: Any, **kwargs: Any) -> Any:
        from contourlab.result.stamp import stamped

        with stamped(self.stamp()):
            answer = save(self, *args, **kwargs)
        vars(answer).update(_made_from=vars(self).get("_made_from", ()))
        return answer

    return saved


def _asked(ask: Callable[..., AnswerT], *inputs: Any, **given: Any) -> AnswerT:
    """Ask, and let the answer know what it is about."""
    from contourlab.result.stamp import gathered

    with gathered() as told:
        answer = ask(*inputs, **given)
    vars(answer)["_made_from"] = tuple(told)
    return answer


def question(settings: type[Options], name: str = "") -> Callable[[Callable[..., AnswerT]], Callable[..., AnswerT]]:
    """Make a public function of a question: its keywords are the options of `settings`; it writes no file and prints nothing."""

    def made(ask: Callable[..., AnswerT]) -> Callable[..., AnswerT]:
        @wraps(ask)
        def asked(*inputs: Any, **options: Any) -> AnswerT:
            chosen = options.pop("settings", None)
            _check_inputs(asked.__signature__.bind(*inputs, **options), own)  # type: ignore[attr-defined]
            direct = {key: options.pop(key) for key in keys if key in options}
            chosen = chosen or settings(**options)
            files = [os.fspath(each) for each in inputs if isinstance(each, str | os.PathLike)]  # a log that is read has its name
            words = ["contourlab", name or ask.__name__, *files, *chosen.words()]
            with Session(command=as_typed(words) if len(files) == len(inputs) and chosen.is_typed else "") as session:
                return _asked(ask, *inputs, **direct, settings=chosen, session=session)

        own = [each for each in inspect.signature(ask).parameters.values() if each.name not in ("settings", "session")]
        keys = [each.name for each in own if each.kind is inspect.Parameter.KEYWORD_ONLY]
        keywords = [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_default(part), annotation=annotation(part))
            for name, part in settings.PARTS.items()
        ]
        returns = inspect.signature(ask).return_annotation
        asked.__signature__ = inspect.Signature([*own, *keywords], return_annotation=returns)  # type: ignore[attr-defined]
        asked.__annotations__ = {each.name: each.annotation for each in (*own, *keywords)} | {"return": returns}
        asked.__doc__ = documented(inspect.getdoc(ask) or "", settings)
        asked.ask = ask  # type: ignore[attr-defined]
        return asked

    return made


def _check_inputs(bound: inspect.BoundArguments, own: Iterable[inspect.Parameter]) -> None:
    """Refuse inputs of no use: none at all, or something else than a file where one is asked for."""
    for one in own:
        several = one.kind is inspect.Parameter.VAR_POSITIONAL
        given = bound.arguments.get(one.name, ())
        refuse(several and not given, ParameterError, one.name, "none", "at least one")
        for value in (given if several else [given]) if "str | Path" in one.annotation else ():
            if not isinstance(value, str | os.PathLike) and type(value).__name__ not in one.annotation:
                raise ParameterError(one.name, type(value).__name__, one.annotation.replace(" | ", " or "))


def _default(part: Part) -> Any:
    return inspect.Parameter.empty if part.default is REQUIRED else part.default


def annotation(part: Part) -> str:
    """Return the type of an option in Python, as text."""
    kind = "str | Path" if part.kind is Path else part.kind.__name__
    kind += f" | {part.option.objects}" if part.option.objects else ""
    if part.many:
        return f"{kind} | Sequence[{kind}]"
    return f"{kind} | None" if part.default is None else kind


def documented(text: str, settings: type[Options]) -> str:
    """Add the options to the docstring of a question, in NumPy form."""
    lines = []
    for name, part in settings.PARTS.items():
        kind = annotation(part).replace(" | None", "").replace(" | ", " or ").replace("Sequence[", "sequence of ").replace("]", "")
        least = f", {part.option.bound}" if part.option.bound else ""
        unit = f" [{part.option.unit}]" if part.option.unit else ""
        optional = ", optional" if part.default is None else ""
        choices = f" One of {', '.join(part.option.choices)}." if part.option.choices else ""
        lines += [f"{name} : {kind}{unit}{optional}", f"    {part.option.help}{least and f' {part.option.bound}.'}{choices}"]
    head, mark, rest = text.partition("\n\nReturns\n")
    return f"{head}\n" + "\n".join(lines) + mark + rest


class Command:
    """A question on the command line.

    Attributes
    ----------
    ask : str
        Its function, as ``module:function``.
    settings : type of Options
        Its options; the docstring is the help.
    files : type of Options
        Its arguments, and where and how it is saved; several are one.
    """

    def __init__(self, ask: str, settings: type[Options], *files: type[Options]) -> None:
        self.ask, self.settings = ask, settings
        self.files: type[Options] = files[0] if len(files) == 1 else options(type("Files", files, {}))

    @property
    def help(self) -> str:
        """The help of the command."""
        return inspect.getdoc(self.settings) or ""


@dataclass(frozen=True)
class Commands:
    """A group of commands; `default` may be left out on the command line."""

    help: str
    members: dict[str, Command]
    default: str = ""


@dataclass(frozen=True)
class Asked:
    """A question as it was typed.

    Attributes
    ----------
    name : str
        Name of the command.
    settings, files : Options
    words : tuple of str
        All words after the name of the program.
    """

    name: str
    settings: Any
    files: Any
    words: tuple[str, ...] = ()
    inputs: tuple[Any, ...] = field(default=())

    @property
    def given(self) -> list[object]:
        """The inputs, and the options that change what they mean: for another command about the same."""
        parts = [(key, self.settings.PARTS[key]) for key in ("machine", "set", "plugin") if key in self.settings.PARTS]
        return [*self.inputs, *(word for key, part in parts for word in part.words(getattr(self.settings, key)))]

    def again(self, *more: str, without: str = "") -> list[str]:
        """Return the command as typed, with more words or without one."""
        return [*(word for word in self.words if word != without), *more]


def execute(command: Command, name: str, values: dict[str, Any], words: Sequence[str], progress: bool) -> tuple[Any, Asked]:
    """Ask a question as a command does: ask, then save; return the answer and how it was asked."""
    module, _, function = command.ask.partition(":")
    settings, files = (kind(**{key: values[key] for key in kind.PARTS}) for kind in (command.settings, command.files))
    of_files = command.files.PARTS
    inputs: list[Any] = []
    for key, part in of_files.items():
        if part.option.argument:
            inputs += getattr(files, key) if part.many else [getattr(files, key)]
    saving = {key: getattr(files, key) for key, part in of_files.items() if not part.option.argument and key != "as_json"}
    typed = as_typed(["contourlab", *name.split(), *(str(each) for each in inputs if each is not None), *settings.words()])
    ask = getattr(import_module(module), function)
    with Session(saving, progress, typed) as session:
        answer: Any = _asked(getattr(ask, "ask", ask), *inputs, settings=settings, session=session)
        if "out" in saving:
            answer = answer.save(saving["out"], **{key: value for key, value in saving.items() if key != "out"})
        elif saving:
            answer = answer.save(**saving)
    return answer, Asked(name, settings, files, tuple(words), tuple(inputs))
