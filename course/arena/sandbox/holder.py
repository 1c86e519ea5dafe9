"""Keeps the namespaces of one arena: a bubblewrap in which nothing happens."""

from __future__ import annotations

import contextlib
import json
import os
import select
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path

from course.arena.sandbox.inner import arguments, data, users
from course.arena.sandbox.plan import Plan
from course.errors import OurFault

_START_TIME = 20.0
_READY = b"ready\n"
# The first process of its namespace, so that no signal from in there ends it. Whoever ignores SIGCHLD need
# not take note of the end of what others leave behind. It ends when our end of its input closes.
_IGNORING = "env --ignore-signal=CHLD"
_HOLDING = f"echo ready; {_IGNORING} true 2>/dev/null && exec {_IGNORING} cat; exec cat"


@contextlib.contextmanager
def holder(plan: Plan, writable: Sequence[Path]) -> Iterator[int]:
    """The pid (as we see it) of the first process in the namespaces; at the end all in them are killed.

    Raises OurFault when bubblewrap fails.
    """
    reading, writing = os.pipe()
    with contextlib.ExitStack() as stack:
        stack.callback(os.close, reading)
        texts = [(stack.enter_context(data(text)), name) for name, text in users(plan)]
        command = ("bwrap", *arguments(plan, writable, texts), "--info-fd", str(writing))
        try:
            process = subprocess.Popen(
                (*command, "--as-pid-1", "--", "/bin/sh", "-c", _HOLDING),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={"PATH": os.environ.get("PATH", os.defpath)},  # programs may be able to read it
                pass_fds=(writing, *(number for number, _ in texts)),
            )
        finally:
            os.close(writing)
        try:
            _await_ready(process)
            yield int(json.loads(os.read(reading, 4096))["child-pid"])
        finally:
            _end(process)


def _await_ready(process: subprocess.Popen[bytes]) -> None:
    assert process.stdout is not None
    said = b""
    while not said.endswith(_READY):
        ready, _, _ = select.select([process.stdout], [], [], _START_TIME)
        more = os.read(process.stdout.fileno(), 4096) if ready else b""
        if not more:
            raise OurFault(f"the sandbox did not start: {said.decode(errors='replace').strip()}")
        said += more


def _end(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.wait()
    for stream in (process.stdin, process.stdout):
        if stream:
            stream.close()
