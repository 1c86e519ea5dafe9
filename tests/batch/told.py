"""What commands say in documents: each block after `<!-- told -->` is typed, and its output written down.

    .venv/bin/python -m tests.batch.told        write it again

A block after `<!-- file: PATH -->` is written to this file when its turn comes.

The commands run beside the class of `tests/batch/term.py`, graded into week3 (from Canvas) and week4 (from
Moodle), and a course home in which its quiz is solved. tests/batch/test_told.py says whether it is still so.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from course.content import open_course
from course.grading import trial
from tests.batch.samples import QUIZ
from tests.batch.term import COURSE, lay_moodle, lay_renamed, lay_term

REPO = Path(__file__).parents[2]
DOCUMENTS = tuple(REPO / "docs" / f"{name}.md" for name in ("submissions", "marks-and-deadlines", "report"))
BLOCK = re.compile(
    r"(?<=<!-- told -->\n)```console\n(.*?)```\n|<!-- file: (\S+) -->\n```yaml\n(.*?)```\n", re.DOTALL
)
ERROR = re.compile(r"^Error:.*?(?=^Next:)", re.DOTALL | re.MULTILINE)
# The course of most commands is the one with the quiz; progress differs each time.
PROGRAM = f"""#!/bin/sh
case "$*" in *18-publisher*) ;; *) set -- --course {shlex.quote(str(COURSE))} "$@" ;; esac
exec {shlex.quote(sys.executable)} -m course "$@" 2>&1
"""
GRADE = f"grade class.zip --roster canvas.csv --exercises {QUIZ} --out week3"
SETUP = ("init home", GRADE, f"grade moodle --exercises {QUIZ} --out week4")


class Term:
    """The folder in which the commands are typed."""

    def __init__(self, folder: Path) -> None:
        self._folder = lay_moodle(lay_term(folder / "term"))
        (self._folder / "ros2course").write_text(PROGRAM)
        (self._folder / "ros2course").chmod(0o755)
        lay_renamed(self._folder / "renamed")
        for command in SETUP:
            self._run(f"./ros2course {command}")
        course = open_course(COURSE)
        trial.lay_solution(course, course.exercise(QUIZ), self._folder / "home")

    def told(self, text: str) -> str:
        return BLOCK.sub(self._block, text)

    def _block(self, block: re.Match[str]) -> str:
        commands, file, content = block.groups()
        if file:
            (self._folder / file).write_text(content, encoding="utf-8")
            return block[0]
        typed = [line for line in commands.splitlines() if line.startswith("$ ")]
        said = [line.rstrip() for each in typed for line in (each, *self._run(each[2:]).splitlines())]
        return "\n".join(["```console", *said, "```\n"])

    def _run(self, command: str) -> str:
        done = subprocess.run(
            command,
            shell=True,
            cwd=self._folder,
            env={
                **os.environ,
                "PYTHONPATH": str(REPO),
                "COLUMNS": "100",
                "NO_COLOR": "1",
                "ROS2COURSE_HOME": str(self._folder / "home"),
                "ROS2COURSE_LAUNCHER": "./ros2course",
            },
            stdout=subprocess.PIPE,
            text=True,
            check=False,
        )
        # Where an error breaks depends on the folder's whole path.
        said = ERROR.sub(lambda found: " ".join(found[0].split()) + "\n", done.stdout)
        return said.replace(f"{self._folder}/", "")


def main() -> None:
    for document in DOCUMENTS:
        with tempfile.TemporaryDirectory() as name:
            text = document.read_text(encoding="utf-8")
            if BLOCK.search(text):
                document.write_text(Term(Path(name)).told(text), encoding="utf-8")


if __name__ == "__main__":
    main()
