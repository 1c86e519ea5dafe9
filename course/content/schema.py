"""What lesson.yaml, mistakes.yaml and alternative.yaml may contain.

In this folder, only the `schema*` modules import pydantic, and only a file that is not cached needs them.
A field's description says what is allowed there: error messages and the authors' documentation show it.
"""

from __future__ import annotations

import json
import math
import re
from enum import Enum
from typing import Annotated, Any

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    ValidationInfo,
    WithJsonSchema,
    field_validator,
    model_validator,
)
from pydantic.json_schema import GenerateJsonSchema
from typing_extensions import Self

from course.content.layout import WORKSPACE
from course.content.schema_types import (
    ExerciseId,
    Form,
    HomePath,
    Line,
    Mode,
    Package,
    Seconds,
    Slug,
    Strict,
    Text,
    Url,
    Workspace,
    one_of,
    unempty,
    wrong,
)

_SHARE = r"^\d+(\.\d+)?\s?%$"


Script = Annotated[
    str,
    Form(r"[a-z0-9_]+\.(cpp|py|sh)", "be the name of a script, like `count.py`, `count.sh`, or `count.cpp`"),
]


def _tolerance(value: Any) -> Any:
    is_share = isinstance(value, str) and re.fullmatch(_SHARE, value)
    is_width = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < math.inf
    if not is_share and not is_width:
        raise wrong(f"must be a number of at least 0, or a share like `10%`, not `{value}`")
    return value


def _short(value: Any) -> Any:
    if isinstance(value, bool) or not isinstance(value, str | int | float) or not str(value).strip():
        raise wrong("must be a string or a number (put it in quotes if it is a string)")
    return value


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise wrong(f"must be a number, not {value}")
    return value


def _worth(value: float) -> float:
    if not math.isfinite(value) or value <= 0:
        raise wrong(f"must be a number greater than 0, not {value:g}")
    return value


class ChoiceSchema(Strict):
    """One entry of `choices`."""

    id: Slug | None = Field(
        default=None, description="a short name that stands for it in the answers file; its text if left out"
    )
    text: Line = Field(description="one line of Markdown, shown as a choice")
    right: bool = Field(default=False, description="`true` when it is right")
    why: Text | None = Field(default=None, description="an explanation; every wrong choice needs one")


class KnownSchema(Strict):
    """One entry of `wrong`: an answer that learners are known to give."""

    answer: Annotated[Any, AfterValidator(_short), WithJsonSchema({"type": ["string", "number"]})] = Field(
        description="a string or a number that is wrong"
    )
    why: Text = Field(description="what is wrong about it, without saying what is right")


class QuestionSchema(Strict):
    """One entry of `questions` in lesson.yaml; `question_problems` holds what spans keys."""

    model_config = one_of(("choices",), ("text",), ("all_of",), ("number",), ("computed",))

    id: Slug = Field(description="a short name in lowercase letters, unique in the exercise: `tab-key`")
    ask: Text = Field(description="the question, in Markdown; its first line is the check's title")
    choices: list[ChoiceSchema] = Field(default=[], description="a list of choices, one of them right")
    multiple: bool = Field(default=False, description="`true` when several choices may be right")
    keep_order: bool = Field(default=False, description="`true` when choices must not be shuffled")
    text: list[Line] = Field(default=[], description="a list of accepted short texts")
    all_of: list[Line] = Field(default=[], description="a list of short texts, all of which are required")
    exact: bool = Field(default=False, description="`true` when capitals and spaces in an answer count")
    number: Annotated[float, AfterValidator(_finite)] | None = Field(default=None, description="the number")
    tolerance: Annotated[
        Any,
        AfterValidator(_tolerance),
        WithJsonSchema({"type": ["number", "string"], "minimum": 0, "pattern": _SHARE}),
    ] = Field(default=0.0, description="how far off a number may be: `0.5`, or `10%` of it")
    wrong: list[KnownSchema] = Field(default=[], description="a list of known wrong answers with `why`")
    explain: Text | None = Field(
        default=None, description="text shown after a right answer, and after an unlisted wrong one"
    )
    otherwise: Text | None = Field(
        default=None, description="text shown after an unlisted wrong answer, instead of `explain`"
    )
    program: Script = Field(
        default="",
        description="a script in the chapter's folder `programs`, shown with the question and run after "
        "the answer; choices show each line of its output in backquotes",
    )
    computed: bool = Field(default=False, description="`true`: the chapter's mystery computes the answer")
    points: Annotated[float, AfterValidator(_worth)] = Field(default=1.0, description="points; 1 if left out")


