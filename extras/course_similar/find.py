"""Finds the similar pairs of a class: reads every submission, then compares them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import combinations
from pathlib import Path

from markdown_it import MarkdownIt

from course.batch.batch_plan import exercises_named
from course.batch.intake import Found, Upload, find_sources, look
from course.batch.intake.recognize import made_of
from course.batch.intake.tree import Tree, read_tree
from course.content import Course, Exercise
from course.content.layout import ALTERNATIVE
from course.errors import UsageError
from course.home.opening import Refused, Remark
from course.model import replace
from course_similar.comparison import Comparison, Match, Pair, Passage, Side
from course_similar.tokens import File, Reader, text_of, words_of
from course_similar.work import Work, fingerprinter, lines_of, runs, work_of

Say = Callable[[str], None]


class Solutions(Enum):
    """How to treat the course's own solutions."""

    ALONE = "left alone"
    COMPARED = "compared too, as if somebody had handed them in"
    GIVEN = "given, as starters are: what is in them counts for nobody"


def find_similar(
    submissions: Path,
    opened: Path,
    course: Course,
    wanted: Wanted,
    solutions: Solutions,
    on_progress: Say,
    only: Sequence[str] = (),
) -> Comparison:
    """submissions: as for `find_sources`. opened: a folder for archives, needed until this returns.

    only: names of the exercises whose code is compared; all code if there are none.

    Raises MissingHere without the library, UsageError if there are not two to compare, and StorageError.
    """
    reading = _Reading(course, solutions, on_progress)
    works = reading.works(submissions, opened, exercises_named(course, only))
    own = [work for work in works if work.words]
    if len(works) < 2:
        raise UsageError(
            "There are no two submissions to compare.", "Name the folder that contains them all."
        )
    if solutions is Solutions.COMPARED:
        own += reading.solutions()
    pairs, more = compare(own, wanted, on_progress)
    return Comparison(
        pairs=pairs,
        compared=sum(not work.ours for work in own),
        threshold=wanted.share,
        more=more,
        without=tuple(work.name for work in works if not work.words),
        remarks=tuple(reading.remarks),
    )


class _Reading:
    """remarks: what was left out, and whose."""

    def __init__(self, course: Course, solutions: Solutions, say: Say) -> None:
        self._fingerprinter = fingerprinter()  # first: without the library, nothing needs to be read
        self.remarks: list[str] = []
        self._course = course
        self._say = say
        self._reader = Reader()
        self._given = given_of(course, self._reader, solutions=solutions is Solutions.GIVEN)

    def works(self, submissions: Path, opened: Path, only: Sequence[Exercise]) -> list[Work]:
        found = gather(submissions, opened, self._course.exercises())
        if only:
            found = (replace(one, files=tuple(_files_of(one.files, only))) for one in found)
        return list(self._each(found))

    def solutions(self) -> list[Work]:
        handed_in = (HandedIn(name, tuple(files)) for name, files in solutions_of(self._course).items())
        return [work for work in (self._work(one, ours=True) for one in handed_in) if work.words]

    def _each(self, found: Iterator[HandedIn]) -> Iterator[Work]:
        for number, one in enumerate(found, 1):
            self._say(f"Reading submission {number}")
            yield self._work(one)

    def _work(self, one: HandedIn, *, ours: bool = False) -> Work:
        read, findings = self._reader.read(one.files)
        self.remarks += (_remark(one.name, finding) for finding in (*one.findings, *findings))
        return work_of(one.name, read, self._given, self._fingerprinter, ours=ours)


def _files_of(files: Iterable[File], exercises: Iterable[Exercise]) -> Iterator[File]:
    names = {name for exercise in exercises for name in exercise.files}
    packages = {package for exercise in exercises for package in exercise.packages}
    return (file for file in files if file.name in names or packages.intersection(Path(file.name).parts))


def _remark(name: str, finding: Remark) -> str:
    return f"{name}: {finding.what}{f' ({finding.where})' if finding.where else ''}"


# Fingerprints are a sample, so a pair's words are counted from this fraction of the wanted share on.
_LENIENT = 0.5
_LONGEST_PASSAGE = 200  # lines


