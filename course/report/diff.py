"""The difference between a learner's files and the reference solution."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put

STYLES = {"+": "green", "-": "red", "@": "cyan"}
LONGEST_LINE = 2000


def render_diff(console: Console, files: Iterable[tuple[str, str]]) -> bool:
    """Unified diffs (file, text); says which files are the same. Returns whether anything differs."""
    differs = False
    for file, diff in files:
        if not diff.strip():
            put(console, Text(f"{safe.one_line(file)}: the same as the reference", "dim"))
            continue
        differs = True
        for line in diff.rstrip("\n").split("\n"):
            put(console, _line(line))
        put(console)
    return differs


def _line(line: str) -> Text:
    style = "bold" if line.startswith(("---", "+++")) else STYLES.get(line[:1], "")
    return Text(safe.one_line(line, LONGEST_LINE), style)
