"""Our own programs alongside the learner's: where they run, what they get, what they share."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.arena.home_programs import memory_mark
from course.errors import MissingHere
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model.events import Marked

from .conftest import WAIT
from .programs import SOURCED, Programs

TELLS = "import os, sys\nprint(__file__, os.environ['KIND'], os.environ['SET'], *sys.argv[1:])\n"
LISTS = (
    "import os, sys\nprint('listed', *os.listdir('/dev/shm'))\nopen('/dev/shm/' + sys.argv[1], 'w').close()\n"
)
MAPS = """
import mmap, sys
with open("/dev/shm/segment", "w+b") as file:
    file.truncate(4096)
    kept = mmap.mmap(file.fileno(), 4096)
print("up", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def write(tmp_path: Path) -> Path:
    return tmp_path / "grader.py"


def test_a_companion_is_a_copy_that_runs_in_the_learners_environment(programs: Programs, write: Path) -> None:
    write.write_text(TELLS)
    assert programs.companion(write, "one", name="c", env={"SET": "yes"}).wait(WAIT)
    assert programs.lines == [f"{programs.ours}/grader.py sourced yes one"]


@pytest.mark.slow
def test_memory_of_its_own_is_empty_and_stays_unseen(programs: Programs, write: Path) -> None:
    if obstacle := obstacle_to(Level.NAMESPACES):
        pytest.skip(f"not exercised: /dev/shm of a program's own ({obstacle})")
    write.write_text(LISTS)
    mine = f"ros2course-own-{os.getpid()}"
    for name in ("first", "second"):
        assert programs.companion(write, mine, name=name, own_memory=True).wait(WAIT)
    assert programs.lines == ["listed", "listed"]
    assert not Path("/dev/shm", mine).exists()


@pytest.mark.slow
def test_what_it_has_in_its_own_memory_is_seen_and_recorded(programs: Programs, write: Path) -> None:
    if obstacle := obstacle_to(Level.NAMESPACES):
        pytest.skip(f"not exercised: /dev/shm of a program's own ({obstacle})")
    write.write_text(MAPS)
    process = programs.companion(write, name="maps", own_memory=True)
    assert programs.timeline.wait_until(lambda: programs.lines == ["up"], WAIT), programs.lines
    assert programs.shared_memory(process) == ("segment",)
    assert [(mark.name, mark.detail) for mark in programs.timeline.of(Marked)] == [
        (memory_mark("maps"), "segment")
    ]


def test_where_the_network_is_shared_memory_of_its_own_is_not_to_be_had(tmp_path: Path, write: Path) -> None:
    """There, ROS must stay on this machine, and uses shared memory whatever a profile says."""
    programs = Programs(tmp_path, environment={**SOURCED, "ROS_DOMAIN_ID": "7"})
    write.write_text("")
    with pytest.raises(MissingHere) as caught:
        programs.companion(write, name="c", own_memory=True)
    assert "namespaces" in caught.value.what
    assert "doctor" in str(caught.value.next_step)


def test_domains_are_those_of_the_network(programs: Programs, tmp_path: Path) -> None:
    assert programs.domain(1) == 1
    (tmp_path / "shared").mkdir()
    assert Programs(tmp_path / "shared", environment={**SOURCED, "ROS_DOMAIN_ID": "7"}).domain(0) == 7
