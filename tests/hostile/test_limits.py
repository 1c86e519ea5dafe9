"""Programs that exhaust the machine: each is stopped in time, with a reason in words for a beginner."""

from __future__ import annotations

import pytest

from course.isolation.identity import available
from course.model.result import Verdict
from tests.hostile.world import MB, NODE, Grade, Graded, with_attack

pytestmark = pytest.mark.slow


def stopped_for(graded: Graded, *words: str) -> None:
    """Not passed, and the first check that failed names the cause."""
    assert graded.result.verdict is Verdict.NOT_PASSED, graded.result
    assert graded.failed, graded.result
    for word in words:
        assert word in graded.words(graded.failed[0]), graded.words(graded.failed[0])


def test_a_fork_bomb(grade: Grade) -> None:
    graded = grade({NODE: with_attack("fork_bomb", MOST=40)}, guarantee="a fork bomb hits its sandbox only")
    stopped_for(graded, "more than 512 processes and threads", "in a loop")


def test_a_thread_bomb(grade: Grade) -> None:
    graded = grade({NODE: with_attack("thread_bomb")}, guarantee="threads are counted, too")
    stopped_for(graded, "more than 512 processes and threads", "in a loop")


@pytest.mark.parametrize("processes", [0, 5])
def test_a_memory_hog(grade: Grade, processes: int) -> None:
    text = with_attack("memory_hog", PROCESSES=processes)
    graded = grade({NODE: text}, guarantee="memory of all programs together is bounded")
    stopped_for(graded, "more than 1024 MB of memory", "grows forever")


@pytest.mark.skipif(not available(), reason="without control groups, nobody counts the kernel's memory")
@pytest.mark.parametrize("kind", ["tcp", "udp"])
def test_memory_of_sockets(grade: Grade, kind: str) -> None:
    """The kernel limits it only for the whole machine; if it is full, everyone's messages are lost."""
    text = with_attack("socket_memory", KIND=kind, MOST=256 * MB)
    graded = grade({NODE: text}, guarantee="what programs send and nobody reads is bounded")
    assert not graded.breaches
    assert "socket memory" in graded.held


def test_a_disk_filler(grade: Grade) -> None:
    graded = grade({NODE: with_attack("disk_filler")}, guarantee="what programs write has little room")
    stopped_for(graded, "more than 256 MB of files")


def test_empty_files_without_end(grade: Grade) -> None:
    graded = grade({NODE: with_attack("inode_filler")}, guarantee="files take memory even when empty")
    stopped_for(graded, "so all of them were stopped")
