"""A class graded by a local Dask cluster and by the local pool; and with one worker killed halfway.

Both grade the same submissions (right ones and known mistakes of one exercise), in turns, with the same
number of gradings at once. The rate leaves out the cluster's start, which has its own row in the table.
"""

from __future__ import annotations

import argparse
import os
import signal
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

import psutil
from mixed import lay_mixed
from table import show

from course.batch.batch_plan import plan_batch
from course.batch.gradings import Graded
from course.batch.run import Batch, BatchProgress, Rounds, default_jobs, results_folder, run
from course.content import open_course
from course_cluster.connect import LOCAL, scheduler_at
from course_cluster.coordinator import Cluster
from course_cluster.fitness import wanted


@dataclass
class Go:
    """One graded class. start: seconds until the first grading could start. seconds: from then on."""

    start: float
    seconds: float = 0.0
    told: Counter[str] = field(default_factory=Counter)
    verdicts: dict[str, str] = field(default_factory=dict)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=40, help="submissions in the class")
    parser.add_argument("--goes", type=int, default=3, help="how often each grades it")
    parser.add_argument("--exercise", default="18-publisher")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
        top = Path(folder)
        lay_mixed(top / "class", options.count, options.exercise)
        grade(top, "warm", options.exercise)  # builds everything that is not built yet
        pairs = [pair(top, n, options.exercise) for n in range(options.goes)]
        killed = grade(top, "killed", options.exercise, LOCAL, kill_after=options.count // 2)
    rows = [
        row(f"{name} {n}", go) for n, pair in enumerate(pairs) for name, go in zip(NAMES, pair, strict=True)
    ]
    show(
        f"{options.count} submissions of {options.exercise}", HEAD, [*rows, row("one worker killed", killed)]
    )
    ratio = median(pool.seconds / cluster.seconds for pool, cluster in pairs)
    same = all(go.verdicts == pairs[0][0].verdicts for pair in pairs for go in (*pair, killed))
    each_once = len(killed.told) == options.count and set(killed.told.values()) == {1}
    print(f"\ncluster's rate / pool's rate, median of {len(pairs)}: {ratio:.2f}")
    print(f"with one worker killed, all results there, each once: {each_once}; verdicts all the same: {same}")


def pair(top: Path, number: int, exercise: str) -> tuple[Go, Go]:
    """The pool's run and the cluster's. They take turns at being first, because a machine's load drifts."""
    order = (None, LOCAL) if number % 2 == 0 else (LOCAL, None)
    goes = {who: grade(top, f"{who or 'pool'}{number}", exercise, who) for who in order}
    return goes[None], goes[LOCAL]


NAMES = ("local pool", "cluster of two")
HEAD = ("who", "start (s)", "graded", "a minute")


def row(who: str, go: Go) -> list[str]:
    return [who, f"{go.start:.1f}", str(len(go.told)), f"{60 * len(go.told) / go.seconds:.1f}"]


def grade(top: Path, name: str, exercise: str, cluster: str | None = None, kill_after: int = 0) -> Go:
    began = time.monotonic()
    out = top / name
    with results_folder(out) as results, ExitStack() as stack:
        planned = plan_batch(top / "class", out / "opened", open_course(), [exercise], single=False)
        rounds: Rounds | None = None
        if cluster:
            client = stack.enter_context(scheduler_at(cluster))
            rounds = Cluster(client, wanted(None, contained=True), print)
        go = Go(time.monotonic() - began)
        began = time.monotonic()
        run(Batch(out, planned, default_jobs()), results, teller(go, kill_after), rounds)
        go.seconds = time.monotonic() - began
        return go


def teller(go: Go, kill_after: int) -> Callable[[BatchProgress, Graded | None], None]:
    def tell(progress: BatchProgress, graded: Graded | None) -> None:
        if graded is None:
            return
        go.told[graded.unit.person] += 1
        go.verdicts[graded.unit.person] = graded.result.verdict.value
        if sum(go.told.values()) == kill_after:
            os.kill(a_worker(), signal.SIGKILL)

    return tell


def a_worker() -> int:
    """The process of one of our Dask workers."""
    children = psutil.Process().children()
    return next(child.pid for child in children if "spawn_main" in " ".join(child.cmdline()))


if __name__ == "__main__":
    main()
