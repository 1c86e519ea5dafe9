"""From the questions of a lesson to those of one learner: drawn names filled in, right answers computed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from course.content import Choice, Exercise, Known, Question
from course.content.names import did_you_mean
from course.errors import OurFault
from course.grading.mystery.author import Mystery

_NAME = re.compile(r"\{([a-z_][a-z0-9_]*)\}")


def resolved(exercise: Exercise, mystery: Mystery, plan: Any) -> tuple[Question, ...]:
    """The exercise's questions for this plan. Raises OurFault where lesson and grader do not agree."""
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
    """`text` with each `{name}` replaced. Other braces stay. Raises OurFault for an unknown name."""

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
        wrong=tuple(Known(fill(one.answer, words), fill(one.why, words)) for one in question.wrong),
        explain=_maybe(question.explain, words),
        otherwise=_maybe(question.otherwise, words),
    )


def _maybe(text: str | None, words: Mapping[str, object]) -> str | None:
    return None if text is None else fill(text, words)
