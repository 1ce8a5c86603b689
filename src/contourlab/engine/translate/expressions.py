"""Expressions and calls of the scalar language over graph values."""

from __future__ import annotations

import ast
import operator as operators
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import FunctionType
from typing import Any

from contourlab import primitives as language
from contourlab.engine.translate.graph import Graph, MismatchError, Op
from contourlab.engine.translate.names import Closure, Frame, assign, bound, flat, has_unset, last_of
from contourlab.engine.translate.outer import Outer, Reads, attribute
from contourlab.engine.translate.source import file_of, tree_of
from contourlab.errors import EngineError, error_text

NOTHING: Any = object()
"""What a body returns that ends without a return."""
_ARITHMETIC = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
_SIGNS = {ast.Lt: "<", ast.Gt: ">", ast.LtE: "<=", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}
_INSTEAD = {
    "max": "maximum",
    "min": "minimum",
    "abs": "fabs",
    "absolute": "fabs",
    "round": "rint",
    "int": "copysign(floor(fabs(x)), x)",
    "trunc": "copysign(floor(fabs(x)), x)",
    "fix": "copysign(floor(fabs(x)), x)",
    "ceil": "-floor(-x)",
    "where": "select",
    "add": "+",
    "sub": "-",
    "sum": "dot, or + in a loop; they round after each term",
    "fsum": "dot, or + in a loop; they round after each term",
    "pow": "a product; x*x may differ from x**2 in the last digit",
    "bool": "a comparison",
    "random": "uniform",
    "gauss": "normal",
    "normalvariate": "normal",
}
"""Functions that a step cannot call, and what it uses instead. Some of them differ from machine code, such as `max` for NaN or, from
Python 3.12 on, `sum`, which does not round after each term; all are refused, so that the rule has no exceptions."""
_SYMBOLS: dict[type, tuple[str, str]] = {
    ast.Pow: ("**", "a product, or exp(n*log(x)) for x > 0; x*x may differ from x**2 in the last digit"),
    ast.Mod: ("%", "a - b*floor(a/b); they may differ unless a and b are whole numbers, so count ticks (clock.k), not seconds"),
    ast.FloorDiv: ("//", "floor(a/b); they may differ unless a and b are whole numbers, so count ticks (clock.k), not seconds"),
}
_DEEPEST = 60
"""Most calls within each other: more is a recursion."""
_PYTHON: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operators.add,
    ast.Sub: operators.sub,
    ast.Mult: operators.mul,
    ast.Div: operators.truediv,
    ast.FloorDiv: operators.floordiv,
    ast.Mod: operators.mod,
    ast.Pow: operators.pow,
    ast.Lt: operators.lt,
    ast.Gt: operators.gt,
    ast.LtE: operators.le,
    ast.GtE: operators.ge,
    ast.Eq: operators.eq,
    ast.NotEq: operators.ne,
    ast.Is: operators.is_,
    ast.IsNot: operators.is_not,
    ast.In: lambda a, b: a in b,
    ast.NotIn: lambda a, b: a not in b,
}


