"""A folder in which submissions arrive: complete ones are graded, unfinished ones wait."""

from __future__ import annotations

import contextlib
import csv
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.batch import arrivals as module
from course.batch.arrivals import Arrivals
from course.batch.batch_plan import digest, plan_batch, remarks_on
from course.batch.intake.tree import RESULTS, RESULTS_LEFT_OUT
from course.batch.results import Results, Submission
from course.cli.main import main
from course.content import Course
from course.errors import UsageError
from tests.batch.conftest import Lay
from tests.batch.samples import QUIZ

SECOND = 10**9


class Clock:
    """Time passes only while somebody waits. Waiting longer than `late` raises TimeoutError."""

    def __init__(self) -> None:
        self.now = 0.0
        self.late = 60.0

    def wait(self, _event: threading.Event, seconds: float) -> None:
        self.now += seconds
        if self.now > self.late:
            raise TimeoutError


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(module, "monotonic", lambda: clock.now)
    monkeypatch.setattr(threading.Event, "wait", lambda event, seconds: clock.wait(event, seconds))
    return clock


def test_what_is_there_is_told_once(lay: Lay, clock: Clock) -> None:
    arrivals = Arrivals(lay("ada", "bao"))
    arrivals.wait()
    assert arrivals.fresh == set(arrivals.complete) == {"ada", "bao"}
    assert clock.now >= module.QUIET
    with pytest.raises(TimeoutError):
        arrivals.wait()


def test_what_comes_later_and_what_changes_and_what_goes(lay: Lay, clock: Clock) -> None:
    folder = lay("ada", "bao")
    arrivals = Arrivals(folder)
    arrivals.wait()
    lay("cem")
    next((folder / "bao").rglob("*.yaml")).write_text("{}")
    arrivals.wait()
    assert arrivals.fresh == {"bao", "cem"}
    (folder / "ada").rename(folder.parent / "ada")
    arrivals.wait()
    assert (set(arrivals.complete), arrivals.fresh) == ({"bao", "cem"}, set())


@pytest.mark.parametrize("ahead", [-3600, 0, 3600])
def test_what_is_being_written_is_left_until_it_is_quiet(
    lay: Lay, clock: Clock, monkeypatch: pytest.MonkeyPatch, ahead: int
) -> None:
    """Even if a network drive's clock is ahead of ours, or behind."""
    real = module._state

    def elsewhere(path: str) -> Iterator[tuple[str, int, int]]:
        yield from ((name, changed + ahead * SECOND, size) for name, changed, size in real(path))

    monkeypatch.setattr(module, "_state", elsewhere)
    folder = lay("ada", "bao")
    arrivals = Arrivals(folder)
    arrivals.wait()
    written = next((folder / "ada").rglob("*.yaml"))
    text, tick = "a", clock.wait

    def grows(event: threading.Event, seconds: float) -> None:
        nonlocal text
        text += "a"
        if clock.now < 30:
            written.write_text(text)
        tick(event, seconds)

    clock.wait = grows  # type: ignore[method-assign]
    written.write_text(text)
    arrivals.wait()
    assert arrivals.fresh == {"ada"} and clock.now >= 30 + module.QUIET - 1


def test_what_is_to_be_told_again_is_quiet_once_more_before(lay: Lay, clock: Clock) -> None:
    arrivals = Arrivals(lay("ada"))
    arrivals.wait()
    before = clock.now
    arrivals.forget_fresh()
    arrivals.wait()
    assert arrivals.fresh == {"ada"} and clock.now >= before + module.QUIET


def test_results_are_nobody_s_wherever_they_are(
    lay: Lay, clock: Clock, quiz_course: Course, tmp_path: Path
) -> None:
    folder = lay("ada", "dev")
    (folder / "dev/src").mkdir()
    kept = [folder / name for name in ("grades", "results/week3", "results/old/week2", "ada/x/week1")]
    for out in (*kept, folder / "dev"):
        with Results.open(out):
            pass
    arrivals = Arrivals(folder)
    arrivals.wait()
    assert set(arrivals.complete) == {"ada", "dev"}
    for out in kept:
        (out / "results.csv").write_text("id\n")
    with pytest.raises(TimeoutError):  # files that `grade` writes are not new submissions
        arrivals.wait()
    planned = plan_batch(folder, tmp_path / "o", quiz_course, [QUIZ], single=False)
    assert [found.person.id for found in planned.found] == ["ada", "dev"]
    assert [(told.what, told.where) for told in planned.findings] == [(RESULTS_LEFT_OUT, "grades, results")]
    assert remarks_on(planned.found[0]) == (f"{RESULTS_LEFT_OUT} (x/week1)",)
    before = digest(planned.found[0])
    (folder / "ada/x/week1/more.csv").write_text("id\n")
    assert digest(planned.found[0]) == before


