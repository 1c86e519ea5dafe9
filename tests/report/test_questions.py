"""Questions on the terminal."""

from __future__ import annotations

import io

from course.content import Choice, Question
from course.model.result import CheckResult, Feedback, Outcome, Result, Verdict
from course.report.console import open_console
from course.report.exercise_text import render_question, render_questions
from course.report.verdict import render_result

LONG = "It completes what you began to type, or, when several things would fit, does nothing at first."
QUESTION = Question(
    "tab",
    "What does **Tab** do?",
    "choice",
    (Choice("long", LONG, True), Choice("b", "Write `blanks`", False)),
)


class Named:
    id = "01-quiz"
    title = "A quiz"


def page(draw: object, *things: object, **named: object) -> list[str]:
    stream = io.StringIO()
    draw(open_console(stream, width=60), *things, **named)  # type: ignore[operator]
    return stream.getvalue().splitlines()


def test_a_question_with_letters() -> None:
    lines = page(render_question, QUESTION, number=2, total=5)
    assert "Question 2 of 5" in lines
    assert "  a  It completes what you began to type, or, when several" in lines
    assert "     things would fit, does nothing at first." in lines
    assert "  b  Write `blanks`" in lines


def test_all_questions_under_their_names() -> None:
    lines = page(render_questions, [QUESTION])
    assert "tab" in lines
    assert "  - Write `blanks`" in lines
    assert not any(line.startswith("  a ") for line in lines)


def test_a_right_answer_shows_its_explanation() -> None:
    said = Feedback("It does that in every shell.")
    check = CheckResult("tab", "What does Tab do?", 1, Outcome.PASSED, feedback=said)
    lines = page(render_result, Result("01-quiz", Verdict.PASSED, (check,)), Named())
    assert "      It does that in every shell." in lines
