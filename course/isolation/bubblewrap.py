"""Isolation in namespaces that bubblewrap makes. See `course.isolation.Backend`.

Source: bwrap(1). About the settings that deny namespaces to ordinary users: apparmor.d(5), the release notes
of Ubuntu 24.04, and Documentation/admin-guide/sysctl/{user,kernel}.rst of Linux.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import shlex
import shutil
import signal
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import IO, Any

from course.errors import OurFault
from course.isolation import none
from course.isolation.isolation_plan import (
    SCRATCH,
    TEMPORARY,
    Holder,
    IsolatedProcess,
    IsolationPlan,
    Level,
    Restriction,
    most_processes,
)
from course.isolation.system_calls import refusing
from course.isolation.view import SYSTEM

_PROBE_TIMEOUT = 30.0
_BUSY = 2.0  # at this many waiting programs per processor, starts become slow
_START_TIME = 20.0
_END_TIMEOUT = 30.0
_READY = b"ready\n"
_SETTINGS = Path("/proc/sys")
_PROFILE = "profile bwrap /usr/bin/bwrap flags=(unconfined) { userns, }"

_APART = "--die-with-parent --unshare-net --unshare-pid --unshare-ipc".split()
_WRITABLE = "--dev-bind / / --proc /proc --tmpfs /dev/shm".split()
_READABLE = (
    f"--ro-bind / / --proc /proc --dev /dev --size {TEMPORARY} --tmpfs /dev/shm --dir {SCRATCH} --tmpfs /tmp"
).split()
# The machine has about 3,000 pseudo-terminals, and builds need none.
_NO_TERMINALS = ("--tmpfs", "/dev/pts", "--remount-ro", "/dev/pts")
# Ends bubblewrap when we end, until its own --die-with-parent takes effect. $0 is our pid: if we end before
# the kernel knows about this, nothing starts. A bubblewrap that nobody listens to hangs forever.
_WITH_US = "setpriv --pdeathsig KILL -- /bin/sh -c".split()
_IF_WE_ARE_HERE = '[ "$PPID" = "$0" ] || exit 126; '
_NAMESPACES = "--die-with-parent --unshare-pid --unshare-ipc --unshare-uts --hostname robot".split()
# The only user inside that is not root. Nested user namespaces cannot have others.
_USER = "--unshare-user --uid 1000 --gid 1000 --disable-userns".split()
# The files of /etc that programs read, except those about this machine or its users.
_ETC = (
    "alternatives bash.bashrc bash_completion.d default/locale inputrc ld.so.cache ld.so.conf ld.so.conf.d "
    "locale.alias localtime lsb-release mime.types nsswitch.conf os-release profile profile.d protocols "
    "python3 python3.10 python3.11 python3.12 python3.13 services shells skel ssl/certs ssl/openssl.cnf "
    "terminfo timezone"
).split()
# A right that does nothing: processes of the same user without it cannot reach a process that has it.
_GUARDED = ("--cap-add", "CAP_WAKE_ALARM")
# SCRATCH may contain files that programs need.
_OWN_MEMORY = (
    f"--die-with-parent --dev-bind / / --perms 1777 --tmpfs /dev/shm --bind-try {SCRATCH} {SCRATCH} --"
).split()
# The first process of a build's namespaces, which nothing inside can kill. It reports the command's exit
# code; bash's own message about how the command ended does not belong in the output.
_TELLING = 'exec 3>&2 2>/dev/null; "$@" 2>&3 3>&- {0}>&-; code=$?; echo "$code" >&{0}; exit "$code"'
# The first process of an arena's namespaces, so no signal from inside ends it. It ignores SIGCHLD, so it
# need not reap orphans. It ends when our end of its input closes.
_IGNORING = "env --ignore-signal=CHLD"
# It reports ready only when it starts no more processes: they would shift the pids that programs see.
_HOLDING = f"{_IGNORING} true 2>/dev/null; no=$?; echo ready; [ $no = 0 ] && exec {_IGNORING} cat; exec cat"


def program() -> str:
    """See `isolation.Backend`."""
    return shutil.which("bwrap") or "bwrap"


def obstacle(level: Level) -> str | None:
    """Why this level is not available here, in one line with what to do; None if it is."""
    if level is Level.DOMAIN:
        return None
    if level is Level.NAMESPACES:
        return _namespace_obstacle()
    inner = [program(), *arguments(_someone()), "--", "/bin/true"]
    found = _tried(
        [program(), *_APART, *_READABLE, *inner], "this system does not allow a sandbox inside namespaces"
    )
    return found and (_namespace_obstacle() or found)


def build_obstacle() -> str | None:
    """Why build commands cannot be confined here; None if they can."""
    if shutil.which(program()) is None:
        return "bubblewrap does not start here: it is not installed"
    options: dict[str, Any] = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL}
    try:
        with start(_someone(own_network=True), ["/bin/true"], stderr=subprocess.PIPE, **options) as started:
            _, said = started.process.communicate(timeout=_PROBE_TIMEOUT)
    except (OSError, subprocess.TimeoutExpired) as error:
        return _why(error)
    return said.decode(errors="replace").strip() or "it failed" if started.process.returncode else None


def _namespace_obstacle() -> str | None:
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed: `sudo apt install bubblewrap`"
    command = [*prefix(IsolationPlan(machine="write")), "true"]
    return _tried(command, "this system does not allow namespaces")


def _tried(command: Sequence[str], refused: str) -> str | None:
    """Why this command cannot be run; None if it can. refused: what it means if it fails."""
    try:
        done = subprocess.run(command, capture_output=True, timeout=_PROBE_TIMEOUT, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return _why(error)
    return f"{refused} ({_complaint(done)})" if done.returncode else None


def _why(error: OSError | subprocess.TimeoutExpired) -> str:
    load = os.getloadavg()[0]
    if isinstance(error, OSError):
        return f"bubblewrap does not start here: {error}"
    if load > _BUSY * (os.cpu_count() or 1):
        return f"it is too busy to test bubblewrap (load {load:.0f}), so try again when less is running"
    return f"bubblewrap does not start here: it hung for {_PROBE_TIMEOUT:.0f} s"


def _someone(own_network: bool = False) -> IsolationPlan:
    return IsolationPlan(0 if os.geteuid() == 0 else None, own_network=own_network)


def _complaint(done: subprocess.CompletedProcess[bytes]) -> str:
    """The last line of bubblewrap's complaint, else its exit code."""
    reason = done.stderr.decode("utf-8", errors="replace").strip().splitlines()
    return reason[-1] if reason else str(done.returncode)