class Expressions:
    """Evaluates expressions; a subclass runs the bodies of functions.

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

    def body(self, statements: Sequence[ast.stmt], frame: Frame) -> Any:
        """Run statements; return the value that is returned, or `NOTHING`."""
        raise NotImplementedError  # see `Evaluator`

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
            if named or len(args) != function.__code__.co_argcount:
                args = list(bound(tree_of(function).args, {}, args, named or {}).values())
            return primitive(self, *args)
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
        raise MismatchError(_refused(function))

    def _run(self, node: Any, frame: Frame) -> Any:
        self._depth += 1
        try:
            if self._depth > _DEEPEST:
                raise MismatchError("a function calls itself")
            if isinstance(node, ast.Lambda):
                return self.expression(node.body, frame)
            found = self.body(node.body, frame)
            return None if found is NOTHING else found
        except EngineError:
            raise
        except Exception as error:  # Python itself may refuse what it computes now
            said = str(error) if isinstance(error, MismatchError) else error_text(error)
            if frame.file == language.__file__:
                raise MismatchError(f"{frame.title}: {said}") from error  # the line that calls a primitive is at fault
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
        known = not isinstance(a, Op) and not isinstance(b, Op)
        if known and type(operator) in _PYTHON:
            return _PYTHON[type(operator)](a, b)
        kind = _ARITHMETIC.get(type(operator))
        if kind is None:
            sign, cure = _SYMBOLS.get(type(operator), (words_of(operator), "arithmetic and comparisons"))
            raise MismatchError(f"a step cannot use {sign}: use {cure}")
        return self.graph.arithmetic(kind, a, b)

    def _unaryop(self, tree: ast.UnaryOp, frame: Frame) -> Any:
        value = self.expression(tree.operand, frame)
        if isinstance(tree.op, ast.Not):
            return self.graph.logic("not", self.graph.condition(value))
        if isinstance(tree.op, ast.USub):
            return self.graph.arithmetic("fneg", value) if isinstance(value, Op) else -value
        if isinstance(tree.op, ast.Invert):
            raise MismatchError("a step cannot use ~")
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
            raise MismatchError(f"{words_of(operator)} of values that are not known")
        return _PYTHON[type(operator)](left, right)

    def _boolop(self, tree: ast.BoolOp, frame: Frame) -> Any:
        """Return the value that Python returns; what follows is computed only where it decides."""

        def value(parts: Sequence[ast.expr]) -> Any:
            held = self.expression(parts[0], frame)
            if len(parts) == 1:
                return held
            test = self.graph.condition(held)
            if isinstance(tree.op, ast.And):
                return self.one_of(test, lambda: value(parts[1:]), lambda: held)
            return self.one_of(test, lambda: held, lambda: value(parts[1:]))

        return value(tree.values)

    def _ifexp(self, tree: ast.IfExp, frame: Frame) -> Any:
        test = self.graph.condition(self.expression(tree.test, frame))
        return self.one_of(test, lambda: self.expression(tree.body, frame), lambda: self.expression(tree.orelse, frame))

    def one_of(self, test: Any, then: Callable[[], Any], other: Callable[[], Any]) -> Any:
        """Return the value of one of two sides, which must be of one kind."""
        value = self.graph.branch(test, then, other)
        if has_unset(value):
            raise MismatchError("the two sides of an if give values of different kinds")
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
        if isinstance(index, Op):
            raise MismatchError("an index that is not known: use lookup")
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

    def _lambda(self, tree: ast.Lambda, frame: Frame) -> Any:
        return self.closure(tree, frame)

    def closure(self, node: ast.FunctionDef | ast.Lambda, frame: Frame) -> Closure:
        """Return a function defined inside another one."""
        if getattr(node, "decorator_list", ()):
            raise MismatchError("a step cannot use a decorator")
        given = node.args
        pairs = last_of(given, given.defaults)
        pairs += [(arg.arg, value) for arg, value in zip(given.kwonlyargs, given.kw_defaults, strict=True) if value is not None]
        return Closure(node, frame, {name: self.expression(value, frame) for name, value in pairs})

    def _generatorexp(self, tree: ast.GeneratorExp, frame: Frame) -> Any:
        made: list[Any] = []

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


def _refused(function: Any) -> str:
    """Return the message about a function that a step cannot call."""
    name, module = getattr(function, "__name__", repr(function)), getattr(function, "__module__", None)
    instead = _INSTEAD.get(name, name)
    if instead in language.__all__:
        instead = f"{instead} of contourlab.primitives"
    elif name not in _INSTEAD:
        instead = "the functions of contourlab.primitives, or your own"
    called = name if module in (None, "builtins") else f"{module}.{name}"
    return f"{called} cannot be called here: use {instead}"


def words_of(tree: ast.AST) -> str:
    """Return the name of a construct, as text."""
    if isinstance(tree, (ast.List, ast.ListComp)):
        return "a list: use a tuple"
    if isinstance(tree, ast.JoinedStr):
        return "an f-string"
    if isinstance(tree, ast.Expr):
        return f"{ast.unparse(tree)}, a line without effect on its result: leave it out"
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in type(tree).__name__).strip()
