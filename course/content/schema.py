"""What lesson.yaml, mistakes.yaml and alternative.yaml may hold.

Only this file and `explain` import pydantic, and only when a file is read that was not found right before.
A field's description says what is allowed there: error messages and the authors' documentation show it.
"""

from __future__ import annotations

import math
import re
from pathlib import PurePosixPath
from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator
from pydantic_core import PydanticCustomError
from typing_extensions import Self

FEWEST_HINTS = 3
OPERATIONS = ("replace", "delete", "rename", "content", "mode")


def wrong(message: str) -> PydanticCustomError:
    """A complaint that reads on after the key: `must be ...`."""
    # Braces are placeholders to pydantic; a message may quote some from the file.
    return PydanticCustomError("rule", "{message}", {"message": message})


def _filled(text: str) -> str:
    if not text.strip():
        raise wrong("must not be empty")
    return text


def _one_line(text: str) -> str:
    if "\n" in _filled(text).strip():
        raise wrong("must be a single line")
    return text.strip()


def _exercise_id(text: str) -> str:
    if not re.fullmatch(r"\d\d-[a-z0-9]+(-[a-z0-9]+)*", text):
        raise wrong(f"must look like `18-publisher`, not `{text}`")
    return text


def _slug(text: str) -> str:
    if not re.fullmatch(r"[a-z0-9]+([-_][a-z0-9]+)*", text):
        raise wrong(f"must be small letters, digits and dashes, not `{text}`")
    return text


def _package(text: str) -> str:
    if not re.fullmatch(r"[a-z][a-z0-9_-]*", text):
        raise wrong(f"must be the name of a ROS package (small letters, digits, underscores), not `{text}`")
    return text


def _home_path(text: str) -> str:
    path = PurePosixPath(text)
    if not path.parts or path.is_absolute() or {"..", "~"} & set(path.parts) or "\\" in text:
        raise wrong(f"must be a file inside the course home, not `{text}`")
    if str(path) != text:
        raise wrong(f"must be written `{path}`, not `{text}`")
    return text


def _octal(text: str) -> str:
    if not re.fullmatch(r"0?[0-7]{3}", text):
        raise wrong(f"must be an octal mode in quotes, like `'755'`, not `{text}`")
    return text


def _seconds(value: float) -> float:
    if not math.isfinite(value) or not 0 < value <= 3600:
        raise wrong(f"must be more than 0 and at most 3600 seconds, not {value:g}")
    return value


def _enough(hints: list[str]) -> list[str]:
    if len(hints) < FEWEST_HINTS:
        raise wrong(f"must hold at least {FEWEST_HINTS} hints, not {len(hints)}")
    return hints


def _unempty(items: list[str]) -> list[str]:
    if not items:
        raise wrong("must not be an empty list")
    return items


Text = Annotated[str, AfterValidator(_filled)]
Line = Annotated[str, AfterValidator(_one_line)]
ExerciseId = Annotated[str, AfterValidator(_exercise_id)]
Slug = Annotated[str, AfterValidator(_slug)]
Package = Annotated[str, AfterValidator(_package)]
HomePath = Annotated[str, AfterValidator(_home_path)]
Mode = Annotated[str, AfterValidator(_octal)]
Seconds = Annotated[float, AfterValidator(_seconds)]


class Strict(BaseModel):
    """No unknown keys, and no number where a text is meant."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)


class ExerciseSchema(Strict):
    """One entry of `exercises` in lesson.yaml."""

    id: ExerciseId = Field(description="the chapter's two digits, a dash and a name: `18-publisher`")
    title: Line = Field(description="one line, shown as the exercise's heading")
    summary: Line = Field(description="one line that says what the learner will do")
    packages: list[Package] = Field(default=[], description="a list of ROS packages that are built for it")
    grader_packages: list[Package] = Field(
        default=[], description="a list of packages whose reference build the grader itself needs"
    )
    requires: list[ExerciseId] = Field(
        default=[], description="a list of ids of the exercises whose work this one stands on"
    )
    files: list[HomePath] = Field(
        default=[], description="a list of the learner's files, relative to the course home"
    )
    time_limit: Seconds = Field(default=60.0, description="seconds that grading may take; 60 if left out")
    hints: Annotated[list[Text], AfterValidator(_enough)] = Field(
        description=f"a list of at least {FEWEST_HINTS} Markdown texts, from a nudge to nearly the answer"
    )
    after: Text | None = Field(default=None, description="a Markdown text shown after a pass")


class LessonSchema(Strict):
    """lesson.yaml: one chapter and its exercises, in the order in which they are done."""

    chapter: int = Field(description="the chapter's number, as in its folder's name")
    title: Line = Field(description="one line, shown as the chapter's heading")
    summary: Line = Field(description="one line that says what the chapter is about")
    exercises: list[ExerciseSchema] = Field(description="a list of exercises; `[]` if there are none")


class EditSchema(Strict):
    """One entry of `edits` in mistakes.yaml: a file, and exactly one thing that is done to it."""

    file: HomePath = Field(description="a file of the solution, relative to the course home")
    replace: Text | None = Field(default=None, description="a text that occurs in the file; needs `with`")
    with_: str | None = Field(default=None, alias="with", description="the text put in its place")
    delete: bool = Field(default=False, description="`true`: the file is deleted")
    rename: HomePath | None = Field(default=None, description="the file's new path")
    content: str | None = Field(default=None, description="the whole new file")
    mode: Mode | None = Field(default=None, description="the file's octal mode in quotes, like `'755'`")

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
    edits: Annotated[list[EditSchema], AfterValidator(_unempty)] = Field(
        description="a list of edits of the reference solution"
    )
    caught_by: Line = Field(description="the id of the check that must fail")
    says: Annotated[list[Text], AfterValidator(_unempty)] = Field(
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

    exercises: Annotated[list[ExerciseId], AfterValidator(_unempty)] = Field(
        description="a list of ids of the exercises that this solves too"
    )
    summary: Line = Field(description="one line that says in what it differs")
    deletes: list[HomePath] = Field(
        default=[], description="a list of the reference solution's files that are not in this one"
    )
