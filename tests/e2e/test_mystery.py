"""A mystery from `play` to the pass, on a pseudo-terminal and on real ROS."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pexpect
import psutil
import pytest

from course.arena.mystery_module import load_mystery, seed_for
from course.home import CourseHome
from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.e2e.conftest import COMMAND
from tests.processes import words_of

pytestmark = pytest.mark.slow

FIXTURE = Path(__file__).parents[1] / "fixtures/quiz_course"
KEEPERS = FIXTURE / "chapters/05-lighthouses/play/05-keepers.py"
STYLING = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
Start = Callable[..., "pexpect.spawn[str]"]

# A learner with the ROS tools: hears the lamp, greets the keeper.
LEARNER = """
import sys, time
import rclpy
from std_msgs.msg import Int32, String
rclpy.init()
node = rclpy.create_node("learner")
voice = node.create_publisher(String, sys.argv[2], 10)
heard = []
node.create_subscription(Int32, sys.argv[1], heard.append, 10)
end = time.monotonic() + 20
# The names of nodes travel apart from their topics, and may come later.
def all_known():
    return heard and voice.get_subscription_count() and len(node.get_node_names()) >= 3
while time.monotonic() < end and not all_known():
    rclpy.spin_once(node, timeout_sec=0.1)
voice.publish(String(data=sys.argv[3]))
voice.wait_for_all_acked()
print(len(heard) > 0, sorted(node.get_node_names()))
"""


@pytest.fixture
def domain() -> Iterator[Mapping[str, str]]:
    """A ROS domain that nobody else uses, so that only the mystery is there."""
    with isolated(namespaces=False) as around:
        yield around.environment


@pytest.fixture
def start(environment: dict[str, str], domain: Mapping[str, str], guarded_home: Path) -> Iterator[Start]:
    running: list[pexpect.spawn[str]] = []

    def run(*words: str) -> pexpect.spawn[str]:
        child = pexpect.spawn(
            COMMAND[0],
            [*COMMAND[1:], "--course", str(FIXTURE), *words],
            env={**environment, **domain, "TERM": "xterm", "NO_COLOR": "1"},
            cwd=str(guarded_home),
            dimensions=(24, 80),
            encoding="utf-8",
            timeout=60,
        )
        running.append(child)
        return child

    run("next", "05-keepers").expect(pexpect.EOF)
    yield run
    for child in running:
        child.close(force=True)


@pytest.fixture
def plan(start: Start, course_home: Path) -> Any:
    return load_mystery(KEEPERS).draw(seed_for("05-keepers", CourseHome(course_home).seed()))


def explore(plan: Any, domain: Mapping[str, str], words: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", LEARNER, plan.topic, plan.ears, words],
        env={**node_environment(find_ros()), **domain},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return done.stdout


def ended(child: pexpect.spawn[str]) -> tuple[str, int | None]:
    shown = STYLING.sub("", child.read())
    child.close()
    return shown, child.exitstatus


def nodes_below(child: pexpect.spawn[str]) -> list[psutil.Process]:
    children = psutil.Process(child.pid).children(recursive=True)
    return [process for process in children if "course.arena.mystery_program" in words_of(process)]


def test_from_play_to_the_pass(start: Start, domain: Mapping[str, str], plan: Any) -> None:
    play = start("play")
    play.expect("05-keepers is running. Ctrl[+]C ends it.")
    play.expect("Type next:")
    (nodes,) = nodes_below(play)

    shown, code = ended(start("play"))
    assert (code, "05-keepers is already running." in shown) == (2, True)

    assert explore(plan, domain, "good moaning") == f"True {sorted(['learner', plan.lamp, plan.keeper])}\n"
    check = start("check")
    for typed in (f"{plan.rate:g} Hz", "std_msgs/msg/Int32", f"{plan.ears} {plan.mouth}", plan.lamp):
        check.expect("Your answer[^\r\n]*: ")
        check.sendline(typed)
    check.expect("Your answer[^\r\n]*: ")
    check.sendline("ros2 topic echo")
    shown, code = ended(check)
    assert code == 1
    assert "Not passed yet: 5 of 6 points" in shown
    assert "The keeper has not heard `good evening`" in shown and "good moaning" in shown

    explore(plan, domain, "Good evening")
    play.sendintr()
    shown, code = ended(play)
    assert code == 0
    assert "The nodes have ended." in shown and "Traceback" not in shown
    nodes.wait(timeout=3)

    shown, code = ended(start("check"))
    assert (code, "Passed: 6 of 6 points" in shown) == (0, True)


def test_nodes_end_with_a_killed_play(start: Start) -> None:
    play = start("play")
    play.expect("is running")
    (nodes,) = nodes_below(play)
    play.kill(9)
    nodes.wait(timeout=30)
    again = start("play")
    again.expect("05-keepers is running[.] Ctrl")
    again.sendintr()
    assert ended(again)[1] == 0


def test_a_closed_terminal_ends_them_too(start: Start) -> None:
    play = start("play")
    play.expect("is running")
    (nodes,) = nodes_below(play)
    play.close(force=False)
    nodes.wait(timeout=30)


def test_nothing_on_the_machine_shows_the_seed(start: Start, course_home: Path) -> None:
    seed = CourseHome(course_home).seed()
    play = start("play")
    play.expect("Type next:")
    (nodes,) = nodes_below(play)
    told = " ".join([*nodes.cmdline(), *nodes.environ().values(), play.before])
    assert str(seed) not in told
    assert str(seed_for("05-keepers", seed)) not in told
    play.sendintr()
    ended(play)
