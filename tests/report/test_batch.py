"""What is shown while a class is graded."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from course.grading.judge.regraded import Move, MoveCause
from course.model.result import CheckResult, Feedback, Outcome, Result, Verdict
from course.report import activity
from course.report.activity import progress
from course.report.batch import (
    GradingTally,
    Moved,
    SubmissionRow,
    line_of,
    render_end,
    render_moves,
    render_plan,
)

SHINES = CheckResult("shines", "It shines", 2, Outcome.PASSED)
DIM = CheckResult("dims", "It dims", 1.5, Outcome.FAILED, feedback=Feedback("It does not."))
PASSED = Result("04-light", Verdict.PASSED, (SHINES,))
FAILED = Result("04-light", Verdict.NOT_PASSED, (SHINES, DIM))
OURS = Result("04-light", Verdict.OUR_ERROR, fault=Feedback("It fell over."))
HOSTILE = "eve\x1b[2J\n\u202egpj.exe"


@pytest.fixture
def console() -> Console:
    return Console(file=io.StringIO(), width=100, force_terminal=False)


def said(console: Console) -> str:
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


def test_the_plan_tells_what_was_found_where(console: Console) -> None:
    rows = [
        SubmissionRow("ada", "Ada Okafor", "ada.zip", "workspace", ("04-light", "04-dim")),
        SubmissionRow("bao", "Bảo", "bao", "nothing", (), ("It is empty.",)),
    ]
    render_plan(console, rows, ["notes.txt was passed over."])
    lines = said(console).splitlines()
    assert lines[1].split() == ["ada", "Ada", "Okafor", "workspace", "04-light,", "04-dim", "ada.zip"]
    assert "  bao: It is empty." in lines
    assert "notes.txt was passed over." in lines
    assert lines[-1] == "2 submissions, 1 of them with something to grade: 2 gradings."


def test_many_exercises_are_counted(console: Console) -> None:
    render_plan(
        console, [SubmissionRow("ada", "Ada", "ada", "course home", [f"0{n}-x" for n in range(7)])], []
    )
    assert "00-x, 01-x, 02-x and 4 more" in said(console)


def test_nothing_of_a_submission_reaches_the_terminal_as_it_is(console: Console) -> None:
    render_plan(console, [SubmissionRow(HOSTILE, HOSTILE, HOSTILE, "files", (), (HOSTILE,))], [HOSTILE])
    with progress(console) as show:
        show(GradingTally(1, 0), line_of(HOSTILE, PASSED))
    assert not {"\x1b", "\u202e"} & set(said(console))
    assert line_of(HOSTILE, PASSED).count("\n") == 0


def test_markup_in_names_is_text(console: Console) -> None:
    render_plan(console, [SubmissionRow("[red]x[/red]", "[bold]", "[/]", "files", (), ("[link=x]",))], [])
    assert "[red]x[/red]" in said(console) and "[link=x]" in said(console)


@pytest.mark.parametrize(
    ("result", "line"),
    [
        (PASSED, "ada  04-light  passed  2 of 2"),
        (FAILED, "ada  04-light  not passed  2 of 3.5"),
        (OURS, "ada  04-light  our error  -"),
        (Result("04-light", Verdict.NOT_AVAILABLE), "ada  04-light  not available here  -"),
        (Result("04-light", Verdict.NOT_APPLICABLE), "ada  04-light  not applicable  -"),
    ],
)
def test_a_grading_in_one_line(result: Result, line: str) -> None:
    assert line_of("ada", result) == line


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [1000.0]
    monkeypatch.setattr(activity.time, "monotonic", lambda: now[0])
    return now


def test_how_far_it_is_how_fast_and_how_long_it_takes(clock: list[float]) -> None:
    tally = GradingTally(60, 0)
    assert tally.line() == "0 of 60"
    clock[0] += 30
    for result in [PASSED] * 6 + [FAILED] * 3 + [OURS]:
        tally.add(result)
    assert tally.line() == "10 of 60, 20 a minute, 2:30 left, 6 passed, 3 not passed, 1 our error"


def test_what_an_earlier_run_has_graded_does_not_count_as_fast(clock: list[float]) -> None:
    tally = GradingTally(60, 50)
    clock[0] += 60
    assert tally.line() == "50 of 60"
    tally.add(PASSED)
    assert tally.line() == "51 of 60, 1 a minute, 9:00 left, 1 passed"


def test_where_no_terminal_is_each_grading_has_a_line(console: Console) -> None:
    tally = GradingTally(2, 0)
    with progress(console) as show:
        show(tally, None)
        tally.add(PASSED)
        show(tally, line_of("ada", PASSED))
    (line,) = said(console).splitlines()
    assert line.startswith("ada  04-light  passed  2 of 2  (1 of 2, ")


def test_on_a_terminal_there_is_a_bar() -> None:
    console = Console(file=io.StringIO(), width=100, force_terminal=True, legacy_windows=False)
    tally = GradingTally(2, 0)
    with progress(console) as show:
        show(tally, None)
        tally.add(PASSED)
        show(tally, line_of("ada", PASSED))
    assert "1 of 2" in said(console) and "ada" not in said(console)


def test_the_end_counts_and_tells_where_to_read_on(console: Console) -> None:
    render_end(console, [("not passed", 3), ("passed", 2)], [("out/a.csv", "a table"), ("out/b/", "letters")])
    lines = said(console).splitlines()
    assert lines == ["3 not passed, 2 passed", "", "  out/a.csv  a table", "  out/b/     letters"]


def test_an_end_without_anything_says_so(console: Console) -> None:
    render_end(console, [], [("out/a.csv", "a table")])
    assert said(console).startswith("Nothing was graded.")


def test_moves_show_what_could_be_had_and_count_only_marks_that_moved(console: Console) -> None:
    shines = Move("shines", "It shines", MoveCause.POINTS, 2, 4, 2, 4, "worth 4, was 2")
    dims = Move("dims", "It dims", MoveCause.OUTCOME, 0, 0, 0, 0, "failed before")
    up = Moved("ada", "Ada", "04-light", 2, 4, 12, 14, [shines])
    same = Moved("bob", "Bob", "04-light", 2, 2, 12, 12, [dims])
    render_moves(console, [up, same], 5)
    assert "It shines: worth 4, was 2" in said(console)
    assert "2 of 12 → 4 of 14" in said(console) and "2 of 12, as before" in said(console)
    assert "1 of them changed, and 1 reached the same points in a different way." in said(console)
