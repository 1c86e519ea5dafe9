"""What a daemon must have in common with who asks it: the ROS, how it discovers, and the network."""

from __future__ import annotations

import contextlib
import os
import socket
import sys
from pathlib import Path

_MATTERS = (
    "FASTDDS_BUILTIN_TRANSPORTS",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "RMW_IMPLEMENTATION",
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_DISCOVERY_SERVER",
    "ROS_LOCALHOST_ONLY",
    "ROS_STATIC_PEERS",
)
_PATHS = ("AMENT_PREFIX_PATH", "LD_LIBRARY_PATH")


def identity(routes: Path = Path("/proc/net/route")) -> list[str]:
    """The same list in two processes means that both see the same graph with the same code.

    What a workspace adds to the paths does not count: terminals with and without it share a daemon.
    """
    settings = [os.environ.get(name, "") for name in _MATTERS]
    profile = os.environ.get("FASTRTPS_DEFAULT_PROFILES_FILE", "")
    return [
        sys.prefix,
        *settings,
        *(_without_workspaces(os.environ.get(name, "")) for name in _PATHS),
        _age(profile),
        _age(str(Path(__file__).with_name("snapshot.py"))),
        *(name for _, name in socket.if_nameindex()),
        *_reachable(routes),
    ]


def _without_workspaces(paths: str) -> str:
    workspaces = tuple(path for path in os.environ.get("COLCON_PREFIX_PATH", "").split(os.pathsep) if path)
    kept = {path for path in paths.split(os.pathsep) if not workspaces or not path.startswith(workspaces)}
    # The wheels' own start-up puts their folders there in an order that varies.
    return os.pathsep.join(sorted(kept))


def _age(file: str) -> str:
    """The file and its state, so that an exchanged one is another."""
    with contextlib.suppress(OSError):
        return f"{file} {Path(file).stat().st_mtime_ns}"
    return file


def _reachable(routes: Path) -> list[str]:
    """Interface and network of each route: a daemon does not see a network that came after it."""
    try:
        lines = routes.read_text(encoding="ascii").splitlines()[1:]
    except OSError:
        return []
    return sorted(" ".join(line.split()[:2]) for line in lines)
