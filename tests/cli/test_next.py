"""`next`: a home when there is none, the right exercise, its files, the lesson once."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"


def test_the_home_is_made_where_told(
    ros2course: Ros2course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert ros2course("--home", str(tmp_path / "a"), "next").code == 0
    assert (tmp_path / "a" / LIGHT).is_file()
    monkeypatch.setenv("ROS2COURSE_HOME", str(tmp_path / "b"))
    assert ros2course("next").code == 0
    assert (tmp_path / "b" / LIGHT).is_file()


def test_progress_of_another_course_is_no_obstacle(ros2course: Ros2course, home: Path) -> None:
    from course.progress import Progress

    ros2course("init")
    with Progress.open(home / ".ros2course") as progress:
        progress.set_current("99-elsewhere")
    assert "== 04-light" in ros2course("next").out


@pytest.mark.parametrize(
    ("exercise", "needed"), [("18-rover", ""), ("18-subscriber", "17-interfaces, 18-publisher")]
)
def test_what_the_starter_supplies_need_not_be_passed(
    ros2course: Ros2course, home: Path, exercise: str, needed: str
) -> None:
    out = " ".join(ros2course("next", exercise, course=Path(__file__).parents[2]).out.split())
    said = out.partition("It builds on ")[2].partition(", which you have not passed yet.")[0]
    assert said == needed


def test_a_review_is_suggested_after_each_fourth_chapter(ros2course: Ros2course, home: Path) -> None:
    own = Path(__file__).parents[2]
    for exercise, suggested in (("04-terminator-quiz", 0), ("05-workspace", 1), ("06-pkg-create-quiz", 0)):
        steps = ros2course("next", exercise, course=own).out.split("Type next:")[1]
        assert steps.count("ros2course review") == suggested, exercise
