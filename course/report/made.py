"""What `new` made for an author."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from rich.console import Console

from course.report import safe
from course.report.console import put


def render_made(
    console: Console, what: str, root: Path, new: Iterable[Path], changed: Iterable[Path]
) -> None:
    """The new files (`+`) and those that got more (`~`), as they lie in the course."""
    put(console, f"{what} in {safe.one_line(str(root))}:", "bold")
    for mark, files in (("+", new), ("~", changed)):
        for file in sorted(files):
            put(console, f"  {mark} {safe.one_line(str(file.relative_to(root)))}")
    put(console)
