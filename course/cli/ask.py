"""Asks the questions of a quiz in the terminal. Each answer is kept as soon as it is given."""

from __future__ import annotations

import io
import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from course.content.layout import answers_file
from course.content.question import Choice, Question
from course.feedback import Failure
from course.grading.quiz.answers import Answers, Given, read_answers
from course.grading.quiz.judge import chosen_by, is_right
from course.grading.quiz.matching import items, number
from course.grading.quiz.writing import answers_text
from course.home import keep_answers
from course.report.console import put
from course.report.questions import LETTERS, render_question
from course.report.safe import clean

if TYPE_CHECKING:
    from rich.console import Console

    from course.content import Exercise
    from course.home import CourseHome

LONGEST = 500
_SEVERAL = ("several words",)  # choices are words, so blanks do not part them


@dataclass(frozen=True)
class Asking:
    """One round of questions about an exercise, worked on in a course home."""

    console: Console
    home: CourseHome
    exercise: Exercise
    questions: tuple[Question, ...]  # as the learner sees them, see `order`

    def run(self, *, again: bool) -> None:
        """Ask what is not answered yet; `again`: also what is wrong, or everything when all is right.

        Leaves a file that cannot be read as it is: judging it says what is wrong with it. Ctrl+C passes
        through; what was answered is kept.
        """
        try:
            known = read_answers(self.home.path, self.exercise.id) or Answers("")
            self._ask(self._open(known, again=again))
        except Failure:
            return
        except KeyboardInterrupt:
            put(self.console)
            put(self.console, f"Stopped. Your answers so far are kept in ~/{answers_file(self.exercise.id)}.")
            raise

    def _open(self, known: Answers, *, again: bool) -> tuple[Question, ...]:
        """The questions that are still to be asked."""
        given = {question.id: known.to(question.id) for question in self.questions}
        blank = tuple(question for question in self.questions if given[question.id] is None)
        if not again:
            return blank
        wrong = tuple(one for one in self.questions if not _is_right(one, given[one.id]))
        return wrong or self.questions

    def _ask(self, questions: tuple[Question, ...]) -> None:
        if not questions:
            return
        put(self.console, "Leave an answer empty to come back to it later. Ctrl+C stops.", "dim")
        for index, question in enumerate(questions, start=1):
            render_question(self.console, question, number=index, total=len(questions))
            texts = self._answer(question)
            if texts:
                self._keep(question, texts)
        put(self.console)

    def _answer(self, question: Question) -> tuple[str, ...]:
        """What was answered; nothing when it is left for later."""
        while typed := _typed(_prompt(question)):
            texts = understood(question, typed)
            if texts:
                return texts
            put(self.console, _misunderstood(question), "yellow")
        return ()

    def _keep(self, question: Question, texts: tuple[str, ...]) -> None:
        """Into the file as it is now, which another terminal or an editor may have changed meanwhile."""
        with self.home.lock():
            known = read_answers(self.home.path, self.exercise.id) or Answers("")
            given = {name: answer.texts for name, answer in known.given.items()}
            given[question.id] = texts
            keep_answers(self.home, self.exercise.id, answers_text(self.exercise.id, self.questions, given))


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
        return f"Your answer, one or more of a to {last}, such as `a, {last}`: "
    return f"Your answer, a to {last}: "


def _misunderstood(question: Question) -> str:
    if question.form == "number":
        return "That is not a number. Write it in digits, such as 2.5."
    return f"That is none of the choices. Type a letter from a to {LETTERS[len(question.choices) - 1]}."
