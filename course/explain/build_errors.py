"""Turns the log of a failed build into a short cause, with file, line and advice."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from course.explain.builds import Build, tag
from course.explain.cmake import LISTS, Command, cmake_errors, commands
from course.explain.cmake_errors import AS_SAID, PACKAGES
from course.explain.compiler import CppError, defining_file, first_error
from course.explain.cpp_code import is_cpp
from course.explain.cpp_errors import COMPILER, LINKER, symptom_of
from course.explain.engine import Evidence, Explanation, Known, Place, Proven, Symptom, Words, explain, here
from course.explain.interface_errors import INTERFACES, RESERVED, TYPES
from course.explain.setup_py import OF_FILES, OF_SETUP, log_errors, setup_errors
from course.model import replace
from course.model.feedback import Feedback, Location
from course.spelling import LOOSELY, nearest, snake_case

MOST_DETAILS = 6
_MOST_SOURCES = 200
_HEADERS = (".hpp", ".hh", ".hxx", ".h")
_NOISE = re.compile(
    r"^\s*$|^gmake|^make|^\[ *\d+%\]|^-- |^\[\d+\.\d+s\] WARNING:colcon|^Traceback|^ +\^+ *$|^running "
)
_TELLING = re.compile(r"(?i)\berror\b|\bfailed\b|exception|cannot|not found|no such")


class BuildError(NamedTuple):
    """Why a package cannot be built. kind: a short stable name for the cause."""

    kind: str
    feedback: Feedback


def explain_build(build: Build) -> BuildError:
    """Why the build failed; if unknown, the last lines of its log that look like a reason."""
    return _python(build) or _cmake(build) or _compiled(build) or _last_lines(build)


def explain_success(build: Build, prefix: Path) -> BuildError | None:
    """What is wrong even though colcon reports success; None if nothing is."""
    if found := explain(RESERVED, _log(build), build):
        return _told(build, found)
    marker = prefix / "share/ament_index/resource_index/packages" / build.name
    installed = marker.exists() or (build.build_type == "cmake" and prefix.exists())
    found = None if installed else explain(INSTALLED_NOTHING, [*_log(build), Symptom("nothing")], build)
    return _told(build, found) if found else None


def _log(build: Build) -> list[Symptom]:
    return [Symptom(line) for line in build.lines]


def _python(build: Build) -> BuildError | None:
    if build.build_type != "ament_python":
        return None
    found = explain(OF_FILES, log_errors(build), build) or explain(OF_SETUP, setup_errors(build), build)
    return _told(build, found, found.symptom.printed) if found else None


def _cmake(build: Build) -> BuildError | None:
    errors = cmake_errors(build.lines, build)
    found = explain((*INTERFACES, *PACKAGES), errors, build) or explain(TYPES, _log(build), build)
    if found:
        return _told(build, found)
    found = explain(AS_SAID, errors, build)
    return _told(build, found, found.symptom.printed) if found else None


def _compiled(build: Build) -> BuildError | None:
    """The compiler's or the linker's first error."""
    error = first_error(build.lines, build.own_file)
    if error is None:
        return None
    symptom = symptom_in(build, error)
    found = explain(COMPILED if error.kind == "compiler" else LINKED, [symptom], build)
    return _told(build, found, error.details) if found else None


def _told(build: Build, found: Explanation, printed: Sequence[str] = ()) -> BuildError:
    """printed: what to show below the source lines. If there is neither, the tool's own output is shown."""
    shown = [line for place in found.where for line in build.shown(place)]
    lines = (*shown, *printed) or found.symptom.printed[:4]
    details = {line.strip(): line.rstrip() for line in reversed(lines) if line.strip()}.values()
    few = tuple(reversed(details))[:MOST_DETAILS]
    return BuildError(
        found.known.kind, Feedback(found.cause, where=found.where, advice=found.remedy or None, details=few)
    )


def _last_lines(build: Build) -> BuildError:
    lines = [line for line in build.lines if not _NOISE.search(line)]
    telling = [line for line in lines if _TELLING.search(line)] or lines
    feedback = Feedback(
        f"`{build.name}` cannot be built.",
        where=(build.place("package.xml"),),
        advice="Build it yourself with `colcon build` and read the first error.",
        details=tuple(line.rstrip() for line in telling[-MOST_DETAILS:]),
    )
    return BuildError("build", feedback)


