"""A question of a quiz, as it is asked and judged. Plain data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

Form = Literal["choice", "choices", "text", "all_of", "number"]


@dataclass(frozen=True)
class Choice:
    """One of several answers to choose from.

    name: what stands for it in the answers file: its id, else its text. why: the explanation.
    """

    name: str
    text: str
    right: bool
    why: str | None = None


@dataclass(frozen=True)
class Known:
    """A wrong answer that is known, and why it is wrong."""

    answer: str
    why: str


@dataclass(frozen=True)
class Question:
    """One question. `ask` is Markdown, and so are the explanations.

    form: `choice` and `choices` (several may be right) use `choices`; `text` holds the accepted
    texts; `all_of` holds texts that are wanted all, in any order; `number` uses `value` and
    `tolerance`. exact: texts count to the letter. explain: shown after a right answer, and after
    a wrong one that is not known unless `otherwise` is given. computed: what is right is drawn
    by the exercise's mystery; form and right answers here mean nothing until it has been asked.
    """

    id: str
    ask: str
    form: Form
    choices: tuple[Choice, ...] = ()
    texts: tuple[str, ...] = ()
    exact: bool = False
    value: float = 0.0
    tolerance: float = 0.0
    wrong: tuple[Known, ...] = ()
    explain: str | None = None
    otherwise: str | None = None
    points: float = 1.0
    keep_order: bool = False
    computed: bool = False


def question_of(data: dict[str, Any]) -> Question:
    """A Question of one entry of `questions` in lesson.yaml, which has been checked."""
    value = float(data["number"] or 0)
    return Question(
        id=data["id"],
        ask=data["ask"].strip(),
        form=_form(data),
        choices=tuple(_choice(item) for item in data["choices"]),
        texts=tuple(data["text"] or data["all_of"]),
        exact=data["exact"],
        value=value,
        tolerance=tolerance_of(value, data["tolerance"]),
        wrong=tuple(Known(str(item["answer"]), item["why"]) for item in data["wrong"]),
        explain=data["explain"],
        otherwise=data["otherwise"],
        points=float(data["points"]),
        keep_order=data["keep_order"],
        computed=data["computed"],
    )


def tolerance_of(value: float, written: float | str) -> float:
    """How far off an answer may be; `10%` is of the right value."""
    if isinstance(written, str):
        return abs(value) * float(written.rstrip("% ")) / 100
    return float(written)


def _choice(data: dict[str, Any]) -> Choice:
    text = data["text"].strip()
    return Choice(data["id"] or " ".join(text.split()), text, data["right"], data["why"])


def _form(data: dict[str, Any]) -> Form:
    if data["choices"]:
        return "choices" if data["multiple"] else "choice"
    if data["number"] is not None:
        return "number"
    return "all_of" if data["all_of"] else "text"
