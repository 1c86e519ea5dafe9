"""Recording processes are forks of one process: nothing of one recording gets into the next."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from course.grading.protocol import RecordingTask
from course.grading.supervisor import ForkServer, Supervisor
from course.isolation.levels import isolated
from course.model import replace
from course.rosenv import find_ros, node_environment

from .conftest import GRADER

pytestmark = pytest.mark.slow

# Leaves as much as it can, and tells what it finds.
FINDS = """
    import ctypes, json, os, random, secrets, sys, tempfile
    import course.model.codec as ours
    numbers = [n for n in os.listdir("/proc/self/fd") if os.path.exists(f"/proc/self/fd/{n}")]
    links = [os.readlink(f"/proc/self/fd/{n}") for n in numbers]
    found = {
        "attribute": getattr(ours, "left", None),
        "module": "left" in sys.modules,
        "environment": os.environ.get("LEFT"),
        "folder": os.getcwd(),
        "path": "/left" in sys.path,
        "descriptors": [link for link in links if "left" in link],
        "count": len(links),
        "drawn": [random.random(), secrets.token_hex(8), next(tempfile._get_candidate_names())],
        "dumpable": ctypes.CDLL(None).prctl(3, 0, 0, 0, 0),
    }
    ours.left, sys.modules["left"], os.environ["LEFT"] = 1, sys, "1"
    sys.path.append("/left")
    os.chdir("/dev")
    kept = os.memfd_create("left")
    random.seed(1)
    os.write(int(sys.argv[1]), json.dumps({"kind": "stage", "text": json.dumps(found)}).encode() + b"\\n")
"""
TELLS = GRADER.replace("def run_it(arena):", f"def run_it(arena):{FINDS}")
PROGRAM = "import time\nprint('go', flush=True)\nwhile True: time.sleep(1)"
Find = Callable[..., dict[str, Any]]


@pytest.fixture(params=["namespaces", "domain"])
def find(request: pytest.FixtureRequest, toy_job: Callable[..., RecordingTask]) -> Iterator[Find]:
    """What a recording finds of those before; all are forks of one process."""
    job = toy_job(PROGRAM, TELLS)
    with contextlib.closing(ForkServer()) as fork_server:
        fork_server.start(node_environment(find_ros()))

        def found(**more: str) -> dict[str, Any]:
            said: list[str] = []
            with isolated(namespaces=request.param == "namespaces") as where:
                environment = {**node_environment(find_ros()), **more}
                task = replace(job, environment={**job.environment, **where.environment})
                with Supervisor(where, environment, fork_server=fork_server) as supervisor:
                    outcome = supervisor.record(task, 60.0, said.append)
            assert outcome.fault is None, outcome.fault
            told: dict[str, Any] = json.loads(next(text for text in said if text.startswith("{")))
            return told

        yield found


def test_nothing_is_left_for_the_next(find: Find) -> None:
    first, second = find(LEFT="of the first"), find()
    assert not set(first.pop("drawn")) & set(second.pop("drawn"))
    assert (first.pop("environment"), second.pop("environment")) == ("of the first", None)
    assert first == second
    del second["count"]
    nothing = {"attribute": None, "module": False, "path": False, "descriptors": [], "dumpable": 0}
    assert second == {**nothing, "folder": "/"}


def test_who_is_forked_from_keeps_nothing_and_is_replaced_when_killed() -> None:
    environment = node_environment(find_ros())
    with contextlib.closing(ForkServer()) as fork_server:
        for _ in range(2):
            with isolated() as where, Supervisor(where, environment, fork_server=fork_server):
                children = psutil.Process().children()
                (process,) = (one for one in children if "course.grading.recording_process" in one.cmdline())
            held = Path(f"/proc/{process.pid}/fd")
            deadline = time.monotonic() + 30
            while len(list(held.iterdir())) > 4 and time.monotonic() < deadline:
                time.sleep(0.01)
            assert len(list(held.iterdir())) == 4  # nothing to read, its log twice, the socket
            assert process.children() == []
            process.kill()
            process.wait()
