"""Why another package cannot use the learner's library, such as something that is not exported."""

from __future__ import annotations

import re
from collections.abc import Sequence

from course.api import (
    BuiltPackage,
    Command,
    CppError,
    Feedback,
    Location,
    Sources,
    commands,
    cpp_files,
    first_error,
    listed,
    places_of,
)

_OTHERS = "Your package builds, but a package that uses it does not"
_TARGETS = re.compile(r"(?<![\w:])\w+::\w+")
_NO_TARGET = re.compile(r"imported targets are referenced, but are missing|but the target was not found")
_NO_FOLDER = re.compile(r"non-existent path")
_NO_FILE = re.compile(r"references the file|this file does not exist")
_HEADER = re.compile(r"^(?P<header>\S+): No such file or directory$")
_SHOWN = 4


def not_configured(lines: Sequence[str], package: BuiltPackage, sources: Sources) -> Feedback:
    """The cause of CMake's errors in a package that finds the learner's with `find_package`."""
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
        advice="Compare the arguments of `ament_export_...` and `install` with the lesson's example.",
        details=tuple(line for line in lines if line.strip())[-_SHOWN:],
    )


def not_compiled(lines: Sequence[str], package: BuiltPackage, sources: Sources) -> Feedback:
    """The cause of the compiler's or the linker's errors in such a package."""
    error = first_error(lines, lambda file: _own(file, package, sources))
    every = commands(sources, package.source)
    if error is None:
        return Feedback(
            summary=f"{_OTHERS}.",
            where=(_lists(package),),
            advice="Write a small package that uses your library, build it, and read the first error.",
            details=tuple(lines)[-_SHOWN:],
        )
    if error.kind == "compiler":
        if found := _HEADER.match(error.text):
            return _no_header(found["header"], package, every, sources)
        return _code(error, package, sources)
    return _unlinked(error, package, every, sources)


def not_loaded(library: str, package: BuiltPackage, sources: Sources) -> Feedback:
    """Why the program finds the library only through the folders that colcon adds."""
    exports = _named(commands(sources, package.source), "ament_export_targets")
    return Feedback(
        summary=f"A program in another package cannot find `{library}` when it starts.",
        expected="the library's folder in LD_LIBRARY_PATH after sourcing",
        where=tuple(one.where for one in exports[:1]) or (_lists(package),),
        advice=(
            "Write `ament_export_targets(... HAS_LIBRARY_TARGET)`. It adds the library's folder to "
            "LD_LIBRARY_PATH. Otherwise, only colcon does that."
        ),
    )


