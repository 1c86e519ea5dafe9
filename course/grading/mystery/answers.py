"""What is right, as a mystery's author computes it from a plan. Each is put into a question.

Number(plan.rate, tolerance="10%", wrong={1 / plan.rate: "That is the period."})
Text(plan.type, wrong={...})
AllOf(plan.topic, plan.misspelt)
OneOf(right=plan.node, wrong={other: "That one only listens." for other in plan.others})
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from course.content import Choice, Known, Question
from course.content.question import tolerance_of


@dataclass(frozen=True)
class Number:
    """A number. tolerance: absolute, or a share like "10%". wrong: known wrong ones and why."""

    value: float
    tolerance: float | str = 0.0
    wrong: Mapping[float, str] = field(default_factory=dict)

    def put_into(self, question: Question) -> Question:
        tolerance = tolerance_of(self.value, self.tolerance)
        wrong = tuple(Known(str(value), why) for value, why in self.wrong.items())
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
        wrong = tuple(Known(text, why) for text, why in self.wrong.items())
        return replace(question, texts=self.texts, exact=self.exact, wrong=wrong)


class Text(_Texts):
    """A text: any of those given. Capitals and blanks do not count unless `exact`."""

    def put_into(self, question: Question) -> Question:
        return replace(self._into(question), form="text")


class AllOf(_Texts):
    """Texts that are wanted all, in any order."""

    def put_into(self, question: Question) -> Question:
        return replace(self._into(question), form="all_of")


@dataclass(frozen=True)
class OneOf:
    """Choices, of which one is right. wrong: the others, each with why it is wrong."""

    right: str
    wrong: Mapping[str, str]

    def put_into(self, question: Question) -> Question:
        others = (Choice(text, text, False, why) for text, why in self.wrong.items())
        return replace(question, form="choice", choices=(Choice(self.right, self.right, True), *others))


Answer = Number | Text | AllOf | OneOf