def prefix(plan: IsolationPlan) -> tuple[str, ...]:
    """What to put in front of a command that sees the whole machine."""
    if plan.machine == "write":
        return (program(), *_APART, *_WRITABLE, "--chdir", "/")
    private = [path for path in plan.shown if path.startswith(("/tmp/", "/dev/shm/"))]  # the rest is there
    shown = (word for path in private for word in ("--ro-bind-try", path, path))
    written = (word for path in plan.write for word in ("--bind-try", path, path))
    return (program(), *_APART, *_READABLE, *shown, *written, "--chdir", "/")


def with_own_memory(command: Sequence[str]) -> tuple[str, ...]:
    """The command, with its own private /dev/shm."""
    return (program(), *_OWN_MEMORY, *command)


@contextlib.contextmanager
def start(plan: IsolationPlan, command: Sequence[str], **options: Any) -> Iterator[IsolatedProcess]:
    """See `isolation.start`. If the machine is hidden, there is no network, and `cwd` is inside."""
    if plan.machine != "hidden":
        with none.start(None, [*prefix(plan), *command], **options) as started:
            yield started
        return
    with contextlib.ExitStack() as stack:
        texts = [(stack.enter_context(data(text)), name) for name, text in users(plan)]
        info, telling = stack.enter_context(_pipe())  # says which process is the namespaces' first
        gate, opening = stack.enter_context(_pipe())  # it waits until we have noted that
        ending, ended = stack.enter_context(_pipe())  # how the command ended
        given = [*(number for number, _ in texts), *(end.fileno() for end in (telling, gate, ended))]
        words = ["--info-fd", str(telling.fileno()), "--block-fd", str(gate.fileno()), "--as-pid-1"]
        if instructions := refusing():
            given.append(stack.enter_context(data(instructions)))
            words += ["--seccomp", str(given[-1])]
        words += [*arguments(plan, texts), *_NO_TERMINALS, *_GUARDED, "--chdir", str(options.get("cwd", "/"))]
        said_at_the_end = _TELLING.format(ended.fileno())
        first = ("--", "/bin/bash", "-c", said_at_the_end, "bash", *_without_rights(plan))
        whole = [*with_us(plan), program(), *words, *first, *command]
        started = stack.enter_context(none.start(None, whole, pass_fds=given, **options))
        telling.close()
        if (pid := _first_process(info)) is not None:
            with contextlib.suppress(ProcessLookupError):  # it has been killed already
                stack.callback(_end, os.pidfd_open(pid))
        opening.write(b"!")
        yield IsolatedProcess(started.process, lambda: bool(_ready([ending], 0) and ending.read(100)))


