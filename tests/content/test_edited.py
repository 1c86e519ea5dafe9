"""The edits of a mistake, one after the other."""

from __future__ import annotations

from pathlib import Path

from course.content import Edit
from course.content.edited import Edited


def test_each_edit_builds_on_those_before(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("one two")
    edited = Edited(tmp_path)
    edited.apply(Edit("a.py", replace="two", with_="three"))
    assert edited.text("a.py") == "one three"
    edited.apply(Edit("a.py", rename="b.py"))
    assert (edited.text("a.py"), edited.text("b.py")) == (None, "one three")
    edited.apply(Edit("b.py", delete=True))
    edited.apply(Edit("b.py", replace="one", with_="x"))
    assert edited.text("b.py") is None
    edited.apply(Edit("b.py", content="new"))
    edited.apply(Edit("b.py", mode="755"))
    assert edited.text("b.py") == "new"
    assert (tmp_path / "a.py").read_text() == "one two"


def test_a_file_that_every_chapter_adds_to(tmp_path: Path) -> None:
    for name, line in (("03-ros", "source ros\n"), ("05-more", "source mine\n")):
        (tmp_path / name).mkdir()
        (tmp_path / name / ".bashrc").write_text(line)
    assert "source ros" in (Edited(tmp_path / "05-more").text(".bashrc") or "")


def test_files_of_earlier_chapters_only(tmp_path: Path) -> None:
    for name in ("03-ros", "05-more", "07-last"):
        (tmp_path / name).mkdir()
    (tmp_path / "03-ros/a.msg").write_text("a")
    (tmp_path / "07-last/b.msg").write_text("b")
    edited = Edited(tmp_path / "05-more")
    assert (edited.text("a.msg"), edited.text("b.msg")) == ("a", None)


def test_what_is_no_file(tmp_path: Path) -> None:
    assert Edited(tmp_path).text(".") is None
    assert Edited(tmp_path).text(".bashrc") is None
