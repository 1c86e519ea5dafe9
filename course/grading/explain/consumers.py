"""Why another package cannot use a library of the learner's: what its package leaves out for others."""

from __future__ import annotations

import re
from collections.abc import Sequence

from course.build.digest.cpp import CppError, first_error
from course.evidence.packages import BuiltPackage
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.cmake_lists import LISTS, Command, commands
from course.grading.explain.cpp_code import cpp_files, places_of
from course.grading.explain.names import listed

_OTHERS = "Your package builds, but another one that uses it does not"
_TARGETS = re.compile(r"(?<![\w:])\w+::\w+")
_NO_TARGET = re.compile(r"imported targets are referenced, but are missing|but the target was not found")
_NO_FOLDER = re.compile(r"non-existent path")
_NO_FILE = re.compile(r"references the file|this file does not exist")
_HEADER = re.compile(r"^(?P<header>\S+): No such file or directory$")
_SHOWN = 4


def not_configured(lines: Sequence[str], package: BuiltPackage, sources: Sources) -> Feedback:
    """CMake's words on a package that says `find_package` of the learner's, to their cause."""
    said = re.sub(r"\s+", " ", " ".join(lines))
    every = commands(sources, package.source)
    if _NO_TARGET.search(said):
        return _dependencies(said, package, every)
    if _NO_FOLDER.search(said):
        return _headers(package, every)
    if _NO_FILE.search(said):
        return _library(package, every)
    return Feedback(
        summary=f"{_OTHERS}: `find_package({package.name})` fails.",
        where=(_lists(package),),
        advice="Compare what stands behind `ament_export_` and `install` with the lesson's example.",
        details=tuple(line for line in lines if line.strip())[-_SHOWN:],
    )


def not_compiled(lines: Sequence[str], package: BuiltPackage, sources: Sources) -> Feedback:
    """The same for what the compiler and the linker say of it."""
    error = first_error(lines, lambda file: _own(file, package, sources))
    every = commands(sources, package.source)
    if error is None:
        return Feedback(
            summary=f"{_OTHERS}.",
            where=(_lists(package),),
            advice="Use your library from a small package of your own, and read the first error.",
            details=tuple(lines)[-_SHOWN:],
        )
    if error.kind == "compiler":
        if found := _HEADER.match(error.text):
            return _no_header(found["header"], package, every, sources)
        return _code(error, package, sources)
    return _unlinked(error, package, every, sources)


def not_loaded(library: str, package: BuiltPackage, sources: Sources) -> Feedback:
    """A program finds the library where colcon says where it is, and nowhere else."""
    exports = _named(commands(sources, package.source), "ament_export_targets")
    return Feedback(
        summary=f"A program of another package does not find `{library}` when it starts.",
        expected="LD_LIBRARY_PATH holds the library's folder after sourcing",
        where=tuple(one.where for one in exports[:1]) or (_lists(package),),
        advice="`ament_export_targets(... HAS_LIBRARY_TARGET)` says that there is a library to be found. "
        "colcon helps without; others do not.",
    )


