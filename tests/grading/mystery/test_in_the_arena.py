"""A scenario that plays its mystery, and sees what its nodes see."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.build import Store
from course.content import Exercise, open_course
from course.grading.check import Request, check_exercise
from course.grading.trial_answers import SEED, lay_answers
from course.model import replace
from course.model.result import Outcome, Verdict
from course.rosenv import find_ros

pytestmark = pytest.mark.slow

FIXTURE = Path(__file__).parents[2] / "fixtures/quiz_course"
SCENARIO = """

@grader.scenario
def greet(arena):
    plan = mystery.plan(arena)
    lamp = arena.ros.subscribe(plan.topic, "std_msgs/msg/Int32")
    mouth = arena.ros.subscribe(plan.mouth, "std_msgs/msg/String")
    arena.play(mystery.file)
    voice = arena.ros.publisher(plan.ears, "std_msgs/msg/String")
    arena.until(lambda: voice.matched, timeout=8)
    voice.publish(data="good evening")
    arena.until(lambda: lamp.count >= 3 and mouth.count, timeout=8)


@grader.check("plays", "the mystery plays")
def plays(recording):
    plan = mystery.plan(recording)
    assert len(recording.messages(plan.topic)) >= 3
    assert len(recording.messages(plan.mouth)) == 1
    mystery.expect_act(recording, "greeted", "not greeted")
"""


@pytest.fixture
def keepers(tmp_path: Path) -> Exercise:
    """The mystery, with a grader that plays it; beside a chapter like the original's."""
    grader = tmp_path / "graders/ch05_lighthouses.py"
    grader.parent.mkdir()
    (tmp_path / "chapters").symlink_to(FIXTURE / "chapters")
    grader.write_text((FIXTURE / "graders/ch05_lighthouses.py").read_text() + SCENARIO)
    return replace(open_course(FIXTURE).exercise("05-keepers"), grader=grader)


@pytest.mark.parametrize("namespaces", [True, False])
def test_it_is_played_and_recorded(keepers: Exercise, tmp_path: Path, namespaces: bool) -> None:
    home = tmp_path / "home"
    home.mkdir()
    lay_answers(keepers, home)
    (home / ".ros2course/acts/05-keepers.json").unlink()
    store = Store(tmp_path / "store")
    request = Request(keepers, home, ros=find_ros(), store=store, seed=SEED, namespaces=namespaces)
    result = check_exercise(request)
    assert [check for check in result.checks if check.outcome is not Outcome.PASSED] == [], result
    assert result.verdict is Verdict.PASSED
