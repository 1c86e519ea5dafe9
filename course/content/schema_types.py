"""The words that schemas are written in: texts, ids, paths. Each complains as an author needs it."""

from __future__ import annotations

import math
import re
from pathlib import PurePosixPath
from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, WithJsonSchema
from pydantic_core import PydanticCustomError

# As patterns, for Python and for the JSON Schema that editors check with.
_EXERCISE_ID = r"\d\d-[a-z0-9]+(-[a-z0-9]+)*"
_SLUG = r"[a-z0-9]+([-_][a-z0-9]+)*"
_PACKAGE = r"[a-z][a-z0-9_-]*"
_WORKSPACE = r"[a-z][a-z0-9_]*_workspace"
_OCTAL = r"0?[0-7]{3}"
_URL = r"https://[^\s/]+/\S*"


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
    if not re.fullmatch(_EXERCISE_ID, text):
        raise wrong(f"must look like `18-publisher`, not `{text}`")
    return text


def _slug(text: str) -> str:
    if not re.fullmatch(_SLUG, text):
        raise wrong(f"must be small letters, digits and dashes, not `{text}`")
    return text


def _package(text: str) -> str:
    if not re.fullmatch(_PACKAGE, text):
        raise wrong(f"must be the name of a ROS package (small letters, digits, underscores), not `{text}`")
    return text


def _workspace(text: str) -> str:
    if not re.fullmatch(_WORKSPACE, text):
        raise wrong(f"must be a folder whose name ends with `_workspace`, not `{text}`")
    return text


def _home_path(text: str) -> str:
    path = PurePosixPath(text)
    if not path.parts or path.is_absolute() or {"..", "~"} & set(path.parts) or "\\" in text:
        raise wrong(f"must be a file inside the course home, not `{text}`")
    if str(path) != text:
        raise wrong(f"must be written `{path}`, not `{text}`")
    return text


def _octal(text: str) -> str:
    if not re.fullmatch(_OCTAL, text):
        raise wrong(f"must be an octal mode in quotes, like `'755'`, not `{text}`")
    return text


def _url(text: str) -> str:
    if not re.fullmatch(_URL, text):
        raise wrong(f"must look like `https://docs.ros.org/en/jazzy/`, not `{text}`")
    return text


def _seconds(value: float) -> float:
    if not math.isfinite(value) or not 0 < value <= 3600:
        raise wrong(f"must be more than 0 and at most 3600 seconds, not {value:g}")
    return value


def one_of(*groups: tuple[str, ...]) -> ConfigDict:
    """For editors: the keys of exactly one of these groups are given."""
    return ConfigDict(json_schema_extra={"oneOf": [{"required": list(group)} for group in groups]})


def unempty(items: list[str]) -> list[str]:
    if not items:
        raise wrong("must not be an empty list")
    return items


def _like(pattern: str) -> WithJsonSchema:
    return WithJsonSchema({"type": "string", "pattern": pattern})


Text = Annotated[str, AfterValidator(_filled), _like(r"\S")]
Line = Annotated[str, AfterValidator(_one_line), _like(r"^\s*\S[^\n]*\s*$")]
ExerciseId = Annotated[str, AfterValidator(_exercise_id), _like(f"^{_EXERCISE_ID}$")]
Slug = Annotated[str, AfterValidator(_slug), _like(f"^{_SLUG}$")]
Package = Annotated[str, AfterValidator(_package), _like(f"^{_PACKAGE}$")]
Workspace = Annotated[str, AfterValidator(_workspace), _like(f"^{_WORKSPACE}$")]
HomePath = Annotated[str, AfterValidator(_home_path), _like(r"^(?!/|~|\./)[^\\]+$")]
Mode = Annotated[str, AfterValidator(_octal), _like(f"^{_OCTAL}$")]
Url = Annotated[str, AfterValidator(_url), _like(f"^{_URL}$")]
Seconds = Annotated[
    float,
    AfterValidator(_seconds),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": 3600}),
]


class Strict(BaseModel):
    """No unknown keys, and no number where a text is meant."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)
