"""A workspace that is really built in a trial home."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import OurFault
from course.grading.trial_build import build_in_place

pytestmark = pytest.mark.slow


def test_it_is_built_anew_with_the_given_layout(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    build_in_place(tmp_path / "ws")
    (tmp_path / "ws/install/left").touch()
    build_in_place(tmp_path / "ws", ["--merge-install"])
    assert (tmp_path / "ws/install/.colcon_install_layout").read_text().strip() == "merged"
    assert not (tmp_path / "ws/install/left").exists()


def test_a_build_that_fails_is_our_fault(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    with pytest.raises(OurFault, match="does not build"):
        build_in_place(tmp_path / "ws", ["--no-such-option"])
