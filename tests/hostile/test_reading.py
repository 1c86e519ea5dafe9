"""What programs must not see: solutions, graders, answers, other people's files, and the grader itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from course.model.result import Verdict
from tests.hostile.secrets import secrets
from tests.hostile.world import NODE, SECRET, Grade, walking, with_attack

pytestmark = pytest.mark.slow
FURTHER = {"environments", "command_lines", "descriptors", "passwords", "secrets_in_environment", "search"}


def test_an_honest_program_passes(grade: Grade) -> None:
    """Otherwise the others prove little: whatever stops attacks must let right programs through."""
    graded = grade({}, guarantee="an honest program is graded as ever")
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_no_text_of_any_course_is_anywhere(grade: Grade, course_copy: Path) -> None:
    """Neither while its packages are built nor while it runs, and even of a course in a separate folder."""
    graded = grade(walking(secrets(course_copy)), guarantee="no file of a course can be read")
    assert graded.result.verdict is Verdict.PASSED, graded.all_words or graded.result
    assert "walk" in graded.held


def test_nothing_but_its_own_files_is_there(
    grade: Grade, course_copy: Path, store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The permissions of all canaries allow everyone to read them."""
    monkeypatch.setenv("INSTRUCTOR_SECRET", SECRET)
    own = open_course().root
    places = [
        *(course_copy / part for part in ("solutions", "graders", "chapters")),
        *(course_copy / part / f"{SECRET}.txt" for part in ("solutions", "graders", "chapters")),
        *(own / part for part in ("graders/ch18_publishers_and_subscribers.py", "README.md", ".git/HEAD")),
        store / f"{SECRET}.txt",
        tmp_path / "evidence-1" / "evidence.mcap",
        Path("/etc/shadow"),
        Path("/etc/hostname"),
        Path("/etc/machine-id"),
        Path("/root/.bashrc"),
        Path("/proc/1/root/etc/shadow"),
        Path("/proc/kcore"),
        Path("/proc/kmsg"),
        Path("/dev/kmsg"),
        Path("/dev/mem"),
        Path("/dev/vda"),
        Path("/sys/fs/cgroup/memory/memory.limit_in_bytes"),
        Path("/sys/fs/cgroup/cgroup.controllers"),
        Path("/run/docker.sock"),
    ]
    text = with_attack("reads", PLACES=[str(place) for place in places], SECRET=SECRET)
    graded = grade({NODE: text}, guarantee="programs see nothing but what they need")
    assert not graded.breaches
    assert graded.held == FURTHER | {"own descriptors"} | {f"place {n}" for n in range(len(places))}
    assert graded.result.verdict is Verdict.PASSED, graded.result


@pytest.mark.parametrize("where", ["home", "results"])
def test_what_lies_beside_the_submission_is_out_of_reach(grade: Grade, open_place: Path, where: str) -> None:
    """Its home is beside other submissions' homes, but only what the exercise needs is copied."""
    text = with_attack("reads", PLACES=[str(open_place), str(open_place / where)], SECRET=SECRET)
    graded = grade({NODE: text}, guarantee="programs do not see other submissions")
    assert not graded.breaches
    assert {"place 0", "place 1", "search"} <= graded.held
