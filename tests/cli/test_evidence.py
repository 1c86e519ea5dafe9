"""`evidence show`, `evidence export` and `check --timeline` as they are typed."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.evidence.mcap_file import load, save
from course.evidence.recording import Recording
from course.model import events as kinds
from course.model import replace
from course.model.result import Result, Timing
from tests.conftest import FIXTURES
from tests.report.drawn.recordings import PACE, steady
from tests.report.pictures.recordings import COUNTER, recording

if TYPE_CHECKING:
    from tests.cli.conftest import Checker, Ros2course

SEEN = replace(recording(*COUNTER), exercise="04-light")


@pytest.fixture(autouse=True)
def begun(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")


@pytest.fixture
def kept(home: Path) -> Path:
    """The recording of the current exercise, as a check leaves it."""
    return keep(home, SEEN)


def keep(home: Path, what: Recording) -> Path:
    file = home / ".ros2course/evidence" / f"{what.exercise}.mcap"
    save(what, file, began_ns=0)
    return file


def of(what: Recording) -> Result:
    from tests.cli.conftest import PASSED

    return replace(PASSED, checks=(*PASSED.checks, PACE), timing=Timing(evidence=what.duration))


@pytest.mark.usefixtures("kept")
@pytest.mark.parametrize("words", [(), ("04-light",), ("light",)])
def test_show_draws_what_was_recorded(ros2course: Ros2course, words: tuple[str, ...]) -> None:
    run = ros2course("evidence", "show", *words)
    assert run.code == 0
    assert run.out.startswith("04-light: 6.0 s recorded, ")
    assert "Program counter: ran from 0.50 s to 5.50 s" in run.out
    assert max(map(len, run.out.splitlines())) <= 80


def test_show_of_any_file(ros2course: Ros2course, kept: Path, tmp_path: Path) -> None:
    other = kept.rename(tmp_path / "other.mcap")
    assert "Program counter: ran" in ros2course("evidence", "show", str(other)).out
    assert ros2course("evidence", "show").code == 2


def test_what_was_expected_comes_from_the_check_of_this_recording(
    ros2course: Ros2course, checker: Checker, home: Path
) -> None:
    what = replace(recording(*steady(9)), exercise="04-light")
    keep(home, what)
    checker.answer = of(what)
    ros2course("check")
    assert "Expected one every" in ros2course("evidence", "show").out
    keep(home, replace(what, duration=7.0))
    assert "Expected one every" not in ros2course("evidence", "show").out


def test_check_draws_what_happened_on_demand(ros2course: Ros2course, checker: Checker, kept: Path) -> None:
    checker.answer = of(SEEN)
    assert "What happened" not in ros2course("check").out
    run = ros2course("check", "--timeline")
    assert run.code == 0
    assert run.out.index("points.") < run.out.index("What happened") < run.out.index("Type next:")


def test_a_check_without_a_recording_of_its_own(ros2course: Ros2course, checker: Checker, kept: Path) -> None:
    """There may be one of an earlier check."""
    run = ros2course("check", "--timeline")
    assert "this check has no recording" in run.out and "What happened" not in run.out


def test_json_and_a_picture_do_not_go_together(ros2course: Ros2course, checker: Checker) -> None:
    run = ros2course("check", "--json", "--timeline")
    assert (run.code, run.out, checker.calls) == (2, "", [])


@pytest.mark.parametrize("words", [("show",), ("export", "--to", "x.mcap")])
def test_no_recording_yet(ros2course: Ros2course, words: tuple[str, ...]) -> None:
    run = ros2course("evidence", *words)
    assert run.code == 2
    assert "no recording of 04-light yet" in run.err and "ros2course check 04-light" in run.err


def test_questions_have_no_recording(ros2course: Ros2course) -> None:
    run = ros2course("evidence", "show", "05-quiz", course=FIXTURES / "quiz_course")
    assert run.code == 2 and "only questions" in run.err


@pytest.mark.parametrize("size", [0, 10, 200, 1200])
def test_a_damaged_recording(ros2course: Ros2course, kept: Path, size: int, tmp_path: Path) -> None:
    kept.write_bytes(kept.read_bytes()[:size])
    for words in (("show",), ("export", "--to", str(tmp_path / "x.mcap"))):
        run = ros2course("evidence", *words)
        assert run.code == 2
        assert "damaged" in run.err and "ros2course check 04-light" in " ".join(run.err.split())
    assert not (tmp_path / "x.mcap").exists()


def test_export_is_a_copy_that_says_how_to_open_it(
    ros2course: Ros2course, kept: Path, tmp_path: Path
) -> None:
    target = tmp_path / "x.mcap"
    run = ros2course("evidence", "export", "--to", str(target))
    assert run.code == 0
    assert target.read_bytes() == kept.read_bytes()
    assert run.out.startswith(f"{target}  ")
    assert "Foxglove" in run.out and "PlotJuggler" in run.out
    assert load(target) == SEEN


def test_export_into_a_folder(ros2course: Ros2course, kept: Path, tmp_path: Path) -> None:
    assert ros2course("evidence", "export", "light", "--to", str(tmp_path)).code == 0
    assert (tmp_path / "04-light.mcap").is_file()


def test_export_replaces_nothing_unasked(ros2course: Ros2course, kept: Path, tmp_path: Path) -> None:
    target = tmp_path / "mine.mcap"
    target.write_text("mine", encoding="utf-8")
    run = ros2course("evidence", "export", "--to", str(target))
    assert run.code == 2 and "--force" in run.err
    assert target.read_text(encoding="utf-8") == "mine"
    assert ros2course("evidence", "export", "--to", str(target), "--force").code == 0
    assert target.read_bytes() == kept.read_bytes()


def test_export_to_nowhere(ros2course: Ros2course, kept: Path, tmp_path: Path) -> None:
    run = ros2course("evidence", "export", "--to", str(tmp_path / "no/such/x.mcap"))
    assert run.code == 4 and "no folder" in run.err
    itself = ros2course("evidence", "export", "--to", str(kept), "--force")
    assert itself.code == 2 and kept.is_file()


def test_a_mystery_is_neither_shown_nor_exported(ros2course: Ros2course, home: Path, tmp_path: Path) -> None:
    keep(home, replace(SEEN, events=(*SEEN.events, kinds.Drawn(5.9, 8675309))))
    shown = ros2course("evidence", "show")
    assert shown.out.startswith("The recording of a mystery is not shown")
    run = ros2course("evidence", "export", "--to", str(tmp_path / "x.mcap"))
    assert run.code == 2 and "mystery" in run.err
    assert not (tmp_path / "x.mcap").exists()
    assert "8675309" not in shown.out + run.err


def test_a_file_that_is_not_there_and_one_that_is_something_else(
    ros2course: Ros2course, tmp_path: Path
) -> None:
    assert "There is no file" in ros2course("evidence", "show", "nowhere.mcap").err
    (tmp_path / "text.mcap").write_text("text", encoding="utf-8")
    assert "not a recording of the course" in " ".join(
        ros2course("evidence", "show", str(tmp_path / "text.mcap")).err.split()
    )
