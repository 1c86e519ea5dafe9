"""Ways out of the sandbox: rights, namespaces, other processes, devices, the network, the terminal."""

from __future__ import annotations

import contextlib
import os
import select
import socket
from pathlib import Path

import pytest

from course.isolation.isolation_plan import ResourceLimits
from course.model.result import Verdict
from tests.hostile.world import NODE, SECRET, Grade, open_to_all, with_attack

pytestmark = pytest.mark.slow
NAME = "listening"
KINDS = (
    (socket.AF_INET, socket.SOCK_STREAM),
    (socket.AF_INET, socket.SOCK_DGRAM),
    (socket.AF_UNIX, socket.SOCK_STREAM),
    (socket.AF_UNIX, socket.SOCK_STREAM),
)
ESCAPES = frozenset(
    """rights setuid_programs namespaces clone3 families devices make_device kernel_settings control_groups
    type_for_another steal_a_terminal terminals limits ptrace process_vm_readv pidfd_getfd signal priority
    unshare mount chroot setuid setgroups keyctl bpf perf_event_open userfaultfd io_uring memfd_secret
    memfd_create shmget landlock first_process mptcp mptcp6 sctp sock_diag udev stand_back""".split()
)


def test_there_is_no_way_out(grade: Grade) -> None:
    text = with_attack("escapes", TERMINALS=ResourceLimits().terminals)
    graded = grade({NODE: text}, guarantee="programs have no rights, and reach nobody")
    assert not graded.breaches
    further = {"kernel log", "pair of tipc", "other architecture", "kill everybody"}
    assert graded.held >= ESCAPES | further
    assert "HELD terminals: nothing" in graded.printed
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_nothing_outside_can_be_written(
    grade: Grade, course_copy: Path, store: Path, open_place: Path, tmp_path: Path
) -> None:
    """Other submissions, results, progress, the course, builds: their permissions allow everyone to write."""
    other = open_place / "other-submission"
    other.mkdir(exist_ok=True)
    (other / f"{SECRET}.txt").write_text(SECRET, encoding="utf-8")
    open_to_all(other)
    solution = course_copy / "solutions" / f"{SECRET}.txt"
    system = (Path("/etc/passwd"), Path("/bin/sh"))
    places = [other / f"{SECRET}.txt", solution, store / f"{SECRET}.txt", *system]
    further = (tmp_path, open_place, Path("/var/tmp"), Path("/run"), Path("/"))
    folders = [*(place.parent for place in places), *further]
    text = with_attack("writes", PLACES=[*map(str, places)], FOLDERS=[*map(str, folders)])
    graded = grade({NODE: text}, guarantee="programs write nowhere but in a folder of their own")
    assert not graded.breaches
    assert graded.held >= {"own_install", "interpreters", *(f"leave {n}" for n in range(len(folders)))}
    assert graded.result.verdict is Verdict.PASSED, graded.result
    assert (other / f"{SECRET}.txt").read_text(encoding="utf-8") == SECRET


def test_no_service_of_the_machine_and_nobody_outside_can_be_reached(grade: Grade, open_place: Path) -> None:
    with contextlib.ExitStack() as stack:
        tcp, udp, abstract, file = (stack.enter_context(socket.socket(*kind)) for kind in KINDS)
        tcp.bind(("127.0.0.1", 0))
        udp.bind(("127.0.0.1", 0))
        abstract.bind(f"\0{NAME}-{os.getpid()}")
        file.bind(str(open_place / NAME))
        (open_place / NAME).chmod(0o777)
        for one in (tcp, abstract, file):
            one.listen()
        text = with_attack(
            "network",
            TCP=tcp.getsockname()[1],
            UDP=udp.getsockname()[1],
            ABSTRACT=f"{NAME}-{os.getpid()}",
            FILE=str(open_place / NAME),
            OUTSIDE="192.0.2.1",
        )
        graded = grade({NODE: text}, guarantee="programs reach no network but their own")
        heard, _, _ = select.select([tcp, udp, abstract, file], [], [], 0)
    (open_place / NAME).unlink()
    assert not heard
    assert not graded.breaches
    assert graded.held >= {"tcp", "tcp6", "udp", "abstract", "file", "outside tcp", "outside udp", "names"}
    assert graded.held >= {"interfaces", "routes", "unix_sockets", "broadcast"}
    assert graded.result.verdict is Verdict.PASSED, graded.result
