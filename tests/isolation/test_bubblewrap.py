"""One command in its own namespaces: it starts once it is known, and ends with all that it started."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from course import isolation
from course.errors import OurFault
from course.isolation import IsolationPlan, Level, bubblewrap, levels, none
from course.isolation.bubblewrap import build_obstacle, restriction
from course.isolation.isolation_plan import ResourceLimits
from course.isolation.levels import isolated_build
from course.rosenv import Ros

OBSTACLE = build_obstacle()
needs_bubblewrap = pytest.mark.skipif(OBSTACLE is not None, reason=f"not exercised here: {OBSTACLE}")
ROS = Ros("pip", "jazzy", Path(sys.prefix), Path(sys.executable), "test")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "own").mkdir()
    return tmp_path / "own"


@pytest.fixture
def plan(folder: Path) -> Iterator[IsolationPlan]:
    with isolated_build(ROS, {"PATH": os.defpath}, [folder], (), ResourceLimits(processes=40)) as found:
        assert found is not None
        yield found


def said(plan: IsolationPlan | None, script: str, folder: Path) -> str:
    """What the script prints, in the folder."""
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "cwd": folder}
    with isolation.start(plan, ["/bin/sh", "-c", script], **pipes) as started:
        printed, _ = started.process.communicate(timeout=30)
        assert started.saw_the_end()
    return printed.decode()


@needs_bubblewrap
def test_each_command_is_in_its_folder_and_a_user_without_a_name(plan: IsolationPlan, folder: Path) -> None:
    assert said(plan, "pwd", folder) == f"{folder}\n"
    assert said(plan, "head -1 /etc/passwd", folder) == "root:x:0:0:root:/root:/bin/bash\n"


@needs_bubblewrap
def test_limits_hold(plan: IsolationPlan, folder: Path) -> None:
    values = said(plan, "ulimit -n; ulimit -c; ulimit -f", folder).split()
    assert values == [str(ResourceLimits().files), "0", str(ResourceLimits().file // 512)]


@needs_bubblewrap
def test_a_command_that_cannot_begin_is_no_harm(plan: IsolationPlan, folder: Path) -> None:
    with pytest.raises(OSError), isolation.start(plan, ["/bin/true"], cwd=folder / "nowhere"):
        pass


@pytest.mark.parametrize("kept_apart", [pytest.param(True, marks=needs_bubblewrap), False])
def test_with_and_without_isolation_a_session_ends(
    kept_apart: bool, folder: Path, request: pytest.FixtureRequest
) -> None:
    """Both implementations promise that."""
    plan = request.getfixturevalue("plan") if kept_apart else None
    reading, writing = os.pipe()
    with isolation.start(plan, ["/bin/sh", "-c", "sleep 77 & echo up; wait"], stdout=writing) as started:
        os.close(writing)
        assert os.read(reading, 10) == b"up\n"
    assert started.process.returncode != 0
    assert os.read(reading, 10) == b""  # the process that held the other end has ended
    os.close(reading)


@needs_bubblewrap
@pytest.mark.parametrize("script", ["exit 3", "kill -9 $$", "kill -9 1; kill -9 -1; exit 3", "echo 0 >&2"])
def test_what_a_command_does_to_itself_is_seen(plan: IsolationPlan, script: str, folder: Path) -> None:
    """Nothing inside can kill the first process, and the command does not see its output."""
    assert "Killed" not in said(plan, script, folder)
    assert re.fullmatch(r"(0 1 2 \d+\n)", said(plan, "echo $(ls /proc/self/fd)", folder))


@needs_bubblewrap
@pytest.mark.parametrize("which", ["bubblewrap", "first"])
def test_a_process_of_ours_that_was_killed_is_told_from_a_command_that_failed(
    plan: IsolationPlan, which: str
) -> None:
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with isolation.start(plan, ["/bin/sh", "-c", "echo up; cat"], **pipes) as started:
        process = started.process
        assert process.stdout is not None and process.stdout.readline() == b"up\n"
        ours = psutil.Process(process.pid)
        (ours if which == "bubblewrap" else ours.children()[0]).kill()
        assert process.wait(30) != 0
        assert not started.saw_the_end()


@needs_bubblewrap
def test_what_does_not_end_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    child = subprocess.Popen(["sleep", "60"])
    descriptor = os.pidfd_open(child.pid)
    monkeypatch.setattr(bubblewrap.signal, "pidfd_send_signal", lambda *_: None)
    monkeypatch.setattr(bubblewrap, "_END_TIMEOUT", 0.1)
    with pytest.raises(OurFault, match="do not end"):
        bubblewrap._end(descriptor)
    child.kill()
    child.wait()


def test_without_bubblewrap_there_is_no_plan(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(levels, "unless_known", lambda *_: "there is none")
    with isolated_build(ROS, {}, [folder], (), ResourceLimits()) as plan:
        assert plan is None
    assert said(None, "pwd; echo 0 >&2", folder) == f"{folder}\n0\n"


def test_another_isolation_takes_its_place(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is one module with these functions, and its name in one line."""
    monkeypatch.setenv("ROS2COURSE_CACHE", str(folder))
    monkeypatch.setattr(isolation, "ISOLATION", none)
    with levels.isolated(levels.MachinePlaces()) as where:
        assert (where.level, where.missing) == (Level.DOMAIN, "there is no isolation")
    assert said(IsolationPlan(), "echo $$ $PPID; pwd", folder).endswith(f" {os.getpid()}\n{folder}\n")


def test_a_missing_program_is_an_obstacle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bubblewrap, "program", lambda: "/no/such/bwrap")
    assert "does not start" in (build_obstacle() or "")


def test_only_one_module_names_the_program() -> None:
    """Another isolation is written beside it, and nothing else changes."""
    engine = Path(isolation.__file__).parents[1]
    naming = [file for file in engine.rglob("*.py") if "bwrap" in file.read_text(encoding="utf-8")]
    assert naming == [Path(bubblewrap.__file__)]


APPARMOR = "kernel/apparmor_restrict_unprivileged_userns"
CLONE = "kernel/unprivileged_userns_clone"
MOST = "user/max_user_namespaces"


def settings(folder: Path, **values: str) -> Path:
    for name, value in values.items():
        file = folder / {"apparmor": APPARMOR, "clone": CLONE, "most": MOST}[name]
        file.parent.mkdir(exist_ok=True)
        file.write_text(value)
    return folder


@pytest.mark.parametrize(
    ("values", "named", "step"),
    [
        ({"apparmor": "1\n", "clone": "1", "most": "9"}, "AppArmor", "apparmor_parser -r"),
        ({"apparmor": "0", "clone": "0\n"}, "unprivileged_userns_clone is 0", "userns_clone=1"),
        ({"most": "0"}, "max_user_namespaces is 0", "max_user_namespaces=15000"),
    ],
)
def test_each_is_named_with_its_remedy(tmp_path: Path, values: dict[str, str], named: str, step: str) -> None:
    found = restriction(settings(tmp_path, **values))
    assert found is not None
    assert named in found.what
    assert step in found.step


@pytest.mark.parametrize(
    "values", [{}, {"apparmor": "0", "clone": "1", "most": "60000"}, {"most": "rubbish"}]
)
def test_a_machine_that_allows_it_has_none(tmp_path: Path, values: dict[str, str]) -> None:
    assert restriction(settings(tmp_path, **values)) is None
