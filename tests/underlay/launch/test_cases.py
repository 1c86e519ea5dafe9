"""Launch files of many shapes run as they were written (see cases_read.py)."""

from __future__ import annotations

import pytest

from tests.underlay.launch.cases_read import Case, cases, check
from tests.underlay.launch.machine import Launcher

_CASES = [
    pytest.param(case, id=case.label, marks=[pytest.mark.slow] if case.told.get("slow") else [])
    for case in cases()
]


@pytest.mark.slow
@pytest.mark.parametrize("case", _CASES)
def test_case(launcher: Launcher, case: Case) -> None:
    check(case, launcher)