def _dependencies(said: str, package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    exports = _named(every, "ament_export_dependencies")
    links = [one for one in every if one.name in ("target_link_libraries", "ament_target_dependencies")]
    known = {word for one in exports for word in one.words}
    # CMake names only the first; the others are missed as soon as that one is found.
    linked = (word for one in links[:1] for word in one.words)
    every_target = (*_TARGETS.findall(said), *(word for word in linked if _TARGETS.fullmatch(word)))
    foreign = [n for n in dict.fromkeys(every_target) if not n.startswith(f"{package.name}::")]
    targets = [name for name in foreign if _package_of(name) not in known] or foreign[:1]
    names = list(dict.fromkeys(map(_package_of, targets)))
    where = (*exports[:1], *(one for one in links if set(one.words) & {*targets, *names}))
    return Feedback(
        summary=f"{_OTHERS}: it does not find {listed(targets)}, which your library needs.",
        expected=f"ament_export_dependencies({' '.join(names)})",
        seen="no such line" if not exports else f"ament_export_dependencies({' '.join(exports[0].words)})",
        where=tuple(one.where for one in where) or (_lists(package),),
        advice=f"Add `ament_export_dependencies({' '.join(names)})` before `ament_package()`: "
        "whoever finds your library finds these first.",
    )


def _package_of(target: str) -> str:
    """`Qt5Core` for `Qt5::Core`, `Eigen3` for `Eigen3::Eigen`."""
    package, _, part = target.partition("::")
    return f"{package}{part}" if package == "Qt5" else package


def _headers(package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    installs = [one for one in _named(every, "install") if one.words[:1] == ("DIRECTORY",)]
    return Feedback(
        summary=f"{_OTHERS}: the header is not installed where your package says it is.",
        expected=f"include/{package.name}/ in the folder where the package is installed",
        where=tuple(one.where for one in installs[:1]) or (_lists(package),),
        advice="`install(DIRECTORY include/ DESTINATION include)`: with the `/`, what is in it is copied.",
    )


def _library(package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    installs = [one for one in _named(every, "install") if one.words[:1] == ("TARGETS",)]
    return Feedback(
        summary=f"{_OTHERS}: the library itself is not where your package says it is.",
        where=tuple(one.where for one in installs[:1]) or (_lists(package),),
        advice="`install(TARGETS ... LIBRARY DESTINATION lib)` puts a shared library into the folder `lib`.",
    )


def _no_header(header: str, package: BuiltPackage, every: Sequence[Command], sources: Sources) -> Feedback:
    if not header.startswith(f"{package.name}/"):
        return Feedback(
            summary=f"{_OTHERS}: your header includes `{header}`, which is not found there.",
            where=places_of(sources, rf"#\s*include\s*[<\"]\s*{re.escape(header)}")[:2] or (_lists(package),),
            advice="Include it in the .cpp file, where it is used. Or name its package in "
            "`ament_export_dependencies`.",
        )
    installed = [one for one in _named(every, "install") if one.words[:1] == ("DIRECTORY",)]
    if not installed:
        return _headers(package, every)
    exports = [one for one in every if one.name.startswith("ament_export_") and "depend" not in one.name]
    includes = _named(every, "target_include_directories")
    return Feedback(
        summary=f"{_OTHERS}: it does not find `{header}`.",
        where=tuple(one.where for one in (*exports, *includes, *installed))[:2],
        advice="Others look where `INSTALL_INTERFACE` says, and `install(DIRECTORY include/ ...)` has to put "
        "the folder just there."
        if exports
        else f"Tell others of the library: `ament_export_targets(export_{package.name} HAS_LIBRARY_TARGET)`.",
    )


def _code(error: CppError, package: BuiltPackage, sources: Sources) -> Feedback:
    """Their program asks for something that the header does not offer in this way."""
    headers = [Location(file) for file in cpp_files(sources) if "/include/" in file]
    place = (Location(error.file, error.line),) if error.file else tuple(headers[:1])
    return Feedback(
        summary=f"Another package cannot use the class as the task says: {error.text[:70]}.",
        where=place or (_lists(package),),
        advice="Compare the header with the task: names, arguments, `static`, and `const` behind what "
        "changes nothing.",
        details=tuple(re.sub(r"^/\S*/", "", line) for line in error.details),
    )


def _unlinked(error: CppError, package: BuiltPackage, every: Sequence[Command], sources: Sources) -> Feedback:
    name = error.text.split("(")[0].rpartition("::")[2] or error.text
    exported = _named(every, "ament_export_targets") or _named(every, "ament_export_libraries")
    if not exported:
        return Feedback(
            summary=f"{_OTHERS}: it is not told of the library, so nothing defines `{error.text}`.",
            where=(_lists(package),),
            advice=f"Add `ament_export_targets(export_{package.name} HAS_LIBRARY_TARGET)`, and "
            "`EXPORT` with that name to the `install` of the library.",
        )
    return Feedback(
        summary=f"Your header promises `{error.text}`, but nothing in the library defines it.",
        where=places_of(sources, rf"\b{re.escape(name)}\s*\(")[:2] or (_lists(package),),
        advice="Define it in a .cpp file that `add_library` lists, with the same arguments, and its class "
        "in front if it is a member.",
    )


def _own(file: str, package: BuiltPackage, sources: Sources) -> str | None:
    """The learner's header behind the installed one."""
    if not file.startswith(package.prefix):
        return None
    name = file.partition("/include/")[2]
    return next((own for own in cpp_files(sources) if name and own.endswith(f"/{name}")), None)


def _named(every: Sequence[Command], name: str) -> list[Command]:
    return [one for one in every if one.name == name]


def _lists(package: BuiltPackage) -> Location:
    return Location(f"{package.source}/{LISTS}")
