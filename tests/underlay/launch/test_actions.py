"""Launch files of many shapes, as they are written for the real launch."""

from __future__ import annotations

import pytest

from tests.underlay.launch.machine import Launcher


def test_arguments_groups_conditions_and_functions(launcher: Launcher) -> None:
    before = """
def opaque(context, word, *, more):
    return [LogInfo(msg=[word, ' ', more, ' ', LaunchConfiguration('a').perform(context)])]
"""
    answer = launcher.run(
        """
        DeclareLaunchArgument('a', default_value='x', description='An argument'),
        DeclareLaunchArgument('b', default_value=[LaunchConfiguration('a'), '-b']),
        LogInfo(msg=['a=', LaunchConfiguration('a'), ' b=', LaunchConfiguration('b')]),
        OpaqueFunction(function=opaque, args=['word'], kwargs={'more': 'more'}),
        GroupAction([SetLaunchConfiguration('a', 'inner'), LogInfo(msg=LaunchConfiguration('a'))]),
        LogInfo(msg=LaunchConfiguration('a')),
        GroupAction(scoped=False, actions=[SetLaunchConfiguration('a', 'left')]),
        LogInfo(msg=LaunchConfiguration('a')),
        GroupAction([LogInfo(msg=LaunchConfiguration('a', default='none')),
                     LogInfo(msg=LaunchConfiguration('c'))],
                    forwarding=False, launch_configurations={'c': 'given'}),
        UnsetLaunchConfiguration('a'),
        LogInfo(msg=LaunchConfiguration('a', default='unset')),
        LogInfo(msg='yes', condition=IfCondition('true')),
        LogInfo(msg='no', condition=IfCondition('0')),
        LogInfo(msg='unless', condition=UnlessCondition(PythonExpression(['1 ', '> 2']))),
        LogInfo(msg='equal', condition=LaunchConfigurationEquals('b', 'y-b')),
        LogInfo(msg='different', condition=LaunchConfigurationNotEquals('b', 'y-b')),
        GroupAction([LogInfo(msg='never')], condition=IfCondition('False')),
        """,
        "a:=y",
        before=before,
    )
    assert answer.logged == [
        "a=y b=y-b", "word more y", "inner", "y", "left", "none", "given", "unset", "yes", "unless", "equal",
    ]  # fmt: skip
    assert answer.code == 0


def test_environment(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        SetEnvironmentVariable('ONE', '1'),
        GroupAction([SetEnvironmentVariable('ONE', 'inner'), LogInfo(msg=EnvironmentVariable('ONE'))]),
        AppendEnvironmentVariable('ONE', '2'),
        AppendEnvironmentVariable('ONE', '0', prepend=True, separator=','),
        LogInfo(msg=EnvironmentVariable('ONE')),
        ExecuteProcess(cmd=['sh', '-c', 'echo $ONE $TWO'], output='screen',
                       additional_env={'TWO': ['t', 'wo']}),
        ExecuteProcess(cmd=['/usr/bin/env'], env={'ONLY': 'this'}, output='screen'),
        UnsetEnvironmentVariable('ONE'),
        LogInfo(msg=EnvironmentVariable('ONE', default_value='unset')),
        """
    )
    assert answer.logged == ["inner", "0,1:2", "unset"]
    assert answer.of("sh-1") == ["0,1:2 two"]
    assert answer.of("env-2") == ["ONLY=this"]


def test_include_passes_arguments_on(launcher: Launcher) -> None:
    launcher.description(
        """
        DeclareLaunchArgument('who'),
        DeclareLaunchArgument('how', default_value='kindly'),
        LogInfo(msg=[LaunchConfiguration('who'), ' ', LaunchConfiguration('how')]),
        LogInfo(msg=PathJoinSubstitution([ThisLaunchFileDir(), 'x', '..'])),
        LogInfo(msg=ThisLaunchFile()),
        """,
        name="below/inner_launch.py",
    )
    answer = launcher.run(
        """
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/below/inner_launch.py']),
            launch_arguments={'who': 'me'}.items()),
        IncludeLaunchDescription(
            PathJoinSubstitution([ThisLaunchFileDir(), 'below', 'inner_launch.py']),
            launch_arguments=[('who', ['y', 'ou']), ('how', 'again')],
            condition=IfCondition('true')),
        LogInfo(msg=ThisLaunchFileDir()),
        """
    )
    below = str(launcher.cwd / "below")
    inner = [f"{below}/x/..", f"{below}/inner_launch.py"]
    assert answer.logged == ["me kindly", *inner, "you again", *inner, str(launcher.cwd)]


def test_include_misses_an_argument(launcher: Launcher) -> None:
    launcher.description("DeclareLaunchArgument('who')", name="inner_launch.py")
    answer = launcher.run(
        "IncludeLaunchDescription(AnyLaunchDescriptionSource([ThisLaunchFileDir(), '/inner_launch.py']),"
        " launch_arguments=[('other', 'x')])"
    )
    assert answer.said == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Included launch description "
        "missing required argument 'who' (description: 'no description given'), given: [other]"
    ]
    assert answer.code == 1


@pytest.mark.slow
def test_timers_and_coroutines(launcher: Launcher) -> None:
    before = """
