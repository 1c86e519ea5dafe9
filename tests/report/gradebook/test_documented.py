"""docs/results.md shows what the formats make, and names every field."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from typing import Any

from course.model.result import Verdict
from course.report.gradebook import github, gradescope
from course.report.gradebook.sheets import COMPLETE, EXCUSED, INCOMPLETE, MARKED, NOT_HANDED_IN
from tests.report.gradebook import samples

TEXT = samples.DOCUMENT.read_text(encoding="utf-8")
TOLD = set(re.findall(r"`([^`\n]+)`", samples.REGION.sub("", TEXT)))


def test_every_sample_is_fresh() -> None:
    regions = [match[1] for match in samples.REGION.finditer(TEXT)]
    assert sorted(regions) == sorted(samples.SAMPLES)
    assert samples.fresh(TEXT) == TEXT, "run python -m tests.report.gradebook.samples, see what changed"


def test_the_command_that_makes_them_says_so() -> None:
    command = [sys.executable, "-m", "tests.report.gradebook.samples", "--check"]
    root = samples.DOCUMENT.parents[1]
    assert subprocess.run(command, cwd=root, check=False, timeout=120).returncode == 0


def test_every_field_is_named() -> None:
    fields = names(samples.SCHEMA)
    made = [
        gradescope.as_data(samples.sheet_of(samples.BAO)),
        github.as_data(samples.sheet_of(samples.BAO)),
    ]
    for data in made:
        fields |= {*data, *(key for test in data["tests"] for key in test)}
    assert len(fields) > 40
    assert sorted(fields - TOLD) == []


def test_every_verdict_and_state_is_named() -> None:
    assert {
        *(verdict.value for verdict in Verdict),
        NOT_HANDED_IN,
        EXCUSED,
        MARKED,
        COMPLETE,
        INCOMPLETE,
    } <= TOLD


def test_the_samples_hold_nothing_of_a_machine() -> None:
    assert not re.search(r"/(home|root|tmp|work|srv|usr)/", TEXT)
    assert all(json.loads(path.read_text(encoding="utf-8"))["checks"] for path in samples.DATA.iterdir())


def names(schema: Any) -> set[str]:
    """All properties that a schema speaks of."""
    if isinstance(schema, list):
        return set().union(*map(names, schema))
    if not isinstance(schema, dict):
        return set()
    own = schema.get("properties")
    return set(own or ()).union(*map(names, schema.values()))
