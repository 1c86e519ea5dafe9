"""Progress is remembered, and survives damage, a second process, and a sudden end."""

from __future__ import annotations

import fcntl
import multiprocessing
import os
import signal
import sqlite3
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager, closing
from pathlib import Path

import pytest

from course.errors import StorageError, UsageError
from course.model.result import CheckResult, Feedback, Outcome, Result, Verdict
from course.progress import FILE, Progress, _set_aside

REPOSITORY = Path(__file__).parents[1]


def result(exercise: str = "18-publisher", points: float = 0.0, verdict: Verdict | None = None) -> Result:
    """A result of 3 points, of which some were earned."""
    earned = CheckResult("topic", "publishes", points, Outcome.PASSED)
    why = Feedback("nothing was published")
    missed = CheckResult("rate", "twice per second", 3 - points, Outcome.FAILED, feedback=why)
    usual = Verdict.PASSED if points == 3 else Verdict.NOT_PASSED
    return Result(exercise, verdict or usual, (earned,) if points == 3 else (earned, missed))


@pytest.fixture
def state(tmp_path: Path) -> Path:
    return tmp_path / "state"


def test_a_new_exercise(state: Path) -> None:
    with Progress.open(state) as progress:
        assert progress.state("18-publisher") == "new"
        assert progress.attempts("18-publisher") == 0
        assert progress.best("18-publisher") is None
        assert progress.last_result("18-publisher") is None
        assert progress.hints_shown("18-publisher") == 0
        assert progress.current() is None
        assert progress.passed_ids() == frozenset()
        assert progress.notices == ()


def test_from_new_to_passed_and_never_back(state: Path) -> None:
    states = []
    with Progress.open(state) as progress:
        progress.set_current("18-publisher")
        states.append(progress.state("18-publisher"))
        for points in (1.0, 3.0, 0.0):
            progress.record(result(points=points))
            states.append(progress.state("18-publisher"))
        assert states == ["begun", "tried", "passed", "passed"]
        assert progress.attempts("18-publisher") == 3
        assert progress.best("18-publisher") == 3.0
        assert progress.passed_ids() == {"18-publisher"}
        assert progress.state("18-subscriber") == "new"


@pytest.mark.parametrize("verdict", [Verdict.OUR_ERROR, Verdict.NOT_AVAILABLE])
def test_what_is_not_the_learner_s_does_not_count(state: Path, verdict: Verdict) -> None:
    with Progress.open(state) as progress:
        progress.record(result(points=1.0))
        progress.record(result(points=2.0, verdict=verdict))
        assert progress.attempts("18-publisher") == 1
        assert progress.best("18-publisher") == 1.0
        assert progress.last_result("18-publisher") == result(points=1.0)
    with closing(sqlite3.connect(state / FILE)) as database:  # but it is stored
        assert database.execute("SELECT count(*) FROM attempts").fetchone() == (2,)


def test_the_last_result_comes_back_whole(state: Path) -> None:
    with Progress.open(state) as progress:
        progress.record(result(points=3.0))
        progress.record(result(points=1.0))
    with Progress.open(state) as progress:
        assert progress.last_result("18-publisher") == result(points=1.0)


def test_failures_are_counted_by_check(state: Path) -> None:
    checks = (CheckResult("rate", "x", 1, Outcome.FAILED), CheckResult("type", "y", 1, Outcome.PASSED))
    with Progress.open(state) as progress:
        for exercise in ("18-publisher", "18-publisher", "10-run-quiz"):
            progress.record(Result(exercise, Verdict.NOT_PASSED, checks))
        assert progress.failures() == {("18-publisher", "rate"): 2, ("10-run-quiz", "rate"): 1}


def test_answers_in_reviews_count(state: Path) -> None:
    with Progress.open(state) as progress:
        for question, right in (("a", False), ("a", False), ("a", True), ("b", True)):
            progress.record_review("10-run-quiz", question, right=right)
    with Progress.open(state) as progress:
        assert progress.failures() == {("10-run-quiz", "a"): 1, ("10-run-quiz", "b"): 0}


def test_a_file_from_before_reviews_were_kept(state: Path) -> None:
    with Progress.open(state) as progress:
        progress.record(result())
    with closing(sqlite3.connect(state / FILE)) as database, database:
        database.execute("DROP TABLE reviews")
    with Progress.open(state) as progress:
        progress.record_review("10-run-quiz", "a", right=False)
        assert (progress.notices, progress.attempts("18-publisher")) == ((), 1)


