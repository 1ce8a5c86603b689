"""The syntax tree of a function, from its file or from source that the program generated."""

from __future__ import annotations

import ast
import linecache
from functools import cache
from types import CodeType, FunctionType

from contourlab.engine.translate.names import positional
from contourlab.errors import EngineError

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
    is_lambda = isinstance(node, ast.Lambda)
    first = min([node.lineno, *(mark.lineno for mark in getattr(node, "decorator_list", ()))])
    names = positional(node.args)
    called = "<lambda>" if is_lambda else getattr(node, "name", "")
    return first == code.co_firstlineno and called == code.co_name and names == list(code.co_varnames[: code.co_argcount])


def _start(node: Function) -> tuple[int, int]:
    """Return line and column of the first expression in a body."""
    body = node.body if isinstance(node.body, list) else [node.body]
    return min((part.lineno, part.col_offset) for tree in body for part in ast.walk(tree) if isinstance(part, ast.expr))


def _start_of_code(code: CodeType) -> tuple[int, int]:
    places = [(line, column) for line, _, column, end in code.co_positions() if line is not None and column is not None and end]
    return min(places)


def codes(code: CodeType) -> list[CodeType]:
    """Return a code object and those inside it."""
    return [code, *(inner for constant in code.co_consts if isinstance(constant, CodeType) for inner in codes(constant))]


def code_words(code: CodeType) -> list[str]:
    """Return the content of a code object, without its place in the file."""
    constants = [c if not isinstance(c, CodeType) else code_words(c) for c in code.co_consts]
    return [code.co_code.hex(), repr(constants), repr((code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars))]
