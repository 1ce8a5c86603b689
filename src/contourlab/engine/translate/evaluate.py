"""Run a function of the scalar language over graph values: what is known now is computed now, the rest becomes operations.

Tuples, named tuples, closures and whole numbers are Python's own and leave no trace. Numbers and conditions that are not known become
operations. An ``if`` over them becomes a branch. A ``while``, a ``for`` that breaks and a long ``for`` that does not use its index become
loops; any other ``for`` is written out.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence
from typing import Any

from contourlab.engine.translate.expressions import NOTHING, Expressions, words_of
from contourlab.engine.translate.graph import UNSET, MismatchError, Op
from contourlab.engine.translate.names import Frame, assign, assigned, flat, is_numeric, shaped
from contourlab.errors import EngineError

_WRITTEN_OUT = 4
"""Most rounds of a ``for`` that are written out although it could be a loop."""
_ON = "the loop goes on"
"""Name, within a round of a loop, of the condition that no break was met."""


class Evaluator(Expressions):
    """Runs the bodies of functions; see `Expressions`."""

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
                found = self._statement(statement, frame)
            except Exception as error:
                if not hasattr(error, "line"):
                    error.line = statement.lineno  # type: ignore[attr-defined]
                raise
            if found is not NOTHING:
                return found
        return NOTHING

    def _if(self, statement: ast.If, rest: Sequence[ast.stmt], frame: Frame) -> Any:
        """Run an if; return a tuple of the returned value if a side returns, else `NOTHING`."""
        test = self.graph.condition(self.expression(statement.test, frame))
        if not isinstance(test, Op):
            found = self.body(statement.body if test else statement.orelse, frame)
            return NOTHING if found is NOTHING else (found,)
        if any(isinstance(node, ast.Return) for node in ast.walk(statement)):
            # The statements after it belong to the side that goes on.
            def side(part: Sequence[ast.stmt]) -> Any:
                found = self.body([*part, *rest], frame.copy())
                if found is NOTHING:
                    raise MismatchError("one side of an if returns, the other does not")
                return found

            return (self.one_of(test, lambda: side(statement.body), lambda: side(statement.orelse)),)
        self._both_sides(test, statement, self.body, assigned(statement), frame)
        return NOTHING

    def _both_sides(self, test: Op, statement: ast.If, run: Callable[[Any, Frame], Any], names: Sequence[str], frame: Frame) -> None:
        """Run both sides of an if over copies of the names, and join those that either may change."""

        def outcome(part: Sequence[ast.stmt]) -> tuple[Any, ...]:
            own = frame.copy()
            run(part, own)
            return tuple(own.env.get(name, UNSET) for name in names)

        joined = self.graph.branch(test, lambda: outcome(statement.body), lambda: outcome(statement.orelse))
        frame.env.update(zip(names, joined, strict=True))

    def _statement(self, statement: ast.stmt, frame: Frame) -> Any:
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
            return self._for(statement, frame)
        elif isinstance(statement, ast.While) and not statement.orelse:
            self._loop(statement, frame, lambda own: self.expression(statement.test, own), None)
        elif isinstance(statement, ast.FunctionDef):
            frame.env[statement.name] = self.closure(statement, frame)
        elif not isinstance(statement, ast.Pass) and not (isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)):
            raise MismatchError(f"a step cannot use {words_of(statement)}")
        return NOTHING

    # --- loops

    def _for(self, statement: ast.For, frame: Frame) -> Any:
        if statement.orelse:
            raise MismatchError("a step cannot use else after a loop")
        items = self.expression(statement.iter, frame)
        if isinstance(items, Op):
            raise MismatchError("a loop needs a known range or tuple")
        if _breaks(statement.body):
            if not isinstance(items, range):
                raise MismatchError("a loop that breaks needs a range")
            self._loop(statement, frame, None, items)
            return NOTHING
        if len(items) > _WRITTEN_OUT and self._repeated(statement, frame, len(items)):
            assign(statement.target, items[-1], frame.env)
            return NOTHING
        for item in items:
            assign(statement.target, item, frame.env)
            found = self.body(statement.body, frame)
            if found is not NOTHING:
                return found
        return NOTHING

    def _repeated(self, statement: ast.For, frame: Frame, count: int) -> bool:
        """Make a loop of a ``for`` whose body does not use its index; return whether that is possible."""
        body = ast.Module(statement.body, [])
        used = {node.id for node in ast.walk(body) if isinstance(node, ast.Name)}
        names, own = assigned(body), frame.copy()
        known = all(is_numeric(frame.env.get(name, UNSET)) for name in names)
        if not known or used & set(assigned(statement.target)) or any(isinstance(node, ast.Return) for node in ast.walk(body)):
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
        """Make a loop of a ``while``, or of a ``for`` over a range that may break."""
        if any(isinstance(node, ast.Return) for node in ast.walk(statement)):
            raise MismatchError("a return inside a loop: set a name, break, and return after the loop")
        names = [name for name in assigned(statement) if is_numeric(frame.env.get(name, UNSET))]
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

        def round_(values: Sequence[Op]) -> list[Any]:
            enter(values)
            on = self._until_break(statement.body, own)
            count = self.graph.arithmetic("fadd", values[1], 1) if items is not None else values[1]
            return [on, count, *flat(own.name(name) for name in names)]

        start = [True, 0, *flat(shapes)]
        after = self.graph.loop(start, goes_on, round_)
        frame.env.update(dict.fromkeys(assigned(statement), UNSET))
        frame.env.update(zip(names, shaped(shapes, after[2:]), strict=True))

    def _until_break(self, statements: Sequence[ast.stmt], frame: Frame) -> Any:
        """Run one round; return whether the loop goes on."""
        for i, statement in enumerate(statements):
            if isinstance(statement, ast.Break):
                return False
            if not _breaks([statement]):
                self.body([statement], frame)
                continue
            assert isinstance(statement, ast.If)
            test = self.graph.condition(self.expression(statement.test, frame))
            rest = statements[i + 1 :]
            if not isinstance(test, Op):
                return self._until_break([*(statement.body if test else statement.orelse), *rest], frame)

            def side(part: Sequence[ast.stmt], own: Frame, rest: Sequence[ast.stmt] = rest) -> None:
                own.env[_ON] = self._until_break([*part, *rest], own)

            self._both_sides(test, statement, side, [*assigned(ast.Module([statement, *rest], [])), _ON], frame)
            return frame.env.pop(_ON)
        return True


def _breaks(statements: Sequence[ast.stmt]) -> bool:
    """Return whether statements may end the loop around them; a break of an inner loop does not."""
    return any(isinstance(one, ast.Break) or (isinstance(one, ast.If) and _breaks([*one.body, *one.orelse])) for one in statements)
