"""How a grader module describes a mystery: the right answers, and the words for its questions.

    mystery = Mystery("19-inspect-topics", __file__)

    @mystery.answers
    def answers(plan): return {"rate": Number(plan.rate, "10%")}

    @mystery.words
    def words(plan): return {"topic": plan.topic}

The plan comes from `draw(seed)` in the chapter's `play/19-inspect-topics.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from course.arena.mystery_module import load_mystery
from course.content import Choice, Exercise, KnownAnswer, Question
from course.content.entries import tolerance_of
from course.content.layout import play_file
from course.errors import OurFault
from course.evidence.acts import acts_of
from course.evidence.recording import Recording
from course.model import replace
from course.model.events import Acted
from course.model.feedback import Failure, Feedback
from course.spelling import did_you_mean

Answers = Callable[[Any], Mapping[str, "Answer"]]
Words = Callable[[Any], Mapping[str, object]]
ActsOf = Callable[[Any], Sequence[str]]
_SHOWN = 5


class Seeded(Protocol):
    """A recording or an arena."""

    @property
    def seed(self) -> int | None: ...


class Mystery:
    """The mystery of one exercise, as its grader module declares it."""

    def __init__(self, exercise: str, grader: str) -> None:
        """grader: the module's own `__file__`, from which the mystery's module is found."""
        self.exercise = exercise
        self._root = Path(grader).resolve().parents[1]
        self.answers_function: Answers | None = None
        self.words_function: Words = _no_words
        self.acts_function: ActsOf = _no_acts

    def answers(self, function: Answers) -> Answers:
        """Decorator: this function maps a plan to the right answer of each question that is `computed`."""
        self.answers_function = function
        return function

    def words(self, function: Words) -> Words:
        """Decorator: this function maps a plan to a value for each `{name}` in the questions' texts."""
        self.words_function = function
        return function

    def acts(self, function: ActsOf) -> ActsOf:
        """Decorator: this function maps a plan to the acts of a learner who does all of it; for tests."""
        self.acts_function = function
        return function

    @property
    def file(self) -> Path:
        """The mystery's module, for `arena.play(mystery.file)`. Raises OurFault if there is none."""
        chapters = sorted(self._root.glob(f"chapters/{self.exercise[:3]}*"))
        found = (play_file(chapter, self.exercise) for chapter in chapters)
        file = next((file for file in found if file is not None), None)
        if file is None:
            raise OurFault(f"there is no play/{self.exercise}.py in the chapter", "Correct the id.")
        return file

    def plan(self, seeded: Seeded) -> Any:
        """Return the plan that belongs to a recording or an arena."""
        if seeded.seed is None:
            raise OurFault(f"no seed was given for {self.exercise}")
        return self.draw(seeded.seed)

    def draw(self, seed: int) -> Any:
        """Return the plan for a seed of this exercise (see `mystery_module.seed_for`)."""
        return load_mystery(self.file).draw(seed)

    def expect_act(
        self,
        recording: Recording,
        name: str,
        summary: str,
        *,
        near_miss: str | None = None,
        at_home: bool = False,
    ) -> None:
        """Check that the learner did the act with this name, which the mystery's nodes recorded.

        summary: what to say if they did not. near_miss: the name of acts that came close; the feedback
        shows their details. at_home: count only what was done at home, before this recording.
        """
        events = recording.events
        acts = acts_of(one for one in events if isinstance(one, Acted)) if at_home else recording.acts
        if any(act.name == name for act in acts):
            return
        close = [act.detail for act in acts if act.name == near_miss]
        raise Failure(
            Feedback(
                summary=summary,
                seen=", ".join(f"`{detail}`" for detail in close[-_SHOWN:]) or None,
                advice=f"Start the mystery in one terminal, `ros2course play {self.exercise}`, and do "
                "this in another terminal while it runs. It remembers what you did.",
            )
        )


def _no_words(_plan: Any) -> Mapping[str, object]:
    return {}


def _no_acts(_plan: Any) -> Sequence[str]:
    return ()


