"""Starts programs inside a sandbox, from outside: no process of the submission can see this one.

The grading process forks it at its very start, while it has a single thread and no secrets: between fork
and exec of each program, Python has to run, which is unsafe in a process with threads. Requests come over
a socket, one message per packet, and are answered in order. Each sandbox has its own launcher, which the
first one forks, because a process cannot leave a namespace that it has entered.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import resource
import signal
import socket
import sys
import termios
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NoReturn

from course.isolation import linux
from course.isolation.identity import join
from course.isolation.isolation_plan import TEMPORARY, IsolationPlan, rlimits
from course.isolation.system_calls import refusing
from course.model import codec

# For a command line and an environment; the kernel accepts less than that for both.
PACKET = 4 * 1024 * 1024
MOST_DESCRIPTORS = 8
MEMORY = "/dev/shm"
TERMINALS = "/dev/pts"
_OOM_SCORE = Path("/proc/self/oom_score_adj")
_PER_PROCESS = ("mnt", "ipc", "uts")


@dataclass(frozen=True)
class Order:
    """A program to start. descriptors: the numbers for the descriptors sent with it, after the terminal.

    own_memory: folders that it sees in its own /dev/shm; None if it shares one.
    """

    command: tuple[str, ...]
    environment: Mapping[str, str]
    folder: str
    descriptors: tuple[int, ...] = ()
    own_memory: tuple[str, ...] | None = None


def serve(link: socket.socket) -> None:
    """Answer requests until the other side is gone."""
    launcher = _Launcher()
    while True:
        data, descriptors, _, _ = socket.recv_fds(link, PACKET, MOST_DESCRIPTORS)
        if not data:
            return
        try:
            answer = launcher.answer(json.loads(data), descriptors)
        except OSError as error:
            answer = {"errno": error.errno, "error": error.strerror, "file": str(error.filename or "")}
        finally:
            for descriptor in descriptors:
                os.close(descriptor)
        link.send(json.dumps(answer).encode())


class _Launcher:
    def __init__(self) -> None:
        self._plan: IsolationPlan
        self._namespaces: dict[str, int] = {}
        self._per_process: tuple[str, ...] = _PER_PROCESS

    def answer(self, asked: dict[str, Any], descriptors: list[int]) -> dict[str, Any]:
        kind = asked.pop("kind")
        if kind == "fork":
            if os.fork() == 0:
                _serve_alone(socket.socket(fileno=os.dup(descriptors[0])))
            return {}
        if kind == "prepare":
            self._prepare(codec.from_json(asked["plan"], IsolationPlan, "the plan"))
            return {}
        if kind == "enter":
            self._enter(asked["holder"])
            return {}
        if kind == "start":
            return {"pid": self._start(Order(**asked), descriptors)}
        if kind == "reap":
            _, status = os.waitpid(asked["pid"], 0)
            return {"code": os.waitstatus_to_exitcode(status)}
        return {}

    def _prepare(self, plan: IsolationPlan) -> None:
        """Join the control groups, so that children are in them: moving each child would take longer."""
        self._plan = plan
        join([Path(group) for group in plan.control_groups])
        with contextlib.suppress(OSError):  # only root may
            _OOM_SCORE.write_text("-900", encoding="ascii")  # if memory runs out, we are not the cause

    def _enter(self, holder: int) -> None:
        """Put future children into the holder's pid namespace; each enters the other namespaces itself."""
        if self._plan.own_network:
            self._per_process = (*_PER_PROCESS, "net")
        for name in ("user", "pid", *self._per_process):
            path = f"/proc/{holder}/ns/{name}"
            self._namespaces[name] = os.open(path, os.O_RDONLY | os.O_CLOEXEC)
        if self._plan.user is None:
            # The outer one owns the other namespaces: without rights in it, we can enter none of them.
            around = linux.parent_namespace(self._namespaces["user"])
            linux.enter_namespace(around)
            os.close(around)
        self._bound_terminals()
        linux.enter_namespace(self._namespaces["pid"])

    def _bound_terminals(self) -> None:
        """Bubblewrap sets no limit. In a child, because a process cannot leave a namespace again."""
        pid = os.fork()
        if pid == 0:
            with contextlib.suppress(OSError):  # a kernel without such limits still runs programs
                linux.enter_namespace(self._namespaces["mnt"])
                linux.bound_terminals(TERMINALS, self._plan.limits.terminals)
            os._exit(0)  # noqa: TID251 - a forked child must not run our cleanups
        os.waitpid(pid, 0)

    def _start(self, order: Order, descriptors: list[int]) -> int:
        """The pid of the running program. Raises OSError if it could not be put into the sandbox."""
        reading, writing = os.pipe()
        pid = os.fork()
        if pid == 0:
            os.close(reading)
            self._become(order, descriptors, writing)
        os.close(writing)
        with os.fdopen(reading, "rb") as trouble:
            said = trouble.read()  # closes when the program has been executed
        if said:
            os.waitpid(pid, 0)
            number, _, text = said.decode().partition(" ")
            raise OSError(int(number), text)
        return pid

    def _become(self, order: Order, descriptors: Sequence[int], trouble: int) -> NoReturn:
        try:
            # Move it away from the requested numbers.
            trouble = fcntl.fcntl(trouble, fcntl.F_DUPFD_CLOEXEC, 1 + max(3, *order.descriptors, 3))
            os.setsid()
            fcntl.ioctl(descriptors[0], termios.TIOCSCTTY, 0)
            self._confine(order.own_memory)
            os.chdir(order.folder)
            _hand_on(descriptors, (0, *order.descriptors), keep=trouble)
        except BaseException as error:  # noqa: BLE001 - the other side of the fork raises it
            number = error.errno if isinstance(error, OSError) and error.errno else 0
            os.write(trouble, f"{number} {type(error).__name__}: {error}".encode()[:4000])
            os._exit(1)  # noqa: TID251 - a forked child must not run our cleanups
        _execute(order)

    def _confine(self, own_memory: Sequence[str] | None) -> None:
        plan = self._plan
        with contextlib.suppress(OSError):
            _OOM_SCORE.write_text("0", encoding="ascii")
        for name in self._per_process:
            linux.enter_namespace(self._namespaces[name])
        if own_memory is not None:
            linux.mount_memory(MEMORY, TEMPORARY, own_memory)
        for number, value in rlimits(plan.limits):
            hard = resource.getrlimit(number)[1]
            most = value if hard == resource.RLIM_INFINITY else min(value, hard)
            resource.setrlimit(number, (most, most))
        linux.process_control(linux.PR_SET_NO_NEW_PRIVS, 1)
        os.umask(0o022)
        if plan.user is None:
            linux.enter_namespace(self._namespaces["user"])  # exec drops all rights inside
        linux.drop_all_rights()
        if plan.user is not None:
            os.setgroups([])
            os.setresgid(plan.user, plan.user, plan.user)
            os.setresuid(plan.user, plan.user, plan.user)
        linux.filter_calls(refusing())


