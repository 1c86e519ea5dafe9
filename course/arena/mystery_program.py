"""The process in which a mystery's nodes run: `python -m course.arena.mystery_program`.

It reads the job from standard input as one line of JSON, see `MysteryJob`, and prints `ready` when every
node is up. It ends within moments of SIGINT or SIGTERM, and also when its standard input closes, because
the process that started it is then gone, for whatever reason.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import threading
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from course.arena.mystery_module import (
    MAX_ACTS,
    MAX_TEXT,
    READY,
    MysteryJob,
    load_mystery,
    read_log,
    write_log,
)
from course.evidence.acts import Act
from course.model import codec

# A node's callback may be busy; after this, nobody waits for it.
_GRACE = 1.5


class MysteryLog:
    """What a mystery gets besides its plan: the nodes report the learner's acts here."""

    def __init__(self, job: MysteryJob) -> None:
        self._job = job
        self._lock = threading.Lock()
        self._known = read_log(Path(job.log)) if job.log else ()
        self._idle: list[Node] = []

    def idle(self, node: Node) -> None:
        """Keep a node that exists but does nothing: it is not spun, so its services never answer."""
        self._idle.append(node)

    def record(self, name: str, detail: str = "") -> None:
        """Record that the learner did this. The same act with the same detail counts once."""
        act = Act(name[:MAX_TEXT], str(detail)[:MAX_TEXT])
        with self._lock:
            if act in self._known or len(self._known) >= MAX_ACTS:
                return
            self._known = (*self._known, act)
            if self._job.log:
                write_log(Path(self._job.log), self._job.exercise, self._known)
            else:
                _say(json.dumps({"act": asdict(act)}))


def main() -> int:
    job = codec.from_json(sys.stdin.readline(), MysteryJob, "the job")
    module = load_mystery(Path(job.file))
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    _end_on_signals()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    log = MysteryLog(job)  # owns idle nodes, so it must live as long as they do
    nodes = _nodes(module.play(module.draw(job.seed), log))
    _spin(nodes)
    # The middleware's threads may take a while to end, but there is nothing left to wait for.
    sys.stdout.flush()
    os._exit(0)


def _nodes(made: Any) -> tuple[Node, ...]:
    nodes = tuple(made) if isinstance(made, Iterable) else ()
    if not nodes or not all(isinstance(node, Node) for node in nodes):
        raise TypeError("play(plan, acts) must return the nodes that it created")
    return nodes


def _spin(nodes: tuple[Node, ...]) -> None:
    executor = SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    _say(READY)
    with contextlib.suppress(ExternalShutdownException):
        executor.spin()
    for node in nodes:
        node.destroy_node()


def _end_on_signals() -> None:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda _number, _frame: threading.Thread(target=_end, daemon=True).start())


def _end_with_parent() -> None:
    while sys.stdin.readline():
        pass
    _end()


def _end() -> None:
    """Wake the executor; if a node does not finish, end without it."""
    threading.Timer(_GRACE, os._exit, (0,)).start()
    rclpy.try_shutdown()


def _say(line: str) -> None:
    # A parent that no longer reads is about to end us.
    with contextlib.suppress(OSError):
        sys.stdout.write(line + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    raise SystemExit(main())
