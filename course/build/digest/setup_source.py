"""Reading setup.py without running it: its entry points, line by line, and the package's name."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from dataclasses import dataclass

_ENTRY_POINT = re.compile(r"\s*[\w.-]+\s*=\s*[^\W\d][\w.]*\s*:\s*[^\W\d][\w.]*\s*")


@dataclass(frozen=True)
class EntryPoint:
    """One item of console_scripts. `parts`: the line of each string that Python joined to make it."""

    text: str
    parts: tuple[int, ...]

    @property
    def line(self) -> int:
        return self.parts[0]

    @property
    def is_joined(self) -> bool:
        """Whether two strings became one that holds two entry points."""
        return len(self.parts) > 1 and self.text.count("=") > 1

    @property
    def is_sound(self) -> bool:
        return _ENTRY_POINT.fullmatch(self.text) is not None


def entry_points(source: str) -> list[EntryPoint]:
    """What console_scripts lists, as far as it is written out; empty when setup.py cannot be parsed."""
    try:
        strings = list(_strings(source))
        nodes = list(ast.walk(ast.parse(source)))
    except (SyntaxError, tokenize.TokenError, ValueError, RecursionError, MemoryError):
        return []
    found = []
    for node in nodes:
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant) and key.value == "console_scripts":
                    found += [_entry_point(item, strings) for item in _texts(value)]
    return found


def name_line(source: str, name: str) -> int | None:
    """The line in which `name` stands as a string of its own."""
    pattern = re.compile(rf"""['"]{re.escape(name)}['"]""")
    lines = enumerate(source.splitlines(), 1)
    return next((number for number, line in lines if pattern.search(line)), None)


def _texts(value: ast.expr) -> list[ast.Constant]:
    items = value.elts if isinstance(value, (ast.List, ast.Tuple)) else ()
    return [item for item in items if isinstance(item, ast.Constant) and isinstance(item.value, str)]


def _entry_point(item: ast.Constant, strings: list[tuple[int, int]]) -> EntryPoint:
    first = (item.lineno, item.col_offset)
    last = (item.end_lineno or item.lineno, item.end_col_offset or 0)
    return EntryPoint(
        str(item.value), tuple(line for line, column in strings if first <= (line, column) < last)
    )


def _strings(source: str) -> Iterator[tuple[int, int]]:
    """Line and column, in bytes as ast counts them, of each string."""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.STRING:
            line, column = token.start
            yield line, len(token.line[:column].encode())
