"""Laid-out homes exist as long as they are needed, and what judging again needs is kept."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.batch_plan import plan_batch
from course.batch.gradings import Unit
from course.batch.run import Homes
from course.content import Course, open_course
from course.errors import StorageError
from tests.batch.samples import QUIZ, names


@pytest.fixture
def homes(lay: Callable[..., Path], quiz_course: Course, tmp_path: Path) -> Homes:
    folder = lay("ada", "bao")
    (folder / "ada/ros2_tutorial_workspace/src").mkdir(parents=True)
    planned = plan_batch(folder, tmp_path / "opened", quiz_course, [QUIZ], single=False)
    return Homes(tmp_path / "homes", tmp_path / "kept", planned.found)


def test_a_home_is_there_until_its_last_user_gives_it_back(
    homes: Homes, quiz_course: Course, tmp_path: Path
) -> None:
    exercise, unit = quiz_course.exercise(QUIZ), Unit("ada", QUIZ)
    home = homes.take(unit, exercise)
    assert home == homes.take(unit, exercise)
    assert (home / f"answers/{QUIZ}.yaml").is_file()
    homes.give_back(unit)
    assert home.is_dir()
    homes.give_back(unit)
    assert names(tmp_path / "homes") == set()


def test_what_was_left_by_one_that_was_killed_is_replaced(
    homes: Homes, quiz_course: Course, tmp_path: Path
) -> None:
    (tmp_path / "homes/ada/half").mkdir(parents=True)
    home = homes.take(Unit("ada", QUIZ), quiz_course.exercise(QUIZ))
    assert not (home / "half").exists()


def test_a_home_that_could_not_be_laid_is_laid_the_next_time(
    homes: Homes, quiz_course: Course, tmp_path: Path
) -> None:
    (tmp_path / "homes").touch()
    exercise, unit = quiz_course.exercise(QUIZ), Unit("ada", QUIZ)
    with pytest.raises(StorageError, match="ada"):
        homes.take(unit, exercise)
    (tmp_path / "homes").unlink()
    assert homes.take(unit, exercise).is_dir()


def test_answers_are_kept_for_judging_again(homes: Homes, quiz_course: Course, tmp_path: Path) -> None:
    homes.take(Unit("ada", QUIZ), quiz_course.exercise(QUIZ))
    homes.give_back(Unit("ada", QUIZ))
    assert (tmp_path / f"kept/ada/answers/{QUIZ}.yaml").read_text().startswith("why:")


def test_of_an_exercise_without_questions_nothing_is_kept(
    homes: Homes, quiz_course: Course, tmp_path: Path, small_course: Path
) -> None:
    homes.take(Unit("ada", "04-light"), open_course(small_course).exercise("04-light"))
    assert not (tmp_path / "kept").exists()
