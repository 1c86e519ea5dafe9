"""Golden files: a difference is a failure, and every entry belongs to an existing test."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.golden import entries, golden

TESTS = Path(__file__).parent
FILES = sorted(TESTS.rglob("golden/*.txt"))


def test_a_difference_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.golden._calls", {})
    monkeypatch.setenv(
        "PYTEST_CURRENT_TEST", "tests/explain/test_executables.py::test_a_missing_comma (call)"
    )
    with pytest.raises(pytest.fail.Exception, match=r"\+another text"):
        golden("another text")
    with pytest.raises(AssertionError, match="no entry"):
        golden("a second call in the same test")


@pytest.mark.parametrize("file", FILES, ids=[str(file.relative_to(TESTS)) for file in FILES])
def test_every_entry_is_of_a_test(file: Path) -> None:
    tests = (file.parents[1] / f"test_{file.name}").with_suffix(".py").read_text(encoding="utf-8")
    named = {re.split(r"[\[ ]", name)[0] for name in entries(file)}
    assert named and named <= set(re.findall(r"^def (test_\w+)", tests, re.MULTILINE))
