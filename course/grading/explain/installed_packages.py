"""Why a Python package was not installed, from the learner's files."""

from __future__ import annotations

from collections.abc import Iterator

from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.names import nearest
from course.grading.explain.python_code import text_places

_FIND = "packages=find_packages(exclude=['test'])"


def not_installed(sources: Sources, folder: str, package: str, error: str) -> Feedback:
    """Why `import package` (`garden.tools`) finds nothing where the ROS package in `folder` is installed.

    error: what Python said.
    """
    files = sources.below(folder).names
    for path in _outer_to_inner(package):
        holds_something = any(name.startswith(f"{folder}/{path}/") for name in files)
        if holds_something and f"{folder}/{path}/__init__.py" not in files:
            return _no_init(folder, path, error)
        if not holds_something:
            return _elsewhere(files, folder, path, error)
    return _left_out(sources, folder, package, error)


def packages_place(sources: Sources, folder: str) -> tuple[Location, ...]:
    """Where setup.py says which Python packages it installs."""
    file = f"{folder}/setup.py"
    places = tuple(place for place in text_places(sources, "packages") if place.file == file)
    given = tuple(place for place in places if "=" in sources.files[file].splitlines()[(place.line or 1) - 1])
    return given[:1] or (Location(file),)


def _outer_to_inner(package: str) -> Iterator[str]:
    """`garden`, `garden/tools` of `garden.tools`."""
    parts = package.split(".")
    yield from ("/".join(parts[:count]) for count in range(1, len(parts) + 1))


def _left_out(sources: Sources, folder: str, package: str, error: str) -> Feedback:
    name = package.rpartition(".")[2]
    return Feedback(
        summary=f"The folder {name} is not installed: it can be imported in the source folder only.",
        expected=_FIND,
        seen=error,
        where=packages_place(sources, folder),
        advice=f"In setup.py, `packages` must list this folder, too. Write `{_FIND}`: it finds all folders "
        "that have an `__init__.py`.",
    )


def _no_init(folder: str, path: str, error: str) -> Feedback:
    file = f"{path}/__init__.py"
    return Feedback(
        summary=f"{file} is missing, so that folder is no Python package and is not installed.",
        expected=file,
        seen=error,
        where=(Location(f"{folder}/{path}"),),
        advice=f"Make that file, in the package's folder: `touch {file}`. For the build it may be empty.",
    )


def _elsewhere(files: tuple[str, ...], folder: str, path: str, error: str) -> Feedback:
    name, wanted = path.rpartition("/")[2], f"{folder}/{path}"
    folders = {file.rpartition("/")[0] for file in files} - {folder}
    names = {place.rpartition("/")[2] for place in folders}
    near = name if name in names else nearest(name, names)
    where = tuple(Location(place) for place in sorted(folders) if near and place.endswith(f"/{near}"))[:1]
    if near == name:
        summary, advice = f"The folder {name} lies in the wrong place.", f"It belongs at `{wanted}`: move it."
    elif near:
        summary, advice = f"There is no folder {name}; there is `{near}`.", f"Rename it to `{name}`."
    else:
        summary = f"The package has no folder {path} with an `__init__.py` in it."
        advice = f"Make both: `{wanted}/__init__.py`. For the build the file may be empty."
    return Feedback(summary=summary, expected=wanted, seen=error, where=where, advice=advice)
