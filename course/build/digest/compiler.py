"""Failed builds of C and C++: the compiler's and the linker's first error."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import PurePosixPath

from course.build.digest.case import Case
from course.build.digest.cpp import CppError, defining_file, first_error
from course.build.digest.cpp_advice import advice_on
from course.build.outcome import BuildFailure
from course.build.refusal import like
from course.feedback import Location

_HEADER = re.compile(r"^(\S+): No such file or directory$")
_HEADERS = ("*.hpp", "*.hh", "*.hxx", "*.h")
_SOURCES = ("*.cpp", "*.cc", "*.cxx", "*.c")
_MOST_SOURCES = 200
_LIBRARIES = re.compile(r"(?mi)^\s*add_library\s*\(\s*(\S+)([^)]*)\)")


def digest(case: Case) -> BuildFailure | None:
    error = first_error(case.lines, case.own_file)
    if error is None:
        return None
    return _compiler(case, error) if error.kind == "compiler" else _linker(case, error)


def _compiler(case: Case, error: CppError) -> BuildFailure:
    where = [case.place(error.file, error.line)] if error.file else []
    if target := _target_without(case, error):
        where.append(_made(case, target))
    summary = f"{error.file or error.printed} does not compile: {error.text}."
    advice = _header_advice(case, error) or advice_on(error)
    return case.failure("compiler", summary, where=where, advice=advice, details=error.details)


def _header_advice(case: Case, error: CppError) -> str | None:
    found = _HEADER.match(error.text)
    if not found:
        return None
    package = found.group(1).split("/")[0]
    if package == case.package.name:
        return "It belongs to this package: `target_include_directories` has to name the folder `include`."
    if package in case.known_packages():
        if target := _target_without(case, error):
            return f"It belongs to `{package}`. Add `ament_target_dependencies({target} {package})`."
        return (
            f"It belongs to `{package}`: name that in `find_package`, in the target's dependencies, "
            "and as `<depend>` in package.xml."
        )
    own = {PurePosixPath(file).name: file for file in _sources(case, _HEADERS)}
    if near := like(PurePosixPath(found.group(1)).name, own):
        return f"Did you mean the header `{own[near]}`? If so, does the target know its folder?"
    near = like(package, case.known_packages())
    return f"Did you mean a header of `{near}`?" if near else None


def _target_without(case: Case, error: CppError) -> str | None:
    """The target that does not use the missing header's package, although that was found.

    make names the object file that it could not make for it.
    """
    found = _HEADER.match(error.text)
    package = found.group(1).split("/")[0] if found else ""
    looked_for = rf"(?i)find_package\s*\(\s*{re.escape(package)}\b"
    if not package or error.file is None or not case.line_of("CMakeLists.txt", looked_for):
        return None
    of_header = PurePosixPath(error.file).suffix in (pattern[1:] for pattern in _HEADERS)
    file = r"\S+" if of_header else re.escape(error.file)  # whoever includes it
    made = re.compile(rf"\*\*\* .*CMakeFiles/([^/\s]+)\.dir/{file}\.o\b")
    return next((found[1] for line in case.lines if (found := made.search(line))), None)


def _linker(case: Case, error: CppError) -> BuildFailure:
    name, package = error.text, case.package.name
    if error.kind == "library":
        summary = f"There is no library called `{name}` to link `{error.target or package}` with."
        advice = "Correct its name in `target_link_libraries`, or find its package first."
    elif error.kind == "twice":
        summary = f"`{name}` is defined twice in `{error.target or package}`."
        advice = advice_on(error)
    else:
        summary = f"`{name}` is used, but nothing in `{error.target or package}` defines it."
        advice = _unlisted(case, error) or _unlinked(case, error) or advice_on(error)
    announced = _announced(case, error) if error.kind == "undefined" else None
    where = [
        *([announced] if announced else []),
        *([case.place(error.file, error.line)] if error.file and error.line else []),
        *_lists(case, error),
    ]
    advice = _unwritten(name) if announced else advice
    return case.failure("linker", summary, where=where, advice=advice, details=error.details)


def _unlisted(case: Case, error: CppError) -> str | None:
    """The commonest cause: the file that defines it exists, and CMakeLists.txt does not name it."""
    listed = case.text("CMakeLists.txt")
    forgotten = [name for name in _sources(case) if PurePosixPath(name).name not in listed]
    file = defining_file(error.text, {name: case.text(name) for name in forgotten})
    if file is None:
        return None
    target = f"the files of `{error.target}`" if error.target else "the files of its target"
    return f"`{file}` defines it, but CMakeLists.txt does not name that file: add it to {target}."


def _unlinked(case: Case, error: CppError) -> str | None:
    """The file that defines it belongs to a library of this package, which the target does not link."""
    file = defining_file(error.text, {name: case.text(name) for name in _sources(case)})
    if file is None or not error.target:
        return None
    for library, files in _LIBRARIES.findall(case.text("CMakeLists.txt")):
        name = library.replace("${PROJECT_NAME}", case.package.name)
        if PurePosixPath(file).name in files and name != error.target:
            return f"`{file}` of `{name}` defines it: add `target_link_libraries({error.target} {name})`."
    return None


def _announced(case: Case, error: CppError) -> Location | None:
    """Where a header of the package announces the member function, if none of its files defines one."""
    *outer, name = error.text.split("(")[0].split("::")
    if not outer or defining_file(error.text, {file: case.text(file) for file in _sources(case)}):
        return None
    in_class = rf"\b(?:class|struct)\s+{re.escape(outer[-1])}\b"
    begins = rf"^\s*(?:explicit\s+|[^()=;/]*[\s&*])?{re.escape(name)}\s*\("
    headers = [file for file in _sources(case, _HEADERS) if case.line_of(file, in_class)]
    places = (case.place(file, line) for file in headers if (line := case.line_of(file, begins)))
    return next(places, None)


def _unwritten(name: str) -> str:
    short = "::".join(name.split("(")[0].split("::")[-2:])
    return (
        f"It is announced, and no file of the package defines it. Write `{short}(...) {{ ... }}` in a .cpp "
        "file, with its type in front and the same arguments."
    )


def _sources(case: Case, patterns: Sequence[str] = _SOURCES) -> list[str]:
    paths = (path for pattern in patterns for path in sorted(case.source.rglob(pattern)))
    return [path.relative_to(case.source).as_posix() for path in paths][:_MOST_SOURCES]


def _lists(case: Case, error: CppError) -> list[Location]:
    """The line of CMakeLists.txt that makes the target; else one that makes or links any."""
    line = _made(case, error.target).line if error.target else None
    some = r"target_link_libraries|ament_target_dependencies|add_executable|add_library"
    return [case.place("CMakeLists.txt", line or case.line_of("CMakeLists.txt", some))]


def _made(case: Case, target: str) -> Location:
    """The line of CMakeLists.txt that makes the target."""
    made = rf"add_(?:executable|library)\s*\(\s*{re.escape(target)}\b"
    return case.place("CMakeLists.txt", case.line_of("CMakeLists.txt", made))
