"""Builds packages of the underlay when something needs them for the first time."""

from __future__ import annotations

import re
from collections.abc import Iterable
from math import inf

from course.build.builder import Progress, build
from course.build.package_sources import TooMuch, source_files
from course.build.runner import Interrupt
from course.build.store import Store, storage
from course.build.workspace import Package, Workspace
from course.errors import OurFault
from course.rosenv import Ros, add_to_underlay, compiled_of_underlay, missing_of_underlay, underlay_builds
from course.rosenv.underlay import UnderlayPackage, source_root

# Seconds for a package. These are our own, and do end, but a busy machine needs time.
_TIME_LIMIT = 1800.0
# Files in which packages name the interfaces that they use.
_TEXTS = (".py", ".cpp", ".hpp", ".h", ".msg", ".srv", ".action", ".txt", ".xml")
_LISTS = ("CMakeLists.txt",)
_TESTS, _END = re.compile(rb"\s*if\s*\(\s*BUILD_TESTING\b"), re.compile(rb"\s*endif\b")
_FIND = re.compile(rb"\s*find_package\s*\(\s*(?P<name>\w+)")


def provide(
    workspace: Workspace,
    names: Iterable[str],
    ros: Ros,
    *,
    on_progress: Progress = lambda text: None,
    interrupt: Interrupt | None = None,
) -> None:
    """Build whatever the packages `names` of the workspace may need from the underlay.

    Installed ROS packages can be used without declaring them, so what CMake is told to find counts, too, and
    interfaces that a source file mentions.
    Takes almost no time if everything is there. Raises what `build_underlay` raises.
    """
    missing = missing_of_underlay(ros)
    if not missing:
        return
    packages = [package for name in names for package in workspace.named(name)]
    needed = [
        candidate.name
        for candidate in missing
        if any(_needs(package, workspace, candidate) for package in packages)
    ]
    build_underlay(needed, ros, on_progress=on_progress, interrupt=interrupt)


def build_underlay(
    names: Iterable[str],
    ros: Ros,
    *,
    on_progress: Progress = lambda text: None,
    interrupt: Interrupt | None = None,
) -> None:
    """Build these packages of the underlay and put them in place; quick if that was done before.

    Raises OurFault if one does not build, MissingHere and StorageError for what this machine lacks, and
    Interrupted when `interrupt` is set.
    """
    root, names = source_root(), tuple(names)
    if not names or root is None:
        return
    store = Store(underlay_builds(ros), keep_bytes=inf)  # what is built is used where it is
    outcome = build(
        Workspace.scan(root),
        names,
        ros,
        store,
        on_progress=on_progress,
        interrupt=interrupt,
        time_limit=_TIME_LIMIT,
    )
    if outcome.failure is not None:
        log = f" Everything it printed: {outcome.failure.log}" if outcome.failure.log else ""
        raise OurFault(
            f"{outcome.failure.package} of the course's own packages does not build here: "
            f"{outcome.failure.feedback.summary}{log}"
        )
    compiled = {package.name for package in compiled_of_underlay(ros)}
    for package in outcome.packages:
        if package.name in compiled:  # the others are in place as they are
            add_to_underlay(ros, package.prefix)


def _needs(package: Package, workspace: Workspace, candidate: UnderlayPackage) -> bool:
    name = candidate.name.encode()
    return (
        package.depends_on(candidate.name)
        or any(_finds(text, name) for text in _texts(package, workspace, _LISTS))
        or (bool(candidate.interfaces) and any(name in text for text in _texts(package, workspace, _TEXTS)))
    )


def _texts(package: Package, workspace: Workspace, endings: tuple[str, ...]) -> list[bytes]:
    try:
        with storage(package.folder):
            files = [f for f in source_files(package.folder, workspace.home) if f.name.endswith(endings)]
            return [file.path.read_bytes() for file in files if file.link is None]
    except TooMuch:
        return []  # the build says so


def _finds(text: bytes, name: bytes) -> bool:
    """Whether CMake has to find `name`. Dependencies of tests do not count: no tests are built."""
    for_tests = False
    for line in text.splitlines():
        for_tests = bool(_TESTS.match(line)) or (for_tests and not _END.match(line))
        found = _FIND.match(line)
        if found and found["name"] == name and not for_tests:
            return True
    return False
