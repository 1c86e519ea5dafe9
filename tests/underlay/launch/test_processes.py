"""Processes: how they are started, shown, watched and ended."""

from __future__ import annotations

import signal

import pytest

from tests.underlay.launch.machine import Launcher, alive, gone

STUBBORN = "trap '' INT TERM; echo ready; while :; do sleep 0.05; done"


def _pidless(lines: list[str]) -> list[str]:
    return [line.split("pid [")[0].split("[pid ")[0] for line in lines]


def test_events_of_a_process(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        one,
        RegisterEventHandler(OnProcessStart(target_action=one, on_start=[LogInfo(msg='started')])),
        RegisterEventHandler(OnProcessIO(
            target_action=one,
            on_stdout=lambda event: LogInfo(msg='out ' + event.text.decode().strip()),
            on_stderr=lambda event: [LogInfo(msg='err ' + event.text.decode().strip())])),
        RegisterEventHandler(OnProcessExit(target_action=one, on_exit=[
            LogInfo(msg='exited'),
            ExecuteProcess(cmd=['echo', 'next'], output='screen', on_exit=Shutdown(reason='done'))])),
        RegisterEventHandler(OnProcessExit(on_exit=lambda event, context: LogInfo(
            msg=f'{event.process_name} {event.returncode}'))),
        RegisterEventHandler(OnExecutionComplete(
            target_action=one, on_completion=LogInfo(msg='complete'))),
        RegisterEventHandler(OnShutdown(on_shutdown=[
            LogInfo(msg=['end: ', LocalSubstitution('event.reason')])])),
        TimerAction(period=50.0, actions=[]),
        """,
        before="script = 'echo hello; sleep 0.1; echo oh >&2; exit 3'\n"
        "one = ExecuteProcess(name='one', cmd=['sh', '-c', script])",
    )
    assert answer.logged == [
        "started", "out hello", "err oh", "one-1 3", "exited", "complete", "echo-2 0", "end: done",
    ]  # fmt: skip
    assert "[INFO] [launch]: process[echo-2] was required: shutting down launched system" in answer.said
    assert answer.code == 0


@pytest.mark.parametrize(
    ("output", "screen", "log"),
    [
        ("'screen'", ["out", "err"], []),
        ("'log'", ["err"], ["out", "err"]),
        ("'both'", ["out", "err"], ["out", "err"]),
        ("'full'", ["out", "err"], ["out", "err"]),
        ("{'stdout': 'screen', 'stderr': 'log'}", ["out"], ["err"]),
        ("LaunchConfiguration('where', default='screen')", ["out", "err"], []),
    ],
)
def test_where_output_goes(launcher: Launcher, output: str, screen: list[str], log: list[str]) -> None:
    answer = launcher.run(
        f"ExecuteProcess(cmd=['sh', '-c', 'echo out; sleep 0.1; echo err >&2'], name='p', output={output})"
    )
    assert answer.of("p-1") == screen
    (folder,) = (launcher.home / ".ros" / "log").iterdir()
    logged = (folder / "launch.log").read_text(encoding="utf-8").splitlines()
    assert [line.split("[p-1] ")[1] for line in logged if "[p-1] " in line] == log
    assert logged[0].split(" ", 1)[1] == answer.stdout.splitlines()[0]
    own = {"p-1.log": "out\nerr\n", "p-1-stdout.log": "out\n", "p-1-stderr.log": "err\n"}
    for name, text in own.items() if output == "'full'" else ():
        assert (folder / name).read_text(encoding="utf-8").replace("[p-1] ", "") == text


def test_every_line_has_its_time_in_the_log(launcher: Launcher) -> None:
    launcher.run("ExecuteProcess(cmd=['seq', '300'], output='log')")
    (folder,) = (launcher.home / ".ros" / "log").iterdir()
    logged = (folder / "launch.log").read_text(encoding="utf-8").splitlines()
    lines = [line.partition(" ") for line in logged if "[seq-1] " in line]
    assert [line for _, _, line in lines] == [f"[seq-1] {number}" for number in range(1, 301)]
    assert all(float(stamp) > 1e9 for stamp, _, _ in lines)


def test_show_all_output(launcher: Launcher) -> None:
    path = launcher.description("ExecuteProcess(cmd=['echo', 'x'], output='log')")
    assert launcher(path).of("echo-1") == []
    assert launcher("-a", path).of("echo-1") == ["x"]


def test_log_folder(launcher: Launcher) -> None:
    answer = launcher.run("LogInfo(msg=LaunchLogDir())", ROS_LOG_DIR=str(launcher.cwd / "logs"))
    (folder,) = (launcher.cwd / "logs").iterdir()
    assert answer.logged == [str(folder)]
    assert answer.stdout.splitlines()[0].endswith(f"All log files can be found below {folder}")


def test_a_terminal_is_emulated(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        ExecuteProcess(cmd=['sh', '-c', 'test -t 1 && test -t 2 && echo tty; printf end'],
                       output='screen', emulate_tty=True, name='a'),
        ExecuteProcess(cmd=['sh', '-c', 'test -t 1 || echo pipe'], output='screen', name='b'),
        """
    )
    assert answer.of("a-1") == ["tty", "end"]
    assert answer.of("b-2") == ["pipe"]


