"""For which machines there are ROS 2 wheels, and what to do on the others."""

from __future__ import annotations

from course.errors import MissingHere
from course.rosenv.host import Host

OLDEST, NEWEST = (3, 10), (3, 14)
_GLIBC = (2, 28)
_PACKAGES = (
    "Install ROS 2 Jazzy from its packages (Ubuntu 24.04, https://docs.ros.org/en/jazzy/Installation.html) "
    "or use the Docker image ros:jazzy. There, run: source /opt/ros/jazzy/setup.bash"
)
_PYTHON = (
    f"Set the course up with one of Python {OLDEST[0]}.{OLDEST[1]} to {NEWEST[0]}.{NEWEST[1]}, "
    "for example, in the course's folder: python3.12 -m venv .venv && .venv/bin/pip install '.[jazzy]'"
)


def why_no_wheels(host: Host) -> MissingHere | None:
    """Why pip cannot bring ROS 2 to this machine, with the way out; None when it can."""
    return _machine(host) or _libc(host) or _python(host)


def _machine(host: Host) -> MissingHere | None:
    if host.system != "linux":
        return MissingHere(f"ROS 2 from pip exists for Linux only; this is {host.system}.", _PACKAGES)
    if host.machine not in ("x86_64", "AMD64"):
        what = f"ROS 2 from pip exists for x86-64 processors only; this one is {host.machine}."
        return MissingHere(what, _PACKAGES)
    return None


def _libc(host: Host) -> MissingHere | None:
    if not host.libc.startswith("glibc "):
        what = "ROS 2 from pip needs the C library glibc; this system has another one (musl, as on Alpine)."
        return MissingHere(what, _PACKAGES)
    numbers = tuple(int(part) for part in host.libc.split()[1].split(".")[:2])
    if numbers < _GLIBC:
        return MissingHere(f"ROS 2 from pip needs glibc 2.28 or newer; here is {host.libc}.", _PACKAGES)
    return None


def _python(host: Host) -> MissingHere | None:
    if host.implementation != "cpython" or host.free_threaded:
        kind = "free-threaded" if host.free_threaded else host.implementation
        return MissingHere(f"ROS 2 from pip needs the usual CPython; this Python is {kind}.", _PYTHON)
    if OLDEST <= host.python <= NEWEST:
        return None
    age = "old" if host.python < OLDEST else "new"
    return MissingHere(f"Python {host.python_version} is too {age} for ROS 2 from pip.", _PYTHON)
