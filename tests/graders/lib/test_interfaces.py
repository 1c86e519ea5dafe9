"""How .msg and .srv files differ from what was asked."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.model.events import GraphSeen
from course.model.feedback import Feedback
from course.model.graph import Endpoint, Graph, Qos, Service
from lib.interfaces import (
    Section,
    compare,
    expect_same_definition,
    expect_same_service,
    expect_tag,
    interface_file,
)
from tests.golden import golden
from tests.grading.expect.conftest import record, said, told, with_manifest

PACKAGE = "words"
MESSAGE: Section = (("int32", "id"), ("string", "text"), ("string", "author"))
REQUEST: Section = ((f"{PACKAGE}/Quote", "quote"),)
RESPONSE: Section = (("geometry_msgs/Point", "point"),)
MSG, SRV = f"src/{PACKAGE}/msg/Quote.msg", f"src/{PACKAGE}/srv/Point.srv"


def message(text: str) -> Feedback:
    file = interface_file(Sources({MSG: text}), PACKAGE, "msg", "Quote")
    return compare(file, (MESSAGE,), PACKAGE, "Quote")


def service(text: str) -> Feedback:
    file = interface_file(Sources({SRV: text}), PACKAGE, "srv", "Point")
    return compare(file, (REQUEST, RESPONSE), PACKAGE, "Point")


def where(feedback: Feedback) -> list[str]:
    return [str(place) for place in feedback.where]


@pytest.mark.parametrize(
    ("text", "fields"),
    [
        ("int32 id\nstring text", [("int32", "id", 1), ("string", "text", 2)]),
        ("\n# comment\n  int32   id  # number\n", [("int32", "id", 3)]),
        ("int32 MOST=5\nint32 LEAST = 1\nint32 id", [("int32", "id", 3)]),
        ("int32 id 5\nstring text \"a = b\"", [("int32", "id", 1), ("string", "text", 2)]),
        ("string<=10 text\nint32[] a\nint32[3] b\nint32[<=3] c\nstring<=5[<=2] d", [
            ("string<=10", "text", 1), ("int32[]", "a", 2), ("int32[3]", "b", 3), ("int32[<=3]", "c", 4),
            ("string<=5[<=2]", "d", 5)]),
        ("geometry_msgs/Point p\ngeometry_msgs/msg/Point[] q", [
            ("geometry_msgs/Point", "p", 1), ("geometry_msgs/msg/Point[]", "q", 2)]),
        ("", []),
    ],
)  # fmt: skip
def test_fields(text: str, fields: list[tuple[str, str, int]]) -> None:
    file = interface_file(Sources({MSG: text}), PACKAGE, "msg", "Quote")
    assert [(field.type, field.name, field.line) for field in file.sections[0]] == fields


def test_sections_of_a_service() -> None:
    file = interface_file(Sources({SRV: "int32 a\n ---  # then\nint32 b"}), PACKAGE, "srv", "Point")
    assert [[field.name for field in section] for section in file.sections] == [["a"], ["b"]]


def test_a_file_that_is_not_there() -> None:
    assert interface_file(Sources({MSG: ""}), PACKAGE, "msg", "Other") is None
    golden(compare(None, (MESSAGE,), PACKAGE, "Quote"))


@pytest.mark.parametrize(
    "text",
    [
        "int32 id\nstring tekst\nstring author",
        "int32 id\nstring other\nstring author",
        "int32 id\nbool x\nstring authors\nstring text",
        "int32 id\nstring text",
        "int32 id",
        "",
        "int32 id\nstring text\nstring author\nbool more",
        "int64 id\nstring text\nstring author",
        "int32 id\nstring<=9 text\nstring author",
        "int32 id\nstring text\nstring[] author",
        "string text\nint32 id\nstring author",
    ],
)
def test_the_first_difference_of_a_message(text: str) -> None:
    golden(message(text))


def test_what_was_seen_is_written_as_what_was_expected() -> None:
    golden(service("words/msg/Quote quotes\n---\ngeometry_msgs/Point point"))
    golden(message(""))


@pytest.mark.parametrize(
    "text",
    [
        "Quote quotation\n---\ngeometry_msgs/Point point",
        "words/msg/Quote quote\n---\ngeometry_msgs/Pose point",
        "Quote quote\n---\n",
        "geometry_msgs/Point point\n---\nQuote quote",
        "Quote quote\n---\ngeometry_msgs/Point point",
        "words/Quote quote\n---\ngeometry_msgs/msg/Point point",
        "Quote quote",
    ],
)
def test_the_first_difference_of_a_service(text: str) -> None:
    golden(service(text))


def test_an_element_that_is_there() -> None:
    recording = with_manifest("<build_depend>gen</build_depend>")
    assert said(expect_tag, recording, "talk", ("depend", "build_depend"), "gen", purpose="x") is None


def test_an_element_that_is_not_there() -> None:
    golden(
        told(expect_tag, with_manifest(), "talk", ("member_of_group", "other"), "group", purpose="it tells")
    )


def test_an_element_under_another_tag() -> None:
    recording = with_manifest("<depend>group_more</depend>", "<group_depend>group</group_depend>")
    golden(told(expect_tag, recording, "talk", ("member_of_group",), "group", purpose="x"))


def test_another_definition_of_a_message() -> None:
    ends = (Endpoint("/quotes", "publisher", "/talker", "words/msg/Quote", "RIHS01_1", Qos()),)
    seen, arguments = (
        record(GraphSeen(1.0, Graph(endpoints=ends))),
        ("publisher", "/quotes", "words/msg/Quote"),
    )
    golden(told(expect_same_definition, seen, *arguments, "RIHS01_2", advice="Look at chapter 3."))
    assert said(expect_same_definition, seen, *arguments, "RIHS01_1", advice="x") is None


def test_another_definition_of_a_service() -> None:
    name, kind, hashes = "/what_is_the_point", "words/srv/Point", ("RIHS01_1", "RIHS01_2")
    seen = record(GraphSeen(1.0, Graph(services=(Service(name, kind, *hashes, servers=("/talker",)),))))
    other = ("RIHS01_1", "RIHS01_3")
    golden(told(expect_same_service, seen, name, kind, other, advice="Look at chapter 3."))
    assert said(expect_same_service, seen, name, kind, hashes, advice="") is None
    not_yet = record(GraphSeen(1.0, Graph(services=(Service(name, kind, servers=("/talker",)),))))
    assert said(expect_same_service, not_yet, name, kind, hashes, advice="") is None
