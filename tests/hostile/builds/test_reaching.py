"""What builds try to read, write and reach."""

from __future__ import annotations

import contextlib
import select
import socket
import threading
import time
from pathlib import Path

import psutil
import pytest

from course.build import BuildFailure
from tests.hostile.builds.conftest import BuildIt, Package, attack, cmake_package, python_package
from tests.hostile.world import SECRET
from tests.processes import ours_below, words_of

pytestmark = pytest.mark.slow
KINDS = pytest.mark.parametrize("package", [python_package, cmake_package])


def test_an_honest_package_is_built(build_it: BuildIt) -> None:
    """Otherwise the others prove little."""
    built = build_it(python_package("print('HELD nothing: at all')"), guarantee="honest packages are built")
    assert built.outcome.failure is None, built.words
    assert (built.install / "share/strange/package.xml").stat().st_uid == 0 or built.world.left() == []


@KINDS
def test_nothing_private_is_read(
    build_it: BuildIt,
    package: Package,
    course_copy: Path,
    own_store: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("ROS2COURSE_TEST_SECRET", SECRET)
    places = (course_copy, course_copy / "solutions", course_copy / "graders", own_store / f"{SECRET}.txt")
    others = ("/root", "/home", "/etc/shadow", "/var/log", "/proc/1/environ", "/proc/1/root", "/sys", "/run")
    program = attack("reads", PLACES=[*map(str, places), *others], SECRET=SECRET)
    built = build_it(package(program), guarantee="builds see only what they need")
    # The descriptors of a build are colcon's pipes; its own processes may look at one another.
    serious = [line for line in built.breaches if "descriptors" not in line and "environments" not in line]
    assert not serious
    assert built.held >= {f"place {number}" for number in range(len(places) + len(others))}
    assert built.held >= {"search", "passwords", "secrets_in_environment"}


@KINDS
def test_nothing_that_others_use_is_poisoned(build_it: BuildIt, package: Package, course_copy: Path) -> None:
    places = [
        *map(str, (course_copy, course_copy / "graders", Path(__file__).parents[3] / "course")),
        "/var/tmp",
    ]
    built = build_it(
        package(attack("build_poison", PLACES=places)), guarantee="builds write only into their own folders"
    )
    assert not built.breaches
    names = (
        "modules",
        "libraries",
        "folders of Python",
        "prefixes",
        "programs",
        "start-up",
        "marker",
        "lock",
    )
    assert built.held >= {*names, "own log", "kept sources", "other entries", "everywhere", "place 0"}
    assert built.outcome.failure is None, built.words


@KINDS
def test_nobody_is_reached(build_it: BuildIt, package: Package, open_place: Path) -> None:
    file = open_place / "listening-to-builds"
    with (
        socket.socket() as tcp,
        socket.socket(type=socket.SOCK_DGRAM) as udp,
        socket.socket(socket.AF_UNIX) as abstract,
        socket.socket(socket.AF_UNIX) as named,
    ):
        tcp.bind(("127.0.0.1", 0))
        udp.bind(("127.0.0.1", 0))
        name = f"{SECRET}-{tcp.getsockname()[1]}"
        abstract.bind(f"\0{name}")
        named.bind(str(file))
        file.chmod(0o777)
        for one in (tcp, abstract, named):
            one.listen()
        ports = {"TCP": tcp.getsockname()[1], "UDP": udp.getsockname()[1]}
        program = attack("network", ABSTRACT=name, FILE=str(file), OUTSIDE="192.0.2.1", **ports)
        built = build_it(package(program), guarantee="builds have no network")
        heard, _, _ = select.select([tcp, udp, abstract, named], [], [], 0)
    file.unlink()
    assert not heard
    assert not built.breaches
    assert built.held >= {
        "tcp",
        "udp",
        "abstract",
        "file",
        "outside tcp",
        "outside udp",
        "names",
        "interfaces",
    }
    assert built.outcome.failure is None, built.words


@KINDS
def test_a_build_has_no_rights(build_it: BuildIt, package: Package) -> None:
    built = build_it(package(attack("build_rights")), guarantee="builds have no rights")
    assert not built.breaches
    names = ("rights", "first process", "ptrace", "user namespace", "chroot", "root", "device", "strangers")
    assert built.held >= {*names, "raw socket", "terminal", "pseudo-terminal"}
    assert built.outcome.failure is None, built.words


WAITING = "import time\ntime.sleep(4)"


@pytest.mark.parametrize("kind", ["build's bubblewrap", "build's first process"])
def test_a_build_whose_surroundings_were_killed_is_run_again(build_it: BuildIt, kind: str) -> None:
    struck: list[str] = []

    def strike() -> None:
        deadline = time.monotonic() + 60
        while not struck and time.monotonic() < deadline:
            ours = dict(ours_below(psutil.Process()))
            if kind in ours and any("setup.py" in word for word in _words_below(ours[kind])):
                ours[kind].kill()
                struck.append(kind)

    thread = threading.Thread(target=strike)
    files, guarantee = python_package(WAITING), "a kill is no failure"
    built = build_it(files, guarantee=guarantee, prepare=lambda _: thread.start())
    thread.join()
    assert struck and built.outcome.failure is None, built.words


def _words_below(process: psutil.Process) -> list[str]:
    with contextlib.suppress(psutil.Error):
        return [word for child in process.children(recursive=True) for word in words_of(child)]
    return []


@KINDS
def test_killing_everybody_kills_the_build_alone(build_it: BuildIt, package: Package) -> None:
    program = "import os, signal\nos.kill(-1, signal.SIGKILL)\nos.kill(os.getpid(), signal.SIGKILL)"
    built = build_it(package(program), guarantee="builds can signal nobody but themselves")
    assert isinstance(built.failure, BuildFailure)
    assert "strange" in built.failure.feedback.summary