def test_shell_prefix_and_folder(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        ExecuteProcess(cmd=[['echo ', 'a b', ' | tr a-z A-Z']], shell=True, output='screen', name='shell'),
        ExecuteProcess(cmd=['pwd'], cwd='/', prefix=['env ', 'LC_ALL=C'], output='screen'),
        ExecuteProcess(cmd=['echo', 'x'], output='screen', output_format='<{line}>', log_cmd=True),
        """
    )
    assert answer.of("shell-1") == ["A B"]
    assert answer.of("pwd-2") == ["/"]
    assert "<x>" in answer.said
    assert any(line.endswith(": cmd 'echo x'") for line in answer.said)


def test_launch_prefix_of_the_command_line(launcher: Launcher) -> None:
    path = launcher.description(
        "ExecuteProcess(cmd=['a', 'x'], output='screen'), ExecuteProcess(cmd=['true'])"
    )
    answer = launcher("--launch-prefix", "echo 1", "--launch-prefix-filter", "a", path)
    assert answer.of("a-1") == ["1 a x"]
    assert "process has finished cleanly" in answer.stdout


def test_respawn(launcher: Launcher) -> None:
    answer = launcher.run(
        "ExecuteProcess(cmd=['false'], respawn=True, respawn_delay=0.05, respawn_max_retries=2)"
    )
    starts = "[INFO] [false-1]: process started with "
    ends = "[ERROR] [false-1]: process has died "
    assert _pidless(answer.said) == [starts, ends] * 3


@pytest.mark.slow
def test_respawning_ends_with_the_launch(launcher: Launcher) -> None:
    path = launcher.description("ExecuteProcess(cmd=['sleep', '0.1'], respawn=True)")
    with launcher.started(path) as running:
        running.wait_for("process started", times=3)
        running.signal(signal.SIGINT)
        assert running.finish().code == 0


def test_a_program_that_is_not_there(launcher: Launcher) -> None:
    answer = launcher.run("ExecuteProcess(cmd=['nosuch-program']), ExecuteProcess(cmd=['echo', 'x'])")
    assert answer.said[0] == (
        "[ERROR] [nosuch-program-1]: exception occurred while executing process: "
        "FileNotFoundError: [Errno 2] No such file or directory: 'nosuch-program'"
    )
    assert answer.said[-1].startswith("[INFO] [echo-2]: process has finished cleanly")


@pytest.mark.slow
def test_escalation(launcher: Launcher) -> None:
    path = launcher.description(
        f'ExecuteProcess(cmd=["sh", "-c", "{STUBBORN}"], name="mule", output="screen",'
        "sigterm_timeout='0.2', sigkill_timeout=LaunchConfiguration('sigkill_timeout', default='0.3'))"
    )
    with launcher.started(path) as running:
        pid = running.pid_of("mule-1")
        running.wait_for("ready")
        running.signal(signal.SIGINT)
        answer = running.finish()
    head = "[ERROR] [mule-1]: process[mule-1] failed to terminate"
    assert answer.said[2:-1] == [
        "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)",
        "[INFO] [mule-1]: sending signal 'SIGINT' to process[mule-1]",
        f"{head} '0.2' seconds after receiving 'SIGINT', escalating to 'SIGTERM'",
        "[INFO] [mule-1]: sending signal 'SIGTERM' to process[mule-1]",
        f"{head} '0.5' seconds after receiving 'SIGTERM', escalating to 'SIGKILL'",
        "[INFO] [mule-1]: sending signal 'SIGKILL' to process[mule-1]",
    ]
    assert answer.said[-1].startswith(f"[ERROR] [mule-1]: process has died [pid {pid}, exit code -9, cmd ")
    assert answer.code == 0


@pytest.mark.slow
def test_the_usual_delays(launcher: Launcher) -> None:
    path = launcher.description(
        f'ExecuteProcess(cmd=["sh", "-c", "{STUBBORN}"], name="mule", output="screen")'
    )
    with launcher.started(path) as running:
        running.wait_for("ready")
        running.signal(signal.SIGINT)
        running.wait_for("sending signal 'SIGINT'")
        running.signal(signal.SIGINT)
        answer = running.finish()
    assert "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT) again, ignoring..." in answer.said
    assert (
        "failed to terminate '5' seconds after receiving 'SIGINT', escalating to 'SIGTERM'" in answer.stdout
    )
    assert "failed to terminate '10.0' seconds after receiving 'SIGTERM'" in answer.stdout


def test_signals_by_event(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        ExecuteProcess(output='screen', name='p', cmd=[
            'sh', '-c', "trap 'echo got; exit 0' USR1; echo up; while :; do sleep 0.05; done"]),
        RegisterEventHandler(OnProcessIO(on_stdout=lambda event: EmitEvent(event=SignalProcess(
            signal_number='SIGUSR1', process_matcher=lambda action: True)) if b'up' in event.text else None)),
        """
    )
    assert answer.of("p-1") == ["up", "got"]
    assert "[INFO] [p-1]: sending signal 'SIGUSR1' to process[p-1]" in answer.said


