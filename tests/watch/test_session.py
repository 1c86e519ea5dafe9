"""A session: checks at a save, keys, changes, results of another check, its own files."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from course.content import Exercise, Lesson, open_course
from course.model import replace
from course.model.result import Result, Verdict
from course.watch import updates
from course.watch.session import Session
from course.watch.updates import Begun, Checked, Key, Look, Said, Saved, Stuck
from tests.watch.pretended import LIGHT, judged


@dataclass
class Desk:
    """A learner with what the test provides."""

    home: Path
    coming: list[Begun] = field(default_factory=list)
    stored: list[Result] = field(default_factory=list)
    passed: set[str] = field(default_factory=set)

    def next(self) -> Begun | None:
        return self.coming.pop(0) if self.coming else None

    def lesson(self, exercise: Exercise) -> updates.LessonText:
        return updates.LessonText(exercise, (Lesson(exercise.chapter, "A lantern.", "04-lanterns"),))

    def task(self, begun: Begun) -> updates.TaskText:
        return updates.TaskText(begun.exercise, self.home, "begun", begun.new)

    def hint(self, exercise: Exercise) -> updates.HintText:
        return updates.HintText(exercise, 1, 3, exercise.hints[0])

    def listing(self) -> updates.Listing:
        return updates.Listing(())

    def is_passed(self, exercise: Exercise) -> bool:
        return exercise.id in self.passed

    def last_result(self, exercise: Exercise) -> Result | None:
        mine = [result for result in self.stored if result.exercise == exercise.id]
        return mine[-1] if mine else None

    def remember(self, exercise: Exercise, result: Result) -> Path | None:
        self.stored.append(result)
        if result.verdict is Verdict.PASSED:
            self.passed.add(exercise.id)
        return None

    def ask(self, exercise: Exercise) -> None:
        raise AssertionError("the session asks by what it was given for that")


@dataclass
class Checking:
    started: list[str] = field(default_factory=list)
    stopped: int = 0

    def start(self, exercise: Exercise) -> int:
        self.started.append(exercise.id)
        return len(self.started)

    def stop(self) -> None:
        self.stopped += 1


class Table:
    """A session with all that it talks to."""

    def __init__(self, home: Path, exercise: Exercise) -> None:
        self.home = home
        self.desk = Desk(home)
        self.checking = Checking()
        self.answers = [True]
        self.asked: list[str] = []
        self.session = Session(self.desk, self.checking, Begun(exercise), lambda: 7, self.ask, lambda: 5.0)

    def ask(self, exercise: Exercise) -> bool:
        self.asked.append(exercise.id)
        return self.answers.pop()

    @property
    def look(self) -> Look:
        return self.session.look

    def press(self, keys: str) -> None:
        for key in keys:
            self.session.hear(Key(key))

    def save(self, *files: str) -> None:
        self.session.hear(Saved(files or (LIGHT,)))

    def finish(self, told: str, number: int = 0) -> None:
        result = Result(self.look.exercise.id, *judged(told))
        self.session.hear(Checked(number or len(self.checking.started), result))


@pytest.fixture
def table(tmp_path: Path, light: Exercise) -> Table:
    return Table(tmp_path, light)


@pytest.fixture
def dim(small_course: Path) -> Exercise:
    return open_course(small_course).exercise("04-dim")


def test_a_save_starts_a_check_and_says_which_file(table: Table) -> None:
    assert table.checking.started == [] and not table.look.doing, "nothing is checked without a save"
    table.save()
    assert table.checking.started == ["04-light"]
    assert table.look.doing and table.look.remark == "saved: light.py"
    table.session.hear(Said(1, "building lanterns"))
    assert table.look.doing == "building lanterns"


def test_a_save_of_what_does_not_count_starts_none(table: Table) -> None:
    table.save(".bash_history", ".ros/log/x.log")
    assert table.checking.started == []


def test_a_save_during_a_check_starts_it_anew_and_the_old_one_is_not_heard(table: Table) -> None:
    table.save()
    table.save(LIGHT, "notes.txt")
    assert table.checking.started == ["04-light"] * 2
    assert table.look.remark == "saved: light.py and 1 more; checking again"
    table.session.hear(Said(1, "of the old one"))
    table.finish("bright", number=1)
    assert table.look.doing not in ("", "of the old one") and table.desk.stored == []
    table.finish("half", number=2)
    assert not table.look.doing and len(table.desk.stored) == 1


def test_what_changed_is_shown_with_the_result(table: Table) -> None:
    table.save()
    table.finish("dark")
    assert isinstance(table.look.body, updates.ResultText) and table.look.body.change is None
    table.save()
    table.finish("half")
    assert isinstance(table.look.body, updates.ResultText) and table.look.body.change is not None
    assert table.look.body.change.fixed == ("It stands",) and table.look.body.change.points == 2
    table.press("tr")
    assert isinstance(table.look.body, updates.ResultText) and table.look.body.change == table.look.change


def test_what_is_certain_is_shown_while_the_cause_is_looked_for(table: Table) -> None:
    table.save()
    so_far = Result("04-light", *judged("half"))
    table.session.hear(updates.SoFar(1, so_far))
    assert isinstance(table.look.body, updates.ResultText) and table.look.body.result is so_far
    assert table.look.doing and table.desk.stored == [], "the check goes on"
    table.finish("half")
    assert not table.look.doing and len(table.desk.stored) == 1


def test_our_error_is_compared_with_nothing(table: Table) -> None:
    table.save()
    table.finish("half")
    table.save()
    table.session.hear(Checked(2, Result("04-light", Verdict.OUR_ERROR)))
    assert table.look.change is None


def test_no_result_is_told_with_what_to_do(table: Table) -> None:
    table.save()
    table.session.hear(Stuck(1, "There is no ROS.", "Get one."))
    assert table.look.body == updates.ProblemText("There is no ROS.", "Get one.") and not table.look.doing
    assert table.desk.stored == []


def test_n_moves_on_only_when_passed(table: Table, dim: Exercise) -> None:
    table.desk.coming = [Begun(dim)]
    table.press("n")
    assert table.look.exercise.id == "04-light" and "not passed yet" in table.look.remark
    table.save()
    table.finish("bright")
    assert table.look.exercise.id == "04-light", "the result is there to be read"
    table.save()
    table.press("n")
    assert table.look.exercise.id == "04-dim" and table.checking.stopped == 1
    table.finish("bright", number=2)
    assert table.desk.last_result(dim) is None, "a check of the exercise before is not heard"
    table.desk.passed.add("04-dim")
    table.press("n")
    assert isinstance(table.look.body, updates.AllPassed)


def test_starters_that_are_laid_are_no_saves(table: Table, dim: Exercise) -> None:
    file = table.home / "ros2_tutorial_workspace/src/lanterns/lanterns/dim.py"
    file.parent.mkdir(parents=True)
    file.write_text("starter")
    table.desk.passed.add("04-light")
    table.desk.coming = [Begun(dim, (file,))]
    table.press("n")
    laid = [file, *file.parents[:-1]]
    names = [str(one.relative_to(table.home)) for one in laid if one.is_relative_to(table.home)]
    table.save(*names)
    assert table.checking.started == []
    file.write_text("work of the learner")
    table.save(*names)
    assert table.checking.started == ["04-dim"]


def test_t_turns_between_task_and_lesson(table: Table, light: Exercise) -> None:
    assert isinstance(table.look.body, updates.TaskText)
    table.press("t")
    assert isinstance(table.look.body, updates.LessonText)
    table.press("t")
    assert isinstance(table.look.body, updates.TaskText)
    first = Session(table.desk, table.checking, Begun(light, (), True), lambda: 0, table.ask)
    assert isinstance(first.look.body, updates.LessonText), "the chapter's lesson comes first, once"


def test_the_other_keys(table: Table) -> None:
    table.press("h")
    assert isinstance(table.look.body, updates.HintText)
    table.press("l")
    assert isinstance(table.look.body, updates.Listing)
    table.press(" ")
    assert table.look.first == 7, "as the screen says"
    table.press("r")
    assert "not been checked" in table.look.remark
    table.press("C")
    assert table.checking.started == ["04-light"]
    table.press("?x")
    assert not table.session.over
    table.press("q")
    assert table.session.over


def test_c_asks_a_quiz_first_and_its_answers_are_no_save(tmp_path: Path) -> None:
    root = Path(__file__).parents[1] / "fixtures/quiz_course"
    quiz = next(one for one in open_course(root).exercises() if one.questions)
    table = Table(tmp_path, quiz)
    answers = f"answers/{quiz.id}.yaml"

    def ask(exercise: Exercise) -> bool:
        (tmp_path / "answers").mkdir(exist_ok=True)
        (tmp_path / answers).write_text("a: b")
        return table.ask(exercise)

    table.session = Session(table.desk, table.checking, Begun(quiz), lambda: 0, ask)
    table.answers = [True, False]
    table.press("c")
    assert table.asked == [quiz.id] and table.checking.started == [], "Ctrl+C at a question: no check"
    table.press("c")
    assert table.checking.started == [quiz.id]
    table.save("answers", answers)
    assert len(table.checking.started) == 1
    (tmp_path / answers).write_text("a: c, written in an editor")
    table.save(answers)
    assert len(table.checking.started) == 2


def test_leaving_stops_what_runs(table: Table) -> None:
    table.save()
    table.session.leave()
    assert table.checking.stopped == 1 and table.look.doing == "stopping the check"
    assert replace(table.look, doing="") != table.look
