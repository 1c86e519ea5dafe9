"""Finds the course that is meant by a folder or by the name of an installed package."""

from __future__ import annotations

from importlib.machinery import PathFinder
from pathlib import Path

from course.content.names import did_you_mean
from course.errors import UsageError

# A package holds a course as its own folders, or beside its code in a folder of its own.
_INSIDE = ("", "_course")


def named_course(name: str) -> Path:
    """The folder of that name, else the course in the installed package of that name; nothing is imported.

    Raises UsageError when it can only be a package and is none. A folder need not be a course yet.
    """
    folder = Path(name).expanduser()
    if folder.exists() or not name.isidentifier():
        return folder
    found = PathFinder.find_spec(name)
    if found is None:
        near = did_you_mean(name, (path.name for path in Path().iterdir() if path.is_dir()))
        what = f"there is no course folder `{name}` here, and no installed package of that name{near}"
        raise UsageError(what, "give the course's folder: `--course DIR`")
    return _inside(name, tuple(map(Path, found.submodule_search_locations or ())))


def _inside(name: str, places: tuple[Path, ...]) -> Path:
    roots = (place / inside for place in places for inside in _INSIDE)
    course = next((root for root in roots if (root / "chapters").is_dir()), None)
    if course is None:
        where = f" ({places[0]})" if places else ""
        raise UsageError(
            f"the installed package {name}{where} holds no course",
            "a course holds chapters/, graders/ and solutions/",
        )
    return course
