"""deadlines.yaml: what being late costs, and for whom."""

from __future__ import annotations

from datetime import datetime, timezone
from pathlib import Path

import pytest

from course.batch.deadlines import ClassList, Deadlines, duration, read_deadlines
from course.errors import UsageError
from course.model import replace
from course.model.gradebook import Delay, Person

ADA = Person("ada", "Ada Okafor")
BAO = Person("bao", "Bao")
DUE = "due: 2026-10-05 23:59\nzone: America/New_York\n"


def read(folder: Path, text: str) -> Deadlines:
    (folder / "deadlines.yaml").write_text(text, encoding="utf-8")
    found = read_deadlines(folder, ClassList([ADA, BAO]))
    assert found is not None
    return found


def late(folder: Path, text: str, at: str, person: Person = ADA) -> Delay:
    known = replace(person, handed_in=datetime.fromisoformat(at))
    return read(folder, text).lateness(known, handed_in=True)


@pytest.mark.parametrize(
    ("at", "words"),
    [
        ("2026-10-05T23:59", ""),
        ("2026-10-06T00:01", "2 minutes late"),
        ("2026-10-07T02:59", "1 day 3 hours late"),
        ("2026-10-06T03:59+00:00", ""),  # 23:59 in New York
        ("2026-10-06T04:59+00:00", "1 hour late"),
    ],
)
def test_what_is_late(tmp_path: Path, at: str, words: str) -> None:
    assert late(tmp_path, DUE, at).words == words


def test_the_hour_that_the_clocks_are_set_back_counts(tmp_path: Path) -> None:
    text = "due: 2026-11-01 00:30\nzone: America/New_York\n"
    assert late(tmp_path, text, "2026-11-01T03:30").words == "4 hours late"


PENALTY = "penalty: {percent: 10, each: 1 day, most: 50}\n"


@pytest.mark.parametrize(
    ("more", "at", "penalty"),
    [
        ("", "2026-10-09T12:00", 0),
        (PENALTY, "2026-10-06T00:00", 0.1),
        (PENALTY, "2026-10-06T23:59", 0.1),
        (PENALTY, "2026-10-07T00:00", 0.2),
        (PENALTY, "2026-11-07T00:00", 0.5),
        (PENALTY + "grace: 15 min\n", "2026-10-06T00:14", 0),
        (PENALTY + "grace: 15 min\n", "2026-10-06T00:15", 0.1),
        (PENALTY + "late_days: 2\n", "2026-10-07T12:00", 0),
        (PENALTY + "late_days: 2\n", "2026-10-08T12:00", 0.1),
        (PENALTY + "late_days: 2\nlate_days_used: {ada: 1}\n", "2026-10-07T12:00", 0.1),
        (PENALTY + "late_days: 2\nlate_days_used: {Bao: 1}\n", "2026-10-07T12:00", 0),
        (PENALTY + "closes: 3 days\n", "2026-10-08T23:59", 0.3),
        (PENALTY + "closes: 3 days\n", "2026-10-09T00:00", 1),
        (PENALTY + "extensions: {Ada Okafor: 2026-10-08 12:00}\n", "2026-10-08T11:00", 0),
        (PENALTY + "handed_in: {ada: 2026-10-05 20:00}\n", "2026-10-08T11:00", 0),
    ],
)
def test_what_it_costs(tmp_path: Path, more: str, at: str, penalty: float) -> None:
    assert late(tmp_path, DUE + more, at).penalty == pytest.approx(penalty)


def test_late_days_are_told(tmp_path: Path) -> None:
    text = f"{DUE}late_days: 3\n"
    assert late(tmp_path, text, "2026-10-07T12:00").words == "1 day 12 hours 1 minute late (2 late days used)"


def test_what_a_person_says_comes_first(tmp_path: Path) -> None:
    known = replace(ADA, handed_in=datetime(2026, 12, 1, tzinfo=timezone.utc))
    found = read(tmp_path, DUE + PENALTY)
    assert found.lateness(known, handed_in=True, late_by=0.0).penalty == 0
    assert found.lateness(ADA, handed_in=True, late_by=86_400.0 * 2).penalty == 0.2


def test_who_handed_in_nothing_or_at_an_unknown_time(tmp_path: Path) -> None:
    found = read(tmp_path, DUE + PENALTY)
    assert found.lateness(ADA, handed_in=False) == Delay()
    assert found.lateness(ADA, handed_in=True) == Delay(words="time not known")
    assert found.lateness(replace(ADA, late=True), handed_in=True).words == "late, time not known"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("zone: UTC\n", "`due` is missing"),
        ("due: 2026-10-05\n", "must have a time of day"),
        ("due: soon\n", "must be a date and a time"),
        (DUE + "grace: 3 moons\n", "must be a time span"),
        ("due: 2026-10-05 23:59\nzone: Mars/Base\n", "must be a time zone"),
        (DUE + "gracee: 3 h\n", "did you mean `grace`"),
        (DUE + "penalty: {percent: 200}\n", "less than or equal to 100"),
        (DUE + "extensions: {adda: 2026-10-08 12:00}\n", "did you mean `ada`"),
        (DUE + "due: 2026-10-06 23:59\n", "appears twice here"),
    ],
)
def test_mistakes_are_told_with_their_line(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(UsageError, match=r"deadlines.yaml:\d") as raised:
        read(tmp_path, text)
    assert said in raised.value.what


def test_a_folder_without_deadlines(tmp_path: Path) -> None:
    assert read_deadlines(tmp_path, ClassList([])) is None


@pytest.mark.parametrize(
    ("seconds", "words"), [(30, "1 minute"), (3600, "1 hour"), (90_060, "1 day 1 hour 1 minute")]
)
def test_durations(seconds: float, words: str) -> None:
    assert duration(seconds) == words
