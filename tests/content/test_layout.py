"""What a solution adds to the learner's own file."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content.layout import named_course, with_addition
from course.errors import UsageError


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("", "new\n"),
        ("\n \n", "new\n"),
        ("old\n", "old\n\nnew\n"),
        ("old", "old\n\nnew\n"),
        ("old\nnew\nmore\n", "old\nnew\nmore\n"),
    ],
)
def test_it_comes_last_and_once(text: str, after: str) -> None:
    assert with_addition(text, "new\n") == after
    assert with_addition(after, "new\n") == after


@pytest.fixture(autouse=True)
def packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Three packages; none may be imported."""
    site = tmp_path / "site"
    for name, inside in (
        ("plain_course", "chapters"),
        ("deep_course", "_course/chapters"),
        ("no_course", "x"),
    ):
        (site / name / inside).mkdir(parents=True)
        (site / name / "__init__.py").write_text("raise RuntimeError\n")
    (site / "a_module.py").write_text("raise RuntimeError\n")
    (tmp_path / "here").mkdir()
    monkeypatch.syspath_prepend(str(site))
    monkeypatch.chdir(tmp_path / "here")
    return site


def test_a_package(packages: Path) -> None:
    assert named_course("plain_course") == packages / "plain_course"
    assert named_course("deep_course") == packages / "deep_course/_course"


def test_a_folder_comes_first_and_a_path_is_a_path() -> None:
    Path("plain_course").mkdir()
    assert named_course("plain_course") == Path("plain_course")
    assert named_course("./deep_course") == Path("deep_course")
    assert named_course("/no/where") == Path("/no/where")


@pytest.mark.parametrize("name", ["no_course", "a_module"])
def test_a_package_without_a_course(name: str) -> None:
    with pytest.raises(UsageError, match=f"the installed package {name}.* contains no course"):
        named_course(name)


def test_neither() -> None:
    Path("robots").mkdir()
    with pytest.raises(UsageError, match="did you mean `robots`") as caught:
        named_course("robts")
    assert caught.value.next_step and "--course DIR" in caught.value.next_step
