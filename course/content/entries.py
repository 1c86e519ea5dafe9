"""The entries of a course's files: questions, known mistakes, other solutions. Plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

# One question's entry in an answers file.
Given = str | list[str]
Form = Literal["choice", "choices", "text", "all_of", "number"]


@dataclass(frozen=True)
class Choice:
    """One of several answers to choose from.

    name: what to write in the answers file to choose it: its id, or its text if it has no id. why: the
    explanation.
    """

    name: str
    text: str
    right: bool
    why: str | None = None


@dataclass(frozen=True)
class KnownAnswer:
    """A known wrong answer, and why it is wrong."""

    answer: str
    why: str


@dataclass(frozen=True)
class Question:
    """One question. `ask` and the explanations are Markdown.

    form: `choice` and `choices` (several may be right) use `choices`; `text` uses `texts`, any of which is
    accepted; `all_of` requires all of `texts`, in any order; `number` uses `value` and `tolerance`. exact:
    texts must match to the letter. explain: shown after a right answer, and after an unlisted wrong one
    unless `otherwise` is given. computed: the exercise's mystery supplies the form and the right answer;
    until then, both mean nothing. program: a script whose output is the answer; `ask` ends with its code.
    """

    id: str
    ask: str
    form: Form
    choices: tuple[Choice, ...] = ()
    texts: tuple[str, ...] = ()
    exact: bool = False
    value: float = 0.0
    tolerance: float = 0.0
    wrong: tuple[KnownAnswer, ...] = ()
    explain: str | None = None
    otherwise: str | None = None
    points: float = 1.0
    keep_order: bool = False
    computed: bool = False
    program: Path | None = None


_LANGUAGES = {".cpp": "cpp", ".py": "python", ".sh": "bash"}


def question_of(data: dict[str, Any], program: Path | None = None, code: str = "") -> Question:
    """Make a Question from one checked entry of `questions` in lesson.yaml."""
    value = float(data["number"] or 0)
    shown = f"\n\n```{_LANGUAGES[program.suffix]}\n{code.rstrip()}\n```" if program else ""
    return Question(
        id=data["id"],
        ask=data["ask"].strip() + shown,
        form=_form(data),
        choices=tuple(_choice(item) for item in data["choices"]),
        texts=tuple(data["text"] or data["all_of"]),
        exact=data["exact"],
        value=value,
        tolerance=tolerance_of(value, data["tolerance"]),
        wrong=tuple(KnownAnswer(str(item["answer"]), item["why"]) for item in data["wrong"]),
        explain=data["explain"],
        otherwise=data["otherwise"],
        points=float(data["points"]),
        keep_order=data["keep_order"],
        computed=data["computed"],
        program=program,
    )


def tolerance_of(value: float, written: float | str) -> float:
    """How far off an answer may be; `10%` means 10% of the right value."""
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


@dataclass(frozen=True)
class Edit:
    """One change to a file of a solution. Apart from `file`, exactly one operation is set.

    file, rename: relative to the course home. replace: a text that occurs in the file; all its
    occurrences become `with_`. content: the whole new file. mode: octal, like "755". delete and rename
    also work on a folder. answers: question ids, each with the answer that replaces the right one in an
    answers file.
    """

    file: str
    replace: str | None = None
    with_: str | None = None
    delete: bool = False
    rename: str | None = None
    content: str | None = None
    mode: str | None = None
    answers: Mapping[str, Given] | None = None


@dataclass(frozen=True)
class Mistake:
    """A mistake that learners make: edits of the reference solution, and how it must be caught.

    caught_by: id of the check that must fail. says: texts that its feedback must contain.
    also_fails: ids of the other checks that rightly fail too; no further ones may. leads_to: part of the line
    that the feedback points at, if it is not a line that the mistake changes.
    """

    id: str
    exercise: str
    summary: str
    edits: tuple[Edit, ...]
    caught_by: str
    says: tuple[str, ...]
    also_fails: tuple[str, ...] = ()
    leads_to: str | None = None


@dataclass(frozen=True)
class Alternative:
    """Another right solution: `tree` is copied over the reference solution.

    tree: laid out like the course home, except for alternative.yaml itself.
    deletes: files of the reference solution that are not in this one. answers: other right answers to
    questions, by the question's id.
    """

    name: str
    exercises: tuple[str, ...]
    summary: str
    deletes: tuple[str, ...]
    tree: Path
    answers: Mapping[str, Given] = field(default_factory=dict)
