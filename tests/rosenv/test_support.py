from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from course.rosenv.host import Host
from course.rosenv.support import why_no_wheels

HOST = Host(Path("/p/bin/python3"), Path("/p"), Path("/p/lib/python3.12/site-packages"), (3, 12))


@pytest.mark.parametrize("python", [(3, 10), (3, 12), (3, 14)])
def test_the_usual_machine_is_served(python: tuple[int, int]) -> None:
    assert why_no_wheels(replace(HOST, python=python)) is None


@pytest.mark.parametrize(
    ("changes", "what", "next_step"),
    [
        ({"machine": "aarch64"}, "x86-64 processors only; this one is aarch64", "Docker image ros:jazzy"),
        ({"system": "darwin"}, "Linux only; this is darwin", "Docker image ros:jazzy"),
        ({"libc": ""}, "musl", "Docker image ros:jazzy"),
        ({"libc": "glibc 2.27"}, "needs glibc 2.28 or newer; here is glibc 2.27", "Docker image ros:jazzy"),
        ({"python": (3, 9)}, "Python 3.9 is too old", "3.10 to 3.14"),
        ({"python": (3, 15)}, "Python 3.15 is too new", "3.10 to 3.14"),
        ({"implementation": "pypy"}, "this Python is pypy", "3.10 to 3.14"),
        ({"free_threaded": True}, "this Python is free-threaded", "3.10 to 3.14"),
    ],
)
def test_another_machine_is_told_why_and_what_to_do(
    changes: dict[str, Any], what: str, next_step: str
) -> None:
    error = why_no_wheels(replace(HOST, **changes))
    assert error is not None
    assert what in error.what
    assert next_step in (error.next_step or "")


def test_the_processor_is_named_before_the_python() -> None:
    # Another Python would not help there.
    error = why_no_wheels(replace(HOST, machine="aarch64", python=(3, 9)))
    assert error is not None
    assert "aarch64" in error.what
