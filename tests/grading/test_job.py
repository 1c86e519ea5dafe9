"""A job on its way to the grading process."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.feedback import Feedback, Location
from course.grading.job import Job, from_line, to_line

FAILURE = Feedback("it does not build", where=(Location("src/talk/setup.py", 3),), details=("one\ntwo",))
TALK = BuiltPackage("talk", "src/talk", "/store/talk", ("talker", "listener"))


@pytest.mark.parametrize(
    "packages", [BuiltPackages(), BuiltPackages((TALK,)), BuiltPackages((TALK,), FAILURE)]
)
@pytest.mark.parametrize("evidence", [None, "/tmp/evidence.mcap"])
def test_a_job_is_one_line_and_comes_back_as_it_was(packages: BuiltPackages, evidence: str | None) -> None:
    job = Job(
        exercise="18-publisher",
        grader="/course/graders/ch18.py",
        home="/home/häufig",
        roots=("src/talk", "src/notes.txt"),
        packages=packages,
        environment={"PATH": "/usr/bin", "LINES": "one\ntwo", "ODD": "caf\udce9"},
        python="/usr/bin/python3",
        evidence=evidence,
    )
    line = to_line(job)
    assert "\n" not in line
    line.encode("ascii")
    assert from_line(line + "\n") == job
