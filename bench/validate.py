"""How long `validate` takes: the whole course without builds, again with all of them, and one exercise.

.venv/bin/python bench/validate.py                       all three
.venv/bin/python bench/validate.py --only 18-publisher   cold and warm, of this exercise alone
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from table import show

from course.content import open_course
from course.validate.proofs import proofs

ROOT = Path(__file__).parents[1]
AGAIN = re.compile(r"(\d+) gradings? (?:was|were) done again")
TARGETS = {"whole course, cold": 900, "whole course, warm": 300}
ONE = 30


def main() -> None:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("--only", help="one exercise, and not the whole course")
    parser.add_argument("--one", default="18-publisher", help="which exercise is timed besides the whole")
    parser.add_argument("--jobs", type=int, help="gradings at once")
    options = parser.parse_args()
    jobs = ["--jobs", str(options.jobs)] if options.jobs else []
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as cache:
        if options.only:
            goes = [(f"{options.only}, {how}", [options.only]) for how in ("cold", "warm")]
        else:
            goes = [(name, []) for name in TARGETS] + [(f"{options.one}, warm", [options.one])]
        rows = [go(name, wanted, jobs, cache) for name, wanted in goes]
    head = ("what", "proofs", "whole (s)", "target (s)", "s a proof", "done again", "exit")
    show(f"validate on {os.cpu_count()} cores", head, rows)


def go(name: str, wanted: list[str], jobs: list[str], cache: str) -> list[str]:
    count = len(proofs([open_course(ROOT).exercise(one) for one in wanted] or open_course(ROOT).exercises()))
    environment = {**os.environ, "ROS2COURSE_CACHE": cache, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "course", "validate", *wanted, *jobs]
    began = time.monotonic()
    done = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    whole = time.monotonic() - began
    if done.returncode:
        print(done.stdout)
    again = AGAIN.search(done.stdout)
    figures = [f"{whole:.1f}", str(TARGETS.get(name, ONE)), f"{whole / count:.2f}"]
    return [name, str(count), *figures, again[1] if again else "0", str(done.returncode)]


if __name__ == "__main__":
    main()
