"""When a program runs once more to find a cause, and that this changes only advice."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path
from unittest.mock import MagicMock

import pytest

from course.content import Exercise, open_course
from course.errors import CourseError, OurFault, StorageError
from course.evidence.mcap_file import load
from course.evidence.packages import BuiltPackages
from course.explain.cpp_crashes import NO_LINE
from course.explain.observed import UNKNOWN
from course.grading import check, trial
from course.grading.check import Helpers, Request, attempt_exercise
from course.grading.judge.judges import Judge
from course.grading.protocol import Judgment, RecordingOutcome, RecordingTask
from course.home import create_home
from course.model import replace
from course.model.events import Observed, OutputLine
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict
from course.rosenv import find_ros

pytestmark = pytest.mark.slow
SCRIPT = "ros2_tutorials_preamble/python/minimalist_package/minimalist_package/minimalist_script.py"
HIDES = """\
import time

def say(count):
    print("Howdy!" + count)

def main():
    try:
        while True:
            time.sleep(0.5)
            say(1)
    except Exception as e:
        pass

if __name__ == "__main__":
    main()
"""
# As in a submission that wants another verdict, or wants others to be blamed.
FORGES = """\
import json, os
from pathlib import Path
folder = Path.home() / ".ros2course-notes"
folder.mkdir(exist_ok=True)
note = {"kind": "Observed", "t": -5.0, "what": "caught", "error": "\\x1b[2JPASSED " * 10000,
        "raised": {"file": "/root/.ssh/id_rsa", "line": 1}, "by": {"file": "/etc/passwd", "line": 3}}
own = {**note, "raised": None, "by": {"file": __file__, "line": LINE}}
other = {"kind": "ProcessExited", "t": 0.0, "process": "script", "code": 0, "signal": None}
text = "\\n".join(json.dumps(one) for one in NOTES)
(folder / "1").write_text(text + "\\nno json\\n[[[[\\n" + "x" * 1_000_000)
os.path.lexists(folder / "2") or os.symlink("/etc/passwd", folder / "2")
os.path.lexists(folder / "3") or os.mkfifo(folder / "3")
"""


@pytest.fixture(scope="module")
def exercise() -> Exercise:
    return open_course().exercise("02-script")


Grade = Callable[..., Result]


@pytest.fixture
def so_far() -> list[Result]:
    """The results that were reported before a second run."""
    return []


@pytest.fixture
def grade(exercise: Exercise, tmp_path: Path, so_far: list[Result]) -> Iterator[Grade]:
    """The exercise with this script; its recording is in `evidence.mcap`."""
    home = create_home(tmp_path / "home").path
    trial.lay_solution(open_course(), exercise, home)
    with contextlib.closing(Helpers()) as helpers:

        def graded(text: str | None, **options: object) -> Result:
            if text is not None:
                (home / SCRIPT).write_text(text)
            evidence = tmp_path / "evidence.mcap"
            told = {"so_far": so_far.append, "looks_for_cause": lambda result: True, **options}
            request = Request(exercise, home, find_ros(), evidence=evidence, **told)  # type: ignore[arg-type]
            return attempt_exercise(request, helpers)

        yield graded


def the(result: Result, name: str) -> CheckResult:
    return next(check for check in result.checks if check.id == name)


def advice(result: Result, name: str = "starts") -> str:
    feedback = the(result, name).feedback
    assert feedback is not None
    return feedback.advice or ""


def outcomes(result: Result) -> list[tuple[str, Outcome]]:
    return [(check.id, check.outcome) for check in result.checks]


def test_a_hidden_error_is_found(
    grade: Grade, exercise: Exercise, tmp_path: Path, so_far: list[Result]
) -> None:
    result = grade(HIDES)
    assert result.verdict is Verdict.NOT_PASSED
    assert advice(result).startswith("Your `except` on line 11 hides this error: `TypeError: can only")
    assert "raised on line 4" in advice(result)
    assert advice(so_far[0]).startswith(UNKNOWN) and len(so_far) == 1
    assert outcomes(so_far[0]) == outcomes(result)
    kept = load(tmp_path / "evidence.mcap")
    assert any(isinstance(event, Observed) for event in kept.events)
    with contextlib.closing(Judge()) as judge:
        again = judge.judge(exercise, tmp_path / "evidence.mcap")
    assert again.checks == result.checks


@pytest.mark.parametrize("text", [None, "print('Howdy!')\n1 / 0\n"], ids=["passed", "proven"])
def test_nothing_is_to_be_found(grade: Grade, tmp_path: Path, so_far: list[Result], text: str | None) -> None:
    result = grade(text)
    assert so_far == [] and UNKNOWN not in str(result)
    assert not any(isinstance(event, Observed) for event in load(tmp_path / "evidence.mcap").events)


def test_nobody_wants_to_know(grade: Grade, so_far: list[Result]) -> None:
    result = grade(HIDES, looks_for_cause=lambda result: False)
    assert so_far == [] and advice(result).startswith(UNKNOWN)


@pytest.mark.parametrize("notes", ["[note] * 100 + [other]", "[own] * 100"], ids=["others", "own"])
def test_forged_notes(grade: Grade, tmp_path: Path, notes: str) -> None:
    """The verdict stays, nobody else's files are named, and quotes are short."""
    forged = FORGES.replace("NOTES", notes)
    text = f"{forged}\ntry:\n    pass\nexcept Exception:\n    pass\n"
    line = text.splitlines().index("except Exception:") + 1
    result = grade(text.replace("LINE", str(line)))
    assert outcomes(result) == outcomes(grade("pass\n"))
    told = str([check.feedback for check in result.checks])
    assert "passwd" not in told and "id_rsa" not in told
    assert advice(result).isprintable() and len(advice(result)) < 400
    events = [event for event in load(tmp_path / "evidence.mcap").events if isinstance(event, Observed)]
    assert len(events) < 600


