"""`grade --cluster`, as the core calls it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from course.batch.run import Rounds
from course_cluster.connect import scheduler_at
from course_cluster.coordinator import Cluster
from course_cluster.fitness import wanted


@contextmanager
def cluster_rounds(
    address: str,
    security: Path | None,
    course: Path | None,
    contained: bool,
    most: int | None,
    say: Callable[[str], None],
    on_look: Callable[[], None],
) -> Iterator[Rounds]:
    """A function that grades on the workers of the scheduler at `address`.

    security: a file with keys for TLS. course: root of the course, None for ours. contained: refuse
    workers that cannot contain submissions. most, say, on_look: see `Cluster`.
    Raises UsageError for an invalid address or file, and MissingHere if nobody answers.
    """
    like_this = wanted(course, contained)
    with scheduler_at(address, security) as client:
        yield Cluster(client, like_this, say, most, on_look)
