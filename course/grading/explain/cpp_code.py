"""Where in the learner's C++ files something is called, as far as can be told without a compiler."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from course.evidence.sources import Sources
from course.feedback import Location

ENDINGS = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".hxx", ".h")
# Comments, and what stands between quotes: neither is code.
_NO_CODE = re.compile(
    r"//[^\n]*|/\*.*?(?:\*/|\Z)"
    r'|R"(?P<mark>[^\s()\\]{0,16})\(.*?\)(?P=mark)"'
    r"""|"(?:\\.|[^"\\\n])*"|(?<![\w'])'(?:\\.|[^'\\\n])*'""",
    re.DOTALL,
)
# A brace right behind a name gives that variable its value: `timer_{...}`.
_ENDS_A_STATEMENT = re.compile(r"[;}]|(?<!\w)\{|(?<=\belse)\{|(?<=\btry)\{|(?<=\bdo)\{")
# A learner's file has few calls of one name and short blocks; others are not looked through.
_MOST_CALLS, _FAR, _LONGEST_STATEMENT = 50, 20_000, 1000


@dataclass(frozen=True)
class CppCall:
    """One call: `before` is what its statement begins with, `arguments` what stands in its brackets.

    around: the block that the call stands in, with blanks for comments and for what stands between quotes.
    """

    where: Location
    before: str
    arguments: str
    around: str


def is_cpp(file: str) -> bool:
    return file.endswith(ENDINGS)


def cpp_files(sources: Sources) -> dict[str, str]:
    """The C++ files among them, without tests."""
    return {file: text for file, text in sources.files.items() if is_cpp(file) and "/test/" not in file}


def cpp_calls(sources: Sources, name: str) -> tuple[CppCall, ...]:
    """All calls of a function, method or macro of this name (`create_wall_timer`), file by file."""
    called = re.compile(rf"(?<![\w~]){re.escape(name)}\s*(?:<[^;{{}}()]*>)?\s*\(")
    return tuple(
        _call(file, text, code, found)
        for file, text in cpp_files(sources).items()
        for code in (only_code(text),)
        for found in islice(called.finditer(code), _MOST_CALLS)
    )


def places_of(sources: Sources, pattern: str) -> tuple[Location, ...]:
    """Where code matches the pattern; comments and what stands between quotes do not count."""
    return tuple(
        Location(file, _line(code, found.start()))
        for file, text in cpp_files(sources).items()
        for code in (only_code(text),)
        for found in islice(re.finditer(pattern, code), _MOST_CALLS)
    )


@lru_cache(maxsize=256)
def only_code(text: str) -> str:
    """The text with blanks in place of comments and of what stands between quotes; lines stay."""
    return _NO_CODE.sub(lambda found: re.sub(r"[^\n\"]", " ", found[0]), text)


def _call(file: str, text: str, code: str, found: re.Match[str]) -> CppCall:
    begins = max(0, found.start() - _LONGEST_STATEMENT)
    ends = [end.end() for end in _ENDS_A_STATEMENT.finditer(code, begins, found.start())]
    end = _closing(code, found.end() - 1, "()")
    opened = _opening(code, found.start())
    around = code[opened : _closing(code, opened, "{}")] if opened else code
    return CppCall(
        Location(file, _line(code, found.start())),
        code[ends[-1] if ends else begins : found.start()].strip(),
        text[found.end() : end].strip(),
        around,
    )


def _line(code: str, position: int) -> int:
    return code.count("\n", 0, position) + 1


def _closing(code: str, position: int, pair: str) -> int:
    """Where the bracket that opens at this position is closed; the end if it is not."""
    depth = 0
    for number, sign in _signs(code, position, pair):
        depth += 1 if sign == pair[0] else -1
        if depth == 0:
            return number
    return min(len(code), position + _FAR)


def _opening(code: str, position: int) -> int:
    """Where the block opens that this position is in; 0 outside of all."""
    depth = 0
    for number in range(position - 1, max(-1, position - _FAR), -1):
        depth += (code[number] == "}") - (code[number] == "{")
        if depth < 0:
            return number
    return 0


def _signs(code: str, start: int, signs: str) -> Iterator[tuple[int, str]]:
    end = min(len(code), start + _FAR)
    return ((number, code[number]) for number in range(start, end) if code[number] in signs)
