"""A kept recording is judged again with the same outcome, and known to be from the same scenario."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.judge.judges import StoredRecording
from course.grading.judge.regraded import lacks, moves, regraded
from course.grading.protocol import Judged, ScenarioState
from course.home import create_home
from course.model.result import Verdict
from course.rosenv import find_ros

from .conftest import judged

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("mistake", "verdict"), [(False, Verdict.PASSED), (True, Verdict.NOT_PASSED)])
def test_judged_again(tmp_path: Path, mistake: bool, verdict: Verdict) -> None:
    course = open_course()
    exercise = course.exercise("02-script")
    home = create_home(tmp_path / "home").path
    trial.lay_solution(course, exercise, home)
    if mistake:
        trial.apply_mistake(exercise, exercise.mistakes()[0], home)
    evidence = tmp_path / "evidence/02-script.mcap"
    before = check_exercise(Request(exercise, home, ros=find_ros(), evidence=evidence))
    assert before.verdict is verdict
    answer = judged(StoredRecording("one", exercise, evidence))["one"]
    assert isinstance(answer, Judged)
    assert answer.scenario is ScenarioState.SAME
    after = regraded(before, exercise, answer.judgment, home, None)
    assert after == before
    assert moves(before, after) == ()
    assert lacks(before, after, answer) is None
