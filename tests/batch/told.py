"""What commands say in documents: each block after `<!-- told -->` is typed, and its output written down.

    .venv/bin/python -m tests.batch.told        write it anew

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
from tests.batch.term import COURSE, lay_moodle, lay_term

REPO = Path(__file__).parents[2]
DOCUMENTS = tuple(REPO / "docs" / f"{name}.md" for name in ("submissions", "marks-and-deadlines", "report"))
BLOCK = re.compile(r"(?<=<!-- told -->\n```console\n).*?(?=```\n)", re.DOTALL)
GRADE = f"grade class.zip --roster canvas.csv --exercises {QUIZ} --out week3"
SETUP = ("init home", GRADE, f"grade moodle --exercises {QUIZ} --out week4")


class Term:
    """The folder in which the commands are typed."""

    def __init__(self, folder: Path) -> None:
        self._folder = lay_moodle(lay_term(folder / "term"))
        for command in SETUP:
            self._run(command)
        course = open_course(COURSE)
        trial.lay_solution(course, course.exercise(QUIZ), self._folder / "home")

    def told(self, text: str) -> str:
        return BLOCK.sub(lambda block: self._block(block[0]), text)

    def _block(self, block: str) -> str:
        said = []
        for line in block.splitlines():
            if line.startswith("$ ./ros2course "):
                said += [line, self._run(line.removeprefix("$ ./ros2course ")).rstrip()]
            elif line.startswith("$ "):
                shell = subprocess.run(
                    line[2:], shell=True, cwd=self._folder, capture_output=True, text=True, check=True
                )
                said += [line, shell.stdout.rstrip()]
        return "\n".join(filter(None, said)) + "\n"

    def _run(self, command: str) -> str:
        done = subprocess.run(
            [sys.executable, "-m", "course", "--course", str(COURSE), *shlex.split(command)],
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
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        return done.stdout.replace(f"{self._folder}/", "")


def main() -> None:
    for document in DOCUMENTS:
        with tempfile.TemporaryDirectory() as name:
            text = document.read_text(encoding="utf-8")
            if BLOCK.search(text):
                document.write_text(Term(Path(name)).told(text), encoding="utf-8")


if __name__ == "__main__":
    main()
