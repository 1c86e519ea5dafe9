"""What has to be graded, and when a submission counts as a new one."""

from __future__ import annotations

import os
import shutil
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.batch_plan import BatchPlan, plan_batch, submission_of
from course.batch.gradings import Unit
from course.batch.intake.tree import TreeEntry, read_into
from course.content import Course
from course.errors import CourseError, UsageError
from tests.batch.samples import QUIZ

Plan = Callable[..., BatchPlan]


@pytest.fixture
def planned(lay: Callable[..., Path], quiz_course: Course, tmp_path: Path) -> Plan:
    """The plan for a class of two, one of whom handed in nothing that counts."""
    folder = lay("ada")
    (folder / "bao").mkdir()
    (folder / "bao/poem.txt").write_text("Roses are red.")

    def of(*wanted: str, path: Path = folder, single: bool = False) -> BatchPlan:
        return plan_batch(path, tmp_path / "opened", quiz_course, wanted, single=single)

    return of


def test_all_whose_files_are_found_are_graded(planned: Plan) -> None:
    assert list(planned().units()) == [Unit("ada", QUIZ)]


def test_what_is_asked_for_is_graded_wherever_there_is_anything(planned: Plan) -> None:
    assert list(planned("05-keepers").units()) == [Unit("ada", "05-keepers")]


def test_everybody_has_a_place(planned: Plan) -> None:
    assert [found.person.id for found in planned().found] == ["ada", "bao"]


def test_named_twice_is_graded_once(planned: Plan) -> None:
    assert list(planned(QUIZ, "quiz").units()) == [Unit("ada", QUIZ)]


def test_an_exercise_that_is_not_there_is_refused(planned: Plan) -> None:
    with pytest.raises(CourseError, match="99"):
        planned("99-none")


def test_one_submission_is_no_class(planned: Plan, tmp_path: Path) -> None:
    found = planned(path=tmp_path / "class/ada", single=True)
    assert [unit.person for unit in found.units()] == ["ada"]
    with pytest.raises(UsageError, match="there is no"):
        planned(path=tmp_path / "none", single=True)


def digest_of_ada(planned: Plan) -> str:
    return submission_of(planned().found[0]).digest


def test_the_same_files_are_the_same_submission(planned: Plan, tmp_path: Path) -> None:
    before = digest_of_ada(planned)
    shutil.copytree(tmp_path / "class/ada", tmp_path / "copy")
    shutil.rmtree(tmp_path / "class/ada")
    shutil.move(tmp_path / "copy", tmp_path / "class/ada")
    os.utime(tmp_path / f"class/ada/answers/{QUIZ}.yaml", (time.time() - 5000,) * 2)
    assert digest_of_ada(planned) == before


@pytest.mark.parametrize("change", ["content", "name", "mode", "more"])
def test_other_files_are_another_one(planned: Plan, tmp_path: Path, change: str) -> None:
    before = digest_of_ada(planned)
    file = tmp_path / f"class/ada/answers/{QUIZ}.yaml"
    if change == "content":
        file.write_text(file.read_text().replace("Keeper", "keeper"))
    elif change == "name":
        file.rename(file.with_name("other.yaml"))
    elif change == "mode":
        file.chmod(0o755)
    else:
        (file.parent / "more.yaml").touch()
    assert digest_of_ada(planned) != before


def test_a_large_file_is_not_read_at_once(planned: Plan, tmp_path: Path) -> None:
    """A digest of a class must not need the memory of its largest file."""
    with (tmp_path / "class/ada/answers/large.bin").open("wb") as file:
        file.truncate(30_000_000)
    found = planned().found[0]
    tracemalloc.start()
    submission_of(found)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10_000_000


def test_what_turned_into_a_link_or_a_pipe_is_not_followed(planned: Plan, tmp_path: Path) -> None:
    """We do not wait for it either, and read no more than was seen of it."""
    file = tmp_path / f"class/ada/answers/{QUIZ}.yaml"
    entry = TreeEntry(file, False, 4)
    file.write_text("aaaa and more")
    found: list[bytes] = []
    assert read_into(entry, found.append) and found == [b"aaaa"]
    (tmp_path / "secret").write_text("aaaa")
    file.unlink()
    for make in (lambda: file.symlink_to(tmp_path / "secret"), lambda: os.mkfifo(file), file.mkdir):
        make()
        assert not read_into(entry, found.append) and found == [b"aaaa"]
        file.rmdir() if file.is_dir() else file.unlink()
