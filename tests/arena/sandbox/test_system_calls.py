"""The filter of system calls, read as the kernel reads it, and tried out in a process of its own."""

from __future__ import annotations

import errno
import platform
import struct
import subprocess
import sys

import pytest

from course.arena.sandbox.system_calls import refusing

X86, ARM = 0xC000_003E, 0xC000_00B7
ALLOW, FAIL = 0x7FFF_0000, 0x0005_0000
LOAD, EQUAL, ANY_BIT, AT_LEAST = 0x20, 0x15, 0x45, 0x35
NEW_USER, THREAD = 0x1000_0000, 0x003D_0F00


def decide(instructions: bytes, call: int, audit: int, *arguments: int) -> int:
    """What the filter answers: 0 when the call is let through, else an error's number."""
    data = struct.pack("<IIQ6Q", call, audit, 0, *arguments, *(0,) * (6 - len(arguments)))
    steps = list(struct.iter_unpack("=HBBI", instructions))
    place, value = 0, 0
    while True:
        code, true, false, operand = steps[place]
        if code == LOAD:
            (value,) = struct.unpack_from("<I", data, operand)
            true = false = 0
        elif code not in (EQUAL, ANY_BIT, AT_LEAST):
            return 0 if operand == ALLOW else operand & ~FAIL
        holds = {EQUAL: value == operand, ANY_BIT: value & operand, AT_LEAST: value >= operand}.get(code)
        place += 1 + (true if holds else false)


# From the kernel's tables.
NAMES = ("read", "clone", "socket", "ioctl", "unshare", "ptrace", "bpf")
NUMBERS = {"x86_64": (0, 56, 41, 16, 272, 101, 321), "aarch64": (63, 220, 198, 29, 97, 117, 280)}


@pytest.mark.parametrize(("machine", "audit"), [("x86_64", X86), ("aarch64", ARM)])
class TestEveryMachine:
    def ask(self, machine: str, audit: int, name: str, *arguments: int) -> int:
        number = NUMBERS[machine][NAMES.index(name)]
        return decide(refusing(machine), number, audit, *arguments)

    def test_what_every_program_needs_is_let_through(self, machine: str, audit: int) -> None:
        assert self.ask(machine, audit, "read") == 0
        assert self.ask(machine, audit, "clone", THREAD) == 0
        assert [self.ask(machine, audit, "socket", family, 1) for family in (1, 2, 10, 16)] == [0] * 4
        assert self.ask(machine, audit, "ioctl", 0, 0x5413) == 0  # the size of the terminal

    def test_what_none_needs_is_not(self, machine: str, audit: int) -> None:
        for name in ("unshare", "ptrace", "bpf"):
            assert self.ask(machine, audit, name) == errno.EPERM
        assert self.ask(machine, audit, "clone", THREAD | NEW_USER) == errno.EPERM
        assert self.ask(machine, audit, "ioctl", 0, 0x5412) == errno.EPERM
        assert self.ask(machine, audit, "socket", 40, 1) == errno.EAFNOSUPPORT
        assert decide(refusing(machine), 425, audit) == errno.EPERM

    def test_clone3_is_unknown_so_that_libraries_take_clone(self, machine: str, audit: int) -> None:
        assert decide(refusing(machine), 435, audit) == errno.ENOSYS

    def test_calls_of_another_architecture_do_not_exist(self, machine: str, audit: int) -> None:
        assert self.ask(machine, audit ^ 0x8000_0000, "read") == errno.ENOSYS
        assert decide(refusing(machine), 0x4000_0000, audit) == errno.ENOSYS


def test_an_unknown_machine_has_no_filter() -> None:
    assert refusing("abacus") == b""


@pytest.mark.skipif(not refusing(), reason=f"no filter is known for {platform.machine()}")
def test_the_kernel_takes_it() -> None:
    """Threads, processes and networks go on; a namespace of users is refused."""
    code = """
import ctypes, socket, subprocess, threading
from course.arena.sandbox import linux
from course.arena.sandbox.system_calls import refusing
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
