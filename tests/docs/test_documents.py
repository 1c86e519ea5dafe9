"""What the documents show is so: their code runs, their tables name what exists, pictures are fresh."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from course.arena.arena import Arena
from course.evidence.recording import Recording

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
CODE = re.compile(r"```python\n(.*?)```", re.DOTALL)
CALLED = {"arena": Arena, "recording": Recording}


def blocks(name: str) -> list[str]:
    return CODE.findall((DOCS / name).read_text(encoding="utf-8"))


def test_the_sample_grader_is_a_grader() -> None:
    names: dict[str, object] = {}
    exec(compile(blocks("writing-a-grader.md")[0], "sample", "exec"), names)
    talker = names["talker"]
    assert list(talker.checks) == ["builds", "starts", "topic", "rate"]  # type: ignore[attr-defined]


@pytest.mark.parametrize("owner", CALLED)
def test_what_the_tables_name_exists(owner: str) -> None:
    text = (DOCS / "writing-a-grader.md").read_text(encoding="utf-8")
    named = set(re.findall(rf"`{owner}\.(\w+)", text))
    fields = set(getattr(CALLED[owner], "__dataclass_fields__", {}))
    assert named, "the document names nothing of it"
    assert [name for name in named if not hasattr(CALLED[owner], name) and name not in fields] == []


def test_links_between_documents_lead_somewhere() -> None:
    for document in (ROOT / "README.md", *DOCS.glob("*.md")):
        for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text(encoding="utf-8")):
            assert (document.parent / target).exists(), f"{document.name}: {target}"


@pytest.mark.slow
def test_the_picture_of_a_check_is_what_a_check_prints() -> None:
    done = subprocess.run([sys.executable, str(DOCS / "pictures.py"), "--check"], cwd=ROOT, check=False)
    assert done.returncode == 0, "run docs/pictures.py and look at what changed"
