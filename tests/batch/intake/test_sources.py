"""Everyone who handed something in is found, in whatever form the submissions come."""

from __future__ import annotations

import tarfile
from pathlib import Path

import pytest

from course.batch.intake import SubmissionKind, Upload, find_sources, look, one_source
from course.batch.intake.people import grouped
from course.batch.intake.submission import Uploads
from course.content import Exercise
from course.errors import UsageError
from course.home.opening import USUAL, Opened
from course.model import replace
from tests.batch.intake.trees import lay, manifest, package
from tests.home.opening.archives import entry, make_tar, make_zip

MOODLE = "_assignsubmission_file_"


def sources(path: Path) -> Uploads:
    return find_sources(path, path.parent / "opened")


def ids(found: Uploads) -> list[str]:
    return [source.person.id for source in found.each]


def files(source: Upload) -> list[str]:
    return [part.name for part in source.parts]


def test_folders_and_archives(tmp_path: Path) -> None:
    lay(tmp_path / "class", *package("a", "jane/"), "notes.txt", ".hidden/x", "__MACOSX/x")
    make_zip(tmp_path / "class/Bob Ray.zip", {"package.xml": manifest("a")})
    make_tar(tmp_path / "class/kim.tar.gz", entry("package.xml"), mode="w:gz")
    found = sources(tmp_path / "class")
    assert ids(found) == ["Bob_Ray", "jane", "kim"]
    assert found.each[0].person.name == "Bob Ray"
    assert [finding.where for finding in found.findings] == ["notes.txt"]


def test_moodle_folders_and_files(tmp_path: Path) -> None:
    lay(tmp_path / "class", f"Jane Doe_11{MOODLE}/work/x", "Jane Doe_11_assignsubmission_onlinetext_/o.html")
    lay(tmp_path / "class", f"Bob Ray_22{MOODLE}setup.py", f"Bob Ray_22{MOODLE}node.py")
    found = sources(tmp_path / "class")
    assert [(s.person.id, s.person.name) for s in found.each] == [("22", "Bob Ray"), ("11", "Jane Doe")]
    assert files(found.each[0]) == ["node.py", "setup.py"]
    assert len(found.each[1].parts) == 2


def test_canvas(tmp_path: Path) -> None:
    names = ["doejane_LATE_12_345_work-1.zip", "doejane_12_346_notes.txt", "raybob_13_347_x.py"]
    found = sources(lay(tmp_path / "class", *names))
    assert ids(found) == ["12", "13"]
    assert files(found.each[0]) == ["notes.txt", "work-1.zip"]
    assert [source.person.late for source in found.each] == [True, False]


def test_whoever_handed_in_a_link_has_a_row_and_every_other_file_is_named(tmp_path: Path) -> None:
    others = [f"notes-{number}.txt" for number in range(5)]
    found = sources(lay(tmp_path / "class", "raybob_13_link.html", *others))
    assert ids(found) == ["13"]
    assert "link" in found.each[0].findings[0].what
    assert [finding.where for finding in found.findings] == [", ".join(others)]


def test_github_classroom(tmp_path: Path) -> None:
    lay(tmp_path / "class", *(f"lab-one-{user}/.git/HEAD" for user in ("jane", "bob-ray")), "else/x")
    assert ids(sources(tmp_path / "class")) == ["bob-ray", "else", "jane"]


def test_ids_that_clash(tmp_path: Path) -> None:
    lay(tmp_path / "class", "jane/x", "jane!/x", "jane?/x")
    make_zip(tmp_path / "class/jane.zip", {"x": "x"})
    found = sources(tmp_path / "class")
    assert len(set(ids(found))) == 4
    assert "jane" in ids(found)
    assert all("id jane" in source.findings[0].what for source in found.each)
    assert ids(found) == ids(sources(tmp_path / "class"))


def test_the_order_does_not_matter(tmp_path: Path) -> None:
    items = [
        Opened(path.name, path, ()) for path in sorted(lay(tmp_path / "c", "jane/x", "jane!/x").iterdir())
    ]
    assert grouped(items, "c") == grouped(items[::-1], "c")


def test_two_people_of_one_number(tmp_path: Path) -> None:
    found = sources(lay(tmp_path / "class", f"Jane_1{MOODLE}/x", f"Bob_1{MOODLE}/x"))
    assert len(set(ids(found))) == 2
    assert all(source.findings for source in found.each)


CLASS = {
    f"Jane Doe_11{MOODLE}/ws/src/a/package.xml": manifest("a"),
    f"Bob Ray_22{MOODLE}/work.zip": "",
    f"Kim_33{MOODLE}package.xml": manifest("k"),
}


