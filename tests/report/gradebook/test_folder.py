"""All reports of a class: what lies where, for many, without holding them all."""

from __future__ import annotations

import csv
import json
import tracemalloc
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from course.report.gradebook.folder import write_reports
from course.report.gradebook.model import Graded, Person
from tests.report.gradebook import hostile, samples


class Store:
    """A class that is made while it is read."""

    def __init__(self, size: int) -> None:
        self.size = size

    def __iter__(self) -> Iterator[Graded]:
        yield from (replace(samples.CARL, person=Person(f"p{number}")) for number in range(self.size))


def test_everything_is_there(tmp_path: Path) -> None:
    write_reports(tmp_path, samples.CLASS, samples.CLEANER)
    found = sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file())
    names = ("ada", "bao", "carl", "dilara", "emre")
    assert found == [
        *(f"feedback/{name}.md" for name in names),
        *(f"gradescope/{name}.json" for name in names),
        *("junit.xml", "results.csv", "results.json"),
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
