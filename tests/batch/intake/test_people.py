"""Names as Moodle, Canvas and GitHub Classroom give them."""

from __future__ import annotations

import pytest

from course.batch.intake.people import assignment, labels, safe_id
from course.model.gradebook import Person


@pytest.mark.parametrize(
    ("name", "person", "file"),
    [
        ("Jane Doe_1234567_assignsubmission_file_", Person("1234567", "Jane Doe"), ""),
        ("Jane Doe_1234567_assignsubmission_file", Person("1234567", "Jane Doe"), ""),
        ("Jane Doe_1234567_assignsubmission_file_my_work.zip", Person("1234567", "Jane Doe"), "my_work.zip"),
        ("Jane_Ann Doe_99_assignsubmission_onlinetext_", Person("99", "Jane_Ann Doe"), ""),
        ("Zoë\x1b[2J O'Neil_7_assignsubmission_file_", Person("7", "Zoë\\x1b[2J O'Neil"), ""),
        ("doejane_12345_67890_file.zip", Person("12345", "doejane", False), "file.zip"),
        ("doejane_LATE_12345_67890_file-1.zip", Person("12345", "doejane", True), "file-1.zip"),
        ("doejane_12345_67890_my_node_2.py", Person("12345", "doejane", False), "my_node_2.py"),
        ("doejane_12345_text.html", Person("12345", "doejane", False), "text.html"),
        ("doejane_LATE_12345_link.html", Person("12345", "doejane", True), "link.html"),
        ("anon_k3Xp9_67890_LATE_work.zip", Person("k3Xp9", "k3Xp9", False), "LATE_work.zip"),
        ("LATE_anon_k3Xp9_67890_work.zip", Person("k3Xp9", "k3Xp9", True), "work.zip"),
        ("jane.tar.gz", Person("jane", "jane"), ""),
        ("jane doe", Person("jane_doe", "jane doe"), ""),
        ("lab_1_final.zip", Person("lab_1_final", "lab_1_final"), ""),
    ],
)
def test_whose_it_is(name: str, person: Person, file: str) -> None:
    label = labels([name])[name]
    assert (label.person, label.file) == (person, file)


def test_numbers_that_are_no_uploads_make_nobody_of_canvas() -> None:
    told = labels(["exam_2024_05_jane.zip", "exam_2024_05_bob.zip"])
    assert [label.person.id for label in told.values()] == ["exam_2024_05_jane", "exam_2024_05_bob"]


@pytest.mark.parametrize(
    ("names", "folder", "slug"),
    [
        (["lab1-jane-doe", "lab1-bob"], "anything", "lab1-"),
        (["lab1-jane-doe", "lab1-jane-roe"], "anything", "lab1-jane-"),
        (["lab1-jane-doe", "lab1-jane-roe"], "lab1-submissions", "lab1-"),
        (["my-lab-jane"], "my-lab-submissions", "my-lab-"),
        (["lab1-jane"], "anything", ""),
        (["jane", "bob"], "anything", ""),
        (["x-jane", "y-bob"], "x-submissions", ""),
        ([], "lab1-submissions", "lab1-"),
    ],
)
def test_the_assignment_of_clones(names: list[str], folder: str, slug: str) -> None:
    assert assignment(names, folder) == slug


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("jane.doe@school.edu", "jane.doe@school.edu"),
        ("Zoe\u0308", "Zo\u00eb"),
        ("../../etc", "etc"),
        ("=cmd|' /C calc'!A0", "cmd_C_calc_A0"),
        ("-rf", "rf"),
        ("a\nb\x1b[2J", "a_b_2J"),
    ],
)
def test_ids_are_fit_for_folders(text: str, safe: str) -> None:
    assert safe_id(text) == safe


def test_ids_that_are_cut_stay_different() -> None:
    ids = {safe_id(text) for text in ("", "..", "x" * 100, "x" * 101, "\u4e2d" * 40, "\udcff")}
    assert len(ids) == 6
    assert all(0 < len(each.encode()) <= 64 + 9 for each in ids)
