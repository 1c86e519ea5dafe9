"""Opening a course folder, and what is read from it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import ChapterRef, open_course
from course.content.course import choose, tidy, unknown
from course.content.layout import own_root
from course.errors import ContentError, OurFault, UsageError

REPOSITORY = Path(__file__).parents[2]


def test_a_chapter_is_read_whole(small_course: Path) -> None:
    (chapter,) = open_course(small_course).chapters()
    assert (chapter.number, chapter.slug, chapter.title) == (4, "04-lanterns", "Lanterns")
    assert chapter.summary == "Light a lantern, and dim it."
    assert chapter.text.startswith("# Lanterns\n")
    assert [exercise.id for exercise in chapter.exercises] == ["04-light", "04-dim"]


def test_a_lesson_ends_with_the_official_pages(
    small_course: Path, change: Callable[[str, str, str], Path]
) -> None:
    links = "links: {Nodes: https://docs.ros.org/a.html, Timers: https://docs.ros.org/b.html}\nexercises:"
    change("chapters/04-lanterns/lesson.yaml", "exercises:", links)
    course = open_course(small_course)
    (lesson,) = course.lessons(course.exercise("04-dim"))
    pages = "Nodes\nhttps://docs.ros.org/a.html\n\nTimers\nhttps://docs.ros.org/b.html\n"
    assert lesson.text.endswith(f"\n\n## Read more\n\n```text\n{pages}```\n")
    assert course.chapters()[0].text == lesson.text


def test_each_exercise_has_its_step_of_the_lesson(steps: Callable[[str, str], Path]) -> None:
    course = open_course(steps("One", "Two"))
    light, dim = course.exercises()
    (first,), (second,), (all_of_it,) = (
        course.lessons(light),
        course.lessons(dim),
        course.lessons(light, whole=True),
    )
    assert (first.text.splitlines()[0], first.text.splitlines()[-1]) == ("# Lanterns", "of one")
    assert (second.text, first.text + second.text) == ("## Two\n\nof two\n", all_of_it.text)
    assert (first.id, second.id, all_of_it.id) == ("04-lanterns", "04-lanterns#Two", "04-lanterns")


def test_an_exercise_without_a_step_belongs_to_the_one_before(steps: Callable[[str, str], Path]) -> None:
    course = open_course(steps("One", ""))
    light, dim = course.exercises()
    assert course.lessons(light) == course.lessons(dim) == course.lessons(dim, whole=True)


def test_a_step_is_a_heading_of_the_lesson(steps: Callable[[str, str], Path]) -> None:
    course = open_course(steps("One", "Three"))
    with pytest.raises(ContentError, match="`## Three` is missing"):
        course.lessons(course.exercise("04-light"))


def test_an_exercise_is_read_whole(small_course: Path) -> None:
    dim = open_course(small_course).exercise("04-dim")
    assert dim.chapter == ChapterRef(4, "Lanterns", "04-lanterns")
    assert (dim.title, dim.summary) == ("Dim it", "Write a function that halves a brightness.")
    assert dim.text == "Write `half(brightness)` in `dim.py`.\n"
    assert dim.packages == ("lanterns",)
    assert dim.grader_packages == ("lamp_oil",)
    assert dim.requires == ("04-light",)
    assert [Path(file).name for file in dim.files] == ["dim.py", "names.py"]
    assert dim.time_limit == 20.0
    assert (len(dim.hints), dim.after) == (3, None)


def test_an_exercise_about_files_of_the_home(
    small_course: Path, change: Callable[[str, str, str], Path]
) -> None:
    new = "    time_limit: 20\n    looks_at: ['*', a_folder]\n    bonus: true\n    local_only: true\n"
    change("chapters/04-lanterns/lesson.yaml", "    time_limit: 20\n", new)
    light, dim = (open_course(small_course).exercise(name) for name in ("04-light", "04-dim"))
    assert (dim.looks_at, dim.bonus, dim.local_only) == (("*", "a_folder"), True, True)
    assert (light.looks_at, light.bonus, light.local_only) == ((), False, False)


def test_what_is_left_out_has_a_default(small_course: Path) -> None:
    light = open_course(small_course).exercise("04-light")
    assert (light.time_limit, light.requires, light.grader_packages) == (60.0, (), ())
    assert light.after == "It shines."


def test_paths_are_absolute_and_right(small_course: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(small_course.parent)
    light = open_course(Path("small_course")).exercise("04-light")
    assert light.grader == small_course / "graders/ch04_lanterns.py"
    assert light.starter == small_course / "chapters/04-lanterns/starter/04-light"
    assert light.solution == small_course / "solutions/04-lanterns"
    assert light.grader.is_file()
    assert light.starter.is_dir()
    assert light.solution.is_dir()


def test_chapters_are_in_order(small_course: Path) -> None:
    for number in ("11", "02"):
        folder = small_course / f"chapters/{number}-empty"
        folder.mkdir()
        (folder / "lesson.md").write_text("text")
        yaml = f"chapter: {int(number)}\ntitle: Empty\nsummary: Nothing to do.\nexercises: []\n"
        (folder / "lesson.yaml").write_text(yaml)
    (small_course / "chapters/.hidden").mkdir()
    assert [chapter.number for chapter in open_course(small_course).chapters()] == [2, 4, 11]


def test_a_checkout_s_course_is_beside_the_package(tmp_path: Path) -> None:
    (tmp_path / "course/_course/chapters").mkdir(parents=True)
    assert own_root(tmp_path / "course") == tmp_path / "course/_course"
    (tmp_path / "chapters").mkdir()
    assert own_root(tmp_path / "course") == tmp_path


def test_an_installation_without_lessons_is_our_fault(tmp_path: Path) -> None:
    with pytest.raises(OurFault, match="lessons are missing"):
        own_root(tmp_path / "course")


def test_without_a_folder_the_own_course_is_opened() -> None:
    assert open_course().root == REPOSITORY


def test_a_folder_that_is_no_course_is_told_what_it_lacks(tmp_path: Path) -> None:
    (tmp_path / "graders").mkdir()
    with pytest.raises(UsageError, match=r"it has no chapters/, solutions/$"):
        open_course(tmp_path)


def test_a_course_without_a_chapter_is_none(tmp_path: Path) -> None:
    (tmp_path / "chapters").mkdir()
    with pytest.raises(UsageError, match="there is no chapter in its chapters/ folder"):
        open_course(tmp_path)


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="there is no such folder"):
        open_course(tmp_path / "nowhere")


@pytest.mark.parametrize("name", ["lesson.md", "04-dim.md"])
def test_a_missing_text_names_its_file(small_course: Path, name: str) -> None:
    (small_course / "chapters/04-lanterns" / name).unlink()
    with pytest.raises(ContentError, match=f"{name} is missing") as caught:
        open_course(small_course).chapters()
    assert caught.value.file.name == name


def test_an_empty_text_is_an_error(small_course: Path) -> None:
    (small_course / "chapters/04-lanterns/04-dim.md").write_text(" \n")
    with pytest.raises(ContentError, match=r"04-dim\.md is empty"):
        open_course(small_course).chapters()


def test_a_text_that_is_not_utf8_is_an_error(small_course: Path) -> None:
    (small_course / "chapters/04-lanterns/04-dim.md").write_bytes(b"caf\xe9")
    with pytest.raises(ContentError, match="not UTF-8"):
        open_course(small_course).chapters()


def run_python(code: str, *arguments: str) -> str:
    environ = {**os.environ, "PYTHONPATH": str(REPOSITORY)}
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(command, env=environ, check=True, capture_output=True, text=True).stdout


def test_importing_content_imports_nothing_slow() -> None:
    found = run_python("import sys, course.content; print(*sys.modules)").split()
    assert not {"pydantic", "yaml", "difflib", "sqlite3"} & set(found)


@pytest.mark.slow
def test_a_remembered_lesson_needs_neither_yaml_nor_pydantic(small_course: Path, tmp_path: Path) -> None:
    code = (
        "import sys; from pathlib import Path; from course.content import open_course\n"
        "print(open_course(Path(sys.argv[1]), cache=Path(sys.argv[2])).exercise('04-dim').id)\n"
        "print('pydantic' in sys.modules, 'yaml' in sys.modules)"
    )
    arguments = (str(small_course), str(tmp_path / "cache"))
    assert run_python(code, *arguments).split() == ["04-dim", "True", "True"]
    assert run_python(code, *arguments).split() == ["04-dim", "False", "False"]


IDS = (
    "02-script",
    "18-publisher",
    "18-subscriber",
    "19-inspect-topics",
    "20-server",
    "20-client",
    "21-publish",
    "30-server",
)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("18-publisher", "18-publisher"),
        ("18-pub", "18-publisher"),
        ("subscriber", "18-subscriber"),
        ("19", "19-inspect-topics"),
        ("2", "02-script"),
        ("2-script", "02-script"),
        ("02-s", "02-script"),
        ("inspect", "19-inspect-topics"),
        ("client", "20-client"),
        ("publisher", "18-publisher"),
        ("publish", "21-publish"),  # a whole name, though another one begins with it
        (" 18_Publisher ", "18-publisher"),
    ],
)
def test_an_abbreviation_that_fits_one_works(typed: str, meant: str) -> None:
    assert choose(tidy(typed), IDS) == meant


@pytest.mark.parametrize(
    ("typed", "listed"),
    [
        ("18", "18-publisher, 18-subscriber"),
        ("server", "20-server, 30-server"),
        ("publ", "18-publisher, 21-publish"),
    ],
)
def test_one_that_fits_several_names_them(typed: str, listed: str) -> None:
    with pytest.raises(UsageError, match="matches several") as caught:
        choose(typed, IDS)
    assert caught.value.next_step.endswith(listed)


@pytest.mark.parametrize("typed", ["99", "18-x", "", "ublisher", "1"])
def test_what_fits_nothing_is_nothing(typed: str) -> None:
    assert choose(typed, IDS) is None


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("18-pubisher", "18-publisher"), ("pubisher", "18-publisher"), ("19-server", "20-server")],
)
def test_an_unknown_one_gets_the_nearest(typed: str, meant: str) -> None:
    error = unknown(typed, IDS)
    assert error.what == f"there is no exercise `{typed}`"
    assert meant in (error.next_step or "")


def test_one_unlike_all_gets_the_list() -> None:
    assert unknown("zzz", IDS).next_step == "`ros2course list` shows them all"


def test_only_the_chapter_that_is_named_is_read(small_course: Path) -> None:
    broken = small_course / "chapters/05-broken"
    broken.mkdir()
    (broken / "lesson.yaml").write_text("nonsense: [")
    course = open_course(small_course)
    assert course.exercise("04-dim").id == "04-dim"
    assert course.exercise("light").id == "04-light"
    with pytest.raises(UsageError, match="no exercise `04-dum`"):
        course.exercise("04-dum")
    with pytest.raises(ContentError):
        course.exercise("05-any")
