"""Classes with copies in them."""

from __future__ import annotations

import os
import shutil
import zipfile
from pathlib import Path

import pytest

from course.errors import UsageError
from course_similar import Solutions, Wanted, tokens
from tests.extras.similar.classes import GARDEN, RENAMED, SHOP, hand_in, write
from tests.extras.similar.conftest import Compare

STARTER = "chapters/04-lanterns/starter/04-light/shop.py"
SOLUTION = "solutions/04-lanterns/shop.py"


@pytest.fixture
def handed_in(tmp_path: Path) -> Path:
    folder = tmp_path / "handed-in"
    hand_in(folder, "ann", SHOP)
    hand_in(folder, "bob", GARDEN)
    return folder


def names(compared: Compare, folder: Path, **options: object) -> list[set[str]]:
    return [{pair.one.name, pair.other.name} for pair in compared(folder, **options).pairs]


def test_a_copy_with_other_names_is_found(compared: Compare, handed_in: Path) -> None:
    hand_in(handed_in, "eve", RENAMED, "mine.py")
    found = compared(handed_in)
    (pair,) = found.pairs
    assert (pair.one.name, pair.other.name, found.compared) == ("ann", "eve", 3)
    assert pair.one.share == pair.other.share == 1
    assert pair.one.lines == pair.other.lines == 21
    match = pair.matches[0]
    assert match.one.lines == tuple(SHOP.split("\n")[2:28]) and match.one.first == 3
    assert match.other.file.endswith("mine.py")
    assert match.other.lines[-1] == RENAMED.split("\n")[match.other.last - 1]


def test_different_programs_are_not_alike(compared: Compare, handed_in: Path) -> None:
    found = compared(handed_in, Wanted(share=0.01, lines=1))
    assert (found.pairs, found.more, found.compared) == ((), 0, 2)


def test_a_part_is_a_share_of_each_side(compared: Compare, handed_in: Path) -> None:
    hand_in(handed_in, "eve", f"{GARDEN}\n{SHOP}")
    found = compared(handed_in)
    shares = {pair.one.name: (pair.one.share, round(pair.other.share, 1)) for pair in found.pairs}
    assert shares == {"ann": (1, 0.5), "bob": (1, 0.5)}


def test_only_what_was_wanted_is_shown(compared: Compare, handed_in: Path) -> None:
    hand_in(handed_in, "eve", SHOP)
    hand_in(handed_in, "fay", SHOP)
    found = compared(handed_in, Wanted(pairs=2))
    assert (len(found.pairs), found.more) == (2, 1)
    assert compared(handed_in, Wanted(lines=22)).pairs == ()
    assert len(compared(handed_in, Wanted(lines=21)).pairs) == 3
    (pair, *_) = compared(handed_in, Wanted(matches=0)).pairs
    assert (pair.matches, pair.more) == ((), 1)


def test_the_most_alike_come_first(compared: Compare, handed_in: Path) -> None:
    write(handed_in / "abe" / "part.py", "\n".join(SHOP.split("\n")[:16]) + GARDEN[:300].replace("for", "if"))
    write(handed_in / "zoe" / "copy.py", GARDEN)
    found = compared(handed_in, Wanted(share=0.3))
    shares = [max(pair.one.share, pair.other.share) for pair in found.pairs]
    assert shares == sorted(shares, reverse=True) and len(set(shares)) > 1
    assert {found.pairs[0].one.name, found.pairs[0].other.name} == {"bob", "zoe"}


@pytest.mark.parametrize("where", ["starter", "lesson"])
def test_what_the_course_gives_counts_for_nobody(
    compared: Compare, handed_in: Path, small_course: Path, where: str
) -> None:
    hand_in(handed_in, "eve", SHOP)
    if where == "starter":
        write(small_course / STARTER, SHOP)
    else:
        lesson = small_course / "chapters/04-lanterns/04-light.md"
        write(lesson, f"{lesson.read_text(encoding='utf-8')}\n```python\n{RENAMED}```\n")
    found = compared(handed_in, Wanted(share=0.01, lines=1))
    assert found.pairs == ()
    assert found.without == ("ann", "eve")


def test_solutions_are_compared_or_given_on_request(
    compared: Compare, handed_in: Path, small_course: Path
) -> None:
    write(small_course / SOLUTION, RENAMED)
    hand_in(handed_in, "eve", SHOP)
    assert names(compared, handed_in) == [{"ann", "eve"}]
    assert names(compared, handed_in, solutions=Solutions.GIVEN) == []
    ours = "solution 04-lanterns"
    found = names(compared, handed_in, solutions=Solutions.COMPARED)
    assert found == [{"ann", "eve"}, {"ann", ours}, {"eve", ours}]


