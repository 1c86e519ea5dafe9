"""What is said about a `.bashrc` that keeps bash from its prompt, and about commands that do not end."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.home_files import HomeEntry
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading.expect.shell import complaints, expect_ran, expect_shell
from course.model.events import Event, ShellRan, ShellReady, ShellStuck
from tests.golden import golden

from .conftest import said, told

READY = ShellReady(0.1, "bash", ())


def shell(*events: Event, bashrc: str = "# mine\n") -> Recording:
    entry = HomeEntry(".bashrc", "file", 0o644, len(bashrc))
    return Recording("x", events, sources=Sources({".bashrc": bashrc}), looked_at=(entry,))


def test_a_shell_that_is_well() -> None:
    ran = ShellRan(0.2, "bash", "say_hello", ("hello",), 0, 0.1)
    recording = shell(READY, ran)
    assert said(expect_shell, recording) is None
    assert expect_ran(recording, "say_hello") == ran


@pytest.mark.parametrize(
    ("reason", "program", "bashrc"),
    [
        ("ended", "", "x=1\nexit\n"),
        ("replaced", "zsh", "exec zsh\n"),
        ("running", "sleep 100", "\nsleep 100\n"),
        ("waiting", "", "# read this\nread name\n"),
        ("busy", "", "while :; do :; done\n"),
        ("flood", "", "yes\n"),
    ],
)
def test_each_reason_has_words_and_a_line(reason: str, program: str, bashrc: str) -> None:
    stuck = ShellStuck(1.0, "bash", reason, program, ("its last words",))
    golden(told(expect_shell, shell(stuck, bashrc=bashrc)))


@pytest.mark.parametrize(
    "line",
    [
        "bash: /tmp/h/.bashrc: line 12: syntax error near unexpected token `fi'",
        "bash: /tmp/h/.bashrc: line 12: unexpected EOF while looking for matching `''",
    ],
)
def test_a_bashrc_that_bash_cannot_read(line: str) -> None:
    recording = shell(ShellReady(0.1, "bash", ("hello", line)))
    golden(told(expect_shell, recording))
    assert complaints(recording)[0] == (None, "hello")


def test_a_command_that_closes_or_blocks_the_shell() -> None:
    none = ShellRan(0.2, "bash", "say_hello", (), None, 0.1)
    golden(told(expect_ran, shell(READY, none, ShellStuck(0.3, "bash", "ended", "", ())), "say_hello"))
    stuck = ShellStuck(0.3, "bash", "running", "sleep 9", ())
    golden(told(expect_ran, shell(READY, none, stuck), "say_hello"))


def test_what_was_never_typed_is_our_fault() -> None:
    with pytest.raises(OurFault):
        expect_ran(shell(READY), "say_hello")
    with pytest.raises(OurFault):
        expect_shell(shell())
