"""Which parts of a program count, and which don't."""

from __future__ import annotations

import pytest

from course_similar import tokens
from course_similar.tokens import TooSlow, code_of, language_of, words_of
from tests.extras.similar.classes import RENAMED, SHOP


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("a = b + c", "x = y + z"),
        ("a = 1", "a = 0x1F"),
        ("f('one')", 'f("""two\nlines""")'),
        ("a = 1  # why", "# first\na = 1\n\n"),
        ("def f():\n    '''Says.'''\n    pass", "def f():\n        pass"),
        (SHOP, RENAMED),
    ],
)
def test_the_same_program_in_other_words(one: str, other: str) -> None:
    assert words_of(one, "python").text == words_of(other, "python").text


@pytest.mark.parametrize(
    ("one", "other"), [("a = b + c", "a = b - c"), ("if a: b()", "while a: b()"), ("f(a)", "f(a, b)")]
)
def test_another_program(one: str, other: str) -> None:
    assert words_of(one, "python").text != words_of(other, "python").text


@pytest.mark.parametrize(
    ("one", "other", "equal"),
    [
        ("a = 1", "# mine\nb = 1", True),
        ("a = 1", "a = 2", False),
        ("f('one')", "f('two')", False),
        ("a = b + c", "a = b - c", False),
    ],
)
def test_code_that_one_comment_fits(one: str, other: str, equal: bool) -> None:
    assert (code_of({"n.py": one}) == code_of({"n.py": other, "README.md": other})) is equal


def test_no_programs_are_not_equal_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    assert code_of({"README.md": "a"}) == ""
    monkeypatch.setattr(tokens, "_LONGEST", -1.0)
    assert code_of({"n.py": "a = 1"}) == ""


def test_each_word_has_its_line() -> None:
    found = words_of('a = """\n\n"""\n# no\n\nb = 2\n', "python")
    assert list(found.lines) == [1, 1, 1, 6, 6, 6]
    assert len(found.text) == 6


def test_comments_and_includes_of_c_plus_plus_do_not_count() -> None:
    code = "#include <rclcpp/rclcpp.hpp>\n/* all\nof it */ int main() { return 0; } // end"
    assert words_of(code, "cpp").text == words_of("int other(){return 1;}", "cpp").text


def test_values_of_yaml_and_xml_stay_apart() -> None:
    for language, one, other in (
        ("yaml", "rate: 2.0  # fast", "rate: 3.0"),
        ("xml", '<node pkg="a"/>', '<node pkg="b"/>'),
    ):
        assert words_of(one, language).text != words_of(other, language).text
        assert words_of(one, language).text == words_of(f"\n\n{one}", language).text


@pytest.mark.parametrize(
    ("name", "language"),
    [
        ("a/b.py", "python"),
        ("b.launch.py", "python"),
        ("a.hpp", "cpp"),
        ("a.yml", "yaml"),
        ("a.launch.xml", "xml"),
        ("a_launch.xml", "xml"),
        ("a.launch", "xml"),
        ("package.xml", None),
        ("setup.cfg", None),
        ("CMakeLists.txt", None),
        ("py", None),
    ],
)
def test_language_by_name(name: str, language: str | None) -> None:
    assert language_of(name) == language


@pytest.mark.parametrize("language", ["python", "cpp", "yaml", "xml"])
@pytest.mark.parametrize(
    "text",
    ["", "def (:\n\t)]}", "'''never closed", "\x00\x1b[2J\u202e\ud800", "é" * 50, "<a <b {% [ - ? : |"],
)
def test_whatever_it_says_it_is_read(text: str, language: str) -> None:
    found = words_of(text, language)
    assert len(found.text) == len(found.lines)


def test_a_text_made_to_be_slow_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tokens, "_LONGEST", 0.05)
    with pytest.raises(TooSlow):
        words_of("\t \n" * 40_000, "python")