def _hand_on(descriptors: Sequence[int], numbers: Sequence[int], keep: int) -> None:
    """Give these descriptors these numbers, the first one also 1 and 2, and close all others."""
    copies = [fcntl.fcntl(descriptor, fcntl.F_DUPFD, keep + 1) for descriptor in descriptors]
    wanted = list(zip((*copies, copies[0], copies[0]), (*numbers, 1, 2), strict=True))
    for copy, number in wanted:
        os.dup2(copy, number)
    low = 3
    for number in sorted({keep, *(number for _, number in wanted if number > 2)}):
        os.closerange(low, number)
        low = number + 1
    os.closerange(low, _limit_of_descriptors())


def _limit_of_descriptors() -> int:
    return min(resource.getrlimit(resource.RLIMIT_NOFILE)[0], 1 << 20)


def _execute(order: Order) -> NoReturn:
    for number in (signal.SIGPIPE, signal.SIGXFSZ):  # Python ignores them
        signal.signal(number, signal.SIG_DFL)
    name = order.command[0]
    try:
        os.execvpe(name, order.command, dict(order.environment))
    except OSError as error:
        # In the words of setsid(1), which starts programs if there is no sandbox.
        os.write(2, f"setsid: failed to execute {name}: {error.strerror}\n".encode())
        os._exit(127 if isinstance(error, FileNotFoundError) else 126)  # noqa: TID251 - see above


def fork_launcher() -> socket.socket:
    """Start the first launcher, for `another_launcher`. Call this while there is a single thread."""
    ours, theirs = socket_pair()
    if os.fork() == 0:
        _serve_alone(theirs)
    theirs.close()
    return ours


def another_launcher(first: socket.socket) -> socket.socket:
    """A launcher for one `sandbox.Sandbox`. It ends when that socket is closed. Raises OSError."""
    ours, theirs = socket_pair()
    with theirs:
        socket.send_fds(first, [as_message("fork")], [theirs.fileno()])
        if not first.recv(PACKET):
            raise BrokenPipeError("the first launcher has ended")
    return ours


def socket_pair() -> tuple[socket.socket, socket.socket]:
    """Two ends that take messages of up to PACKET bytes."""
    ends = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    for end in ends:
        end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, PACKET)
    return ends


def _serve_alone(link: socket.socket) -> NoReturn:
    code = 1
    with contextlib.suppress(BaseException):
        _let_go_of_everything(link.fileno())
        serve(link)
        code = 0
    os._exit(code)  # noqa: TID251 - a forked child must not run our cleanups


def _let_go_of_everything(link: int) -> None:
    """Close everything, above all the pipe for verdicts and the file with the job."""
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):
        os.dup2(nothing, number)
    os.closerange(3, link)
    os.closerange(link + 1, _limit_of_descriptors())
    sys.stdin = sys.stdout = None  # they no longer belong to us


def as_message(kind: str, **fields: Any) -> bytes:
    return json.dumps({"kind": kind, **fields}).encode()


def start_message(order: Order) -> bytes:
    return as_message("start", **asdict(order))
