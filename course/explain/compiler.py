"""Reads the first error, and any warnings, from the output of a C++ compiler or linker.

Errors that follow from the first one, and pages of template messages, are left out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import Literal

Kind = Literal["compiler", "undefined", "twice", "library"]

# Maps a printed file name to the learner's file; None for anyone else's.
Own = Callable[[str], str | None]

_LONGEST = 90
_LONGEST_WORDS = 160  # of a compiler's message: long names can come before what is wrong
_SHOWN = 3
# Template instantiations that led to an error come before it; notes about it come after.
_MOST_AROUND = 60
_DIAGNOSTIC = re.compile(
    r"^(?P<file>[^:\s][^:]*):(?P<line>\d+):(?:\d+:)? (?P<kind>(?:fatal )?error|warning): (?P<text>.+)$"
)
_FROM_HERE = re.compile(r"^(?P<file>[^:\s][^:]*):(?P<line>\d+):(?:\d+:)? +(?:recursively )?required from")
_INCLUDED = re.compile(r"^(?:In file included| +) ?from (?P<file>[^:\s][^:]*):(?P<line>\d+)(?::\d+)?[,:]$")
_AROUND = re.compile(r"^In file included from |^ +from |: In instantiation of|: In substitution of|required ")
_DEFINED_IN = re.compile(r"is defined in header ['‘](<[\w./]+>)['’]")

_USER = r"^(?:\S*\bld(?:\.\w+)?: )?(?:(?P<file>[^:\s(]+):)?(?:(?:(?P<line>\d+)|\([^)]*\)):)?(?:\d+:)? ?"
_UNDEFINED = re.compile(_USER + r"undefined reference to [`'‘](?P<name>.+?)['’]$")
_TWICE = re.compile(
    _USER + r"multiple definition of [`'‘](?P<name>.+?)['’]; (?P<first>\S+?):\S*: first defined here"
)
_LIBRARY = re.compile(r"cannot find -l(?P<name>[^\s:]+)")
_TARGET = re.compile(r"CMakeFiles/(?P<target>[^/\s]+)\.dir/(?P<file>\S+?)\.o\b")
_OPTION = re.compile(r" \[-[Wf][^\]]*\]$")
_LONG_NAMES = (
    (re.compile(r"std::(?:__cxx11::)?basic_string<char(?:, std::char_traits<char>, std::allocator<char> )?>"),
     "std::string"),
    (re.compile(r"std::__cxx11::"), "std::"),
    (re.compile(r"Eigen::Matrix<double, -1, 1>"), "Eigen::VectorXd"),
    (re.compile(r"\(\(const std::__shared_ptr_access<[^()]*>\*\)\(& (\w+)\)\)->[^()]*::operator->\(\)"),
     r"\1"),
    (re.compile(r" \[with [^\]]*\]"), ""),
    (re.compile("[‘’]"), "'"),  # compilers' quotes on terminals that can show them
    (re.compile(r" \{aka '[^']*'\}"), ""),
    (re.compile(r"; did you mean '[^']*\bdetail::[^']*'\?$"), ""),
    (re.compile(r"; did you mean ('[^']*')\?$"), r" (did you mean \1?)"),
)  # fmt: skip


@dataclass(frozen=True)
class CppError:
    """The first thing that stopped a compiler or linker.

    kind: "undefined" for a symbol that nothing defines, "twice" for one that two files define, "library"
    for a library that was not found; otherwise "compiler". text: the compiler's message, or the symbol or
    library. file, line: in the learner's code; None if it was not involved. printed: the file as printed.
    target: what CMake was linking; "" if unknown. details: lines to show. header: the standard header that
    the compiler suggests. more: whether other errors follow.
    """

    kind: Kind
    text: str
    file: str | None
    line: int | None
    printed: str
    target: str = ""
    details: tuple[str, ...] = ()
    header: str = ""
    more: bool = False


def first_error(lines: Sequence[str], own: Own) -> CppError | None:
    """Return the first error in, or caused by, one of the learner's files; if there is none, the first."""
    found = list(_diagnosed(lines, own, "error"))
    mine = [error for error in found if error.file]
    if found:
        return (mine or found)[0]
    return next(_linked(lines, own), None)


def warnings(lines: Sequence[str], own: Own) -> tuple[CppError, ...]:
    """The compiler's warnings about the learner's files, in order, without duplicates."""
    return tuple(dict.fromkeys(one for one in _diagnosed(lines, own, "warning") if one.file))


