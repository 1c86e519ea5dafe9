"""The sample in docs/grading-a-class.md: what the command says of the class of sixty.

    .venv/bin/python -m tests.batch.picture        write it again

tests/batch/test_class_of_sixty.py says whether it is still so.
"""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterator
from pathlib import Path

from course.content import open_course
from tests.batch.command import Command
from tests.batch.the_class import lay_class

DOCUMENT = Path(__file__).parents[2] / "docs" / "grading-a-class.md"
REGION = re.compile(r"(?<=<!-- class:begin -->\n).*?(?=<!-- class:end -->)", re.DOTALL)
# One row of each kind, out of sixty.
SHOWN = re.compile(r"id  |7004  |3005  |learner02|mallory-fork|packages01|tarred06|workspace00|broken|bomb")
REMARK = re.compile(r"  \S")
PROGRESS = re.compile(r"\(\d+ of \d+")


def picture(said: str, beside: Path) -> str:
    """A code block: some rows of the table, and everything after it, without what differs from run to run.

    beside: the folder that the class and the results are in; paths are shown as from there.
    """
    for named in (str(beside), os.path.relpath(beside)):
        said = said.replace(f"{named}/", "")
    lines = [line.rstrip() for line in said.splitlines() if not PROGRESS.search(line)]
    end = next(number for number, line in enumerate(lines) if REMARK.match(line))
    text = "\n".join([*_some_rows(lines[:end]), "...", *lines[end:]])
    return f"```console\n$ ./ros2course grade class/\n{text}\n```\n"


def _some_rows(lines: list[str]) -> Iterator[str]:
    """Each with its continuation lines."""
    taken = False
    for line in lines:
        taken = taken if line.startswith(" ") else bool(SHOWN.match(line))
        if taken:
            yield line


def shown() -> str:
    """What the document shows now."""
    found = REGION.search(DOCUMENT.read_text(encoding="utf-8"))
    return found[0] if found else ""


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        lay_class(open_course(), folder / "class")
        said = Command(folder / "class", folder / "grades", folder / "tmp").until_judged()
    text = DOCUMENT.read_text(encoding="utf-8")
    DOCUMENT.write_text(REGION.sub(lambda _: picture(said, folder), text), encoding="utf-8")


if __name__ == "__main__":
    main()
