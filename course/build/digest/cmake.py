"""Failed builds of CMake packages: what CMake says, and what usually is behind it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from course.build.digest.case import Case
from course.build.outcome import BuildFailure
from course.build.refusal import like, manifest_place
from course.feedback import Location

_LONGEST = 160  # characters of CMake's own words in a summary
# Of them, and in one of them, as far as they are looked at: the log may hold forged ones without end.
_MOST_ERRORS, _MOST_LINES, _LONGEST_TEXT = 50, 100, 4000

_HEAD = re.compile(
    r"^CMake Error(?: at (?P<file>.+?):(?P<line>\d+)(?: \((?P<command>\w+)\))?| in (?P<list>\S+?))?:"
    r"\s?(?P<rest>.*)$"
)
_FRAME = re.compile(r"^\s+(?P<file>.+?):(?P<line>\d+) \((?P<command>\w+)\)$")

# Commands that learners misspell or use before the package that brings them.
_BROUGHT_BY = {
    "rosidl_generate_interfaces": "rosidl_default_generators",
    "rosidl_get_typesupport_target": "rosidl_default_generators",
    "ament_package": "ament_cmake",
    "ament_target_dependencies": "ament_cmake",
    "ament_export_dependencies": "ament_cmake",
    "ament_export_targets": "ament_cmake",
    "ament_export_include_directories": "ament_cmake",
    "ament_export_libraries": "ament_cmake",
    "ament_python_install_package": "ament_cmake_python",
    "ament_add_gtest": "ament_cmake_gtest",
}
_OWN_COMMANDS = (
    "add_executable", "add_library", "add_subdirectory", "add_compile_options", "cmake_minimum_required",
    "find_package", "if", "endif", "include_directories", "install", "project", "set",
    "set_target_properties", "target_compile_features", "target_include_directories",
    "target_link_libraries", "target_sources",
)  # fmt: skip


@dataclass(frozen=True)
class CMakeError:
    """One «CMake Error»: its text in one line, as printed, and the place in the learner's CMake files."""

    text: str
    printed: tuple[str, ...]
    file: str
    line: int | None
    command: str | None


class Printed(Protocol):
    """What CMake printed, and which of the files that it names are the learner's."""

    @property
    def lines(self) -> Sequence[str]: ...

    def own_file(self, shown: str) -> str | None: ...


Explain = Callable[[Case, CMakeError, re.Match[str]], BuildFailure | None]


def digest(case: Case) -> BuildFailure | None:
    errors = cmake_errors(case)
    return explained(case, errors, _EXPLANATIONS) or (_as_said(case, errors[0]) if errors else None)


def explained(
    case: Case, errors: Sequence[CMakeError], explanations: Sequence[tuple[str, Explain]]
) -> BuildFailure | None:
    """The first explanation that fits one of the errors: those of causes come before those of effects."""
    for pattern, explain in explanations:
        for error in errors:
            if (found := re.search(pattern, error.text)) and (failure := explain(case, error, found)):
                return failure
    return None


def cmake_errors(case: Printed) -> list[CMakeError]:
    """The errors in the log, in their order."""
    heads = [number for number, line in enumerate(case.lines) if _HEAD.match(line)][:_MOST_ERRORS]
    return [_read(case, case.lines[start : start + _MOST_LINES]) for start in heads]


def _read(case: Printed, lines: Sequence[str]) -> CMakeError:
    head = _HEAD.match(lines[0])
    assert head is not None
    body = _indented(lines[1:])
    calls = lines[1 + len(body) :]
    frames = [head, *(found for line in _indented(calls[1:]) if (found := _FRAME.match(line)))]
    own = [frame for frame in frames if case.own_file(frame["file"] or "")]
    text = re.sub(r"\s+", " ", " ".join((head["rest"], *body))).strip()[:_LONGEST_TEXT]
    printed = tuple(line.strip() for line in (head["rest"], *body) if line.strip())
    if own:
        return CMakeError(
            text, printed, case.own_file(own[0]["file"]) or "", int(own[0]["line"]), own[0]["command"]
        )
    return CMakeError(text, printed, head["list"] or "CMakeLists.txt", None, None)


def _indented(lines: Sequence[str]) -> list[str]:
    body: list[str] = []
    for line in lines:
        if line and not line.startswith("  "):
            break
        body.append(line)
    return body


