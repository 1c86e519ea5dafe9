"""The command: its flags, its output for programs, and how it stops."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pexpect
import pytest

from tests.report.gradebook.test_junit import assert_counts, assert_suite
from tests.validate.conftest import Validate, edit

REPO = Path(__file__).parents[2]
MISTAKES = Path("chapters/05-lighthouses/mistakes.yaml")
NOT_CAUGHT = ("answers: {why: It saves oil}", "answers: {why: tell-apart}")

# The command with workers that answer until the folder is asked for by its third proof, and then hang.
PROGRAM = """
import sys
from course.model import replace
from course.validate import proofs
from course.validate import schedule
schedule.PROOFS = replace(proofs.PROOFS, worker="tests.validate.slow_worker")
from course.cli.main import main
sys.exit(main(sys.argv[1:]))
"""


def test_static_grades_nothing(validate: Validate, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("course.cli.validate.run", None)
    edit(MISTAKES, *NOT_CAUGHT)
    ended = validate("--static")
    assert (ended.code, ended.out) == (0, "\nNo problems were found.\n")


@pytest.mark.slow
def test_junit_by_the_rules_of_its_readers(validate: Validate, tmp_path: Path) -> None:
    line = edit(MISTAKES, *NOT_CAUGHT)
    assert validate("--junit", str(tmp_path / "out.xml")).code == 1
    root = ET.parse(tmp_path / "out.xml").getroot()
    assert_counts(root)
    for suite in root:
        assert_suite(suite)
    assert [suite.get("name") for suite in root] == ["files", "05-quiz"]
    (broken,) = [case for case in root.iter("testcase") if case.find("failure") is not None]
    assert broken.get("name") == "mistake saves-oil"
    assert broken.get("file") == str(MISTAKES)
    assert 0 < line - int(broken.get("line", "0")) < 6
    assert len(list(root.iter("testcase"))) == 7


@pytest.mark.slow
def test_github_is_told_the_line_in_the_repository(
    validate: Validate, monkeypatch: pytest.MonkeyPatch, quiz_course: Path
) -> None:
    edit(MISTAKES, *NOT_CAUGHT)
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    monkeypatch.setenv("GITHUB_WORKSPACE", str(quiz_course.parent))
    (line,) = [line for line in validate().out.splitlines() if line.startswith("::")]
    where = f"::error title=05-quiz,file=quiz_course/{MISTAKES},line=2::mistake `saves-oil`: "
    assert line.startswith(where)


@pytest.mark.slow
def test_outside_of_github_nothing_is_annotated(validate: Validate) -> None:
    edit(MISTAKES, *NOT_CAUGHT)
    assert "::error" not in validate().out


@pytest.mark.slow
def test_what_broke_is_told_as_it_goes_where_there_is_no_bar(validate: Validate) -> None:
    edit(MISTAKES, *NOT_CAUGHT)
    (line,) = validate().err.splitlines()
    assert line.startswith("05-quiz mistake saves-oil  (") and "1 broken" in line


@pytest.mark.slow
def test_a_machine_that_lacks_something(validate: Validate, monkeypatch: pytest.MonkeyPatch) -> None:
    from course.model import replace
    from course.validate import schedule
    from course.validate.proofs import PROOFS

    monkeypatch.setattr(schedule, "PROOFS", replace(PROOFS, worker="tests.validate.odd_worker"))
    monkeypatch.setenv("WAYS", "missing")
    ended = validate()
    assert ended.code == 4
    assert "Not available here: 05-quiz. There is no ROS." in ended.words
    assert "0 of 6 proofs are done" in ended.words


def test_mutating_goes_with_no_other_kind(validate: Validate) -> None:
    assert validate("--mutate", "--static").code == 2


@pytest.mark.slow
def test_a_reader_that_goes_away_leaves_no_traceback(quiz_course: Path) -> None:
    words = ["-m", "course", "--course", str(quiz_course), "validate", "--static"]
    read, write = os.pipe()
    os.close(read)
    environment = {**os.environ, "PYTHONPATH": str(REPO)}
    try:
        done = subprocess.run(
            [sys.executable, *words], stdout=write, stderr=subprocess.PIPE, env=environment, check=False
        )
    finally:
        os.close(write)
    assert done.stderr == b""


@pytest.mark.slow
def test_ctrl_c_shows_what_is_known(quiz_course: Path, tmp_path: Path) -> None:
    words = ["-c", PROGRAM, "--course", str(quiz_course), "validate", "05-quiz", "--jobs", "1"]
    environment = {**os.environ, "PYTHONPATH": str(REPO), "TERM": "xterm", "TMPDIR": str(tmp_path / "tmp")}
    (tmp_path / "tmp").mkdir()
    child = pexpect.spawn(
        sys.executable, words, env=environment, encoding="utf-8", timeout=60, dimensions=(24, 80)
    )
    child.expect_exact("3 of 6")
    child.sendintr()
    child.expect_exact("Stopped: 3 of 6 proofs were known.")
    child.expect_exact("3 of 6 proofs are done, and hold.")
    child.expect(pexpect.EOF)
    child.close()
    assert child.exitstatus == 130
    assert list((tmp_path / "tmp").iterdir()) == []
