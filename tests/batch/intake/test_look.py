"""Course homes, workspaces, packages, and files are recognized, however they are packed."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.intake import Found, Placement, SubmissionKind, Upload, find_sources, lay_out, look
from course.batch.intake.submission import Part
from course.build import Workspace
from course.content import Exercise
from course.model import replace
from course.model.gradebook import Person
from tests.batch.intake.trees import INTERFACES, MESSAGES, PUBLISHER, lay, manifest, package
from tests.home.opening.archives import make_zip

Looked = Callable[..., Found]
SRC = "ros2_tutorial_workspace/src"

WRAPPERS = ["", "submission/", "repo-main/", "a/b/c/"]


@pytest.mark.parametrize("wrapper", WRAPPERS)
@pytest.mark.parametrize("zipped", [False, True])
@pytest.mark.parametrize(
    ("names", "kind", "target"),
    [
        (
            (*package(MESSAGES, f"{SRC}/"), f"{SRC}/{PUBLISHER}", "answers/10-run-quiz.yaml"),
            SubmissionKind.HOME,
            "",
        ),
        (
            (*package(MESSAGES, "src/"), f"src/{PUBLISHER}"),
            SubmissionKind.WORKSPACE,
            "ros2_tutorial_workspace",
        ),
        ((*package(MESSAGES), PUBLISHER), SubmissionKind.PACKAGES, f"{SRC}/{MESSAGES}"),
    ],
)
def test_what_it_is(
    tmp_path: Path,
    looked: Looked,
    wrapper: str,
    zipped: bool,
    names: tuple[str, ...],
    kind: SubmissionKind,
    target: str,
) -> None:
    lay(tmp_path / "in", *(f"{wrapper}{name}" for name in names), "__MACOSX/._a", "readme.md")
    path = tmp_path / "in"
    if zipped:
        path = Path(shutil.make_archive(str(tmp_path / "jane"), "zip", path))
    found = looked(path)
    assert (found.kind, found.packages, found.findings) == (kind, (MESSAGES,), ())
    root = f"{wrapper}{MESSAGES}" if kind is SubmissionKind.PACKAGES else wrapper.rstrip("/")
    assert found.places == (Placement(root, target),)
    assert found.root == root
    assert "18-publisher" in found.exercises
    assert "18-subscriber" not in found.exercises
    assert ("10-run-quiz" in found.exercises) is (kind is SubmissionKind.HOME)


def test_several_packages(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package(INTERFACES), *package(MESSAGES, "more/")))
    assert (found.kind, found.packages) == (SubmissionKind.PACKAGES, (INTERFACES, MESSAGES))
    assert {place.target for place in found.places} == {f"{SRC}/{INTERFACES}", f"{SRC}/{MESSAGES}"}


def test_files_of_which_none_counts_are_named(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", "poem.txt", *(f"more/{number}.pdf" for number in range(9))))
    (told,) = found.findings
    assert told.what == "No course home, workspace, or package was found in it."
    assert told.where.startswith("more/0.pdf, ") and told.where.endswith("more")


def test_files_handed_in_beside_what_counts_are_named(tmp_path: Path, looked: Looked) -> None:
    home = lay(tmp_path / "home", *package(MESSAGES, f"{SRC}/"), f"{SRC}/{PUBLISHER}", "notes.txt")
    lay(tmp_path, "report.pdf", "old.py")
    found = looked(tmp_path / "report.pdf", home, tmp_path / "old.py")
    assert found.kind is SubmissionKind.HOME
    assert [(one.what, one.where) for one in found.findings] == [
        ("Other files were not used.", "report.pdf, old.py")
    ]


DRIVER = "sas_robot_driver_myrobot"


@pytest.fixture
def in_another_workspace(exercises: tuple[Exercise, ...], tmp_path: Path) -> Looked:
    """`looked`, for a course with an exercise whose package is in another workspace."""
    files = (f"sas_tutorial_workspace/src/{DRIVER}/package.xml",)
    every = (*exercises, replace(exercises[0], id="31-driver", files=files))

    def of(path: Path) -> Found:
        source = Upload(Person("jane", "Jane"), "jane", (Part(path.name, path),))
        return look(source, tmp_path / "opened", every)

    return of


def test_a_package_that_belongs_into_another_workspace(tmp_path: Path, in_another_workspace: Looked) -> None:
    place = Placement(DRIVER, f"sas_tutorial_workspace/src/{DRIVER}")
    found = in_another_workspace(lay(tmp_path / "in", *package(DRIVER), *package(MESSAGES)))
    assert found.places == (Placement(MESSAGES, f"{SRC}/{MESSAGES}"), place)
    found = in_another_workspace(lay(tmp_path / "ws", *package(DRIVER, "src/"), *package(MESSAGES, "src/")))
    assert found.places == (Placement("", "ros2_tutorial_workspace"), replace(place, source=f"src/{DRIVER}"))
    assert "31-driver" in found.exercises
    found = in_another_workspace(lay(tmp_path / "home", *package(DRIVER, "sas_tutorial_workspace/src/")))
    assert found.kind is SubmissionKind.HOME and DRIVER in found.packages


def test_a_package_of_another_folder_name(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in/repo-main", "package.xml").joinpath("package.xml").write_text(manifest(MESSAGES))
    found = looked(tmp_path / "in")
    assert found.places == (Placement("repo-main", f"{SRC}/{MESSAGES}"),)


@pytest.mark.parametrize("name", ["../../evil", "", "a/b", "x" * 200])
def test_a_package_that_calls_itself_what_no_package_is_called(
    tmp_path: Path, looked: Looked, name: str
) -> None:
    lay(tmp_path / "in/pkg", "package.xml").joinpath("package.xml").write_text(manifest(name))
    assert looked(tmp_path / "in").places == (Placement("pkg", f"{SRC}/pkg"),)


def test_a_package_xml_that_is_no_xml(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in/pkg", "package.xml").joinpath("package.xml").write_bytes(b"\xff<<name>own</name>")
    assert looked(tmp_path / "in").packages == ("own",)


def test_a_package_in_a_package_is_none(tmp_path: Path, looked: Looked) -> None:
    assert looked(lay(tmp_path / "in", *package("one"), *package("two", "one/"))).packages == ("one",)
    assert looked(lay(tmp_path / "ws", *package("one", "src/"), *package("two", "src/one/a/"))).packages == (
        "one",
    )


def test_what_tools_leave_is_passed_over(tmp_path: Path, looked: Looked) -> None:
    built = [*package("built", "ws/install/"), *package("built", "ws/build/"), "ws/log/x"]
    left = [
        *package("old", ".git/"),
        *package("mac", "__MACOSX/"),
        *package("venv", "venv/lib/"),
        "venv/pyvenv.cfg",
    ]
    alone = [*package("alone", "install/"), "install/setup.bash"]
    found = looked(lay(tmp_path / "in", *package("good", "ws/src/"), *built, *left, *alone))
    assert (found.kind, found.packages, found.root) == (SubmissionKind.WORKSPACE, ("good",), "ws")


def test_a_folder_that_only_shares_the_name_of_a_build_is_kept(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package("good", "log/")))
    assert found.packages == ("good",)


def test_a_workspace_of_another_name_in_a_home(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", "answers/10-run-quiz.yaml", *package("good", "my_ws/src/")))
    assert (found.kind, found.packages) == (SubmissionKind.HOME, ("good",))
    assert found.places == (Placement("", ""), Placement("my_ws", "ros2_tutorial_workspace"))


def test_a_home_is_known_by_what_the_course_keeps_in_it(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", "w/.ros2course/home.json", *package("a", "w/")))
    assert (found.kind, found.root, found.packages) == (SubmissionKind.HOME, "w", ())


def test_two_homes(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package("a", f"new/{SRC}/"), *package("a", f"old/{SRC}/")))
    assert found.places == (Placement("new", ""),)
    assert [finding.where for finding in found.findings] == ["old"]


def test_a_package_beside_a_workspace_is_added(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package("a", "ws/src/"), *package("b", "more/")))
    assert found.places == (Placement("ws", "ros2_tutorial_workspace"), Placement("more/b", f"{SRC}/b"))


def test_a_package_twice(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package("a"), *package("a", "copy/")))
    assert found.places == (Placement("a", f"{SRC}/a"),)
    assert found.findings[0].where == "copy/a"


def test_single_files_are_told_by_their_names(tmp_path: Path, looked: Looked) -> None:
    names = ["robocop.txt", "x/amazing_quote_publisher_node.py", "10-run-quiz.yaml", "setup.py", "notes.txt"]
    (tmp_path / "in").mkdir()
    found = looked(lay(tmp_path / "in", *(f"deep/{name}" for name in names)))
    assert found.kind is SubmissionKind.FILES
    assert {place.target for place in found.places} == {
        "robocop.txt",
        f"{SRC}/{PUBLISHER}",
        f"{SRC}/{MESSAGES}/setup.py",
        "answers/10-run-quiz.yaml",
    }
    assert [finding.where for finding in found.findings] == [None]
    assert set(found.exercises) == {"01-grep", "18-publisher", "10-run-quiz"}


def test_beside_files_of_several_packages_a_file_may_be_any_s(tmp_path: Path, looked: Looked) -> None:
    names = ["amazing_quote_publisher_node.py", "print_forever_node.py", "setup.py"]
    (tmp_path / "in").mkdir()
    found = looked(lay(tmp_path / "in", *names))
    assert len(found.places) == 2
    assert [finding.where for finding in found.findings] == ["setup.py", None]


def test_single_files_beside_a_workspace(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", "howdy.sh", "setup.py", *package("a", "ws/src/")))
    assert found.places == (Placement("ws", "ros2_tutorial_workspace"), Placement("howdy.sh", "howdy.sh"))
    assert found.findings == ()


def test_folders_tell_files_apart(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", f"{MESSAGES}/setup.py", "minimalist_package/setup.py"))
    assert {place.target for place in found.places} == {
        f"{SRC}/{MESSAGES}/setup.py",
        "ros2_tutorials_preamble/python/minimalist_package/setup.py",
    }


def test_the_latest_of_several_tries(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path, "robocop.txt", "robocop-1.txt", "robocop-2.txt")
    found = looked(*(tmp_path / f"robocop{n}.txt" for n in ("", "-1", "-2")))
    assert found.places == (Placement("robocop-2.txt", "robocop.txt"),)


def test_several_archives_of_one_person(tmp_path: Path, looked: Looked) -> None:
    one = make_zip(tmp_path / "one.zip", {"a/package.xml": manifest("a")})
    other = make_zip(tmp_path / "two.zip", {"b/package.xml": manifest("b")})
    found = looked(one, other)
    assert (found.kind, found.packages, found.root) == (SubmissionKind.PACKAGES, ("a", "b"), "")


@pytest.mark.parametrize(("name", "folder"), [("...zip", "part"), ("..zip", "part"), (".zip", ".zip")])
def test_archives_of_odd_names_stay_in_their_places(
    tmp_path: Path, looked: Looked, name: str, folder: str
) -> None:
    odd = make_zip(tmp_path / name, {"evil": ""})
    # Because of its name, this one makes a home of the folder around it.
    found = looked(odd, make_zip(tmp_path / "ros2_tutorial_workspace.zip", {"x": ""}))
    lay_out(found, tmp_path / "home/home")
    assert [path.parts[-3:-1] for path in (tmp_path / "home").rglob("evil")] == [("home", folder)]


def test_a_package_beside_a_home_that_is_one_too(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", "package.xml", *package("a", f"{SRC}/")))
    assert (found.kind, found.packages) == (SubmissionKind.HOME, ("a",))


@pytest.mark.slow
def test_a_thousand_packages_take_no_hours(tmp_path: Path, looked: Looked) -> None:
    names = [f"{n}/src/p{n}/package.xml" for n in range(500)] + [f"q{n}/package.xml" for n in range(500)]
    archive = make_zip(tmp_path / "many.zip", dict.fromkeys(names, ""))
    assert len(looked(archive).packages) == 1000


def test_an_archive_in_a_folder_is_opened(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", "comments.txt")
    make_zip(tmp_path / "in/work.zip", {"a/package.xml": manifest("a")})
    found = looked(tmp_path / "in")
    assert (found.packages, found.root) == (("a",), "work/a")


def test_an_archive_beside_what_was_recognised_is_left_alone(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", *package("a"))
    make_zip(tmp_path / "in/data.zip", {"b/package.xml": manifest("b")})
    assert looked(tmp_path / "in").packages == ("a",)


def test_an_archive_in_an_archive_is_not_opened(tmp_path: Path, looked: Looked) -> None:
    make_zip(tmp_path / "inner.zip", {"a/package.xml": manifest("a")})
    outer = make_zip(tmp_path / "outer.zip", {"inner.zip": (tmp_path / "inner.zip").read_bytes()})
    found = looked(outer)
    assert (found.kind, found.packages) == (SubmissionKind.NOTHING, ())
    assert [finding.where for finding in found.findings] == ["inner.zip", "inner.zip"]


def test_archives_without_end_and_deep_in_folders_are_not_opened(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", "d/d/d/d/", "e/")
    archive = make_zip(tmp_path / "in/d/d/d/d/z.zip", {"package.xml": manifest("z")}).read_bytes()
    deep = looked(tmp_path / "in")
    assert (deep.kind, deep.findings[1].where) == (SubmissionKind.NOTHING, "d/d/d/d/z.zip")
    for number in range(25):
        (tmp_path / f"in/e/{number}.zip").write_bytes(archive)
    found = looked(tmp_path / "in")
    assert len(list((tmp_path / "opened").iterdir())) == 20
    assert found.packages == ("z",)


def test_exercises_that_share_their_files_need_all_of_them(tmp_path: Path, looked: Looked) -> None:
    package = "ros2_tutorials_preamble/python/minimalist_package/minimalist_package"
    files = ["__init__.py", "minimalist_script.py", "_minimalist_class.py"]
    some = looked(lay(tmp_path / "some", f"{package}/{files[1]}"))
    every = looked(lay(tmp_path / "all", *(f"{package}/{file}" for file in files)))
    assert ("02-style" in some.exercises, "02-style" in every.exercises) == (False, True)


def test_a_package_that_lacks_what_it_needs_is_told(tmp_path: Path, looked: Looked) -> None:
    needs = manifest(MESSAGES).replace(
        "</name>", f"</name><depend>{INTERFACES}</depend><depend>rclpy</depend>"
    )
    files = {f"{MESSAGES}/package.xml": needs}
    found = looked(make_zip(tmp_path / "alone.zip", files))
    assert [f"`{INTERFACES}`" in finding.what for finding in found.findings] == [True]
    files[f"{INTERFACES}/package.xml"] = manifest(INTERFACES)
    assert looked(make_zip(tmp_path / "whole.zip", files)).findings == ()


def test_a_file_without_its_package_is_told(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path, "amazing_quote_publisher_node.py", "robocop.txt")
    (told,) = looked(tmp_path / "amazing_quote_publisher_node.py").findings
    assert "without the package" in told.what
    assert looked(tmp_path / "robocop.txt").findings == ()


def test_what_cannot_be_opened_is_not_an_empty_hand_in(tmp_path: Path, looked: Looked) -> None:
    (tmp_path / "work.rar").write_bytes(b"Rar!\x1a\x07\x01\x00")
    assert looked(tmp_path / "work.rar").kind is SubmissionKind.UNREADABLE


def test_a_broken_archive_is_told_and_the_rest_looked_at(tmp_path: Path, looked: Looked) -> None:
    (tmp_path / "bad.zip").write_bytes(b"PK\3\4 nonsense")
    found = looked(tmp_path / "bad.zip", make_zip(tmp_path / "good.zip", {"package.xml": manifest("a")}))
    assert found.packages == ("a",)
    assert (found.findings[0].what, found.findings[0].where) == ("The archive is broken.", "bad.zip")


def test_a_broken_archive_in_a_folder_is_told_once(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", "bad.zip")
    assert [finding.what for finding in looked(tmp_path / "in").findings] == ["This is not a zip or a tar."]


@pytest.mark.parametrize("names", [(), ("notes.txt",), ("src/",), ("empty/",)])
def test_nothing(tmp_path: Path, looked: Looked, names: tuple[str, ...]) -> None:
    (tmp_path / "in").mkdir()
    found = looked(lay(tmp_path / "in", *names))
    assert (found.kind, found.places, len(found.findings)) == (SubmissionKind.NOTHING, (), 1)


def test_looking_again_finds_the_same(tmp_path: Path, looked: Looked) -> None:
    archive = make_zip(tmp_path / "one.zip", {"a/package.xml": manifest("a")})
    assert looked(archive) == looked(archive)


@pytest.mark.parametrize("inside", ["", f"{SRC}/", "src/"])
def test_of_two_archives_of_one_person_the_newest_is_graded(
    tmp_path: Path, exercises: tuple[Exercise, ...], inside: str
) -> None:
    (tmp_path / "class").mkdir()
    for name, said in (("678904_homework-1", "old"), ("678906_homework-2", "new")):
        files = {f"{inside}a/package.xml": manifest("a"), f"{inside}a/node.py": said}
        make_zip(tmp_path / f"class/liwei_12348_{name}.zip", files)
    (liwei,) = find_sources(tmp_path / "class", tmp_path / "o").each
    found = look(liwei, tmp_path / "opened", exercises)
    lay_out(found, tmp_path / "home")
    assert (tmp_path / f"home/{SRC}/a/node.py").read_text() == "new"
    (told,) = found.findings
    assert "`homework-2" in told.what and str(told.where).startswith("homework-1")


def test_a_newer_package_takes_the_place_of_the_one_in_an_older_home(
    tmp_path: Path, exercises: tuple[Exercise, ...]
) -> None:
    (tmp_path / "class").mkdir()
    old = {f"{SRC}/a/package.xml": manifest("a"), f"{SRC}/a/old.py": "", "answers/10-run-quiz.yaml": ""}
    new = {"a/package.xml": manifest("a"), "a/new.py": ""}
    make_zip(tmp_path / "class/li_1_11_all.zip", old)
    make_zip(tmp_path / "class/li_1_12_a.zip", new)
    (li,) = find_sources(tmp_path / "class", tmp_path / "o").each
    lay_out(look(li, tmp_path / "opened", exercises), tmp_path / "home")
    laid = {path.name for path in (tmp_path / "home").rglob("*") if path.is_file()}
    assert laid == {"10-run-quiz.yaml", "package.xml", "new.py"}


@pytest.mark.parametrize("top", ["", "ros2_tutorial_workspace/"])
def test_packages_beside_src_are_found_where_colcon_finds_them(
    tmp_path: Path, looked: Looked, top: str
) -> None:
    found = looked(lay(tmp_path / "in", *package("a", f"{top}src/"), *package("b", top)))
    assert found.packages == ("a", "b")
    lay_out(found, tmp_path / "home")
    built = Workspace.scan(tmp_path / "home/ros2_tutorial_workspace").packages
    assert sorted(each.name for each in built) == ["a", "b"]


def test_a_workspace_with_its_packages_at_its_root(tmp_path: Path, looked: Looked) -> None:
    found = looked(lay(tmp_path / "in", *package("a", "ros2_tutorial_workspace/")))
    assert found.packages == ("a",)
