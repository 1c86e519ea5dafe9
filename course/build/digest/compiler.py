"""Failed builds of C and C++: the compiler's and the linker's first error."""

from __future__ import annotations

import re

from course.build.digest.case import Case
from course.build.outcome import BuildFailure
from course.build.refusal import like
from course.feedback import Location

_ERROR = re.compile(r"^(?P<file>[^:\s][^:]*):(?P<line>\d+):(?:\d+:)? (?:fatal )?error: (?P<text>.+)$")
_HEADER = re.compile(r"^(\S+): No such file or directory$")
_UNDEFINED = re.compile(r"undefined reference to [`'‘](.+?)['’]")
_LIBRARY = re.compile(r"cannot find -l(\S+?):?(?: |$)")


def digest(case: Case) -> BuildFailure | None:
    return _compiler(case) or _linker(case)


def _compiler(case: Case) -> BuildFailure | None:
    errors = [(number, found) for number, line in enumerate(case.lines) if (found := _ERROR.match(line))]
    own = [(number, found) for number, found in errors if case.own_file(found["file"])]
    if not (own or errors):
        return None
    number, found = (own or errors)[0]
    file = case.own_file(found["file"])
    where = [case.place(file, int(found["line"]))] if file else []
    summary = f"{file or found['file']} does not compile: {found['text']}."
    advice = _header_advice(case, found["text"])
    if advice is None and len(errors) > 1:
        advice = "Repair the first error first: the others often follow from it."
    details = case.lines[number : number + 3]
    return case.failure("compiler", summary, where=where, advice=advice, details=details)


def _header_advice(case: Case, text: str) -> str | None:
    found = _HEADER.match(text)
    if not found:
        return None
    package = found.group(1).split("/")[0]
    if package in case.known_packages():
        return (
            f"It belongs to `{package}`: name that in `find_package`, in the target's dependencies, "
            "and as `<depend>` in package.xml."
        )
    near = like(package, case.known_packages())
    return f"Did you mean a header of `{near}`?" if near else "Is its name right, and its folder included?"


def _linker(case: Case) -> BuildFailure | None:
    for number, line in enumerate(case.lines):
        details = case.lines[max(0, number - 1) : number + 1]
        if found := _UNDEFINED.search(line):
            summary = f"`{found.group(1)}` is used, but nothing in `{case.package.name}` defines it."
            advice = "Is its .cpp file listed in CMakeLists.txt, and are the libraries it comes from linked?"
            return case.failure("linker", summary, where=_lists(case), advice=advice, details=details)
        if found := _LIBRARY.search(line):
            summary = f"There is no library called `{found.group(1)}` to link `{case.package.name}` with."
            advice = "Correct its name in `target_link_libraries`, or find its package first."
            return case.failure("linker", summary, where=_lists(case), advice=advice, details=details)
    return None


def _lists(case: Case) -> list[Location]:
    line = case.line_of("CMakeLists.txt", r"target_link_libraries|ament_target_dependencies|add_executable")
    return [case.place("CMakeLists.txt", line)]