# ------------------------------------------------------------------ compilers and linkers in a package


def symptom_in(build: Build, error: CppError) -> Symptom:
    place = build.place(error.file, error.line) if error.file else None
    symptom = symptom_of(error, place if error.kind == "compiler" or error.line else None)
    shown = error.file or error.printed
    more = {
        "shown": shown,
        "said": error.text,
        "source": error.file or "",
        "where": error.target or build.name,
    }
    return replace(symptom, words={**symptom.words, **more})


def _target_without(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """The target that does not use the missing header's package, although CMake found the package.

    make's output names the object file that it could not build for that target.
    """
    looked_for = rf"(?i)find_package\s*\(\s*{re.escape(words['name'])}\b"
    if not words["source"] or words["name"] not in build.known_packages or not build.line(LISTS, looked_for):
        return None
    of_header = words["source"].endswith(_HEADERS)
    file = r"\S+" if of_header else re.escape(words["source"])  # whichever file includes it
    made = re.compile(rf"\*\*\* .*CMakeFiles/([^/\s]+)\.dir/{file}\.o\b")
    target = next((found[1] for line in build.lines if (found := made.search(line))), None)
    if target is None:
        return None
    places = (symptom.where, _made(build, target))
    use = _use_of(build, target, words["header_name"], words["name"])
    return Proven({"use": use}, tuple(place for place in places if place))


def _use_of(build: Build, target: str, header: str, package: str) -> str:
    """The command that makes the target use this header's package, in the style that the target uses.

    CMake does not allow `ament_target_dependencies` and a command with `PUBLIC` for the same target.
    """
    if any(one.words[:1] == (target,) for one in _uses(build, "ament_target_dependencies")):
        return f"ament_target_dependencies({target} {package})"
    interfaces = re.match(r"[^/]+/(?:msg|srv|action)/", header)
    return _link_of(build, target, f"${{{package}_TARGETS}}" if interfaces else f"{package}::{package}")


def _link_of(build: Build, target: str, library: str) -> str:
    """`target_link_libraries`, with a keyword if the target's other commands have one."""
    every = ("target_link_libraries", "ament_target_dependencies")
    used = [one for one in _uses(build, *every) if one.words[:1] == (target,)]
    plain = used and not any({"PUBLIC", "PRIVATE", "INTERFACE"} & {*one.words[:3]} for one in used)
    return f"target_link_libraries({target} {'' if plain else 'PUBLIC '}{library})"


def _uses(build: Build, *names: str) -> tuple[Command, ...]:
    return commands(build.sources, build.folder, *names)


def _with_capitals(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """A message's header is named like its type: `PointStamped.hpp`."""
    found = re.fullmatch(r"([^/]+/(?:msg|srv|action)/)(\w*[A-Z]\w*)\.hpp", words["header_name"])
    return Proven({"right": f"{found[1]}{snake_case(found[2])}.hpp"}) if found else None


def _of_this_package(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if words["name"] == build.name else None


def _of_known_package(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if words["name"] in build.known_packages else None


def _for_itself_alone(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`target_include_directories(talk PRIVATE include)`, for a header that another target includes."""
    for command in commands(build.sources, build.folder, "target_include_directories"):
        if "PRIVATE" in command.words:
            return Proven(where=(command.where,)) if _of_this_package(build, symptom, words) else None
    return None


def _header_without_folder(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`#include "talk.hpp"`, where the header is include/talk/talk.hpp."""
    written = PurePosixPath(words["header_name"])
    for file in _sources(build, headers=True):
        below = file.partition("include/")[2]
        if below and PurePosixPath(below).name == written.name and below != str(written):
            return Proven({"right": below})
    return None


def _header_of_another_name(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`#include "robot.h"`, beside a file robot.hpp."""
    proven = _header_like(build, symptom, words)
    if proven is None or "include/" in proven.words["near"]:
        return None
    name = PurePosixPath(proven.words["near"]).name
    return Proven({"right": name}) if name != words["header_name"] else None


def _header_like(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    own = {PurePosixPath(file).name: file for file in _sources(build, headers=True)}
    near = nearest(PurePosixPath(words["header_name"]).name, own, LOOSELY)
    return Proven({"near": own[near]}) if near else None


def _package_like(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    near = nearest(words["name"], build.known_packages, LOOSELY)
    return Proven({"near": near}) if near else None


def _defined_in(build: Build, name: str, files: Iterable[str]) -> str | None:
    return defining_file(name, {file: build.text(file) for file in files})


def _announced(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """Where a header of the package declares the member function, if none of its files defines it."""
    *outer, name = words["said"].split("(")[0].split("::")
    if not outer or _defined_in(build, words["said"], _sources(build)):
        return None
    in_class = rf"\b(?:class|struct)\s+{re.escape(outer[-1])}\b"
    begins = rf"^\s*(?:explicit\s+|[^()=;/]*[\s&*])?{re.escape(name)}\s*\("
    headers = [file for file in _sources(build, headers=True) if build.line(file, in_class)]
    places = (build.place(file, line) for file in headers if (line := build.line(file, begins)))
    where = next(places, None)
    return Proven({"short": "::".join((*outer, name)[-2:])}, (where,)) if where else None


def _unlisted(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """The most common cause: a file defines the symbol, but CMakeLists.txt does not list that file."""
    listed = build.text(LISTS)
    file = _defined_in(
        build, words["said"], (f for f in _sources(build) if PurePosixPath(f).name not in listed)
    )
    return Proven({"path": file}) if file else None


def _unlinked(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """The file that defines the symbol belongs to a library of this package that the target does not link."""
    file = _defined_in(build, words["said"], _sources(build))
    if file is None or "target" not in words:
        return None
    for library in commands(build.sources, build.folder, "add_library"):
        name, *files = library.words or ("",)
        if name != words["target"] and any(one.endswith(PurePosixPath(file).name) for one in files):
            return Proven({"path": file, "library": name, "link": _link_of(build, words["target"], name)})
    return None


def _sources(build: Build, *, headers: bool = False) -> list[str]:
    every = (file for file in build.files() if is_cpp(file) or file.endswith(".c"))
    return [file for file in every if file.endswith(_HEADERS) is headers][:_MOST_SOURCES]


def _made(build: Build, target: str) -> Location:
    """The line of CMakeLists.txt that creates the target."""
    return build.place(LISTS, build.line(LISTS, rf"add_(?:executable|library)\s*\(\s*{re.escape(target)}\b"))


def _linked(build: Build, symptom: Symptom, words: Words) -> Location:
    """The line of CMakeLists.txt that creates the target, or else one that creates or links any target."""
    made = _made(build, words["where"])
    some = r"target_link_libraries|ament_target_dependencies|add_executable|add_library"
    return made if made.line else build.place(LISTS, build.line(LISTS, some))


def _for_builds(known: Known[Evidence], kind: str, cause: str, *where: Place[Build]) -> Known[Build]:
    return Known(known.pattern, known.remedy, known.example, cause, where, known.proof, kind, known.given)


_NO_HEADER = r"^(?P<header_name>(?P<name>[^/\s]+)\S*): No such file or directory$"
_NOT_COMPILED = "{shown} does not compile: {said}."
_HEADER = "std_msgs/msg/string.hpp: No such file or directory"

# Which package a missing header belongs to.
HEADERS = tuple(
    Known[Build](_NO_HEADER, remedy, example, _NOT_COMPILED, proof=proof, kind="compiler", given=given)
    for proof, remedy, example, given in (
        (
            _with_capitals,
            "Headers of interfaces have lowercase names: `#include <{right}>`.",
            "geometry_msgs/msg/PointStamped.hpp: No such file or directory",
            {},
        ),
        (
            _for_itself_alone,
            "`PRIVATE` hides this folder from targets that link the library: write `PUBLIC`.",
            "talk/talk.hpp: No such file or directory",
            {LISTS: "target_include_directories(talk PRIVATE include)"},
        ),
        (
            _header_without_folder,
            'Write the header with its folder: `#include "{right}"`.',
            "talk.hpp: No such file or directory",
            {"include/talk/talk.hpp": ""},
        ),
        (
            _header_of_another_name,
            'Did you mean `#include "{right}"`?',
            "robot.h: No such file or directory",
            {"src/robot.hpp": ""},
        ),
        (
            _of_this_package,
            "The header is in this package: `target_include_directories` must name the folder `include`.",
            "talk/talk.hpp: No such file or directory",
            {},
        ),
        (
            _target_without,
            "The header belongs to `{name}`. Add `{use}`.",
            f"{_HEADER}\ngmake[2]: *** [CMakeFiles/robot.dir/build.make:76: "
            "CMakeFiles/robot.dir/src/main.cpp.o] Error 1",
            {LISTS: "find_package(std_msgs REQUIRED)\nadd_executable(robot src/main.cpp)"},
        ),
        (
            _of_known_package,
            "The header belongs to `{name}`: add that package to `find_package`, to the target's libraries, "
            "and as `<depend>` to package.xml.",
            _HEADER,
            {},
        ),
        (
            _header_like,
            "Did you mean the header `{near}`? If so, `target_include_directories` must name its folder.",
            "robot/robot.h: No such file or directory",
            {"include/robots/robot.hpp": ""},
        ),
        (
            _package_like,
            "Did you mean a header of `{near}`?",
            "std_msg/msg/string.hpp: No such file or directory",
            {},
        ),
    )
)
COMPILED = (*HEADERS, *(_for_builds(known, "compiler", _NOT_COMPILED, here) for known in COMPILER))
_UNDEFINED = r"^undefined reference to `(?!(?:vtable|typeinfo) for )"
_IS_UNDEFINED = "`{said}` is used, but nothing in `{where}` defines it."
_FORGOTTEN = f"`{{path}}` defines it, but {LISTS} does not list that file: add it to"
_CALL = "undefined reference to `Arm::bend(double)'"
_ARM = {"src/arm.cpp": "void Arm::bend(double x)\n{\n}\n"}

LINKED: tuple[Known[Build], ...] = (
    Known(kind="linker", pattern=r"^cannot find -l",
          cause="`{where}` links to the library `{said}`, which the linker cannot find.",
          remedy="Correct its name in `target_link_libraries`, or call `find_package` for it first.",
          where=(here, _linked), example="cannot find -ltinyqp"),
    _for_builds(LINKER[0], "linker", "`{said}` is defined twice in `{where}`.", here, _linked),
    *(
        Known[Build](
            _UNDEFINED, remedy, _CALL, _IS_UNDEFINED, (here, _linked), proof, kind="linker", given=given
        )
        for proof, remedy, given in (
            (
                _announced,
                "It is declared, but no file in the package defines it. Define it in a .cpp file: its "
                "return type, then `{short}(...) { ... }`, with the same arguments.",
                {"src/arm.hpp": "struct Arm {\n  void bend(double x);\n};\n"},
            ),
            (
                _unlisted,
                (f"{_FORGOTTEN} the files of `{{target}}`.", f"{_FORGOTTEN} the files of its target."),
                _ARM,
            ),
            (
                _unlinked,
                "`{path}` defines it, and `{library}` is built from that file: add `{link}`.",
                {**_ARM, LISTS: "project(talk)\nadd_library(arm SHARED src/arm.cpp)\n"},
            ),
        )
    ),
    *(
        _for_builds(known, "linker", _IS_UNDEFINED, here, _linked)
        for known in LINKER
        if known.pattern.startswith("^undefined")
    ),
)  # fmt: skip


# ---------------------------------------------------------------------- builds that install nothing


def _no_ament_package(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    called = build.line(LISTS, r"(?i)^\s*ament_package\s*\(")
    return Proven() if build.build_type == "ament_cmake" and not called else None


INSTALLED_NOTHING: tuple[Known[Build], ...] = (
    Known(kind="build-type", pattern=r"No task extension to 'build'",
          cause="`{package}`'s package.xml has the build type {type}, which does not exist.",
          remedy="Write ament_python for a Python package, or ament_cmake for one with a CMakeLists.txt.",
          where=(tag("build_type"),), example="No task extension to 'build' a 'ros.ament_pyton' package"),
    Known(kind="ament-package", pattern=r"^nothing$",
          cause=f"`{{package}}`'s {LISTS} never calls `ament_package()`, so ROS cannot find the package.",
          remedy="Add `ament_package()` as the last line.", proof=_no_ament_package,
          where=(lambda build, symptom, words: build.place(LISTS),), example="nothing",
          given={LISTS: "project(talk)"}),
    Known(kind="not-installed", pattern=r"^nothing$",
          cause="The build of `{package}` installs nothing that ROS can find.", remedy="",
          where=(tag("name"),), example="nothing", given={LISTS: "ament_package()"}),
)  # fmt: skip
