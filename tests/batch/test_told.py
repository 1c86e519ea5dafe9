"""The output of commands as documents show it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.batch.told import DOCUMENTS, Term


@pytest.mark.slow
@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda document: document.stem)
def test_documents_show_what_commands_say(document: Path, tmp_path: Path) -> None:
    text = document.read_text(encoding="utf-8")
    assert Term(tmp_path).told(text) == text, "python -m tests.batch.told, and look at what changed"
