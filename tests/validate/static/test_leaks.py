"""Solutions and right answers that a learner would see."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from .conftest import Change, Tell

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
DIM = "ros2_tutorial_workspace/src/lanterns/lanterns/dim.py"
STARTER = "chapters/04-lanterns/starter"
LONG = """\
def half(brightness):
    whole = brightness // 2
    rest = brightness % 2
    return whole + 0 * rest
"""
FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture(autouse=True)
def _a_solution_of_some_lines(change: Change) -> None:
    change(f"solutions/04-lanterns/{DIM}", "", LONG)


def test_a_starter_that_is_the_solution(root: Path, tell: Tell) -> None:
    folder = "ros2_tutorial_workspace/src/lanterns/lanterns"
    shutil.copytree(
        root / "solutions/04-lanterns" / folder, root / STARTER / "04-dim" / folder, dirs_exist_ok=True
    )
    what = f"the starter of 04-dim is its solution: {DIM}, {folder}/names.py"
    assert tell() == [f"{STARTER}/04-dim/{DIM}:None: {what}"]


def test_a_starter_with_a_solution_under_another_name(change: Change, tell: Tell) -> None:
    place = f"{STARTER}/04-light/ros2_tutorial_workspace/src/lanterns/spare.py"
    change(place, "", f"# spare\n\n{LONG}\n")
    assert tell() == [f"{place}:None: the starter of 04-light contains the solution of 04-dim, `{DIM}`"]


def test_a_later_exercise_may_begin_with_what_an_earlier_one_made(change: Change, tell: Tell) -> None:
    change(f"solutions/04-lanterns/{LIGHT}", "", LONG.replace("half", "full") + "    # return 100\n")
    change(f"{STARTER}/04-dim/{LIGHT}", "", LONG.replace("half", "full"))
    assert tell() == []


@pytest.mark.parametrize("file", ["lesson.md", "04-light.md"])
def test_a_text_that_shows_the_whole_solution(file: str, root: Path, tell: Tell) -> None:
    text = root / "chapters/04-lanterns" / file
    text.write_text(f"# Lanterns\n\nSo:\n\n```python\n# comment\n{LONG}```\n")
    assert tell() == [f"chapters/04-lanterns/{file}:6: this is the whole solution of 04-dim, `{DIM}`"]


def test_only_a_last_hint_may_show_it(change: Change, tell: Tell) -> None:
    shown = (
        "|\n        ```python\n" + "".join(f"        {line}\n" for line in LONG.splitlines()) + "        ```"
    )
    lesson = "chapters/04-lanterns/lesson.yaml"
    change(lesson, '"Return `brightness // 2`."', shown)
    assert tell() == []
    change(lesson, "Half of it is left.", shown)
    assert tell() == [f"{lesson}:31: this is the whole solution of 04-dim, `{DIM}`"]


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("answers/04-dim.yaml", "the starter of 04-light contains an answers file, `answers/04-dim.yaml`"),
        (
            "lanterns/lesson.yaml",
            "`lanterns/lesson.yaml` of the course itself is copied into the course home",
        ),
        ("graders/lanterns/x.py", "`graders/lanterns/x.py` of the course itself is copied into"),
    ],
)
def test_files_of_the_course_in_a_new_home(name: str, what: str, change: Change, tell: Tell) -> None:
    change(f"{STARTER}/04-light/{name}", "", "why: x\n")
    assert any(line.startswith(f"{STARTER}/04-light/{name}:None: {what}") for line in tell())


def test_a_link_out_of_the_home(root: Path, tell: Tell) -> None:
    place = root / STARTER / "04-light/lanterns/x.py"
    place.parent.mkdir()
    place.symlink_to(root / "solutions/04-lanterns" / DIM)
    assert any("`lanterns/x.py` of this starter is a link" in line for line in tell())


def test_a_right_answer_in_a_starter(tmp_path: Path, tell: Tell) -> None:
    root = shutil.copytree(FIXTURES / "quiz_course", tmp_path / "quiz_course")
    place = "chapters/05-lighthouses/starter/05-keepers/note.txt"
    (root / place).write_text("keeper: captain\nkeeper: a keeper\nperiod: 5\nwhy: 'tell-apart'\nnumber: 5\n")
    told = [line for line in tell(folder=root) if "right answer" in line]
    assert told == [
        f"{place}:2: this is the right answer to `keeper` of 05-quiz",
        f"{place}:3: this is the right answer to `period` of 05-quiz",
        f"{place}:4: this is the right answer to `why` of 05-quiz",
    ]


def test_a_mystery_with_a_solution_in_it(root: Path, change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/play/04-light.py", "", LONG)
    told = [line for line in tell() if "play" in line]
    place = "chapters/04-lanterns/play/04-light.py"
    assert told == [f"{place}:None: the mystery of 04-light contains the solution of 04-dim, `{DIM}`"]
