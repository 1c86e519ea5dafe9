"""Compares every submission with every other one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

from course.batch.similar.reading import text_of
from course.batch.similar.work import Work, lines_of, runs
from course.report.similar.model import Match, Pair, Passage, Side

# Fingerprints are a sample. A pair is counted word by word from this part of the wanted share on.
_LENIENT = 0.5
_LONGEST_PASSAGE = 200  # lines


@dataclass(frozen=True)
class Wanted:
    """Which pairs are shown. share: of either side's code, at least (0 to 1). lines: at least so many.

    pairs: at most so many. matches: of each pair, at most so many.
    """

    share: float = 0.6
    lines: int = 10
    pairs: int = 20
    matches: int = 20


@dataclass(frozen=True)
class _Alike:
    one: Work
    other: Work
    shares: tuple[float, float]
    lines: tuple[int, int]

    @property
    def order(self) -> tuple[float, int, str, str]:
        """The most alike first; of those, the longer first."""
        return -round(max(self.shares), 2), -max(self.lines), self.one.name, self.other.name


def compare(
    works: Sequence[Work], wanted: Wanted, on_progress: Callable[[str], None] = lambda _: None
) -> tuple[tuple[Pair, ...], int]:
    """The pairs that are alike, most alike first, and how many more there are."""
    candidates = [pair for pair in combinations(works, 2) if _may_be_alike(*pair, wanted.share)]
    found = []
    for number, (one, other) in enumerate(candidates, 1):
        if number % 20 == 0:
            on_progress(f"Comparing: {number:,} of {len(candidates):,} pairs that have something in common")
        alike = _measured(one, other)
        if max(alike.shares) >= wanted.share and max(alike.lines) >= wanted.lines:
            found.append(alike)
    found.sort(key=lambda alike: alike.order)
    shown = tuple(_pair(alike, wanted.matches) for alike in found[: wanted.pairs])
    return shown, len(found) - len(shown)


def _may_be_alike(one: Work, other: Work, share: float) -> bool:
    if one.ours and other.ours:
        return False
    common = len(one.fingerprints & other.fingerprints)
    return common > 0 and common >= _LENIENT * share * min(len(one.fingerprints), len(other.fingerprints))


def _measured(one: Work, other: Work) -> _Alike:
    in_one = [range(run.one, run.one + run.length) for run in runs(one, other)]
    in_other = [range(run.one, run.one + run.length) for run in runs(other, one)]
    shares = _share(one, in_one), _share(other, in_other)
    return _Alike(one, other, shares, (lines_of(one, in_one), lines_of(other, in_other)))


def _share(work: Work, parts: Iterable[range]) -> float:
    return sum(map(len, parts)) / work.words


def _pair(alike: _Alike, most: int) -> Pair:
    one, other = alike.one, alike.other
    found = sorted(runs(one, other), key=lambda run: (-run.length, run.one))
    matches = tuple(
        Match(_passage(one, run.one, run.length), _passage(other, run.other, run.length))
        for run in found[:most]
    )
    left, right = map(Side, (one.name, other.name), alike.shares, alike.lines)
    return Pair(left, right, matches, len(found) - len(matches))


def _passage(work: Work, begin: int, length: int) -> Passage:
    """The lines are read now, so that not all texts of a class need be held."""
    file = work.sources[work.files[begin]]
    first, last = work.lines[begin], work.lines[begin + length - 1]
    last = min(last, first + _LONGEST_PASSAGE - 1)
    lines = text_of(file.path.read_bytes()).split("\n")[first - 1 : last]
    return Passage(file.name, first, tuple(lines))
