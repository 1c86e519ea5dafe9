"""An interactive bash, with every kind of .bashrc that a learner, or an attacker, may write."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.evidence.process_view import ShellView
from course.model.events import ProcessExited, ShellPrompt

from .conftest import WAIT
from .programs import Programs

ALIAS = "alias say_hello='echo hello'\n"
Commands = Callable[..., ShellView]


@pytest.fixture
def typed(programs: Programs) -> Commands:
    """The results of some commands in a shell with this .bashrc."""

    def run(bashrc: str | None, *commands: str, timeout: float = WAIT, sourced: bool = False) -> ShellView:
        if bashrc is not None:
            programs.write(".bashrc", bashrc)
        with programs.shell(timeout=timeout, sourced=sourced) as shell:
            for command in commands:
                shell.run(command, timeout=timeout)
        return programs.recording.shell()

    return run


def test_output_and_exit_codes(typed: Commands) -> None:
    shell = typed(ALIAS, "say_hello", "false", "no_such_command", "printf one; echo; printf two")
    assert [(ran.printed, ran.code) for ran in shell.ran] == [
        (("hello",), 0),
        ((), 1),
        (("bash: no_such_command: command not found",), 127),
        (("one", "two"), 0),
    ]
    assert shell.ready is not None and shell.ready.printed == ()
    assert shell.stuck is None


def test_it_is_interactive_at_home_and_keeps_its_state(typed: Commands, tmp_path: Path) -> None:
    shell = typed(ALIAS, "echo $-", "pwd", "mkdir new; cd new", "pwd", "x=3", "echo $x $HOME $TERM", "tty")
    said = [ran.printed for ran in shell.ran]
    home = str(tmp_path / "home")
    assert "i" in said[0][0]
    assert (said[1], said[3]) == ((home,), (f"{home}/new",))
    assert said[5] == (f"3 {home} xterm",)
    assert said[6][0].startswith("/dev/")


@pytest.mark.parametrize(("sourced", "kind"), [(False, "plain "), (True, "sourced jazzy")])
def test_ros_is_there_only_when_asked_for(typed: Commands, sourced: bool, kind: str) -> None:
    shell = typed(None, 'echo "$KIND $ROS_DISTRO"', "env | grep ROS_ | wc -l", sourced=sourced)
    assert shell.ran[0].printed == (kind,)
    assert (shell.ran[1].printed[0].strip() == "0") is not sourced


@pytest.mark.parametrize(
    "bashrc",
    [
        "PS1='\\u@\\h:\\w\\$ '\n",
        "PROMPT_COMMAND='echo noise; PS1=x'\n",
        "PROMPT_COMMAND=('echo a' 'echo b')\n",
        "PS0='running '\n",
        "stty echo\n",
        "clear\n",
        "sleep 100 &\ndisown\n",
        "set -u\n",
        "printf() { echo mine; }\nalias unset=false builtin=false\n",
        "echo no line end >&2; printf '%s' halfway\n",
        "return\nexit\n",
        "cd /\n",
        "exec 3>&1\n",
        "alias echo='echo -n x'\nunalias echo\n",
        "true\r\n",
    ],
)
def test_a_bashrc_with_ways_of_its_own(typed: Commands, bashrc: str) -> None:
    shell = typed(ALIAS + bashrc, "say_hello", "(exit 7)", "PS1='mine '", "say_hello")
    assert shell.stuck is None
    assert [(ran.printed, ran.code) for ran in shell.ran] == [
        (("hello",), 0),
        ((), 7),
        ((), 0),
        (("hello",), 0),
    ]


@pytest.mark.parametrize("bashrc", ["set -x\n", "trap 'echo debug' DEBUG\n"])
def test_noise_does_not_shift_the_answers(programs: Programs, typed: Commands, bashrc: str) -> None:
    shell = typed(ALIAS + bashrc, "say_hello", "(exit 7)", "say_hello")
    assert [ran.code for ran in shell.ran] == [0, 7, 0]
    assert ["hello" in ran.printed for ran in shell.ran] == [True, False, True]
    # Nothing else was mistaken for a prompt.
    assert [prompt.code for prompt in programs.timeline.of(ShellPrompt)][1:] == [0, 7, 0]


@pytest.mark.slow
@pytest.mark.parametrize("bashrc", ["readonly PS1='x> '\nreadonly PROMPT_COMMAND=:\n", "exec 2>/dev/null\n"])
def test_a_prompt_that_cannot_be_set_or_seen(typed: Commands, bashrc: str) -> None:
    shell = typed(ALIAS + bashrc, "say_hello", "(exit 7)", 'echo "it\'s"', timeout=3.0)
    assert shell.stuck is None
    assert [(ran.printed, ran.code) for ran in shell.ran] == [(("hello",), 0), ((), 7), (("it's",), 0)]


def test_what_bash_says_of_a_bashrc_is_kept(typed: Commands) -> None:
    shell = typed("alias say_hello = 'echo hello'\nif true; then\n", "true")
    assert any("alias: =: not found" in line for line in shell.ready.printed)
    assert any("syntax error" in line and "line 3" in line for line in shell.ready.printed)
    assert shell.ran[0].code == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("bashrc", "reason", "program"),
    [
        ("sleep 1000\n", "running", "sleep 1000"),
        ("exec sh\n", "replaced", "sh"),
        ("exec sleep 1000\n", "replaced", "sleep"),
        ("cat\n", "running", "cat"),
        ("read -p 'Name? ' name\n", "waiting", ""),
        ("select x in a b; do echo $x; done\n", "waiting", ""),
        ("while true; do :; done\n", "busy", ""),
        ("while true; do echo flood flood flood flood flood; done\n", "flood", ""),
        ("bash\n", "running", "bash"),
        ("trap '' INT TERM HUP\nsleep 1000\n", "running", "sleep 1000"),
    ],
)
def test_a_bashrc_that_never_ends(typed: Commands, bashrc: str, reason: str, program: str) -> None:
    shell = typed(ALIAS + bashrc, "say_hello", timeout=3.0)
    assert shell.ready is None
    assert (shell.stuck.reason, shell.stuck.program) == (reason, program)
    assert shell.ran == ()


@pytest.mark.parametrize("bashrc", ["echo bye\nexit 3\n", "echo bye\nkill -9 $$\n", "echo bye\nexec true\n"])
def test_a_bashrc_that_ends_bash(typed: Commands, bashrc: str) -> None:
    shell = typed(bashrc, "say_hello")
    assert (shell.stuck.reason, shell.stuck.printed) == ("ended", ("bye",))


def test_a_shell_that_closes_at_the_first_failure(typed: Commands) -> None:
    shell = typed("set -e\n", "true", "false", "true")
    assert [(ran.command, ran.code) for ran in shell.ran] == [("true", 0), ("false", None)]
    assert shell.stuck is not None and shell.stuck.reason == "ended"


@pytest.mark.slow
def test_a_command_that_never_ends(programs: Programs) -> None:
    programs.write(".bashrc", "")
    with programs.shell() as shell:
        assert shell.run("sleep 1000", timeout=0.5).code is None
        assert not shell.alive
        assert shell.run("true").code is None
    found = programs.recording.shell()
    assert (found.stuck.reason, found.stuck.program) == ("running", "sleep 1000")
    assert [ran.command for ran in found.ran] == ["sleep 1000"]


def test_it_ends_with_its_context(programs: Programs) -> None:
    with programs.shell() as shell:
        shell.run("true")
    assert [end.process for end in programs.timeline.of(ProcessExited)] == ["bash"]


def test_a_home_without_a_bashrc(typed: Commands) -> None:
    assert typed(None, "alias").ran[0].code == 0