FEWEST_HINTS = 3
OPERATIONS = ("replace", "delete", "rename", "content", "mode", "answers")


class ExerciseSchema(Strict):
    """One entry of `exercises` in lesson.yaml."""

    # Tells editors what `_enough` checks.
    model_config = ConfigDict(
        json_schema_extra={
            "anyOf": [
                {"required": ["hints"], "properties": {"hints": {"minItems": FEWEST_HINTS}}},
                {
                    "required": ["questions"],
                    "properties": {"questions": {"minItems": 1}, "packages": {"maxItems": 0}},
                },
            ]
        }
    )

    id: ExerciseId = Field(description="the chapter's two digits, a dash, and a name: `18-publisher`")
    title: Line = Field(description="one line, shown as the exercise's heading")
    summary: Line = Field(description="one line that says what the learner will do")
    step: Line = Field(
        default="",
        description="a heading (`##`) of lesson.md: `next` shows the lesson from there up to the next "
        "exercise's `step`; the exercises without one belong to the step before",
    )
    packages: list[Package] = Field(default=[], description="a list of ROS packages that are built for it")
    workspace: Workspace = Field(
        default=WORKSPACE, description=f"the workspace that contains them; `{WORKSPACE}` if left out"
    )
    grader_packages: list[Package] = Field(
        default=[], description="a list of packages whose reference build the grader itself needs"
    )
    requires: list[ExerciseId] = Field(
        default=[], description="a list of ids of the exercises that this one builds on"
    )
    files: list[HomePath] = Field(
        default=[], description="a list of the learner's files, relative to the course home"
    )
    looks_at: list[HomePath] = Field(
        default=[],
        description="a list of more files, folders, or patterns (`*/*.txt`) of the course home that "
        "the grader looks at",
    )
    bonus: bool = Field(default=False, description="`true`: the course is complete without this exercise")
    local_only: bool = Field(
        default=False, description="`true`: about the learner's own machine, and no part of a submission"
    )
    time_limit: Seconds = Field(default=60.0, description="seconds that grading may take; 60 if left out")
    questions: list[QuestionSchema] = Field(default=[], description="a list of questions: a quiz")
    hints: list[Text] = Field(
        default=[],
        validate_default=True,
        description=f"a list of at least {FEWEST_HINTS} Markdown texts, from a nudge to nearly the answer; "
        "a quiz may have fewer",
    )
    after: Text | None = Field(default=None, description="a Markdown text shown after a pass")

    @field_validator("hints")
    @classmethod
    def _enough(cls, hints: list[str], info: ValidationInfo) -> list[str]:
        """A quiz may have fewer: each question has its own explanations."""
        writes_programs = info.data.get("questions") == [] or bool(info.data.get("packages"))
        if len(hints) < FEWEST_HINTS and writes_programs:
            raise wrong(f"must contain at least {FEWEST_HINTS} hints, not {len(hints)}")
        return hints


class LessonSchema(Strict):
    """lesson.yaml: one chapter and its exercises, in the order in which they are done."""

    chapter: int = Field(description="the chapter's number, as in its folder's name")
    title: Line = Field(description="one line, shown as the chapter's heading")
    summary: Line = Field(description="one line that says what the chapter is about")
    links: dict[Line, Url] = Field(
        default={},
        description="the official pages of what the chapter teaches, by title; "
        "the lesson ends with them, under `Read more`",
    )
    terms: list[Line] = Field(
        default=[],
        description="words that the lesson explains, each in bold where it does; "
        "`validate` reports texts that use them earlier",
    )
    exercises: list[ExerciseSchema] = Field(description="a list of exercises; `[]` if there are none")


def _answer_given(value: Any) -> Any:
    items = value if isinstance(value, list) else [value]
    if not all(isinstance(item, str) for item in items):
        raise wrong(f"must be a string or a list of strings, not `{value}` (put it in quotes)")
    return value


# As written in the answers file: a text, a number in quotes, or a list of texts.
AnswerGiven = Annotated[
    Any,
    AfterValidator(_answer_given),
    WithJsonSchema({"type": ["string", "array"], "items": {"type": "string"}}),
]


