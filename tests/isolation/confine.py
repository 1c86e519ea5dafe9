"""Runs a program in both layers, as a grading does, and tells what came of it: a script, with two parts.

`confine.py FILE` opens the outer layer and starts itself in it, with "inside" before the name. With "apart"
at first, the program gets a /dev/shm of its own; what it has there in memory when it prints "up" is told.
With "again" it runs twice in one sandbox, and with "fresh" in two.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from course.evidence.timeline import Timeline
    from course.isolation.sandbox import Sandbox

MOST_SECONDS = 60.0


def outside(file: Path) -> int:
    from course.isolation.levels import MachinePlaces, isolated

    with isolated(MachinePlaces((Path(__file__).parent,))) as where:
        user = where.identity.user if where.identity else None
        told = {"kind": where.level.value, "user": user, "missing": where.missing}
        print(json.dumps(told), flush=True)
        command = [*where.prefix, sys.executable, __file__, "inside", *sys.argv[1:]]
        return subprocess.run(command, check=False).returncode


def inside(file: Path, *how: str) -> int:
    from course.isolation.launcher import fork_launcher

    link = fork_launcher()
    from course.evidence.timeline import Timeline
    from course.isolation.isolation_plan import PROGRAMS, SCRATCH, IsolationPlan
    from course.isolation.sandbox import open_sandbox
    from course.model.events import OutputLine

    timeline, limits, ended = Timeline(), list[str](), True

    def fill(folder: Path) -> None:
        (folder / file.name).write_bytes(file.read_bytes())

    plan = IsolationPlan(None, (), own_network=bool({"again", "fresh"} & {*how}))
    for _ in range(2 if "fresh" in how else 1):
        with open_sandbox(plan, link, SCRATCH / PROGRAMS, limits.append, fill) as (sandbox, _):
            for _ in range(2 if "again" in how else 1):
                ended &= run(sandbox, SCRATCH / PROGRAMS / file.name, timeline, "apart" in how)
    printed = [event.text for event in timeline.events() if isinstance(event, OutputLine)]
    print(json.dumps({"ended": ended, "limits": limits, "printed": printed}), flush=True)
    return 0


def run(sandbox: Sandbox, program: Path, timeline: Timeline, apart: bool) -> bool:
    """Whether the program came to its end."""
    from course.arena.process import Process, files_in_memory
    from course.model.events import OutputLine

    process = Process(
        "program",
        (sys.executable, str(program)),
        env={"PATH": os.defpath, "HOME": str(program.parent), "TMPDIR": str(program.parent)},
        cwd=program.parent,
        timeline=timeline,
        start=partial(sandbox, own_memory=apart),
    )
    if apart:
        timeline.wait_until(lambda: any(e.text == "up" for e in timeline.of(OutputLine)), MOST_SECONDS)
        print(json.dumps({"memory": files_in_memory(process.pid)}), flush=True)
        process.type("go on\n")
    ended = process.wait(MOST_SECONDS)
    process.close()
    return ended


if __name__ == "__main__":
    program = Path(sys.argv[-1])
    raise SystemExit(inside(program, *sys.argv[2:-1]) if sys.argv[1] == "inside" else outside(program))
