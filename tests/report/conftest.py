"""Consoles that write into a string, with and without color."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass

import pytest
from rich.console import Console

from course.report.console import open_console


@dataclass
class Page:
    """A console and what was written on it."""

    console: Console
    stream: io.StringIO

    @property
    def text(self) -> str:
        return self.stream.getvalue()

    @property
    def lines(self) -> list[str]:
        return self.text.splitlines()


@pytest.fixture
def page() -> Page:
    """80 columns, no color: a pipe or a dumb terminal."""
    stream = io.StringIO()
    return Page(open_console(stream, width=80), stream)


@pytest.fixture
def colour_page(monkeypatch: pytest.MonkeyPatch) -> Page:
    """80 columns, a terminal with colors."""
    for name in ("NO_COLOR", "COLORTERM"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("FORCE_COLOR", "1")
    stream = io.StringIO()
    return Page(open_console(stream, width=80), stream)


@pytest.fixture
def narrow_page() -> Callable[[int], Page]:
    def make(width: int) -> Page:
        stream = io.StringIO()
        return Page(open_console(stream, width=width), stream)

    return make
