"""Run a function of the scalar language over graph values: what is known now is computed now, the rest becomes operations.

Tuples, named tuples, closures and whole numbers are Python's own and leave no trace. Numbers and conditions that are not known become
operations. An ``if`` over them becomes a branch. A ``while``, a ``for`` over a range that it may leave, and a long ``for`` that does not
use its index become loops; any other ``for`` is written out.
"""

from __future__ import annotations

import ast
import builtins
import inspect
import math
import operator as operators
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from types import FunctionType
from typing import Any

from contourlab import primitives as language
from contourlab.engine.translate.graph import COMPARED, CONDITION, FOLDED, NUMBER, UNSET, WHOLE, Block, Graph, MismatchError, Op
from contourlab.engine.translate.outer import Outer, Reads, attribute, file_of, positional, tree_of
from contourlab.errors import EngineError, error_text, refuse

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
            raise MismatchError(f"{wanted} may have no value here: give it one before the if or the loop")
        return value


@cache
def _names(tree: ast.AST, context: type[ast.expr_context] = ast.expr_context) -> frozenset[str]:
    """Return the names of a tree: all, or those that it assigns to."""
    return frozenset(node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, context))


def assigned(*trees: ast.AST) -> list[str]:
    """Return the names that trees assign to."""
    return sorted(frozenset().union(*(_names(tree, ast.Store) for tree in trees)))


@cache
def _returns(tree: ast.AST) -> bool:
    """Return whether a statement returns; a function that it defines does not count."""
    inner = () if isinstance(tree, (ast.FunctionDef, ast.Lambda)) else ast.iter_child_nodes(tree)
    return isinstance(tree, ast.Return) or any(map(_returns, inner))


def _exits(statements: Sequence[ast.stmt], by: tuple[type[ast.stmt], ...] = (ast.Break, ast.Continue, ast.Return)) -> bool:
    """Return whether statements may end a round of the loop around them."""
    return any(
        isinstance(one, by)
        or (isinstance(one, ast.If) and _exits([*one.body, *one.orelse], by))
        or (isinstance(one, (ast.For, ast.While)) and ((ast.Return in by and _returns(one)) or _exits(one.orelse, by)))
        for one in statements
    )


@cache
def _after(loop: ast.For | ast.While, inside: bool) -> list[ast.stmt]:
    """Return the statements that follow a loop: what it returned is returned, or ends the loop `inside` of which it is, and its else."""
    returned = ast.Break() if inside else ast.Return(ast.Name(_VALUE, ast.Load()))
    endless = isinstance(loop, ast.While) and getattr(loop.test, "value", 0) == 1 and not _exits(loop.body, (ast.Break,))  # while True
    made: list[ast.stmt] = [returned if endless else ast.If(ast.Name(_RETURNED, ast.Load()), [returned], [])]
    made = made if any(map(_returns, loop.body)) else []
    made += [ast.If(ast.Name(_ENDED, ast.Load()), loop.orelse, [])] if loop.orelse else []
    return [ast.fix_missing_locations(ast.copy_location(one, loop)) for one in made]


def _binds(*trees: ast.AST) -> None:
    """Refuse ``:=`` where it does not always run."""
    found = any(isinstance(node, ast.NamedExpr) for tree in trees for node in ast.walk(tree))
    refuse(found, MismatchError, "a := that does not always run, or runs in a loop: give the name its value on a line before")


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
    refuse(len(values) != len(targets), MismatchError, f"{len(values)} values for {len(targets)} names")
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


def last_of(arguments: ast.arguments, values: Sequence[Any]) -> list[tuple[str, Any]]:
    """Return the defaults of the last positional arguments, with their names."""
    names = positional(arguments)
    return [*zip(names[len(names) - len(values) :], values, strict=True)]


def is_numeric(value: Any) -> bool:
    """Return whether a value is a number, a condition, or a tuple of them."""
    types = (NUMBER, WHOLE, CONDITION)
    return all(isinstance(leaf, (int, float)) or (isinstance(leaf, Op) and leaf.type in types) for leaf in flat([value]))


def has_unset(value: Any) -> bool:
    """Return whether a value or an item of it is `UNSET`."""
    return value is UNSET or (isinstance(value, tuple) and any(map(has_unset, value)))


def flat(values: Iterable[Any]) -> list[Any]:
    """Return the numbers and conditions within tuples, in order."""
    return [leaf for value in values for leaf in (flat(value) if isinstance(value, tuple) else [value])]


