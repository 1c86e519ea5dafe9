"""Control groups, in trees of ordinary folders: both versions, and machines without them."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.isolation import identity as module
from course.isolation.identity import (
    control_groups,
    cpu_seconds,
    join,
    memory_kills,
    refused_processes,
)
from course.isolation.isolation_plan import ResourceLimits

NOBODY = int(Path("/proc/sys/kernel/pid_max").read_text()) + 1
LIMITS = ResourceLimits(memory=1000, processes=7)
FILES_1 = {
    "memory": ("memory.limit_in_bytes", "memory.kmem.tcp.limit_in_bytes"),
    "pids": ("pids.max",),
    "cpu": ("cpu.shares",),
    "cpuacct": (),
}
FILES_2 = ("memory.max", "memory.swap.max", "pids.max", "cpu.weight")


@pytest.fixture(autouse=True)
def own_group(monkeypatch: pytest.MonkeyPatch) -> None:
    """The test's process is in the root of every tree."""
    monkeypatch.setattr(module, "_own_groups", lambda: {})


@pytest.fixture
def kernel(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A group comes with its files, and goes with them."""
    make, remove = Path.mkdir, Path.rmdir

    def make_group(folder: Path, *given: int, **named: bool) -> None:
        make(folder, *given, **named)
        if folder.name.startswith("ros2course-"):
            for name in FILES_1.get(folder.parent.name, FILES_2):
                (folder / name).write_text("max")
            (folder / "cgroup.procs").write_text("")

    def remove_group(folder: Path) -> None:
        for file in folder.iterdir():
            file.unlink()
        remove(folder)

    monkeypatch.setattr(Path, "mkdir", make_group)
    monkeypatch.setattr(Path, "rmdir", remove_group)
    yield


@pytest.fixture
def version_1(tmp_path: Path) -> Path:
    for name in FILES_1:
        (tmp_path / name).mkdir()
    return tmp_path


@pytest.fixture
def version_2(tmp_path: Path) -> Path:
    (tmp_path / "cgroup.controllers").write_text("cpu memory pids\n")
    (tmp_path / "cgroup.subtree_control").write_text("memory pids\n")
    (tmp_path / "cgroup.procs").write_text("")
    return tmp_path


@pytest.mark.usefixtures("kernel")
def test_version_1_has_a_group_in_each_tree(version_1: Path) -> None:
    with control_groups(LIMITS, version_1) as groups:
        assert [group.parent.name for group in groups] == ["memory", "pids", "cpu", "cpuacct"]
        values = {file.name: file.read_text() for group in groups for file in group.iterdir()}
        assert values["memory.limit_in_bytes"] == "1000"
        assert values["memory.kmem.tcp.limit_in_bytes"] == "125"
        assert values["pids.max"] == "7"
        assert values["cpu.shares"] == "1024"
    assert not list(version_1.glob("*/ros2course-*"))


@pytest.mark.usefixtures("kernel")
def test_version_1_with_two_controllers_in_one_tree(version_1: Path) -> None:
    (version_1 / "cpuacct").rmdir()
    (version_1 / "cpuacct").symlink_to(version_1 / "cpu")
    with control_groups(LIMITS, version_1) as groups:
        assert [group.parent.name for group in groups] == ["memory", "pids", "cpu"]


@pytest.mark.usefixtures("kernel")
def test_version_2_has_one_group(version_2: Path) -> None:
    with control_groups(LIMITS, version_2) as (group,):
        values = {file.name: file.read_text() for file in group.iterdir()}
        assert (values["memory.max"], values["memory.swap.max"]) == ("1000", "0")
        assert (values["pids.max"], values["cpu.weight"]) == ("7", "100")
    assert not group.exists()


@pytest.mark.usefixtures("kernel")
def test_version_2_has_it_beside_ours(version_2: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Our own group has processes, so the kernel refuses to delegate anything from there."""
    own = version_2 / "user.slice/session"
    own.mkdir(parents=True)
    (own.parent / "cgroup.subtree_control").write_text("memory pids\n")
    (own.parent / "cgroup.procs").write_text("")
    (own / "cgroup.subtree_control").mkdir()  # reading or writing it is an error
    monkeypatch.setattr(module, "_own_groups", lambda: {"": "/user.slice/session"})
    with control_groups(LIMITS, version_2) as (group,):
        assert group.parent == own.parent


@pytest.mark.usefixtures("kernel")
def test_each_submission_has_its_own(version_2: Path) -> None:
    with control_groups(LIMITS, version_2) as first, control_groups(LIMITS, version_2) as second:
        assert first != second


def test_a_machine_without_them(tmp_path: Path) -> None:
    with control_groups(LIMITS, tmp_path / "nothing") as groups:
        assert groups == ()


def test_a_tree_that_lacks_what_is_needed(version_1: Path) -> None:
    (version_1 / "pids").rmdir()
    with control_groups(LIMITS, version_1) as groups:
        assert groups == ()
    assert not list(version_1.glob("*/ros2course-*"))


@pytest.mark.usefixtures("kernel")
def test_what_a_killed_grading_left_is_swept(version_2: Path) -> None:
    """And nothing of a grading that is still running."""
    with subprocess.Popen(["sleep", "60"]) as running, subprocess.Popen(["true"]) as ended:
        os.waitid(os.P_PID, ended.pid, os.WEXITED | os.WNOWAIT)  # nobody has asked how it ended
        mine = module._started(running.pid)
        kept = version_2 / f"ros2course-{running.pid}-{mine}-999999"
        left = [
            version_2 / f"ros2course-{NOBODY}-{mine}-0",
            version_2 / f"ros2course-{running.pid}-{mine - 1}-0",  # of an earlier process of that number
            version_2 / f"ros2course-{ended.pid}-{mine}-0",
        ]
        for group in (kept, *left):
            group.mkdir()
        with control_groups(LIMITS, version_2) as made:
            assert [group for group in left if group.exists()] == []
            assert kept.exists()
            assert [module._LEFT.fullmatch(group.name) is not None for group in made] == [True]
        running.kill()


def test_what_the_kernel_noted(tmp_path: Path) -> None:
    first, second = tmp_path / "1", tmp_path / "2"
    for group in (first, second):
        group.mkdir()
    (first / "memory.oom_control").write_text("oom_kill_disable 0\nunder_oom 0\noom_kill 2\n")
    (second / "memory.events").write_text("low 0\noom 5\noom_kill 3\n")
    (first / "pids.events").write_text("max 4\n")
    (first / "cpuacct.usage").write_text("1500000000\n")
    (second / "cpu.stat").write_text("usage_usec 250000\nuser_usec 1\n")
    groups = (first, second)
    assert (memory_kills(groups), refused_processes(groups)) == (5, 4)
    assert cpu_seconds(groups) == pytest.approx(1.75)


def test_files_that_are_missing_or_odd_say_nothing(tmp_path: Path) -> None:
    (tmp_path / "pids.events").write_text("max many\n")
    assert (memory_kills([tmp_path]), refused_processes([tmp_path]), cpu_seconds([tmp_path])) == (0, 0, 0)


def test_joining_writes_to_each(tmp_path: Path) -> None:
    join([tmp_path])
    assert (tmp_path / "cgroup.procs").read_text() == "0"
