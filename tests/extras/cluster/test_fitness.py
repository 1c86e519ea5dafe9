"""A machine that would grade differently is reported, with what to do about it."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import MissingHere, UsageError
from course.model import replace
from course_cluster import fitness
from course_cluster.fitness import Unfit, Wanted


@pytest.fixture
def asked(small_course: Path, monkeypatch: pytest.MonkeyPatch) -> Wanted:
    """What a machine just like this one requires."""
    monkeypatch.setattr(fitness, "find_ros", lambda: None)
    monkeypatch.setattr(fitness, "obstacle_to", lambda level: None)
    return fitness.wanted(small_course, contained=True)


def looked(asked: Wanted, engine: str | None = None) -> Unfit | None:
    return fitness.unfit(asked, engine or asked.engine)


def test_the_same_is_fit(asked: Wanted) -> None:
    assert looked(asked) is None


def test_another_version(asked: Wanted) -> None:
    problem = looked(replace(asked, version="9.9"))
    assert problem and "9.9" in problem.why and "Install ros2course 9.9" in problem.advice


def test_another_engine_of_the_same_version(asked: Wanted) -> None:
    problem = looked(asked, engine="other")
    assert problem and "ros2course" in problem.why and "same commit" in problem.advice


@pytest.mark.parametrize("part", ["chapters", "graders", "solutions"])
def test_other_lessons(asked: Wanted, small_course: Path, part: str) -> None:
    next(path for path in sorted((small_course / part).rglob("*.*")) if path.is_file()).write_text("other")
    problem = looked(asked)
    assert problem and "course" in problem.why


def test_what_tools_leave_behind_makes_no_difference(asked: Wanted, small_course: Path) -> None:
    left = small_course / "graders" / "__pycache__"
    left.mkdir(exist_ok=True)
    (left / "grader.cpython-310.pyc").write_bytes(b"0")
    (small_course / "graders" / ".DS_Store").write_bytes(b"0")
    assert looked(asked) is None


def test_no_such_course_there(asked: Wanted, tmp_path: Path) -> None:
    problem = looked(replace(asked, course=str(tmp_path / "nowhere")))
    assert problem and "nowhere" in problem.why and "--course" in problem.advice


def test_no_ros(asked: Wanted, monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> None:
        raise MissingHere("ROS 2 was not found.", "Install it.")

    monkeypatch.setattr(fitness, "find_ros", none)
    assert looked(asked) == Unfit("has no ROS to grade with: ROS 2 was not found.", "Install it.")


def test_no_containment(asked: Wanted, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fitness, "obstacle_to", lambda level: "bubblewrap is not installed")
    problem = looked(asked)
    assert problem and "bubblewrap is not installed" in problem.why and "doctor" in problem.advice
    assert looked(replace(asked, contained=False)) is None


def test_who_asks_has_a_course(tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        fitness.wanted(tmp_path, contained=True)
