"""Questions of a quiz on the terminal: one that is being asked, or all of them to read."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from string import ascii_lowercase
from typing import Protocol

from rich.console import Console
from rich.text import Text

from course.report.console import put, put_prose, with_code
from course.report.markdown import put_markdown

LETTERS = ascii_lowercase


class Choice(Protocol):
    @property
    def text(self) -> str: ...


class Question(Protocol):
    @property
    def id(self) -> str: ...

    @property
    def ask(self) -> str: ...

    @property
    def choices(self) -> Sequence[Choice]: ...


def render_question(console: Console, question: Question, *, number: int, total: int) -> None:
    """The question that is asked now: `number` of `total`, from 1. Its choices get letters."""
    put(console)
    put(console, f"Question {number} of {total}", "bold")
    put_markdown(console, question.ask)
    if question.choices:
        put(console)
    for letter, choice in zip(LETTERS, question.choices, strict=False):
        put_prose(console, with_code(console, choice.text), first=f"  {letter}  ")
    put(console)


def render_questions(console: Console, questions: Iterable[Question]) -> None:
    """All questions to read, under the names that they have in the answers file."""
    put(console, "The questions:", "bold")
    for question in questions:
        put(console)
        put(console, Text(question.id, "bold"))
        put_markdown(console, question.ask)
        for choice in question.choices:
            put_prose(console, with_code(console, choice.text), first="  - ")
    put(console)
