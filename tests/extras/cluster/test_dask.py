"""Dask does its part: only workers that offer the resource get gradings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict

import pytest

from course.model import replace
from course_cluster import fitness, worker
from course_cluster.coordinator import Roster, _done, call
from course_cluster.fitness import Unfit, Wanted

distributed = pytest.importorskip("distributed")
pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

PATIENCE = 30.0
WANTED = Wanted("0.1.0", "engine", "lessons")


@pytest.fixture
def client(monkeypatch: pytest.MonkeyPatch) -> Iterator[distributed.Client]:
    """Two workers with two threads each, in this process."""
    monkeypatch.setattr(worker, "engine_digest", lambda: "engine")
    monkeypatch.setattr(worker, "unfit", lambda asked, engine: None)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=2, processes=False, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster, set_as_default=False) as client,
    ):
        yield client


def test_a_worker_that_fits_offers_so_many_gradings_as_suit_it(
    client: distributed.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(worker, "default_jobs", lambda: 1)
    for address in client.nthreads():
        assert call(client, "look", asdict(WANTED), workers=[address]).result(PATIENCE)[1] is None
    offered = client.run(lambda dask_worker: dask_worker.state.total_resources)
    assert [*offered.values()] == [{WANTED.resource: 1}] * 2


def test_only_who_fits_is_given_gradings(client: distributed.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    first = next(iter(client.nthreads()))
    problem = Unfit("has no ROS", "Install it.")
    monkeypatch.setattr(
        worker, "unfit", lambda asked, engine: None if distributed.get_worker().address == first else problem
    )
    monkeypatch.setattr(worker, "grade", lambda: distributed.get_worker().address)
    told: list[str] = []
    roster = Roster(client, WANTED, told.append)
    roster.look()
    while roster.looking:
        _done(client, roster.looking)
        roster.look()
    assert roster.fit == {first: 2}
    assert len(told) == 1 and "is not used: it has no ROS. Install it." in told[0]
    gradings = [call(client, "grade", resources={WANTED.resource: 1}) for _ in range(6)]
    assert {future.result(PATIENCE) for future in gradings} == {first}


def test_a_worker_without_this_package_says_so(client: distributed.Client) -> None:
    future = call(client, "no_such_function")
    assert isinstance(future.exception(PATIENCE), AttributeError)


def test_another_course_asks_for_another_resource(monkeypatch: pytest.MonkeyPatch) -> None:
    assert replace(WANTED, lessons="others").resource != WANTED.resource
    assert fitness.Wanted(**asdict(WANTED)).resource == WANTED.resource
