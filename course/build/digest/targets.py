"""Failed builds of packages with C++ programs and libraries: what CMake says of their targets.

A target is what `add_executable` and `add_library` make. It is used, installed and exported by its name.
"""

from __future__ import annotations

import re

from course.build.digest.case import Case
from course.build.digest.cmake import CMakeError, Explain, cmake_errors, explained
from course.build.outcome import BuildFailure
from course.build.refusal import like
from course.feedback import Location

_LISTS = "CMakeLists.txt"
# Packages that come in parts, each with a name of its own: `Qt5Core` brings `Qt5::Core`.
_IN_PARTS = ("Qt5", "Qt6")
_MADE = re.compile(r"^\s*add_(?:executable|library)\s*\(\s*([^\s()]+)", re.MULTILINE)


def digest(case: Case) -> BuildFailure | None:
    return explained(case, cmake_errors(case), _EXPLANATIONS)


def _place(case: Case, error: CMakeError) -> Location:
    return case.place(error.file, error.line)


def _not_looked_for(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    summary = f"{_LISTS} uses the package `{name}`, but does not look for it first."
    advice = f"Add `find_package({name} REQUIRED)` above that line."
    wrong = _alike(case, name)
    if wrong:
        advice = f"Compare with line {wrong}: one of the two names is wrong."
    where = [case.place(_LISTS, wrong), _place(case, error)] if wrong else [_place(case, error)]
    return case.failure(
        "find-package-missing", summary, where=where, advice=advice, details=case.at(error.file, error.line)
    )


def _alike(case: Case, name: str) -> int | None:
    """The line that looks for a package of nearly that name."""
    names = re.findall(r"(?i)find_package\s*\(\s*(\w+)", case.text(_LISTS))
    near = like(name, names)
    return case.line_of(_LISTS, rf"(?i)find_package\s*\(\s*{near}\b") if near else None


def _no_target(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    own = case.package.name
    made = [target.replace("${PROJECT_NAME}", own) for target in _MADE.findall(case.text(_LISTS))]
    summary = f"{_LISTS} names the target `{name}`, which nothing has made by then."
    near = like(name, made)
    advice = f"Did you mean `{near}`?" if near and near != name else _TO_MAKE
    return case.failure(
        "target-missing",
        summary,
        where=[_place(case, error)],
        advice=advice,
        details=case.at(error.file, error.line),
    )


_TO_MAKE = "`add_executable` and `add_library` make targets; they stand above the lines that name them."


def _not_found(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    target = found.group(1)
    brings, _, part = target.partition("::")
    package = f"{brings}{part}" if brings in _IN_PARTS else brings
    summary = f"{_LISTS} links `{target}`, but nothing there has found it."
    advice = f"Add `find_package({package} REQUIRED)` above, or correct the name."
    line = case.line_of(_LISTS, rf"(?<![\w:]){re.escape(target)}(?![\w:])") or error.line
    where = [case.place(_LISTS, line)]
    return case.failure("link-target", summary, where=where, advice=advice, details=case.at(_LISTS, line))


def _two_signatures(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    summary = "Some libraries of a target are linked with `PRIVATE` or `PUBLIC`, and others without."
    advice = (
        "Write such a word in all lines for this target, or in none. "
        "It may stand in `ament_target_dependencies`, too, behind the target's name."
    )
    return case.failure(
        "link-signature",
        summary,
        where=[_place(case, error)],
        advice=advice,
        details=case.at(error.file, error.line),
    )


def _no_export(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    installed = case.line_of(_LISTS, r"^\s*(?:install\s*\(.*)?\bEXPORT\s+\S+")
    exported = case.line_of(_LISTS, r"(?i)ament_export_targets\s*\(")
    summary = f"`{name}` is exported, but nothing was installed for an export of that name."
    advice = f"`install(TARGETS ... EXPORT {name} ...)` and `ament_export_targets` must say the same name."
    lines = [line for line in (exported, installed) if line]
    where = [case.place(_LISTS, line) for line in lines] or [_place(case, error)]
    details = [text for line in lines for text in case.at(_LISTS, line)]
    return case.failure("export-name", summary, where=where, advice=advice, details=details)


def _own_folder(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    summary = "Others are told to look for headers in your source folder, which they do not have."
    advice = (
        "Let `target_include_directories` name two folders: `$<BUILD_INTERFACE:...>` where the headers lie, "
        "and `$<INSTALL_INTERFACE:include>` where they are installed."
    )
    line = case.line_of(_LISTS, r"(?i)target_include_directories\s*\(")
    return case.failure("include-folder", summary, where=[case.place(_LISTS, line)], advice=advice)


_EXPLANATIONS: tuple[tuple[str, Explain], ...] = (
    (r"the passed package name '(\S+)' was not found before", _not_looked_for),
    (r'for target "(\S+)" which is not built by this project', _no_target),
    (r"the first argument '(\S+)' must be a valid target name", _no_target),
    (r'(?:install TARGETS|TARGETS) given target "(\S+)" which does not exist', _no_target),
    (r'links to:? (?:target )?"?(\w+::\w+)"? but the target was not found', _not_found),
    (r"signature for target_link_libraries has already been used", _two_signatures),
    (r'given unknown export "(\S+)"', _no_export),
    (r"INTERFACE_INCLUDE_DIRECTORIES property contains path.* prefixed in the source", _own_folder),
)
