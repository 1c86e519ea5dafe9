"""JSON Schemas of the files that an author writes, made of the models that the course itself reads them by.

An editor that knows them (by the first line of the file) completes keys and checks while one types. What
several files or keys together must hold, only `ros2course validate` knows.
"""

from __future__ import annotations

import json
from enum import Enum
from typing import Any

from pydantic import BaseModel
from pydantic.json_schema import GenerateJsonSchema

from course.content.schema import AlternativeSchema, LessonSchema, MistakesSchema

_DIALECT = "https://json-schema.org/draft/2020-12/schema"


class Kind(str, Enum):
    """The files that have a schema, as they are called in `ros2course schema KIND`."""

    LESSON = "lesson"
    MISTAKES = "mistakes"
    ALTERNATIVE = "alternative"


_MODELS: dict[Kind, type[BaseModel]] = {
    Kind.LESSON: LessonSchema,
    Kind.MISTAKES: MistakesSchema,
    Kind.ALTERNATIVE: AlternativeSchema,
}


class _Plain(GenerateJsonSchema):
    """Without a title for each key, which would only repeat its name."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        return False


def json_schema(kind: Kind) -> dict[str, Any]:
    """The schema of `lesson.yaml`, `mistakes.yaml` or `alternative.yaml`, in draft 2020-12."""
    made = _MODELS[kind].model_json_schema(by_alias=True, schema_generator=_Plain)
    head = {"$schema": _DIALECT, "$id": f"urn:ros2course:{kind.value}", "title": f"{kind.value}.yaml"}
    return {**head, **{key: value for key, value in made.items() if key != "title"}}


def schema_text(kind: Kind) -> str:
    """The same as the text of a file."""
    return json.dumps(json_schema(kind), indent=2, ensure_ascii=False) + "\n"
