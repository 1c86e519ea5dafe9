"""What a scenario can do, without ROS: the recorder is a fake."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

import pytest

from course.arena.arena import Arena
from course.arena.home_programs import Surroundings
from course.errors import OurFault
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import ROSOUT, ROSOUT_TYPE
from course.evidence.sources import MAX_FILE
from course.evidence.timeline import Timeline
from course.model.events import (
    Event,
    ExecutableMissing,
    FileKept,
    Marked,
    MessageSeen,
    OutputLine,
    ProcessExited,
    ProcessLeft,
    SignalSent,
)

from .conftest import WAIT

DEAF = (
    "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nprint('deaf', flush=True)\nsignal.pause()\n"
)


@dataclass
class NoRecorder:
    timeline: Timeline = field(default_factory=Timeline)


@dataclass
class Play:
    arena: Arena
    prefix: Path

    def events(self, kind: type[Event]) -> list[Any]:
        return list(self.arena.timeline.of(kind))

    def install(self, name: str, program: str) -> None:
        file = self.prefix / "lib" / "talk" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"#!/usr/bin/env python3\n{program}")


@pytest.fixture
def play(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Play]:
    # All descendants of pytest itself would be ended.
    monkeypatch.setattr("course.arena.arena.end_descendants", lambda: 0)
    prefix = tmp_path / "prefix"
    prefix.mkdir()
    packages = BuiltPackages((BuiltPackage("talk", "src/talk", str(prefix), ("talker", "listener")),))
    folder = tmp_path / "scratch"
    folder.mkdir()
    environment = {"PATH": "/usr/bin:/bin", "GIVEN": "from the environment", "HOME": "/nowhere"}
    arena = Arena(cast(Any, NoRecorder()), packages, Surroundings(environment, sys.executable, folder))
    yield Play(arena, prefix)
    arena.close()


def test_an_executable_is_run_as_ros2_run_would(play: Play) -> None:
    play.install("talker", "import sys\nprint('hello', *sys.argv[1:])\n")
    program = play.arena.run("talk", "talker", "--ros-args", "x")
    assert program.wait(WAIT)
    assert [line.text for line in play.events(OutputLine)] == ["hello --ros-args x"]
    assert program.name == "talker"


def test_an_executable_that_is_not_there_is_recorded(play: Play) -> None:
    assert play.arena.run("talk", "walker", name="it") is None
    (missing,) = play.events(ExecutableMissing)
    assert (missing.process, missing.package, missing.executable) == ("it", "talk", "walker")
    assert missing.available == ("talker", "listener")


def test_a_package_that_is_not_the_exercises_is_our_fault(play: Play) -> None:
    with pytest.raises(OurFault, match=r"`tlak`, which is not among the exercise's packages.*`talk`\?"):
        play.arena.run("tlak", "talker")


def test_two_programs_of_one_name_are_our_fault(play: Play) -> None:
    play.arena.start("true", name="it")
    with pytest.raises(OurFault, match="it"):
        play.arena.start("true", name="it")


def test_home_and_logs_are_in_the_scratch_folder(play: Play, tmp_path: Path) -> None:
    program = play.arena.start("sh", "-c", "env; pwd", name="it", env={"EXTRA": "from the scenario"})
    assert program.wait(WAIT)
    lines = [line.text for line in play.events(OutputLine)]
    scratch = tmp_path / "scratch"
    for wanted in (
        f"HOME={scratch}/home",
        f"TMPDIR={scratch}",
        f"ROS_LOG_DIR={scratch}/log",
        "GIVEN=from the environment",
        "EXTRA=from the scenario",
        "PYTHONDONTWRITEBYTECODE=1",
        "ROS2COURSE_ARENA=1",
        f"{scratch}/home",
    ):
        assert wanted in lines


def test_parameters_remaps_and_a_name_for_its_nodes(play: Play) -> None:
    play.install("talker", "import sys\nprint(*sys.argv[1:], sep='|')\n")
    program = play.arena.run(
        "talk", "talker", "more", params={"quote": "1"}, remaps={"a": "b"}, node_name="other"
    )
    assert program.wait(WAIT)
    (line,) = play.events(OutputLine)
    assert line.text == 'more|--ros-args|-p|quote:="1"|-r|a:=b|-r|__node:=other'


def test_a_launch_file_is_started_as_ros2_launch_does(play: Play, tmp_path: Path) -> None:
    command = tmp_path / "bin" / "ros2"
    command.parent.mkdir()
    command.write_text('#!/bin/sh\necho "$@"\n')
    command.chmod(0o755)
    path = f"{command.parent}:/usr/bin:/bin"
    given = Surroundings({"PATH": path}, sys.executable, tmp_path)
    arena = Arena(cast(Any, NoRecorder()), BuiltPackages(), given)
    program = arena.launch("talk", "talk_launch.py", speed="2 m/s")
    assert program.wait(WAIT)
    assert program.name == "talk_launch.py"
    (line,) = arena.timeline.of(OutputLine)
    assert line.text == "launch talk talk_launch.py speed:=2 m/s"


# waiting


def test_until_ends_as_soon_as_the_condition_holds(play: Play) -> None:
    program = play.arena.start("sh", "-c", "echo ready; read line", name="it")
    assert play.arena.until(lambda: play.arena.printed("ready"), timeout=WAIT, while_running=program)
    assert program.running


def test_until_ends_with_the_program(play: Play) -> None:
    program = play.arena.start("true", name="it")
    began = time.monotonic()
    assert not play.arena.until(lambda: False, timeout=WAIT, while_running=program)
    assert time.monotonic() - began < WAIT / 2


def test_until_sees_what_the_program_wrote_last(play: Play) -> None:
    program = play.arena.start("sh", "-c", "printf last", name="it")
    assert play.arena.until(lambda: play.arena.printed("last"), timeout=WAIT, while_running=program)


@dataclass
class Speaker:
    """A fake publisher: what it says comes back as a printed line, unless it is `silence`."""

    timeline: Timeline
    said: list[str] = field(default_factory=list)

    def publish(self, data: str) -> None:
        self.said.append(data)
        if data != "silence":
            self.timeline.add(OutputLine(self.timeline.now(), "echo", data))


def test_say_waits_for_each_answer_but_not_for_long(play: Play) -> None:
    speaker = Speaker(play.arena.timeline)
    asked: list[tuple[str, int]] = []

    def is_answered(fields: Mapping[str, Any]) -> bool:
        asked.append((fields["data"], len(speaker.said)))
        return bool(play.arena.printed(fields["data"]))

    messages = [{"data": text} for text in ("a", "silence", "b")]
    began = time.monotonic()
    play.arena.say(cast("Any", speaker), messages, is_answered)
    assert 1.0 <= time.monotonic() - began < WAIT
    assert speaker.said == ["a", "silence", "b"]
    assert {("a", 1), ("silence", 2), ("b", 3)} == set(asked)


def test_say_ends_with_the_program(play: Play) -> None:
    speaker = Speaker(play.arena.timeline)
    program = play.arena.start(sys.executable, "-c", "pass", name="brief")
    assert program.wait(WAIT)
    play.arena.say(cast("Any", speaker), [{"data": "a"}], lambda _: True, while_running=program)
    assert speaker.said == []


def test_until_gives_up(play: Play) -> None:
    assert not play.arena.until(lambda: False, timeout=0.05)
    assert play.events(Marked) == []


TEXTS = (b"selten\0", "so häufig\0".encode(), b"selten.py\0")


def test_printed_and_logged_count(play: Play) -> None:
    line: Callable[[str], OutputLine] = lambda text: OutputLine(0.0, "it", text)  # noqa: E731
    for event in (line("Printed 1"), line("Printed 2"), line("other")):
        play.arena.timeline.add(event)
    # As ROS serializes a Log: encapsulation, stamp and level, then name, msg, file.
    texts = (len(text).to_bytes(4, "little") + text.ljust(-(-len(text) // 4) * 4, b"\0") for text in TEXTS)
    logged = b"\0\1\0\0" + bytes(12) + b"".join(texts)
    for topic in (ROSOUT, "/other"):
        play.arena.timeline.add(MessageSeen(0.0, topic, ROSOUT_TYPE, logged))
    assert play.arena.printed("Printed") == 2
    assert play.arena.logged("häufig") == 1
    assert play.arena.logged("selten") == 0


# ending


def test_interrupt_waits_for_the_end(play: Play) -> None:
    play.install("talker", "import signal\nprint('ready', flush=True)\nsignal.pause()\n")
    program = play.arena.run("talk", "talker")
    assert play.arena.until(lambda: play.arena.printed("ready"), timeout=WAIT)
    play.arena.interrupt(program, grace=WAIT)
    assert [sent.signal for sent in play.events(SignalSent)] == [signal.SIGINT]
    assert len(play.events(ProcessExited)) == 1
    assert play.events(Marked) == []


def test_a_deaf_program_is_marked_and_killed(play: Play) -> None:
    play.install("talker", DEAF)
    program = play.arena.run("talk", "talker")
    assert play.arena.until(lambda: play.arena.printed("deaf"), timeout=WAIT)
    play.arena.interrupt(program, grace=0.1)
    assert [mark.name for mark in play.events(Marked)] == ["ignored Ctrl+C: talker"]
    assert play.events(ProcessExited)[0].signal == signal.SIGKILL


@pytest.mark.slow
def test_what_a_program_leaves_running_is_recorded(play: Play) -> None:
    # It is ready when it sleeps: then it has its own session, which Ctrl+C does not reach.
    left_behind = "setsid sleep 100 & until grep -qx sleep /proc/$!/comm; do :; done; echo ready; wait"
    program = play.arena.start("sh", "-c", left_behind, name="it")
    assert play.arena.until(lambda: play.arena.printed("ready"), timeout=WAIT)
    play.arena.interrupt(program, grace=WAIT)
    (left,) = play.events(ProcessLeft)
    os.kill(left.pid, signal.SIGKILL)
    assert (left.process, left.command) == ("it", ("sleep", "100"))


def test_interrupting_what_never_ran_does_nothing(play: Play) -> None:
    play.arena.interrupt(None)
    assert play.arena.timeline.events() == ()


def test_close_ends_all_and_tells_that_it_was_us(play: Play) -> None:
    play.arena.start("sleep", "100", name="one")
    play.arena.start("sleep", "100", name="two")
    play.arena.close()
    assert {(end.process, end.signal) for end in play.events(ProcessExited)} == {("one", 9), ("two", 9)}
    assert {(sent.process, sent.signal) for sent in play.events(SignalSent)} == {("one", 9), ("two", 9)}


# files


def test_an_installed_file_is_kept(play: Play) -> None:
    (play.prefix / "share").mkdir()
    (play.prefix / "share" / "notes").write_bytes(b"caf\xe9\n")
    play.arena.keep("talk", "share/notes")
    assert [(kept.name, kept.text) for kept in play.events(FileKept)] == [("share/notes", "caf\ufffd\n")]


@pytest.mark.parametrize(("package", "file"), [("talk", "share/notes"), ("walk", "share"), ("talk", ".")])
def test_what_is_not_there_is_kept_as_nothing(play: Play, package: str, file: str) -> None:
    play.arena.keep(package, file)
    assert [kept.text for kept in play.events(FileKept)] == [None]


def test_of_a_huge_file_the_beginning_is_kept(play: Play) -> None:
    with (play.prefix / "huge").open("wb") as stream:
        stream.truncate(10**10)
    play.arena.keep("talk", "huge")
    assert len(play.events(FileKept)[0].text) == MAX_FILE
