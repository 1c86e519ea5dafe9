"""Commands of a build run as another user, in their own three folders."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from course.build import Interrupt, Store, Workspace
from course.build.budget import OURS, Budget
from course.build.colcon import build_environment
from course.build.package_build import PackageBuild, RunCommand
from course.build.runner import Ended, Ending
from course.build.store import StoreEntry
from course.isolation.bubblewrap import build_obstacle
from course.rosenv import Ros
from tests.build.conftest import WORKSPACE

pytestmark = pytest.mark.skipif(
    build_obstacle() is not None, reason=f"not exercised here: {build_obstacle()}"
)


class Place:
    """An entry that is being built, and how to run commands in it."""

    def __init__(self, entry: StoreEntry, run: RunCommand) -> None:
        self.entry = entry
        self._run = run

    def shell(self, script: str, time_limit: float = 20.0) -> tuple[Ended, str]:
        """How the script ended, and its output."""
        ended = self._run(["/bin/sh", "-c", script], self.entry.src, self.entry.log, time_limit)
        return ended, self.entry.log.read_text()


@pytest.fixture
def place(home: Path, store: Store, ros: Ros) -> Iterator[Place]:
    with _place(home, store, ros) as found:
        yield found


@contextmanager
def _place(home: Path, store: Store, ros: Ros) -> Iterator[Place]:
    workspace = Workspace.scan(home / WORKSPACE)
    package = workspace.find("small_node")
    assert package is not None
    with Interrupt() as stop:
        build = PackageBuild(
            package, workspace, "0" * 32, (), (), ros, ros.identity, store, Budget(OURS), 20.0, print, stop
        )
        build.entry.begin()
        build.entry.src.mkdir()
        with build.commands(build_environment(ros, build.entry, ()), build.usage()) as run:
            yield Place(build.entry, run)


def test_three_folders_can_be_written_and_no_other(place: Place) -> None:
    folders = "src build install . log .. / /usr /etc /home /var /opt"
    script = f"cd ..; for f in {folders}; do touch $f/made 2>/dev/null && echo $f; done; true"
    _, said = place.shell(script)
    assert set(said.split()) <= {"src", "build", "install", "."}
    assert {path.name for path in place.entry.path.iterdir()} == {"src", "build", "install", "log"}
    assert [path.name for path in place.entry.log.parent.iterdir()] == ["build.log"]


def test_it_is_somebody_without_rights(place: Place) -> None:
    _, said = place.shell("id -u; id -G; grep -E 'Cap|NoNew' /proc/self/status; ulimit -c")
    user, groups, *rest, core = said.splitlines()
    assert int(user) not in (0, os.getuid())
    assert groups == user
    assert rest == [f"Cap{kind}:\t{'0' * 16}" for kind in ("Inh", "Prm", "Eff", "Bnd", "Amb")] + [
        "NoNewPrivs:\t1"
    ]
    assert core == "0"


def test_there_is_no_network_and_no_stranger(place: Place) -> None:
    _, said = place.shell("tail -n +3 /proc/net/dev; echo --; ls -d /proc/[0-9]* | wc -l")
    interfaces, processes = said.split("--")
    assert {line.split(":")[0].strip() for line in interfaces.splitlines() if line.strip()} <= {"lo"}
    assert int(processes) < 8


def test_the_environment_is_ours(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    _, said = place.shell("echo $HOME $TMPDIR; cat /etc/passwd; hostname")
    home, passwd = said.split("\n", 1)
    assert set(home.split()) == {str(place.entry.build / "tmp")}
    assert [line.split(":")[0] for line in passwd.splitlines()[:2]] == ["root", "learner"]


@pytest.mark.slow
@pytest.mark.parametrize("limit", [20.0, 1.0])
def test_all_have_ended_when_it_is_over(place: Place, limit: float) -> None:
    """Even if it was stopped, and even those that left its session; many, as ending them takes a moment."""
    script = "for i in $(seq 150); do setsid sleep 77 >/dev/null & done; sleep 0.3; "
    ended, _ = place.shell(script + ("sleep 77" if limit < 10 else "true"), limit)
    left = [path for path in Path("/proc").glob("[0-9]*/cmdline") if b"sleep\x0077\x00" in contents(path)]
    assert not left
    assert ended.ending is (Ending.TOO_LONG if limit < 10 else Ending.EXITED)


def contents(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError:  # it has just ended
        return b""


def test_commands_can_follow_one_another(place: Place) -> None:
    place.shell("echo one > made")
    _, said = place.shell("cat made; cat /etc/hosts")
    assert said.startswith("one\n127.0.0.1 localhost")
