"""ROS domains: a free one for a check, or for a scenario's programs if others use the same network."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Iterator

from course.errors import MissingHere

# Higher domains have port numbers in the range that Linux uses for outgoing connections.
_DOMAINS = range(1, 102)
# How many participants of a domain are looked for: the first ones may have ended.
_PARTICIPANTS = 32


@contextlib.contextmanager
def free_domain() -> Iterator[int]:
    """A domain that no other check on this machine holds and no ROS program listens in.

    The claim is an abstract socket: the kernel keeps it unique for all users and frees it
    when this process ends, however it ends. Raises MissingHere if all are taken.
    """
    for domain in _DOMAINS:
        with contextlib.ExitStack() as stack:
            claim = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_STREAM))
            try:
                claim.bind(f"\0ros2course-domain-{domain}")
            except OSError:
                continue
            if _in_use(domain):
                continue
            yield domain
            return
    raise MissingHere(
        "All ROS domains of this machine are in use.",
        "Wait until other checks have ended, or install bubblewrap: `sudo apt install bubblewrap`.",
    )


def _in_use(domain: int) -> bool:
    """Whether a participant listens at one of the domain's ports.

    Source: DDS-RTPS specification, 9.6.1.1: 7400 + 250 * domain, plus 0 for discovery by
    multicast, plus 10 + 2 * n for that of the n-th participant.
    """
    offsets = (0, *(10 + 2 * n for n in range(_PARTICIPANTS)))
    return any(_is_taken(7400 + 250 * domain + offset) for offset in offsets)


def _is_taken(port: int) -> bool:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("", port))
        except OSError:
            return True
    return False


class Domains:
    """around: the domain that the arena was given; None if it has its own network."""

    def __init__(self, around: int | None) -> None:
        self._around = around
        self._known = {0: around}
        self._claims = contextlib.ExitStack()

    def at(self, number: int) -> int:
        """The real ROS_DOMAIN_ID for domain `number`; 0 is the arena's.

        On a network that others use, too, this is a free domain, because other checks or a robot may use the
        one with that number. It is held until `close`. Raises MissingHere if all are taken.
        """
        if self._around is None:
            return number
        found = self._known.get(number)
        if found is None:
            found = self._known[number] = self._claims.enter_context(free_domain())
        return found

    def close(self) -> None:
        self._claims.close()
