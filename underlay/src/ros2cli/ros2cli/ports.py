"""How many processes on this machine take part in a ROS domain: each has a port of a known number."""

from __future__ import annotations

from pathlib import Path

_BASE, _DOMAIN_GAIN, _UNICAST = 7400, 250, 10


def local_participants(domain: int, table: Path = Path("/proc/net/udp")) -> int:
    """Counted from the sockets that the kernel lists; 0 where it does not tell."""
    first = _BASE + _DOMAIN_GAIN * domain + _UNICAST
    unicast = range(first, first + _DOMAIN_GAIN - _UNICAST, 2)
    try:
        lines = table.read_text(encoding="ascii").splitlines()[1:]
    except OSError:
        return 0
    return len({port for port in map(_port, lines) if port in unicast})


def _port(line: str) -> int:
    return int(line.split()[1].rpartition(":")[2], 16)
