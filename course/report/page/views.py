"""Figures about the whole class, counted once, for the page to draw."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from course.model.gradebook import GradedExercise
from course.model.result import CheckResult, Outcome, Verdict
from course.report.gradebook.sheets import COMPLETE, INCOMPLETE, NOT_HANDED_IN, Mark, Sheet
from course.report.page.data import ClassPage

BARS = 10
_JUDGED = (Outcome.PASSED, Outcome.FAILED, Outcome.SKIPPED)


@dataclass(frozen=True)
class Bar:
    """How many people have a share of the points within one range."""

    label: str
    count: int


@dataclass(frozen=True)
class CheckView:
    """judged: for how many people it counts. not_reached: for how many of them an earlier check had failed.

    tells_apart: how passing it correlates with the exercise's other points, from -1 to 1; None if everybody
    has the same result. Near 0 or below, the check does not show who knows more.
    """

    title: str
    bonus: bool
    judged: int
    passed: int
    failed: int
    not_reached: int
    tells_apart: float | None

    @property
    def percent(self) -> int | None:
        """The share of passes among the people for whom it counts."""
        return _percent(self.passed, self.judged)


@dataclass(frozen=True)
class ExerciseView:
    """handed_in: by how many people. points, seconds: the median. longest: seconds of the longest grading."""

    exercise: GradedExercise
    handed_in: int
    passed: int
    not_passed: int
    not_judged: int
    points: float | None
    seconds: float
    longest: float
    checks: tuple[CheckView, ...]

    @property
    def percent(self) -> int | None:
        """The share that passed, among those whose work was judged."""
        return _percent(self.passed, self.passed + self.not_passed)


@dataclass(frozen=True)
class CommonMistake:
    """A message of a failed check. people: places in the class of those who got it."""

    exercise: str
    title: str
    words: str
    people: tuple[int, ...]


@dataclass(frozen=True)
class Changed:
    """A verdict that is different from the one in the earlier run. people: places in the class."""

    exercise: str
    words: str
    people: tuple[int, ...]


@dataclass(frozen=True)
class NotJudged:
    """An exercise that could not be judged, through no fault of the learner's."""

    exercise: str
    verdict: str
    people: tuple[int, ...]


@dataclass(frozen=True)
class ClassTotals:
    """states: how many submissions are in each state. seconds: the time of all gradings together."""

    people: int
    gradings: int
    passed: int
    not_passed: int
    not_judged: int
    states: dict[str, int]
    median_percent: float | None
    seconds: float


def totals(page: ClassPage) -> ClassTotals:
    marks = [mark for sheet in page.sheets for mark in sheet.marks]
    verdicts = Counter(mark.verdict for mark in marks)
    states = Counter(sheet.state for sheet in page.sheets)
    shares = [share for sheet in page.sheets if (share := _share(sheet)) is not None]
    passed, not_passed = verdicts[Verdict.PASSED.value], verdicts[Verdict.NOT_PASSED.value]
    gradings = sum(mark.result is not None for mark in marks)
    return ClassTotals(
        people=len(page.sheets),
        gradings=gradings,
        passed=passed,
        not_passed=not_passed,
        not_judged=sum(mark.is_open for mark in marks),
        states={state: states[state] for state in (COMPLETE, INCOMPLETE, NOT_HANDED_IN)},
        median_percent=round(median(shares) * 100) if shares else None,
        seconds=sum(sheet.seconds for sheet in page.sheets),
    )


def distribution(page: ClassPage) -> tuple[Bar, ...]:
    """People with a total, in equal ranges of the share of points; with bonus points, it can exceed 100%."""
    counts: Counter[int] = Counter()
    for sheet in page.sheets:
        share = _share(sheet)
        if share is not None:
            counts[min(int(share * BARS + 1e-9), BARS)] += 1
    step = 100 // BARS
    labels = [f"{low}–{low + step - 1}%" for low in range(0, 100, step)] + ["100% or more"]
    return tuple(Bar(label, counts[place]) for place, label in enumerate(labels))


def exercises(page: ClassPage) -> tuple[ExerciseView, ...]:
    return tuple(_exercise(one, [mark for _, mark in page.marks(one)]) for one in page.exercises)


