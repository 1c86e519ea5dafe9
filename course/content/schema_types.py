"""The types that schemas use: texts, ids, paths. Their error messages are written for authors."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, GetCoreSchemaHandler, WithJsonSchema
from pydantic_core import CoreSchema, PydanticCustomError
from pydantic_core.core_schema import no_info_after_validator_function


def wrong(message: str) -> PydanticCustomError:
    """An error whose message continues after the key's name: `must be ...`."""
    # Pydantic treats braces as placeholders, but a message may quote braces from the file.
    return PydanticCustomError("rule", "{message}", {"message": message})


def _filled(text: str) -> str:
    if not text.strip():
        raise wrong("must not be empty")
    return text


def _one_line(text: str) -> str:
    if "\n" in _filled(text).strip():
        raise wrong("must be a single line")
    return text.strip()


def _home_path(text: str) -> str:
    path = PurePosixPath(text)
    if not path.parts or path.is_absolute() or {"..", "~"} & set(path.parts) or "\\" in text:
        raise wrong(f"must be a file inside the course home, not `{text}`")
    if str(path) != text:
        raise wrong(f"must be written `{path}`, not `{text}`")
    return text


def _seconds(value: float) -> float:
    if not math.isfinite(value) or not 0 < value <= 3600:
        raise wrong(f"must be more than 0 and at most 3600 seconds, not {value:g}")
    return value


def one_of(*groups: tuple[str, ...]) -> ConfigDict:
    """Tells editors that the keys of exactly one of these groups must be given."""
    return ConfigDict(json_schema_extra={"oneOf": [{"required": list(group)} for group in groups]})


def unempty(items: list[str]) -> list[str]:
    if not items:
        raise wrong("must not be an empty list")
    return items


@dataclass(frozen=True)
class Form:
    """What a text must look like, for Python and for the JSON Schema that editors check with.

    must: completes the complaint `must ..., not ...`.
    """

    pattern: str
    must: str

    def __get_pydantic_core_schema__(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return no_info_after_validator_function(self._matching, handler(kind))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: Any) -> dict[str, str]:
        return {"type": "string", "pattern": f"^{self.pattern}$"}

    def _matching(self, text: str) -> str:
        if not re.fullmatch(self.pattern, text):
            raise wrong(f"must {self.must}, not `{text}`")
        return text


def _like(pattern: str) -> WithJsonSchema:
    return WithJsonSchema({"type": "string", "pattern": pattern})


Text = Annotated[str, AfterValidator(_filled), _like(r"\S")]
Line = Annotated[str, AfterValidator(_one_line), _like(r"^\s*\S[^\n]*\s*$")]
ExerciseId = Annotated[str, Form(r"\d\d-[a-z0-9]+(-[a-z0-9]+)*", "look like `18-publisher`")]
Slug = Annotated[str, Form(r"[a-z0-9]+([-_][a-z0-9]+)*", "be lowercase letters, digits, dashes, or `_`")]
Package = Annotated[
    str, Form("[a-z][a-z0-9_-]*", "be the name of a ROS package (lowercase letters, digits, `_`, dashes)")
]
Workspace = Annotated[str, Form("[a-z][a-z0-9_]*_workspace", "be a folder whose name ends with `_workspace`")]
HomePath = Annotated[str, AfterValidator(_home_path), _like(r"^(?!/|~|\./)[^\\]+$")]
Mode = Annotated[str, Form("0?[0-7]{3}", "be an octal mode in quotes, like `'755'`")]
Url = Annotated[str, Form(r"https://[^\s/]+/\S*", "look like `https://docs.ros.org/en/jazzy/`")]
Seconds = Annotated[
    float,
    AfterValidator(_seconds),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": 3600}),
]


class Strict(BaseModel):
    """Allows no unknown keys, and no number where a text is expected."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)
