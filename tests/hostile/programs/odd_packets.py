"""Sends what the grader's own RTPS packets are like, changed at random. SEED: of the changes. RATE: a second.

They are learned from its announcements, and from those of the node itself.
"""

import itertools
import os
import random
import socket
import struct
import time

OWN = b"\x01\x0f\x0d\xd5" + os.urandom(8)  # of a participant that there is not
# Of the endpoints that every participant has.
ENDPOINTS = tuple(
    bytes((0, kind >> 8, kind & 255, end))
    for kind in (0x1, 0x2, 0x3, 0x4, 0x100, 0x200)
    for end in (0xC2, 0xC7)
)
NUMBERS = (0, 1, 2, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF)


def made_up(draw):
    """A few submessages of random kinds, which speak to endpoints that there are."""
    parts = [b"RTPS\x02\x03\x01\x0f" + OWN]
    for _ in range(draw.randint(1, 4)):
        numbers = struct.pack("<6I", *draw.choices(NUMBERS, k=6))
        body = (
            draw.choice((b"", b"\x00\x00\x10\x00"))
            + draw.choice(ENDPOINTS)
            + draw.choice(ENDPOINTS)
            + numbers
        )
        parts.append(struct.pack("<BBH", draw.randrange(0x01, 0x36), draw.randrange(16), len(body)) + body)
    return b"".join(parts)


def changed(draw, samples):
    """One of the samples, as if it came from another participant, and odd in a few places."""
    packet = bytearray(draw.choice((draw.choice(samples), made_up(draw))))
    packet[8:20] = draw.choice((OWN, packet[8:20], draw.randbytes(12)))
    for _ in range(draw.randint(0, 5)):
        at = draw.randrange(20, len(packet)) if len(packet) > 20 else 0
        end = min(len(packet), at + draw.choice((1, 2, 4, 8, 40)))
        match draw.randrange(7):
            case 0:
                packet[at:end] = draw.randbytes(end - at)
            case 1:
                packet[at : at + 4] = struct.pack("<I", draw.choice(NUMBERS))
            case 2:
                packet[at : at + 2] = struct.pack("<H", draw.choice(NUMBERS) & 0xFFFF)
            case 3:
                del packet[at:end]
            case 4:
                packet[at:at] = packet[at:end] * draw.choice((1, 3, 60))
            case 5:
                packet[at:] = draw.choice(samples)[20:]
            case _:
                del packet[at:]
    return bytes(packet[:60000])


def listen(port):
    """Where announcements are sent to."""
    listening = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    listening.bind(("", port))
    group = socket.inet_aton("239.255.0.1") + socket.inet_aton("127.0.0.1")
    listening.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, group)
    return listening


def send(node):
    first = 7400 + 250 * int(os.environ.get("ROS_DOMAIN_ID", "0"))
    listening, sender = listen(first), socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    samples = [listening.recv(65536) for _ in range(40)]
    draw, ports = random.Random(SEED), (first, first + 1, *range(first + 10, first + 20))
    for number in itertools.count():
        packet = changed(draw, samples)
        for port in ports:
            try:
                sender.sendto(packet, ("127.0.0.1", port))
            except OSError:
                pass
        if number == 500:
            print("500 packets were sent", flush=True)
        time.sleep(1 / RATE)


beside(send)