def mistakes(page: ClassPage) -> list[CommonMistake]:
    """The most common first."""
    people: defaultdict[tuple[str, str, str], list[int]] = defaultdict(list)
    for one in page.exercises:
        for place, mark in page.marks(one):
            for check in _checks(mark):
                if check.outcome is Outcome.FAILED and check.feedback:
                    found = people[one.id, check.title, check.feedback.summary]
                    if place not in found[-1:]:  # the same words twice are one person's mistake
                        found.append(place)
    every = [CommonMistake(*words, tuple(places)) for words, places in people.items()]
    return sorted(every, key=lambda mistake: -len(mistake.people))


def changes(page: ClassPage) -> tuple[Changed, ...]:
    """Verdicts that changed since `page.before`."""
    people: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    for one in page.exercises:
        for place, mark in page.marks(one):
            then = page.then(page.sheets[place], mark)
            if then and then.verdict != mark.verdict:
                people[one.id, f"{then.verdict} → {mark.verdict}"].append(place)
    return tuple(Changed(*what, tuple(places)) for what, places in people.items())


def troubles(page: ClassPage) -> tuple[NotJudged, ...]:
    found: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    for one in page.exercises:
        for place, mark in page.marks(one):
            if mark.is_open:
                found[one.id, mark.verdict].append(place)
    return tuple(NotJudged(*what, tuple(people)) for what, people in found.items())


def _exercise(exercise: GradedExercise, marks: Sequence[Mark]) -> ExerciseView:
    handed_in = [mark for mark in marks if mark.result]
    verdicts = Counter(mark.verdict for mark in handed_in)
    points = [mark.points for mark in handed_in if mark.points is not None]
    seconds = [mark.seconds for mark in handed_in]
    return ExerciseView(
        exercise=exercise,
        handed_in=len(handed_in),
        passed=verdicts[Verdict.PASSED.value],
        not_passed=verdicts[Verdict.NOT_PASSED.value],
        not_judged=sum(mark.is_open for mark in handed_in),
        points=median(points) if points else None,
        seconds=median(seconds) if seconds else 0.0,
        longest=max(seconds, default=0.0),
        checks=tuple(_check_views(handed_in)),
    )


def _check_views(marks: Sequence[Mark]) -> list[CheckView]:
    found: defaultdict[tuple[str, str, bool], list[tuple[CheckResult, float]]] = defaultdict(list)
    for mark in marks:
        total = sum(check.earned for check in _checks(mark))
        for check in _checks(mark):
            found[check.id, check.title, check.bonus].append((check, total - check.earned))
    return [_check_view(title, bonus, each) for (_, title, bonus), each in found.items()]


def _check_view(title: str, bonus: bool, each: Sequence[tuple[CheckResult, float]]) -> CheckView:
    counts = Counter(check.outcome for check, _ in each)
    judged = [(check.outcome is Outcome.PASSED, rest) for check, rest in each if check.outcome in _JUDGED]
    return CheckView(
        title=title,
        bonus=bonus,
        judged=len(judged),
        passed=counts[Outcome.PASSED],
        failed=counts[Outcome.FAILED],
        not_reached=counts[Outcome.SKIPPED],
        tells_apart=_correlation(judged),
    )


def _correlation(pairs: Sequence[tuple[float, float]]) -> float | None:
    """Pearson's correlation; None if one side is constant."""
    if len(pairs) < 2:
        return None
    means = [sum(side) / len(pairs) for side in zip(*pairs, strict=True)]
    apart = [(one - means[0], other - means[1]) for one, other in pairs]
    spread = sum(one * one for one, _ in apart) * sum(other * other for _, other in apart)
    return sum(one * other for one, other in apart) / spread**0.5 if spread > 1e-12 else None


def _checks(mark: Mark) -> tuple[CheckResult, ...]:
    return mark.result.checks if mark.result else ()


def _share(sheet: Sheet) -> float | None:
    return sheet.points / sheet.max_points if sheet.points is not None and sheet.max_points else None


def _percent(part: int, whole: int) -> int | None:
    return round(part / whole * 100) if whole else None
