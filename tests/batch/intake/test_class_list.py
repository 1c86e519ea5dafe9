"""The class as an LMS lists it, merged with the submissions."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import pytest

from course.batch.intake import find_sources
from course.batch.intake.class_list import in_groups, merged, read_class_list
from course.batch.intake.submission import Part, Upload, Uploads
from course.errors import UsageError
from course.home.opening import Remark
from course.model.gradebook import Person

CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (99)\r\n"
    "    Points Possible,,,,,10\r\n"
    '"Doe, Jane",12345,S1,jdoe,A,\r\n"Nguyen, Bao",12346,S2,bnguyen,A,\r\n'
)
MOODLE = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
    "Last modified (submission),Last modified (grade),Feedback comments\n"
    'Participant 70,Jane Doe,j@x.edu,Submitted for grading,,10.00,Yes,"Monday, 5 October 2026, 11:58 PM",-,\n'
    "Participant 71,Bao Nguyen,b@x.edu,No submission,,10.00,Yes,-,-,\n"
)
PARTICIPANTS = (
    "First name,Last name,Email address,ID number,Groups\nJane,Doe,j@x.edu,,Team 1\n"
    "Bao,Nguyen,b@x.edu,S2,Team 1\n"
)
CANVAS_GROUPS = (
    "name,canvas_user_id,user_id,login_id,sections,group_name,canvas_group_id,group_id\n"
    "Jane Doe,12345,S1,jdoe,A,Team 1,55,\nBao Nguyen,12346,S2,bnguyen,A,,,\n"
)
BLACKBOARD = '"Last Name"\t"First Name"\t"Username"\t"Student ID"\n"Doe"\t"Jane"\t"jdoe"\t"S1"\n'
CLASSROOM = "username,first_name,last_name,email,section,github_id\njdoe,Jane,Doe,,A,1\n"


def listed(folder: Path, text: str) -> list[Person]:
    (folder / "list.csv").write_text(text, encoding="utf-8")
    return [one.person for one in read_class_list(folder / "list.csv")]


def upload(identity: str, name: str = "", *, late: bool = False, at: datetime | None = None) -> Upload:
    part = Part("work", Path("/work"))
    return Upload(Person(identity, name or identity, late, at), f"{identity}.zip", (part,))


@pytest.mark.parametrize(
    ("text", "people"),
    [
        (CANVAS, [("12345", "Doe, Jane"), ("12346", "Nguyen, Bao")]),
        (CANVAS_GROUPS, [("12345", "Jane Doe"), ("12346", "Bao Nguyen")]),
        (MOODLE, [("70", "Jane Doe"), ("71", "Bao Nguyen")]),
        (PARTICIPANTS, [("j@x.edu", "Jane Doe"), ("S2", "Bao Nguyen")]),
        (BLACKBOARD, [("jdoe", "Jane Doe")]),
        (CLASSROOM, [("jdoe", "Jane Doe")]),
        ("id,name\n7,Ada\n7,Ada again\n", [("7", "Ada again")]),
    ],
)
def test_lists_of_every_kind(tmp_path: Path, text: str, people: list[tuple[str, str]]) -> None:
    assert [(one.id, one.name) for one in listed(tmp_path, text)] == people


def test_groups_of_canvas(tmp_path: Path) -> None:
    assert [one.group for one in listed(tmp_path, CANVAS_GROUPS)] == ["Team 1", ""]


def test_moodle_tells_when_it_was_handed_in(tmp_path: Path) -> None:
    jane, bao = listed(tmp_path, MOODLE)
    assert (jane.handed_in, bao.handed_in) == (datetime(2026, 10, 5, 23, 58), None)


@pytest.mark.parametrize("text", ["one\n", "color,size\nred,3\n", "", "Student,ID\nPoints Possible,\n"])
def test_what_lists_nobody(tmp_path: Path, text: str) -> None:
    with pytest.raises(UsageError):
        listed(tmp_path, text)


def test_what_is_no_table(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="is not a class list: it has no line of column names") as raised:
        listed(tmp_path, "ada\n")
    assert "id,name,group" in str(raised.value.next_step)


def test_everybody_is_there_whoever_handed_in(tmp_path: Path) -> None:
    (tmp_path / "list.csv").write_text(CANVAS, encoding="utf-8")
    uploads = Uploads((upload("12346", "nguyenbao", late=True), upload("999", "eve")))
    jane, bao, eve = merged(uploads, read_class_list(tmp_path / "list.csv")).each
    assert (jane.person.name, jane.parts, jane.shown) == ("Doe, Jane", (), "")
    assert [finding.what for finding in jane.findings] == ["Nothing was handed in."]
    assert (bao.person.id, bao.person.name, bao.person.late) == ("12346", "Nguyen, Bao", True)
    assert [finding.what for finding in eve.findings] == ["This person is not on the class list."]


@pytest.mark.parametrize(("identity", "name"), [("S2", "x"), ("b@x.edu", "x"), ("88", "bao  nguyen")])
def test_people_are_known_by_any_id_or_by_their_name(tmp_path: Path, identity: str, name: str) -> None:
    (tmp_path / "list.csv").write_text(PARTICIPANTS, encoding="utf-8")
    found = merged(Uploads((upload(identity, name),)), read_class_list(tmp_path / "list.csv"))
    assert [(one.person.id, bool(one.parts)) for one in found.each] == [("j@x.edu", False), ("S2", True)]


def test_two_of_a_name_are_not_mixed_up(tmp_path: Path) -> None:
    (tmp_path / "list.csv").write_text("id,name\n1,Jane\n2,Jane\n", encoding="utf-8")
    found = merged(Uploads((upload("jane", "Jane"),)), read_class_list(tmp_path / "list.csv"))
    assert [bool(one.parts) for one in found.each] == [False, False, True]


def test_one_submission_counts_for_a_group(tmp_path: Path) -> None:
    (tmp_path / "work").mkdir()
    text = "id,name,path,group,submitted\n1,A,work,red,2026-10-05 10:00\n2,B,work,red,2026-10-05 12:00\n"
    (tmp_path / "roster.csv").write_text(text + "3,C,,red,\n4,D,work,,\n", encoding="utf-8")
    first, second, third, fourth = in_groups(find_sources(tmp_path / "roster.csv", tmp_path / "opened")).each
    assert [one.person.graded_as for one in (first, second, third, fourth)] == ["2", "", "2", ""]
    assert [bool(one.parts) for one in (first, second, third, fourth)] == [False, True, False, True]
    assert third.findings == (Remark("The submission of B counts for the group red."),)
    assert third.person.handed_in == datetime(2026, 10, 5, 12)


def test_without_times_the_first_of_a_group_counts(tmp_path: Path) -> None:
    group = [Upload(Person(each, each, group="g"), each, upload(each).parts) for each in ("a", "b")]
    assert [one.person.graded_as for one in in_groups(Uploads(tuple(group))).each] == ["", "a"]
    nobody = [Upload(Person(each, each, group="g"), "", ()) for each in ("a", "b")]
    assert [one.person.graded_as for one in in_groups(Uploads(tuple(nobody))).each] == ["", ""]
