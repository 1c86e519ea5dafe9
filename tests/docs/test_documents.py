"""The documents are true: their code runs, their tables name what exists, pictures are up to date."""

from __future__ import annotations

import re
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import pytest

from course.arena.arena import Arena
from course.arena.arena_node import ArenaNode
from course.arena.cpp_programs import CppPrograms
from course.content import open_course, problems
from course.evidence.recording import Recording
from course.grading import trial
from course.grading.load import questions_for
from course.grading.quiz.questions import check_quiz

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
CODE = re.compile(r"```python\n(.*?)```", re.DOTALL)
YAML = re.compile(r"```yaml\n(.*?)```", re.DOTALL)
CALLED = {"arena": Arena, "arena.ros": ArenaNode, "arena.cpp": CppPrograms, "recording": Recording}


def blocks(name: str) -> list[str]:
    return CODE.findall((DOCS / name).read_text(encoding="utf-8"))


def test_the_sample_grader_is_a_grader() -> None:
    names: dict[str, object] = {}
    exec(compile(blocks("writing-a-grader.md")[0], "sample", "exec"), names)
    talker = names["talker"]
    assert list(talker.checks) == ["builds", "starts", "topic", "rate"]  # type: ignore[attr-defined]


def test_the_sample_quiz_and_mystery_are_right(tmp_path: Path) -> None:
    quiz, mistake, computed = YAML.findall((DOCS / "writing-a-grader.md").read_text(encoding="utf-8"))
    mystery = "  - id: 19-inspect-topics\n    title: t\n    summary: s\n" + computed
    for number, exercise in (("01", quiz), ("19", mystery)):
        chapter = tmp_path / f"chapters/{number}-sample"
        chapter.mkdir(parents=True)
        head = f"chapter: {int(number)}\ntitle: Sample\nsummary: A sample.\nexercises:\n"
        (chapter / "lesson.yaml").write_text(head + exercise, encoding="utf-8")
        for text in ("lesson.md", "01-terminal-quiz.md" if number == "01" else "19-inspect-topics.md"):
            (chapter / text).write_text("# Sample\n\nText.\n", encoding="utf-8")
    (tmp_path / "chapters/01-sample/mistakes.yaml").write_text(f"mistakes:\n{mistake}", encoding="utf-8")
    (tmp_path / "chapters/19-sample/play").mkdir()
    play, grader = (text for text in blocks("writing-a-grader.md") if "draw(" in text or "Mystery(" in text)
    (tmp_path / "chapters/19-sample/play/19-inspect-topics.py").write_text(play, encoding="utf-8")
    (tmp_path / "graders").mkdir()
    (tmp_path / "graders/ch19_sample.py").write_text(grader, encoding="utf-8")
    course = open_course(tmp_path)
    assert problems(course) == ()
    (asked,) = questions_for(course.exercise("19-inspect-topics"), 5)
    assert asked.form == "number" and "{topic}" not in asked.ask
    trial.lay_mistake(course, course.exercise("01"), course.exercise("01").mistakes()[0], tmp_path)
    failed = [check.id for check in check_quiz(course.exercise("01"), tmp_path).checks if not check.earned]
    assert failed == ["tab-key"]


@pytest.mark.parametrize("owner", CALLED)
def test_what_the_tables_name_exists(owner: str) -> None:
    text = (DOCS / "writing-a-grader.md").read_text(encoding="utf-8")
    parts = {name.rpartition(".")[2] for name in CALLED if name.startswith(f"{owner}.")}
    named = set(re.findall(rf"`{re.escape(owner)}\.(\w+)", text)) - parts
    fields = set(getattr(CALLED[owner], "__dataclass_fields__", {}))
    assert named, "the document names nothing of it"
    assert [name for name in named if not hasattr(CALLED[owner], name) and name not in fields] == []


def test_links_between_documents_lead_somewhere() -> None:
    for document in (ROOT / "README.md", *DOCS.glob("*.md")):
        for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text(encoding="utf-8")):
            assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_the_readme_says_what_each_dependency_is_for() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    table = readme.partition("| package | for |")[2].partition("\n\n")[0]
    first_column = "".join(row.split("|")[1] for row in table.splitlines() if row)
    told = re.findall(r"`([\w*-]+)`", first_column)
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8").partition("[project.scripts]")[0]
    needed = re.findall(r'^    "([\w-]+)', project.partition("dependencies = [")[2], re.MULTILINE)
    assert len(needed) > 30
    assert {one for one in needed if not any(fnmatch(one, name) for name in told)} == set()
    extras = {"jazzy", "similar", "cluster", "test"}
    assert {name for name in told if not any(fnmatch(one, name) for one in needed)} == extras


@pytest.mark.slow
def test_the_picture_of_a_check_is_what_a_check_prints() -> None:
    done = subprocess.run([sys.executable, str(DOCS / "pictures.py"), "--check"], cwd=ROOT, check=False)
    assert done.returncode == 0, "run docs/pictures.py and look at what changed"
