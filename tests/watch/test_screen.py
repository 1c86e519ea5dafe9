"""A screenful: exactly as many lines as the terminal has, whatever is shown."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from rich.text import Text

from course.content import Exercise, Lesson
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report.exercise_text import ExerciseRow
from course.watch import updates
from course.watch.screen import MOST_LINES, Frame, Screen
from course.watch.updates import Body, Look, what_changed
from tests.watch.pretended import judged


@pytest.fixture(autouse=True)
def colored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.delenv("NO_COLOR", raising=False)


def typed(words: str) -> str:
    return f"ros2course {words}"


def result(told: str) -> Result:
    return Result("04-light", *judged(told))


def drawn(look: Look, width: int = 79, height: int = 24, screen: Screen | None = None) -> Frame:
    frame = (screen or Screen(typed)).draw(look, width, height, 10.0)
    assert len(frame.lines) <= height
    assert max(Text.from_ansi(line).cell_len for line in frame.lines) <= width
    return frame


def plain(frame: Frame) -> list[str]:
    return [Text.from_ansi(line).plain.rstrip() for line in frame.lines]


def lesson(exercise: Exercise, text: str) -> updates.LessonText:
    return updates.LessonText(exercise, (Lesson(exercise.chapter, text, "04-lanterns"),))


def bodies(exercise: Exercise) -> list[Body]:
    rows = tuple(
        ExerciseRow("4 Lanterns", f"{n:02}-light", "Light " * 30, "new", current=n == 40) for n in range(80)
    )
    change = what_changed(result("dark"), result("half"))
    return [
        lesson(exercise, "# Lanterns\n\n" + "word " * 2000 + "\n\n```python\n" + "x" * 300 + "\n```"),
        updates.TaskText(exercise, Path("/a" * 90), "begun", (Path("/a" * 90) / "new.py",), ("03-oil",)),
        updates.ResultText(exercise, result("half"), result("dark"), change),
        updates.ResultText(exercise, result("flood"), None, None),
        updates.ResultText(
            exercise, Result("04-light", Verdict.OUR_ERROR, fault=Feedback("Fell.")), None, None
        ),
        updates.ProblemText("There is no " + "oil" * 100, "Buy\nsome"),
        updates.HintText(exercise, 1, 3, "A hint."),
        updates.HintText(exercise, 0, 0),
        updates.Listing(rows),
        updates.AllPassed(),
    ]


@pytest.mark.slow
@pytest.mark.parametrize("number", range(10))
@pytest.mark.parametrize(("width", "height"), [(79, 24), (100, 50), (30, 10), (10, 4), (1, 1), (300, 100)])
def test_everything_fits_everywhere(light: Exercise, number: int, width: int, height: int) -> None:
    look = Look(light, bodies(light)[number], result("half"), None, "building", 3.0, "saved: light.py")
    frame = drawn(look, width, height)
    if height > 4 and width > 20:
        assert plain(frame)[0].startswith("04-light")
        assert plain(frame)[-1].startswith("n next")


def test_the_edges_tell_exercise_result_activity_and_keys(light: Exercise) -> None:
    change = what_changed(result("dark"), result("half"))
    look = Look(
        light, updates.AllPassed(), result("half"), change, "building lanterns", 3.0, "saved: light.py"
    )
    lines = plain(drawn(look))
    assert lines[0].startswith("04-light  Light it")
    assert lines[0].endswith("Not passed yet: 2 of 4 points (2 points more)")
    assert lines[-2][2:] == "building lanterns  7 s  (saved: light.py)"
    assert lines[-1] == "n next  h hint  t task  r result  l list  c check  space more  q quit"
    assert plain(drawn(replace(look, doing="")))[-2] == "saved: light.py"


def test_a_result_names_what_changed_and_what_is_to_be_done_first(light: Exercise) -> None:
    change = what_changed(result("dark"), result("half"))
    text = plain(drawn(Look(light, updates.ResultText(light, result("half"), result("dark"), change))))
    order = ["Not passed yet: 2 of 4", "Since the last check: 2 points more", "+ It stands passes now"]
    order += ["no  It shines", "try       Light it.", "ok  It stands"]
    found = [next(row for row, line in enumerate(text) if part in line) for part in order]
    assert found == sorted(found)
    worse = what_changed(result("half"), result("dark"))
    text = plain(drawn(Look(light, updates.ResultText(light, result("dark"), result("half"), worse))))
    assert any("2 points fewer" in line for line in text)
    assert any("- It stands no longer passes" in line for line in text)


def test_reading_on_shows_every_line_once_and_begins_again(light: Exercise) -> None:
    text = "\n\n".join(f"line{n}." for n in range(60))
    screen, look = Screen(typed), Look(light, lesson(light, text))
    seen: list[str] = []
    while True:
        frame = drawn(look, screen=screen)
        seen += [line for line in plain(frame) if line.startswith("line")]
        look = replace(look, first=frame.following)
        if frame.following == 0:
            break
    assert seen == [f"line{n}." for n in range(60)]
    assert plain(drawn(look, screen=screen))[1].startswith("== Chapter 4")


def test_a_list_begins_where_the_learner_is(light: Exercise) -> None:
    lines = plain(drawn(Look(light, bodies(light)[8])))
    assert any(line.startswith(">") and "40-light" in line for line in lines)


def test_a_huge_result_is_cut_and_says_where_all_of_it_is(light: Exercise) -> None:
    checks = tuple(
        CheckResult(f"c{n}", f"Check {n}", 1, Outcome.FAILED, feedback=Feedback("Dark. " * 100))
        for n in range(20_000)
    )
    huge = Result("04-light", Verdict.NOT_PASSED, checks)
    screen = Screen(typed)
    look = Look(light, updates.ResultText(light, huge, None, None), huge)
    frame = drawn(look, screen=screen)
    assert "`ros2course check` shows all at once" in plain(frame)[-4]
    last = drawn(replace(look, first=10 * MOST_LINES), screen=screen)
    assert any("cut here" in line and "ros2course check" in line for line in plain(last))


def test_what_a_submission_wrote_stays_in_its_place(light: Exercise) -> None:
    nasty = Feedback(
        "\x1b[2J\x1b[H\x1b]0;title\x07 \r\n\x9b31m", details=("\x1b[?1049l\x1b[31m" + "y" * 999,)
    )
    check = CheckResult("c", "\x1b[2Jtitle", 1, Outcome.FAILED, feedback=nasty)
    bad = Result("04-light", Verdict.NOT_PASSED, (check,))
    frame = drawn(
        Look(light, updates.ResultText(light, bad, None, None), bad, None, "\x1b[2Jbuild", 0.0, "\x1b[H")
    )
    for line in frame.lines:
        assert "\x1b[2J" not in line and "\x1b[H" not in line and "\x1b]" not in line and "\x1b[?" not in line


def test_the_same_body_is_rendered_once(light: Exercise, monkeypatch: pytest.MonkeyPatch) -> None:
    rendered: list[Body] = []
    monkeypatch.setattr("course.watch.screen.render", lambda body, console, typed: rendered.append(body))
    screen, look = Screen(typed), Look(light, updates.AllPassed())
    for _ in range(3):
        screen.draw(look, 79, 24, time.monotonic())
    screen.draw(look, 60, 24, 0.0)
    assert len(rendered) == 2