def shaped(shapes: Iterable[Any], leaves: Sequence[Any]) -> list[Any]:
    """Return leaves in the tuples that they came from."""
    rest = iter(leaves)

    def shape(like: Any) -> Any:
        if not isinstance(like, tuple):
            return next(rest)
        items = [shape(item) for item in like]
        return type(like)(*items) if hasattr(like, "_fields") else tuple(items)

    return [shape(like) for like in shapes]


NOTHING: Any = object()
"""What a body returns that ends without a return."""
_ARITHMETIC = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
_SIGNS = {ast.Lt: "<", ast.Gt: ">", ast.LtE: "<=", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}
_INSTEAD = {
    "fix": "trunc of math",
    "where": "select of contourlab.primitives",
    "add": "+",
    "sub": "-",
    "power": "**",
    "square": "x*x",
    **dict.fromkeys(("sum", "fsum"), "dot of contourlab.primitives, or + in a loop; they round after each term"),
    "hypot": "sqrt(a*a + b*b)",
    **{f"arc{name}": f"a{name} of math" for name in ("tan", "sin", "cos", "tan2")},
    **{f"log{base}": f"log(x, {base}.0) of math" for base in (2, 10)},
    "sorted": "min and max",
    "map": "tuple(f(v) for v in values)",
    **dict.fromkeys(("array", "asarray"), "a tuple"),
    "float64": "float",
    "random": "uniform of contourlab.primitives",
    **dict.fromkeys(("gauss", "normalvariate"), "normal of contourlab.primitives"),
}
"""Functions that a step cannot call, and what it uses instead: the last digit of `numpy.sin` depends on the processor, that of `hypot` and
`sum` on the version of Python."""
_OWN = (language.__file__, __file__.removesuffix("evaluate.py"))
"""Where functions begin that stand for operations."""
_DEEPEST = 60
"""Most calls within each other: more is a recursion."""
_PYTHON: dict[type, Callable[[Any, Any], Any]] = {
    **{kind: FOLDED[name] for kind, name in _ARITHMETIC.items()},
    **{kind: COMPARED[sign] for kind, sign in _SIGNS.items()},
    ast.FloorDiv: operators.floordiv,
    ast.Mod: operators.mod,
    ast.Pow: operators.pow,
    ast.BitAnd: operators.and_,
    ast.BitOr: operators.or_,
    ast.BitXor: operators.xor,
    ast.Is: operators.is_,
    ast.IsNot: operators.is_not,
    ast.In: lambda a, b: a in b,
    ast.NotIn: lambda a, b: a not in b,
}


_WRITTEN_OUT = 4
"""Most rounds of a ``for`` that are written out although it could be a loop."""
_ON, _ENDED, _RETURNED, _VALUE = "the loop goes on", "the loop has ended", "a loop has returned", "what a loop has returned"
"""Names of the conditions that a round met no break, that a loop ended without one, and that one returned, and of what it returned."""


