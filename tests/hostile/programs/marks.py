"""Leaves a mark wherever there may be room for one, and tells which marks of an earlier run are there."""

import ctypes
import errno
import os
import socket
import time

IPC_CREAT, IPC_EXCL = 0o1000, 0o2000
KEY, NAME, PORT, MANY = 0x5EED, "mark-of-a-run", 45678, 1000
LIBC = ctypes.CDLL(None, use_errno=True)


def in_folder(folder):
    def act():
        file = os.path.join(folder, f".{NAME}")
        if os.path.exists(file):
            return file
        with open(file, "w"):
            pass

    return act


def modification_time():
    if os.stat(__file__).st_mtime == 1.0:
        return "set by an earlier run"
    os.utime(__file__, (1, 1))


def numbers_of_files():
    """Each new file gets the next number."""
    for _ in range(MANY):
        file = os.path.join(os.environ["HOME"], f".{NAME}-numbered")
        with open(file, "w"):
            number = os.stat(file).st_ino - os.stat(os.environ["HOME"]).st_ino
        os.unlink(file)
    return number if number > 1.5 * MANY else None


def process_number():
    """The first process of a sandbox is 1, what it tries at first is 2, and the first program is 3."""
    return os.getpid() if os.getpid() > 3 else None


def processes():
    known = {1, os.getpid()}
    return {int(name) for name in os.listdir("/proc") if name.isdigit()} - known or None


def is_there(made):
    """Whether the call failed because it is there already. Raises OSError when the call is refused."""
    number = ctypes.get_errno() if made == -1 else 0
    if number not in (0, errno.EEXIST):
        raise OSError(number, os.strerror(number))
    return "made by an earlier run" if number else None


def shared_memory():
    return is_there(LIBC.shmget(KEY, 4096, IPC_CREAT | IPC_EXCL | 0o600))


def message_queue():
    return is_there(LIBC.mq_open(f"/{NAME}".encode(), os.O_CREAT | os.O_EXCL | os.O_RDWR, 0o600, None))


def socket_of_a_daemon():
    mark = socket.socket(socket.AF_UNIX)
    try:
        mark.bind(f"\0{NAME}")
    except OSError as error:
        return error
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for number in (0, 1, 2):
                os.close(number)
            time.sleep(600)
        os._exit(0)


def closed_connection():
    """The kernel keeps the port of one that was closed for a minute."""
    with socket.socket() as server:
        try:
            server.bind(("127.0.0.1", PORT))
        except OSError as error:
            return error
        server.listen()
        with socket.create_connection(("127.0.0.1", PORT)):
            server.accept()[0].close()
            time.sleep(0.1)


def packets():
    """The network counts what was ever sent."""
    with open("/proc/net/dev") as file:
        counted = next(int(line.split()[2]) for line in file if line.strip().startswith("lo:"))
    if counted >= MANY:
        return counted
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for _ in range(MANY):
            sender.sendto(b"mark", ("127.0.0.1", 9))


own = {os.environ["HOME"], os.environ["TMPDIR"], os.path.dirname(__file__)}
for folder in ("/tmp", "/dev/shm", *sorted(own)):
    attempt(f"in {folder}", in_folder(folder))
for act in (modification_time, numbers_of_files, process_number, processes, shared_memory, message_queue):
    attempt(act.__name__, act)
for act in (packets, closed_connection, socket_of_a_daemon):
    attempt(act.__name__, act)
