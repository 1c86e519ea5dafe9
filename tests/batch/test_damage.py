"""A damaged file of results: each damaged grading is reported, and all others remain usable."""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from course.batch.class_page import read_class
from course.batch.repair import KEPT_AS, repair
from course.batch.results import FILE, Results, settings_of
from course.cli.main import main
from course.content import Course
from course.errors import StorageError
from course.model.result import Verdict, to_json
from tests.batch.command import Command
from tests.batch.samples import FAILED, PASSED, QUIZ, graded, submissions
from tests.conftest import FIXTURES

COURSE = ("--course", str(FIXTURES / "quiz_course"))
GOOD = to_json(PASSED)
Lay = Callable[..., Path]


def spoil(folder: Path, statement: str, *values: object) -> None:
    database = sqlite3.connect(folder / FILE)
    assert database.execute(statement, values).rowcount > 0
    database.commit()
    database.close()


def blob(text: str) -> str:
    """As the bytes of a text that is not UTF-8."""
    return f"CAST(X'{text.encode().hex()}FF' AS TEXT)"


def of_type(**changes: object) -> str:
    return json.dumps({**json.loads(GOOD), **changes})


def in_check(**changes: object) -> str:
    data = json.loads(GOOD)
    data["checks"][0].update(changes)
    return json.dumps(data)


