"""A class of sixty, graded by the real command: every row is known in advance."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.build import Store
from course.content import open_course
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model.result import Verdict
from tests.batch.command import Command, half_written, verdicts
from tests.batch.picture import picture, shown
from tests.batch.the_class import Member, lay_class

pytestmark = pytest.mark.slow


@pytest.fixture
def command(tmp_path: Path, shared_builds: Store) -> Command:
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle:
        pytest.skip(f"not exercised here: a class with hostile submissions ({obstacle})")
    cache = shared_builds.root.parent
    return Command(tmp_path / "class", tmp_path / "grades", tmp_path / "tmp", cache=cache)


def rows(out: Path) -> Iterator[dict[str, str]]:
    with (out / "results.csv").open(encoding="utf-8-sig", newline="") as file:
        yield from csv.DictReader(file)


def surprises(members: tuple[Member, ...], out: Path) -> Iterator[str]:
    found = verdicts(out)
    for member in members:
        given = {exercise: each for (person, exercise), each in found.items() if person == member.person}
        for exercise in given.keys() ^ member.expected.keys():
            yield f"{member.what}: {exercise} was {'' if exercise in given else 'not '}graded"
        for exercise in given.keys() & member.expected.keys():
            (verdict, failed), expected = given[exercise], member.expected[exercise]
            if verdict is not expected.verdict or expected.failed not in (None, failed):
                yield f"{member.what}, {exercise}: {verdict.value}, {sorted(failed)}; expected: {expected}"


def test_everybody_gets_what_they_deserve(command: Command, tmp_path: Path) -> None:
    members = lay_class(open_course(), command.folder)
    assert len(members) == len({member.person for member in members}) == 60
    said = command.until_judged()
    assert list(surprises(members, command.out)) == []
    gradebook = list(rows(command.out))
    assert {row["id"] for row in gradebook} == {member.person for member in members}
    for row in gradebook:
        expected = next(member.expected for member in members if member.person == row["id"])
        for exercise, one in expected.items():
            assert row[f"{exercise} verdict"] == one.verdict.value, row
            if one.verdict is Verdict.PASSED:
                assert float(row[f"{exercise} points"]) >= float(row[f"{exercise} max"]) > 0, row
    assert list(half_written(command.out)) == []
    assert list(command.temporary.iterdir()) == []
    assert not (tmp_path / "climbed.txt").exists()
    drawn = picture(said, command.out.parent)
    assert drawn == shown(), "write docs/grading-a-class.md anew: python -m tests.batch.picture"
