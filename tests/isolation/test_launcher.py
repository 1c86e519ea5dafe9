"""The launcher: what it keeps, what it passes on, and what it says if a program cannot be started."""

from __future__ import annotations

import subprocess
import sys

import pytest

from course.isolation.bubblewrap import data
from course.isolation.launcher import Order, as_message, start_message


def run(code: str) -> list[str]:
    """In a separate process, which forks."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_it_holds_nothing_of_the_grading_process_and_ends_with_it() -> None:
    """Above all not the pipe for the verdict, which closes when the grading process ends."""
    code = """
import os
from course.isolation.launcher import fork_launcher
reading, writing = os.pipe()
os.set_inheritable(writing, True)
link = fork_launcher()
os.close(writing)
print(os.read(reading, 1))
link.close()
print(os.wait()[1])
"""
    assert run(code) == ["b''", "0"]


def test_a_program_gets_the_descriptors_that_were_asked_for_and_no_others() -> None:
    code = """
import os
from course.isolation.launcher import _hand_on
terminal, asked, other = (os.memfd_create(name) for name in ("terminal", "asked", "other"))
keep = os.memfd_create("keep")
if os.fork() == 0:
    _hand_on([terminal, asked], (0, 9), keep=keep)
    names = {number: os.readlink(f"/proc/self/fd/{number}") for number in (0, 1, 2, 9, keep)}
    left = [number for number in range(64) if os.path.exists(f"/proc/self/fd/{number}") or number in names]
    os.write(1, f"{[names[number][7:15] for number in (0, 1, 2, 9)]}\\n{left == sorted(names)}".encode())
    os._exit(0)
os.wait()
print(os.pread(terminal, 1000, 0).decode())
"""
    assert run(code) == ["['terminal', 'terminal', 'terminal', 'asked (d']", "True"]


def test_an_order_travels_whole() -> None:
    order = Order(("run", "it"), {"A": "b"}, "/there", (5,), own_memory=("/dev/shm/here",))
    told = {"command": ("run", "it"), "environment": {"A": "b"}, "folder": "/there", "descriptors": (5,)}
    assert start_message(order) == as_message("start", **told, own_memory=("/dev/shm/here",))


@pytest.mark.parametrize("given", ["text\n", b"bytes\n"])
def test_data_for_bubblewrap_is_read_from_its_beginning(given: str | bytes) -> None:
    with data(given) as descriptor, open(descriptor, "rb", closefd=False) as file:
        assert file.read() in (b"text\n", b"bytes\n")
