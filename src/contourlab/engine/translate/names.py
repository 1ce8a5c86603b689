"""The names of a running function, and the values behind them."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from contourlab.engine.translate.graph import CONDITION, NUMBER, UNSET, WHOLE, MismatchError, Op

Env = dict[str, Any]


class Closure:
    """A function defined inside another one, with the names around it and the values of its defaults, by name."""

    def __init__(self, node: ast.FunctionDef | ast.Lambda, around: Frame, defaults: Env) -> None:
        self.node, self.around, self.defaults = node, around, defaults


class Frame:
    """The names of a running function, and where its source is.

    A side of a branch and a round of a loop have a copy. `now` of the `origin` is the copy that runs.
    """

    def __init__(self, file: str, outer: Callable[[str], Any], name: str) -> None:
        self.file, self.outer, self.title = file, outer, name
        self.env: Env = {}
        self.origin = self.now = self

    def copy(self) -> Frame:
        """Return a frame with the same names, to be changed apart from this one."""
        made = Frame(self.file, self.outer, self.title)
        made.env, made.origin = dict(self.env), self.origin
        return made

    def name(self, wanted: str) -> Any:
        """Return the value of a name, here or around."""
        value = self.env[wanted] if wanted in self.env else self.outer(wanted)
        if value is UNSET:
            raise MismatchError(f"{wanted} may have no value here")
        return value


def assigned(tree: ast.AST) -> list[str]:
    """Return the names that a tree assigns to."""
    return sorted({node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)})


def assign(target: ast.expr, value: Any, env: Env) -> None:
    """Assign a value to a name, or its items to a tuple of names."""
    if isinstance(target, ast.Name):
        env[target.id] = value
        return
    if not isinstance(target, (ast.Tuple, ast.List)):
        raise MismatchError(f"a step cannot assign to {ast.unparse(target)}: keep it in a name, or in a state")
    values, targets = list(value), list(target.elts)
    for i, item in enumerate(targets):
        if isinstance(item, ast.Starred):
            n = len(values) - len(targets) + 1
            values[i : i + n] = [tuple(values[i : i + n])]
            targets[i] = item.value
            break
    if len(values) != len(targets):
        raise MismatchError(f"{len(values)} values for {len(targets)} names")
    for item, part in zip(targets, values, strict=True):
        assign(item, part, env)


def bound(arguments: ast.arguments, defaults: Env, args: Sequence[Any], named: Mapping[str, Any]) -> Env:
    """Return the values of a function's arguments, by name."""
    made = inspect.Parameter
    takes = [made(name, made.POSITIONAL_OR_KEYWORD, default=defaults.get(name, made.empty)) for name in positional(arguments)]
    takes += [made(arguments.vararg.arg, made.VAR_POSITIONAL)] if arguments.vararg else []
    takes += [made(a.arg, made.KEYWORD_ONLY, default=defaults.get(a.arg, made.empty)) for a in arguments.kwonlyargs]
    try:
        found = inspect.Signature(takes).bind(*args, **named)
    except (TypeError, ValueError) as error:
        raise MismatchError(str(error)) from error
    found.apply_defaults()
    return found.arguments


def positional(arguments: ast.arguments) -> list[str]:
    """Return the names of the arguments that may be given without a name."""
    return [arg.arg for arg in (*arguments.posonlyargs, *arguments.args)]


def last_of(arguments: ast.arguments, values: Sequence[Any]) -> list[tuple[str, Any]]:
    """Return the defaults of the last positional arguments, with their names."""
    names = positional(arguments)
    return [*zip(names[len(names) - len(values) :], values, strict=True)]


def is_numeric(value: Any) -> bool:
    """Return whether a value is a number, a condition, or a tuple of them."""
    if isinstance(value, tuple):
        return all(map(is_numeric, value))
    return isinstance(value, (int, float)) or (isinstance(value, Op) and value.type in (NUMBER, WHOLE, CONDITION))


def has_unset(value: Any) -> bool:
    """Return whether a value or an item of it is `UNSET`."""
    return value is UNSET or (isinstance(value, tuple) and any(map(has_unset, value)))


def flat(values: Iterable[Any]) -> list[Any]:
    """Return the numbers and conditions within tuples, in order."""
    leaves: list[Any] = []
    for value in values:
        leaves += flat(value) if isinstance(value, tuple) else [value]
    return leaves


def shaped(shapes: Iterable[Any], leaves: Sequence[Any]) -> list[Any]:
    """Return leaves in the tuples that they came from."""
    rest = iter(leaves)

    def shape(like: Any) -> Any:
        if not isinstance(like, tuple):
            return next(rest)
        items = [shape(item) for item in like]
        return type(like)(*items) if hasattr(like, "_fields") else tuple(items)

    return [shape(like) for like in shapes]
