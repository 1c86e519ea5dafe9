"""A private user id, which nobody else gets while it is held."""

from __future__ import annotations

import contextlib
import os
import socket
from pathlib import Path

import pytest

from course.errors import MissingHere
from course.isolation import identity as module
from course.isolation.identity import new_identity
from course.isolation.isolation_plan import ResourceLimits

root = pytest.mark.skipif(
    os.geteuid() != 0, reason="not exercised: each arena is a user of its own (this is not root)"
)


@pytest.fixture(autouse=True)
def no_groups(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "control_groups", lambda limits: contextlib.nullcontext(()))


@root
def test_two_at_once_are_two_users() -> None:
    with new_identity(ResourceLimits()) as first, new_identity(ResourceLimits()) as second:
        assert first.user and second.user
        assert first.user != second.user
    with new_identity(ResourceLimits()) as again:
        assert again.user == first.user


@root
def test_an_id_that_another_process_claims_is_passed_over() -> None:
    with new_identity(ResourceLimits()) as first:
        taken = first.user
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as claim:
        claim.bind(f"\0ros2course-user-{taken}")
        with new_identity(ResourceLimits()) as other:
            assert other.user != taken


@root
def test_none_left(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_usable", lambda: range(2_100_000_000, 2_100_000_001))
    with new_identity(ResourceLimits()), pytest.raises(MissingHere), new_identity(ResourceLimits()):
        pass


def test_an_ordinary_user_stays_who_he_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    with new_identity(ResourceLimits()) as who:
        assert who.user is None


@pytest.mark.parametrize(
    ("mapped", "first"),
    [("0 0 4294967295\n", 2_000_000_000), ("0 1000 1\n1 100000 65536\n", 55_000)],
    ids=["all ids", "root of a container"],
)
def test_the_ids_that_there_are(
    mapped: str, first: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "uid_map"
    file.write_text(mapped)
    monkeypatch.setattr(module, "_MAP", file)
    assert module._usable()[0] == first
