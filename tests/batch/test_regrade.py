"""A class is judged again after its course has changed: what changes, why, and what stays."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.gradings import Graded
from course.batch.regrade import Regraded, regrade
from course.batch.results import Results, settings_of
from course.cli.main import main
from course.content import Course, open_course
from course.errors import OurFault, UsageError
from course.grading import trial
from course.model import replace
from tests.batch.samples import QUIZ
from tests.conftest import FIXTURES

pytestmark = pytest.mark.slow

SCRIPT = "02-script"
HOWDY = '@script.check("howdy", "it prints `Howdy!`", needs="starts")'
NEW_CHECK = """

@script.check("greeting", "it begins with a greeting")
def begins_with_a_greeting(recording):
    assert recording.process("script").lines[0].startswith("Howdy")
"""


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with `course`, `class` (one right, one wrong) and `grades`, as graded by the real command."""
    place = tmp_path_factory.mktemp("regrade")
    root = open_course().root
    for part in ("chapters", "graders", "solutions"):
        shutil.copytree(root / part, place / "course" / part, ignore=shutil.ignore_patterns("__pycache__"))
    course = open_course(place / "course")
    exercise = course.exercise(SCRIPT)
    mistake = next(one for one in exercise.mistakes() if one.id == "once-per-second")
    for person in ("ada", "bao"):
        (place / "class" / person).mkdir(parents=True)
    trial.lay_solution(course, exercise, place / "class/ada")
    trial.lay_mistake(course, exercise, mistake, place / "class/bao")
    words = ["grade", str(place / "class"), "--exercises", SCRIPT, "--out", str(place / "grades")]
    assert main(["--course", str(place / "course"), *words]) == 0
    return place


@pytest.fixture
def place(graded: Path, tmp_path: Path) -> Path:
    return shutil.copytree(graded, tmp_path / "place", ignore=shutil.ignore_patterns("__pycache__"))


def change(place: Path, old: str, new: str) -> None:
    file = place / "course/graders/ch02_python_basics.py"
    text = file.read_text()
    assert text.count(old) == 1
    file.write_text(text.replace(old, new))


def judged_again(place: Path) -> Regraded:
    with Results.open(place / "grades") as results:
        return regrade(place / "grades", results, open_course(place / "course"), lambda *_: None, jobs=1)


def points(place: Path) -> dict[str, float]:
    with Results.open(place / "grades") as results:
        people = [one.person for one in results.submissions()]
        return {person: results.gradings(person)[0].result.points for person in people}


def test_nothing_moves_when_nothing_was_changed(place: Path) -> None:
    before = points(place)
    found = judged_again(place)
    assert (found.judged, found.moved, found.lacking) == (2, (), ())
    assert points(place) == before
    assert before["ada"] > before["bao"]


def test_changed_points_move_marks_with_a_reason(place: Path) -> None:
    before = points(place)
    change(place, HOWDY, HOWDY.replace('needs="starts"', 'points=3, needs="starts"'))
    found = judged_again(place)
    assert [(one.person, one.after - one.before) for one in found.moved] == [("ada", 2.0), ("bao", 2.0)]
    assert [move.why for move in found.moved[0].moves] == ["worth 3, was 1"]
    assert points(place) == {person: earned + 2 for person, earned in before.items()}


