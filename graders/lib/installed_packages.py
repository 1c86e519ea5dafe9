"""Why a Python package was not installed, according to the learner's files."""

from __future__ import annotations

from collections.abc import Iterator

from course.api import Feedback, Location, Sources, nearest, packages_place

_FIND = "packages=find_packages(exclude=['test'])"


def not_installed(sources: Sources, folder: str, package: str, error: str) -> Feedback:
    """Why `import package` (`garden.tools`) finds nothing where the ROS package in `folder` is installed.

    error: Python's message.
    """
    files = sources.below(folder).names
    for path in _outer_to_inner(package):
        holds_something = any(name.startswith(f"{folder}/{path}/") for name in files)
        if holds_something and f"{folder}/{path}/__init__.py" not in files:
            return _no_init(folder, path, error)
        if not holds_something:
            return _elsewhere(files, folder, path, error)
    return _left_out(sources, folder, package, error)


def _outer_to_inner(package: str) -> Iterator[str]:
    """`garden`, then `garden/tools`, for `garden.tools`."""
    parts = package.split(".")
    yield from ("/".join(parts[:count]) for count in range(1, len(parts) + 1))


def _left_out(sources: Sources, folder: str, package: str, error: str) -> Feedback:
    name = package.rpartition(".")[2]
    return Feedback(
        summary=f"The folder {name} is not installed: only code in the source folder can import it.",
        expected=_FIND,
        seen=error,
        where=packages_place(sources, folder),
        advice=f"In setup.py, `packages` must list this folder, too. Write `{_FIND}`: it finds all folders "
        "that have an `__init__.py`.",
    )


def _no_init(folder: str, path: str, error: str) -> Feedback:
    file = f"{path}/__init__.py"
    return Feedback(
        summary=f"{file} is missing, so that folder is not a Python package and is not installed.",
        expected=file,
        seen=error,
        where=(Location(f"{folder}/{path}"),),
        advice=f"Create it in the package's folder: `touch {file}`. For the build, it may be empty.",
    )


def _elsewhere(files: tuple[str, ...], folder: str, path: str, error: str) -> Feedback:
    name, wanted = path.rpartition("/")[2], f"{folder}/{path}"
    folders = {file.rpartition("/")[0] for file in files} - {folder}
    names = {place.rpartition("/")[2] for place in folders}
    near = name if name in names else nearest(name, names)
    where = tuple(Location(place) for place in sorted(folders) if near and place.endswith(f"/{near}"))[:1]
    if near == name:
        summary, advice = f"The folder {name} is in the wrong place.", f"It belongs at `{wanted}`: move it."
    elif near:
        summary, advice = f"The folder {name} does not exist, but `{near}` does.", f"Rename it to `{name}`."
    else:
        summary = f"The package has no folder {path} with an `__init__.py` in it."
        advice = f"Create the folder and `{wanted}/__init__.py`. An empty file is enough for the build."
    return Feedback(summary=summary, expected=wanted, seen=error, where=where, advice=advice)
