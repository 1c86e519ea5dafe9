"""`report` and `serve` as they are typed."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from datetime import datetime, timezone
from pathlib import Path
from urllib.request import urlopen

import pytest

from course.batch.gradings import Graded, Unit
from course.batch.results import BatchSettings, Results, Submission, keep_settings
from course.cli.main import main
from course.model.result import CheckResult, Outcome, Result, Verdict
from tests.conftest import FIXTURES

EXERCISE = "05-quiz"
RIGHT = Result(EXERCISE, Verdict.PASSED, (CheckResult("a", "It is", 1, Outcome.PASSED),))
COURSE = ("--course", str(FIXTURES / "quiz_course"))


@pytest.fixture
def out(tmp_path: Path) -> Path:
    folder = tmp_path / "grades"
    with Results.open(folder) as results:
        results.enter([Submission(one, one.title(), f"{one}.zip", "d") for one in ("ada", "b/ao")])
        began = datetime.now(timezone.utc)
        keep_settings(results, BatchSettings(tmp_path / "class", (), (EXERCISE,), False, True, began))
        results.record(Graded(Unit("ada", EXERCISE), RIGHT, 1.0), "1", None)
    return folder


def test_the_page_lies_beside_the_results(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*COURSE, "report", str(out)]) == 0
    page = out / "report.html"
    assert capsys.readouterr().out == f"{page}\n"
    assert "B/Ao" in page.read_text(encoding="utf-8")


def test_a_page_for_each_learner(out: Path, tmp_path: Path) -> None:
    pages = tmp_path / "pages"
    assert main([*COURSE, "report", str(out), "--learners", str(pages)]) == 0
    ada, bao = sorted(pages.iterdir())
    assert (ada.name, bao.name[:5]) == ("ada.html", "b-ao-")
    assert "Feedback for Ada" in ada.read_text(encoding="utf-8")
    assert "B/Ao" not in ada.read_text(encoding="utf-8")


def test_a_page_for_one_learner(out: Path, tmp_path: Path) -> None:
    page = tmp_path / "mine.html"
    assert main([*COURSE, "report", str(out), "--learner", "ada", "--out", str(page)]) == 0
    assert "Feedback for Ada" in page.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--learner", "eve"), "no submission from eve"),
        (("--learners", "pages", "--learner", "ada"), "--learners makes a page for each learner"),
    ],
)
def test_what_does_not_fit(
    out: Path, words: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*COURSE, "report", str(out), *words]) == 2
    assert said in capsys.readouterr().err


def test_a_folder_without_results(tmp_path: Path) -> None:
    assert main([*COURSE, "report", str(tmp_path)]) == 2
    assert main([*COURSE, "serve", str(tmp_path)]) == 2


@pytest.mark.slow
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_serve_shows_the_class_and_ends_in_order(out: Path, number: int, code: int) -> None:
    command = [sys.executable, "-m", "course", *COURSE, "serve", str(out)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as server:
        assert server.stdout and server.stderr
        address = server.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]+/", address)
        with urlopen(address) as answer:
            assert b"B/Ao" in answer.read()
        server.send_signal(number)
        assert server.wait(60) == code
        assert "Traceback" not in server.stderr.read()
