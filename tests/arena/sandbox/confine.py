"""Runs a program in both layers, as a grading does, and tells what came of it: a script, with two parts.

`confine.py FILE` opens the outer layer and starts itself in it, with "inside" before the name. With "apart"
at first, the program gets a /dev/shm of its own; what it has there in memory when it prints "up" is told.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from pathlib import Path

MOST_SECONDS = 60.0


def outside(file: Path) -> int:
    from course.arena.containment import Places, containment

    with containment(Places((Path(__file__).parent,))) as where:
        user = where.who.user if where.who else None
        told = {"kind": where.around.kind, "user": user, "missing": where.around.missing}
        print(json.dumps(told), flush=True)
        command = [*where.around.prefix, sys.executable, __file__, "inside", *sys.argv[1:]]
        return subprocess.run(command, check=False).returncode


def inside(file: Path, apart: bool) -> int:
    from course.arena.sandbox.launcher import fork_launcher

    link = fork_launcher()
    from course.arena.containment import PROGRAMS, SCRATCH
    from course.arena.process import Process
    from course.arena.sandbox.plan import Plan
    from course.arena.sandbox.sandbox import open_sandbox
    from course.arena.shared_memory import files_in_memory
    from course.evidence.events import OutputLine
    from course.evidence.timeline import Timeline

    scratch, timeline, limits = SCRATCH / PROGRAMS, Timeline(), list[str]()
    copy = scratch / file.name
    copy.write_bytes(file.read_bytes())
    environment = {"PATH": os.defpath, "HOME": str(scratch), "TMPDIR": str(scratch)}
    with open_sandbox(Plan(None, ()), link, scratch, limits.append) as sandbox:
        command = (sys.executable, str(copy))
        process = Process(
            "program",
            command,
            env=environment,
            cwd=scratch,
            timeline=timeline,
            start=partial(sandbox, own_memory=apart),
        )
        if apart:
            timeline.wait_until(lambda: any(e.text == "up" for e in timeline.of(OutputLine)), MOST_SECONDS)
            print(json.dumps({"memory": files_in_memory(process.pid)}), flush=True)
            process.type("go on\n")
        ended = process.wait(MOST_SECONDS)
        process.close()
    printed = [event.text for event in timeline.events() if isinstance(event, OutputLine)]
    print(json.dumps({"ended": ended, "limits": limits, "printed": printed}), flush=True)
    return 0


if __name__ == "__main__":
    program = Path(sys.argv[-1])
    raise SystemExit(inside(program, "apart" in sys.argv) if sys.argv[1] == "inside" else outside(program))
