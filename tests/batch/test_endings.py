"""However the command ends, the same command continues from there, and leaves nothing else behind."""

from __future__ import annotations

import random
import re
import signal
import sqlite3
import subprocess
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path

import psutil
import pytest

from course.batch.results import FILE
from course.batch.run import results_folder
from course.cli.grade import remove_if_unused
from course.content import open_course
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model import replace
from tests.batch.command import Command, below, groups_of, half_written, outliving, verdicts
from tests.batch.conftest import Lay
from tests.batch.the_class import lay_class
from tests.conftest import FIXTURES
from tests.processes import GRADING, left_in, words_of

pytestmark = pytest.mark.slow

KILLS = 10
TIME = re.compile(r'time(stamp)?="[^"]*"')
QUIZ = ("--course", str(FIXTURES / "quiz_course"))
# Without containment, all of this is still true for submissions that are known to be honest.
WORDS = ("--jobs", "2", *(("--no-sandbox",) if obstacle_to(Level.CONTAINED) else ()))


@pytest.fixture(scope="module")
def honest_class(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("class") / "class"
    lay_class(open_course(), folder, {"07-simplest-package": 7, "04-layout": 3}, honest=True)
    return folder


@pytest.fixture
def command(honest_class: Path, tmp_path: Path) -> Command:
    cache = honest_class.parent / "cache"
    return Command(honest_class, tmp_path / "grades", tmp_path / "tmp", WORDS, cache=cache)


@pytest.fixture
def quiz(lay: Lay, tmp_path: Path) -> Command:
    folder = lay(*(f"p{n:03}" for n in range(40)))
    return Command(folder, tmp_path / "grades", tmp_path / "tmp", WORDS, QUIZ)


def gradings(out: Path) -> dict[tuple[str, str], tuple[str, float]]:
    """When each was graded, and how long it took, which identifies a grading. {} without a file."""
    if not (out / FILE).exists():
        return {}
    with closing(sqlite3.connect(out / FILE)) as database:
        if not database.execute("SELECT 1 FROM sqlite_master WHERE name = 'gradings'").fetchone():
            return {}
        rows = database.execute(
            "SELECT person, exercise, at, seconds FROM gradings WHERE verdict <> 'our error'"
        )
        return {(person, exercise): (at, seconds) for person, exercise, at, seconds in rows}


def killed(command: Command, after: float) -> list[psutil.Process]:
    """Start the command, and kill -9 it after so many seconds; return all that it had started."""
    process = command.start()
    with suppress(subprocess.TimeoutExpired):
        process.wait(after)
    started = below(process)
    process.kill()
    process.communicate()
    return started


def until(said: str, process: subprocess.Popen[str]) -> None:
    assert process.stdout
    for line in process.stdout:
        if said in line:
            return
    raise AssertionError(f"it ended without {said!r}")


def test_killed_ten_times_it_comes_to_the_same(command: Command, tmp_path: Path) -> None:
    moments = random.Random(6)
    all_started: list[psutil.Process] = []
    before = gradings(command.out)
    progress = []
    for _ in range(KILLS):
        started = killed(command, moments.uniform(0.3, 6.0))
        assert outliving(started) == []
        all_started += started
        now = gradings(command.out)
        assert {key: now.get(key) for key in before} == before, "graded twice, or lost"
        before = now
        progress.append(len(before))
    command.until_judged()
    last = gradings(command.out)
    assert {key: last[key] for key in before} == before, "graded twice"
    assert list(half_written(command.out)) == []
    calm = replace(command, out=tmp_path / "calm")
    calm.until_judged()
    assert verdicts(command.out) == verdicts(calm.out)
    assert len(last) == len(verdicts(calm.out)) > max(progress[0], 10), progress
    for report in ("results.csv", "junit.xml"):
        assert _lines(command.out / report) == _lines(calm.out / report)
    assert groups_of(all_started) == []
    assert left_in(command.temporary) == []


def _lines(report: Path) -> list[str]:
    return [TIME.sub("", line) for line in report.read_text(encoding="utf-8").splitlines()]


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)], ids=str
)
def test_stopped_it_ends_in_order_and_goes_on(command: Command, number: signal.Signals, code: int) -> None:
    with command.start() as process:
        until("a minute", process)
        started = below(process)
        process.send_signal(number)
        said = process.communicate()[0]
    assert process.returncode == code, said
    assert ("continues from here" in said) is (number is signal.SIGINT)
    assert outliving(started) == []
    assert groups_of(started) == []
    assert list(half_written(command.out)) == []
    assert not (command.out / "work").exists()
    before = gradings(command.out)
    assert before
    command.until_judged()
    after = gradings(command.out)
    assert {key: after[key] for key in before} == before
    assert len(after) > len(before)


@pytest.mark.parametrize("module", ["course.batch.worker", GRADING])
def test_a_worker_or_a_fork_server_that_is_killed_is_no_loss(command: Command, module: str) -> None:
    with command.start() as process:
        until("a minute", process)
        next(each for each in below(process) if module in words_of(each)).kill()  # parents come first
        said = process.communicate()[0]
    assert process.returncode == 0, said
    assert set(gradings(command.out)) == set(verdicts(command.out))


def test_two_commands_do_not_mix(quiz: Command) -> None:
    with results_folder(quiz.out):
        code, said = quiz.run()
        assert code == 2 and "Somebody else is grading" in said
    code, said = quiz.run()
    assert code == 0 and "40 passed" in said


def test_two_at_the_same_moment_grade_once(quiz: Command) -> None:
    with quiz.start() as one, quiz.start() as other:
        said = [one.communicate()[0], other.communicate()[0]]
    assert sorted((one.returncode, other.returncode)) in ([0, 2], [0, 0]), said
    assert len(gradings(quiz.out)) == 40, said


def test_the_second_one_leaves_the_folder_alone(tmp_path: Path) -> None:
    """It was not there when that command began, so it looks like one of its own."""
    out = tmp_path / "grades"
    with results_folder(out):
        remove_if_unused(out)
        assert (out / FILE).exists()
    remove_if_unused(out)
    assert not out.exists()


@contextmanager
def _full_disk() -> Iterator[None]:
    """Programs started meanwhile cannot write files of more than a hundred kilobytes."""
    import resource

    usual = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, usual[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, usual)


def test_on_a_full_disk_it_stops_with_words_and_goes_on_later(quiz: Command) -> None:
    with _full_disk():
        process = quiz.start()
    with process:
        said = process.communicate()[0]
    assert process.returncode == 4, said
    assert "cannot be saved" in said and "Free some space" in said, said
    before = gradings(quiz.out)
    assert len(before) < 40
    code, said = quiz.run()
    assert code == 0, said
    after = gradings(quiz.out)
    assert len(after) == 40 and {key: after[key] for key in before} == before


def test_stopped_before_it_began_leaves_nothing(quiz: Command) -> None:
    with quiz.start() as process:
        time.sleep(0.1)  # at a random moment
        process.send_signal(signal.SIGINT)
        process.communicate()
    code, said = quiz.run()
    assert code == 0 and "40 passed" in said
