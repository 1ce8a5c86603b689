"""What a step reads from outside: global names, closure variables, attributes, items.

The translator folds these values into machine code, so they are part of its key. `Reads` is the one gate through which they come in. It
records each read. Before machine code runs again, the same reads are made again, without a translation.
"""

from __future__ import annotations

import ast
import builtins
import hashlib
import linecache
import operator
from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from functools import cache
from numbers import Real
from types import BuiltinFunctionType, CodeType, FunctionType
from typing import Any, NamedTuple, NoReturn

import numpy as np

from contourlab import primitives
from contourlab.engine.translate.graph import MismatchError, Op
from contourlab.errors import EngineError, refuse

Function = ast.FunctionDef | ast.Lambda
TYPED = "__typed__"
"""Name, in the module of a plug-in, of its file as the user typed it."""


def file_of(function: FunctionType) -> str:
    """Return the file of a function; that of a plug-in as the user typed it."""
    return str(function.__globals__.get(TYPED, function.__code__.co_filename))


def tree_of(function: FunctionType) -> Function:
    """Return the syntax tree of a plain function; its line numbers are those of the file.

    Raises
    ------
    EngineError
        If there is no source, or the file has changed since it was imported.
    """
    code = function.__code__  # another one after a reload in place
    return _tree_of(code, code.co_filename, file_of(function), function.__qualname__)


@cache
def _tree_of(code: CodeType, read: str, file: str, name: str) -> Function:
    line = code.co_firstlineno
    linecache.checkcache(read)  # the file of a plugin may have changed since
    source = "".join(linecache.getlines(read))
    found = [node for node in _functions(source) if _matches(node, code)]
    if len(found) > 1:
        found = [node for node in found if _start(node) == _start_of_code(code)]
    if found and code_words(code) not in _written(source, read):
        raise EngineError(f"{name} has changed in the file since it was imported: import it again", file=file, line=line)
    if len(found) != 1:
        raise EngineError(f"no source of {name}: define it in a file", file=file, line=line)
    return found[0]


@cache
def _written(source: str, file: str) -> list[list[str]]:
    """Return the content of every function that a source defines."""
    return [code_words(code) for code in codes(compile(source, file, "exec", dont_inherit=True))]


@cache
def _functions(source: str) -> list[Function]:
    try:
        tree = ast.parse(source)
    except SyntaxError:  # edited since it was imported
        return []
    return [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.Lambda))]


def _matches(node: Function, code: CodeType) -> bool:
    first = min([node.lineno, *(mark.lineno for mark in getattr(node, "decorator_list", ()))])
    own = first, getattr(node, "name", "<lambda>"), positional(node.args)
    return own == (code.co_firstlineno, code.co_name, list(code.co_varnames[: code.co_argcount]))


def _start(node: Function) -> tuple[int, int]:
    """Return line and column of the first expression in a body."""
    body = node.body if isinstance(node.body, list) else [node.body]
    return min((part.lineno, part.col_offset) for tree in body for part in ast.walk(tree) if isinstance(part, ast.expr))


def _start_of_code(code: CodeType) -> tuple[int, int]:
    return min((line, column) for line, _, column, end in code.co_positions() if line is not None and column is not None and end)


def positional(arguments: ast.arguments) -> list[str]:
    """Return the names of the arguments that may be given without a name."""
    return [arg.arg for arg in (*arguments.posonlyargs, *arguments.args)]


def codes(code: CodeType) -> list[CodeType]:
    """Return a code object and those inside it."""
    return [code, *(inner for constant in code.co_consts if isinstance(constant, CodeType) for inner in codes(constant))]


def code_words(code: CodeType) -> list[str]:
    """Return the content of a code object, without its place in the file."""
    constants = [c if not isinstance(c, CodeType) else code_words(c) for c in code.co_consts]
    return [code.co_code.hex(), repr(constants), repr((code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars))]


Read = tuple[int, str, Any]
"""The number of an outer object, how it is read, and the name or index."""

_SCALARS = frozenset({bool, int, float, complex, str, bytes, type(None)})
_BUILT_IN = (BuiltinFunctionType, np.ufunc, type(np.clip))
_EQUALS: tuple[Any, ...] = (object.__eq__, int.__eq__, float.__eq__, str.__eq__)
"""Comparisons that run no code of the user."""
_digests: dict[int, tuple[CodeType, str]] = {}


