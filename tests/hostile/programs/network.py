"""Tries to reach others over the network. HOST: addresses that somebody listens at outside of the sandbox.

TCP, UDP: port numbers. ABSTRACT: the name of a unix socket without a file; FILE: of one with a file.
OUTSIDE: an address that no machine has, so that nobody is bothered.
"""

import socket


def talk(family, kind, address):
    with socket.socket(family, kind) as link:
        link.settimeout(2)
        link.connect(address)
        link.send(b"breach")
        return link.recv(10)


def interfaces():
    return [name for _, name in socket.if_nameindex() if name != "lo"] or None


def routes():
    with open("/proc/net/route") as file:
        return file.read().splitlines()[1:] or None


def unix_sockets():
    """Named ones of others, which could be connected to."""
    with open("/proc/net/unix") as file:
        lines = [line.split() for line in file.read().splitlines()[1:]]
    return [line[7] for line in lines if len(line) > 7] or None


def broadcast():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as link:
        link.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
        return link.sendto(b"breach", ("255.255.255.255", 9))


attempt("tcp", lambda: talk(socket.AF_INET, socket.SOCK_STREAM, ("127.0.0.1", TCP)))
attempt("tcp6", lambda: talk(socket.AF_INET6, socket.SOCK_STREAM, ("::1", TCP)))
attempt("udp", lambda: talk(socket.AF_INET, socket.SOCK_DGRAM, ("127.0.0.1", UDP)))
attempt("abstract", lambda: talk(socket.AF_UNIX, socket.SOCK_STREAM, "\0" + ABSTRACT))
attempt("file", lambda: talk(socket.AF_UNIX, socket.SOCK_STREAM, FILE))
attempt("outside tcp", lambda: talk(socket.AF_INET, socket.SOCK_STREAM, (OUTSIDE, 80)))
attempt("outside udp", lambda: talk(socket.AF_INET, socket.SOCK_DGRAM, (OUTSIDE, 53)))
attempt("names", lambda: socket.getaddrinfo("example.org", 80))
for act in (interfaces, routes, unix_sockets, broadcast):
    attempt(act.__name__, act)
