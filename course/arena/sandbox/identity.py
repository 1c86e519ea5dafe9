"""Who a submission is to this machine: a user id that nobody else has, and control groups of its own."""

from __future__ import annotations

import contextlib
import os
import socket
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from course.arena.sandbox.control_groups import control_groups
from course.arena.sandbox.limits import Limits
from course.errors import MissingHere

# Far above the users of any system; and, for a root who has but some of the ids, near the end of those.
_RANGES = (range(2_000_000_000, 2_000_010_000), range(55_000, 60_000))
_MAP = Path("/proc/self/uid_map")


@dataclass(frozen=True)
class Identity:
    """user: None where we are not root, and programs are the caller in a user namespace.

    control_groups: folders, none where none can be had.
    """

    user: int | None
    control_groups: tuple[Path, ...] = ()


@contextlib.contextmanager
def identity(limits: Limits) -> Iterator[Identity]:
    """Held until the end. Raises MissingHere when all ids are taken."""
    with contextlib.ExitStack() as stack:
        user = stack.enter_context(_own_user()) if os.geteuid() == 0 else None
        yield Identity(user, stack.enter_context(control_groups(limits)))


@contextlib.contextmanager
def _own_user() -> Iterator[int]:
    """As with domains, the claim is an abstract socket, which the kernel frees however we end."""
    start = os.getpid()
    ids = _usable()
    for step in range(len(ids)):
        user = ids[(start + step) % len(ids)]
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as claim:
            try:
                claim.bind(f"\0ros2course-user-{user}")
            except OSError:
                continue
            yield user
            return
    raise MissingHere("All user ids for submissions are in use.", "Wait until other gradings have ended.")


def _usable() -> range:
    mapped = [line.split() for line in _MAP.read_text(encoding="ascii").splitlines()]
    for ids in _RANGES:
        if any(int(first) <= ids[0] and ids[-1] < int(first) + int(count) for first, _, count in mapped):
            return ids
    return _RANGES[-1]
