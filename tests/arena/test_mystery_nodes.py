"""A mystery's nodes: up when it says so, and gone when they should be, whatever happens."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path

import psutil
import pytest

from course.arena.mystery_module import MysteryJob
from course.arena.mystery_nodes import MysteryNodes, mystery_nodes, only_once
from course.errors import OurFault, UsageError
from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.processes import below, words_of

pytestmark = pytest.mark.slow

QUIET = """
def draw(seed):
    return f"quiet_{seed}"

def play(plan, acts):
    from rclpy.node import Node
    acts.record("made", plan)
    return [Node(plan)]
"""
STUCK = """
import threading

def draw(seed):
    return seed

def play(plan, acts):
    from rclpy.node import Node
    node = Node("stuck")

    def stick():
        acts.record("stuck")
        threading.Event().wait()

    node.create_timer(0.01, stick)
    return [node]
"""
Play = Callable[..., AbstractContextManager[MysteryNodes]]


@pytest.fixture
def environment() -> Iterator[dict[str, str]]:
    """In a ROS domain that nobody else uses."""
    with isolated(namespaces=False) as around:
        yield {**node_environment(find_ros()), **around.environment}


@pytest.fixture
def play(tmp_path: Path, environment: dict[str, str]) -> Iterator[Play]:
    lock = (tmp_path / "lock").open("a")

    def make(source: str = QUIET) -> AbstractContextManager[MysteryNodes]:
        file = tmp_path / "05-other.py"
        file.write_text(textwrap.dedent(source))
        job = MysteryJob(str(file), "05-other", 7, str(tmp_path / "acts.json"))
        return mystery_nodes(job, environment, lock.fileno())

    with lock:
        yield make


def players() -> set[int]:
    """Processes of mysteries below this one."""
    return {child.pid for child in below() if "course.arena.mystery_program" in words_of(child)}


def await_text(file: Path, text: str) -> None:
    deadline = time.monotonic() + 20
    while not (file.exists() and text in file.read_text()):
        assert time.monotonic() < deadline, f"{text} never came"
        time.sleep(0.02)


def test_nodes_come_up_and_end(play: Play, tmp_path: Path) -> None:
    with play():
        assert len(players()) == 1
        assert '"made"' in (tmp_path / "acts.json").read_text()
    assert players() == set()


IDLE = """
def draw(seed):
    return seed

def play(plan, acts):
    from rclpy.node import Node
    from std_srvs.srv import Trigger
    for name in ("answers", "silent"):
        node = Node(name, start_parameter_services=False)
        node.create_service(Trigger, f"/{name}", lambda request, response: response)
        if name == "silent":
            acts.idle(node)
        else:
            spun = [node]
    import gc
    del node
    gc.collect()
    return spun
"""
CALL = """
import rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("caller")
for name, seconds in (("answers", 20.0), ("silent", 1.0)):
    client = node.create_client(Trigger, f"/{name}")
    there = client.wait_for_service(20.0)
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=seconds)
    print(name, there, future.done())
"""


def test_an_idle_node_is_there_and_does_not_answer(play: Play, environment: dict[str, str]) -> None:
    with play(IDLE):
        done = subprocess.run(
            [sys.executable, "-c", CALL],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
            timeout=60,
        )
    assert done.stdout.splitlines() == ["answers True True", "silent True False"]


def test_a_node_that_hangs_ends_within_three_seconds(play: Play, tmp_path: Path) -> None:
    playing = play(STUCK)
    playing.__enter__()
    await_text(tmp_path / "acts.json", "stuck")
    began = time.monotonic()
    playing.__exit__(None, None, None)
    assert time.monotonic() - began < 5  # three, and the machine may be busy
    assert players() == set()


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("def draw(seed): return 1\ndef play(plan, acts): raise ValueError('no lamp')", "no lamp"),
        ("def draw(seed): return 1 / 0\ndef play(plan, acts): ...", "ZeroDivisionError"),
        ("def draw(seed): return 1\ndef play(plan, acts): ...", "must return the nodes"),
        ("def draw(seed): return 1\ndef play(plan, acts): return []", "must return the nodes"),
    ],
)
def test_nodes_that_do_not_come_up_are_our_fault(play: Play, source: str, words: str) -> None:
    with pytest.raises(OurFault, match="could not be started") as caught, play(source):
        pass
    assert words in caught.value.what
    assert players() == set()


def test_nodes_that_end_by_themselves_are_our_fault(play: Play) -> None:
    with play() as playing:
        (player,) = players()
        os.kill(player, signal.SIGKILL)
        with pytest.raises(OurFault, match="ended by themselves"):
            playing.wait()


PARENT = """
import os, sys
from pathlib import Path
from course.arena.mystery_module import MysteryJob
from course.arena.mystery_nodes import mystery_nodes
from course.rosenv import find_ros, node_environment
environment = {**node_environment(find_ros()), "ROS_DOMAIN_ID": os.environ["ROS_DOMAIN_ID"]}
job = MysteryJob(sys.argv[1], "05-other", 7, sys.argv[3])
with open(sys.argv[2], "a") as lock, mystery_nodes(job, environment, lock.fileno()) as playing:
    print(playing._process.pid, flush=True)
    playing.wait()
"""


@pytest.mark.parametrize("source", [QUIET, STUCK], ids=["quiet", "stuck"])
def test_nodes_end_when_their_parent_is_killed(
    tmp_path: Path, environment: dict[str, str], source: str
) -> None:
    file = tmp_path / "05-other.py"
    file.write_text(source)
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, str(file), str(tmp_path / "lock"), str(tmp_path / "acts.json")],
        env={**os.environ, "ROS_DOMAIN_ID": environment["ROS_DOMAIN_ID"]},
        stdout=subprocess.PIPE,
        text=True,
    )
    player = psutil.Process(int(parent.stdout.readline()))
    await_text(tmp_path / "acts.json", "stuck" if source is STUCK else "made")
    parent.kill()
    parent.wait()
    parent.stdout.close()
    player.wait(timeout=30)


def test_only_once(tmp_path: Path) -> None:
    with only_once(tmp_path / "play/05.lock", "05-keepers"):
        with pytest.raises(UsageError, match="05-keepers is already running"):
            only_once(tmp_path / "play/05.lock", "05-keepers").__enter__()
        with only_once(tmp_path / "play/06.lock", "06-other"):
            pass
    with only_once(tmp_path / "play/05.lock", "05-keepers"):
        pass
