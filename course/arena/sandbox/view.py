"""Which files of the machine a submission's programs can read, beside the system's own."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

import course
from course.rosenv import Ros, places_of
from course.rosenv.variables import LISTS

# Shown as the system itself.
_SYSTEM = tuple(Path(name) for name in ("/usr", "/bin", "/sbin", "/lib", "/lib64"))
# What our own programs need that run among the learner's.
_ARENA = Path(course.__file__).parent / "arena"
_OURS = ("probe_program.py", "type_probe.py")


def shown(ros: Ros, environment: Mapping[str, str], more: Iterable[Path] = ()) -> tuple[str, ...]:
    """The ROS, the Pythons, what `environment` (see `node_environment`) leads to, and `more`."""
    lists = (name for name in LISTS if name != "PATH")  # on it are folders of the learner's own
    found = (
        *(Path(entry) for name in lists for entry in environment.get(name, "").split(":") if entry),
        *places_of(ros),
        *(Path(prefix) for prefix in (sys.prefix, sys.exec_prefix, sys.base_prefix, sys.base_exec_prefix)),
        *(_ARENA / name for name in _OURS),
        *more,
    )
    # A link that leads there needs what it leads to.
    everything = dict.fromkeys(place for path in found for place in (path, path.resolve()))
    return tuple(str(path) for path in _outermost(everything) if path.exists())


def _outermost(paths: Iterable[Path]) -> list[Path]:
    kept: list[Path] = []
    for path in sorted(paths, key=lambda path: len(path.parts)):
        below = any(path.is_relative_to(other) for other in (*_SYSTEM, *kept))
        if path != Path("/") and not (below and not _within_course(path)):
            kept.append(path)
    return kept


def _within_course(path: Path) -> bool:
    return path.is_relative_to(Path(course.__file__).parent)


def hidden(shown: Iterable[str]) -> tuple[str, ...]:
    """The course itself, with its graders and solutions, where it lies in what is shown."""
    own = Path(course.__file__).parent
    places = {own, own.resolve()}
    around = [*_SYSTEM, *(Path(path) for path in shown)]
    return tuple(
        str(place)
        for place in sorted(places)
        if any(place.is_relative_to(path) and place != path for path in around)
    )
