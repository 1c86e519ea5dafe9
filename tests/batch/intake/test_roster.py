"""Rosters as spreadsheets write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.batch.intake import find_sources
from course.batch.intake.uploads import read_roster
from course.errors import UsageError
from tests.batch.intake.trees import lay


def roster(tmp_path: Path, text: str | bytes) -> Path:
    file = tmp_path / "roster.csv"
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    return file


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize(
    "text",
    [
        'id,name,path\r\n1,"Doe, Zoë",work\r\n',
        'id, name, path\n1, "Doe, Zoë", work\n',
        'Path;ID;Name;Mark\nwork;1;"Doe, Zoë";\n;;;\n',
        "id\tpath\tname\n1\twork\tDoe, Zoë\n",
        " id | name | path \n 1 | Doe, Zoë | work \n",
    ],
)
def test_forms(tmp_path: Path, encoding: str, text: str) -> None:
    lay(tmp_path, "work/x")
    (source,), findings = read_roster(roster(tmp_path, text.encode(encoding)))
    assert (source.person.id, source.person.name) == ("1", "Doe, Zoë")
    assert (source.parts[0].path, source.shown) == (tmp_path / "work", "work")
    assert findings == ()


def test_names_may_be_missing_and_paths_absolute(tmp_path: Path) -> None:
    lay(tmp_path, "work/x")
    ((source,), _) = read_roster(roster(tmp_path, f"id,path\njane,{tmp_path / 'work'}\n"))
    assert (source.person.name, source.findings) == ("jane", ())


def test_what_is_missing_is_told_of_that_person(tmp_path: Path) -> None:
    lay(tmp_path, "work/x")
    text = "id,name,path\n1,A,nowhere\n2,B,\n,C,work\n4,D,work\n5\n"
    found = find_sources(roster(tmp_path, text), tmp_path / "opened")
    assert [(s.person.id, len(s.parts), len(s.findings)) for s in found.each] == [
        ("5", 0, 1),
        ("1", 0, 1),
        ("2", 0, 1),
        ("4", 1, 0),
    ]
    assert [finding.where for finding in found.findings] == ["line 4"]


def test_several_lines_of_one_person(tmp_path: Path) -> None:
    lay(tmp_path, "a/x", "b/x")
    (source,), _ = read_roster(roster(tmp_path, "id,name,path\n1,Jane,a\n1,jane,b\n"))
    assert [part.name for part in source.parts] == ["a", "b"]
    assert source.findings == ()


def test_one_id_for_two_people(tmp_path: Path) -> None:
    lay(tmp_path, "a/x", "b/x")
    (source,), _ = read_roster(roster(tmp_path, "id,name,path\n1,Jane,a\n1,Bob,b\n"))
    assert "to Jane and to Bob" in source.findings[0].what


@pytest.mark.parametrize(
    "text", ["", "name,file\na,b\n", b"\xff\xfe\x00", "id,path\n" + "x" * 200_000 + ",y\n"]
)
def test_what_is_no_roster(tmp_path: Path, text: str | bytes) -> None:
    with pytest.raises(UsageError, match="is not a roster"):
        read_roster(roster(tmp_path, text))


def test_a_path_that_no_system_takes(tmp_path: Path) -> None:
    (source,), _ = read_roster(roster(tmp_path, f"id,name,path\n1,Jane,{'x' * 300}\n"))
    assert source.parts == ()
    assert "nothing at the path" in source.findings[0].what


def test_a_path_that_was_written_on_windows(tmp_path: Path) -> None:
    lay(tmp_path, "handed in/jane/x")
    ((source,), _) = read_roster(roster(tmp_path, "id,path\njane,handed in\\jane\n"))
    assert (len(source.parts), source.findings) == (1, ())
