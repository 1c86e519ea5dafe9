"""Recordings of every kind of event, and messages as ROS itself serializes them."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from course.evidence.home_files import HomeEntry
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.model import events as kinds
from course.model.events import Event
from course.model.feedback import Feedback, Location
from course.model.graph import Endpoint, Graph, Qos, Service
from course.rosenv import find_ros, node_environment, prepare

TIMEOUT = 120.0
STRING = "std_msgs/msg/String"
NUMBER = "std_msgs/msg/Int32"
ADD = "example_interfaces/srv/AddTwoInts"
HELLO = b"\0\1\0\0\6\0\0\0hello\0"
GRAPH = Graph(
    ("/listener", "/talker"),
    (
        Endpoint("/talk", "publisher", "/talker", STRING, "RIHS01_1", Qos()),
        Endpoint("/talk", "subscription", "", STRING, "RIHS01_1", Qos("best_effort", deadline=0.5)),
    ),
    (
        Service("/add", ADD, "RIHS01_2", "RIHS01_3", ("/adder",), ("/asker", "/robot/asker")),
        Service("/x", "a/srv/B"),
    ),
)

# At least one of each kind; some at the same moment, whose order must not change.
EVENTS: tuple[Event, ...] = (
    kinds.ProcessStarted(0.000000001, "talker", ("python3", "/lib/talker", "häufig")),
    kinds.ExecutableMissing(0.1, "walker", "talk", "walker", ("listener", "talker")),
    kinds.ExecutableMissing(0.1, "runner", "run", "runner", ()),
    kinds.GraphSeen(0.2, Graph()),
    kinds.GraphSeen(0.25, GRAPH),
    kinds.MessageSent(0.3, "/talk", STRING, HELLO),
    kinds.OutputLine(0.3, "talker", 'tab\t, "quotes", çà et là, 日本語 ✓, \ufffd'),
    kinds.MessageSeen(0.3, "/talk", STRING, HELLO),
    kinds.OutputLine(0.3, "talker", ""),
    kinds.MessageSeen(0.333333333, "/other", NUMBER, b""),
    kinds.Joined(0.4, "/talk", STRING, "subscription"),
    kinds.MessagesLost(0.5, "/talk", 3),
    kinds.MessagesCut(0.6, "/talk"),
    kinds.OutputCut(0.7, "talker", 10**12),
    kinds.ServiceCalled(0.75, "/add", ADD, "client", "1.0", "client 1", b"\0\1\0\0"),
    kinds.ServiceCalled(0.76, "/add", ADD, "server", "2.1", "", b"\xff"),
    kinds.ServiceAnswered(0.77, "/add", ADD, "client", "1.0", b""),
    kinds.ProcessLeft(0.78, "talker", 4711, ("python3", "häufig")),
    kinds.FileKept(0.8, "notes.txt", "one\ntwo\n"),
    kinds.FileKept(0.8, "lost.txt", None),
    kinds.Marked(0.9, "gave up: a message", "details"),
    kinds.Marked(0.9, "done"),
    kinds.Watched(0.91, True),
    kinds.Late(0.92, 0.0125),
    kinds.Watched(0.93, False),
    kinds.SignalSent(1.0, "talker", 2),
    kinds.LimitReached(1.05, "memory", 1024.0),
    kinds.ProcessExited(1.1, "talker", 1, None),
    kinds.ProgramMissing(1.1, "script", "python/script.py"),
    kinds.ShellPrompt(1.1, "bash", 127),
    kinds.ShellReady(1.1, "bash", ("bash: alias: =: not found",)),
    kinds.ShellRan(1.1, "bash", "say_hello", ("hello",), 0, 1.0),
    kinds.ShellRan(1.1, "bash", "sleep 100", (), None, 1.0),
    kinds.ShellStuck(1.1, "bash", "running", "sleep 100", ()),
    kinds.Drawn(1.1, 2**62 + 7),
    kinds.Acted(1.1, "greeted", "good evening"),
    kinds.Probed(1.1, "probe", ('{"question": "sum", "value": 3, "type": "int"}',), True),
    kinds.ProcessExited(1.2, "walker", None, 9),
)


@pytest.fixture
def recording() -> Recording:
    feedback = Feedback(
        "it failed", "a", "b", (Location("src/talk/setup.py", 3), Location("x")), "try", ("1",)
    )
    return Recording(
        "18-publisher",
        EVENTS,
        {STRING: "string data\n", "a/msg/Unused": "int32 x", NUMBER: "int32 data\n"},
        Sources({"src/talk/setup.py": "häufig\n"}, ("picture.png",)),
        BuiltPackages((BuiltPackage("talk", "src/talk", "/store/talk", ("talker",)),), feedback),
        1.5,
        (HomeEntry("a_folder", "folder", 0o755, 4096), HomeEntry("way", "link", target="/elsewhere")),
        local=False,
        scenario="abc",
    )


@dataclass(frozen=True)
class Sample:
    """A message as rclpy serialized it, with its text definition and its fields."""

    type: str
    data: bytes
    definition: str
    fields: dict[str, Any]


# Runs with ROS: serializes messages, and writes their fields as plain JSON.
SERIALIZE = Path(__file__).with_name("serialize.py")


def ros_python(script: Path, *arguments: str, **variables: str) -> str:
    """What a Python of this machine's ROS prints."""
    ros = find_ros()
    prepare(ros)
    environment = node_environment(ros)
    done = subprocess.run(
        [str(ros.python), str(script), *arguments],
        env={**environment, **variables, "PYTHONPATH": _path(environment)},
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def _path(environment: dict[str, str]) -> str:
    """The engine comes first, ROS after it."""
    return ":".join([str(Path(__file__).parents[2]), *filter(None, [environment.get("PYTHONPATH")])])


@pytest.fixture(scope="session")
def samples() -> dict[str, Sample]:
    """By name."""
    found = json.loads(ros_python(SERIALIZE))
    return {
        name: Sample(item["type"], bytes.fromhex(item["data"]), item["definition"], item["fields"])
        for name, item in found.items()
    }
