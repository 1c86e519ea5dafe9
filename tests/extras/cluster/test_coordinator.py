"""A round on a cluster: each task counts once, no more are sent than needed, nobody is lost."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator
from pathlib import Path

import pytest

from course.batch.gradings import Graded, GradingTask, Unit
from course.errors import MissingHere
from course.home.opening import Refused
from course.model.result import Verdict
from course_cluster import coordinator
from course_cluster.coordinator import Cluster
from course_cluster.fitness import Wanted
from tests.batch.samples import people
from tests.extras.cluster.dask_stand_in import Client, Future, answer_to

WANTED = Wanted("0.1.0", "engine", "lessons")


class Class:
    """A number of tasks with their homes, and what the instructor was told."""

    def __init__(self, folder: Path, count: int) -> None:
        (folder / "home").mkdir()
        self.told: list[str] = []
        self.names = [f"s{n:03}" for n in range(count)]
        self._left = deque(
            GradingTask(Unit(name, "04-light"), str(folder / "home"), str(folder / f"{name}.mcap"))
            for name in self.names
        )

    def round(
        self,
        client: Client,
        *,
        most: int | None = None,
        alone: bool = False,
        on_look: Callable[[], None] = lambda: None,
    ) -> Generator[Graded, None, None]:
        cluster = Cluster(client, WANTED, self.told.append, most, on_look)  # type: ignore[arg-type]
        return cluster(self._next, waiting=len(self._left), alone=alone)

    def _next(self) -> GradingTask | None:
        return self._left.popleft() if self._left else None


@pytest.fixture
def of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[int], Class]:
    monkeypatch.setattr(coordinator, "_LOOK", 0.01)
    monkeypatch.setattr(coordinator, "wait", lambda futures, **_: None)
    return lambda count: Class(tmp_path, count)


def test_all_are_graded_once(of: Callable[[int], Class]) -> None:
    group = of(50)
    client = Client({"a": 2, "b": 1}, Future.pass_)
    assert people(group.round(client)) == group.names
    assert len(client.gradings) == 50


def test_who_looks_on_may_end_it(of: Callable[[int], Class]) -> None:
    """For example, if Ctrl+C was lost here but reached all workers: nothing would ever arrive again."""
    group, client, looks = of(9), Client({"a": 2}, lambda future: None), iter(range(5))

    def look() -> None:
        if next(looks) == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        people(group.round(client, on_look=look))
    assert client.gradings and all(future.cancelled() for future in client.gradings)


@pytest.mark.parametrize(
    ("workers", "most", "alone", "expected"),
    [({"a": 2, "b": 3}, None, False, 7), ({"a": 2, "b": 3}, 4, False, 4), ({"a": 2, "b": 3}, None, True, 1)],
)
def test_only_so_many_are_on_their_way(
    of: Callable[[int], Class], workers: dict[str, int], most: int | None, alone: bool, expected: int
) -> None:
    group = of(30)
    client = _slow(workers)
    assert people(group.round(client, most=most, alone=alone)) == group.names
    assert client.most == expected


def _slow(workers: dict[str, int]) -> Client:
    client = Client(workers, lambda _: None)
    client.slow = True
    return client


def test_machines_take_what_is_to_be_alone_side_by_side(of: Callable[[int], Class]) -> None:
    group = of(12)
    client = _slow({"a": 4, "b": 4, "c": 4})
    hosts = iter(["one", "one", "two"])
    client.look = lambda future: future.finish((next(hosts), None))
    assert people(group.round(client, alone=True)) == group.names
    assert client.most == 2


def test_bytes_on_their_way_are_bounded(of: Callable[[int], Class], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(coordinator, "MOST_BYTES", 250)
    monkeypatch.setattr(coordinator, "pack", lambda home: b"x" * 100)
    group = of(12)
    client = _slow({"a": 8})
    assert people(group.round(client)) == group.names
    assert client.most == 3


def test_recordings_are_kept_where_they_belong(of: Callable[[int], Class], tmp_path: Path) -> None:
    list(of(1).round(Client({"a": 1}, lambda future: future.pass_(b"mcap"))))
    assert (tmp_path / "s000.mcap").read_bytes() == b"mcap"


@pytest.mark.parametrize(
    ("before", "told"), [([{}] * 5, 1), ([{"good": 1}, {"good": 1}, *[{"bad": 1}] * 5], 2)]
)
def test_without_workers_it_waits_and_says_so_once(
    of: Callable[[int], Class], before: list[dict[str, int]], told: int
) -> None:
    def look(future: Future) -> None:
        future.finish(("host", ("has no ROS", "Install it.") if future.workers == ["bad"] else None))

    group, there, looks = of(1), deque(before), iter(range(50))
    client = Client({}, lambda future: None if there else future.pass_())
    client.look = look
    client.nthreads = lambda: there.popleft() if there else {"new": 1}  # type: ignore[method-assign]
    assert people(group.round(client, on_look=lambda: next(looks))) == group.names
    assert len(group.told) == told and "waiting for one" in group.told[-1] and "Ctrl+C" in group.told[-1]


def test_unfit_workers_are_named_and_left_alone(of: Callable[[int], Class]) -> None:
    def look(future: Future) -> None:
        if future.workers == ["good"]:
            future.finish(("one", None))
        elif future.workers == ["bad"]:
            future.finish(("two", ("has ros2course 9.9", "Install 0.1.0 on it.")))
        else:
            future.fail(ModuleNotFoundError("No module named 'course'"))

    group = of(5)
    client = Client({"bad": 4, "good": 1, "bare": 4}, Future.pass_)
    client.look = look
    assert people(group.round(client)) == group.names
    assert {tuple(future.resources) for future in client.gradings} == {(WANTED.resource,)}
    assert sorted(group.told) == [
        "Worker bad (two) is not used: it has ros2course 9.9. Install 0.1.0 on it.",
        "Worker bare is not used: it has no ros2course, or a different version. Install the same"
        " version on it, with its extra `cluster`, then start the worker again.",
    ]
    assert len(client.looks) == 3


def test_when_none_is_fit_it_ends(of: Callable[[int], Class]) -> None:
    client = Client({"a": 1}, Future.pass_)
    client.look = lambda future: future.finish(("host", ("has no ROS", "Install it.")))
    with pytest.raises(MissingHere, match="only worker cannot be used"):
        list(of(1).round(client))


def test_a_scheduler_that_is_gone_ends_it(of: Callable[[int], Class]) -> None:
    def lose(future: Future) -> None:
        client.status = "connecting"
        future.cancel()

    client = Client({"a": 1}, lose)
    with pytest.raises(MissingHere, match="no longer answers"):
        list(of(3).round(client))


def test_what_others_cancelled_is_sent_again(of: Callable[[int], Class]) -> None:
    group = of(1)
    client = Client({"a": 1}, lambda future: future.pass_() if len(client.gradings) > 1 else future.cancel())
    assert people(group.round(client)) == group.names


def test_what_waits_for_a_worker_is_sent_again_when_one_comes_after_all_have_gone(
    of: Callable[[int], Class],
) -> None:
    """Dask would let it wait forever: a worker says only later that it can grade."""
    group = of(4)
    client = Client({"a": 2}, lambda future: future.pass_() if "b" in client.workers else None)
    looked = 0

    def look_on() -> None:
        nonlocal looked
        looked += 1
        if looked == 4:
            client.workers = {"b": 1}

    assert people(group.round(client, on_look=look_on)) == group.names
    assert [future.cancelled() for future in client.gradings[:3]] == [True] * 3


def test_a_grading_that_kills_its_workers_is_our_error(of: Callable[[int], Class]) -> None:
    (graded,) = of(1).round(Client({"a": 1}, lambda future: future.fail(RuntimeError("KilledWorker"))))
    assert graded.result.verdict is Verdict.OUR_ERROR
    assert graded.result.fault and "KilledWorker" in graded.result.fault.summary


def test_an_answer_for_another_is_our_error(of: Callable[[int], Class], tmp_path: Path) -> None:
    other = GradingTask(Unit("somebody", "04-light"), "", "")
    (graded,) = of(1).round(Client({"a": 1}, lambda future: future.finish(answer_to(other, b"theirs"))))
    assert (graded.unit.person, graded.result.verdict) == ("s000", Verdict.OUR_ERROR)
    assert not (tmp_path / "s000.mcap").exists()


def test_a_home_that_is_too_large_is_our_error_with_a_way_out(
    of: Callable[[int], Class], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(home: Path) -> bytes:
        raise Refused("It is too large.", "Grade it here.")

    monkeypatch.setattr(coordinator, "pack", refuse)
    group = of(3)
    found = list(group.round(Client({"a": 1}, Future.pass_)))
    assert people(found) == group.names
    assert {graded.result.verdict for graded in found} == {Verdict.OUR_ERROR}


def test_stopped_in_the_middle_it_calls_off_the_rest(of: Callable[[int], Class]) -> None:
    client = Client({"a": 3}, lambda future: future.pass_() if len(client.gradings) == 1 else None)
    found = of(9).round(client)
    next(found)
    found.close()
    assert [future.status for future in client.gradings] == [
        "finished",
        "cancelled",
        "cancelled",
        "cancelled",
    ]
