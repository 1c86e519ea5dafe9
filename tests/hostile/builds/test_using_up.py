"""Builds that exhaust what they can: time, memory, processes, the disk, the log."""

from __future__ import annotations

import time

import pytest

from course.build import outputs, package_build, runner
from course.build.budget import SUBMISSION
from course.grading import check
from course.grading.check import attempt_exercise as attempt
from course.isolation.isolation_plan import BUILD
from course.model import replace
from course.model.result import Verdict
from tests.hostile.builds.conftest import BuildIt, cmake_package, python_package
from tests.hostile.world import SRC, Grade
from tests.processes import none_stays

pytestmark = pytest.mark.slow
MB = 1024 * 1024
KINDS = pytest.mark.parametrize("package", [python_package, cmake_package])

FORKS = """
import os
while True:
    try:
        os.fork()
    except OSError:
        pass
"""
THREADS = """
import threading, time
while True:
    try:
        threading.Thread(target=time.sleep, args=(1000,), daemon=True).start()
    except RuntimeError:
        time.sleep(0.01)
"""
MEMORY = """
kept = []
while True:
    kept.append(b'x' * 10_000_000)
"""
DISK = """
number = 0
while True:
    number += 1
    try:
        with open(f'filler-{number}', 'wb') as file:
            for _ in range(50):
                file.write(bytes(1_000_000))
    except OSError:
        pass
"""
OUTPUT = """
import os
while True:
    os.write(2, b'x' * 65536 + b'\\n')
"""
LOOP = """
import os, signal
for number in range(1, 65):
    try:
        signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError):
        pass
if os.fork() == 0:
    os.setsid()
    os.fork()
while True:
    pass
"""
FOLDERS = """
import os
for _ in range(3000):
    os.mkdir('deeper')
    os.chdir('deeper')
while True:
    pass
"""
FILES = """
import os
for number in range(30_000):
    open(f'file-{number}', 'w').close()
while True:
    pass
"""
LONG = 120.0  # a busy machine may need its time to reach another limit
LIMITED = (
    (FORKS, "processes-limit", "started more than 256 processes and threads"),
    (THREADS, "processes-limit", "started more than 256 processes and threads"),
    (MEMORY, "memory-limit", "took more than 3072 MB of memory"),
    (DISK, "disk-limit", "wrote more than 1024 MB of files"),
    (OUTPUT, "output-limit", "never stopped printing"),
    (LOOP, "time-limit", "took longer than 8 seconds"),
    (FOLDERS, "files-limit", "or folders nested far too deep"),
    (FILES, "files-limit", "created more than 50000 files"),
)


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """As usual, but with lower limits, for this machine's sake."""
    less = replace(BUILD, memory=300 * MB, scratch=150 * MB)
    monkeypatch.setattr(package_build, "BUILD", less)
    monkeypatch.setattr(runner, "MOST_OUTPUT", 4 * MB)
    monkeypatch.setattr(outputs, "MOST_FILES", 20_000)


@pytest.mark.parametrize(("program", "kind", "words"), LIMITED, ids=[kind for _, kind, _ in LIMITED])
def test_it_is_stopped_and_told(build_it: BuildIt, program: str, kind: str, words: str) -> None:
    time_limit = 8.0 if kind == "time-limit" else LONG
    built = build_it(python_package(program), guarantee=f"a build ends at its {kind}", time_limit=time_limit)
    assert built.failure.kind == kind
    assert words in built.failure.feedback.summary
    assert built.failure.feedback.where[0].file.endswith("strange/setup.py")
    assert [path.name for path in built.entry.iterdir()] == ["log"]


def test_cmake_is_stopped_too(build_it: BuildIt) -> None:
    guarantee = "a build ends at its limit of processes"
    built = build_it(cmake_package(FORKS), guarantee=guarantee, time_limit=LONG)
    assert built.failure.kind == "processes-limit"
    assert built.failure.feedback.where[0].file.endswith("strange/CMakeLists.txt")


def test_what_is_written_at_the_last_moment_counts(build_it: BuildIt) -> None:
    program = (
        "MORE = [f'big-{n}' for n in range(4)]\\nfor name in MORE: open(name, 'wb').write(bytes(50_000_000))"
    )
    built = build_it(
        python_package(program.replace("\\n", "\n")), guarantee="a disk is not filled at the end"
    )
    assert built.failure.kind == "disk-limit"


def test_nothing_outlives_its_build(build_it: BuildIt) -> None:
    """A daemon that waits for the end of its build, to change what it installed."""
    program = """
import os, time
if os.fork() == 0:
    os.setsid()
    if os.fork():
        os._exit(0)
    for number in range(3, 100):
        try:
            os.close(number)
        except OSError:
            pass
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in range(3):
        os.dup2(nothing, number)
    while True:
        for folder, _, _ in os.walk('../install'):
            try:
                open(os.path.join(folder, 'late'), 'a').write('breach')
            except OSError:
                pass
"""
    with none_stays():
        built = build_it(python_package(program), guarantee="no process outlives a build")
        assert built.outcome.failure is None, built.words
        before = {path: path.lstat().st_mtime_ns for path in built.entry.rglob("*")}
        time.sleep(0.5)  # there is no event for something that must not happen
        assert before == {path: path.lstat().st_mtime_ns for path in built.entry.rglob("*")}


def test_all_limits_have_words() -> None:
    known = {*package_build._LIMITS, "time", "output"}
    assert {kind.removesuffix("-limit") for _, kind, _ in LIMITED} <= known


def test_builds_beyond_the_budget_are_a_failure_and_not_run_again(
    grade: Grade, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A rerun would take the same time again, and others wait."""
    attempts = []
    monkeypatch.setattr(check, "SUBMISSION", replace(SUBMISSION, seconds=3.0))
    monkeypatch.setattr(
        check, "attempt_exercise", lambda *given, **more: (attempts.append(1), attempt(*given, **more))[1]
    )
    setup = f"{SRC}/the_simplest_python_package/setup.py"
    graded = grade({setup: LOOP}, "07-simplest-package", guarantee="a build without end is a failure")
    assert graded.result.verdict is Verdict.NOT_PASSED, graded.result
    assert graded.failed[:1] == ("builds",)
    assert "together took longer than 3 s" in graded.words("builds")
    assert attempts == [1]
