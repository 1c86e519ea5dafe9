"""Sends small RTPS packets to all ports that a grader may listen at, as fast as it can. THREADS: how many.

Some are broken, some announce much that never comes.
"""

import itertools
import os
import socket
import struct
import threading

HEADER = b"RTPS\x02\x03\x01\x0f"


def packets():
    """Heartbeats, gaps and data of writers that there are not, and bytes that mean nothing."""
    writer, reader = b"\x00\x00\x02\xc2", b"\x00\x00\x02\xc7"
    numbers = struct.pack("<iIiIi", 0, 1, 0, 1 << 30, 1)
    heartbeat = b"\x07\x01" + struct.pack("<H", 28) + reader + writer + numbers
    fragment = b"\x16\x01" + struct.pack("<H", 32) + b"\x00\x00\x1c\x00" + reader + writer
    fragment += struct.pack("<iIIHHI", 0, 1, 1, 1, 64, 1 << 31)
    for number in itertools.count():
        prefix = struct.pack("<III", number % 977, os.getpid(), 7)
        body = (heartbeat, fragment, os.urandom(24), b"\x15\x05\xff\xff")[number % 4]
        yield HEADER + prefix + body


def flood(node):
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    domain = int(os.environ.get("ROS_DOMAIN_ID", "0"))
    ports = [7400 + 250 * domain + offset for offset in (0, 1, *range(10, 20))]
    for packet in packets():
        for port in ports:
            try:
                sender.sendto(packet, ("127.0.0.1", port))
            except OSError:
                pass


def all_of_them(node):
    for _ in range(THREADS):
        threading.Thread(target=flood, args=(node,), daemon=True).start()


beside(all_of_them)
