"""Where the learner's C++ files call something, as far as that is clear without a compiler."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from course.evidence.sources import Sources
from course.explain.engine import Cause
from course.model.feedback import Location

ENDINGS = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".hxx", ".h")
# Comments and quoted texts are not code. Anything unclosed extends to the end. Otherwise, the search would
# run to the end of the text for each opening mark.
_NO_CODE = re.compile(
    r"//[^\n]*|/\*.*?(?:\*/|\Z)"
    r'|R"(?P<mark>[^\s()\\]{0,16})\(.*?(?:\)(?P=mark)"|\Z)'
    r"""|"(?:\\.|[^"\\\n])*(?:"|(?=\n)|\Z)|(?<![\w'])'(?:\\.|[^'\\\n])*(?:'|(?=\n)|\Z)""",
    re.DOTALL,
)
# A brace right after a name initializes that variable (`timer_{...}`), so it does not end a statement.
_ENDS_A_STATEMENT = re.compile(r"[;}]|(?<!\w)\{|(?<=\belse)\{|(?<=\btry)\{|(?<=\bdo)\{")
# Limits for the search: a learner's file has few calls with the same name, and short blocks.
_MOST_CALLS, _FAR, _LONGEST_STATEMENT = 50, 20_000, 1000


@dataclass(frozen=True)
class CppCall:
    """One call: `before` is how its statement begins, `arguments` what its parentheses contain.

    around: the block that contains the call, with spaces instead of comments and quoted texts.
    """

    where: Location
    before: str
    arguments: str
    around: str


def is_cpp(file: str) -> bool:
    return file.endswith(ENDINGS)


def cpp_files(sources: Sources) -> dict[str, str]:
    """Return the C++ files among the sources, without tests."""
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
    """Return where code matches the pattern, ignoring comments and quoted texts."""
    return tuple(
        Location(file, _line(code, found.start()))
        for file, text in cpp_files(sources).items()
        for code in (only_code(text),)
        for found in islice(re.finditer(pattern, code), _MOST_CALLS)
    )


@lru_cache(maxsize=256)
def only_code(text: str) -> str:
    """The text with spaces instead of comments and quoted texts; line breaks stay."""
    return _NO_CODE.sub(lambda found: re.sub(r"[^\n\"]", " ", found[0]), text)


# These read hostile sources, too, so they must not try the same text again from each of its characters.
# At the beginning of a line, after the end of a statement or an opening brace.
_BEGINS = r"(?<=[;{})]\n)[ \t]*"
_EFFECTLESS = (
    (
        rf"{_BEGINS}[\w.:>\[\]-]+\s*==[^;=]*;",
        "`==` only compares, and changes nothing. A single `=` assigns a value.",
    ),
    (
        rf"{_BEGINS}(?:if\s*\([^;{{}}\n]*\)\s*(?:\{{\s*)?)?std::\w+(?:_error|_argument|_range)\s*[({{][^;]*;",
        "This line creates an exception, but does not throw it: write `throw` before it.",
    ),
    (
        r"\b(?:while|if)\s*\(\s*(?:!\s*)?rclcpp::ok\s*\)",
        "`rclcpp::ok` only names the function. Call it: `rclcpp::ok()`.",
    ),
    (
        r"(?<![\w:<>,&*])(?!void\s|explicit\b|else\b|constexpr\b|inline\b)[\w:<>,&*]*[\w>&*]\s+"
        r"(?!if\b|main\b|(\w+)::\1\b)[\w:]+\s*\([^;{}()]*\)\s*(?:const\s*)?\{(?![^{}]*\b(?:return|throw)\b)[^{}]+\}",
        "This function has no `return`, so the value that it gives back is arbitrary.",
    ),
)


_OVERRIDES = re.compile(r"\boverride\b")


def without_effect(sources: Sources) -> Cause | None:
    """A statement of C++ that compiles, but cannot do what it was meant to do."""
    found = ((text, places_of(sources, pattern)) for pattern, text in _EFFECTLESS)
    return next((Cause(text, places[:1]) for text, places in found if places), None)


def never_called(sources: Sources) -> Cause | None:
    """A method that is declared and defined, and then never named again."""
    code = "\n".join(map(only_code, cpp_files(sources).values()))
    # A declaration that overrides does not count: others call the method.
    plain = (_OVERRIDES.split(statement)[-1] for statement in re.split(r"[;{}]", code))
    named = Counter(name for text in plain for name in re.findall(r"\w+", text))
    for found in re.finditer(r"(?m)^[ \t]*void\s+(\w+::)?(\w+)\s*\([^;{}()]*\)\s*(?:const\s*)?\{", code):
        if named[found[2]] == (2 if found[1] else 1):
            text = f"Nothing calls `{found[2]}`, or passes it to something that calls it."
            takers = places_of(sources, r"\bcreate_(?:subscription|wall_timer|timer|service)\b")
            return Cause(text, takers[:1] or places_of(sources, rf"\b{found[2]}\b")[-1:])
    return None


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
    """The position of the bracket that closes the one opened here; the end if there is none."""
    depth = 0
    for number, sign in _signs(code, position, pair):
        depth += 1 if sign == pair[0] else -1
        if depth == 0:
            return number
    return min(len(code), position + _FAR)


def _opening(code: str, position: int) -> int:
    """The position where the block around this position begins; 0 if there is no block."""
    depth = 0
    for number in range(position - 1, max(-1, position - _FAR), -1):
        depth += (code[number] == "}") - (code[number] == "{")
        if depth < 0:
            return number
    return 0


def _signs(code: str, start: int, signs: str) -> Iterator[tuple[int, str]]:
    end = min(len(code), start + _FAR)
    return ((number, code[number]) for number in range(start, end) if code[number] in signs)
