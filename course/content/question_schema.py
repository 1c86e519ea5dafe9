"""What a question in lesson.yaml may hold; see `schema`."""

from __future__ import annotations

import math
import re
from typing import Annotated, Any

from pydantic import AfterValidator, Field, WithJsonSchema

from course.content.schema_parts import Line, Slug, Strict, Text, one_of, wrong

_SHARE = r"^\d+(\.\d+)?\s?%$"


def _tolerance(value: Any) -> Any:
    is_share = isinstance(value, str) and re.fullmatch(_SHARE, value)
    is_width = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < math.inf
    if not is_share and not is_width:
        raise wrong(f"must be a number from 0 on, or a share like `10%`, not `{value}`")
    return value


def _short(value: Any) -> Any:
    if isinstance(value, bool) or not isinstance(value, str | int | float) or not str(value).strip():
        raise wrong("must be a text or a number (put it in quotes if it is a text)")
    return value


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise wrong(f"must be a number, not {value}")
    return value


def _worth(value: float) -> float:
    if not math.isfinite(value) or value < 0:
        raise wrong(f"must be a number from 0 on, not {value:g}")
    return value


class ChoiceSchema(Strict):
    """One entry of `choices`."""

    id: Slug | None = Field(
        default=None, description="a short name that stands for it in the answers file; its text if left out"
    )
    text: Line = Field(description="one line of Markdown, shown to choose from")
    right: bool = Field(default=False, description="`true` when it is right")
    why: Text | None = Field(default=None, description="an explanation; every wrong choice needs one")


class KnownSchema(Strict):
    """One entry of `wrong`: an answer that learners are known to give."""

    answer: Annotated[Any, AfterValidator(_short), WithJsonSchema({"type": ["string", "number"]})] = Field(
        description="a text or a number that is wrong"
    )
    why: Text = Field(description="what is wrong about it, without saying what is right")


class QuestionSchema(Strict):
    """One entry of `questions` in lesson.yaml; `question_problems` holds what spans keys."""

    model_config = one_of(("choices",), ("text",), ("all_of",), ("number",), ("computed",))

    id: Slug = Field(description="a short name in small letters, unique in the exercise: `tab-key`")
    ask: Text = Field(description="the question, in Markdown; its first line is the check's title")
    choices: list[ChoiceSchema] = Field(default=[], description="a list of choices, one of them right")
    multiple: bool = Field(default=False, description="`true` when several choices may be right")
    keep_order: bool = Field(default=False, description="`true` when choices are not to be shuffled")
    text: list[Line] = Field(default=[], description="a list of accepted short texts")
    all_of: list[Line] = Field(default=[], description="a list of short texts that are wanted all")
    exact: bool = Field(default=False, description="`true` when capitals and blanks in a text count")
    number: Annotated[float, AfterValidator(_finite)] | None = Field(default=None, description="the number")
    tolerance: Annotated[
        Any,
        AfterValidator(_tolerance),
        WithJsonSchema({"type": ["number", "string"], "minimum": 0, "pattern": _SHARE}),
    ] = Field(default=0.0, description="how far off a number may be: `0.5`, or `10%` of it")
    wrong: list[KnownSchema] = Field(default=[], description="a list of known wrong answers with `why`")
    explain: Text | None = Field(
        default=None, description="a text shown after a right answer, and after an unlisted wrong one"
    )
    otherwise: Text | None = Field(
        default=None, description="a text shown after an unlisted wrong answer, instead of `explain`"
    )
    computed: bool = Field(default=False, description="`true` when the chapter's mystery gives what is right")
    points: Annotated[float, AfterValidator(_worth)] = Field(default=1.0, description="points; 1 if left out")