class _Record(NamedTuple):
    field: float


_RECORD_WORDS = {*vars(_Record), *vars(type("_", (_Record,), {})), "__annotations__", "__annotations_cache__", "__annotate_func__"}


class Outer:
    """An object outside a step that is more than plain data: a function, a class, a module, an instance.

    A step may call it if it is a function, and read attributes and items. It cannot compute with it as a whole.
    """

    __slots__ = ("number", "reads", "value")
    reads: Reads

    def __init__(self, reads: Reads, value: Any, number: int) -> None:
        self.reads, self.value, self.number = reads, value, number

    def name(self, wanted: str) -> Any:
        """Return the value of a name in a function: of its closure, its module or the builtins."""
        return self.reads.read(self.number, "name", wanted)

    def attribute(self, name: str) -> Any:
        """Return an attribute."""
        return self.reads.read(self.number, "attribute", name)

    def __getitem__(self, index: Any) -> Any:
        if not {type(part) for part in (index if type(index) is tuple else (index,))} <= _SCALARS:
            raise MismatchError(f"an item of {self!r} is read by a number or a text")
        return self.reads.read(self.number, "item", index)

    def made(self, args: Sequence[Any], named: Mapping[str, Any]) -> Any:
        """Return a named tuple of this class."""
        if not _is_record(self.value):
            raise MismatchError(f"{self!r} has methods of its own: write a NamedTuple with fields alone")
        fields, defaults = self.attribute("_fields"), self.attribute("__new__").attribute("__defaults__") or ()
        rest = dict(zip(fields[len(fields) - len(defaults) :], defaults, strict=True))
        return self.value(*args, **named, **{field: rest[field] for field in fields[len(args) :] if field in rest and field not in named})

    @property
    def cure(self) -> str:
        """What to write where a number is needed."""
        if isinstance(self.value, Enum):
            return "write .value behind it"
        return "make it a plain float where it is defined" if isinstance(self.value, Real) else "read numbers from it"

    def __repr__(self) -> str:
        return str(getattr(self.value, "__name__", f"a {type(self.value).__name__}"))

    def __bool__(self) -> bool:
        return True if _always_true(type(self.value)) else self._whole()

    def __eq__(self, other: object) -> bool:
        if any(type(one.value).__eq__ not in _EQUALS for one in (self, other) if isinstance(one, Outer)):
            self._whole()
        return bool(self.value == (other.value if isinstance(other, Outer) else other))

    def __hash__(self) -> int:
        return hash(self.value)

    def _whole(self, *_: Any) -> NoReturn:
        raise MismatchError(f"a step cannot compute with {self!r} as a whole: {self.cure}")

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = __pow__ = __rpow__ = _whole
    __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = __neg__ = __pos__ = __float__ = __index__ = _whole
    __lt__ = __le__ = __gt__ = __ge__ = __iter__ = __len__ = __contains__ = _whole


def attribute(value: Any, name: str) -> Any:
    """Return an attribute of a value in a step."""
    if isinstance(value, Outer):
        return value.attribute(name)
    fields = () if isinstance(value, Op) else getattr(value, "_fields", (name,))
    if name not in fields:  # a method or property of a named tuple reads what it likes
        raise AttributeError(name)
    return getattr(value, name)


