"""The Python modules of sas_core as imports of the tests: they need no ROS."""

from __future__ import annotations

from pathlib import Path

import pytest

_SOURCES = Path(__file__).parents[3] / "underlay/src"


@pytest.fixture(autouse=True)
def _sas_core_is_importable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(_SOURCES / "sas_core"))