def test_our_solutions_are_not_compared_with_each_other(
    compared: Compare, handed_in: Path, small_course: Path
) -> None:
    write(small_course / SOLUTION, RENAMED)
    write(small_course / "solutions/04-lanterns/alternatives/shifts-bits/shop.py", RENAMED)
    found = names(compared, handed_in, solutions=Solutions.COMPARED)
    assert found == [
        {"ann", "solution 04-lanterns"},
        {"ann", "solution 04-lanterns (shifts-bits)"},
    ]


def test_files_that_are_the_same_everywhere_do_not_count(compared: Compare, handed_in: Path) -> None:
    for name, way in (("ann", "A = 1\n"), ("bob", "A = 2\n")):
        hand_in(handed_in, name, "", "__init__.py")
        hand_in(handed_in, name, way, "small.py")
        for folder in ("build", "install", "answers", "src/shop/resource", ".hidden"):
            write(handed_in / name / folder / "made.py", SHOP if name == "ann" else RENAMED)
    found = compared(handed_in, Wanted(share=0.01, lines=1))
    assert found.pairs == ()


def test_archives_are_opened(compared: Compare, handed_in: Path) -> None:
    with zipfile.ZipFile(handed_in / "eve.zip", "w") as archive:
        archive.writestr("work/src/shop/package.xml", "<package><name>shop</name></package>")
        archive.writestr("work/src/shop/shop/shop.py", RENAMED)
    assert names(compared, handed_in) == [{"ann", "eve"}]


def test_programs_in_no_package_are_compared_too(compared: Compare, handed_in: Path) -> None:
    write(handed_in / "eve" / "anywhere" / "shop.py", SHOP)
    assert names(compared, handed_in) == [{"ann", "eve"}]


def test_two_of_one_name_are_told_apart(compared: Compare, tmp_path: Path) -> None:
    for number in (1, 2):
        hand_in(tmp_path / "moodle", f"Jane Doe_{number}000001_assignsubmission_file_", SHOP)
    assert names(compared, tmp_path / "moodle") == [{"Jane Doe (1000001)", "Jane Doe (2000001)"}]


def test_one_alone_cannot_be_compared(compared: Compare, handed_in: Path) -> None:
    shutil.rmtree(handed_in / "bob")
    with pytest.raises(UsageError, match="no two"):
        compared(handed_in)


def test_it_comes_out_the_same_each_time(compared: Compare, handed_in: Path) -> None:
    hand_in(handed_in, "eve", RENAMED)
    hand_in(handed_in, "fay", SHOP)
    assert compared(handed_in) == compared(handed_in)


def test_hostile_files_keep_nobody_from_being_compared(compared: Compare, handed_in: Path) -> None:
    ran = handed_in.parent / "ran"
    shop = hand_in(handed_in, "eve", f"import pathlib\npathlib.Path({str(ran)!r}).touch()\n{RENAMED}").parent
    write(shop / "large.py", SHOP * 1000)
    write(shop / "binary.py", b"\x7fELF\0" + SHOP.encode())
    write(shop / "broken.py", "def (:\n" + SHOP.replace(")", "]"))
    write(shop / "latin.py", b"name = '\xe9\xff'\n" * 5)
    write(shop / "esc\x1b[2J\u202e.py", GARDEN)
    os.mkfifo(shop / "pipe.py")
    (shop / "endless.py").symlink_to("/dev/zero")
    (shop / "loop").symlink_to("..")
    found = compared(handed_in)
    assert [{pair.one.name, pair.other.name} for pair in found.pairs] == [{"ann", "eve"}, {"bob", "eve"}]
    assert not ran.exists()
    told = "\n".join(found.remarks)
    assert "eve: Files larger than 128 kB were not compared. (" in told and "large.py" in told
    assert "eve: Files that are not text were not compared. (" in told and "binary.py" in told
    shown = "".join(match.other.file for pair in found.pairs for match in pair.matches)
    assert shown.isprintable() and "esc_" in shown


def test_a_submission_made_to_be_slow_is_given_up(
    compared: Compare, handed_in: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tokens, "LONGEST", -1.0)
    found = compared(handed_in)
    assert found.without == ("ann", "bob")
    assert [text.split(":")[0] for text in found.remarks] == ["ann", "bob"]


@pytest.mark.parametrize(("limit", "most"), [("MOST_WORDS", 100), ("MOST_FILES", 2)])
def test_so_much_of_one_submission_at_most(
    compared: Compare, handed_in: Path, monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    for number in range(2):
        hand_in(handed_in, "ann", f"a = {number}\n", f"b{number}.py")
    assert compared(handed_in).remarks == ()
    monkeypatch.setattr(tokens, limit, most)
    (told,) = (text for text in compared(handed_in).remarks if text.startswith("ann: "))
    assert "so much code that only a part was compared" in told and told.endswith("shop.py)")
