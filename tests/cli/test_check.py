"""`check`: what is said, what is stored, how it ends."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.errors import MissingHere, StorageError
from course.grading.result import Result, from_json
from course.progress import Progress

if TYPE_CHECKING:
    from tests.cli.conftest import Checker, Ros2course


@pytest.fixture(autouse=True)
def begun(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")


def results() -> dict[str, Result]:
    from tests.cli import conftest

    return {
        "passed": conftest.PASSED,
        "failed": conftest.FAILED,
        "ours": conftest.OURS,
        "missing": conftest.MISSING,
    }


@pytest.mark.parametrize(("kind", "code"), [("passed", 0), ("failed", 1), ("ours", 3), ("missing", 4)])
def test_the_exit_code_tells_the_verdict(
    ros2course: Ros2course, checker: Checker, kind: str, code: int
) -> None:
    checker.answer = results()[kind]
    assert ros2course("check").code == code
    assert ros2course("check", "--json").code == code


def test_it_checks_the_current_exercise_in_the_home(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    ros2course("check")
    ros2course("check", "dim")
    assert checker.calls == [("04-light", home), ("04-dim", home)]


def test_the_recording_is_kept_and_namespaces_are_optional(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    ros2course("check")
    assert checker.options["namespaces"] is True
    assert checker.options["evidence"] == home / ".ros2course/evidence/04-light.mcap"
    ros2course("check", "--no-namespaces")
    assert checker.options["namespaces"] is False


def test_a_failure_is_explained_and_says_what_to_type(ros2course: Ros2course, checker: Checker) -> None:
    checker.answer = results()["failed"]
    run = ros2course("check")
    assert "  no  It shines" in run.out
    assert "      It is dark." in run.out
    assert "      try       Light it." in run.out
    assert "  ros2course hint" in run.out.split("Type next:")[1]


def test_a_pass_is_followed_by_the_lesson_s_word_and_next(ros2course: Ros2course, checker: Checker) -> None:
    run = ros2course("check")
    assert "Passed: 2 of 2 points." in run.out
    assert "It shines." in run.out
    assert "  ros2course next" in run.out.split("Type next:")[1]


def test_after_the_last_hint_it_offers_them_all_again(ros2course: Ros2course, checker: Checker) -> None:
    ros2course("hint", "--all")
    checker.answer = results()["failed"]
    assert "ros2course hint --all" in ros2course("check").out


def test_progress_lines_go_to_standard_error(ros2course: Ros2course, checker: Checker) -> None:
    checker.says = ("building lanterns", "building lanterns", "watching")
    run = ros2course("check")
    assert run.err.splitlines() == ["checking 04-light", "building lanterns", "watching"]
    assert "building" not in run.out


def test_json_is_the_result_alone(ros2course: Ros2course, checker: Checker) -> None:
    checker.answer = results()["failed"]
    checker.says = ("building lanterns",)
    run = ros2course("check", "--json")
    assert from_json(run.out) == checker.answer
    assert json.loads(run.out)["points"] == 0
    assert run.err == ""


def test_attempts_are_stored_and_ours_do_not_count(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    for kind in ("failed", "ours", "missing", "passed"):
        checker.answer = results()[kind]
        ros2course("check")
    with Progress.open(home / ".ros2course") as progress:
        assert progress.attempts("04-light") == 2
        assert progress.state("04-light") == "passed"


def test_the_last_time_is_compared_with(ros2course: Ros2course, checker: Checker) -> None:
    ros2course("check")
    checker.answer = results()["failed"]
    run = ros2course("check")
    assert "This check passed the last time." in run.out
    assert "(last time 2)" in run.out


def test_our_error_does_not_count_and_names_its_log(ros2course: Ros2course, checker: Checker) -> None:
    checker.answer = results()["ours"]
    run = ros2course("check")
    assert "The grader fell over." in run.out
    assert "the attempt does not count" in run.out
    log = Path(run.out.split("The details are in ")[1].splitlines()[0])
    assert from_json(log.read_text()) == checker.answer


def test_ctrl_c_ends_with_130_and_counts_for_nothing(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    checker.answer = KeyboardInterrupt()
    run = ros2course("check")
    assert run.code == 130
    assert "Stopped. This attempt does not count." in run.err
    with Progress.open(home / ".ros2course") as progress:
        assert progress.attempts("04-light") == 0


def test_what_this_machine_lacks_is_said(ros2course: Ros2course, checker: Checker) -> None:
    checker.answer = MissingHere("There is no ROS 2 here.", "`ros2course doctor` says more.")
    run = ros2course("check")
    assert run.code == 4
    assert "Error: There is no ROS 2 here." in run.err
    assert "Next: `ros2course doctor` says more." in run.err


def test_a_crash_of_the_engine_is_ours(ros2course: Ros2course, checker: Checker) -> None:
    checker.answer = RuntimeError("\x1b[31mboom")
    run = ros2course("check")
    assert run.code == 3
    assert "A fault of the course, not yours: RuntimeError: boom" in run.err
    log = Path(run.err.split("The details are in ")[1].splitlines()[0])
    assert "Traceback" in log.read_text() and "check" in log.read_text()
    assert "Traceback" not in run.err


def test_a_full_disk_costs_no_verdict(
    ros2course: Ros2course, checker: Checker, monkeypatch: pytest.MonkeyPatch
) -> None:
    def record(self: Progress, result: Result) -> None:
        raise StorageError("your progress cannot be saved", "free some space")

    monkeypatch.setattr(Progress, "record", record)
    run = ros2course("check")
    assert run.code == 4
    assert "Passed: 2 of 2 points." in run.out
    assert "Error: Your progress cannot be saved" in run.err


def test_checking_a_passed_one_again_does_not_move_the_learner(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    ros2course("check")
    ros2course("next")
    checker.answer = results()["failed"]
    run = ros2course("check", "light")
    assert "ros2course hint 04-light" in run.out
    with Progress.open(home / ".ros2course") as progress:
        assert progress.current() == "04-dim"