def test_a_result_in_another_form_is_as_none(state: Path) -> None:
    with Progress.open(state) as progress:
        progress.record(result())
    with closing(sqlite3.connect(state / FILE)) as database, database:
        database.execute("UPDATE attempts SET result = '{\"schema\": 99}'")
    with Progress.open(state) as progress:
        assert progress.last_result("18-publisher") is None
        assert progress.attempts("18-publisher") == 1


def test_hints_move_on_and_stay_at_the_last(state: Path) -> None:
    with Progress.open(state) as progress:
        assert [progress.next_hint("18-publisher", 3) for _ in range(2)] == [0, 1]
    with Progress.open(state) as progress:
        assert progress.hints_shown("18-publisher") == 2
        assert [progress.next_hint("18-publisher", 3) for _ in range(3)] == [2, 2, 2]
        assert progress.hints_shown("18-publisher") == 3
        assert progress.next_hint("18-subscriber", 3) == 0


def test_fewer_hints_than_before_show_the_last(state: Path) -> None:
    with Progress.open(state) as progress:
        for _ in range(4):
            progress.next_hint("18-publisher", 5)
        assert progress.next_hint("18-publisher", 3) == 2


def test_the_current_exercise_and_the_chapters_shown_are_kept(state: Path) -> None:
    with Progress.open(state) as progress:
        progress.set_current("18-publisher")
        progress.set_current("18-subscriber")
        progress.mark_chapter_shown("18-topics")
        progress.mark_chapter_shown("18-topics")
    with Progress.open(state) as progress:
        assert progress.current() == "18-subscriber"
        assert progress.chapter_shown("18-topics")
        assert not progress.chapter_shown("19-inspecting")


def test_the_file_is_in_wal_mode(state: Path) -> None:
    Progress.open(state).__exit__(None, None, None)
    with closing(sqlite3.connect(state / FILE)) as database:
        assert database.execute("PRAGMA journal_mode").fetchone() == ("wal",)


# ------------------------------------------------------------------------------------------- damage


@pytest.fixture
def used(state: Path) -> Path:
    """The file of somebody who has done a lot."""
    with Progress.open(state) as progress:
        for number in range(8):
            progress.record(result(f"{number:02d}-thing", points=3.0))
    return state / FILE


def not_sqlite(file: Path) -> None:
    file.write_bytes(b"This is a text, not a database.\n" * 100)


def zeros(file: Path) -> None:
    file.write_bytes(bytes(file.stat().st_size))


