"""What the builds of one check may use together. colcon is replaced."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from course.build import BuildFailure, BuildOutcome, Interrupt, Interrupted, Store, budget
from course.build.budget import (
    ALL_CPU,
    ALL_DISK,
    ALL_SECONDS,
    NO_ROOM,
    SUBMISSION,
    Bounds,
    Budget,
    Spent,
    claimed,
)
from course.build.builder import Unbuildable, build_order
from course.build.workspace import MOST_PACKAGES, Workspace
from course.errors import StorageError
from tests.build.conftest import WORKSPACE
from tests.build.packages import make_package

Built = Callable[..., BuildOutcome]
Runs = Callable[[], list[str]]
MB = 1024 * 1024
SMALL = Bounds(packages=10, seconds=60.0, cpu=60.0, disk=50 * MB)


def failure(outcome: BuildOutcome) -> BuildFailure:
    assert outcome.failure is not None
    return outcome.failure


def chain(src: Path, length: int, program: str = "") -> str:
    """Packages that each need the previous one; returns the last one's name."""
    for number in range(length):
        folder = make_package(src, f"link{number}", *([f"link{number - 1}"] if number else []))
        (folder / "quick.py").write_text(program)
    return f"link{length - 1}"


@pytest.mark.slow
def test_too_many_packages(built: Built, runs: Runs, src: Path) -> None:
    told = failure(built(chain(src, 11), bounds=SMALL))
    assert told.kind == "packages-limit"
    assert "needs 11 packages, its own included, and at most 10" in told.feedback.summary
    assert told.feedback.where[0].file.endswith("link10/package.xml")
    assert runs() == []
    assert built("link9", bounds=SMALL).failure is None


@pytest.mark.slow
def test_a_workspace_of_ten_thousand_packages(src: Path, home: Path) -> None:
    for number in range(10_000):
        make_package(src, f"p{number}", f"p{(number + 1) % 10_000}")
    workspace = Workspace.scan(home / WORKSPACE)
    assert len(workspace.packages) == MOST_PACKAGES + 1
    with pytest.raises(Unbuildable) as caught:
        build_order(workspace, ["p0"])
    assert caught.value.failure.kind == "packages-limit"
    assert f"more than {MOST_PACKAGES} packages" in caught.value.failure.feedback.summary


def test_a_circle_of_many_is_told_in_short(src: Path, home: Path) -> None:
    for number in range(100):
        make_package(src, f"p{number}", f"p{(number + 1) % 100}")
    with pytest.raises(Unbuildable) as caught:
        build_order(Workspace.scan(home / WORKSPACE), ["p0"])
    told = caught.value.failure
    assert told.kind == "package-circle"
    assert len(told.feedback.summary) < 200
    assert len(told.feedback.where) == 6


@pytest.mark.slow
def test_a_chain_that_takes_its_time(built: Built, runs: Runs, src: Path) -> None:
    """No single package takes too long, but all together do."""
    last = chain(src, 10, "import time; time.sleep(1.5)")
    told = failure(built(last, bounds=replace(SMALL, seconds=4.0)))
    assert told.kind == "all-time-limit"
    assert "together took longer than 4 s" in told.feedback.summary
    assert len(runs()) <= 4


@pytest.mark.slow
def test_a_chain_that_computes(built: Built, runs: Runs, src: Path) -> None:
    program = "import time\nwhile time.process_time() < 1.5: pass"
    told = failure(built(chain(src, 10, program), bounds=replace(SMALL, cpu=4.0)))
    assert told.kind == "all-cpu-limit"
    assert "together used more than 4 s of CPU time" in told.feedback.summary


@pytest.mark.slow
def test_a_chain_that_writes(built: Built, runs: Runs, src: Path, store: Store) -> None:
    program = "pathlib.Path(install, 'big').write_bytes(bytes(20_000_000))"
    last = chain(src, 10, program)
    told = failure(built(last, bounds=SMALL))
    assert told.kind == "all-disk-limit"
    assert "together wrote more than 50 MB" in told.feedback.summary
    assert len(runs()) == 3
    assert not list(store.root.glob("*.claim"))
    told = failure(built(last, bounds=SMALL))
    assert told.kind == "all-disk-limit", "what was built before counts"


@pytest.mark.slow
def test_our_own_packages_have_no_bound(built: Built, runs: Runs, src: Path) -> None:
    last = chain(src, 4, "pathlib.Path(install, 'big').write_bytes(bytes(20_000_000))")
    assert built(last).failure is None


