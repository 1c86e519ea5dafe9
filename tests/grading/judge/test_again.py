"""From a judgment to the new result, and whether the recording was sufficient for it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.grading.judge.regraded import lacks, regraded
from course.grading.protocol import Judged, Judgment, ScenarioState, Unjudged, UnjudgedCause
from course.grading.quiz.questions import check_quiz
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Doubt, Outcome, Result, Timing, Verdict

QUIZ = Path(__file__).parents[2] / "fixtures/quiz_course"
PASSED = CheckResult("a", "does a", 2, Outcome.PASSED)
FAILED = CheckResult("b", "does b", 1, Outcome.FAILED, feedback=Feedback("It does no b."))
MEASURED = Timing(1, 2, 3, 4, 5)
BEFORE = Result("04-light", Verdict.NOT_PASSED, (PASSED, FAILED), MEASURED, None, "contained", ("note",))


def result(*checks: CheckResult) -> Result:
    return Result("04-light", Verdict.PASSED, checks)


def rejudged(*checks: CheckResult, scenario: ScenarioState = ScenarioState.SAME) -> Judged:
    return Judged(Judgment(checks), scenario)


def test_what_was_measured_stays(light: Exercise, tmp_path: Path) -> None:
    now = replace(FAILED, outcome=Outcome.PASSED, feedback=None)
    after = regraded(BEFORE, light, Judgment((PASSED, now)), tmp_path, None)
    assert after == replace(BEFORE, verdict=Verdict.PASSED, checks=(PASSED, now))


def test_no_other_attempt_can_follow(light: Exercise, tmp_path: Path) -> None:
    assert regraded(BEFORE, light, Judgment((PASSED, FAILED), None, Doubt.KILLED), tmp_path, None) == BEFORE


def test_a_fault_of_the_grader_is_our_error(light: Exercise, tmp_path: Path) -> None:
    fault = Feedback("It cannot be run.")
    after = regraded(BEFORE, light, Judgment((), fault), tmp_path, None)
    assert (after.verdict, after.fault, after.checks) == (Verdict.OUR_ERROR, fault, ())
    again = regraded(after, light, Judgment((PASSED,)), tmp_path, None)
    assert (again.verdict, again.fault) == (Verdict.PASSED, None)


@pytest.fixture
def quiz(tmp_path: Path) -> Exercise:
    return open_course(shutil.copytree(QUIZ, tmp_path / "course")).exercise("05-quiz")


def answers(folder: Path, text: str) -> Path:
    (folder / "answers").mkdir(parents=True)
    (folder / "answers/05-quiz.yaml").write_text(text)
    return folder


def test_questions_are_judged_from_the_answers(quiz: Exercise, tmp_path: Path) -> None:
    home = answers(tmp_path / "kept", "stranger: 1\n")
    before = replace(check_quiz(quiz, home), timing=Timing(total=3))
    assert any("stranger" in note for note in before.notes)
    judgment = Judgment((PASSED,))
    for given, own in ((None, ()), (judgment, (PASSED,))):
        after = regraded(before, quiz, given, home, None)
        assert after.checks == (*own, *before.checks)
        assert (after.notes, after.timing) == (before.notes, before.timing)
    better = regraded(before, quiz, judgment, QUIZ / "solutions/05-lighthouses", None)
    assert (better.verdict, better.notes) == (Verdict.PASSED, ())


def test_the_evidence_suffices(light: Exercise) -> None:
    for scenario in ScenarioState:
        assert lacks(BEFORE, BEFORE, rejudged(PASSED, FAILED, scenario=scenario)) is None
    other = result(replace(PASSED, outcome=Outcome.FAILED), replace(FAILED, id="c"))
    assert lacks(BEFORE, other, rejudged(*other.checks)) is None


def test_no_recording_does_not_suffice() -> None:
    problem = Unjudged(UnjudgedCause.DAMAGED, "The recording is damaged.")
    assert lacks(BEFORE, BEFORE, problem) == "The recording is damaged."


@pytest.mark.parametrize("scenario", ScenarioState)
def test_an_error_of_a_check_does_not_suffice(scenario: ScenarioState) -> None:
    wrong = CheckResult("c", "does c", 1, Outcome.ERROR, feedback=Feedback("AttributeError: t"))
    said = lacks(BEFORE, result(PASSED, wrong), rejudged(PASSED, wrong, scenario=scenario))
    assert said == '"does c" cannot be judged from this recording: AttributeError: t'


@pytest.mark.parametrize("scenario", [ScenarioState.CHANGED, ScenarioState.UNKNOWN])
@pytest.mark.parametrize(
    ("check", "how"),
    [
        (replace(PASSED, id="c", title="does c"), '"does c" is new'),
        (replace(FAILED, id="c", title="does c"), '"does c" is new'),
        (replace(PASSED, outcome=Outcome.FAILED), '"does a" ended differently before'),
    ],
)
def test_another_scenario_does_not_suffice_for_what_is_judged_otherwise(
    scenario: ScenarioState, check: CheckResult, how: str
) -> None:
    said = lacks(BEFORE, result(check, FAILED), rejudged(check, FAILED, scenario=scenario))
    assert said is not None
    assert how in said


def test_new_questions_need_no_recording() -> None:
    question = replace(PASSED, id="question")
    after = result(PASSED, FAILED, question)
    assert lacks(BEFORE, after, rejudged(PASSED, FAILED, scenario=ScenarioState.CHANGED)) is None


def test_no_evidence_helps_a_grader_that_cannot_be_run() -> None:
    broken = Judged(Judgment((), Feedback("It cannot be run.")), ScenarioState.CHANGED)
    assert lacks(BEFORE, result(), broken) is None
