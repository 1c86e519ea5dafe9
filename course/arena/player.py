"""The process in which a mystery's nodes live: `python -m course.arena.player`.

Its standard input brings the job as one line of JSON: the mystery's module, its seed, and where to
keep acts. It prints `ready` when every node is up. It ends within moments of SIGINT or SIGTERM, and
also when its standard input closes: then whoever started it is gone, however that happened.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import threading
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from course.arena.acts import MAX_ACTS, MAX_TEXT, read_acts, write_acts
from course.arena.play_module import load_play
from course.evidence.acts import Act

READY = "ready"
# A callback of a node's may be busy; after this nobody waits for it.
_GRACE = 1.5


@dataclass(frozen=True)
class PlayJob:
    """What to play. acts: the file that keeps them; None prints each as a line of JSON."""

    file: str
    exercise: str
    seed: int
    acts: str | None = None


class Acts:
    """What a mystery is given beside its plan: where its nodes tell of the learner's acts."""

    def __init__(self, job: PlayJob) -> None:
        self._job = job
        self._lock = threading.Lock()
        self._known = read_acts(Path(job.acts)) if job.acts else ()
        self._idle: list[Node] = []

    def idle(self, node: Node) -> None:
        """Keep a node that is there and does nothing: it is not spun, so its services never answer."""
        self._idle.append(node)

    def record(self, name: str, detail: str = "") -> None:
        """The learner did this. The same act with the same detail counts once."""
        act = Act(name[:MAX_TEXT], str(detail)[:MAX_TEXT])
        with self._lock:
            if act in self._known or len(self._known) >= MAX_ACTS:
                return
            self._known = (*self._known, act)
            if self._job.acts:
                write_acts(Path(self._job.acts), self._job.exercise, self._known)
            else:
                _say(json.dumps({"act": asdict(act)}))


def main() -> int:
    job = PlayJob(**json.loads(sys.stdin.readline()))
    module = load_play(Path(job.file))
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    _end_on_signals()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    acts = Acts(job)  # holds idle nodes, so it must live as long as they
    nodes = _nodes(module.play(module.draw(job.seed), acts))
    _spin(nodes)
    # The middleware's threads may take their time to end; there is nothing left to wait for.
    sys.stdout.flush()
    os._exit(0)


def _nodes(made: Any) -> tuple[Node, ...]:
    nodes = tuple(made) if isinstance(made, Iterable) else ()
    if not nodes or not all(isinstance(node, Node) for node in nodes):
        raise TypeError("play(plan, acts) must return the nodes that it made")
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
    """Wake the executor; and if a node does not let go, end without it."""
    threading.Timer(_GRACE, os._exit, (0,)).start()
    rclpy.try_shutdown()


def _say(line: str) -> None:
    # Somebody who does not read any more is about to end us.
    with contextlib.suppress(OSError):
        sys.stdout.write(line + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    raise SystemExit(main())
