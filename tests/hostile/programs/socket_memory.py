"""Sends to sockets that nobody reads. KIND: tcp or udp. MOST: bytes that the kernel may keep."""

import socket
import time

SOCKETS, SECONDS = 800, 2.0


def kept_of_a_stream(server):
    """How many bytes one more connection takes."""
    client = socket.create_connection(server.getsockname(), timeout=1)
    kept.extend((client, server.accept()[0]))
    client.setblocking(False)
    total = 0
    try:
        while True:
            total += client.send(bytes(1_000_000))
    except BlockingIOError:
        return total


def kept_of_datagrams(sender):
    """How many bytes one more receiver takes: what is over its bound, or the group's, is lost."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.bind(("127.0.0.1", 0))
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 30)
    receiver.setblocking(False)
    for _ in range(300):
        sender.sendto(bytes(60_000), receiver.getsockname())
    kept.append(receiver)
    return 0


def in_receivers():
    total = 0
    for receiver in kept:
        try:
            while True:
                total += len(receiver.recv(65_536))
        except BlockingIOError:
            pass
    return total


def fill():
    end, total = time.monotonic() + SECONDS, 0
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM if KIND == "tcp" else socket.SOCK_DGRAM) as one:
        if KIND == "tcp":
            one.bind(("127.0.0.1", 0))
            one.listen(SOCKETS)
            one.settimeout(1)
        while len(kept) < SOCKETS and time.monotonic() < end:
            try:
                total += kept_of_a_stream(one) if KIND == "tcp" else kept_of_datagrams(one)
            except TimeoutError:
                break
    total += in_receivers() if KIND == "udp" else 0
    print("kept", total, "in", len(kept), flush=True)
    return total if total > MOST else None


kept = []
attempt("socket memory", fill)
kept.clear()
