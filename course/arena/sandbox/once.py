"""One command in a sandbox of its own, from outside of any: for builds."""

from __future__ import annotations

import contextlib
import json
import os
import select
import shlex
import signal
import subprocess
import threading
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from course.arena.enclosure import bwrap
from course.arena.remembered import unless_known
from course.arena.sandbox.identity import Identity, identity
from course.arena.sandbox.inner import arguments, data, users
from course.arena.sandbox.limits import Limits, most_processes
from course.arena.sandbox.plan import Plan
from course.arena.sandbox.system_calls import refusing
from course.arena.sandbox.view import hidden, shown
from course.errors import OurFault
from course.rosenv import Ros

_PROBE_TIMEOUT = 10.0
_END_TIMEOUT = 30.0


@dataclass(frozen=True)
class Confinement:
    """Where commands are started; who: what they run as. plan: None without confinement.

    folder: where they are started. writable: folders that they may write to.
    """

    who: Identity = field(default_factory=lambda: Identity(None))
    plan: Plan | None = None
    folder: Path = Path("/")
    writable: tuple[Path, ...] = ()

    @contextlib.contextmanager
    def entrance(self) -> Iterator[tuple[tuple[str, ...], tuple[int, ...]]]:
        """For one command: what to put before it, and what it inherits. Held while it runs.

        At the end all processes of it have ended, also those that it left behind. Raises OurFault when
        they do not.
        """
        if self.plan is None:
            yield (), ()
            return
        with contextlib.ExitStack() as stack:
            texts = [(stack.enter_context(data(text)), name) for name, text in users(self.plan)]
            told, gate = stack.enter_context(_watched_first_process())
            given = [number for number, _ in texts] + [told, gate]
            words = ["--info-fd", str(told), "--block-fd", str(gate), "--unshare-net"]
            if instructions := refusing():
                given.append(stack.enter_context(data(instructions)))
                words += ["--seccomp", str(given[-1])]
            words += [*arguments(self.plan, self.writable, texts), "--chdir", str(self.folder), "--"]
            yield (*_joining(self.who), bwrap(), *words, *_without_rights(self.plan)), tuple(given)


@contextlib.contextmanager
def confinement(
    ros: Ros,
    environment: Mapping[str, str],
    folder: Path,
    writable: Sequence[Path],
    more: Sequence[Path],
    limits: Limits,
) -> Iterator[Confinement]:
    """No network, no process but its own, no file but what it needs; held until the end.

    folder: where commands are started. writable: folders, which belong to the sandbox's user from now on.
    more: what else it reads. Without bubblewrap there is no confinement.
    """
    if unless_known("confined-builds", bwrap(), once_obstacle) is not None:
        yield Confinement()
        return
    visible = shown(ros, environment, more)
    with identity(limits) as who:
        plan = Plan(who.user, visible, hidden(visible), (), limits)
        yield Confinement(who, plan, folder, tuple(writable))


@contextlib.contextmanager
def _watched_first_process() -> Iterator[tuple[int, int]]:
    """Descriptors for bubblewrap: to tell of the first process of its namespaces, and to wait for our answer.

    It ends with its command, or is killed, a moment before what else is left in there.
    """
    told, telling = os.pipe()
    gate, opening = os.pipe()
    known: list[int] = []
    thread = threading.Thread(target=_note_first_process, args=(told, opening, known), daemon=True)
    thread.start()
    try:
        yield telling, gate
    finally:
        os.close(telling)
        thread.join()
        for descriptor in (told, gate, opening):
            os.close(descriptor)
        for process in known:
            _end(process)


def _note_first_process(told: int, opening: int, known: list[int]) -> None:
    said = b""
    while not said.rstrip().endswith(b"}"):
        more = os.read(told, 4096)
        if not more:  # it did not get that far
            return
        said += more
    with contextlib.suppress(ProcessLookupError):  # it was killed again
        known.append(os.pidfd_open(json.loads(said)["child-pid"]))
    os.write(opening, b"!")


def _end(process: int) -> None:
    """The kernel lets the first process of a namespace end only after all others."""
    try:
        with contextlib.suppress(ProcessLookupError):
            signal.pidfd_send_signal(process, signal.SIGKILL)
        if not select.select([process], [], [], _END_TIMEOUT)[0]:
            raise OurFault("the processes of a build do not end")
    finally:
        os.close(process)


def once_obstacle() -> str | None:
    """Why commands cannot be confined here; None when they can."""
    place = Confinement(plan=Plan(0 if os.geteuid() == 0 else None, ()))
    try:
        with place.entrance() as (prefix, given):
            command = (*prefix, "/bin/true")
            done = subprocess.run(
                command, capture_output=True, timeout=_PROBE_TIMEOUT, check=False, pass_fds=given
            )
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"bubblewrap does not start here: {error}"
    return done.stderr.decode(errors="replace").strip() or "it failed" if done.returncode else None


def _joining(who: Identity) -> tuple[str, ...]:
    if not who.control_groups:
        return ()
    files = " ".join(shlex.quote(str(group / "cgroup.procs")) for group in who.control_groups)
    script = f'for file in {files}; do echo 0 > "$file" || exit 126; done; exec "$@"'
    return ("/bin/sh", "-c", script, "sh")


def _without_rights(plan: Plan) -> tuple[str, ...]:
    limits = plan.limits
    bounds = (
        f"--nproc={most_processes(limits)}",
        f"--fsize={limits.file}",
        f"--nofile={limits.files}",
        f"--as={limits.address_space}",
        "--core=0",
    )
    user = plan.user
    rights = (
        ("--reuid", str(user), "--regid", str(user), "--clear-groups", "--bounding-set=-all")
        if user is not None
        else ()
    )
    return ("prlimit", *bounds, "--", "setpriv", "--no-new-privs", "--inh-caps=-all", *rights, "--")
