"""The filter of system calls, read as the kernel does, and tried in a separate process."""

from __future__ import annotations

import errno
import platform
import struct
import subprocess
import sys

import pytest

from course.isolation.system_calls import refusing

X86, ARM = 0xC000_003E, 0xC000_00B7
ALLOW, FAIL = 0x7FFF_0000, 0x0005_0000
LOAD, EQUAL, ANY_BIT, AT_LEAST, AND = 0x20, 0x15, 0x45, 0x35, 0x54
NEW_USER, THREAD = 0x1000_0000, 0x003D_0F00


def decide(instructions: bytes, call: int, audit: int, *arguments: int) -> int:
    """The filter's answer: 0 if the call is allowed, otherwise an error number, or -1 for success."""
    data = struct.pack("<IIQ6Q", call, audit, 0, *arguments, *(0,) * (6 - len(arguments)))
    steps = list(struct.iter_unpack("=HBBI", instructions))
    place, value = 0, 0
    while True:
        code, true, false, operand = steps[place]
        if code == LOAD:
            (value,) = struct.unpack_from("<I", data, operand)
            true = false = 0
        elif code == AND:
            value &= operand
            true = false = 0
        elif code not in (EQUAL, ANY_BIT, AT_LEAST):
            return 0 if operand == ALLOW else operand & ~FAIL or -1
        holds = {EQUAL: value == operand, ANY_BIT: value & operand, AT_LEAST: value >= operand}.get(code)
        place += 1 + (true if holds else false)


# From the kernel's tables.
NAMES = "read clone socket socketpair ioctl unshare ptrace bpf memfd_create shmget".split()
NAMES += "setpriority sched_setparam sched_setscheduler sched_setattr ioprio_set".split()
NUMBERS = {
    "x86_64": (0, 56, 41, 53, 16, 272, 101, 321, 319, 29, 141, 142, 144, 314, 251),
    "aarch64": (63, 220, 198, 199, 29, 97, 117, 280, 279, 194, 140, 118, 119, 274, 30),
}
UNIX, INET, INET6, NETLINK, TIPC, VSOCK = 1, 2, 10, 16, 30, 40
STREAM, DATAGRAM, RAW, SEQUENCE = 1, 2, 3, 5
FLAGS = 0x8_0800  # SOCK_CLOEXEC and SOCK_NONBLOCK
TCP, UDP, SCTP, MPTCP, SOCK_DIAG = 6, 17, 132, 262, 4


@pytest.mark.parametrize(("machine", "audit"), [("x86_64", X86), ("aarch64", ARM)])
class TestEveryMachine:
    def ask(self, machine: str, audit: int, name: str, *arguments: int) -> int:
        number = NUMBERS[machine][NAMES.index(name)]
        return decide(refusing(machine), number, audit, *arguments)

    def test_what_every_program_needs_is_let_through(self, machine: str, audit: int) -> None:
        assert self.ask(machine, audit, "read") == 0
        assert self.ask(machine, audit, "clone", THREAD) == 0
        sockets = [(family, kind, 0) for family in (INET, INET6) for kind in (STREAM, DATAGRAM)]
        sockets += [(INET, STREAM | FLAGS, TCP), (INET6, DATAGRAM | FLAGS, UDP), (NETLINK, RAW | FLAGS, 0)]
        sockets += [(UNIX, kind, 0) for kind in (STREAM, DATAGRAM, SEQUENCE)]
        assert [self.ask(machine, audit, "socket", *each) for each in sockets] == [0] * len(sockets)
        assert self.ask(machine, audit, "socketpair", UNIX, STREAM | FLAGS, 0) == 0
        assert self.ask(machine, audit, "ioctl", 0, 0x5413) == 0  # the size of the terminal

    def test_what_none_needs_is_not(self, machine: str, audit: int) -> None:
        for name in ("unshare", "ptrace", "bpf"):
            assert self.ask(machine, audit, name) == errno.EPERM
        assert self.ask(machine, audit, "clone", THREAD | NEW_USER) == errno.EPERM
        assert self.ask(machine, audit, "ioctl", 0, 0x5412) == errno.EPERM
        assert [self.ask(machine, audit, name) for name in NAMES[-5:]] == [-1] * 5
        for number in (425, 447):  # io_uring_setup, memfd_secret
            assert decide(refusing(machine), number, audit) == errno.EPERM

    @pytest.mark.parametrize(
        ("socket", "refused"),
        [
            ((VSOCK, STREAM, 0), errno.EAFNOSUPPORT),
            ((TIPC, SEQUENCE, 0), errno.EAFNOSUPPORT),
            ((INET, STREAM, MPTCP), errno.EPROTONOSUPPORT),
            ((INET6, STREAM | FLAGS, MPTCP), errno.EPROTONOSUPPORT),
            ((INET, STREAM, SCTP), errno.EPROTONOSUPPORT),
            ((INET, SEQUENCE, 0), errno.ESOCKTNOSUPPORT),  # SCTP, too
            ((INET, RAW, TCP), errno.ESOCKTNOSUPPORT),
            ((NETLINK, RAW, SOCK_DIAG), errno.EPROTONOSUPPORT),
            ((NETLINK, DATAGRAM, SOCK_DIAG), errno.EPROTONOSUPPORT),
        ],
    )
    def test_networks_that_none_needs_are_not(
        self, machine: str, audit: int, socket: tuple[int, ...], refused: int
    ) -> None:
        assert self.ask(machine, audit, "socket", *socket) == refused

    def test_pairs_are_local(self, machine: str, audit: int) -> None:
        assert self.ask(machine, audit, "socketpair", TIPC, STREAM, 0) == errno.EAFNOSUPPORT

    def test_memory_that_counts_for_nobody_and_calls_to_come_do_not_exist(
        self, machine: str, audit: int
    ) -> None:
        for name in ("memfd_create", "shmget"):
            assert self.ask(machine, audit, name) == errno.ENOSYS
        assert decide(refusing(machine), 454, audit) == errno.ENOSYS

    def test_clone3_is_unknown_so_that_libraries_take_clone(self, machine: str, audit: int) -> None:
        assert decide(refusing(machine), 435, audit) == errno.ENOSYS

    def test_calls_of_another_architecture_do_not_exist(self, machine: str, audit: int) -> None:
        assert self.ask(machine, audit ^ 0x8000_0000, "read") == errno.ENOSYS
        assert decide(refusing(machine), 0x4000_0000, audit) == errno.ENOSYS


def test_an_unknown_machine_has_no_filter() -> None:
    assert refusing("abacus") == b""


@pytest.mark.skipif(not refusing(), reason=f"no filter is known for {platform.machine()}")
def test_the_kernel_takes_it() -> None:
    """Threads, processes, and networks still work; a user namespace is refused."""
    code = """
import ctypes, socket, subprocess, threading
from course.isolation import linux
from course.isolation.system_calls import refusing
linux.process_control(linux.PR_SET_NO_NEW_PRIVS, 1)
linux.filter_calls(refusing())
threading.Thread(target=print, args=("thread",)).start()
subprocess.run(["true"], check=True)
socket.socket().close()
print(ctypes.CDLL(None).unshare(0x10000000))
try:
    socket.socket(40, socket.SOCK_STREAM)
except OSError as error:
    print(error.errno)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout.split() == ["thread", "-1", str(errno.EAFNOSUPPORT)], done.stderr