def truncated(file: Path) -> None:
    os.truncate(file, file.stat().st_size // 2)


def cut_to_a_few_bytes(file: Path) -> None:
    os.truncate(file, 50)


def overwritten_inside(file: Path) -> None:
    with file.open("r+b") as stream:
        stream.seek(4096)
        stream.write(b"\xff" * 8192)


def of_something_else(file: Path) -> None:
    file.unlink()
    with closing(sqlite3.connect(file)) as database, database:
        for table in ("attempts", "exercises", "chapters_shown", "current"):
            database.execute(f"CREATE TABLE {table} (x)")
        database.execute("PRAGMA user_version = 1")


def a_table_gone(file: Path) -> None:
    with closing(sqlite3.connect(file)) as database, database:
        database.execute("DROP TABLE exercises")


def without_version(file: Path) -> None:
    with closing(sqlite3.connect(file)) as database, database:
        database.execute("PRAGMA user_version = 0")


DAMAGES = [
    not_sqlite,
    zeros,
    truncated,
    cut_to_a_few_bytes,
    overwritten_inside,
    of_something_else,
    a_table_gone,
    without_version,
]


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_kept_aside_and_told(used: Path, damage: Callable[[Path], None]) -> None:
    damage(used)
    content = used.read_bytes()
    with Progress.open(used.parent) as progress:
        (notice,) = progress.notices
        assert progress.passed_ids() == frozenset()
        progress.record(result(points=3.0))
    (aside,) = used.parent.glob("progress.damaged-*.sqlite3")
    assert str(aside) in notice
    assert aside.read_bytes() == content
    with Progress.open(used.parent) as progress:
        assert progress.notices == ()
        assert progress.passed_ids() == {"18-publisher"}


def test_two_damaged_files_in_one_second_are_both_kept(used: Path) -> None:
    for content in (b"first " * 100, b"second " * 100):
        used.write_bytes(content)
        Progress.open(used.parent).__exit__(None, None, None)
    kept = {aside.read_bytes()[:5] for aside in used.parent.glob("progress.damaged-*.sqlite3")}
    assert kept == {b"first", b"secon"}


def test_journals_go_aside_with_their_file(used: Path) -> None:
    for suffix in ("-wal", "-journal"):  # SQLite deletes most of them itself; what stays must not be mixed
        Path(f"{used}{suffix}").write_text("left over")
    aside = _set_aside(used)
    assert Path(f"{aside}-wal").read_text() == Path(f"{aside}-journal").read_text() == "left over"
    assert [path for path in used.parent.iterdir() if path.name.startswith(FILE)] == []


def test_an_empty_file_is_begun(state: Path) -> None:
    state.mkdir()
    (state / FILE).touch()
    with Progress.open(state) as progress:
        assert progress.notices == ()
        progress.record(result())


def test_the_file_of_a_newer_version_is_left_alone(used: Path) -> None:
    with closing(sqlite3.connect(used)) as database, database:
        database.execute("PRAGMA user_version = 99")
    content = used.read_bytes()
    with pytest.raises(UsageError, match="newer") as caught:
        Progress.open(used.parent)
    assert "upgrade" in (caught.value.next_step or "")
    assert used.read_bytes() == content
    assert not list(used.parent.glob("progress.damaged*"))


# ------------------------------------------------------------------------------------ two processes


@pytest.mark.slow
def test_two_processes_at_once_both_land(state: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        pool.starmap(_record_many, [(state, "01-a"), (state, "02-b")], chunksize=1)
    with Progress.open(state) as progress:
        assert (progress.attempts("01-a"), progress.attempts("02-b")) == (10, 10)
        assert progress.hints_shown("00-both") == 20
        assert progress.notices == ()


def _record_many(state: Path, exercise: str) -> None:
    for number in range(10):
        with Progress.open(state) as progress:
            progress.record(result(exercise, points=number % 3))
            progress.next_hint("00-both", 1000)


def test_two_processes_set_a_damaged_file_aside_once(used: Path) -> None:
    not_sqlite(used)
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        notices = pool.map(_open_and_record, [used.parent] * 6, chunksize=1)
    assert sum(notices) == 1
    assert len(list(used.parent.glob("progress.damaged-*"))) == 1
    with Progress.open(used.parent) as progress:
        assert progress.attempts("18-publisher") == 6


def _open_and_record(state: Path) -> int:
    with Progress.open(state) as progress:
        progress.record(result())
        return len(progress.notices)


def test_what_a_killed_process_recorded_is_there(state: Path) -> None:
    code = (
        "import os, signal, sys; from pathlib import Path; from course.progress import Progress\n"
        "progress = Progress.open(Path(sys.argv[1]))\n"
        "progress.set_current('18-publisher')\n"
        "progress._database.execute('BEGIN IMMEDIATE')\n"
        "progress._run('DELETE FROM current')\n"  # not committed
        "os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    environ = {**os.environ, "PYTHONPATH": str(REPOSITORY)}
    ended = subprocess.run([sys.executable, "-c", code, str(state)], env=environ, check=False)
    assert ended.returncode == -signal.SIGKILL
    assert (state / f"{FILE}-wal").stat().st_size > 0  # the leftover that this is about
    with Progress.open(state) as progress:
        assert progress.notices == ()
        assert progress.current() == "18-publisher"


def test_a_journal_left_without_its_file_is_no_matter(state: Path, used: Path) -> None:
    with Progress.open(state) as progress:
        progress.set_current("18-publisher")
        leftover = (state / f"{FILE}-wal").read_bytes()
    used.unlink()
    Path(f"{used}-wal").write_bytes(leftover)
    with Progress.open(state) as progress:
        assert progress.current() is None
        progress.record(result())


def test_opening_waits_for_another_that_is_opening(state: Path) -> None:
    other = threading.Thread(target=_open_and_record, args=(state,))
    state.mkdir()
    with (state / "progress.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        other.start()
        other.join(0.2)
        assert other.is_alive()
        assert not (state / FILE).exists()
    other.join(10)
    assert (state / FILE).exists()


def test_what_is_read_for_writing_cannot_change_meanwhile(
    state: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("course.progress.BUSY_SECONDS", 0.05)
    with Progress.open(state) as one, Progress.open(state) as other:
        with one.writing(), pytest.raises(StorageError, match="locked"):
            other.next_hint("18-publisher", 3)
        assert other.next_hint("18-publisher", 3) == 0


def test_an_error_in_between_leaves_all_as_it_was(state: Path) -> None:
    with Progress.open(state) as progress:
        progress.set_current("18-publisher")
        with pytest.raises(ZeroDivisionError), progress.writing():
            progress._run("DELETE FROM current")
            raise ZeroDivisionError
        assert progress.current() == "18-publisher"
        progress.set_current("18-subscriber")
    with Progress.open(state) as progress:
        assert progress.current() == "18-subscriber"


def test_a_file_that_stays_busy_is_told(state: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    Progress.open(state).__exit__(None, None, None)
    monkeypatch.setattr("course.progress.BUSY_SECONDS", 0.05)
    with closing(sqlite3.connect(state / FILE, isolation_level=None)) as other:
        other.execute("BEGIN IMMEDIATE")
        with Progress.open(state) as progress:
            with pytest.raises(StorageError, match="locked") as caught:
                progress.record(result())
            assert "wait" in (caught.value.next_step or "")
            other.execute("COMMIT")
            progress.record(result())
            assert progress.attempts("18-publisher") == 1


# -------------------------------------------------------------------------------- disks that refuse


def test_a_full_disk_loses_nothing(used: Path) -> None:
    with Progress.open(used.parent) as progress:
        pages = progress._database.execute("PRAGMA page_count").fetchone()[0]
        progress._database.execute(
            f"PRAGMA max_page_count = {pages}"
        )  # SQLite then says what a full disk does
        with pytest.raises(StorageError, match="full") as caught:
            for _ in range(50):
                progress.record(result())
        assert "free some space" in (caught.value.next_step or "")
        before = progress.attempts("18-publisher")
        progress._database.execute("PRAGMA max_page_count = 100000")
        progress.record(result())
        assert progress.attempts("18-publisher") == before + 1
        assert len(progress.passed_ids()) == 8


def test_a_read_only_home_is_told(
    open_folder: Path, read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    state = open_folder / "state"
    with Progress.open(state) as progress:
        progress.record(result(points=3.0))
    with read_only(open_folder), pytest.raises(StorageError) as caught:
        Progress.open(state)
    assert "make the course home writable" in (caught.value.next_step or "")
    with Progress.open(state) as progress:
        assert progress.passed_ids() == {"18-publisher"}


def test_a_read_only_file_is_told(state: Path) -> None:
    with Progress.open(state) as progress:
        progress._database.execute("PRAGMA query_only = ON")  # as SQLite says it of a file, to root too
        with pytest.raises(StorageError, match="readonly") as caught:
            progress.record(result())
        assert "make the course home writable" in (caught.value.next_step or "")


def test_a_state_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError):
        Progress.open(tmp_path / "file/state")


@pytest.fixture
def no_shared_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """SQLite as on a disk that WAL cannot work on: through its own file system layer that lacks it."""
    connect = sqlite3.connect

    def elsewhere(file: Path, **options: object) -> sqlite3.Connection:
        return connect(f"file:{file}?vfs=unix-dotfile", uri=True, **options)  # type: ignore[call-overload]

    monkeypatch.setattr("course.progress.sqlite3.connect", elsewhere)


def journal_mode(progress: Progress) -> str:
    return str(progress._database.execute("PRAGMA journal_mode").fetchone()[0])


def test_where_wal_cannot_work_another_journal_is_used(state: Path, no_shared_memory: None) -> None:
    for _ in range(2):
        with Progress.open(state) as progress:
            progress.record(result(points=3.0))
            assert journal_mode(progress) == "delete"
            assert progress.notices == ()
    with Progress.open(state) as progress:
        assert progress.attempts("18-publisher") == 2


def test_a_home_moved_to_such_a_disk_is_converted(used: Path, request: pytest.FixtureRequest) -> None:
    request.getfixturevalue("no_shared_memory")
    with Progress.open(used.parent) as progress:
        assert progress.notices == ()
        assert len(progress.passed_ids()) == 8
        progress.record(result())
        assert journal_mode(progress) == "delete"
    with Progress.open(used.parent) as progress:
        assert progress.attempts("18-publisher") == 1


def test_importing_it_is_light() -> None:
    code = "import sys, course.progress; print(*sys.modules)"
    environ = {**os.environ, "PYTHONPATH": str(REPOSITORY)}
    found = subprocess.run(
        [sys.executable, "-c", code], env=environ, check=True, capture_output=True, text=True
    )
    assert not {"json", "yaml", "pydantic", "rich", "typer", "course.grading"} & set(found.stdout.split())
