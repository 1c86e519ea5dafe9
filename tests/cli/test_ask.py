"""What is typed at a question, and what it means."""

from __future__ import annotations

import pytest

from course.cli.ask import understood
from course.content import Choice, Question

CHOICES = tuple(
    Choice(name, text, False) for name, text in (("keep", "It `keeps`"), ("b c", "b c"), (">>", ">>"))
)
ONE = Question("one", "?", "choice", CHOICES)
SOME = Question("some", "?", "choices", CHOICES)
NUMBER = Question("number", "?", "number", value=3)
TEXT = Question("text", "?", "text", texts=("x",))


@pytest.mark.parametrize(
    ("question", "typed", "texts"),
    [
        (ONE, "a", ("keep",)),
        (ONE, "A)", ("keep",)),
        (ONE, " c. ", (">>",)),
        (ONE, "it keeps", ("keep",)),
        (ONE, ">>", (">>",)),
        (ONE, "d", ()),
        (ONE, "a, b", ()),
        (ONE, "it keep", ()),
        (SOME, "a, c", ("keep", ">>")),
        (SOME, "ca", (">>", "keep")),
        (SOME, "C a", (">>", "keep")),
        (SOME, "b, b", ("b c",)),
        (SOME, "b c", ("b c",)),
        (SOME, "it keeps and >>", ("keep", ">>")),
        (SOME, "a, x", ()),
        (NUMBER, "2,5 Hz", ("2,5 Hz",)),
        (NUMBER, "many", ()),
        (TEXT, "a", ("a",)),
    ],
)
def test_what_is_meant(question: Question, typed: str, texts: tuple[str, ...]) -> None:
    assert understood(question, typed) == texts