class Evaluator:
    """Evaluates expressions and runs the bodies of functions.

    Parameters
    ----------
    graph : Graph
        Receives the operations.
    primitives : mapping
        Python functions that become operations: function -> ``made(evaluator, *values)``.
    reads : Reads, optional
        Records the outer values that functions read.
    """

    def __init__(self, graph: Graph, primitives: Mapping[Any, Callable[..., Any]], reads: Reads | None = None) -> None:
        self.graph, self.primitives, self.reads = graph, primitives, reads or Reads()
        self._depth = 0
        self._returned: list[Any] = []

    def call(self, function: Any, args: Sequence[Any], named: Mapping[str, Any] | None = None) -> Any:
        """Return the value of a function over graph values.

        Raises
        ------
        EngineError
            If the function uses what cannot be translated; names file and line.
        """
        outer = self.reads.of(function) if isinstance(function, FunctionType) else function
        function = outer.value if isinstance(outer, Outer) else function
        try:
            primitive = self.primitives.get(function)
        except TypeError:
            primitive = None
        if primitive is not None:
            if isinstance(function, FunctionType) and (named or len(args) != function.__code__.co_argcount):
                args, named = [*bound(tree_of(function).args, {}, args, named or {}).values()], None
            try:
                return primitive(self, *args, **(named or {}))
            except TypeError as error:
                said = f"{function.__name__} cannot be called so here: give numbers alone, no key, default or digits"
                raise MismatchError(said) from error
        if isinstance(function, Closure):
            around = function.around.origin
            frame = Frame(function.around.file, lambda name: around.now.name(name), function.around.title)
            frame.env = bound(function.node.args, function.defaults, args, named or {})
            return self._run(function.node, frame)
        if isinstance(function, FunctionType):
            frame = Frame(file_of(function), outer.name, function.__qualname__)
            node = tree_of(function)
            # Without defaults all arguments are given, whatever defaults it gets later.
            defaults = last_of(node.args, outer.attribute("__defaults__") if function.__defaults__ else ())
            defaults += (outer.attribute("__kwdefaults__") if function.__kwdefaults__ else {}).items()
            frame.env = bound(node.args, dict(defaults), args, named or {})
            return self._run(node, frame)
        if isinstance(outer, Outer) and isinstance(function, type) and issubclass(function, tuple):
            return outer.made(args, named or {})
        return self._builtin(function, args, named or {})

    def _builtin(self, function: Any, args: Sequence[Any], named: Mapping[str, Any]) -> Any:
        """Call what shapes tuples and loops; numbers are for `contourlab.primitives` alone."""
        unknown = any(isinstance(arg, Op) for arg in flat(args))
        if function is float:
            return self.graph.number(args[0]) if unknown else float(args[0])
        if function in (tuple, zip, enumerate, reversed):
            return tuple(function(*args, **named))
        if function is len or (function is range and not unknown):
            return function(*args, **named)
        if function is range:
            raise MismatchError("range of a number known only in the run: loop over a fixed range, and break")
        raise MismatchError(self._refused(function))

    def _refused(self, function: Any) -> str:
        """Return the message about a function that a step cannot call."""
        name, module = getattr(function, "__name__", repr(function)), getattr(function, "__module__", None)
        twins = [f"{name}{of}" for place, of in ((math, " of math"), (builtins, "")) if getattr(place, name, None) in self.primitives]
        other = f"{name} of contourlab.primitives" if name in language.__all__ else "the functions of contourlab.primitives, or your own"
        instead = _INSTEAD.get(name, [*twins, other][0])
        return f"{'' if module in (None, 'builtins') else f'{module}.'}{name} cannot be called here: use {instead}"

    def _run(self, node: Any, frame: Frame) -> Any:
        self._depth += 1
        try:
            refuse(self._depth > _DEEPEST, MismatchError, "a function calls itself")
            if isinstance(node, ast.Lambda):
                return self.expression(node.body, frame)
            found = self.body(node.body, frame)
            return None if found is NOTHING else found
        except EngineError:
            raise
        except Exception as error:  # Python itself may refuse what it computes now
            said = str(error) if isinstance(error, MismatchError) else error_text(error)
            if frame.file.startswith(_OWN):
                raise MismatchError(f"{frame.title.strip('_')}: {said}") from error  # the line that calls a primitive is at fault
            raise EngineError(f"{frame.title}: {said}", file=frame.file, line=getattr(error, "line", node.lineno)) from error
        finally:
            self._depth -= 1

    def expression(self, tree: ast.expr, frame: Frame) -> Any:
        """Return the value of an expression."""
        handler = getattr(self, f"_{type(tree).__name__.lower()}", None)
        if handler is None:
            raise MismatchError(f"a step cannot use {words_of(tree)}")
        return handler(tree, frame)

    def _constant(self, tree: ast.Constant, frame: Frame) -> Any:
        return tree.value

    def _name(self, tree: ast.Name, frame: Frame) -> Any:
        return frame.name(tree.id)

    def _attribute(self, tree: ast.Attribute, frame: Frame) -> Any:
        value = self.expression(tree.value, frame)
        try:
            return attribute(value, tree.attr)
        except AttributeError as error:
            known = getattr(value, "_fields", None)
            there = "" if known is None else f"; {ast.unparse(tree.value)} has: {', '.join(known) or 'nothing'}"
            raise MismatchError(f"no {tree.attr!r} here{there}") from error

    def _binop(self, tree: ast.BinOp, frame: Frame) -> Any:
        return self.operation(tree.op, self.expression(tree.left, frame), self.expression(tree.right, frame))

    def operation(self, operator: ast.operator, a: Any, b: Any) -> Any:
        """Return the result of an operator; of plain values as Python computes it."""
        if not isinstance(a, Op) and not isinstance(b, Op) and type(operator) in _PYTHON:
            return _PYTHON[type(operator)](a, b)
        if type(operator) in _ARITHMETIC:
            return self.graph.arithmetic(_ARITHMETIC[type(operator)], a, b)
        refuse(type(operator) not in _PYTHON, MismatchError, f"a step cannot use {words_of(operator)}")
        return self.primitives[_PYTHON[type(operator)]](self, a, b)

    def _unaryop(self, tree: ast.UnaryOp, frame: Frame) -> Any:
        value = self.expression(tree.operand, frame)
        if isinstance(tree.op, ast.Not):
            return self.graph.logic("not", self.graph.condition(value))
        if isinstance(tree.op, ast.USub):
            return self.graph.arithmetic("fneg", value) if isinstance(value, Op) else -value
        refuse(isinstance(tree.op, ast.Invert), MismatchError, "~ of a condition is true in Python, whatever it is: use not")
        return value

    def _compare(self, tree: ast.Compare, frame: Frame) -> Any:
        left, held = self.expression(tree.left, frame), None
        for operator, item in zip(tree.ops, tree.comparators, strict=True):
            right = self.expression(item, frame)
            one = self._compared(operator, left, right)
            held = one if held is None else self.graph.logic("and", held, one)
            left = right
        return held

    def _compared(self, operator: ast.cmpop, left: Any, right: Any) -> Any:
        if type(operator) in _SIGNS and (isinstance(left, Op) or isinstance(right, Op)):
            return self.graph.compare(_SIGNS[type(operator)], left, right)
        if isinstance(operator, (ast.In, ast.NotIn)) and isinstance(right, tuple) and any(isinstance(v, Op) for v in (left, *right)):
            found: Any = False
            for item in right:
                found = self.graph.logic("or", found, self.graph.compare("==", left, item))
            return found if isinstance(operator, ast.In) else self.graph.logic("not", found)
        if any(isinstance(v, Op) for v in flat((left, right))) and not (left is None or right is None):
            raise MismatchError(f"{words_of(operator)} of values that are not known: compare numbers one by one, with ==")
        return _PYTHON[type(operator)](left, right)

    def _boolop(self, tree: ast.BoolOp, frame: Frame) -> Any:
        """Return the value that Python returns; what follows is computed only where it decides."""

        def value(parts: Sequence[ast.expr]) -> Any:
            held = self.expression(parts[0], frame)
            if len(parts) == 1:
                return held
            test = self.graph.condition(held)
            if isinstance(test, Op):
                _binds(*parts[1:])
            if isinstance(tree.op, ast.And):
                return self.one_of(test, lambda: value(parts[1:]), lambda: held)
            return self.one_of(test, lambda: held, lambda: value(parts[1:]))

        return value(tree.values)

    def _ifexp(self, tree: ast.IfExp, frame: Frame) -> Any:
        test = self.graph.condition(self.expression(tree.test, frame))
        if isinstance(test, Op):
            _binds(tree.body, tree.orelse)
        return self.one_of(test, lambda: self.expression(tree.body, frame), lambda: self.expression(tree.orelse, frame))

    def _namedexpr(self, tree: ast.NamedExpr, frame: Frame) -> Any:
        frame.env[tree.target.id] = value = self.expression(tree.value, frame)
        return value

    def one_of(self, test: Any, then: Callable[[], Any], other: Callable[[], Any]) -> Any:
        """Return the value of one of two sides, which must be of one kind."""
        value = self.graph.branch(test, then, other)
        refuse(has_unset(value), MismatchError, "the two sides of an if give values of different kinds")
        return value

    def _tuple(self, tree: ast.Tuple, frame: Frame) -> Any:
        return tuple(self._items(tree.elts, frame))

    def _items(self, trees: Iterable[ast.expr], frame: Frame) -> Any:
        for item in trees:
            if isinstance(item, ast.Starred):
                yield from self.expression(item.value, frame)
            else:
                yield self.expression(item, frame)

    def _subscript(self, tree: ast.Subscript, frame: Frame) -> Any:
        value = self.expression(tree.value, frame)
        if isinstance(tree.slice, ast.Slice):
            parts = (tree.slice.lower, tree.slice.upper, tree.slice.step)
            return tuple(value)[slice(*(None if part is None else self.expression(part, frame) for part in parts))]
        index = self.expression(tree.slice, frame)
        refuse(isinstance(index, Op), MismatchError, "an index that is not known: use lookup of contourlab.primitives")
        return value[index]

    def _call(self, tree: ast.Call, frame: Frame) -> Any:
        function = self.expression(tree.func, frame)
        args = list(self._items(tree.args, frame))
        named: dict[str, Any] = {}
        for word in tree.keywords:
            value = self.expression(word.value, frame)
            named |= value if word.arg is None else {word.arg: value}
        frame.origin.now = frame  # a function defined here sees the names as they are now
        return self.call(function, args, named)

    def closure(self, node: ast.FunctionDef | ast.Lambda, frame: Frame) -> Closure:
        """Return a function defined inside another one."""
        refuse(getattr(node, "decorator_list", ()), MismatchError, "a step cannot use a decorator")
        given = node.args
        pairs = last_of(given, given.defaults)
        pairs += [(arg.arg, value) for arg, value in zip(given.kwonlyargs, given.kw_defaults, strict=True) if value is not None]
        return Closure(node, frame, {name: self.expression(value, frame) for name, value in pairs})

    _lambda = closure

    def _generatorexp(self, tree: ast.GeneratorExp, frame: Frame) -> Any:
        made: list[Any] = []
        _binds(tree)

        def fill(depth: int, own: Frame) -> None:
            if depth == len(tree.generators):
                made.append(self.expression(tree.elt, own))
                return
            part = tree.generators[depth]
            for item in self.expression(part.iter, own):
                inner = own.copy()
                assign(part.target, item, inner.env)
                if all(self.expression(test, inner) for test in part.ifs):
                    fill(depth + 1, inner)

        fill(0, frame.copy())
        return tuple(made)

    # --- statements

    def body(self, statements: Sequence[ast.stmt], frame: Frame) -> Any:
        for i, statement in enumerate(statements):
            try:
                if isinstance(statement, ast.Return):
                    return self.expression(statement.value, frame) if statement.value else None
                if isinstance(statement, ast.If):
                    found = self._if(statement, statements[i + 1 :], frame)
                    if found is not NOTHING:
                        return found[0]
                    continue
                self._statement(statement, frame)
                if isinstance(statement, (ast.For, ast.While)) and _after(statement, False):
                    return self.body([*_after(statement, False), *statements[i + 1 :]], frame)
            except Exception as error:
                if not hasattr(error, "line"):
                    error.line = statement.lineno  # type: ignore[attr-defined]
                raise
        return NOTHING

    def _if(self, statement: ast.If, rest: Sequence[ast.stmt], frame: Frame) -> Any:
        """Run an if; return a tuple of the returned value if a side returns, else `NOTHING`."""
        test = self.graph.condition(self.expression(statement.test, frame))
        # The statements after an if that returns belong to the side that goes on.
        if not isinstance(test, Op):
            part = statement.body if test else statement.orelse
            found = self.body([*part, *rest] if _returns(statement) else part, frame)
            return (found,) if _returns(statement) else NOTHING
        if _returns(statement):

            def side(part: Sequence[ast.stmt]) -> Any:
                found = self.body([*part, *rest], frame.copy())
                refuse(found is NOTHING, MismatchError, "one side of an if returns, the other does not")
                return found

            return (self.one_of(test, lambda: side(statement.body), lambda: side(statement.orelse)),)
        sides = (lambda own: self.body(statement.body, own)), (lambda own: self.body(statement.orelse, own))
        self._both_sides(test, *sides, assigned(statement), frame)
        return NOTHING

    def _both_sides(
        self, test: Op, then: Callable[[Frame], Any], other: Callable[[Frame], Any], names: Sequence[str], frame: Frame
    ) -> None:
        """Run both sides of an if over copies of the names, and join those that either may change."""

        def outcome(run: Callable[[Frame], Any]) -> tuple[Any, ...]:
            own = frame.copy()
            run(own)
            return tuple(own.env.get(name, UNSET) for name in names)

        joined = self.graph.branch(test, lambda: outcome(then), lambda: outcome(other))
        frame.env.update(zip(names, joined, strict=True))

    def _statement(self, statement: ast.stmt, frame: Frame) -> None:
        if isinstance(statement, ast.Assign):
            value = self.expression(statement.value, frame)
            for target in statement.targets:
                assign(target, value, frame.env)
        elif isinstance(statement, ast.AnnAssign):
            if statement.value is not None:
                assign(statement.target, self.expression(statement.value, frame), frame.env)
        elif isinstance(statement, ast.AugAssign):
            if not isinstance(statement.target, ast.Name):
                assign(statement.target, None, frame.env)  # refuses it
            assert isinstance(statement.target, ast.Name)
            here = frame.name(statement.target.id)
            frame.env[statement.target.id] = self.operation(statement.op, here, self.expression(statement.value, frame))
        elif isinstance(statement, ast.For):
            self._for(statement, frame)
        elif isinstance(statement, ast.While):
            _binds(statement.test)
            self._leaving(
                statement, frame, lambda own: self._loop(statement, own, lambda inner: self.expression(statement.test, inner), None)
            )
        elif isinstance(statement, ast.FunctionDef):
            frame.env[statement.name] = self.closure(statement, frame)
        elif not isinstance(statement, ast.Pass) and not (isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)):
            raise MismatchError(f"a step cannot use {words_of(statement)}")

    # --- loops

    def _for(self, statement: ast.For, frame: Frame) -> None:
        items = self.expression(statement.iter, frame)
        refuse(isinstance(items, Op), MismatchError, "a loop needs a known range or tuple")
        if _exits(statement.body):
            self._leaving(statement, frame, lambda own: self._left(statement, items, own))
            return
        if len(items) > _WRITTEN_OUT and self._repeated(statement, frame, len(items)):
            assign(statement.target, items[-1], frame.env)
        else:
            for item in items:
                assign(statement.target, item, frame.env)
                self.body(statement.body, frame)
        frame.env[_ENDED] = True

    def _leaving(self, statement: ast.For | ast.While, frame: Frame, run: Callable[[Frame], None]) -> None:
        """Run a loop that may be left; if it returns, once more before, apart, to see what kind of value."""
        if any(map(_returns, statement.body)):
            held, self._returned, own = self._returned, [], frame.copy()
            with self.graph.within(Block(self.graph.block)):
                run(own)
            found, self._returned = self._returned, [*held, *self._returned]
            refuse(not is_numeric(tuple(found)), MismatchError, "a return inside a loop needs a number, or a tuple of numbers")
            unknown = [shaped([value], [math.nan] * len(flat([value])))[0] for value in found]
            alike = all(repr(value) == repr(unknown[0]) for value in unknown)
            refuse(not alike, MismatchError, "the returns inside a loop give values of different kinds")
            frame.env |= {_RETURNED: False, _VALUE: unknown[0] if unknown else 0.0}
        run(frame)

    def _left(self, statement: ast.For, items: Any, frame: Frame) -> None:
        """Run a ``for`` that may be left: as a loop over a range if that is possible, else written out."""
        if isinstance(items, range):
            try:
                self._loop(statement, frame, None, items)
                return
            except (MismatchError, EngineError, ValueError):
                pass  # such as an index of a tuple, known where it is written out
        on: Any = True
        for item in items:

            def round_(own: Frame, item: Any = item) -> None:
                assign(statement.target, item, own.env)
                own.env[_ON] = self._until_left(statement.body, own)

            if isinstance(on, Op):
                self._both_sides(on, round_, lambda own: own.env.update({_ON: False}), [*assigned(statement), *_flags(frame)], frame)
            elif on:
                round_(frame)
            on = frame.env.pop(_ON, on)
        frame.env[_ENDED] = on

    def _repeated(self, statement: ast.For, frame: Frame, count: int) -> bool:
        """Make a loop of a ``for`` whose body does not use its index; return whether that is possible."""
        names, own = assigned(*statement.body), frame.copy()
        known = all(is_numeric(frame.env.get(name, UNSET)) for name in names)
        indexed = any(_names(part) & _names(statement.target) for part in statement.body)
        if not known or indexed:
            return False
        shapes = [frame.env[name] for name in names]

        def round_(_: Op, values: Sequence[Op]) -> list[Any]:
            own.env = {**frame.env, **dict(zip(names, shaped(shapes, values), strict=True))}
            self.body(statement.body, own)
            return flat(own.name(name) for name in names)

        try:
            after = self.graph.repeat(count, flat(shapes), round_)
        except (MismatchError, EngineError, ValueError):
            return False  # such as a tuple that grows: written out, it may be possible
        frame.env.update(zip(names, shaped(shapes, after), strict=True))
        return True

    def _loop(self, statement: ast.For | ast.While, frame: Frame, test: Callable[[Frame], Any] | None, items: range | None) -> None:
        """Make a loop of a ``while``, or of a ``for`` over a range that may be left."""
        if items is not None and len(items):
            assign(statement.target, items[0], frame.env)  # type: ignore[union-attr]
        names = [name for name in (*assigned(statement), _RETURNED, _VALUE) if is_numeric(frame.env.get(name, UNSET))]
        shapes = [frame.env[name] for name in names]
        own = frame.copy()

        def enter(values: Sequence[Op]) -> None:
            own.env = {**frame.env, **dict.fromkeys(assigned(statement), UNSET)}
            own.env.update(zip(names, shaped(shapes, values[2:]), strict=True))
            if items is not None:
                assert isinstance(statement, ast.For)
                index = self.graph.arithmetic("fadd", items.start, self.graph.arithmetic("fmul", values[1], items.step))
                assign(statement.target, index, own.env)

        def goes_on(values: Sequence[Op]) -> Any:
            enter(values)
            if items is not None:
                return self.graph.logic("and", values[0], self.graph.compare("<", values[1], float(len(items))))
            assert test is not None
            # After a break the test does not run.
            return self.one_of(values[0], lambda: self.graph.condition(test(own)), lambda: False)

        def round_(_: None, values: Sequence[Op]) -> list[Any]:
            enter(values)
            on = self._until_left(statement.body, own)
            count = self.graph.arithmetic("fadd", values[1], 1) if items is not None else values[1]
            return [on, count, *flat(own.name(name) for name in names)]

        after = self.graph.repeat(goes_on, [True, 0, *flat(shapes)], round_)
        frame.env.update(dict.fromkeys(assigned(statement), UNSET))
        frame.env.update(zip(names, shaped(shapes, after[2:]), strict=True))
        frame.env[_ENDED] = after[0]

    def _until_left(self, statements: Sequence[ast.stmt], frame: Frame) -> Any:
        """Run one round; return whether the loop goes on."""
        for i, statement in enumerate(statements):
            if isinstance(statement, (ast.Break, ast.Continue)):
                return isinstance(statement, ast.Continue)
            if isinstance(statement, ast.Return):
                value = self.expression(statement.value, frame) if statement.value else None
                self._returned.append(value)
                frame.env |= {_RETURNED: True, _VALUE: value}
                return False
            if not _exits([statement]):
                self.body([statement], frame)
                continue
            rest = statements[i + 1 :]
            if isinstance(statement, (ast.For, ast.While)):
                self._statement(statement, frame)
                return self._until_left([*_after(statement, True), *rest], frame)
            assert isinstance(statement, ast.If)
            test = self.graph.condition(self.expression(statement.test, frame))
            if not isinstance(test, Op):
                return self._until_left([*(statement.body if test else statement.orelse), *rest], frame)

            def side(part: Sequence[ast.stmt], rest: Sequence[ast.stmt] = rest) -> Callable[[Frame], None]:
                return lambda own: own.env.update({_ON: self._until_left([*part, *rest], own)})

            names = [*assigned(statement, *rest), *_flags(frame)]
            self._both_sides(test, side(statement.body), side(statement.orelse), names, frame)
            return frame.env.pop(_ON)
        return True