@dataclass(frozen=True)
class Wanted:
    """Which pairs are shown. share: the smallest share of either side's code (0 to 1). lines: the fewest.

    pairs: the most pairs. matches: the most of each pair.
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
        """The most similar first; of those, the longer first."""
        return -round(max(self.shares), 2), -max(self.lines), self.one.name, self.other.name


def compare(
    works: Sequence[Work], wanted: Wanted, on_progress: Callable[[str], None] = lambda _: None
) -> tuple[tuple[Pair, ...], int]:
    """The similar pairs, the most similar first, and how many more there are."""
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
    """Reads the lines only now, so that the texts of a whole class need not fit into memory."""
    file = work.sources[work.files[begin]]
    first, last = work.lines[begin], work.lines[begin + length - 1]
    last = min(last, first + _LONGEST_PASSAGE - 1)
    lines = text_of(file.path.read_bytes()).split("\n")[first - 1 : last]
    return Passage(file.name, first, tuple(lines))


@dataclass(frozen=True)
class HandedIn:
    """The files of one submission. name: its owner, unique and safe to show."""

    name: str
    files: tuple[File, ...]
    findings: tuple[Remark, ...] = ()


def gather(submissions: Path, opened: Path, exercises: Iterable[Exercise]) -> Iterator[HandedIn]:
    """submissions: as for `find_sources`. opened: a folder for archives, needed as long as the files are.

    Raises UsageError and StorageError.
    """
    exercises = tuple(exercises)
    sources = find_sources(submissions, opened / "class")
    names = Counter(source.person.name for source in sources.each)
    for source in sources.each:
        person = source.person
        name = person.name if names[person.name] == 1 and person.name else f"{person.name} ({person.id})"
        yield _handed_in(name.strip(), source, look(source, opened / person.id, exercises))


def _handed_in(name: str, source: Upload, found: Found) -> HandedIn:
    try:
        files = _laid_out(read_tree(found.parts), found) if found.places else _as_it_is(source)
    except Refused as refused:
        return HandedIn(name, (), (refused.finding,))
    return HandedIn(name, tuple(files), found.findings)


def _laid_out(tree: Tree, found: Found) -> list[File]:
    return [File(path, entry.path) for path, entry in made_of(tree, found.places) if not entry.folder]


def _as_it_is(source: Upload) -> list[File]:
    """All files of a submission in which nothing of the course was recognized: they can still be compared."""
    entries = read_tree(source.parts).entries
    return [File(path, entry.path) for path, entry in entries.items() if not entry.folder]


# Shorter than what counts as similar, so that a person's own code around a starter's line still counts.
GIVEN = 16  # words in a row
_ALTERNATIVES = "alternatives"
_LANGUAGES = frozenset({"python", "cpp", "yaml", "xml"})

Given = frozenset[str]


def given_of(course: Course, reader: Reader, *, solutions: bool = False) -> Given:
    """The runs of GIVEN words in starters, lessons, and, with `solutions`, in solutions."""
    exercises = course.exercises()
    folders = [exercise.starter for exercise in exercises]
    if solutions:
        folders += [exercise.solution for exercise in exercises]
    texts = [words.text for folder in _each(folders) for _, words in reader.read(_files(folder))[0]]
    texts += [words_of(code, language).text for language, code in _shown(exercises)]
    return frozenset(text[at : at + GIVEN] for text in texts for at in range(len(text) - GIVEN + 1))


def solutions_of(course: Course) -> dict[str, list[File]]:
    """The reference solution of each chapter, and each alternative, with the name that is shown."""
    found: dict[str, list[File]] = {}
    for folder in _each(exercise.solution for exercise in course.exercises()):
        for file in _files(folder):
            parts = Path(file.name).parts
            other = parts[0] == _ALTERNATIVES and len(parts) > 2
            name = f"solution {folder.name}{f' ({parts[1]})' if other else ''}"
            if parts[-1] != ALTERNATIVE:
                found.setdefault(name, []).append(file)
    return found


def _files(folder: Path) -> list[File]:
    return [File(str(path.relative_to(folder)), path) for path in folder.rglob("*") if path.is_file()]


def _each(folders: Iterable[Path]) -> list[Path]:
    return [folder for folder in dict.fromkeys(folders) if folder.is_dir()]


def _shown(exercises: Iterable[Exercise]) -> Iterator[tuple[str, str]]:
    """The code that lessons show: (language, code)."""
    for folder in _each(exercise.folder for exercise in exercises):
        for file in sorted(folder.glob("*.md")):
            for token in MarkdownIt().parse(file.read_text(encoding="utf-8")):
                language = token.info.split(" ")[0]
                if token.type == "fence" and language in _LANGUAGES:
                    yield language, token.content
