"""All problems of a course at once, including those between several files."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import Edit, open_course, problems
from course.content.audit import Edited
from course.errors import ContentError

EditFile = Callable[[str, str], Path]
Change = Callable[[str, str, str], Path]


def found(small_course: Path) -> tuple[ContentError, ...]:
    return problems(open_course(small_course))


def only(small_course: Path) -> ContentError:
    (problem,) = found(small_course)
    return problem


FOLDER = """
  - id: no-shelf
    exercise: 04-light
    summary: Has no shelf
    edits:
      - file: shelf
        WHAT
    caught_by: told
    says: [shelf]"""


def test_the_small_course_is_right(small_course: Path) -> None:
    assert found(small_course) == ()


def test_every_problem_is_told(small_course: Path, lesson: EditFile, mistakes: EditFile) -> None:
    second = shutil.copytree(small_course / "chapters/04-lanterns", small_course / "chapters/05-more")
    (second / "lesson.yaml").write_text("chapter: five\n")
    lesson("title: Lanterns", "title: 12")
    lesson("      - Half of it is left.\n", "")
    told = [(problem.file.parent.name, problem.line, problem.key) for problem in found(small_course)]
    assert told == [
        ("04-lanterns", 2, "title"),
        ("04-lanterns", 28, "exercises[1].hints"),
        ("05-more", 1, "chapter"),
        ("05-more", 1, "title"),
        ("05-more", 1, "summary"),
        ("05-more", 1, "exercises"),
    ]


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [("One", "Two", []), ("", "Two", []), ("One", "Three", ["## Three"]), ("Two", "One", ["## One"])],
)
def test_steps_are_headings_in_order(steps: EditFile, first: str, second: str, told: list[str]) -> None:
    problems_found = found(steps(first, second))
    assert [problem.key for problem in problems_found] == ["exercises[1].step"] * len(told)
    assert all(heading in str(problem) for heading, problem in zip(told, problems_found, strict=True))


def test_a_misspelt_key_is_not_told_as_missing_too(small_course: Path, lesson: EditFile) -> None:
    lesson("title: Lanterns", "titel: Lanterns")
    assert only(small_course).what == "`titel` is not a key; did you mean `title`?"


def test_an_unknown_requirement(small_course: Path, lesson: EditFile) -> None:
    file = lesson("requires: [04-light]", "requires: [04-ligth]")
    problem = only(small_course)
    assert (problem.file, problem.line, problem.key) == (file, 23, "exercises[1].requires[0]")
    assert "there is no exercise `04-ligth`; did you mean `04-light`?" in problem.what


def test_a_circle_is_told_once(small_course: Path, lesson: EditFile) -> None:
    lesson("    title: Light it\n", "    title: Light it\n    requires: [04-dim]\n")
    problem = only(small_course)
    assert problem.what == "`04-dim` requires itself: 04-dim -> 04-light -> 04-dim"


def test_an_exercise_that_requires_itself(small_course: Path, lesson: EditFile) -> None:
    lesson("requires: [04-light]", "requires: [04-dim]")
    assert only(small_course).what == "`04-dim` requires itself: 04-dim -> 04-dim"


def test_two_chapters_of_one_number(small_course: Path) -> None:
    folder = small_course / "chapters/04-other"
    folder.mkdir()
    (folder / "lesson.md").write_text("text")
    (folder / "lesson.yaml").write_text("chapter: 4\ntitle: Other\nsummary: Other.\nexercises: []\n")
    assert only(small_course).what == "`04-other` and `04-lanterns` have the same number"


@pytest.mark.parametrize("name", ["lesson.md", "04-dim.md"])
def test_a_missing_text(small_course: Path, name: str) -> None:
    file = small_course / "chapters/04-lanterns" / name
    file.unlink()
    assert only(small_course).file == file


def test_a_missing_grader(small_course: Path) -> None:
    file = small_course / "graders/ch04_lanterns.py"
    file.unlink()
    assert only(small_course).file == file


def test_a_file_that_the_solution_lacks(small_course: Path, lesson: EditFile) -> None:
    lesson("lanterns/dim.py", "lanterns/dimmer.py")
    problem = only(small_course)
    assert (problem.line, problem.key) == (25, "exercises[1].files[0]")
    assert "is not in the reference solution" in problem.what


@pytest.mark.parametrize("stray", ["04-dimm.md", "starter/04-dimm"])
def test_a_text_or_starter_of_no_exercise(small_course: Path, stray: str) -> None:
    path = small_course / "chapters/04-lanterns" / stray
    path.write_text("text")
    problem = only(small_course)
    assert problem.file == path
    assert problem.what.endswith("called `04-dimm`; did you mean `04-dim`?")


def test_a_mistake_of_an_unknown_exercise(small_course: Path, mistakes: EditFile) -> None:
    mistakes("exercise: 04-light", "exercise: 04-lihgt")
    problem = only(small_course)
    assert (problem.line, problem.key) == (3, "mistakes[0].exercise")
    assert "did you mean `04-light`?" in problem.what


def test_a_text_that_the_solution_does_not_hold(small_course: Path, mistakes: EditFile) -> None:
    mistakes("replace: return 100", "replace: return 1000")
    problem = only(small_course)
    assert (problem.line, problem.key) == (7, "mistakes[0].edits[0].replace")


def test_an_edit_of_a_file_that_is_not_there(small_course: Path, mistakes: EditFile) -> None:
    mistakes("lanterns/light.py", "lanterns/ligth.py")
    problem = only(small_course)
    assert (problem.line, problem.key) == (6, "mistakes[0].edits[0].file")
    assert "lanterns/light.py`?" in problem.what


def test_a_folder_may_be_taken_but_not_changed(small_course: Path, mistakes: EditFile) -> None:
    (folder,) = small_course.glob("solutions/04-*")
    (folder / "shelf").mkdir()
    mistakes("mistakes:", f"mistakes:{FOLDER.replace('WHAT', 'delete: true')}")
    assert found(small_course) == ()
    mistakes("delete: true", "mode: '755'")
    assert only(small_course).key == "mistakes[0].edits[0].file"


@pytest.mark.parametrize(("file", "is_made"), [("shelf", True), ("shelf/lib/x.so", True), ("shelves", False)])
def test_what_is_installed_when_a_home_is_laid_is_in_no_solution(
    small_course: Path, mistakes: EditFile, file: str, is_made: bool
) -> None:
    (folder,) = small_course.glob("solutions/04-*")
    (folder / "built.txt").write_text("project -DCMAKE_INSTALL_PREFIX=~/shelf -DX=1\n")
    edit = FOLDER.replace("WHAT", "rename: other").replace("file: shelf", f"file: {file}")
    mistakes("mistakes:", f"mistakes:{edit}")
    assert (found(small_course) == ()) is is_made


def test_an_edit_of_a_file_that_an_earlier_one_made(small_course: Path, mistakes: EditFile) -> None:
    mistakes("lanterns/light.py\n        mode", "lanterns/dimm.py\n        mode")
    assert found(small_course) == ()


def test_a_broken_mistakes_file(small_course: Path, mistakes: EditFile) -> None:
    mistakes("mistakes:", "mistakes: [")
    assert "not valid YAML" in only(small_course).what


def test_an_alternative_of_unknown_exercise_and_file(small_course: Path, change: Change) -> None:
    file = "solutions/04-lanterns/alternatives/shifts-bits/alternative.yaml"
    change(file, "04-dim", "04-dom")
    change(file, "names.py", "name.py")
    assert [(problem.line, problem.key) for problem in found(small_course)] == [
        (1, "exercises[0]"),
        (3, "deletes[0]"),
    ]


def test_each_edit_builds_on_those_before(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("one two")
    edited = Edited(tmp_path)
    edited.apply(Edit("a.py", replace="two", with_="three"))
    assert edited.text("a.py") == "one three"
    edited.apply(Edit("a.py", rename="b.py"))
    assert (edited.text("a.py"), edited.text("b.py")) == (None, "one three")
    edited.apply(Edit("b.py", delete=True))
    edited.apply(Edit("b.py", replace="one", with_="x"))
    assert edited.text("b.py") is None
    edited.apply(Edit("b.py", content="new"))
    edited.apply(Edit("b.py", mode="755"))
    assert edited.text("b.py") == "new"
    assert (tmp_path / "a.py").read_text() == "one two"


def test_a_file_that_every_chapter_adds_to(tmp_path: Path) -> None:
    for name, line in (("03-ros", "source ros\n"), ("05-more", "source mine\n")):
        (tmp_path / name).mkdir()
        (tmp_path / name / ".bashrc").write_text(line)
    assert "source ros" in (Edited(tmp_path / "05-more").text(".bashrc") or "")


def test_files_of_earlier_chapters_only(tmp_path: Path) -> None:
    for name in ("03-ros", "05-more", "07-last"):
        (tmp_path / name).mkdir()
    (tmp_path / "03-ros/a.msg").write_text("a")
    (tmp_path / "07-last/b.msg").write_text("b")
    edited = Edited(tmp_path / "05-more")
    assert (edited.text("a.msg"), edited.text("b.msg")) == ("a", None)


def test_what_is_no_file(tmp_path: Path) -> None:
    (tmp_path / "solution").mkdir()
    assert Edited(tmp_path / "solution").text(".") is None
    assert Edited(tmp_path / "solution").text(".bashrc") is None