def test_who_handed_in_what_looks_like_results_is_told(lay: Lay, quiz_course: Course, tmp_path: Path) -> None:
    folder = lay("ada")
    for name in ("Bo Ray_22_assignsubmission_file_", "eve", "fay" + "/f" * 40):
        (folder / name).mkdir(parents=True)
        (folder / name / RESULTS).write_text("")
    planned = plan_batch(folder, tmp_path / "o", quiz_course, [QUIZ], single=False)
    assert [found.person.id for found in planned.found] == ["ada", "22", "fay"]
    assert [told.where for told in planned.findings] == ["eve"]


def test_nothing_counts_in_an_empty_folder(tmp_path: Path, clock: Clock) -> None:
    (tmp_path / ".part").write_text("")
    with pytest.raises(TimeoutError):
        Arrivals(tmp_path).wait()
    with pytest.raises(UsageError, match="is not a folder"):
        Arrivals(tmp_path / ".part")


def test_who_is_held_back_is_not_looked_at_and_loses_nothing(
    lay: Lay, clock: Clock, quiz_course: Course, tmp_path: Path
) -> None:
    folder = lay("ada", "bao")
    arrivals = Arrivals(folder)
    arrivals.wait()
    arrivals.complete = {name: files for name, files in arrivals.complete.items() if name == "ada"}
    planned = plan_batch(folder, tmp_path / "o", quiz_course, [QUIZ], single=False, arrivals=arrivals)
    assert [found.person.id for found in planned.found] == ["ada"]
    assert [person.id for person in planned.held] == ["bao"]
    assert [person.id for person in planned.people] == ["ada", "bao"]
    with Results.open(tmp_path / "out") as results:
        both = [Submission(name, name, name, name, ()) for name in ("ada", "bao", "cem")]
        results.enter(both)
        results.enter(both[:1], ["bao"])
        assert [one.person for one in results.submissions()] == ["ada", "bao"]


class Watching:
    """The command itself, as an instructor leaves it running."""

    def __init__(self, course: Course, folder: Path, out: Path) -> None:
        words = ["--course", str(course.root), "grade", str(folder), "--watch", "--out", str(out)]
        self._command = subprocess.Popen([sys.executable, "-m", "course", *words])
        self._out = out

    def until_graded(self, *people: str) -> None:
        """Fails unless exactly these people have a mark within a minute."""
        ended = time.monotonic() + 60
        while self._marks().keys() != set(people):
            assert self._command.poll() is None and time.monotonic() < ended, self._marks()
            time.sleep(0.1)

    def _marks(self) -> dict[str, str]:
        file = self._out / "results.csv"
        if not file.is_file():
            return {}
        with file.open(encoding="utf-8-sig") as rows:
            return {row["id"]: row["total"] for row in csv.DictReader(rows) if row["total"]}

    def stop(self) -> int:
        self._command.send_signal(signal.SIGINT)
        return self._command.wait(30)


def kept(out: Path) -> set[tuple[str, ...]]:
    """Every grading with the time when it was stored."""
    with contextlib.closing(sqlite3.connect(out / "grades.sqlite3")) as file:
        return set(file.execute("SELECT person, exercise, at FROM gradings"))


@pytest.mark.slow
def test_the_command_grades_what_arrives_and_goes_on_after_ctrl_c(
    lay: Lay, quiz_course: Course, tmp_path: Path
) -> None:
    folder, out = lay("ada"), tmp_path / "out"
    first = Watching(quiz_course, folder, out)
    first.until_graded("ada")
    lay("bao")
    first.until_graded("ada", "bao")
    assert first.stop() == 130
    before = kept(out)
    assert {row[0] for row in before} == {"ada", "bao"}
    lay("cem")
    second = Watching(quiz_course, folder, out)
    second.until_graded("ada", "bao", "cem")
    assert second.stop() == 130
    after = kept(out)
    assert before < after and {row[0] for row in after - before} == {"cem"}


def test_a_typo_in_a_later_round_is_told_and_harms_nothing(
    lay: Lay,
    quiz_course: Course,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    folder, out = lay("ada"), tmp_path / "out"
    rounds = iter(("first", "typo", "still", "mended", "end"))

    def wait(arrivals: Arrivals) -> None:
        now = next(rounds)
        if now == "end":
            raise KeyboardInterrupt
        if now == "typo":
            lay("bao")
            (out / "deadlines.yaml").write_text("[")
        if now == "mended":
            assert set(arrivals.complete) == {"ada"}  # arrivals are reported again
            (out / "deadlines.yaml").unlink()
        names = {path.name for path in folder.iterdir()}
        arrivals.fresh = frozenset(names - arrivals.complete.keys())
        arrivals.complete = dict.fromkeys(names, frozenset())

    monkeypatch.setattr(Arrivals, "wait", wait)
    words = ["--course", str(quiz_course.root), "grade", str(folder), "--watch", "--out", str(out)]
    assert main([*words, "--no-sandbox"]) == 130
    assert capfd.readouterr().err.count("Error:") == 1
    assert {row[0] for row in kept(out)} == {"ada", "bao"}
