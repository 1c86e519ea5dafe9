"""Judges the learner's Python files by rules of ruff, on a terminal like every other program."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from pathlib import Path

LINT_TIME = 10.0
# Nothing that the learner may have set, or written beside a line, silences a rule.
_OPTIONS = ("--isolated", "--no-cache", "--ignore-noqa", "--output-format", "concise")


def lint_command(folder: str, rules: tuple[str, ...]) -> tuple[str, ...]:
    return (sys.executable, "-m", "ruff", "check", *_OPTIONS, "--select", ",".join(rules), folder)


@contextlib.contextmanager
def named_as_public(folder: Path) -> Iterator[dict[str, Path]]:
    """Meanwhile `_words.py` is called `words.py`; yields the new names with the old files.

    For a linter, all that is in a file with an underscore is private, and needs neither docstring nor
    hint. But the package exports it.
    """
    renamed: dict[str, Path] = {}
    for file in sorted(folder.rglob("_*.py")):
        public = file.with_name(file.name.lstrip("_"))
        if not file.name.startswith("__") and not public.exists():
            file.rename(public)
            renamed[str(public)] = file
    try:
        yield renamed
    finally:
        for name, file in renamed.items():
            Path(name).rename(file)
