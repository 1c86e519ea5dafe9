"""`check`: its output, what it stores, how it ends."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.errors import MissingHere, StorageError
from course.model.result import Result, from_json
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
    assert checker.requests[-1].namespaces is True
    assert checker.requests[-1].evidence == home / ".ros2course/evidence/04-light.mcap"
    ros2course("check", "--no-namespaces")
    assert checker.requests[-1].namespaces is False


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


@pytest.mark.parametrize("quiet", [(), ("--json",)])
def test_ctrl_c_costs_no_verdict_that_is_certain(
    ros2course: Ros2course, checker: Checker, home: Path, quiet: tuple[str, ...]
) -> None:
    """For example, during the search for the cause of a failure."""
    checker.answer, checker.so_far = KeyboardInterrupt(), results()["failed"]
    run = ros2course("check", *quiet)
    assert run.code == 130
    assert "Stopped. The result so far counts." in run.err
    assert "does not count" not in run.err
    with Progress.open(home / ".ros2course") as progress:
        assert progress.attempts("04-light") == 1
        assert progress.last_result("04-light") == checker.so_far


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
    assert "An error in the course, not yours: RuntimeError: boom" in run.err
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