def test_the_command_shows_it_and_writes_the_reports_anew(
    place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(place, HOWDY, HOWDY.replace('needs="starts"', 'points=3, needs="starts"'))
    earlier = (place / "grades/results.csv").read_text()
    assert main(["--course", str(place / "course"), "regrade", str(place / "grades")]) == 0
    shown = capsys.readouterr().out
    assert "it prints `Howdy!`: worth 3, was 1" in shown
    assert "2 gradings were judged again; 2 of them changed." in shown
    assert (place / "grades/results.csv").read_text() != earlier


def test_a_dry_run_shows_it_and_changes_nothing(place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(place, HOWDY, HOWDY.replace('needs="starts"', 'points=3, needs="starts"'))
    before, earlier = points(place), (place / "grades/results.csv").read_text()
    words = ["--course", str(place / "course"), "regrade", str(place / "grades"), "--dry-run"]
    assert main(words) == 0
    shown = capsys.readouterr().out
    assert "it prints `Howdy!`: worth 3, was 1" in shown and "Nothing was changed." in shown
    assert (points(place), (place / "grades/results.csv").read_text()) == (before, earlier)
    assert main([*words, "--rerun"]) == 2


def test_a_check_that_needs_more_than_was_recorded_leaves_the_marks(place: Path) -> None:
    before = points(place)
    broken = "def begins(recording):\n    raise KeyError('not recorded')\n"
    added = NEW_CHECK.split("def ")[0] + broken
    change(place, HOWDY, f"{added.strip()}\n\n\n{HOWDY}")
    found = judged_again(place)
    assert [one.person for one in found.lacking] == ["ada", "bao"]
    assert "cannot be judged from this recording" in found.lacking[0].why
    assert points(place) == before


def test_rerun_grades_those_anew(place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.rmtree(place / "grades/evidence/bao")
    (place / "grades/evidence/ada" / f"{SCRIPT}.mcap").write_bytes(b"damaged")
    words = ["--course", str(place / "course"), "regrade", str(place / "grades")]
    assert main(words) == 0
    assert "2 stay as they were" in capsys.readouterr().out
    before = points(place)
    assert main([*words, "--rerun"]) == 0
    assert points(place) == before
    assert judged_again(place).lacking == ()


def test_a_failure_in_the_middle_moves_nothing(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = points(place)
    change(place, HOWDY, HOWDY.replace('needs="starts"', 'points=3, needs="starts"'))
    record = Results.record
    calls: list[object] = []

    def fails_at_the_second(self: Results, *given: object) -> None:
        calls.append(given)
        if len(calls) == 2:
            raise RuntimeError("killed")
        record(self, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(Results, "record", fails_at_the_second)
    with pytest.raises(RuntimeError):
        judged_again(place)
    assert points(place) == before


def test_a_broken_grader_moves_nothing(place: Path) -> None:
    before = points(place)
    change(place, HOWDY, f"1 / 0\n\n\n{HOWDY}")
    with pytest.raises(OurFault, match="02-script cannot be judged"):
        judged_again(place)
    assert points(place) == before


def test_what_a_busy_machine_recorded_is_not_held_against_anybody(place: Path) -> None:
    with Results.open(place / "grades") as results:
        (stored,) = results.gradings("bao")
        lagging = replace(stored.result, timing=replace(stored.result.timing, lag=1.5, cpu=0.0))
        results.record(Graded(stored.unit, lagging, 1.0), "0", stored.evidence)
    assert [(one.person, one.why) for one in judged_again(place).lacking] == [
        ("bao", "The machine was too busy when it was recorded.")
    ]


def test_an_exercise_that_is_gone_is_named(place: Path) -> None:
    with (
        pytest.raises(UsageError, match="no longer has an exercise 02-script"),
        Results.open(place / "grades") as results,
    ):
        regrade(place / "grades", results, open_course(FIXTURES / "quiz_course"), lambda *_: None, jobs=1)


def test_what_was_asked_for_is_kept(place: Path) -> None:
    with Results.open(place / "grades") as results:
        asked = settings_of(results)
    assert (asked.wanted, asked.exercises) == ((SCRIPT,), (SCRIPT,))
    assert (asked.single, asked.contained) == (False, True)


def test_answers_are_judged_by_the_questions_of_now(
    lay: Callable[..., Path], quiz_course: Course, tmp_path: Path
) -> None:
    out, root = tmp_path / "grades", str(FIXTURES / "quiz_course")
    words = ["--course", root, "grade", str(lay("ada")), "--exercises", QUIZ, "--out", str(out)]
    assert main(words) == 0
    answers = next((out / "answers/ada/answers").glob("*.yaml"))
    answers.write_text("{}\n")
    with Results.open(out) as results:
        found = regrade(out, results, quiz_course, lambda *_: None, jobs=1)
    assert [one.after for one in found.moved] == [0.0]


def test_a_folder_without_results(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["regrade", str(tmp_path)]) == 2
    assert "Name the folder given to --out" in capsys.readouterr().err
