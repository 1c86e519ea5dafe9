"""Runs a program in both layers, as a grading does, and tells what came of it: a script, with two parts.

`confine.py FILE` opens the outer layer and starts itself in it, with "inside" before the name.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

MOST_SECONDS = 60.0


def outside(file: Path) -> int:
    from course.arena.containment import Places, containment

    with containment(Places((Path(__file__).parent,))) as where:
        user = where.who.user if where.who else None
        told = {"kind": where.around.kind, "user": user, "missing": where.around.missing}
        print(json.dumps(told), flush=True)
        command = [*where.around.prefix, sys.executable, __file__, "inside", str(file)]
        return subprocess.run(command, check=False).returncode


def inside(file: Path) -> int:
    from course.arena.sandbox.launcher import fork_launcher

    link = fork_launcher()
    from course.arena.containment import PROGRAMS, SCRATCH
    from course.arena.process import Process
    from course.arena.sandbox.plan import Plan
    from course.arena.sandbox.sandbox import open_sandbox
    from course.evidence.events import OutputLine
    from course.evidence.timeline import Timeline

    scratch, timeline, limits = SCRATCH / PROGRAMS, Timeline(), list[str]()
    copy = scratch / file.name
    copy.write_bytes(file.read_bytes())
    environment = {"PATH": os.defpath, "HOME": str(scratch), "TMPDIR": str(scratch)}
    with open_sandbox(Plan(None, ()), link, scratch, limits.append) as sandbox:
        command = (sys.executable, str(copy))
        process = Process(
            "program", command, env=environment, cwd=scratch, timeline=timeline, start=sandbox
        )
        ended = process.wait(MOST_SECONDS)
        process.close()
    printed = [event.text for event in timeline.events() if isinstance(event, OutputLine)]
    print(json.dumps({"ended": ended, "limits": limits, "printed": printed}), flush=True)
    return 0


if __name__ == "__main__":
    part = inside if sys.argv[1] == "inside" else outside
    raise SystemExit(part(Path(sys.argv[-1])))
