"""Terminal output in the documents, as it really is.

    .venv/bin/python docs/pictures.py           write it anew
    .venv/bin/python docs/pictures.py --check   say whether it is still so (exit 1 if not)

Between `<!-- check:begin -->` and `<!-- check:end -->` of the README stands what two real checks of
18-publisher print: one with a known mistake, one of the reference solution.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from course.content import Course, open_course
from course.grading import trial

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
EXERCISE = "18-publisher"
MISTAKE = "publisher-topic-plural"
REGION = re.compile(r"(?<=<!-- check:begin -->\n).*?(?=<!-- check:end -->)", re.DOTALL)
# Durations differ from run to run.
SECONDS = re.compile(r"\d+\.\d+ s")


def main() -> int:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("--check", action="store_true")
    only_check = parser.parse_args().check
    before = README.read_text(encoding="utf-8")
    after = REGION.sub(lambda _: picture(), before)
    if only_check:
        return 0 if SECONDS.sub("", after) == SECONDS.sub("", before) else 1
    README.write_text(after, encoding="utf-8")
    return 0


def picture() -> str:
    """Both checks as one code block."""
    course = open_course(ROOT)
    shown = "\n\n".join(f"$ ./ros2course check\n{checked(course, mistaken)}" for mistaken in (True, False))
    return f"```console\n{shown}\n```\n"


def checked(course: Course, mistaken: bool) -> str:
    """What `check` prints at 80 columns, with the mistake in the solution or without."""
    exercise = course.exercise(EXERCISE)
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        trial.lay_solution(course, exercise, home)
        if mistaken:
            mistake = next(found for found in exercise.mistakes() if found.id == MISTAKE)
            trial.apply_mistake(exercise, mistake, home)
        run("init", folder)
        return "\n".join(line.rstrip() for line in run("--home", folder, "check", EXERCISE).splitlines())


def run(*words: str) -> str:
    environment = {**os.environ, "COLUMNS": "80", "NO_COLOR": "1", "ROS2COURSE_LAUNCHER": "./ros2course"}
    command = [sys.executable, "-m", "course", *words]
    done = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    return done.stdout


if __name__ == "__main__":
    raise SystemExit(main())
