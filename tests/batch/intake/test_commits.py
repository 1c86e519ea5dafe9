"""The time of a clone's commit, read without anything that the learner could have set."""

from __future__ import annotations

import subprocess
from datetime import datetime, timedelta, timezone
from pathlib import Path

import pytest

from course.batch.intake.commits import committed, dated
from course.batch.intake.submission import Part, Upload
from course.model.gradebook import Person

AT = datetime(2026, 10, 5, 23, 58, tzinfo=timezone(timedelta(hours=-4)))


def git(folder: Path, *words: str) -> None:
    who = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a"}
    dates = {"GIT_AUTHOR_DATE": "2020-01-01T00:00:00Z", "GIT_COMMITTER_DATE": AT.isoformat()}
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(folder), "GIT_COMMITTER_EMAIL": "a@b", **who, **dates}
    subprocess.run(["git", "-C", str(folder), *words], check=True, capture_output=True, env=environment)


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    folder = tmp_path / "clone"
    folder.mkdir()
    git(folder, "init", "-b", "main")
    (folder / "file").write_text("work")
    git(folder, "add", "file")
    git(folder, "commit", "-m", "Work\n\ncommitter eve <e@f> 0 +0000")
    return folder


def test_the_committers_date_counts(clone: Path) -> None:
    upload = Upload(Person("ada"), "clone", (Part("clone", clone),))
    assert dated(upload).person.handed_in == AT
    known = Upload(Person("ada", handed_in=datetime(2026, 1, 1)), "clone", (Part("clone", clone),))
    assert dated(known) == known


def test_a_packed_clone_and_a_detached_head(clone: Path) -> None:
    git(clone, "gc")
    assert not (clone / ".git/refs/heads/main").exists()
    assert committed(clone / ".git") == AT
    git(clone, "checkout", "--detach")
    assert committed(clone / ".git") == AT


def test_nothing_of_the_learners_settings_runs(clone: Path, tmp_path: Path) -> None:
    trap = tmp_path / "trap"
    trap.write_text(f"#!/bin/sh\ntouch {tmp_path}/sprung\n")
    trap.chmod(0o755)
    with (clone / ".git/config").open("a") as config:
        config.write(f"[core]\n\tfsmonitor = {trap}\n\tpager = {trap}\n\tsshCommand = {trap}\n")
        config.write(f"[log]\n\tshowSignature = true\n[gpg]\n\tprogram = {trap}\n")
    assert committed(clone / ".git") == AT
    assert not (tmp_path / "sprung").exists()


@pytest.mark.parametrize(
    ("file", "content"),
    [
        ("HEAD", b""),
        ("HEAD", b"ref: refs/heads/../../../../etc/passwd"),
        ("HEAD", b"0" * 40),
        ("HEAD", b"--help"),
        ("refs/heads/main", b"\xff" * 100),
    ],
)
def test_what_is_no_clone_has_no_date(clone: Path, file: str, content: bytes) -> None:
    (clone / ".git" / file).write_bytes(content)
    assert committed(clone / ".git") is None


def test_an_object_that_is_no_commit_or_is_broken(clone: Path) -> None:
    blob = subprocess.run(
        ["git", "-C", str(clone), "rev-parse", "HEAD:file"], check=True, capture_output=True, text=True
    )
    (clone / ".git/HEAD").write_text(blob.stdout)
    assert committed(clone / ".git") is None