def test_the_line_in_which_cpp_crashes(tmp_path: Path) -> None:
    """The package is compiled again, with a sanitizer, and only that run is one of it."""
    home = create_home(tmp_path / "home").path
    trial.lay_solution(open_course(), open_course().exercise("26-cpp-node"), home)
    main = next(home.rglob("print_forever_node_main.cpp"))
    main.write_text(main.read_text().replace("  rclcpp::spin(", "  std::stoi(argv[0]);\n  rclcpp::spin("))
    so_far: list[Result] = []
    told = {"so_far": so_far.append, "evidence": tmp_path / "evidence.mcap"}
    request = Request(open_course().exercise("26-cpp-node"), home, find_ros(), **told)  # type: ignore[arg-type]
    with contextlib.closing(Helpers()) as helpers:
        result = attempt_exercise(request, helpers)
    line = main.read_text().splitlines().index("  std::stoi(argv[0]);") + 1
    assert advice(result).startswith(f"It happens on line {line} of `{main.name}`. The string does not start")
    feedback = the(result, "starts").feedback
    assert feedback and [(place.file, place.line) for place in feedback.where] == [
        (str(main.relative_to(home)), line)
    ]
    assert advice(so_far[0]).startswith(NO_LINE) and outcomes(so_far[0]) == outcomes(result)
    printed = [
        event.text for event in load(tmp_path / "evidence.mcap").events if isinstance(event, OutputLine)
    ]
    assert any("terminate called" in text for text in printed)
    assert not any("Sanitizer" in text for text in printed)


UNPROVEN = CheckResult(
    "starts", "It starts", 1, Outcome.FAILED, feedback=Feedback("It did not.", advice=UNKNOWN)
)
SO_FAR = Result("02-script", Verdict.NOT_PASSED, (UNPROVEN,), Timing(1.0, 1.0, 2.0))
FOUND = replace(UNPROVEN, feedback=Feedback("It did not.", advice="Line 3 hides it."))


@pytest.fixture
def second_run(exercise: Exercise, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """A second run that is judged so, or that cannot start; what is kept is a file `kept`."""

    def run(judged: Judgment | CourseError) -> Result:
        supervisor = MagicMock()
        entered = supervisor.return_value.__enter__
        entered.side_effect = judged if isinstance(judged, CourseError) else None
        entered.return_value.record.return_value = RecordingOutcome()
        entered.return_value.recording.fileno.return_value = 0
        monkeypatch.setattr(check, "Supervisor", supervisor)
        monkeypatch.setattr(check, "keep_recording", lambda recording, file: file.touch())
        helpers = MagicMock()
        helpers.judge.judge.return_value = judged
        task = RecordingTask(exercise.id, "", "", (), BuiltPackages(), {}, "")
        request = Request(exercise, tmp_path, evidence=tmp_path / "kept")
        return check._with_causes(SO_FAR, lambda: task, MagicMock(), helpers, request, MagicMock())

    return run


def test_the_recording_with_notes_is_kept_once_it_was_judged(
    second_run: Callable[..., Result], tmp_path: Path
) -> None:
    assert second_run(Judgment((FOUND,))).checks == (FOUND,)
    assert (tmp_path / "kept").exists()


def test_a_recording_that_cannot_be_judged_replaces_none(
    second_run: Callable[..., Result], tmp_path: Path
) -> None:
    assert second_run(Judgment((), Feedback("The recording is damaged."))) == SO_FAR
    assert not (tmp_path / "kept").exists()


@pytest.mark.parametrize("error", [StorageError("No temporary file can be made."), OurFault("It broke.")])
def test_a_second_run_that_cannot_start_costs_no_verdict(
    second_run: Callable[..., Result], error: CourseError
) -> None:
    assert second_run(error) == SO_FAR
