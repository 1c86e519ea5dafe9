"""A quiz in the terminal: its questions, asked or shown. Each answer is kept as soon as it is given."""

from __future__ import annotations

import io
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

from course.cli.session import CourseSession
from course.content import Exercise, answers_file
from course.content.entries import Choice, Question
from course.errors import MissingHere
from course.grading.load import questions_for
from course.grading.quiz.answers import FIRST, Answers, Given, answers_text, read_answers
from course.grading.quiz.judge import LATER_SHARE, chosen_by, is_a_try, is_right, items, number, right_answers
from course.grading.quiz.program import printed
from course.grading.quiz.questions import as_seen
from course.home import keep_answers
from course.model.feedback import Failure
from course.report.activity import activity
from course.report.console import error_console, put
from course.report.exercise_text import LETTERS, render_output, render_question, render_questions
from course.report.sanitize import clean
from course.rosenv import find_ros

if TYPE_CHECKING:
    from rich.console import Console

    from course.home import CourseHome


LONGEST = 500
_SEVERAL = ("several words",)  # choices are single words, so spaces separate them


@dataclass(frozen=True)
class Asking:
    """One round of questions about an exercise, worked on in a course home."""

    console: Console
    home: CourseHome
    exercise: Exercise
    questions: tuple[Question, ...]  # as the learner sees them, see `order`

    def run(self, *, again: bool) -> None:
        """Ask what is not answered yet; `again`: also what is wrong, or everything when all is right.

        A file that cannot be read is left as it is, because judging it reports what is wrong. Ctrl+C passes
        through; what was answered is kept.
        """
        try:
            known = read_answers(self.home.path, self.exercise.id) or Answers("")
            self._ask(self._open(known, again=again), known)
        except Failure:
            return
        except KeyboardInterrupt:
            put(self.console)
            put(self.console, f"Stopped. Your answers so far are kept in ~/{answers_file(self.exercise.id)}.")
            raise

    def _open(self, known: Answers, *, again: bool) -> tuple[Question, ...]:
        given = {question.id: known.to(question.id) for question in self.questions}
        blank = tuple(question for question in self.questions if given[question.id] is None)
        if not again:
            return blank
        wrong = tuple(one for one in self.questions if not _is_right(one, given[one.id]))
        return wrong or self.questions

    def _ask(self, questions: tuple[Question, ...], known: Answers) -> None:
        if not questions:
            return
        put(self.console, "Leave an answer empty to come back to it later. Press Ctrl+C to stop.", "dim")
        for index, question in enumerate(questions, start=1):
            render_question(self.console, question, number=index, total=len(questions))
            if known.first(question.id):
                put(self.console, _worth_less(question), "yellow")
            texts = answer_to(self.console, question)
            if texts:
                self._keep(question, texts)
                show_output(self.console, question, texts)
        put(self.console)

    def _keep(self, question: Question, texts: tuple[str, ...]) -> None:
        _change(self.home, self.exercise, self.questions, lambda _: {question.id: texts})


def show_output(console: Console, question: Question, texts: tuple[str, ...]) -> None:
    """Run the program of the question, if it has one, after the learner predicted its output."""
    if question.program is None:
        return
    try:
        with activity(error_console(), f"running {question.program.name}"):
            lines = printed(question.program, find_ros())
    except MissingHere as error:
        put(console, f"The program cannot run on this machine: {error.what}", "yellow")
        return
    predicted = [choice.text for text in texts if (choice := chosen_by(question, text))]
    render_output(console, ", ".join(predicted), lines)


def answer_to(console: Console, question: Question) -> tuple[str, ...]:
    """The answer to a question; empty if it is left for later."""
    while typed := _typed(_prompt(question)):
        texts = understood(question, typed)
        if texts:
            return texts
        put(console, _misunderstood(question), "yellow")
    return ()


def left_open(home: CourseHome, exercise: Exercise) -> int:
    """How many questions have no answer; 0 if the file of answers cannot be read."""
    with suppress(Failure):
        known = read_answers(home.path, exercise.id) or Answers("")
        return sum(known.to(question.id) is None for question in exercise.questions)
    return 0