@contextlib.contextmanager
def hold(plan: IsolationPlan, scratch: Path | None = None) -> Iterator[Holder]:
    """See `isolation.Backend`."""
    with contextlib.ExitStack() as stack:
        hidden = plan.machine == "hidden"
        texts = [(stack.enter_context(data(text)), name) for name, text in (users(plan) if hidden else ())]
        info, telling = stack.enter_context(_pipe())
        words = [program(), *arguments(plan, texts, scratch), *_GUARDED] if hidden else [*prefix(plan)]
        words += ["--as-pid-1", "--info-fd", str(telling.fileno())]
        started = stack.enter_context(
            none.start(
                None,
                [*words, "--", "/bin/sh", "-c", _HOLDING],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={"PATH": os.environ.get("PATH", os.defpath)},  # programs may be able to read it
                pass_fds=(telling.fileno(), *(number for number, _ in texts)),
            )
        )
        telling.close()
        process = started.process
        said = _until_ready(process)
        pid = _first_process(info)
        if pid is None or not said.endswith(_READY):
            raise OurFault(f"the sandbox did not start: {said.decode(errors='replace').strip()}")
        yield Holder(pid, lambda: _answers(process))


def _answers(process: subprocess.Popen[bytes]) -> bool:
    """Whether the first process and bubblewrap are alive: then the process repeats what it is told."""
    assert process.stdin is not None
    try:
        os.write(process.stdin.fileno(), _READY)
    except BrokenPipeError:
        return False
    return _until_ready(process).endswith(_READY)


def _until_ready(process: subprocess.Popen[bytes]) -> bytes:
    """What the process prints until it says that it is ready, or until it ends."""
    assert process.stdout is not None
    said = b""
    while not said.endswith(_READY):
        more = os.read(process.stdout.fileno(), 4096) if _ready([process.stdout], _START_TIME) else b""
        if not more:
            break
        said += more
    return said


def arguments(
    plan: IsolationPlan, texts: Sequence[tuple[int, str]] = (), scratch: Path | None = None
) -> tuple[str, ...]:
    """Namespaces, and what is visible in them. Anything that is not named here is not there.

    texts: a file's name, and the descriptor that its text is read from. scratch: its own empty folder.
    """
    return (
        *_NAMESPACES,
        *(("--unshare-net",) if plan.own_network else ()),
        *(() if plan.user is not None else _USER),
        *("--proc", "/proc", "--dev", "/dev"),
        *("--perms", "1777", "--size", str(TEMPORARY), "--tmpfs", "/tmp"),
        *("--perms", "1777", "--size", str(TEMPORARY), "--tmpfs", "/dev/shm"),
        *_system(),
        *_mounts("--ro-bind-try", (path for path in plan.shown if not _within(path, plan.empty))),
        *(word for path in plan.empty for word in ("--tmpfs", path)),
        *(word for path, links in plan.linked for word in ("--ro-bind", links, path)),
        *_mounts("--ro-bind-try", (path for path in plan.shown if _within(path, plan.empty))),
        *_mounts("--bind", plan.write),
        *(_memory(scratch, plan.limits.scratch) if scratch else ()),
        *(word for number, name in texts for word in ("--perms", "644", "--ro-bind-data", str(number), name)),
        # All these folders are in memory without a limit, and belong to root inside.
        # In /proc, programs could also change how the kernel schedules them.
        *(word for path in ("/", "/dev", "/proc", *plan.empty) for word in ("--remount-ro", path)),
    )


def _mounts(how: str, paths: Iterable[str]) -> Iterator[str]:
    for path in paths:
        # Otherwise bubblewrap makes folders on the way that only root can enter.
        yield from ("--dir", str(Path(path).parent))
        if (target := _neighbor(Path(path))) is not None:
            yield from ("--symlink", target, path)
        else:
            yield from (how, path, path)


def _neighbor(path: Path) -> str | None:
    """The target of a link that stays a link: lib64 is another name for lib."""
    target = path.readlink() if path.is_symlink() else None
    is_near = target is not None and not target.is_absolute() and ".." not in target.parts
    return str(target) if is_near else None


def _memory(folder: Path, size: int) -> tuple[str, ...]:
    return ("--dir", str(folder.parent), "--size", str(size), "--tmpfs", str(folder))


def _within(path: str, folders: Iterable[str]) -> bool:
    return any(Path(path).is_relative_to(folder) for folder in folders)


def _system() -> Iterator[str]:
    yield from _mounts("--ro-bind-try", map(str, SYSTEM))
    yield from ("--dir", "/etc")
    for name in _ETC:
        if Path("/etc", name).exists():
            yield from ("--ro-bind", f"/etc/{name}", f"/etc/{name}")


