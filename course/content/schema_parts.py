"""The words that schemas are written in: texts, ids, paths. Each complains as an author needs it."""

from __future__ import annotations

import math
import re
from pathlib import PurePosixPath
from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict
from pydantic_core import PydanticCustomError


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


def unempty(items: list[str]) -> list[str]:
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
