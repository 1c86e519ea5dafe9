"""People's names are not paths."""

from __future__ import annotations

import pytest

from course.report.gradebook.sheets import file_stem
from tests.report.gradebook import hostile


@pytest.mark.parametrize("name", ["ada", "ada.okafor", "2026-001", "A_b-c"])
def test_a_harmless_id_is_its_own_name(name: str) -> None:
    assert file_stem(name) == name


@pytest.mark.parametrize("text", [*hostile.TEXTS, "../../x", "..", ".", ".hidden", "a/b", "x" * 300, "-rf"])
def test_any_other_id_becomes_a_name(text: str) -> None:
    stem = file_stem(text)
    assert stem.isascii() and "/" not in stem and stem[0] not in ".-" and len(stem) <= 60


def test_different_people_have_different_names() -> None:
    people = ["a b", "a-b", "a/b", "", " ", "é", "è", file_stem("a b")]
    assert len({file_stem(name) for name in people}) == len(people)
