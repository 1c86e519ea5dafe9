"""Turns what pydantic found wrong with a file into errors that an author can act on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar, get_args

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from course.content.document import Document, Place, key_text, read_document
from course.errors import ContentError
from course.spelling import close_names, did_you_mean

S = TypeVar("S", bound=BaseModel)
T = TypeVar("T")

_WANTED = {
    "string_type": "a string",
    "int_type": "a whole number",
    "float_type": "a number",
    "bool_type": "`true` or `false`",
    "list_type": "a list",
    "model_type": "a mapping of keys to values",
    "dict_type": "a mapping of keys to values",
}


@dataclass(frozen=True)
class Reading(Generic[T]):
    """A file's content; `value` is None if the file is missing, or `problems` make it unusable."""

    value: T | None
    problems: tuple[ContentError, ...] = ()
    document: Document | None = None

    def line(self, place: Place) -> int | None:
        """The line of a place in the file; None if there is no such file."""
        return self.document.line(place) if self.document else None


def read_checked(file: Path, schema: type[S], convert: Callable[[Document, S], Reading[T]]) -> Reading[T]:
    """Check a file against the schema, and convert its content if it fits."""
    try:
        document = read_document(file)
    except ContentError as error:
        return Reading(None, (error,))
    found, problems = validated(document, schema)
    return Reading(None, problems, document) if found is None else convert(document, found)


def validated(document: Document, schema: type[S]) -> tuple[S | None, tuple[ContentError, ...]]:
    """The document with defaults filled in, or None; and everything that is wrong with it."""
    try:
        found = schema.model_validate(document.data)
    except ValidationError as error:
        wrong = error.errors(include_url=False)
        misspelt = _misspelt(schema, wrong)
        told = (_explain(document, schema, details) for details in wrong if details["loc"] not in misspelt)
        return None, (*document.repeated, *told)
    return (None if document.repeated else found), document.repeated


def _misspelt(schema: type[BaseModel], found: list[ErrorDetails]) -> set[Place]:
    """Keys that are missing only because they are misspelled; the error about the unknown key says so."""
    unknown = [details["loc"] for details in found if details["type"] == "extra_forbidden"]
    meant = (
        (*place[:-1], name)
        for place in unknown
        for name in close_names(str(place[-1]), _fields(_model_at(schema, place[:-1])), 1)
    )
    missing = {details["loc"] for details in found if details["type"] == "missing"}
    return missing & set(meant)


def _explain(document: Document, schema: type[BaseModel], details: ErrorDetails) -> ContentError:
    place = details["loc"]
    if details["type"] == "missing":
        return _missing(document, schema, place)
    if details["type"] == "extra_forbidden":
        return _unknown(document, schema, place)
    field = _field_at(schema, place)
    what = f"{_subject(place)} {_complaint(details)}"
    allowed = f"allowed: {field.description}" if field and field.description else None
    return document.error(what, allowed, place=place)


def _missing(document: Document, schema: type[BaseModel], place: Place) -> ContentError:
    field = _field_at(schema, place)
    return document.error(
        f"`{place[-1]}` is missing",
        f"add `{place[-1]}`: {field.description}" if field else None,
        place=place,
    )


def _unknown(document: Document, schema: type[BaseModel], place: Place) -> ContentError:
    known = list(_fields(_model_at(schema, place[:-1])))
    name = str(place[-1])
    where = f" in {_subject(place[:-1])}" if len(place) > 1 else ""
    what = f"`{name}` is not a key{where}{did_you_mean(name, known)}"
    return document.error(what, f"allowed: {', '.join(known)}", place=place)


def _complaint(details: ErrorDetails) -> str:
    wanted = _WANTED.get(details["type"])
    if wanted:
        return f"must be {wanted}, not {_kind(details['input'])}"
    return details["msg"]


def _kind(value: object) -> str:
    """What the value is called in YAML, not in Python."""
    if value is None:
        return "empty"
    if isinstance(value, bool):
        return f"`{str(value).lower()}` (put it in quotes if it is a string)"
    if isinstance(value, Mapping):
        return "a mapping (put it in quotes if it is a string)"
    if isinstance(value, list):
        return "a list"
    if isinstance(value, str):
        return "a string"
    return f"`{value}` (put it in quotes if it is a string)"


def _subject(place: Place) -> str:
    return f"`{key_text(place)}`" if place else "the file"


def _field_at(schema: type[BaseModel], place: Place) -> FieldInfo | None:
    """The field that contains a place: for an item of a list, the list."""
    named = [index for index, part in enumerate(place) if isinstance(part, str)]
    if not named:
        return None
    last = named[-1]
    return _fields(_model_at(schema, place[:last])).get(str(place[last]))


def _model_at(schema: type[BaseModel], place: Place) -> type[BaseModel]:
    for part in place:
        field = _fields(schema).get(part) if isinstance(part, str) else None
        schema = (_model_in(field.annotation) if field else None) or schema
    return schema


def _model_in(annotation: Any) -> type[BaseModel] | None:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next(filter(None, map(_model_in, get_args(annotation))), None)


def _fields(schema: type[BaseModel]) -> dict[str, FieldInfo]:
    """The fields by their names in files: `with` for Python's `with_`."""
    return {field.alias or name: field for name, field in schema.model_fields.items()}
