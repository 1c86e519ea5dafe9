"""From a symptom to its cause: tries known errors in order, and uses the first one that is proven.

A known error is data: a pattern for a tool's message, the cause, the remedy, where to look, and an example.
The tables in this folder contain them; `tests/explain/test_known.py` runs every example through this engine.
To add an error, add one entry above any other entry that would match it, and one mistake to a chapter's
`mistakes.yaml`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.model.feedback import Location
from course.model.result import CheckResult, Outcome
from course.spelling import LOOSELY, nearest

Words = Mapping[str, str]
# `{name}` in an entry's text, but not CMake's `${NAME}` or C++'s `{ ... }`.
_WORD = re.compile(r"(?<!\$)\{([a-z_]+)\}")


@dataclass(frozen=True)
class Cause:
    """A likely cause: what to say, and where it is."""

    text: str
    where: tuple[Location, ...] = ()


def failed_with(check: CheckResult, *beginnings: str) -> bool:
    """Whether the check failed with advice that begins with one of these texts."""
    advice = check.feedback.advice if check.feedback else None
    return check.outcome is Outcome.FAILED and (advice or "").startswith(beginnings)


@dataclass(frozen=True)
class Symptom:
    """What a tool or a program said about an error.

    text: the message on one line. where: the learner's place that it names or leads to. printed: the lines
    as printed. words: what else the message says, for the texts of entries.
    """

    text: str
    where: Location | None = None
    printed: tuple[str, ...] = ()
    words: Words = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Evidence:
    """What a proof may examine. folder: of the package or project in question, relative to the home."""

    sources: Sources
    packages: BuiltPackages = field(default_factory=BuiltPackages)
    folder: str = ""

    @property
    def words(self) -> Words:
        """Words that the texts of every entry may use."""
        return {}

    def place(self, file: str, line: int | None = None) -> Location:
        """A place in the folder; `file` is relative to it."""
        return Location(f"{self.folder}/{file}" if self.folder else file, line)

    def text(self, file: str) -> str:
        """The content of a file in the folder; empty if it is missing or unreadable."""
        return self.sources.files.get(self.place(file).file, "")

    def files(self) -> list[str]:
        """Names of all files in the folder, relative to it."""
        return [name.removeprefix(f"{self.folder}/") for name in self.sources.below(self.folder).names]

    def matching(self, file: str, pattern: str) -> list[int]:
        """The numbers of the lines that match the pattern, in a file in the folder."""
        every = enumerate(self.text(file).splitlines(), 1)
        return [number for number, line in every if re.search(pattern, line)]

    def line(self, file: str, pattern: str) -> int | None:
        return next(iter(self.matching(file, pattern)), None)

    def shown(self, place: Location) -> tuple[str, ...]:
        """The source line at this place, without indentation; empty if there is none."""
        lines = self.sources.files.get(place.file, "").splitlines()
        return (lines[place.line - 1].strip(),) if place.line and place.line <= len(lines) else ()

    def own_file(self, shown: str) -> str | None:
        """A path that a tool printed, relative to the folder; None for files outside it."""
        name = shown.removeprefix("~/").removeprefix("./")
        name = name.removeprefix(f"{self.folder}/") if self.folder else name
        return name if self.place(name).file in self.sources.names else None


E = TypeVar("E", bound=Evidence, contravariant=True)


@dataclass(frozen=True)
class Proven:
    """What a proof found: more words for the entry's texts, and places to show first."""

    words: Words = field(default_factory=dict)
    where: tuple[Location, ...] = ()


# Takes the evidence, the symptom and the words so far; returns None if the cause is different.
Proof = Callable[[E, Symptom, Words], Proven | None]
# The place that an entry points to; None if it does not exist.
Place = Callable[[E, Symptom, Words], Location | None]


def here(evidence: Evidence, symptom: Symptom, words: Words) -> Location | None:
    """The place that the symptom itself names."""
    return symptom.where


