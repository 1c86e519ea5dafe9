"""All reports of a class: which file is where, for many, without keeping them all in memory."""

from __future__ import annotations

import csv
import json
import tracemalloc
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from hashlib import blake2b
from pathlib import Path

import pytest

from course.model import replace
from course.model.gradebook import GradedSubmission, Person
from course.report.gradebook.class_files import write_reports
from tests.report.gradebook import hostile, samples


class Store:
    """A class that is generated while it is read."""

    def __init__(self, size: int) -> None:
        self.size = size

    def __iter__(self) -> Iterator[GradedSubmission]:
        yield from (replace(samples.CARL, person=Person(f"p{number}")) for number in range(self.size))


def test_everything_is_there(tmp_path: Path) -> None:
    write_reports(tmp_path, samples.CLASS, samples.CLEANER)
    found = sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file())
    names = ("ada", "bao", "carl", "dilara", "emre")
    assert found == [
        *(f"feedback/{name}.md" for name in names),
        *(f"gradescope/{name}.json" for name in names),
        *("junit.xml", "letters.json", "results.csv", "results.json"),
    ]
    assert (tmp_path / "results.csv").read_bytes().startswith(b"\xef\xbb\xbfid,name")
    assert "Ada Okafor" in (tmp_path / "feedback/ada.md").read_text(encoding="utf-8")


def test_people_of_one_name_do_not_overwrite_each_other(tmp_path: Path) -> None:
    book = samples.gradebook(samples.ADA, replace(samples.BAO, person=Person("\x1b[0mada")))
    write_reports(tmp_path, book, samples.CLEANER)
    assert len(list((tmp_path / "feedback").iterdir())) == 2


@pytest.mark.slow
def test_a_hostile_class_is_written_and_read(tmp_path: Path) -> None:
    write_reports(tmp_path, samples.gradebook(*map(hostile.graded, hostile.TEXTS)), hostile.CLEANER)
    everyone = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))["graded"]
    assert len(everyone) == len(hostile.TEXTS) == len(ET.parse(tmp_path / "junit.xml").getroot())
    with (tmp_path / "results.csv").open(encoding="utf-8-sig", newline="") as table:
        assert len(list(csv.DictReader(table))) == len(hostile.TEXTS)
    assert len(list((tmp_path / "feedback").iterdir())) == len(hostile.TEXTS)
    for path in tmp_path.rglob("*"):
        assert path.resolve().is_relative_to(tmp_path)
        if path.is_file():
            text = path.read_text(encoding="utf-8")
            assert hostile.SECRET not in text and "/srv/grading/" not in text.replace(
                f"{hostile.MACHINE}s", ""
            )


@pytest.mark.slow
def test_memory_is_flat(tmp_path: Path) -> None:
    def peak(size: int) -> int:
        tracemalloc.start()
        write_reports(tmp_path / str(size), replace(samples.CLASS, graded=Store(size)), samples.CLEANER)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    peak(10)  # what is loaded once
    assert peak(300) < peak(30) + 500_000


def test_letters_of_people_who_are_gone_go_too(tmp_path: Path) -> None:
    write_reports(tmp_path, samples.gradebook(samples.ADA, samples.BAO), samples.CLEANER)
    write_reports(tmp_path, samples.gradebook(samples.ADA), samples.CLEANER)
    assert [file.name for file in sorted(tmp_path.glob("*/*"))] == ["ada.md", "ada.json"]


def test_what_somebody_else_wrote_stays(tmp_path: Path) -> None:
    write_reports(tmp_path, samples.gradebook(samples.ADA, samples.BAO), samples.CLEANER)
    (tmp_path / "feedback/talk.md").write_text("Notes of my own.")
    (tmp_path / "feedback/bao.md").write_text("I have added a line.")
    write_reports(tmp_path, samples.gradebook(samples.ADA), samples.CLEANER)
    assert sorted(file.name for file in tmp_path.glob("feedback/*")) == ["ada.md", "bao.md", "talk.md"]
    assert not (tmp_path / "gradescope/bao.json").exists()


@pytest.mark.parametrize("name", ["../x/y.md", "feedback/../../x/y.md", "gradescope/../x/y.md"])
def test_a_list_that_is_not_ours_deletes_nothing(tmp_path: Path, name: str) -> None:
    for place in ("x", "out/x"):
        (tmp_path / place).mkdir(parents=True)
        (tmp_path / place / "y.md").write_text("Mine.")
    for text in ("[", "[1]", json.dumps({name: blake2b(b"Mine.", digest_size=16).hexdigest()})):
        (tmp_path / "out/letters.json").write_text(text)
        write_reports(tmp_path / "out", samples.gradebook(samples.ADA), samples.CLEANER)
    assert (tmp_path / "x/y.md").exists() and (tmp_path / "out/x/y.md").exists()
