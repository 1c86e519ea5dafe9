"""With `--names lenient`, programs and packages with wrong names are graded, minus a point."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.batch_plan import BatchPlan, digest, plan_batch, remarks_on
from course.batch.intake import Found, lay_out
from course.batch.intake.other_names import AS_IF, ENTERED, UNCLEAR, asked_programs
from course.build import Workspace
from course.content import open_course
from course.evidence.sources import read_sources
from course.explain.setup_py import entry_points
from course.grading import trial

SRC = "ros2_tutorial_workspace/src"
MESSAGES, QUOTES = "python_package_that_uses_the_messages", "quotes"
PUBLISHER, SUBSCRIBER = "amazing_quote_publisher_node", "amazing_quote_subscriber_node"
OTHERS = {PUBLISHER: "talker", SUBSCRIBER: "listener"}
ASKED = {"18-publisher": [PUBLISHER], "12-print-forever": ["print_forever_node"], "23-launch": []}
BOTH = ("18-publisher", "18-subscriber")
Hand = Callable[..., Path]


@pytest.fixture
def hand(tmp_path: Path) -> Hand:
    """`hand("ada", "quotes", amazing_quote_publisher_node="talker")`: the solution with other names."""

    def of(person: str, package: str = MESSAGES, **programs: str) -> Path:
        course = open_course()
        trial.lay_solution(course, course.exercise("18-subscriber"), tmp_path / "solved" / person)
        src = tmp_path / "class" / person / "src"
        shutil.copytree(tmp_path / "solved" / person / SRC, src)
        folder = (src / MESSAGES).rename(src / package)
        (folder / MESSAGES).rename(folder / package)
        (folder / "resource" / MESSAGES).rename(folder / "resource" / package)
        for name in ("setup.py", "setup.cfg", "package.xml"):
            edit(folder / name, MESSAGES, package)
        for name, other in programs.items():
            edit(folder / "setup.py", f"'{name} = '", f"'{other} = '")
        return folder

    return of


def edit(file: Path, old: str, new: str) -> None:
    assert old in file.read_text()
    file.write_text(file.read_text().replace(old, new))


def planned(folder: Path, *wanted: str, lenient: bool = True) -> BatchPlan:
    opened = folder.parent / "opened"
    return plan_batch(folder, opened, open_course(), wanted, single=False, lenient=lenient)


def plan(tmp_path: Path, *wanted: str, lenient: bool = True) -> Found:
    (found,) = planned(tmp_path / "class", *(wanted or BOTH), lenient=lenient).found
    return found


def programs(found: Found, home: Path) -> dict[str, str]:
    """The programs of the requested package as it is laid out, by name."""
    lay_out(found, home)
    package = Workspace.scan(home / SRC, home).find(MESSAGES)
    if package is None:
        return {}
    entries = entry_points(read_sources(home, [package.source]), package.source)
    return {entry.name: entry.target for entry in entries}


@pytest.mark.parametrize("others", [{}, OTHERS], ids=["package", "both"])
def test_a_package_of_another_name(hand: Hand, tmp_path: Path, others: dict[str, str]) -> None:
    """A copy with the right name is laid beside it, and the original stays as it is."""
    own = hand("ada", QUOTES, **others)
    found = plan(tmp_path)
    assert programs(found, tmp_path / "home") == {
        name: f"{QUOTES}.{name}:main" for name in (PUBLISHER, SUBSCRIBER)
    }
    assert (tmp_path / "home" / SRC / QUOTES / "setup.py").read_text() == (own / "setup.py").read_text()
    workspace = Workspace.scan(tmp_path / "home" / SRC, tmp_path / "home")
    beside = workspace.find(MESSAGES)
    assert beside and beside.depends_on(QUOTES) and beside.depends_on("package_with_interfaces")
    assert found.person.renamed == BOTH
    own_name = others.get(PUBLISHER, PUBLISHER)
    told = AS_IF.format(BOTH[0], f"`{own_name}` of `{QUOTES}`", f"`{PUBLISHER}` of `{MESSAGES}`")
    assert remarks_on(found)[0] == told


def test_programs_of_other_names(hand: Hand, tmp_path: Path) -> None:
    """They are told apart by what they create, and renamed where they are declared."""
    own = hand("ada", **OTHERS)
    found = plan(tmp_path)
    assert programs(found, tmp_path / "home") == {
        name: f"{MESSAGES}.{name}:main" for name in (PUBLISHER, SUBSCRIBER)
    }
    laid = (tmp_path / "home" / SRC / MESSAGES / "setup.py").read_text()
    assert laid.count("\n") == (own / "setup.py").read_text().count("\n")
    told = AS_IF.format(BOTH[1], f"`listener` of `{MESSAGES}`", f"`{SUBSCRIBER}` of `{MESSAGES}`")
    assert remarks_on(found)[1] == told


def test_it_costs_where_it_was_needed(hand: Hand, tmp_path: Path) -> None:
    hand("ada", **{SUBSCRIBER: "listener"})
    assert plan(tmp_path).person.renamed == ("18-subscriber",)
    assert plan(tmp_path, "18-publisher").person.renamed == ()


def test_strict_unless_asked(hand: Hand, tmp_path: Path) -> None:
    hand("ada", QUOTES, **OTHERS)
    strict, lenient = plan(tmp_path, lenient=False), plan(tmp_path)
    assert (strict.written, strict.person.renamed, strict.findings) == ((), (), ())
    assert digest(strict) != digest(lenient)


def test_right_names_change_nothing(hand: Hand, tmp_path: Path) -> None:
    hand("ada")
    assert plan(tmp_path) == plan(tmp_path, lenient=False)


def test_what_does_something_else_is_not_taken_for_it(hand: Hand, tmp_path: Path) -> None:
    own = hand("ada", **{PUBLISHER: "talker"})
    (own / MESSAGES / f"{PUBLISHER}.py").write_text("def main():\n    create_service(1, 2, 3)\n")
    assert plan(tmp_path).person.renamed == ()


def test_a_program_that_another_exercise_asks_for_is_not_taken_for_it(hand: Hand, tmp_path: Path) -> None:
    """Even if nobody can tell what it does."""
    own = hand("ada")
    edit(own / "setup.py", f"'{PUBLISHER} = '\n", "")
    edit(own / "setup.py", f"'{MESSAGES}.{PUBLISHER}:main',", "")
    (own / MESSAGES / f"{SUBSCRIBER}.py").write_text("from elsewhere import main\n")
    assert plan(tmp_path).person.renamed == ()


@pytest.mark.parametrize("unclear", ["programs", "packages", "one for both"])
def test_what_could_be_several_is_told(hand: Hand, tmp_path: Path, unclear: str) -> None:
    own = hand("ada", QUOTES, **OTHERS)
    if unclear == "programs":
        edit(own / QUOTES / f"{SUBSCRIBER}.py", "create_subscription", "create_publisher")
    elif unclear == "packages":
        shutil.copytree(own, own.parent / "again")
        edit(own.parent / "again/package.xml", f"<name>{QUOTES}<", "<name>again<")
    else:
        edit(own / "setup.py", f"{QUOTES}.{SUBSCRIBER}:main", "")
        (own / QUOTES / f"{PUBLISHER}.py").write_text("from elsewhere import main\n")
    found, asked = plan(tmp_path), f"`{PUBLISHER}` of `{MESSAGES}`"
    assert "18-publisher" not in found.person.renamed
    told = [remark for remark in remarks_on(found) if remark.startswith(UNCLEAR.format(asked))]
    assert len(told) == 1 and "`talker` of `quotes`" in told[0]


def test_a_package_that_is_more_than_its_programs_is_left_alone() -> None:
    """Its launch files would be missing in the copy with the right name."""
    course = open_course()
    asked = {name: [one.entry.name for one in asked_programs(course.exercise(name))] for name in ASKED}
    assert asked == ASKED


def test_a_name_that_stands_elsewhere_too_is_not_touched(hand: Hand, tmp_path: Path) -> None:
    """Nobody knows what else would change."""
    own = hand("ada", **OTHERS)
    edit(own / "setup.py", "'talker = '", "*['my_talker = a:b'], 'talker = '")
    assert plan(tmp_path, "18-publisher").person.renamed == ()


def test_a_folder_in_the_place_of_the_package_stays(hand: Hand, tmp_path: Path) -> None:
    own = hand("ada", QUOTES)
    own.rename(own.with_name(MESSAGES))
    assert plan(tmp_path).written == ()


@pytest.mark.parametrize(
    "setup",
    ["(" * 60_000, "-" * 60_000 + "1", "a" + ".b" * 30_000, "'" + "talker =" * 10_000, "\0\ud800"],
    ids=["brackets", "signs", "dots", "text", "no text"],
)
def test_files_made_to_stall_or_crash_are_harmless(hand: Hand, tmp_path: Path, setup: str) -> None:
    own = hand("ada", **OTHERS)
    (own / "setup.py").write_bytes(setup.encode("utf-8", "surrogatepass"))
    (own / MESSAGES / f"{PUBLISHER}.py").write_bytes(setup.encode("utf-8", "surrogatepass"))
    assert plan(tmp_path).person.renamed == ()


@pytest.fixture
def lone(tmp_path: Path) -> Callable[..., Found]:
    """`lone()`: what was found in a publisher's file that was handed in alone."""

    def of(*wanted: str, complete: bool = True, **others: bytes) -> Found:
        course, folder = open_course(), tmp_path / "class/ada"
        folder.mkdir(parents=True)
        node = course.exercise("18-publisher").solution / SRC / MESSAGES / MESSAGES / f"{PUBLISHER}.py"
        shutil.copy(node, folder)
        for name, content in others.items():
            (folder / name.replace("_py", ".py")).write_bytes(content)
        opened = tmp_path / "opened"
        planned = plan_batch(
            folder.parent, opened, course, wanted or BOTH, single=False, complete=complete, lenient=True
        )
        return planned.found[0]

    return of


