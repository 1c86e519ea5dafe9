"""Tries to get out: rights, other processes, devices, namespaces, and the kernel's odd corners.

TERMINALS: how many pseudo-terminals there are for it.
"""

import contextlib
import ctypes
import fcntl
import glob
import os
import pathlib
import platform
import signal
import socket
import struct
import subprocess
import termios

LIBC = ctypes.CDLL(None, use_errno=True)
ARM = platform.machine() == "aarch64"
CLONE_NEWUSER, CLONE_NEWNS = 0x10000000, 0x00020000


def call(number, arm, *arguments):
    """A system call; what it returns, if it works."""
    result = LIBC.syscall(arm if ARM else number, *arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return f"returned {result}"


def others():
    return [int(pid) for pid in os.listdir("/proc") if pid.isdigit() and int(pid) != os.getpid()]


def of_any(act):
    """What succeeds with some other process."""
    found = []
    for pid in others():
        try:
            act(pid)
            found.append(pid)
        except OSError:
            pass
    return found or None


def rights():
    with open("/proc/self/status") as file:
        status = dict(line.rstrip("\n").split(":\t", 1) for line in file)
    bad = [key for key in ("CapEff", "CapPrm", "CapInh", "CapBnd", "CapAmb") if int(status[key], 16)]
    if status["NoNewPrivs"] != "1" or status["Seccomp"] != "2" or "0" in status["Uid"].split():
        bad.append(str(status))
    return bad or None


def setuid_programs():
    """They run, and give nothing."""
    nothing = subprocess.DEVNULL
    for command in (["su", "-c", "id"], ["mount", "-t", "tmpfs", "none", "/tmp"], ["unshare", "-r", "id"]):
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=10, stdin=nothing)
        except OSError:
            continue
        if done.returncode == 0 or "uid=0" in done.stdout:
            return command, done.stdout
    return None


def namespaces():
    pid = LIBC.syscall(220 if ARM else 56, CLONE_NEWUSER | signal.SIGCHLD, 0, 0, 0, 0)
    if pid == 0:
        os._exit(0)
    return pid if pid > 0 else None


def clone3():
    arguments = struct.pack("11Q", CLONE_NEWUSER, 0, 0, 0, signal.SIGCHLD, 0, 0, 0, 0, 0, 0)
    pid = LIBC.syscall(435, ctypes.c_char_p(arguments), len(arguments))
    if pid == 0:
        os._exit(0)
    return pid if pid > 0 else None


def families():
    """Kinds of networks that are of no use to a ROS program."""
    found = []
    for family in range(1, 46):
        for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM, socket.SOCK_RAW):
            try:
                socket.socket(family, kind).close()
                found.append((family, kind))
            except OSError:
                pass
    allowed = {(family, kind) for family in (1, 2, 10, 16) for kind in (1, 2, 3)} - {(2, 3), (10, 3)}
    return set(found) - allowed or None


def devices():
    """Of the kinds that one can do harm with; or made by oneself."""
    harmless = {"null", "zero", "full", "random", "urandom", "tty", "pts", "ptmx", "shm", "fd", "console"}
    found = set(os.listdir("/dev")) - harmless - {"stdin", "stdout", "stderr", "core"}
    return found or None


def make_device():
    os.mknod("/tmp/disk", 0o60600, os.makedev(254, 0))
    return "made"


def kernel_settings():
    found = []
    for place in (
        "/proc/sysrq-trigger",
        "/proc/sys/kernel/core_pattern",
        "/proc/sys/vm/drop_caches",
        "/proc/self/oom_score_adj",
        "/proc/sys/user/max_user_namespaces",
        "/proc/1/oom_score_adj",
        "/proc/1/setgroups",
        "/proc/self/uid_map",
    ):
        try:
            with open(place, "w") as file:
                file.write("-1000")
            found.append(place)
        except OSError:
            pass
    return found or None


def control_groups():
    return glob.glob("/sys/fs/cgroup/**/cgroup.procs", recursive=True)[:3] or None


def type_for_another():
    return fcntl.ioctl(0, termios.TIOCSTI, b"x")


def steal_a_terminal():
    """Those of other programs of the grading."""
    found = []
    for name in glob.glob("/dev/pts/[0-9]*"):
        if name != os.ttyname(0):
            os.close(os.open(name, os.O_RDWR | os.O_NOCTTY))
            found.append(name)
    return found or None


