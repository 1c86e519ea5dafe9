"""The LMS's own sheet, filled in: the right cells, and no other byte."""

from __future__ import annotations

import pytest

from course.errors import UsageError
from course.report.gradebook.lms_sheet import Filled, Score, fill

SCORES = {"1": Score(4.5, "complete"), "2": Score(0, "not handed in"), "3": Score(None, "excused")}
CANVAS = (
    "\ufeffStudent,ID,SIS User ID,Section,Lights (77),Motors (78),Final Score\r\n"
    "    Points Possible,,,,6.00,10,(read only)\r\n"
    '"Doe, ""JD"" Jane",1,007,"A\r\nB",,7,"87,5"\r\n'
    "Ngu\u1ec5n,2,,A,3.0,,12\r\n"
    "Zo\u00eb,3,,A,,,\r\n"
    "Eve,99,,A,1,,\r\n"
)
MOODLE = (
    "Identifier,Full name,Status,Grade,Maximum Grade,Grade can be changed,Feedback comments\n"
    'Participant 1,Jane,"Submitted",,6.00,Yes,"<p>a, ""b""</p>"\n'
    'Participant 2,Bao,-,"1.00",6.00,No,\n'
    "Participant 3,Zo\u00eb,-,,6.00,Yes,"
)
BLACKBOARD = (
    '"Last Name"\t"First Name"\t"Username"\t"Lights [EXTRA] [Total Pts: 6 Score] |123"\t'
    '"Total [Total Pts: up to 1,499 Score] |124"\t"Group [Total Pts: 0 Text] |125"\n'
    '"Doe"\t"Jane"\t"1"\t""\t"50,0"\t""\n"Nguyen"\t"Bao"\t"2"\t"5"\t""\t"A"\n'
)


def filled(text: str, column: str = "", scale: bool | None = None, encoding: str = "utf-8") -> Filled:
    return fill(
        text.encode(encoding), SCORES, 6, lambda cell: cell.removeprefix("Participant "), column, scale
    )


def test_canvas() -> None:
    found = filled(CANVAS, "Lights")
    expected = (
        CANVAS.replace('B",,7', 'B",4.5,7')
        .replace("A,3.0,,12", "A,0,,12")
        .replace("Zo\u00eb,3,,A,,", "Zo\u00eb,3,,A,EX,")
    )
    assert found.content.decode() == expected
    assert (found.lms, found.column, found.filled, found.changed) == ("Canvas", "Lights (77)", 3, 1)
    assert (found.left, found.absent) == ((("99", "not in the class"),), ())


def test_moodle() -> None:
    found = filled(MOODLE)
    assert found.content.decode() == MOODLE.replace('"Submitted",,', '"Submitted",4.5,')
    assert found.left == (("2", "the sheet says that the grade cannot be changed"), ("3", "excused"))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16-le", "utf-16-be"])
def test_blackboard(encoding: str) -> None:
    mark = "" if encoding == "utf-8" else "\ufeff"
    found = filled(mark + BLACKBOARD, encoding=encoding)
    expected = BLACKBOARD.replace('"1"\t""', '"1"\t"4.5"').replace('"2"\t"5"', '"2"\t"0"')
    assert found.content == (mark + expected).encode(encoding)
    assert (found.lms, found.absent) == ("Blackboard", ("3",))


def test_bytes_that_are_no_text_stay() -> None:
    odd = MOODLE.encode().replace(b"Jane", b"J\xe4ne\x00")
    found = fill(odd, SCORES, 6, lambda cell: cell.removeprefix("Participant "))
    assert found.content == odd.replace(b'"Submitted",,', b'"Submitted",4.5,')


def test_a_class_with_the_ids_of_another_column() -> None:
    text = MOODLE.replace("Full name", "Email address").replace("Jane", "j@x.org").replace("Bao", "1")
    found = fill(text.encode(), {"j@x.org": Score(4.5, "complete")}, 6, lambda cell: cell)
    assert found.content.decode() == text.replace('"Submitted",,', '"Submitted",4.5,')
    assert found.absent == ()
    found = filled(text)  # a person who is known by the LMS's own id is not looked up in another column
    assert found.content.decode() == text.replace('"Submitted",,', '"Submitted",4.5,')


def test_nobody_of_the_class_changes_nothing() -> None:
    for text, column in ((CANVAS, "77"), (MOODLE, ""), (BLACKBOARD, "")):
        assert fill(text.encode(), {}, 6, lambda cell: cell, column).content == text.encode()


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
def test_every_line_end_stays(ending: str) -> None:
    text = f"Student,ID,Lights (77){ending}Jane,1,{ending}Bao,2,"
    assert filled(text).content.decode() == f"Student,ID,Lights (77){ending}Jane,1,4.5{ending}Bao,2,0"


def test_points_are_converted_only_when_somebody_says_so() -> None:
    with pytest.raises(UsageError, match="out of 10 points, and this class is out of 6"):
        filled(CANVAS, "Motors")
    assert b'B",,7.5,' in filled(CANVAS, "Motors", scale=True).content
    assert b'B",,4.5,' in filled(CANVAS, "Motors", scale=False).content


@pytest.mark.parametrize("most", ["1,000", "1,000.00", "1000,00"])
def test_thousands_may_be_grouped(most: str) -> None:
    sheet = f'Student,ID,Lights (77)\nPoints Possible,,"{most}"\nJane,1,\n'
    with pytest.raises(UsageError, match=r"out of 1,?000 points"):
        filled(sheet)


def test_a_decimal_comma_stays_a_comma() -> None:
    text = "Identifier;Grade;Maximum Grade\nParticipant 1;;6,00\n"
    assert filled(
        text
    ).content.decode() == "Identifier;Grade;Maximum Grade\nParticipant 1;4,5;6,00\n".replace("4,5", '"4,5"')


@pytest.mark.parametrize(
    ("text", "column", "said"),
    [
        (CANVAS, "", "Several columns"),
        (CANVAS, "Final Score", "No column"),
        (CANVAS.replace("Motors (78)", "Lights (79)"), "Lights", "Several columns"),
        ("Student,ID\nJane,1\n", "", "No column"),
        ("a,b\n1,2\n", "", "not a sheet of Canvas, Moodle, or Blackboard"),
        ("", "", "not a sheet"),
        (CANVAS.replace("A,3.0", '"A,3.0'), "Lights", "a quoted cell is not closed"),
    ],
)
def test_what_cannot_be_filled(text: str, column: str, said: str) -> None:
    with pytest.raises(UsageError, match=said):
        filled(text, column)


def test_half_a_character_of_utf_16() -> None:
    with pytest.raises(UsageError, match="damaged"):
        fill(b"\xff\xfea", SCORES, 6, str)
