"""The network interfaces of this machine, as the kernel tells of them."""

from __future__ import annotations

import contextlib
import fcntl
import ipaddress
import socket
import struct
from pathlib import Path

_ADDRESS, _MASK, _FLAGS, _MTU = 0x8915, 0x891B, 0x8913, 0x8921  # SIOCGIF...
_FLAG_NAMES = {
    0x1000: "MULTICAST",
    0x2: "BROADCAST",
    0x10: "POINTOPOINT",
    0x8: "LOOPBACK",
    0x40: "RUNNING",
    0x1: "UP",
}

Row = tuple[str, object]


def interface_rows(name: str, table: Path = Path("/proc/net/if_inet6")) -> list[Row]:
    """What is known of one interface; what it has not is left out."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        address, mask = (_told(asked, question, name) for question in (_ADDRESS, _MASK))
        flags, mtu = (_told(asked, question, name) for question in (_FLAGS, _MTU))
    inet = socket.inet_ntoa(address[4:8]) if address else None
    rows = [
        ("inet", inet),
        ("inet4", [inet] if inet else []),
        ("inet6", _inet6(name, table)),
        ("netmask", socket.inet_ntoa(mask[4:8]) if mask else None),
        ("device", name),
        ("flags", _flag_text(struct.unpack_from("H", flags)[0]) if flags else None),
        ("mtu", struct.unpack_from("i", mtu)[0] if mtu else None),
    ]
    return [(key, value) for key, value in rows if value is not None]


def _told(asked: socket.socket, question: int, name: str) -> bytes:
    """The answer after the name that every answer begins with; nothing where there is none."""
    with contextlib.suppress(OSError):
        return fcntl.ioctl(asked, question, struct.pack("256s", name[:15].encode()))[16:]
    return b""


def _flag_text(flags: int) -> str:
    return f"{flags}<{','.join(name for bit, name in _FLAG_NAMES.items() if flags & bit)}>"


def _inet6(name: str, table: Path) -> list[str]:
    with contextlib.suppress(OSError):
        lines = (line.split() for line in table.read_text(encoding="ascii").splitlines())
        return [str(ipaddress.IPv6Address(bytes.fromhex(line[0]))) for line in lines if line[5] == name]
    return []
