"""Entry points in all the ways that they can be written."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.setup_py import EntryPoint, entry_points, joined_entry_points, starts_another
from course.model.feedback import Location

FOLDER = "src/talk"
ONE = "'one = talk.one:main'"
TWO = "'two = talk.two:main'"
BOTH = [("one", "talk.one:main"), ("two", "talk.two:main")]


def found(setup_py: str = "", setup_cfg: str = "") -> tuple[EntryPoint, ...]:
    files = {f"{FOLDER}/setup.py": setup_py, f"{FOLDER}/setup.cfg": setup_cfg}
    return entry_points(Sources({name: text for name, text in files.items() if text}), FOLDER)


def pairs(entries: tuple[EntryPoint, ...]) -> list[tuple[str, str]]:
    return [(entry.name, entry.target) for entry in entries]


@pytest.mark.parametrize(
    "scripts",
    [
        f"[{ONE}, {TWO}]",
        f"({ONE}, {TWO})",
        f"[\n    {ONE},\n    {TWO},\n]",
        "['one=talk.one:main', ' two =  talk.two:main ']",
        "['one = ' 'talk.one:main', 'two = '\n 'talk.two:main']",
        "['one = ' + 'talk.one:main', 'two = ' + package_name + '.two:main']",
        "[f'one = {package_name}.one:main', f'two = {package_name}.two:main']",
        "scripts",
        "'''\n    one = talk.one:main\n    two = talk.two:main\n'''",
        "[*more, 'one = talk.one:main', None, 'two = talk.two:main', unknown, f'{unknown}']",
    ],
)
@pytest.mark.parametrize(
    "whole", ["entry_points={{'console_scripts': {}}}", "entry_points=dict(console_scripts={})"]
)
def test_both_entry_points_are_found(whole: str, scripts: str) -> None:
    text = f"package_name = 'talk'\nscripts = [{ONE}, {TWO}]\nsetup({whole.format(scripts)})\n"
    assert pairs(found(text)) == BOTH


def test_each_has_its_line() -> None:
    text = f"setup(entry_points={{\n'console_scripts': [\n{ONE},\n{TWO},\n]}})"
    assert found(text) == (
        EntryPoint("one", "talk.one:main", "one = talk.one:main", Location(f"{FOLDER}/setup.py", 3), 3),
        EntryPoint("two", "talk.two:main", "two = talk.two:main", Location(f"{FOLDER}/setup.py", 4), 4),
    )


def test_lines_of_one_long_string() -> None:
    text = 'setup(\n entry_points={"console_scripts": """\n one = talk.one:main\n\n two = talk.two:m\n"""})'
    assert [entry.where.line for entry in found(text)] == [3, 5]


def test_other_groups_do_not_count() -> None:
    assert found(f"setup(entry_points={{'gui_scripts': [{ONE}], 'pytest11': [{TWO}]}})") == ()


@pytest.mark.parametrize(
    "text",
    [
        "",
        "setup(",
        "\x00",
        "setup()",
        "setup(entry_points={'console_scripts': scripts()})",
        "scripts = scripts",
    ],
)
def test_what_cannot_be_told_is_nothing(text: str) -> None:
    assert found(text) == ()


def test_names_in_a_circle_end() -> None:
    text = "a = f'{b}'\nb = f'{a}'\nsetup(entry_points={'console_scripts': [a, f'{b}']})"
    assert found(text) == ()


def test_setup_cfg() -> None:
    text = (
        "[develop]\n[options.entry_points]\nconsole_scripts =\n one = talk.one:main\n two = talk.two:main\n"
    )
    entries = found(setup_cfg=text)
    assert pairs(entries) == BOTH
    assert [str(entry.where) for entry in entries] == [f"{FOLDER}/setup.cfg:4", f"{FOLDER}/setup.cfg:5"]


def test_setup_cfg_in_one_line() -> None:
    text = "[options.entry_points]\nconsole_scripts = one = talk.one:main\n"
    assert pairs(found(setup_cfg=text)) == BOTH[:1]


@pytest.mark.parametrize(
    "text", ["[develop]\n", "no section", "[a]\nx = 1\nx = 2\n", "[options.entry_points]\n"]
)
def test_a_setup_cfg_without_any(text: str) -> None:
    assert found(setup_cfg=text) == ()


@pytest.mark.parametrize(
    ("scripts", "joined"),
    [
        (f"[{ONE} {TWO}]", "one = talk.one:maintwo = talk.two:main"),
        (f"[\n    {ONE}\n    {TWO},\n]", "one = talk.one:maintwo = talk.two:main"),
        (f"['zero = talk.zero:main', {ONE} {TWO}]", "one = talk.one:maintwo = talk.two:main"),
        (f"[{ONE}, {TWO}]", None),
        ("['one = ' 'talk.one:main']", None),
        ("['one = talk.one']", None),
        ("[]", None),
    ],
)
def test_a_missing_comma_is_noticed(scripts: str, joined: str | None) -> None:
    sources = Sources({f"{FOLDER}/setup.py": f"setup(entry_points={{'console_scripts': {scripts}}})"})
    entry = joined_entry_points(sources, FOLDER)
    assert (entry.text if entry else None) == joined


@pytest.mark.parametrize(
    ("seen", "wanted", "line"),
    [("/one_node", "two_node", 1), ("/one_node", "one_node", None), ("/other", "two_node", None)],
)
def test_an_entry_point_that_starts_another_node(seen: str, wanted: str, line: int | None) -> None:
    scripts = f"setup(entry_points={{'console_scripts': [{TWO.replace('talk.two', 'talk.one')}]}})"
    modules = {name: f"super().__init__('{name}_node')" for name in ("one", "two")}
    files = {f"{FOLDER}/talk/{name}.py": text for name, text in modules.items()}
    cause = starts_another(Sources({f"{FOLDER}/setup.py": scripts, **files}), seen, wanted)
    assert (cause.where[0].line if cause else None) == line
    assert cause is None or "starts `one`" in cause.text