RESULTS = {
    "half": GOOD[: len(GOOD) // 2],
    "empty": "",
    "deep": "[" * 100_000,
    "nothing": "null",
    "a list": "[]",
    "another exercise": of_type(exercise="05-other"),
    "verdict": of_type(verdict="splendid"),
    "checks": of_type(checks={"a": 1}),
    "timing": of_type(timing={"lag": "much"}),
    "notes": of_type(notes=[1]),
    "lacking": json.dumps({"schema": 1}),
    "points": in_check(points="many"),
    "endless points": in_check(points=float("nan")),
    "title": in_check(title=None),
    "feedback": in_check(feedback={"summary": 1, "where": [], "details": []}),
    "where": in_check(feedback={"summary": "a", "where": [{"file": "a", "line": "b"}], "details": []}),
}
COLUMNS = {
    "invalid utf-8": f"result = {blob(GOOD)}",
    "a blob": "result = X'00FF'",
    "a number": "result = 5",
    "attempt": "attempt = 'often'",
    "seconds": "seconds = 'long'",
    "evidence": "evidence = X'FF'",
    "evidence of nowhere": "evidence = 'a' || char(0) || 'b'",
    "exercise": f"exercise = {blob('04')}",
}


@pytest.fixture
def results(tmp_path: Path) -> Iterator[Results]:
    with Results.open(tmp_path) as opened:
        opened.enter(submissions("ada", "bao", "cyd"))
        for person in ("ada", "bao"):
            opened.record(graded(person), "1.0", f"evidence/{person}/04-light.mcap")
        opened.record(graded("cyd", FAILED), "1.0", None)
        yield opened


def check_the_others(results: Results) -> None:
    """All but ada's."""
    assert results.done() >= {("bao", "04-light"), ("cyd", "04-light")}
    assert [one.result for one in results.gradings("bao")] == [PASSED]
    assert results.evidence()["bao", "04-light"] == "evidence/bao/04-light.mcap"
    assert [one.person for one in results.submissions()] == ["ada", "bao", "cyd"]
    assert results.containments() == ("contained",)


def check_the_damaged(results: Results) -> None:
    assert not [key for key in results.done() if key[0] == "ada"]
    assert results.verdicts() == {"our error": 1, "passed": 1, "not passed": 1}
    (stored,) = results.gradings("ada")
    assert stored.damaged
    assert stored.result.verdict is Verdict.OUR_ERROR
    assert stored.result.fault is not None
    assert "is damaged" in stored.result.fault.summary
    assert "grades this one again" in (stored.result.fault.advice or "")
    assert [person for person, _ in results.damaged()] == ["ada"]
    assert [person for person, _ in results.drop_damaged()] == ["ada"]
    assert results.gradings("ada") == []


@pytest.mark.parametrize("text", RESULTS.values(), ids=list(RESULTS))
def test_a_damaged_result(results: Results, tmp_path: Path, text: str) -> None:
    spoil(tmp_path, "UPDATE gradings SET result = ? WHERE person = 'ada'", text)
    check_the_others(results)
    check_the_damaged(results)


@pytest.mark.parametrize("change", COLUMNS.values(), ids=list(COLUMNS))
def test_a_damaged_column(results: Results, tmp_path: Path, change: str) -> None:
    spoil(tmp_path, f"UPDATE gradings SET {change} WHERE person = 'ada'")
    check_the_others(results)
    check_the_damaged(results)


@pytest.mark.parametrize("name", ["name", "source", "digest", "remarks"])
@pytest.mark.parametrize("value", [blob("a"), "X'FF'", "7", "'['"])
def test_a_damaged_submission(results: Results, tmp_path: Path, name: str, value: str) -> None:
    spoil(tmp_path, f"UPDATE submissions SET {name} = {value} WHERE person = 'ada'")
    check_the_others(results)
    if name == "remarks":
        (remark,) = results.submissions()[0].remarks
        assert "damaged" in remark
    results.enter(submissions("ada", "bao", "cyd"))
    assert results.submissions() == submissions("ada", "bao", "cyd")


def test_a_damaged_person_is_gone_when_the_class_is_graded_again(results: Results, tmp_path: Path) -> None:
    spoil(tmp_path, f"UPDATE submissions SET person = {blob('ada')} WHERE person = 'ada'")
    spoil(tmp_path, f"UPDATE gradings SET person = {blob('ada')} WHERE person = 'ada'")
    assert results.verdicts() == {"our error": 1, "passed": 1, "not passed": 1}
    assert len(results.drop_damaged()) == 1
    results.enter(submissions("ada", "bao", "cyd"))
    assert results.submissions() == submissions("ada", "bao", "cyd")
    check_the_others(results)


@pytest.mark.parametrize(
    "change",
    [f"value = {value}" for value in ("'{'", "'[]'", "'{}'", "X'FF'", "3", blob("a"))] + ["key = 'a'"],
)
def test_what_was_asked_for_is_damaged(results: Results, tmp_path: Path, change: str) -> None:
    results.note("asked", "{}")
    spoil(tmp_path, f"UPDATE batch SET {change}")
    with pytest.raises(StorageError, match="damaged") as caught:
        settings_of(results)
    assert "keeps the results" in (caught.value.next_step or "")


@pytest.fixture
def many(tmp_path: Path) -> Path:
    """Sixty gradings, whose results take more than a page each."""
    people = [f"p{number:02}" for number in range(60)]
    with Results.open(tmp_path) as results:
        results.enter(submissions(*people))
        for person in people:
            results.record(graded(person), "1.0" * 400, None)
    return tmp_path


def garbage(folder: Path, table: str) -> None:
    """One leaf page of the table, somewhere in its middle."""
    database = sqlite3.connect(folder / FILE)
    size = database.execute("PRAGMA page_size").fetchone()[0]
    pages = database.execute("SELECT pageno FROM dbstat WHERE name = ? AND pagetype = 'leaf'", (table,))
    leaves = [page for (page,) in pages]
    database.close()
    with (folder / FILE).open("r+b") as file:
        file.seek((leaves[len(leaves) // 2] - 1) * size)
        file.write(b"\xa5" * size)


def has_dbstat() -> bool:
    with sqlite3.connect(":memory:") as database:
        return ("ENABLE_DBSTAT_VTAB",) in database.execute("PRAGMA compile_options").fetchall()


@pytest.mark.skipif(not has_dbstat(), reason="this SQLite does not say which page is whose")
def test_a_page_of_garbage(many: Path) -> None:
    garbage(many, "gradings")
    with Results.look(many) as results:
        before = results.verdicts()
        assert before["passed"] >= 40
        assert before["passed"] + before["our error"] == 60
    assert repair(many)
    assert not repair(many), "then all is well"
    with Results.open(many) as results:
        assert results.verdicts() == before
        lost = results.drop_damaged()
        assert len(lost) == before["our error"]
        assert all(exercise == "04-light" for _, exercise in lost)
        for person, _ in lost:
            results.record(graded(person), "1.0", None)
        assert results.verdicts() == {"passed": 60}
    assert (many / KEPT_AS).is_file()


@pytest.mark.skipif(not has_dbstat(), reason="this SQLite does not say which page is whose")
@pytest.mark.parametrize("table", ["submissions", "checks", "sqlite_autoindex_gradings_1"])
def test_a_page_of_garbage_elsewhere(many: Path, table: str) -> None:
    garbage(many, table)
    assert repair(many)
    with Results.open(many) as results:
        results.enter(submissions(*[f"p{number:02}" for number in range(60)]))
        assert results.verdicts() == {"passed": 60}
        assert len(results.submissions()) == 60


def test_a_sound_file_is_left_alone(many: Path) -> None:
    before = (many / FILE).stat().st_ino
    assert not repair(many)
    assert not repair(many / "nothing")
    assert (many / FILE).stat().st_ino == before


@pytest.mark.slow
def test_every_command_goes_on(
    lay: Lay, tmp_path: Path, capsys: pytest.CaptureFixture[str], quiz_course: Course
) -> None:
    """Three people answer a quiz; the stored results of two of them are damaged."""
    command = Command(lay("ada", "bao", "cyd"), tmp_path / "grades", tmp_path / "tmp", before=COURSE)
    command.until_judged()
    whole = (tmp_path / "grades/results.csv").read_text()
    for person, change in (("ada", f"result = {blob('{')}"), ("bao", "result = '{'")):
        spoil(command.out, f"UPDATE gradings SET {change} WHERE person = '{person}'")

    assert main([*COURSE, "report", str(command.out)]) == 0
    with Results.look(command.out) as stored:
        sheets = read_class(command.out, stored, quiz_course).page.sheets
    assert [sheet.marks[0].verdict for sheet in sheets] == ["our error", "our error", "passed"]
    said = capsys.readouterr().err
    for person in ("ada", "bao"):
        assert f"The stored result of {person} for {QUIZ} is damaged: the command that graded" in said
    assert main([*COURSE, "regrade", str(command.out)]) == 0
    told = capsys.readouterr().out
    for person in ("ada", "bao"):
        assert f"{person}  {QUIZ}  Its stored result is damaged." in told
    assert "our error" in (command.out / "results.csv").read_text()
    assert "a verdict is still missing" in (command.out / "feedback/ada.md").read_text()
    assert "a verdict is still missing" not in (command.out / "feedback/cyd.md").read_text()

    spoiled = shutil.copytree(command.out, tmp_path / "spoiled")
    said = command.until_judged()
    for person in ("ada", "bao"):
        assert f"The stored result of {person} for {QUIZ} is damaged: it is graded again." in said
    assert "The stored result of cyd" not in said
    assert (command.out / "results.csv").read_text() == whole
    assert main([*COURSE, "regrade", str(spoiled), "--rerun"]) in (0, 3)