def keep_first_answers(home: CourseHome, exercise: Exercise, questions: tuple[Question, ...]) -> None:
    """Record wrong first answers, so that these questions earn less from now on."""

    def wrong(known: Answers) -> Mapping[str, tuple[str, ...]]:
        open_ones = ((one, known.to(one.id)) for one in questions if not known.first(one.id))
        return {one.id + FIRST: given.texts for one, given in open_ones if given and is_a_try(one, given)}

    with suppress(Failure):  # the file cannot be read; judging it has reported that
        _change(home, exercise, questions, wrong)


def _change(
    home: CourseHome,
    exercise: Exercise,
    questions: tuple[Question, ...],
    change: Callable[[Answers], Mapping[str, tuple[str, ...]]],
) -> None:
    """Change the current file, because another terminal or an editor may have changed it in the meantime."""
    with home.lock():
        known = read_answers(home.path, exercise.id) or Answers("")
        new = change(known)
        if new:
            given = {name: answer.texts for name, answer in known.given.items()} | dict(new)
            keep_answers(home, exercise.id, answers_text(exercise.id, questions, given))


def understood(question: Question, typed: str) -> tuple[str, ...]:
    """The answer as it goes into the file; nothing when it makes no sense for this question.

    Choices are given by their letters (`b`, `a, d`, `ad`) or their words.
    """
    if question.form == "number":
        return (typed,) if number(typed) is not None else ()
    if not question.choices:
        return (typed,)
    by_letter = dict(zip(LETTERS, question.choices, strict=False))
    parts: Sequence[str] = (typed,)
    if question.form == "choices" and not _choice(question, by_letter, typed):
        letters = re.sub(r"[\s,;]+", "", typed.lower())
        parts = letters if set(letters) <= by_letter.keys() else items((typed,), _SEVERAL)
    chosen = [_choice(question, by_letter, part) for part in parts]
    if not all(chosen):
        return ()
    return tuple(dict.fromkeys(choice.name for choice in chosen if choice))


def _choice(question: Question, by_letter: dict[str, Choice], typed: str) -> Choice | None:
    return by_letter.get(typed.strip(" .)").lower()) or chosen_by(question, typed)


def _is_right(question: Question, given: Given | None) -> bool:
    return given is not None and is_right(question, given)


def _typed(prompt: str) -> str:
    if isinstance(sys.stdin, io.TextIOWrapper):
        sys.stdin.reconfigure(errors="replace")  # a terminal may send anything
    try:
        return " ".join(clean(input(prompt)[:LONGEST]).split())
    except EOFError:  # Ctrl+D, or the terminal is gone
        print()
        return ""


def _prompt(question: Question) -> str:
    if not question.choices:
        return "Your answer: "
    last = LETTERS[len(question.choices) - 1]
    if question.form == "choices":
        return f"Your answer, one or more letters from a to {last}, such as `a, {last}`: "
    return f"Your answer, a to {last}: "


def _worth_less(question: Question) -> str:
    points = f"{question.points * LATER_SHARE:g} of {question.points:g}"
    return f"Your first answer was wrong. The right one now earns {points} points."


def _misunderstood(question: Question) -> str:
    if question.form == "number":
        return "That is not a number. Write it in digits, such as 2.5."
    return f"That is not one of the choices. Type a letter from a to {LETTERS[len(question.choices) - 1]}."


def put_questions(console: Console, session: CourseSession, exercise: Exercise) -> None:
    """The questions of a quiz, to read; nothing for other exercises."""
    questions = questions_of(session, exercise)
    if questions:
        render_questions(console, questions)


def questions_of(session: CourseSession, exercise: Exercise) -> tuple[Question, ...]:
    """The questions of a quiz as this learner is asked them; none for other exercises."""
    if not exercise.questions:
        return ()
    seed = session.home.seed()
    return as_seen(questions_for(exercise, seed), exercise.id, seed)


def right_answers_of(session: CourseSession, exercise: Exercise) -> dict[str, str]:
    """The file of right answers to an exercise's questions, by its path; nothing without questions."""
    if not exercise.questions:
        return {}
    questions = questions_of(session, exercise)
    text = answers_text(exercise.id, questions, right_answers(questions))
    return {answers_file(exercise.id): text}