def users(plan: IsolationPlan) -> tuple[tuple[str, str], ...]:
    """Names and texts of the files about users and machines: the same everywhere."""
    number = 1000 if plan.user is None else plan.user
    return (
        ("/etc/passwd", f"root:x:0:0:root:/root:/bin/bash\nlearner:x:{number}:{number}::/:/bin/bash\n"),
        ("/etc/group", f"root:x:0:\nlearner:x:{number}:\n"),
        ("/etc/hosts", "127.0.0.1 localhost robot\n::1 localhost\n"),
    )


@contextlib.contextmanager
def data(text: str | bytes) -> Iterator[int]:
    """A descriptor from which bubblewrap can read the text, once."""
    descriptor = os.memfd_create("text")
    try:
        os.write(descriptor, text if isinstance(text, bytes) else text.encode())
        os.lseek(descriptor, 0, os.SEEK_SET)
        yield descriptor
    finally:
        os.close(descriptor)


@contextlib.contextmanager
def _pipe() -> Iterator[tuple[IO[bytes], IO[bytes]]]:
    reading, writing = os.pipe()
    with os.fdopen(reading, "rb", buffering=0) as ours, os.fdopen(writing, "wb", buffering=0) as theirs:
        yield ours, theirs


def _first_process(info: IO[bytes]) -> int | None:
    """The pid that bubblewrap reports; None if it did not get that far. The process ends with its command.

    Raises OurFault if bubblewrap hangs.
    """
    said = b""
    while not said.rstrip().endswith(b"}"):
        if not _ready([info], _START_TIME):
            raise OurFault("the sandbox did not start in time")
        more = info.read(4096)
        if not more:
            return None
        said += more
    return int(json.loads(said)["child-pid"])


def _ready(streams: Sequence[IO[bytes]], seconds: float) -> bool:
    return bool(select.select(streams, [], [], seconds)[0])


def _end(process: int) -> None:
    """The kernel lets the first process of a namespace end only after all others."""
    try:
        with contextlib.suppress(ProcessLookupError):
            signal.pidfd_send_signal(process, signal.SIGKILL)
        if not select.select([process], [], [], _END_TIMEOUT)[0]:
            raise OurFault("the processes of a build do not end")
    finally:
        os.close(process)


def with_us(plan: IsolationPlan) -> tuple[str, ...]:
    """A prefix that starts a command in the plan's control groups, and ends it when we end."""
    files = " ".join(shlex.quote(f"{group}/cgroup.procs") for group in plan.control_groups)
    joining = f'for file in {files}; do echo 0 > "$file" || exit 126; done; ' if files else ""
    return (*_WITH_US, f'{_IF_WE_ARE_HERE}{joining}exec "$@"', str(os.getpid()))


def _without_rights(plan: IsolationPlan) -> tuple[str, ...]:
    limits, user = plan.limits, plan.user
    bounds = (
        f"--nproc={most_processes(limits)}",
        f"--fsize={limits.file}",
        f"--nofile={limits.files}",
        f"--as={limits.address_space}",
        "--core=0",
    )
    rights = (
        ("--reuid", str(user), "--regid", str(user), "--clear-groups", "--bounding-set=-all")
        if user is not None
        else ()
    )
    return ("prlimit", *bounds, "--", "setpriv", "--no-new-privs", "--inh-caps=-all", *rights, "--")


def restriction(settings: Path = _SETTINGS) -> Restriction | None:
    """See `isolation.Backend`. settings: the folder to read sysctls from."""
    if _value(settings / "kernel/apparmor_restrict_unprivileged_userns") == 1:
        return Restriction(
            "AppArmor restricts user namespaces (kernel.apparmor_restrict_unprivileged_userns is 1).",
            f"Allow them for bubblewrap: write `{_PROFILE}` into /etc/apparmor.d/bwrap, then "
            "`sudo apparmor_parser -r /etc/apparmor.d/bwrap`.",
        )
    if _value(settings / "kernel/unprivileged_userns_clone") == 0:
        return Restriction(
            "User namespaces are switched off (kernel.unprivileged_userns_clone is 0).",
            "sudo sysctl -w kernel.unprivileged_userns_clone=1",
        )
    if _value(settings / "user/max_user_namespaces") == 0:
        return Restriction(
            "No user namespace can be created (user.max_user_namespaces is 0).",
            "sudo sysctl -w user.max_user_namespaces=15000",
        )
    return None


def _value(file: Path) -> int | None:
    with contextlib.suppress(OSError, ValueError):
        return int(file.read_text(encoding="ascii"))
    return None