_WORDS: dict[type, str] = {
    **dict.fromkeys((ast.List, ast.ListComp), "a list: use a tuple"),
    **dict.fromkeys((ast.Dict, ast.DictComp), "a dict: use a tuple, or a named tuple"),
    ast.JoinedStr: "an f-string",
    ast.Match: "match: use if and elif",
    ast.Try: "try: nothing is raised here; ask with if before",
    ast.Raise: "raise: return math.nan, and the run stops",
    ast.Assert: "assert: leave it out",
    ast.Delete: "del: leave it out",
    ast.Global: "global: keep what changes in a state",
    **dict.fromkeys((ast.Import, ast.ImportFrom), "an import: write it at the top of the file"),
    ast.MatMult: "@: use dot of contourlab.primitives",
}
"""Constructs that a step cannot use, and what it uses instead."""


def words_of(tree: ast.AST) -> str:
    """Return the name of a construct, as text."""
    if type(tree) in _WORDS:
        return _WORDS[type(tree)]
    if isinstance(tree, ast.Expr):
        return f"{ast.unparse(tree)}, a line without effect on its result: leave it out"
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in type(tree).__name__).strip()


def _flags(frame: Frame) -> list[str]:
    """Return the names that say how a round has ended."""
    return [_ON, *(name for name in (_ENDED, _RETURNED, _VALUE) if name in frame.env)]