def _place(case: Case, error: CMakeError) -> Location:
    return case.place(error.file, error.line)


def _as_said(case: Case, error: CMakeError) -> BuildFailure:
    sentence = re.split(r"(?<=[.!?:])\s", error.text, maxsplit=1)[0].rstrip(".:")[:_LONGEST]
    summary = f"CMake cannot configure `{case.package.name}`: {sentence}."
    return case.failure("cmake", summary, where=[_place(case, error)], details=error.printed)


# ------------------------------------------------------------------------------------- explanations


def _no_minimum(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    summary = f"CMakeLists.txt of `{case.package.name}` does not begin with `cmake_minimum_required`."
    advice = "Add `cmake_minimum_required(VERSION 3.8)` as the first line."
    return case.failure("cmake-minimum", summary, where=[case.place("CMakeLists.txt", 1)], advice=advice)


def _no_braces(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    variable = found.group(1)
    summary = f"CMakeLists.txt of `{case.package.name}` uses the variable {variable} without braces."
    advice = f"Write `${{{variable}}}`: a variable's name stands within `${{` and `}}`."
    line = case.line_of("CMakeLists.txt", rf"\${variable}\b") or error.line
    where = [case.place("CMakeLists.txt", line)]
    return case.failure(
        "cmake-variable", summary, where=where, advice=advice, details=case.at("CMakeLists.txt", line)
    )


def _not_closed(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    what = "quote" if "unterminated string" in error.text else "bracket"
    line = _unclosed_quote(case, error) if what == "quote" else error.line
    summary = f"A closing {what} is missing in {error.file} of `{case.package.name}`."
    advice = f"Look for it from line {line} on: every `(` needs its `)`, every quote its second one."
    return case.failure(
        "cmake-syntax",
        summary,
        where=[case.place(error.file, line)],
        advice=advice,
        details=case.at(error.file, error.line),
    )


def _unclosed_quote(case: Case, error: CMakeError) -> int | None:
    """CMake names the last line; the first with an odd number of quotes is where it began."""
    lines = enumerate(case.text(error.file).splitlines(), 1)
    return next((number for number, line in lines if line.split("#")[0].count('"') % 2), error.line)


def _syntax(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    summary = f"CMake cannot read {error.file} of `{case.package.name}`: {found.group(1).rstrip('.')}."
    advice = "A command is a name, then its arguments in brackets: `find_package(rclcpp REQUIRED)`."
    return case.failure(
        "cmake-syntax", summary, where=[_place(case, error)], advice=advice, details=error.printed[:4]
    )


def _unknown_command(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    command = found.group(1)
    if bringer := _BROUGHT_BY.get(command.lower()):
        summary = f"{error.file} calls `{command}`, but the package that brings it was not looked for."
        advice = f"Add `find_package({bringer} REQUIRED)` above that line."
    else:
        summary = f"{error.file} calls `{command}`, which is no CMake command."
        near = like(command, (*_BROUGHT_BY, *_OWN_COMMANDS))
        advice = f"Did you mean `{near}`?" if near else "Is a `find_package` missing above it?"
    return case.failure(
        "cmake-command",
        summary,
        where=[_place(case, error)],
        advice=advice,
        details=case.at(error.file, error.line),
    )


def _package_not_found(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    own = case.workspace.find(name)
    if own and not case.package.depends_on(name):
        return _undeclared(case, error, name)
    where = [_place(case, error)]
    details = case.at(error.file, error.line)
    if own:
        summary = f"`{name}` was built, but CMake cannot use it."
        advice = f"Does {own.source}/CMakeLists.txt end with `ament_package()`?"
        where.append(Location(f"{own.source}/CMakeLists.txt"))
    else:
        summary = f"{error.file} of `{case.package.name}` looks for `{name}`, which does not exist here."
        advice = _where_from(case, name)
    return case.failure("dependency-missing", summary, where=where, advice=advice, details=details)


def _where_from(case: Case, name: str) -> str:
    if near := like(name, case.known_packages()):
        return f"Did you mean `{near}`?"
    return f"It is neither in your workspace nor among the packages of this ROS: is `{name}` spelt right?"


def _undeclared(case: Case, error: CMakeError, name: str) -> BuildFailure:
    summary = f"`{case.package.name}` uses `{name}`, but its package.xml does not say so."
    advice = f"Add `<depend>{name}</depend>` to package.xml: only then is `{name}` built first and found."
    where = [after_dependencies(case), _place(case, error)]
    return case.failure(
        "dependency-undeclared", summary, where=where, advice=advice, details=error.printed[:1]
    )


def after_dependencies(case: Case) -> Location:
    """Where a dependency belongs in package.xml: at the last one that is there."""
    lines = [dependency.line for dependency in case.package.dependencies]
    return case.place("package.xml", lines[-1]) if lines else manifest_place(case.package, "export")


def _project_name(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    return _wrong_project(case, found.group(2))


def _bad_project(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    return _wrong_project(case, found.group(1))


def _wrong_project(case: Case, project: str) -> BuildFailure:
    name = case.package.name
    if project == "Project":  # what CMake takes when there is no project()
        summary = f"CMakeLists.txt of `{name}` does not call `project({name})`."
        where = [case.place("CMakeLists.txt", 1)]
    else:
        summary = f"CMakeLists.txt calls the project `{project}`, but package.xml calls it `{name}`."
        where = [case.place("CMakeLists.txt", case.line_of("CMakeLists.txt", r"(?i)^\s*project\s*\("))]
    advice = f"Write `project({name})` below `cmake_minimum_required`."
    where.append(manifest_place(case.package, "name"))
    return case.failure("names-differ", summary, where=where, advice=advice)


def _no_list(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name, build_type = case.package.name, case.package.build_type
    if case.text("setup.py"):
        says = f"says {build_type}" if build_type != "catkin" else "says no build type"
        summary = f"package.xml of `{name}` {says}, but the package has a setup.py and no CMakeLists.txt."
        advice = "If it is a Python package, write `<build_type>ament_python</build_type>` within `<export>`."
        return case.failure(
            "build-type", summary, where=[manifest_place(case.package, "export")], advice=advice
        )
    summary = f"`{name}` has no CMakeLists.txt, which a package of type {build_type} is built with."
    advice = f"Make a fresh package with `ros2 pkg create {name} --build-type ament_cmake` and compare."
    return case.failure("cmake-missing", summary, where=[case.place("CMakeLists.txt")], advice=advice)


def _no_source(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    file = found.group(1)
    summary = (
        f"{error.file} of `{case.package.name}` names the source file {file}, but there is no such file."
    )
    near = like(file, _files(case))
    advice = f"Did you mean `{near}`?" if near else "Make the file, or correct its name."
    return case.failure("source-missing", summary, where=[_place(case, error)], advice=advice)


def _nothing_to_install(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    shown = found.group(1)
    file = shown.removeprefix(f"{case.package.source}/")
    last = re.escape(file.rsplit("/", 1)[-1])
    summary = f"CMakeLists.txt of `{case.package.name}` installs {file}, but it does not exist."
    near = like(file, _files(case))
    advice = f"Did you mean `{near}`?" if near else "Make it, or take it out of `install(...)`."
    where = [case.place("CMakeLists.txt", case.line_of("CMakeLists.txt", rf"\b{last}\b"))]
    return case.failure("install-missing", summary, where=where, advice=advice)


def _files(case: Case) -> list[str]:
    return [path.relative_to(case.source).as_posix() for path in case.source.rglob("*")]


_EXPLANATIONS: tuple[tuple[str, Explain], ...] = (
    (r"No cmake_minimum_required command is present", _no_minimum),
    (r"Parse error\. Function missing ending", _not_closed),
    (r"(Parse error\. .*?[.])(?:\s|$)", _syntax),
    (r'Unknown CMake command "(\w+)"', _unknown_command),
    (r'package configuration file provided by "(\S+?)"', _package_not_found),
    (r"package name '(\S+)' in '\S*' does not match current PROJECT_NAME '(\S+?)'", _project_name),
    (r"'(\S+)' is an invalid package name", _bad_project),
    (r'target name "\$(\w+)" is reserved', _no_braces),
    (r"does not appear to contain CMakeLists\.txt", _no_list),
    (r"Cannot find source file: (\S+)", _no_source),
    (r'file INSTALL cannot find "(.+?)"', _nothing_to_install),
)