class Reads:
    """The outer values that a translation or a look-up has read so far.

    Parameters
    ----------
    roots : sequence of callable
        The functions that the reads begin at.

    Attributes
    ----------
    trace : list of Read
        Plain data, to be filed.
    words : list
        What was read: plain data, the same for the same values alone.
    """

    def __init__(self, roots: Sequence[Any] = ()) -> None:
        self.trace: list[Read] = []
        self.words: list[Any] = []
        self._outers: list[Outer] = []
        self._numbers: dict[int, int] = {}
        self._known: dict[Any, Any] = {}
        for root in roots:
            self.take(root)

    def of(self, function: Any) -> Outer:
        """Return a function that the reads begin at; reads of one that they do not begin at, the translator's own, are not recorded."""
        number = self._numbers.get(id(function))
        return self._outers[number] if number is not None else Reads((function,))._outers[0]

    def read(self, number: int, how: str, name: Any) -> Any:
        """Read from an outer object."""
        key = (number, how, type(name), name)
        if key not in self._known:
            self.trace.append((number, how, name))
            self._known[key] = self.take(_READ[how](self._outers[number].value, name))
        return self._known[key]

    def again(self, trace: Sequence[Read]) -> None:
        """Make recorded reads again."""
        try:
            for number, how, name in trace:
                self.take(_READ[how](self._outers[number].value, name))
        except Exception as error:  # it is gone, or a property fails: translate anew
            self.words.append(("failed", type(error).__name__))

    def take(self, value: Any) -> Any:
        """Note a value; return it as a step may use it: copied, what is more than plain data as an `Outer`."""
        kind, words = type(value), self.words
        if kind in _SCALARS:
            words.append(value)
            return value
        number = self._numbers.get(id(value))
        if number is not None:
            words.append(("again", number))
            return self._outers[number]
        if kind is FunctionType:
            return self._outer(value, _digest(value.__code__), value.__module__ == primitives.__name__)
        if kind in (tuple, list, set, frozenset):
            if _SCALARS.issuperset(map(type, value)):
                words.append((kind.__name__, *value))
                return list(value) if kind is list else value
            refuse(kind in (set, frozenset), MismatchError, "a set of more than numbers and texts: use a tuple")
            words.append((f"{kind.__name__} of", len(value)))
            return kind(map(self.take, value))
        if kind is dict:
            words.append(("dict of", len(value)))
            return {self.take(key): self.take(item) for key, item in value.items()}
        if kind in (range, slice):
            words.append((f"{kind.__name__} of", 3))
            return kind(*map(self.take, (value.start, value.stop, value.step)))
        if (kind is np.ndarray or (issubclass(kind, np.generic) and kind.__module__ == np.__name__)) and not value.dtype.hasobject:
            words.append((kind.__name__, str(value.dtype), value.shape, hashlib.sha256(value.tobytes()).digest()))
            return np.array(value, order="C") if kind is np.ndarray else value
        if _is_record(kind):
            words.append(("record", kind._fields))
            return tuple.__new__(kind, map(self.take, value))
        if kind in _BUILT_IN or (kind is type and getattr(builtins, value.__name__, None) is value):
            words.append(("builtin", getattr(value, "__module__", None), value.__name__))
            return value
        if isinstance(value, type):
            return self._outer(value, value.__qualname__, _is_record(value))
        plain = [base.__repr__(value) for base in (int, float, str) if isinstance(value, base)]
        return self._outer(value, kind.__qualname__, kind.__eq__ in _EQUALS, _always_true(kind), *plain)

    def _outer(self, value: Any, *words: Any) -> Outer:
        self.words.append(("outer", *words))
        self._numbers[id(value)] = len(self._outers)
        self._outers.append(Outer(self, value, len(self._outers)))  # and keep it: a number must not be used twice
        return self._outers[-1]


def _name_in(function: FunctionType, wanted: str) -> Any:
    code = function.__code__
    if wanted in code.co_freevars:
        return (function.__closure__ or ())[code.co_freevars.index(wanted)].cell_contents
    if wanted in function.__globals__:
        return function.__globals__[wanted]
    if hasattr(builtins, wanted):
        return getattr(builtins, wanted)
    raise MismatchError(f"no name {wanted!r}: take it from par, x or inp, or define it")


_READ: dict[str, Callable[[Any, Any], Any]] = {"name": _name_in, "attribute": getattr, "item": operator.getitem}


def _digest(code: CodeType) -> str:
    """Return a digest of the content of a code object; the same object is digested once."""
    if id(code) not in _digests:
        _digests[id(code)] = code, hashlib.sha256(repr(code_words(code)).encode()).hexdigest()
    return _digests[id(code)][1]


def _always_true(kind: type) -> bool:
    return not hasattr(kind, "__bool__") and not hasattr(kind, "__len__")


def _is_record(kind: type) -> bool:
    """Return whether a class is a named tuple that computes as a tuple does."""
    if not issubclass(kind, tuple) or not str(kind.__new__.__module__).startswith("namedtuple_"):
        return False
    own = {name for base in kind.__mro__ if base not in (tuple, object) for name in vars(base) if name[:2] == "__"}
    fields: tuple[str, ...] = getattr(kind, "_fields", ())
    return own <= _RECORD_WORDS and all(type(getattr(kind, field)) is type(_Record.field) for field in fields)