@pytest.mark.parametrize("wrapper", ["", "course-lab 1-4711/"])
def test_a_class_in_a_zip(tmp_path: Path, exercises: tuple[Exercise, ...], wrapper: str) -> None:
    inner = make_zip(tmp_path / "inner.zip", {"b/package.xml": manifest("b")}).read_bytes()
    content = {f"{wrapper}{name}": text or inner for name, text in CLASS.items()}
    found = sources(make_zip(tmp_path / "class.zip", content))
    assert ids(found) == ["22", "11", "33"]
    assert sources(tmp_path / "class.zip") == found  # again
    looked = [look(source, tmp_path / "more" / source.person.id, exercises) for source in found.each]
    assert [each.packages for each in looked] == [("b",), ("a",), ("k",)]
    assert [each.findings for each in looked] == [()] * 3


def test_a_class_of_one_in_a_zip(tmp_path: Path) -> None:
    assert ids(sources(make_zip(tmp_path / "class.zip", {f"Jane_11{MOODLE}/work/x": "x"}))) == ["11"]


def test_one_bomb_in_a_class_harms_nobody_else(tmp_path: Path, exercises: tuple[Exercise, ...]) -> None:
    bomb = {f"Eve_66{MOODLE}/zeros": bytes(3_000_000), f"Eve_66{MOODLE}/package.xml": manifest("eve")}
    archive = make_zip(tmp_path / "class.zip", {**CLASS, **bomb, "../evil": "x"})
    limits = replace(USUAL, free=1_000_000)
    found = find_sources(archive, tmp_path / "opened", limits)
    assert sorted(ids(found)) == ["11", "22", "33", "66"]
    (eve,) = (source for source in found.each if source.person.id == "66")
    assert look(eve, tmp_path / "eve", exercises).kind is SubmissionKind.NOTHING
    assert "200 times its archive's size" in look(eve, tmp_path / "eve", exercises).findings[0].what
    assert [finding.where for finding in found.findings] == ["../evil"]


@pytest.mark.parametrize("names", [("src/a/package.xml",), ("ros2_tutorial_workspace/",), ("package.xml",)])
@pytest.mark.parametrize("wrapper", ["", "repo-main/"])
def test_a_zip_of_one_person(tmp_path: Path, names: tuple[str, ...], wrapper: str) -> None:
    archive = make_zip(tmp_path / "jane.zip", {f"{wrapper}{name}": "" for name in names})
    assert ids(sources(archive)) == ["jane"]


def test_a_tar_is_of_one_person_and_a_broken_zip_too(tmp_path: Path, exercises: tuple[Exercise, ...]) -> None:
    archive = make_tar(tmp_path / "jane.tar.xz", entry("a/x"), entry("b", kind=tarfile.DIRTYPE), mode="w:xz")
    assert ids(sources(archive)) == ["jane"]
    (tmp_path / "bob.zip").write_bytes(b"PK nonsense")
    (bob,) = sources(tmp_path / "bob.zip").each
    assert look(bob, tmp_path / "o", exercises).findings[0].what == "The archive is broken."


def test_a_folder_of_one_person(tmp_path: Path) -> None:
    assert ids(sources(lay(tmp_path / "jane", "src/a/package.xml", "other/"))) == ["jane"]


def test_what_is_said_to_be_one_person_s_is(tmp_path: Path) -> None:
    lay(tmp_path / "jane", "a/x", "b/x")
    make_zip(tmp_path / "bob.zip", CLASS)
    assert ids(one_source(tmp_path / "jane")) == ["jane"]
    assert ids(one_source(tmp_path / "bob.zip")) == ["bob"]
    with pytest.raises(UsageError, match="missing"):
        one_source(tmp_path / "missing")


@pytest.mark.parametrize("name", ["missing", "file.txt", "empty"])
def test_what_is_no_class(tmp_path: Path, name: str) -> None:
    lay(tmp_path, "file.txt", "empty/")
    with pytest.raises(UsageError, match=name):
        sources(tmp_path / name)


def test_names_that_attack_a_terminal(tmp_path: Path) -> None:
    lay(tmp_path / "class", "jane\x1b[2J\n\u202e/x")
    (source,) = sources(tmp_path / "class").each
    assert (source.person.id, source.person.name) == ("jane_2J", "jane\\x1b[2J \\u202e")
    assert source.shown == "jane\\x1b[2J\\n\\u202e"