def terminals():
    """A few are there for launch files; all others of the machine are for others."""
    taken = []
    with contextlib.suppress(OSError):
        while len(taken) <= TERMINALS:
            taken.append(os.openpty())
    for both in taken:
        for descriptor in both:
            os.close(descriptor)
    return None if len(taken) == TERMINALS else len(taken)


def limits():
    import resource

    before = resource.getrlimit(resource.RLIMIT_NPROC)
    resource.setrlimit(resource.RLIMIT_NPROC, (before[0] + 1, before[1] + 1))
    return "raised"


def stand_back():
    """To let all others go first, and to say then that the machine was too busy."""
    found = []
    os.nice(5)
    os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))
    call(314, 274, 0, struct.pack("IIQiIQQQ", 48, 0, os.SCHED_IDLE, 5, 0, 0, 0, 0), 0)
    if os.getpriority(os.PRIO_PROCESS, 0) or os.sched_getscheduler(0) != os.SCHED_OTHER:
        found.append("its priority")
    for name, value in (("autogroup", "5"), ("timerslack_ns", "1000000000")):
        try:
            found.append(pathlib.Path("/proc/self", name).write_text(value))
        except OSError:
            pass
    return found or None


def peek(pid):
    place = ctypes.create_string_buffer(8)
    vector = struct.pack("2Q", ctypes.addressof(place), 8)
    call(310, 270, pid, vector, 1, vector, 1, 0)


def pid_descriptor(pid):
    descriptor = os.pidfd_open(pid)
    call(438, 438, descriptor, 1, 0)


def first_process():
    """What it holds, and the files that it has open."""
    found = []
    for name in ("mem", "environ", "maps", "root", "cwd", "fd/0", "fd/1"):
        try:
            os.close(os.open(f"/proc/1/{name}", os.O_RDWR if name == "mem" else os.O_RDONLY))
            found.append(name)
        except OSError:
            pass
    return found or None


for act in (
    rights,
    setuid_programs,
    namespaces,
    clone3,
    families,
    devices,
    make_device,
    kernel_settings,
    control_groups,
    type_for_another,
    steal_a_terminal,
    terminals,
    limits,
    stand_back,
    first_process,
):
    attempt(act.__name__, act)
attempt("ptrace", lambda: of_any(lambda pid: call(101, 117, 16, pid, 0, 0)))
attempt("process_vm_readv", lambda: of_any(peek))
attempt("pidfd_getfd", lambda: of_any(pid_descriptor))
attempt("signal", lambda: of_any(lambda pid: os.kill(pid, signal.SIGSTOP)))
attempt("priority", lambda: os.nice(-5) or None)
attempt("unshare", lambda: call(272, 97, CLONE_NEWUSER | CLONE_NEWNS))
attempt("mount", lambda: call(165, 40, b"none", b"/tmp", b"tmpfs", 0, 0))
attempt("chroot", lambda: os.chroot("/tmp") or "done")
attempt("setuid", lambda: os.setuid(0) or "done")
attempt("setgroups", lambda: os.setgroups([0]) or "done")
attempt("keyctl", lambda: call(250, 219, 0, -3, 1))
attempt("bpf", lambda: call(321, 280, 0, 0, 0))
attempt("perf_event_open", lambda: call(298, 241, 0, 0, -1, -1, 0))
attempt("userfaultfd", lambda: call(323, 282, 1))
attempt("io_uring", lambda: call(425, 425, 4, ctypes.create_string_buffer(128)))
attempt("memfd_secret", lambda: call(447, 447, 0))
attempt("memfd_create", lambda: os.memfd_create("breach"))
attempt("shmget", lambda: call(29, 194, 0, 4096, 0o1600))
attempt("landlock", lambda: call(444, 444, 0, 0, 1))
attempt("mptcp", lambda: socket.socket(socket.AF_INET, socket.SOCK_STREAM, 262))
attempt("mptcp6", lambda: socket.socket(socket.AF_INET6, socket.SOCK_STREAM, 262))
attempt("sctp", lambda: socket.socket(socket.AF_INET, socket.SOCK_SEQPACKET))
attempt("sock_diag", lambda: socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 4))
attempt("udev", lambda: socket.socket(socket.AF_NETLINK, socket.SOCK_DGRAM, 15))
attempt("pair of tipc", lambda: socket.socketpair(30, socket.SOCK_SEQPACKET))
attempt("kernel log", lambda: call(103, 116, 3, ctypes.create_string_buffer(64), 64))
attempt("other architecture", lambda: call(0x40000000 + 39, 0x40000000 + 39))
# The kernel does not tell who was hit. The verdict does.
attempt("kill everybody", lambda: os.kill(-1, signal.SIGKILL))
