"""What is shown of a comparison: plain data. Texts and names are a stranger's, and cleaned when drawn."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Passage:
    """Lines `first` to `last` (from 1, both included) of a file, without their line ends."""

    file: str
    first: int
    lines: tuple[str, ...]

    @property
    def last(self) -> int:
        return self.first + len(self.lines) - 1


@dataclass(frozen=True)
class Match:
    """The same in both, but for names, texts, numbers, comments and blanks."""

    one: Passage
    other: Passage


@dataclass(frozen=True)
class Side:
    """share: of this side's own code, what is in the other's too (0 to 1). lines: how many lines that is."""

    name: str
    share: float
    lines: int


@dataclass(frozen=True)
class Pair:
    """matches: the longest first. more: matches that are left out here."""

    one: Side
    other: Side
    matches: tuple[Match, ...]
    more: int = 0


@dataclass(frozen=True)
class Comparison:
    """pairs: those that are alike, most alike first. more: such pairs that are left out here.

    compared: submissions with code of their own. threshold: from which share on a pair is shown (0 to 1).
    without: names of submissions that have no code of their own to compare. remarks: what was left out.
    """

    pairs: tuple[Pair, ...]
    compared: int
    threshold: float
    more: int = 0
    without: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
