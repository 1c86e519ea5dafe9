"""The course supplies what a submission lacks, unless the person is graded for it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from course.batch.batch_plan import BEGUN, LAID, BatchPlan, digest, plan_batch, remarks_on
from course.batch.intake import Found, lay_out
from course.batch.intake.contents import LACKING, NO_PACKAGE
from course.content import open_course
from course.grading import trial
from course.home.opening.unpack import BOTH
from course.model import replace

SRC = "ros2_tutorial_workspace/src"
MESSAGES, INTERFACES = "python_package_that_uses_the_messages", "package_with_interfaces"
NODE = f"{MESSAGES}/{MESSAGES}/amazing_quote_publisher_node.py"


@pytest.fixture
def handed_in(tmp_path: Path) -> Path:
    """ada: the package alone; bao: one file; cleo: all of it."""
    course = open_course()
    trial.lay_solution(course, course.exercise("18-publisher"), tmp_path / "home")
    solved, folder = tmp_path / "home" / SRC, tmp_path / "class"
    shutil.copytree(solved / MESSAGES, folder / "ada" / MESSAGES)
    (folder / "bao").mkdir()
    shutil.copy(solved / NODE, folder / "bao")
    shutil.copytree(solved, folder / "cleo" / "src")
    (folder / "cleo/src" / INTERFACES / "msg/AmazingQuote.msg").write_text("string own\n")
    return folder


def plan(folder: Path, *wanted: str, complete: bool = True) -> BatchPlan:
    opened = folder.parent / "opened"
    return plan_batch(folder, opened, open_course(), wanted, single=False, complete=complete)


def laid(found: Found, home: Path) -> Path:
    lay_out(found, home)
    return home / SRC


def test_a_package_that_others_need_is_the_course_s_own(handed_in: Path, tmp_path: Path) -> None:
    ada, _, cleo = plan(handed_in, "18-publisher").found
    assert remarks_on(ada) == (f"{LAID} ({INTERFACES})",)
    assert (laid(ada, tmp_path / "a") / INTERFACES / "msg/AmazingQuote.msg").is_file()
    assert (remarks_on(cleo), cleo.beneath) == ((), ())
    own = laid(cleo, tmp_path / "c") / INTERFACES / "msg/AmazingQuote.msg"
    assert own.read_text() == "string own\n"


def test_a_single_file_gets_the_package_that_the_exercise_begins_with(
    handed_in: Path, tmp_path: Path
) -> None:
    bao = plan(handed_in, "18-publisher").found[1]
    assert remarks_on(bao) == (f"{LAID} ({INTERFACES})", f"{BEGUN} (setup.py, package.xml)")
    src = laid(bao, tmp_path / "b")
    assert (src / NODE).read_bytes() == (handed_in / "bao" / Path(NODE).name).read_bytes()
    starter = open_course().exercise("18-publisher").starter / SRC / MESSAGES
    assert (src / MESSAGES / "setup.py").read_bytes() == (starter / "setup.py").read_bytes()


def test_an_exercise_that_begins_with_an_earlier_chapter_s_package(tmp_path: Path) -> None:
    """That chapter's solution, with the starter on top, as for those who did everything before."""
    alone = tmp_path / "class/ada"
    alone.mkdir(parents=True)
    exercise = open_course().exercise("23-launch")
    shutil.copy(exercise.solution / exercise.files[0], alone)
    (ada,) = plan(tmp_path / "class", "23-launch").found
    lay_out(ada, tmp_path / "a")
    lay_out(replace(ada, places=(), parts=()), tmp_path / "begun")
    trial.lay_starter(open_course(), exercise, tmp_path / "starter")
    for home, launch_file in (("a", exercise.solution), ("begun", exercise.starter)):
        assert (tmp_path / home / exercise.files[0]).read_bytes() == (
            launch_file / exercise.files[0]
        ).read_bytes()
        for file in exercise.files[1:]:
            assert (tmp_path / home / file).read_bytes() == (tmp_path / "starter" / file).read_bytes()
    solved = open_course().exercise("22-launch").solution
    for wanted in (("22-launch", "23-launch"), ("22-parameters", "23-launch")):
        (ada,) = plan(tmp_path / "class", *wanted).found
        assert ada.beneath and not [tree for tree, _ in ada.beneath if tree.is_relative_to(solved)]


def test_nobody_gets_what_they_are_graded_for(handed_in: Path, tmp_path: Path) -> None:
    ada = plan(handed_in, "17-interfaces", "18-publisher").found[0]
    assert ada.beneath == ()
    assert remarks_on(ada)[0].startswith(LACKING.format(INTERFACES))
    assert not (laid(ada, tmp_path / "a") / INTERFACES).exists()


def test_nothing_is_laid_unasked(handed_in: Path) -> None:
    with_it, without = plan(handed_in, "18-publisher"), plan(handed_in, "18-publisher", complete=False)
    assert [one.beneath for one in without.found] == [(), (), ()]
    assert remarks_on(without.found[1]) == (NO_PACKAGE,)
    pairs = list(zip(with_it.found, without.found, strict=True))
    assert [digest(one) == digest(other) for one, other in pairs] == [False, False, True]


def test_a_file_in_the_place_of_a_package_is_left_there(handed_in: Path, tmp_path: Path) -> None:
    """It is the learner's mistake, not our error."""
    (handed_in / "ada" / INTERFACES).write_text("not a folder")
    shutil.copytree(handed_in / "ada", handed_in / "dev/src")
    dev = next(one for one in plan(handed_in, "18-publisher").found if one.person.id == "dev")
    told = lay_out(dev, tmp_path / "d")
    assert (tmp_path / "d" / SRC / INTERFACES).read_text() == "not a folder"
    assert [one.what for one in told] == [BOTH] and INTERFACES in told[0].where
