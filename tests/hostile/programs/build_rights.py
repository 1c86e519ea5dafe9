"""Looks for rights, other processes and ways out."""

import ctypes
import os
import signal
import socket

LIBC = ctypes.CDLL(None, use_errno=True)
PTRACE_ATTACH, CLONE_NEWUSER, CLONE_NEWNS = 16, 0x10000000, 0x00020000


def call(function, *arguments):
    return f"{function.__name__} worked" if function(*arguments) == 0 else None


def rights():
    with open("/proc/self/status") as file:
        status = dict(line.rstrip("\n").split(":\t", 1) for line in file)
    names = ("CapEff", "CapPrm", "CapInh", "CapBnd", "CapAmb")
    bad = [name for name in names if int(status[name], 16)]
    bad += [status["Uid"]] * ("0" in status["Uid"].split())
    return bad + ["privileges"] * (status["NoNewPrivs"] != "1") or None


def first_process():
    """bubblewrap's own, which is another user's."""
    os.kill(1, signal.SIGKILL)
    os.kill(1, 0)


def strangers():
    """Processes that do not come from this build."""
    known = ("python", "bwrap", "colcon", "cmake", "sh", "env", "gmake", "make")
    first = ("1", "bash")  # ours, which tells how the build ended
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        with open(f"/proc/{pid}/comm") as file:
            name = file.read().strip()
        if not name.startswith(known) and (pid, name) != first:
            found.append((pid, name))
    return found or None


def become_root():
    os.setuid(0)
    return os.getuid()


def device():
    os.mknod("breach-device", 0o020666, os.makedev(1, 1))
    return "made"


attempt("rights", rights)
attempt("first process", first_process)
attempt("ptrace", lambda: call(LIBC.ptrace, PTRACE_ATTACH, 1, 0, 0))
attempt("user namespace", lambda: call(LIBC.unshare, CLONE_NEWUSER))
attempt("mount namespace", lambda: call(LIBC.unshare, CLONE_NEWNS))
attempt("chroot", lambda: os.chroot("/tmp") or "worked")
attempt("root", become_root)
attempt("device", device)
attempt("strangers", strangers)
attempt("raw socket", lambda: socket.socket(socket.AF_INET, socket.SOCK_RAW, 1))
attempt("terminal", lambda: open("/dev/tty"))
attempt("pseudo-terminal", os.openpty)
