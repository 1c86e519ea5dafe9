"""Where the grading process runs: apart from the rest of the machine as far as it allows.

`namespaces`  bubblewrap gives it a network of its own (loopback only), its own processes,
              shared memory and /proc; when its parent dies, the kernel ends everything in it.
`domain`      where namespaces are not allowed: a ROS_DOMAIN_ID that nobody else on this
              machine uses, and discovery on this machine only.
"""

from __future__ import annotations

import contextlib
import shutil
import socket
import subprocess
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from course.errors import MissingHere

_BWRAP = (
    "--die-with-parent --unshare-net --unshare-pid --unshare-ipc "
    "--dev-bind / / --proc /proc --tmpfs /dev/shm --chdir /"
).split()
_PROBE_TIMEOUT = 10.0
# The port numbers of higher domains meet the range that Linux gives to outgoing connections.
_DOMAINS = range(1, 102)
# As many programs in one domain as may be left over when the first has ended.
_PARTICIPANTS = 32


@dataclass(frozen=True)
class Enclosure:
    """How to start the grading process.

    kind: "namespaces" or "domain". prefix: put before the command. environment: added to its
    environment. missing: a quiet line on what this machine lacks, or None.
    """

    kind: str
    prefix: tuple[str, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    missing: str | None = None


@contextlib.contextmanager
def enclosure(*, namespaces: bool = True) -> Iterator[Enclosure]:
    """The strongest enclosure that this machine offers without root; held until the end.

    namespaces: False takes the domain even where namespaces would work.
    """
    obstacle = namespace_obstacle() if namespaces else "namespaces were not wanted"
    if obstacle is None:
        yield Enclosure("namespaces", (bwrap(), *_BWRAP))
        return
    with free_domain() as domain:
        environment = {"ROS_DOMAIN_ID": str(domain), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
        yield Enclosure("domain", (), environment, obstacle if namespaces else None)


def namespace_obstacle() -> str | None:
    """Why namespaces cannot be had here, in one line with what to do; None when they can."""
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed: `sudo apt install bubblewrap`"
    try:
        done = subprocess.run(
            [bwrap(), *_BWRAP, "true"], capture_output=True, timeout=_PROBE_TIMEOUT, check=False
        )
    except subprocess.TimeoutExpired:
        return f"bubblewrap does not start here: it hung for {_PROBE_TIMEOUT:.0f} s"
    except OSError as error:
        return f"bubblewrap does not start here: {error}"
    if done.returncode == 0:
        return None
    return f"this system does not allow namespaces ({said(done)})"


def said(done: subprocess.CompletedProcess[bytes]) -> str:
    """The last line of what bubblewrap complained about, else its exit code."""
    reason = done.stderr.decode("utf-8", errors="replace").strip().splitlines()
    return reason[-1] if reason else str(done.returncode)


def bwrap() -> str:
    return shutil.which("bwrap") or "bwrap"


@contextlib.contextmanager
def free_domain() -> Iterator[int]:
    """A domain that no other check on this machine holds and no ROS program listens in.

    The claim is an abstract socket: the kernel keeps it unique for all users and frees it
    when this process ends, however it ends. Raises MissingHere when all are taken.
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