class EditSchema(Strict):
    """One entry of `edits` in mistakes.yaml: a file, and exactly one thing that is done to it."""

    model_config = one_of(("replace", "with"), *((name,) for name in OPERATIONS if name != "replace"))

    file: HomePath = Field(description="a file of the solution, relative to the course home")
    replace: Text | None = Field(default=None, description="text that occurs in the file; needs `with`")
    with_: str | None = Field(default=None, alias="with", description="the text that replaces it")
    delete: bool = Field(default=False, description="`true`: the file is deleted")
    rename: HomePath | None = Field(default=None, description="the file's new path")
    content: str | None = Field(default=None, description="the whole new file")
    mode: Mode | None = Field(default=None, description="the file's octal mode in quotes, like `'755'`")
    answers: dict[Slug, AnswerGiven] | None = Field(
        default=None, description="question ids with other answers; the rest of the file stays right"
    )

    @model_validator(mode="after")
    def _one_operation(self) -> Self:
        given = [name for name in OPERATIONS if getattr(self, name) not in (None, False)]
        if len(given) != 1:
            found = " and ".join(f"`{name}`" for name in given) or "none"
            raise wrong(f"must contain exactly one of {', '.join(OPERATIONS)}; it contains {found}")
        if (self.replace is None) != (self.with_ is None):
            raise wrong("must contain both `replace` and `with`")
        return self


class MistakeSchema(Strict):
    """One entry of `mistakes` in mistakes.yaml."""

    id: Slug = Field(description="a short name in lowercase letters, unique in this file: `topic-misspelt`")
    exercise: ExerciseId = Field(description="the id of the exercise whose grader must catch it")
    summary: Line = Field(description="one line that says what the learner did")
    edits: Annotated[list[EditSchema], AfterValidator(unempty)] = Field(
        description="a list of edits of the reference solution"
    )
    caught_by: Line = Field(description="the id of the check that must fail")
    says: Annotated[list[Text], AfterValidator(unempty)] = Field(
        description="a list of texts that the feedback must contain"
    )
    also_fails: list[Line] = Field(
        default=[], description="a list of ids of other checks that this mistake rightly fails too"
    )
    leads_to: Line | None = Field(
        default=None,
        description="part of the line that the feedback points at, if the mistake doesn't change that line: "
        "`setup.py`, `create_timer`",
    )


class MistakesSchema(Strict):
    """mistakes.yaml: what learners of this chapter are known to get wrong."""

    mistakes: list[MistakeSchema] = Field(description="a list of mistakes")


class AlternativeSchema(Strict):
    """alternative.yaml: another right way to solve exercises of the chapter."""

    exercises: Annotated[list[ExerciseId], AfterValidator(unempty)] = Field(
        description="a list of ids of the exercises that this solves too"
    )
    summary: Line = Field(description="one line that says how it differs")
    deletes: list[HomePath] = Field(
        default=[], description="a list of the reference solution's files that are not in this one"
    )
    answers: dict[Slug, AnswerGiven] = Field(
        default={}, description="question ids with other right answers; the other answers stay"
    )


_DIALECT = "https://json-schema.org/draft/2020-12/schema"


class Kind(str, Enum):
    """The files that have a schema, by their names in `ros2course schema KIND`."""

    LESSON = "lesson"
    MISTAKES = "mistakes"
    ALTERNATIVE = "alternative"


_MODELS: dict[Kind, type[BaseModel]] = {
    Kind.LESSON: LessonSchema,
    Kind.MISTAKES: MistakesSchema,
    Kind.ALTERNATIVE: AlternativeSchema,
}


class _Plain(GenerateJsonSchema):
    """Leaves out the title of each key, which would only repeat its name."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        return False


def json_schema(kind: Kind) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of `lesson.yaml`, `mistakes.yaml` or `alternative.yaml`."""
    made = _MODELS[kind].model_json_schema(by_alias=True, schema_generator=_Plain)
    head = {"$schema": _DIALECT, "$id": f"urn:ros2course:{kind.value}", "title": f"{kind.value}.yaml"}
    return {**head, **{key: value for key, value in made.items() if key != "title"}}


def schema_text(kind: Kind) -> str:
    """The same schema as formatted JSON."""
    return json.dumps(json_schema(kind), indent=2, ensure_ascii=False) + "\n"