@dataclass(frozen=True)
class Known(Generic[E]):
    """One known error.

    pattern: searched for in the symptom's text; its named groups are words for the texts.
    cause: what happened, in one sentence; empty if the symptom speaks for itself.
    remedy: what to do. Of several, the first one whose words are all known is used.
    example: a tool's message that this entry explains, and no earlier entry does.
    where: places to look at; by default, the symptom's own. proof: finds out whether this is the cause.
    kind: a short stable name for the cause, for statistics.
    given: files that the example needs, by their path in the folder.
    """

    pattern: str
    remedy: str | tuple[str, ...]
    example: str
    cause: str = ""
    where: tuple[Place[E], ...] = ()
    proof: Proof[E] | None = None
    kind: str = ""
    given: Mapping[str, str] = field(default_factory=dict)

    def explains(self, symptom: Symptom, evidence: E) -> Explanation | None:
        found = re.search(self.pattern, symptom.text)
        if found is None:
            return None
        named = {name: word for name, word in found.groupdict().items() if word is not None}
        words = {**evidence.words, **symptom.words, **named}
        proven = self.proof(evidence, symptom, words) if self.proof else Proven()
        if proven is None:
            return None
        words = {**words, **proven.words}
        remedies = (self.remedy,) if isinstance(self.remedy, str) else self.remedy
        remedy = next((text for one in remedies if (text := filled(one, words)) is not None), None)
        cause = filled(self.cause, words)
        if cause is None or remedy is None:
            return None
        places = (*proven.where, *(place(evidence, symptom, words) for place in self.where))
        known = tuple(dict.fromkeys(place for place in places if place))
        return Explanation(self, symptom, cause, remedy, known or ((symptom.where,) if symptom.where else ()))


@dataclass(frozen=True)
class Explanation:
    """What a known error means here: the entry that matched, on which symptom, and its texts."""

    known: Known[Any]
    symptom: Symptom
    cause: str
    remedy: str
    where: tuple[Location, ...]


def explain(known: Iterable[Known[E]], symptoms: Sequence[Symptom], evidence: E) -> Explanation | None:
    """The first entry that explains one of the symptoms, so list causes before their effects."""
    every = (entry.explains(symptom, evidence) for entry in known for symptom in symptoms)
    return next((found for found in every if found), None)


def filled(text: str, words: Words, escape: Callable[[str], str] = str) -> str | None:
    """The text with its words filled in; None if one of them is unknown."""
    if any(name not in words for name in _WORD.findall(text)):
        return None
    return _WORD.sub(lambda name: escape(words[name[1]]), text)


# ------------------------------------------------------------------------- parts that entries are made of


def at(file: str, *patterns: str) -> Place[Evidence]:
    """A line of a file in the folder; without patterns, the whole file.

    Uses the first pattern that matches any line, after the words are filled in, and its first such line.
    """

    def place(evidence: Evidence, symptom: Symptom, words: Words) -> Location | None:
        name = filled(file, words)
        if name is None or not patterns:
            return evidence.place(name) if name else None
        wanted = (filled(pattern, words, re.escape) for pattern in patterns)
        lines = (evidence.line(name, each) for each in wanted if each is not None)
        line = next(filter(None, lines), None)
        return evidence.place(name, line) if line else None

    return place


def like(names: Callable[[E], Iterable[str]], word: str = "name") -> Proof[E]:
    """Proves nothing, but provides as `near` the name that the word was probably meant to be."""

    def proof(evidence: E, symptom: Symptom, words: Words) -> Proven:
        near = nearest(words[word], names(evidence), LOOSELY)
        return Proven({"near": near} if near and near != words[word] else {})

    return proof


def because(cause: Callable[[Sources], Cause | None]) -> Proof[Evidence]:
    """A cause that is found in the learner's files; `{cause}` is its text."""

    def proof(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
        found = cause(evidence.sources)
        return Proven({"cause": found.text}, found.where) if found else None

    return proof