import asyncio
async def later(context, word):
    await asyncio.sleep(0.05)
    context.emit_event_sync(ShutdownProcess(process_matcher=lambda action: True))
"""
    answer = launcher.run(
        """
        TimerAction(period=0.3, actions=[LogInfo(msg='second'), Shutdown(reason='enough')]),
        TimerAction(period='0.1', actions=[LogInfo(msg='first')]),
        TimerAction(period=100.0, actions=[LogInfo(msg='never')]),
        ExecuteProcess(cmd=['sleep', '100']),
        OpaqueCoroutine(coroutine=later, args=['w']),
        """,
        before=before,
    )
    assert answer.logged == ["first", "second"]
    assert "[INFO] [sleep-1]: sending signal 'SIGINT' to process[sleep-1]" in answer.said
    assert answer.code == 0


def test_loops(launcher: Launcher) -> None:
    answer = launcher.run(
        """
        ForLoop('3', function=lambda i: [LogInfo(msg=str(i))]),
        ForEach('{name: a, x: 1};{name: b, x: 2}', function=lambda name, x: [LogInfo(msg=f'{name}{x}')]),
        """
    )
    assert answer.logged == ["0", "1", "2", "a1", "b2"]


def test_levels_of_log(launcher: Launcher) -> None:
    answer = launcher.run("LogWarning(msg='careful'), LogError(msg='bad'), LogDebug(msg='hidden')")
    assert answer.said == ["[WARNING] [launch.user]: careful", "[ERROR] [launch.user]: bad"]


def test_a_choice_that_is_none(launcher: Launcher) -> None:
    answer = launcher.run("DeclareLaunchArgument('mode', choices=['a', 'b'], default_value='a')", "mode:=z")
    assert answer.said == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
        "Argument \"mode\" provided value \"z\" is not valid. Valid options are: ['a', 'b']"
    ]
    assert answer.code == 1


def test_a_condition_that_is_neither(launcher: Launcher) -> None:
    answer = launcher.run("LogInfo(msg='x', condition=IfCondition('perhaps'))")
    assert (
        "invalid condition expression, expected one of 'true, 1' (true) or 'false, 0' (false)"
        in answer.stdout
    )
    assert answer.code == 1


@pytest.mark.slow
def test_an_exception_ends_what_runs(launcher: Launcher) -> None:
    answer = launcher.run(
        "RegisterEventHandler(OnProcessStart(on_start=["
        "TimerAction(period=0.01, actions=[OpaqueFunction(function=lambda context: 1 / 0)])])),"
        "ExecuteProcess(cmd=['sleep', '100'])"
    )
    assert answer.said[1:] == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): division by zero",
        "[INFO] [sleep-1]: sending signal 'SIGINT' to process[sleep-1]",
        answer.said[-1],
    ]
    assert "process has died" in answer.said[-1]
    assert answer.code == 1


def test_an_exception_in_the_launch_file(launcher: Launcher) -> None:
    answer = launcher(launcher.file("import os\n\ndef generate_launch_description():\n    return nosuch\n"))
    assert answer.said == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
        "Caught multiple exceptions when trying to load file of format [py]:",
        " - NameError: name 'nosuch' is not defined",
        " - InvalidFrontendLaunchFileError: "
        "The launch file may have a syntax error, or its format is unknown",
    ]
    assert (answer.code, answer.stderr) == (1, "")


def test_debug_shows_the_traceback(launcher: Launcher) -> None:
    path = launcher.description("OpaqueFunction(function=lambda context: 1 / 0)")
    answer = launcher("-d", path)
    assert "ZeroDivisionError: division by zero" in answer.stdout
    assert "[INFO] [launch]: Default logging verbosity is set to DEBUG" in answer.stdout


def test_nothing_is_written_beside_a_launch_file(launcher: Launcher) -> None:
    launcher.run("LogInfo(msg='x')")
    assert [path.name for path in launcher.cwd.iterdir()] == ["test_launch.py"]
