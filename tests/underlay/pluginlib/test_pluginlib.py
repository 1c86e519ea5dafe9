"""Plugins in shared libraries, and the files that describe them: see probes/."""

from __future__ import annotations

import re

import pytest

from tests.underlay.pluginlib.conftest import PROBES
from tests.underlay.rclcpp.room import Ended, Room

pytestmark = pytest.mark.slow

CASES = re.findall(r'^    \{"(\w+)", ', (PROBES / "src/cases.cpp").read_text(), re.MULTILINE)


@pytest.mark.parametrize("case", CASES)
def test_case(case: str, room: Room) -> None:
    ended = room.run("cases", case)
    assert ended.code == 0, ended.text


def test_a_program_may_be_linked_with_its_plugins(room: Room) -> None:
    assert room.run("linked") == Ended(0, "lantern\n")


def listed(room: Room, text: str, package: str = "<package><name>shop</name></package>") -> Ended:
    (room.folder / "package.xml").write_text(package)
    (room.folder / "plugins.xml").write_text(text)
    return room.run("listed", "plugins.xml")


def lamp(name: str, rest: str = "/") -> str:
    return f'<class name="{name}" type="Lamp" base_class_type="probes::Lamp"{rest}>'


SILENT = "There is no <description> of this class."


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f'<library path="a">{lamp("one")}</library>', f"one, Lamp, shop: {SILENT}\n"),
        (
            "\ufeff<?xml version='1.0'?>\n<!DOCTYPE class_libraries>\n<!-- <library> -->\n"
            f'<class_libraries><ignored/><library path = "a" >{lamp("one")}<!-- x --></library >\n'
            f"<library path='b'><ignored/>{lamp('two')}</library></class_libraries>\n<!-- end -->\n",
            f"one, Lamp, shop: {SILENT}\ntwo, Lamp, shop: {SILENT}\n",
        ),
        # XML does not allow a second element at the top, but such files are common.
        (
            f'<library path="a">{lamp("one")}</library><library path="b">{lamp("two")}</library>',
            f"one, Lamp, shop: {SILENT}\ntwo, Lamp, shop: {SILENT}\n",
        ),
        (
            '<library path="a">'
            + lamp("a &lt; &quot;b&quot;", "")
            + "<description>1 &amp; 2 <![CDATA[<&>]]> &#65;&#x42;&#228;&#x20AC;&#x1F600;</description>"
            + "</class></library>",
            'a < "b", Lamp, shop: 1 & 2 <&> AB\u00e4\u20ac\U0001f600\n',
        ),
    ],
)
def test_what_a_file_describes(text: str, said: str, room: Room) -> None:
    assert listed(room, text) == Ended(0, said)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "plugins.xml:1: there is no element in this file"),
        ("\n<library path='a'>\n</class>\n", "plugins.xml:3: <library> is not closed by </library>"),
        ("<library path='a'>\n<class>\n", "plugins.xml:3: <class> is not closed by </class>"),
        ("<library path=a/>", "plugins.xml:1: the value of the attribute path must be in quotes"),
        ("<library path/>", "plugins.xml:1: expected = after the attribute path"),
        ("<library path='a/>", "plugins.xml:1: the value of the attribute path has no end"),
        ("<library path='a' path='b'/>", "plugins.xml:1: <library> has the attribute path twice"),
        ("<library path='a'", "plugins.xml:1: expected a name"),
        ("<library path='a'></library", "plugins.xml:1: </library must end with >"),
        ("<library path='a & b'/>", "plugins.xml:1: write &amp; for the character & in a text"),
        ("<library path='a&nbsp;b'/>", "plugins.xml:1: write &amp; for the character & in a text"),
        ("<!-- <library path='a'/>", "plugins.xml:1: <!-- is not closed by -->"),
        ("library", "plugins.xml:1: expected an element, which begins with <"),
        ("<plugins/>", "the first element must be <library> or <class_libraries>, not <plugins>"),
    ],
)
def test_a_file_that_cannot_be_read_is_skipped(text: str, said: str, room: Room) -> None:
    ended = listed(room, text)
    assert ended.code == 0
    assert re.fullmatch(
        r"\[ERROR\] \[[\d.]+\] \[pluginlib\.ClassLoader\]: Skipped a file: (.*)\n", ended.text
    )
    assert ended.text.endswith(f"{said}\n")


def test_a_library_without_a_path_is_skipped(room: Room) -> None:
    text = f'<class_libraries><library>{lamp("one")}</library><library path="b">{lamp("two")}</library>'
    ended = listed(room, f"{text}</class_libraries>")
    assert "skipped a <library> without the attribute 'path'" in ended.text
    assert ended.text.endswith(f"\ntwo, Lamp, shop: {SILENT}\n")


@pytest.mark.parametrize("lacks", ["type", "base_class_type"])
def test_a_class_must_have_both_types(lacks: str, room: Room) -> None:
    described = lamp("one").replace(f" {lacks}=", " other=")
    ended = listed(room, f'<library path="a">{described}</library>')
    assert ended == Ended(1, f"ClassLoaderException: plugins.xml: a <class> lacks the attribute '{lacks}'\n")


def test_the_package_must_have_a_name(room: Room) -> None:
    ended = listed(room, f'<library path="a">{lamp("one")}</library>', "<package/>")
    assert "there is no package.xml with a <name> in this folder or above" in ended.text
    assert ended.text.endswith(f"\none, Lamp, : {SILENT}\n")
