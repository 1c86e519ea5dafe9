"""A submission's own code, and which parts of it another submission contains."""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from string import ascii_lowercase, digits

from course.cli.usage import installing
from course.errors import MissingHere
from course_similar.tokens import File, Words, number_of

SAME = 24  # this many equal words in a row, about three lines, count as similar
# If the other one contains a passage many times, this many places are tried.
_TRIED = 8
_GAP = "\0"

# A library makes fingerprints of texts of digits and letters: each 30 of these give one, and one of each 64
# neighbors is kept. With three characters for each word, 31 common words always give a common fingerprint.
SHORTEST = 31  # words; fewer have no fingerprint
_DIGITS = tuple("".join(three) for three in product(digits + ascii_lowercase, repeat=3))
_FINGERPRINT = re.compile(r"\b[0-9a-f]{8}\b")

Fingerprinter = Callable[[str], frozenset[str]]


def fingerprinter() -> Fingerprinter:
    """A function from words (`Words.text`, or a part of it) to their fingerprints.

    Raises MissingHere if the library is not installed.
    """
    try:
        from scanoss_winnowing.winnowing import Winnowing
    except ImportError:
        what = "Comparing submissions needs a library that is not installed: scanoss-winnowing."
        step = f"`{installing('similar')}` installs it."
        raise MissingHere(what, step) from None
    winnowing = Winnowing(quiet=True, all_extensions=True)

    def fingerprints(words: str) -> frozenset[str]:
        coded = "".join(_DIGITS[number_of(word)] for word in words)
        # The first line describes the file; the others are fingerprints.
        _, _, found = winnowing.wfp_for_contents("", False, coded.encode()).partition("\n")
        return frozenset(_FINGERPRINT.findall(found))

    return fingerprints


@dataclass(frozen=True)
class Work:
    """name: the owner's. text: its words, with a gap between separate parts.

    files, lines: for each word, the file's index in `sources`, and the line. fingerprints: see there.
    ours: whether it is the course's own solution.
    """

    name: str
    sources: tuple[File, ...]
    text: str
    files: array[int]
    lines: array[int]
    fingerprints: frozenset[str]
    ours: bool = False

    @cached_property
    def words(self) -> int:
        return len(self.text) - self.text.count(_GAP)

    @cached_property
    def index(self) -> dict[str, list[int]]:
        """Where each run of SAME words begins."""
        found: dict[str, list[int]] = {}
        for begin in range(len(self.text) - SAME + 1):
            found.setdefault(self.text[begin : begin + SAME], []).append(begin)
        return {run: places for run, places in found.items() if _GAP not in run}


@dataclass(frozen=True)
class Run:
    """`length` words that are the same in two works, starting at `one` and at `other`."""

    one: int
    other: int
    length: int


def work_of(
    name: str,
    files: Sequence[tuple[File, Words]],
    given: frozenset[str],
    fingerprinter: Fingerprinter,
    *,
    ours: bool = False,
) -> Work:
    """given: runs of words from the course, all of the same length; see `given.Given`."""
    text: list[str] = []
    of_files, lines = array("i"), array("i")
    fingerprints: set[str] = set()
    for number, (_, words) in enumerate(files):
        for begin, end in stretches(words.text, given):
            text += words.text[begin:end], _GAP
            of_files.extend([number] * (end - begin + 1))
            lines.extend((*words.lines[begin:end], 0))
            fingerprints |= fingerprinter(words.text[begin:end])
    sources = tuple(file for file, _ in files)
    return Work(name, sources, "".join(text), of_files, lines, frozenset(fingerprints), ours)


def stretches(text: str, given: frozenset[str]) -> Iterator[tuple[int, int]]:
    """The beginning and end of each part that is not given and is long enough to compare."""
    length = len(next(iter(given), ""))
    begin = 0
    for at, end in _given_places(text, given, length):
        if at - begin >= SHORTEST:
            yield begin, at
        begin = end
    if len(text) - begin >= SHORTEST:
        yield begin, len(text)


def _given_places(text: str, given: frozenset[str], length: int) -> Iterator[tuple[int, int]]:
    """The parts of the text that are given, in order; they do not overlap."""
    begin = end = 0
    for at in range(len(text) - length + 1) if given else ():
        if text[at : at + length] in given:
            if at > end:
                yield begin, end
                begin = at
            end = at + length
    yield begin, end


def runs(one: Work, other: Work) -> Iterator[Run]:
    """The parts of `one` that are also in `other`: each word of `one` once, the longest run at each place."""
    common = one.index.keys() & other.index.keys()
    done = 0
    for at in sorted(at for words in common for at in one.index[words]):
        if at >= done:
            places = other.index[one.text[at : at + SAME]][:_TRIED]
            length, place = max((_in_common(one.text, at, other.text, place), -place) for place in places)
            yield Run(at, -place, length)
            done = at + length


def _in_common(one: str, at: int, other: str, place: int) -> int:
    """How many characters are the same from these places on, up to a gap; at least SAME."""
    end = one.find(_GAP, at)
    most = min(end if end >= 0 else len(one), at + len(other) - place) - at
    same, step = SAME, SAME
    while step:
        step = min(step, most - same)
        if one[at + same : at + same + step] == other[place + same : place + same + step]:
            same += step
            step *= 2
        else:
            step //= 2
    return same


def lines_of(work: Work, parts: Iterable[range]) -> int:
    """How many different lines contain words of these parts."""
    return len({(work.files[at], work.lines[at]) for part in parts for at in part})