@dataclass(frozen=True)
class Number:
    """A number. tolerance: absolute, or a percentage like "10%". wrong: known wrong numbers, and why."""

    value: float
    tolerance: float | str = 0.0
    wrong: Mapping[float, str] = field(default_factory=dict)

    def put_into(self, question: Question) -> Question:
        """Return the question with this as its right answer."""
        tolerance = tolerance_of(self.value, self.tolerance)
        wrong = tuple(KnownAnswer(str(value), why) for value, why in self.wrong.items())
        return replace(question, form="number", value=self.value, tolerance=tolerance, wrong=wrong)


@dataclass(frozen=True, init=False)
class _Texts:
    texts: tuple[str, ...]
    exact: bool
    wrong: Mapping[str, str]

    def __init__(self, *texts: str, exact: bool = False, wrong: Mapping[str, str] | None = None) -> None:
        object.__setattr__(self, "texts", texts)
        object.__setattr__(self, "exact", exact)
        object.__setattr__(self, "wrong", dict(wrong or {}))

    def _into(self, question: Question) -> Question:
        wrong = tuple(KnownAnswer(text, why) for text, why in self.wrong.items())
        return replace(question, texts=self.texts, exact=self.exact, wrong=wrong)


class Text(_Texts):
    """Any of the given texts. Capitals and spaces do not matter unless `exact`."""

    def put_into(self, question: Question) -> Question:
        """Return the question with this as its right answer."""
        return replace(self._into(question), form="text")


class AllOf(_Texts):
    """Several texts that are all required, in any order."""

    def put_into(self, question: Question) -> Question:
        """Return the question with this as its right answer."""
        return replace(self._into(question), form="all_of")


@dataclass(frozen=True)
class OneOf:
    """Choices, one of which is right. wrong: the others, each with the reason why it is wrong."""

    right: str
    wrong: Mapping[str, str]

    def put_into(self, question: Question) -> Question:
        """Return the question with this as its right answer."""
        others = (Choice(text, text, False, why) for text, why in self.wrong.items())
        return replace(question, form="choice", choices=(Choice(self.right, self.right, True), *others))


Answer = Number | Text | AllOf | OneOf


_NAME = re.compile(r"\{([a-z_][a-z0-9_]*)\}")


def resolved(exercise: Exercise, mystery: Mystery, plan: Any) -> tuple[Question, ...]:
    """The exercise's questions for this plan. Raises OurFault if the lesson and the grader disagree."""
    answers = dict(mystery.answers_function(plan)) if mystery.answers_function else {}
    words = mystery.words_function(plan)
    computed = {question.id for question in exercise.questions if question.computed}
    for stranger in sorted(answers.keys() ^ computed):
        lacks = "the grader" if stranger in computed else "lesson.yaml"
        what = f"{lacks} has no computed answer `{stranger}` for {exercise.id}"
        raise OurFault(what + did_you_mean(stranger, (answers.keys() | computed) - {stranger}))
    return tuple(
        _filled(answers[question.id].put_into(question) if question.computed else question, words)
        for question in exercise.questions
    )


def fill(text: str, words: Mapping[str, object]) -> str:
    """`text` with each `{name}` replaced; other braces stay. Raises OurFault for an unknown name."""

    def word(match: re.Match[str]) -> str:
        if match[1] not in words:
            raise OurFault(f"the mystery has no word `{match[1]}`{did_you_mean(match[1], words)}")
        return str(words[match[1]])

    return _NAME.sub(word, text)


def _filled(question: Question, words: Mapping[str, object]) -> Question:
    choices = (
        Choice(fill(one.name, words), fill(one.text, words), one.right, _maybe(one.why, words))
        for one in question.choices
    )
    return replace(
        question,
        ask=fill(question.ask, words),
        choices=tuple(choices),
        texts=tuple(fill(text, words) for text in question.texts),
        wrong=tuple(KnownAnswer(fill(one.answer, words), fill(one.why, words)) for one in question.wrong),
        explain=_maybe(question.explain, words),
        otherwise=_maybe(question.otherwise, words),
    )


def _maybe(text: str | None, words: Mapping[str, object]) -> str | None:
    return None if text is None else fill(text, words)
