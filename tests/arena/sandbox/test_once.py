"""One command in namespaces of its own: it begins when it is known, and ends with all that it started."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena.sandbox import once
from course.arena.sandbox.limits import Limits
from course.arena.sandbox.once import Confinement, confinement, once_obstacle
from course.errors import OurFault
from course.rosenv import Ros

OBSTACLE = once_obstacle()
needs_bubblewrap = pytest.mark.skipif(OBSTACLE is not None, reason=f"not exercised here: {OBSTACLE}")
ROS = Ros("pip", "jazzy", Path(sys.prefix), Path(sys.executable), "test")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "own").mkdir()
    return tmp_path / "own"


@pytest.fixture
def place(folder: Path) -> Iterator[Confinement]:
    with confinement(ROS, {"PATH": os.defpath}, folder, [folder], (), Limits(processes=40)) as found:
        yield found


def said(place: Confinement, script: str) -> str:
    with place.entrance() as (prefix, descriptors):
        command = [*prefix, "/bin/sh", "-c", script]
        done = subprocess.run(command, pass_fds=descriptors, capture_output=True, text=True, timeout=30)
    return done.stdout + done.stderr


@needs_bubblewrap
def test_each_command_has_an_entrance_of_its_own(place: Confinement, folder: Path) -> None:
    assert said(place, "pwd") == f"{folder}\n"
    assert said(place, "echo $$; head -1 /etc/passwd").splitlines()[1] == "root:x:0:0:root:/root:/bin/bash"


@needs_bubblewrap
def test_limits_hold(place: Confinement) -> None:
    values = said(place, "ulimit -n; ulimit -c; ulimit -f").split()
    assert values == [str(Limits().files), "0", str(Limits().file // 512)]


@needs_bubblewrap
def test_a_command_that_never_begins_is_no_harm(place: Confinement) -> None:
    with place.entrance() as (prefix, _):
        assert prefix


@needs_bubblewrap
def test_what_does_not_end_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    child = subprocess.Popen(["sleep", "60"])
    descriptor = os.pidfd_open(child.pid)
    monkeypatch.setattr(once.signal, "pidfd_send_signal", lambda *_: None)
    monkeypatch.setattr(once, "_END_TIMEOUT", 0.1)
    with pytest.raises(OurFault, match="do not end"):
        once._end(descriptor)
    child.kill()
    child.wait()


def test_without_bubblewrap_there_is_none(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(once, "unless_known", lambda *_: "there is none")
    with confinement(ROS, {}, folder, [folder], (), Limits()) as place, place.entrance() as (prefix, given):
        assert (prefix, given, place.who.user) == ((), (), None)


def test_a_missing_program_is_an_obstacle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(once, "bwrap", lambda: "/no/such/bwrap")
    assert "does not start" in (once_obstacle() or "")