def test_a_disk_with_less_than_is_allowed_is_the_machines(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    last = chain(src, 1, "pathlib.Path(install, 'big').write_bytes(bytes(20_000_000))")
    monkeypatch.setattr(Store, "free", lambda _: 20 * MB)
    with pytest.raises(StorageError, match="disk is full"):
        built(last, bounds=SMALL)
    assert len(runs()) == 2, "it is tried once more"


def test_what_a_full_disk_ended_is_built_again(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Somebody else filled it for a moment; the build's own message is not needed."""
    program = f"there = pathlib.Path({str(tmp_path)!r}, 'there')\n"
    program += "not there.exists() and (there.touch() or sys.exit('Bus error'))"
    last = chain(src, 1, program)
    monkeypatch.setattr("course.build.outputs.LOW", 2**62)
    assert built(last, bounds=SMALL).failure is None
    assert len(runs()) == 2


def test_budgets_add_up() -> None:
    mine = Budget(SMALL)
    mine.found("c", 10 * MB)
    assert mine.spend("first", "a", Spent(30.0, 30.0, 20 * MB)) is None
    assert mine.spend("first", "a", Spent(31.0, 31.0, 20 * MB)) is None
    assert mine.spend("second", "b", Spent(30.0, 1.0, 0)) == ALL_SECONDS
    assert mine.spend("second", "b", Spent(1.0, 30.0, 0)) == ALL_CPU
    assert mine.spend("second", "b", Spent(1.0, 1.0, 21 * MB)) == ALL_DISK
    assert mine.wrote("b", 19 * MB) is None
    mine.room = 30 * MB
    assert mine.wrote("b", 19 * MB) == NO_ROOM


class Disk:
    """How much is free in all stores."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, free: int) -> None:
        self.free = free
        monkeypatch.setattr(Store, "free", lambda _: self.free)


def test_room_is_claimed(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    """A build that finds everything claimed by others waits for them."""
    Disk(monkeypatch, budget.RESERVE + SUBMISSION.disk + 3 * MB)
    waiting, order = threading.Event(), []

    def second() -> None:
        theirs = Budget(SUBMISSION)
        with Interrupt() as stop, claimed(store, theirs, stop, waiting.set):
            order.append("second")
            assert theirs.room == float("inf")

    thread = threading.Thread(target=second)
    mine = Budget(SUBMISSION)
    with Interrupt() as stop, claimed(store, mine, stop, lambda: None):
        thread.start()
        assert waiting.wait(10)
        order.append("first")
    thread.join(10)
    assert order == ["first", "second"]
    assert not list(store.root.glob("*.claim"))


def test_waiting_for_room_can_be_called_off(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    Disk(monkeypatch, budget.RESERVE + 2 * MB)
    with (
        Interrupt() as mine,
        claimed(store, Budget(SUBMISSION), mine, lambda: None),
        Interrupt() as theirs,
        pytest.raises(Interrupted),
        claimed(store, Budget(SUBMISSION), theirs, theirs.set),
    ):
        pass


def test_claims_of_the_dead_do_not_count(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    Disk(monkeypatch, budget.RESERVE + SUBMISSION.disk)
    store.root.mkdir()
    (store.root / "killed.claim").write_text("1000000000000")
    mine = Budget(SUBMISSION)
    with Interrupt() as stop, claimed(store, mine, stop, stop.set):
        assert mine.room == float("inf")
    assert not (store.root / "killed.claim").exists()


def test_a_disk_that_is_nearly_full_serves_who_is_alone(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    Disk(monkeypatch, 100 * MB)
    mine = Budget(SUBMISSION)
    with Interrupt() as stop, claimed(store, mine, stop, stop.set):
        assert mine.room == 50 * MB


def test_old_builds_make_room(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted: list[int] = []
    monkeypatch.setattr(Store, "make_room", lambda _, room: wanted.append(room))
    with (
        Interrupt() as stop,
        claimed(store, Budget(SMALL), stop, stop.set),
        Interrupt() as theirs,
        claimed(store, Budget(SMALL), theirs, theirs.set),
    ):
        pass
    assert wanted == [budget.RESERVE + 50 * MB, budget.RESERVE + 100 * MB]


def test_the_bounds_are_generous() -> None:
    assert SUBMISSION.packages >= 30
    assert 600 <= SUBMISSION.seconds <= 1200, "the worker of a class is given up after half an hour"
