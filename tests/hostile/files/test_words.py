"""A submission's text, wherever it is shown or stored, never affects its reader."""

from __future__ import annotations

import io
import json
import re
from pathlib import Path

import pytest
from rich.console import Console

from course.content import Exercise, open_course
from course.grading.quiz.questions import check_quiz
from course.grading.trial_answers import SEED
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict, from_json, to_json
from course.report.console import open_console
from course.report.problem import render_problem
from course.report.verdict import render_result
from tests.hostile.world import SECRET

ATTACKS = {
    "color": "\x1b[31mred\x1b[0m",
    "clear": "\x1b[2J\x1b[H\x1bc",
    "title": "\x1b]0;evil\x07",
    "link": "\x1b]8;;http://evil/\x1b\\click\x1b]8;;\x1b\\",
    "clipboard": "\x1b]52;c;ZXZpbA==\x07",
    "unfinished": "\x1b]8;;http://evil/",
    "device": "\x1bP+q544e\x1b\\\x1b_evil\x1b\\\x1b^evil\x1b\\",
    "c1": "\x9b31mred\x9d0;evil\x9c",
    "bidi": "‮txt.exe‬ ⁦evil⁩ ‏",
    "lines": "one\r\ntwo\rthree\x0bfour\x0cfive\x85six\u2028seven",
    "backspace": "password\x08\x08\x08\x08\x08\x08\x08\x08evil    ",
    "nul": "a\x00b\x7fc",
    "surrogate": "\udcff\ud800",
    "markup": "[red]red[/red] [link=http://evil]click[/link] [/]",
    "code": "`code` ``` # heading",
    "long": "x" * 1_000_000,
}
FORBIDDEN = re.compile(
    r"[^\n\x20-\x7e\xa0-\u0619\u061d-\u200d\u2010-\u2027\u202f-\u2065\u206a-\ud7ff\ue000-\U0010ffff]"
)


def result_that_says(text: str) -> Result:
    feedback = Feedback(text, text, text, (Location(text, 3),), text, (text, text))
    checks = (
        CheckResult("one", "a title", 1, Outcome.FAILED, feedback=feedback),
        CheckResult("two", "another", 1, Outcome.SKIPPED, skipped_because=text),
    )
    return Result(
        "18-publisher", Verdict.NOT_PASSED, checks, Timing(), notes=(text,), containment="contained"
    )


@pytest.fixture(scope="module")
def exercise() -> Exercise:
    return open_course().exercise("18-publisher")


@pytest.mark.parametrize("name", list(ATTACKS))
def test_a_terminal_shows_it_and_does_nothing_else(name: str, exercise: Exercise) -> None:
    stream = io.StringIO()
    console = open_console(stream, width=80)
    render_result(console, result_that_says(ATTACKS[name]), exercise)
    render_problem(console, ATTACKS[name], ATTACKS[name])
    shown = stream.getvalue()
    assert not FORBIDDEN.search(shown), ascii(FORBIDDEN.findall(shown))
    shown.encode()
    assert len(shown) < 100_000


@pytest.mark.parametrize("name", list(ATTACKS))
def test_a_coloured_terminal_gets_no_colours_but_ours(name: str, exercise: Exercise) -> None:
    stream = io.StringIO()
    console = Console(file=stream, force_terminal=True, color_system="standard", width=80)
    render_result(console, result_that_says(ATTACKS[name]), exercise)
    plain = re.sub(r"\x1b\[[0-9;]*m", "", stream.getvalue())
    assert not FORBIDDEN.search(plain), ascii(FORBIDDEN.findall(plain))
    assert "\x1b[2J" not in stream.getvalue()


@pytest.mark.parametrize("name", list(ATTACKS))
def test_json_holds_it_and_shows_none_of_it(name: str) -> None:
    result = result_that_says(ATTACKS[name])
    for text in (to_json(result), to_json(result, indent=2)):
        assert not FORBIDDEN.search(text), ascii(FORBIDDEN.findall(text))
        text.encode()
        assert from_json(text).checks == result.checks
        json.loads(text)


ANSWERS = {
    "object": "tab: !!python/object/apply:os.system ['touch /tmp/breach']\n",
    "name": "tab: !!python/name:os.system ''\n",
    "custom": "tab: !evil {a: b}\n",
    "cycle": "tab: &a [*a]\n",
    "laughs": "a: &a [x,x]\n" + "".join(f"b{n}: &b{n} [*a,*a]\n" for n in range(9)),
    "merge": "a: &a {b: c}\ntab: {<<: *a}\n",
    "deep": "tab: " + "[" * 100_000,
    "flow": "{" * 50_000,
    "many": "".join(f"q{number}: a\n" for number in range(10_000)),
    "huge": "tab: " + "x" * 5_000_000,
    "documents": "tab: a\n---\ntab: b\n" * 100,
    "directive": "%TAG ! tag:yaml.org,2002:python/\n---\ntab: !object/apply:os.system [id]\n",
    "binary": "tab: !!binary aGVsbG8=\n",
    "escapes": 'tab: "\\e[31m\\x9b\\u202e"\n',
    "no text": "\x00\x01\xff",
}


@pytest.mark.parametrize("name", list(ANSWERS))
def test_answers_are_text_and_nothing_more(name: str, tmp_path: Path) -> None:
    quiz = open_course().exercise("01-terminal-quiz")
    file = tmp_path / "answers" / f"{quiz.id}.yaml"
    file.parent.mkdir()
    file.write_bytes(ANSWERS[name].encode("latin-1"))
    result = check_quiz(quiz, tmp_path, SEED)
    assert result.verdict is Verdict.NOT_PASSED, result.fault
    text = to_json(result)
    assert not FORBIDDEN.search(text)
    assert len(text) < 100_000


@pytest.mark.parametrize("target", ["/etc/passwd", "/dev/zero", "/proc/self/environ", "outside"])
def test_answers_are_no_links(target: str, tmp_path: Path) -> None:
    quiz = open_course().exercise("01-terminal-quiz")
    home = tmp_path / "home"
    (home / "answers").mkdir(parents=True)
    (tmp_path / "outside").write_text(f"tab: {SECRET}\n")
    (home / "answers" / f"{quiz.id}.yaml").symlink_to(tmp_path / target)
    result = check_quiz(quiz, home, SEED)
    assert result.verdict is Verdict.NOT_PASSED
    assert "it is a link" in to_json(result)
    assert SECRET not in to_json(result)