def readable_name(text: str, longest: int = _LONGEST) -> str:
    """A symbol or error without the parts that no beginner wrote, and of limited length."""
    for pattern, short in _LONG_NAMES:
        text = pattern.sub(short, text)
    return text if len(text) <= longest else f"{text[: longest - 6]} [...]"


def defining_file(symbol: str, texts: Mapping[str, str]) -> str | None:
    """The first of these files (name to text) that seems to define this function."""
    name = re.escape(symbol.split("(")[0].strip().rpartition(" ")[2])
    if not name:
        return None
    short = name.split("::")
    # `Class::member`, as written outside the class; namespaces may come before it or surround it.
    written = (r"(?:\w+::)*" if len(short) > 1 else "") + r"\s*::\s*".join(short[-2:])
    pattern = re.compile(rf"(?:^|[\s&*]){written}\s*\([^;{{}}]*\)[^;{{}}()]*(?::[^;{{}}]*)?\{{", re.MULTILINE)
    return next((file for file, text in texts.items() if pattern.search(text)), None)


def _diagnosed(lines: Sequence[str], own: Own, kind: str) -> Iterator[CppError]:
    heads = [(n, found) for n, line in enumerate(lines) if (found := _DIAGNOSTIC.match(line))]
    heads = [(number, found) for number, found in heads if found["kind"].endswith(kind)]
    for position, (number, found) in enumerate(heads):
        file, line = _place(lines, number, found, own)
        behind = lines[number + 1 : number + _MOST_AROUND]
        header = next(_headers(behind), "")
        yield CppError(
            "compiler",
            readable_name(_OPTION.sub("", found["text"]).rstrip("."), _LONGEST_WORDS),
            file,
            line,
            found["file"],
            details=tuple(lines[number : number + _SHOWN]),
            header=header,
            more=position + 1 < len(heads),
        )


def _place(
    lines: Sequence[str], number: int, found: re.Match[str], own: Own
) -> tuple[str | None, int | None]:
    """The place in the learner's files that led to the error.

    For a template that is not theirs, it is where they use it; for such a header, where they include it.
    """
    if file := own(found["file"]):
        return file, int(found["line"])
    before = lines[max(0, number - _MOST_AROUND) : number]
    around = list(takewhile(_AROUND.search, reversed(before)))
    return _nearest(_FROM_HERE, around, own) or _nearest(_INCLUDED, around, own) or (None, None)


def _nearest(pattern: re.Pattern[str], around: Sequence[str], own: Own) -> tuple[str, int] | None:
    """The learner's place nearest to the error, which is printed first. around: from the last line up."""
    for line in reversed(around):
        asked = pattern.match(line)
        if asked and (file := own(asked["file"])):
            return file, int(asked["line"])
    return None


def _headers(behind: Sequence[str]) -> Iterator[str]:
    for line in behind:
        if _DIAGNOSTIC.match(line):
            return
        if found := _DEFINED_IN.search(line):
            yield found[1]


def _linked(lines: Sequence[str], own: Own) -> Iterator[CppError]:
    for number, line in enumerate(lines):
        details = tuple(lines[max(0, number - 1) : number + 1])
        if found := _UNDEFINED.search(line):
            file, place = _user(found, lines[:number], own)
            name = readable_name(found["name"])
            target = _target(lines[: number + 1])
            yield CppError("undefined", name, file, place, found["file"] or "", target, details)
        elif found := _TWICE.search(line):
            file, place = _user(found, lines[:number], own)
            name, target = readable_name(found["name"]), _target(lines[: number + 1])
            yield CppError("twice", name, file, place, found["first"], target, details)
        elif found := _LIBRARY.search(line):
            yield CppError("library", found["name"], None, None, "", _target(lines[: number + 1]), details)


def _user(found: re.Match[str], before: Sequence[str], own: Own) -> tuple[str | None, int | None]:
    """The place that uses the symbol, from the line itself or from an object file named above it."""
    if found["file"] and (file := own(found["file"])):
        return file, int(found["line"]) if found["line"] else None
    for line in reversed(before[-_SHOWN:]):
        if (made := _TARGET.search(line)) and (file := own(made["file"])):
            return file, None
    return None, None


def _target(before: Sequence[str]) -> str:
    for line in reversed(before[-_MOST_AROUND:]):
        if made := _TARGET.search(line):
            return made["target"]
    return ""
