"""The file of acts: kept complete, read with suspicion, limited in size."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from course.arena.mystery_module import MAX_ACTS, log_file, read_log, write_log
from course.evidence.acts import Act, acts_of
from course.model.events import Acted, OutputLine

ACTS = (Act("greeted"), Act("mumbled", "häm \n"))


def test_what_is_written_is_read(tmp_path: Path) -> None:
    file = log_file(tmp_path, "05-keepers")
    write_log(file, "05-keepers", ACTS)
    assert file == tmp_path / "acts/05-keepers.json"
    assert read_log(file) == ACTS


@pytest.mark.parametrize(
    "content", ["", "[]", "{}", '{"acts": 3}', '{"acts": [1]}', '{"acts": [{"detail": "x"}]}', "[" * 100_000]
)
def test_what_is_none_of_ours_holds_nothing(tmp_path: Path, content: str) -> None:
    file = tmp_path / "acts.json"
    file.write_text(content)
    assert read_log(file) == ()


def test_a_huge_file_is_bounded(tmp_path: Path) -> None:
    file = tmp_path / "acts.json"
    file.write_text(json.dumps({"acts": [{"name": "n" * 2000}] * 400}))
    acts = read_log(file)
    assert len(acts) == MAX_ACTS
    assert len(acts[0].name) == 1000


def test_links_and_pipes_are_not_read(tmp_path: Path) -> None:
    write_log(tmp_path / "real.json", "05-keepers", ACTS)
    (tmp_path / "link.json").symlink_to(tmp_path / "real.json")
    os.mkfifo(tmp_path / "pipe.json")
    assert read_log(tmp_path / "link.json") == read_log(tmp_path / "pipe.json") == ()


def test_acts_of_a_recording() -> None:
    events = (
        Acted(0.0, "greeted", ""),
        OutputLine(1.0, "mystery", '{"act": {"name": "mumbled", "detail": "x"}}'),
        OutputLine(2.0, "mystery", '{"act": {"name": "greeted", "detail": ""}}'),
        OutputLine(2.0, "learners", '{"act": {"name": "cheated", "detail": ""}}'),
        OutputLine(3.0, "mystery", "ready"),
    )
    assert acts_of(events) == (Act("greeted"), Act("mumbled", "x"))
