"""Recording processes are forks of one process: nothing of one recording gets into the next."""

from __future__ import annotations

import contextlib
import json
import re
import time
from pathlib import Path
from typing import Any

import psutil
import pytest

from course.grading.protocol import RecordingTask
from course.grading.supervisor import ForkServer, Supervisor
from course.isolation.levels import isolated
from course.model import replace
from course.rosenv import find_ros, node_environment

from .conftest import GRADER, lay_toy

pytestmark = pytest.mark.slow

# Leaves as much as it can, and tells what it finds.
FINDS = """
    import ctypes, json, os, random, rclpy, secrets, sys, tempfile
    import course.model.codec as ours
    numbers = [n for n in os.listdir("/proc/self/fd") if os.path.exists(f"/proc/self/fd/{n}")]
    context = rclpy.Context()
    rclpy.init(context=context, domain_id=77)
    node = rclpy.create_node(f"found{os.getpid()}", context=context)
    rosout = node.get_publishers_info_by_topic("/rosout")
    own = next(bytes(one.endpoint_gid).hex() for one in rosout if one.node_name == node.get_name())
    found = {
        "state": {
            "attribute": getattr(ours, "left", None),
            "module": "left" in sys.modules,
            "path": "/left" in sys.path,
            "folder": os.getcwd(),
        },
        "environment": os.environ.get("LEFT"),
        "descriptors": [os.readlink(f"/proc/self/fd/{n}") for n in numbers],
        "drawn": [random.random(), secrets.token_hex(8), next(tempfile._get_candidate_names()), own],
        "dumpable": ctypes.CDLL(None).prctl(3, 0, 0, 0, 0),
    }
    node.destroy_node()
    context.shutdown()
    ours.left, sys.modules["left"], os.environ["LEFT"] = 1, sys, "1"
    sys.path.append("/left")
    os.chdir("/dev")
    kept = os.memfd_create("left")
    random.seed(1)
    os.write(int(sys.argv[1]), json.dumps({"kind": "stage", "text": json.dumps(found)}).encode() + b"\\n")
"""
TELLS = GRADER.replace("def run_it(arena):", f"def run_it(arena):{FINDS}")
PROGRAM = "import time\nprint('go', flush=True)\nwhile True: time.sleep(1)"
Found = dict[str, Any]


@pytest.fixture(scope="module", params=["namespaces", "domain"])
def found(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Found, Found]:
    """What two recordings, forks of one process, find: the second one of the first, too."""
    job = lay_toy(tmp_path_factory.mktemp("toy"), PROGRAM, TELLS)
    namespaces, environment = request.param == "namespaces", node_environment(find_ros())
    with contextlib.closing(ForkServer()) as fork_server:
        fork_server.start(environment)
        first = record(job, fork_server, namespaces, {**environment, "LEFT": "of the first"})
        return first, record(job, fork_server, namespaces, environment)


def record(
    job: RecordingTask, fork_server: ForkServer, namespaces: bool, environment: dict[str, str]
) -> Found:
    said: list[str] = []
    with isolated(namespaces=namespaces) as where:
        task = replace(job, environment={**job.environment, **where.environment})
        with Supervisor(where, environment, fork_server) as supervisor:
            outcome = supervisor.record(task, 60.0, said.append)
    assert outcome.fault is None, outcome.fault
    told: Found = json.loads(next(text for text in said if text.startswith("{")))
    return told


def test_its_state_is_as_if_it_were_the_first(found: tuple[Found, Found]) -> None:
    fresh = {"attribute": None, "module": False, "path": False, "folder": "/"}
    assert [one["state"] for one in found] == [fresh, fresh]


def test_its_environment_is_its_own(found: tuple[Found, Found]) -> None:
    assert [one["environment"] for one in found] == ["of the first", None]


def test_it_holds_no_descriptor_of_another(found: tuple[Found, Found]) -> None:
    first, second = map(descriptors, found)
    assert first == second
    assert not any("left" in link for link in found[1]["descriptors"])


def descriptors(told: Found) -> list[str]:
    """What kind each is of. Not Fast DDS's own files: its threads open and close them at any time."""
    links = [link for link in told["descriptors"] if "fastrtps" not in link]
    return sorted(re.sub(r"\d+|/tmp/.*", "", link) for link in links)


def test_it_draws_other_numbers_names_and_endpoints(found: tuple[Found, Found]) -> None:
    first, second = (one["drawn"] for one in found)
    assert len(first) == 4 and not set(first) & set(second)


def test_no_program_reads_its_memory(found: tuple[Found, Found]) -> None:
    assert [one["dumpable"] for one in found] == [0, 0]


def started() -> psutil.Process:
    """The child that recordings are forked from. At the moment it is loaded, it has no command line."""
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        for child in psutil.Process().children():
            with contextlib.suppress(psutil.Error):  # another one that has just ended
                if "course.grading.recording_process" in child.cmdline():
                    return child
        time.sleep(0.01)
    raise AssertionError("nothing to fork from was started")


def test_who_is_forked_from_keeps_nothing_and_is_replaced_when_killed() -> None:
    environment = node_environment(find_ros())
    with contextlib.closing(ForkServer()) as fork_server:
        for _ in range(2):
            with isolated() as where, Supervisor(where, environment, fork_server):
                process = started()
            held = Path(f"/proc/{process.pid}/fd")
            deadline = time.monotonic() + 30
            while len(list(held.iterdir())) > 4 and time.monotonic() < deadline:
                time.sleep(0.01)
            assert len(list(held.iterdir())) == 4  # nothing to read, its log twice, the socket
            assert process.children() == []
            process.kill()
            process.wait()