def test_a_hangup_ends_the_processes(launcher: Launcher) -> None:
    path = launcher.description("ExecuteProcess(cmd=['sleep', '100'])")
    with launcher.started(path) as running:
        pid = running.pid_of("sleep-1")
        running.signal(signal.SIGHUP)
        answer = running.finish()
    assert gone(pid)
    assert "[WARNING] [launch]: told to end (SIGHUP), shutting down" in answer.said
    assert answer.code == -signal.SIGHUP


def test_last_words_of_what_a_process_started(launcher: Launcher) -> None:
    answer = launcher.run(
        "ExecuteProcess(cmd=['sh', '-c', '(sleep 0.1; echo late) & exit 0'], output='screen')",
        before="from launch.child import child\nchild._LAST_WORDS = 30.0",
    )
    assert answer.of("sh-1") == ["late"]
    assert "process has finished cleanly" in answer.said[-1]


def test_nobody_reads(launcher: Launcher) -> None:
    """As with `| head`: the launch ends, without a traceback."""
    path = launcher.description(
        "ExecuteProcess(cmd=['sh', '-c', 'while :; do echo x; sleep 0.02; done'], output='screen')"
    )
    with launcher.started(path) as running:
        pid = running.pid_of("sh-1")
        assert alive(pid)
        assert running.process.stdout and running.process.stderr
        running.process.stdout.close()
        assert running.process.stderr.read() == ""
        running.process.wait(timeout=20)
        assert gone(pid)


@pytest.mark.slow
def test_many_processes_keep_their_order(launcher: Launcher) -> None:
    answer = launcher.run("*[ExecuteProcess(cmd=['echo', str(i)], output='screen') for i in range(30)]")
    started = [line for line in answer.said if "process started" in line]
    assert [line.split("]")[1] for line in started] == [f" [echo-{i}" for i in range(1, 31)]
    assert all(answer.of(f"echo-{i + 1}") == [str(i)] for i in range(30))


@pytest.mark.slow
def test_much_output_is_complete(launcher: Launcher) -> None:
    answer = launcher.run("ExecuteProcess(cmd=['seq', '20000'], output='screen')")
    assert answer.of("seq-1") == [str(number) for number in range(1, 20001)]