def test_a_program_that_was_handed_in_alone_gets_its_entry_point(
    lone: Callable[..., Found], tmp_path: Path
) -> None:
    found = lone()
    assert programs(found, tmp_path / "home")[PUBLISHER] == f"{MESSAGES}.{PUBLISHER}:main"
    assert found.person.renamed == ("18-publisher",)
    assert remarks_on(found)[0] == ENTERED.format("18-publisher", PUBLISHER)


def test_a_setup_py_that_was_handed_in_stays(lone: Callable[..., Found]) -> None:
    found = lone(setup_py=b"from setuptools import setup\n")
    assert (found.person.renamed, found.written) == ((), ())


def test_without_the_course_s_own_files_there_is_no_entry_point(lone: Callable[..., Found]) -> None:
    found = lone(complete=False)
    assert (found.person.renamed, found.written) == ((), ())


@pytest.mark.slow
def test_graded_as_if_named_right(hand: Hand, tmp_path: Path) -> None:
    """Each of the three cases, by the command itself; a wrong program stays wrong."""
    slow = hand("ada", QUOTES)
    edit(slow / QUOTES / f"{PUBLISHER}.py", "0.5", "1.0")
    hand("bao", **OTHERS)
    hand("cleo", QUOTES, **OTHERS)
    asked = ("--exercises", "18-publisher", "--names", "lenient", "--no-sandbox", "--out", "out")
    subprocess.run([sys.executable, "-m", "course", "grade", "class", *asked], cwd=tmp_path, check=True)
    told = json.loads((tmp_path / "out/results.json").read_text())
    (ada,), (bao,), (cleo,) = (one["results"] for one in told["graded"])
    assert [check["id"] for check in ada["checks"] if check["outcome"] != "passed"] == ["rate"]
    assert [(one["verdict"], one["points"]) for one in (ada, bao, cleo)] == [
        ("not passed", 9),
        ("passed", 11),
        ("passed", 11),
    ]
    assert (
        f"were `{PUBLISHER}` of `{MESSAGES}`, for one point less."
        in (tmp_path / "out/feedback/cleo.md").read_text()
    )
    assert "Names: -1 point." in (tmp_path / "out/results.csv").read_text()
