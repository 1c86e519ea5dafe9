"""Where the JSON Schemas of a course lie, which the first line of its lesson.yaml names."""

from __future__ import annotations

from pathlib import Path

from course.content.json_schema import Kind, schema_text

# The first is for a course that keeps its documents in docs/, as the one in this repository does.
_PLACES = ("docs/schema", ".schema")


def schema_folder(root: Path) -> str:
    """Relative to the course: the first place that holds one, else where they are to be made."""
    held = (place for place in _PLACES if (root / place / _name(Kind.LESSON)).is_file())
    return next(held, _PLACES[-1])


def missing_schemas(root: Path) -> dict[Path, str]:
    """Those that the course has not got, with their texts."""
    folder = root / schema_folder(root)
    wanted = {folder / _name(kind): kind for kind in Kind}
    return {file: schema_text(kind) for file, kind in wanted.items() if not file.exists()}


def _name(kind: Kind) -> str:
    return f"{kind.value}.schema.json"
