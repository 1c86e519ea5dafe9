"""Adds to an author's files without changing anything that is already in them."""

from __future__ import annotations

import ast
import textwrap
from collections.abc import Iterable, Iterator
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

import yaml

from course.errors import ContentError

_WIDTH = 110


def with_item(file: Path, text: str, key: str, item: str) -> str:
    """Return `text`, the YAML of `file`, with `item` (`- ...`) at the end of the list `key`.

    Raises ContentError if that cannot be done with certainty.
    """
    old = _loaded(file, text)
    new = _inserted(text, key, item)
    if new is None or not _holds(new, old, key, yaml.safe_load(item)):
        what = f"`{key}` is not written as a list with a dash before each entry"
        raise ContentError(what, "write it so, then try again", file=file, line=_line(text, key), key=key)
    return new


def _loaded(file: Path, text: str) -> Any:
    try:
        return yaml.safe_load(text)
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else None
        raise ContentError(
            "this is not valid YAML", "correct it, then try again", file=file, line=line
        ) from None


def _holds(new: str, old: Any, key: str, more: list[Any]) -> bool:
    """Whether the new text contains the old one, and only one list grew."""
    try:
        return bool(yaml.safe_load(new) == {**old, key: [*old[key], *more]})
    except yaml.YAMLError:
        return False


def _inserted(text: str, key: str, item: str) -> str | None:
    node = _node(text, key)
    if not isinstance(node, yaml.SequenceNode) or (node.flow_style and node.value):
        return None
    if not node.value:  # `key: []`
        before, after = text[: node.start_mark.index].rstrip(" "), text[node.end_mark.index :]
        return f"{before}\n{textwrap.indent(item, '  ').rstrip()}{after}"
    indent = " " * node.start_mark.column
    before, after = text[: node.end_mark.index].rstrip(), text[node.end_mark.index :]
    return f"{before}\n{textwrap.indent(item, indent).rstrip()}\n{after}"


def _node(text: str, key: str) -> yaml.Node | None:
    # Not the C loader, whose marks count bytes.
    root = yaml.compose(text, Loader=yaml.SafeLoader)
    pairs = root.value if isinstance(root, yaml.MappingNode) else []
    return next((value for name, value in pairs if name.value == key), None)


def _line(text: str, key: str) -> int | None:
    node = _node(text, key)
    return node.start_mark.line + 1 if node else None


def with_code(file: Path, text: str, imports: str, code: str) -> str:
    """Return `text`, the Python of `file`, with the names of `imports` that it lacks, and `code` at the end.

    imports: statements `from module import names`. Raises ContentError if `text` is not Python.
    """
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        what = f"this is not valid Python: {error.msg}"
        raise ContentError(what, "correct it, then try again", file=file, line=error.lineno) from None
    found = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    known = {name for node in found for name in _names(node)}
    wanted = [name for node in ast.parse(imports).body for name in _names(node) if name not in known]
    lines = text.splitlines()
    last = max((node.end_lineno or 0 for node in found), default=_after_docstring(tree))
    together = [*lines[:last], *_imports(wanted), *lines[last:]]
    return "\n".join(together).rstrip() + f"\n\n\n{code}"


def _imports(names: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Names of one module on one line if they fit, otherwise one per line. Each module has its own line."""
    for module, group in groupby(names, itemgetter(0)):
        short = [name for _, name in group]
        if not module:
            yield from (f"import {name}" for name in short)
            continue
        line = f"from {module} import {', '.join(short)}"
        if len(line) <= _WIDTH:
            yield line
        else:
            yield from (f"from {module} import (", *(f"    {name}," for name in short), ")")


def _names(node: ast.stmt) -> list[tuple[str, str]]:
    """What a line imports: (module, name)."""
    if isinstance(node, ast.ImportFrom):
        return [(node.module or "", alias.name) for alias in node.names if alias.asname is None]
    return [("", alias.name) for alias in node.names] if isinstance(node, ast.Import) else []


def _after_docstring(tree: ast.Module) -> int:
    first = tree.body[0] if tree.body else None
    is_docstring = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    return (first.end_lineno or 0) if first and is_docstring else 0
