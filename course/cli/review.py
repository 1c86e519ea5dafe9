"""`review`: asks a few questions of earlier quizzes again, mostly those answered wrong."""

from __future__ import annotations

import random
import sys
from collections.abc import Iterable, Mapping

import typer

from course.cli.quiz import answer_to, questions_of, show_output
from course.cli.session import CourseSession, open_session
from course.cli.usage import examples
from course.content import Question
from course.errors import UsageError
from course.grading.quiz.answers import Answers, Given
from course.grading.quiz.judge import judge
from course.progress import Progress
from course.report.console import open_console, put
from course.report.exercise_text import render_question
from course.report.verdict import render_checks

EXAMPLES = examples(("review", "eight questions from the quizzes that you have done"))
ROUND = 8
Name = tuple[str, str]  # of a question: its exercise's id, and its own


def review(ctx: typer.Context) -> None:
    """Answer a few questions from earlier quizzes again.

    Questions that you answered wrong come up more often, until you answer them
    right in a review. A review gives no points and changes none.
    """
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise UsageError("Questions can only be asked in a terminal.")
    with open_session(ctx) as session:
        questions = _known(session)
        if not questions:
            raise UsageError("There is nothing to review yet.", "Answer the questions of a quiz first.")
        names = drawn(questions, session.progress.failures(), random.Random())
        _ask({name: questions[name] for name in names}, session.progress)


def drawn(questions: Iterable[Name], failures: Mapping[Name, int], chance: random.Random) -> list[Name]:
    """Draw up to ROUND questions. Each wrong answer raises the chances of its question."""
    last = {name: chance.random() ** (1 / (1 + failures.get(name, 0))) for name in questions}
    return sorted(last, key=last.__getitem__, reverse=True)[:ROUND]


def _known(session: CourseSession) -> dict[Name, Question]:
    """Questions of attempted quizzes, without mysteries, which need running nodes."""
    done = (one for one in session.course.readable_exercises() if one.play is None and one.questions)
    tried = [one for one in done if session.progress.attempts(one.id)]
    return {(one.id, question.id): question for one in tried for question in questions_of(session, one)}


def _ask(questions: Mapping[Name, Question], progress: Progress) -> None:
    console = open_console()
    put(console, "Leave an answer empty to skip the question. Press Ctrl+C to stop.", "dim")
    right = 0
    for index, ((exercise, _), question) in enumerate(questions.items(), start=1):
        render_question(console, question, number=index, total=len(questions))
        texts = answer_to(console, question)
        if texts:
            answers = Answers("your answer", {question.id: Given(texts)})
            result = judge(question, answers, frozenset({question.id}))
            show_output(console, question, texts)
            render_checks(console, [result])
            progress.record_review(exercise, question.id, right=result.earned > 0)
            right += result.earned > 0
    put(console)
    put(console, f"You answered {right} of {len(questions)} correctly.", "bold")
