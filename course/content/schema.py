"""What lesson.yaml, mistakes.yaml and alternative.yaml may hold.

Only the schemas and `explain` import pydantic, and only when a file is read that was not found right before.
A field's description says what is allowed there: error messages and the authors' documentation show it.
"""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import (
    AfterValidator,
    ConfigDict,
    Field,
    ValidationInfo,
    WithJsonSchema,
    field_validator,
    model_validator,
)
from typing_extensions import Self

from course.content.layout import WORKSPACE
from course.content.question_schema import QuestionSchema
from course.content.schema_parts import (
    ExerciseId,
    HomePath,
    Line,
    Mode,
    Package,
    Seconds,
    Slug,
    Strict,
    Text,
    Workspace,
    one_of,
    unempty,
    wrong,
)

FEWEST_HINTS = 3
OPERATIONS = ("replace", "delete", "rename", "content", "mode", "answers")


class ExerciseSchema(Strict):
    """One entry of `exercises` in lesson.yaml."""

    # For editors: what `_enough` says.
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

    id: ExerciseId = Field(description="the chapter's two digits, a dash and a name: `18-publisher`")
    title: Line = Field(description="one line, shown as the exercise's heading")
    summary: Line = Field(description="one line that says what the learner will do")
    packages: list[Package] = Field(default=[], description="a list of ROS packages that are built for it")
    workspace: Workspace = Field(
        default=WORKSPACE, description=f"the workspace that these lie in; `{WORKSPACE}` if left out"
    )
    grader_packages: list[Package] = Field(
        default=[], description="a list of packages whose reference build the grader itself needs"
    )
    requires: list[ExerciseId] = Field(
        default=[], description="a list of ids of the exercises whose work this one stands on"
    )
    files: list[HomePath] = Field(
        default=[], description="a list of the learner's files, relative to the course home"
    )
    looks_at: list[HomePath] = Field(
        default=[],
        description="a list of more files, folders or patterns (`*/*.txt`) of the course home that "
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
        """Fewer will do for a quiz: each of its questions explains itself."""
        writes_programs = info.data.get("questions") == [] or bool(info.data.get("packages"))
        if len(hints) < FEWEST_HINTS and writes_programs:
            raise wrong(f"must hold at least {FEWEST_HINTS} hints, not {len(hints)}")
        return hints


class LessonSchema(Strict):
    """lesson.yaml: one chapter and its exercises, in the order in which they are done."""

    chapter: int = Field(description="the chapter's number, as in its folder's name")
    title: Line = Field(description="one line, shown as the chapter's heading")
    summary: Line = Field(description="one line that says what the chapter is about")
    exercises: list[ExerciseSchema] = Field(description="a list of exercises; `[]` if there are none")


def _answer_given(value: Any) -> Any:
    items = value if isinstance(value, list) else [value]
    if not all(isinstance(item, str) for item in items):
        raise wrong(f"must be a text or a list of texts, not `{value}` (put it in quotes)")
    return value


# As it stands in the answers file: a text, a number in quotes, or a list of texts.
AnswerGiven = Annotated[
    Any,
    AfterValidator(_answer_given),
    WithJsonSchema({"type": ["string", "array"], "items": {"type": "string"}}),
]


class EditSchema(Strict):
    """One entry of `edits` in mistakes.yaml: a file, and exactly one thing that is done to it."""

    model_config = one_of(("replace", "with"), *((name,) for name in OPERATIONS if name != "replace"))

    file: HomePath = Field(description="a file of the solution, relative to the course home")
    replace: Text | None = Field(default=None, description="a text that occurs in the file; needs `with`")
    with_: str | None = Field(default=None, alias="with", description="the text put in its place")
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
            raise wrong(f"must hold exactly one of {', '.join(OPERATIONS)}; it holds {found}")
        if (self.replace is None) != (self.with_ is None):
            raise wrong("must hold `replace` and `with` together")
        return self


class MistakeSchema(Strict):
    """One entry of `mistakes` in mistakes.yaml."""

    id: Slug = Field(description="a short name in small letters, unique in this file: `topic-misspelt`")
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


class MistakesSchema(Strict):
    """mistakes.yaml: what learners of this chapter are known to get wrong."""

    mistakes: list[MistakeSchema] = Field(description="a list of mistakes")


class AlternativeSchema(Strict):
    """alternative.yaml: another right way to solve exercises of the chapter."""

    exercises: Annotated[list[ExerciseId], AfterValidator(unempty)] = Field(
        description="a list of ids of the exercises that this solves too"
    )
    summary: Line = Field(description="one line that says in what it differs")
    deletes: list[HomePath] = Field(
        default=[], description="a list of the reference solution's files that are not in this one"
    )
    answers: dict[Slug, AnswerGiven] = Field(
        default={}, description="question ids with other right answers; the other answers stay"
    )