def _dependencies(said: str, package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    exports = _named(every, "ament_export_dependencies")
    links = [one for one in every if one.name in ("target_link_libraries", "ament_target_dependencies")]
    known = {word for one in exports for word in one.words}
    # CMake reports only the first one. It would report the others once that one is found.
    linked = (word for one in links[:1] for word in one.words)
    every_target = (*_TARGETS.findall(said), *(word for word in linked if _TARGETS.fullmatch(word)))
    foreign = [n for n in dict.fromkeys(every_target) if not n.startswith(f"{package.name}::")]
    targets = [name for name in foreign if _package_of(name) not in known] or foreign[:1]
    names = list(dict.fromkeys(map(_package_of, targets)))
    where = (*exports[:1], *(one for one in links if set(one.words) & {*targets, *names}))
    return Feedback(
        summary=f"{_OTHERS}: it cannot find {listed(targets)}, which your library needs.",
        expected=f"ament_export_dependencies({' '.join(names)})",
        seen="no such line" if not exports else f"ament_export_dependencies({' '.join(exports[0].words)})",
        where=tuple(one.where for one in where) or (_lists(package),),
        advice=(
            f"Add `ament_export_dependencies({' '.join(names)})` before `ament_package()`. Then CMake "
            "finds these packages along with your library."
        ),
    )


def _package_of(target: str) -> str:
    """`Qt5Core` for `Qt5::Core`, `Eigen3` for `Eigen3::Eigen`."""
    package, _, part = target.partition("::")
    return f"{package}{part}" if package == "Qt5" else package


def _headers(package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    installs = [one for one in _named(every, "install") if one.words[:1] == ("DIRECTORY",)]
    return Feedback(
        summary=f"{_OTHERS}: the header is not in the folder that your package names.",
        expected=f"include/{package.name}/ in the package's install folder",
        where=tuple(one.where for one in installs[:1]) or (_lists(package),),
        advice=(
            "Write `install(DIRECTORY include/ DESTINATION include)`. The `/` copies the folder's contents."
        ),
    )


def _library(package: BuiltPackage, every: Sequence[Command]) -> Feedback:
    installs = [one for one in _named(every, "install") if one.words[:1] == ("TARGETS",)]
    return Feedback(
        summary=f"{_OTHERS}: the library is not in the folder that your package names.",
        where=tuple(one.where for one in installs[:1]) or (_lists(package),),
        advice="Install it in the folder `lib`: `install(TARGETS ... LIBRARY DESTINATION lib)`.",
    )


def _no_header(header: str, package: BuiltPackage, every: Sequence[Command], sources: Sources) -> Feedback:
    if not header.startswith(f"{package.name}/"):
        return Feedback(
            summary=f"{_OTHERS}: it cannot find `{header}`, which your header includes.",
            where=places_of(sources, rf"#\s*include\s*[<\"]\s*{re.escape(header)}")[:2] or (_lists(package),),
            advice=(
                "Include it only in the .cpp file that uses it, or add its package to "
                "`ament_export_dependencies`."
            ),
        )
    installed = [one for one in _named(every, "install") if one.words[:1] == ("DIRECTORY",)]
    nested = [one for one in installed if one.words[1:2] == ("include",)]
    if not installed or any((one.after("DESTINATION") or "").endswith("include") for one in nested):
        return _headers(package, nested or every)
    exports = [one for one in every if one.name.startswith("ament_export_") and "depend" not in one.name]
    includes = _named(every, "target_include_directories")
    return Feedback(
        summary=f"{_OTHERS}: it cannot find `{header}`.",
        where=tuple(one.where for one in (*exports, *includes, *installed))[:2],
        advice=(
            "Other packages look in the folder named in `INSTALL_INTERFACE`. `install(DIRECTORY "
            "include/ ...)` must copy the headers to that folder."
        )
        if exports
        else f"Export the library: `ament_export_targets(export_{package.name} HAS_LIBRARY_TARGET)`.",
    )


def _code(error: CppError, package: BuiltPackage, sources: Sources) -> Feedback:
    """The header declares something in a different form than the task says."""
    headers = [Location(file) for file in cpp_files(sources) if "/include/" in file]
    place = (Location(error.file, error.line),) if error.file else tuple(headers[:1])
    inside = re.search(r"^'(\w+)' was not declared.*mean '(?:\w+::)+\1'", error.text)
    return Feedback(
        summary=f"Another package cannot use the class as the task requires: {error.text}.",
        where=place or (_lists(package),),
        advice=(
            f"`{inside[1]}` is in a namespace. Remove the namespace from the header and the .cpp file."
            if inside
            else "Compare the header with the task: names, arguments, `static`, and `const` after "
            "functions that don't change the object."
        ),
        details=tuple(re.sub(r"^/\S*/", "", line) for line in error.details),
    )


def _unlinked(error: CppError, package: BuiltPackage, every: Sequence[Command], sources: Sources) -> Feedback:
    name = error.text.split("(")[0].rpartition("::")[2] or error.text
    exported = _named(every, "ament_export_targets") or _named(every, "ament_export_libraries")
    if not exported:
        return Feedback(
            summary=f"{_OTHERS}: your library is not exported, so nothing defines `{error.text}`.",
            where=(_lists(package),),
            advice=f"Add `ament_export_targets(export_{package.name} HAS_LIBRARY_TARGET)`, and "
            "`EXPORT` with that name to the `install` of the library.",
        )
    made = {one.words[0] for one in _named(every, "add_library") if one.words}
    lost = [one for one in exported if one.name == "ament_export_libraries" and not made & {*one.words}]
    if made and lost:
        return Feedback(
            summary=f"{_OTHERS}: your package does not build a library {listed(lost[0].words)}.",
            where=(lost[0].where,),
            advice=f"Use the target of `add_library`: `ament_export_libraries({listed(made)})`.",
        )
    return Feedback(
        summary=f"Your header declares `{error.text}`, but nothing in the library defines it.",
        where=places_of(sources, rf"\b{re.escape(name)}\s*\(")[:2] or (_lists(package),),
        advice=(
            "Define it in a .cpp file that `add_library` lists, with the same arguments, and with "
            "`Class::` before its name if it is a member."
        ),
    )


def _own(file: str, package: BuiltPackage, sources: Sources) -> str | None:
    """The learner's source of an installed header."""
    if not file.startswith(package.prefix):
        return None
    name = file.partition("/include/")[2]
    return next((own for own in cpp_files(sources) if name and own.endswith(f"/{name}")), None)


def _named(every: Sequence[Command], name: str) -> list[Command]:
    return [one for one in every if one.name == name]


def _lists(package: BuiltPackage) -> Location:
    return Location(f"{package.source}/CMakeLists.txt")
