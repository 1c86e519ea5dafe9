"""Programs that use the launch service themselves, and imports by their full names."""

from __future__ import annotations

import subprocess

import pytest

from tests.underlay.launch.machine import TIMEOUT, Launcher

DESCRIPTION = """
import asyncio, os, sys, threading
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart
sleeps = ExecuteProcess(cmd=['sleep', '100'], name='s')
description = LaunchDescription([sleeps])
async def until_started(service):
    started = asyncio.Event()
    description.add_action(RegisterEventHandler(OnProcessStart(on_start=lambda *_: started.set())))
    service.include_launch_description(description)
    task = asyncio.create_task(service.run_async())
    await started.wait()
    return task
"""
MODULES = """
from launch.action import Action
from launch.actions.declare_launch_argument import DeclareLaunchArgument
from launch.actions.execute_process import ExecuteProcess
from launch.condition import Condition
from launch.conditions.if_condition import IfCondition
from launch.event import Event
from launch.event_handler import EventHandler
from launch.event_handlers.on_process_exit import OnProcessExit
from launch.events import Shutdown, matches_action
from launch.events.process import ProcessExited, ProcessIO, ProcessStarted
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.python_launch_description_source import PythonLaunchDescriptionSource
from launch.launch_introspector import LaunchIntrospector
from launch.launch_service import LaunchService
from launch.logging import get_logger, launch_config
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.path_join_substitution import PathJoinSubstitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from launch_ros.actions.node import Node
from launch_ros.descriptions import ParameterFile, ParameterValue
from launch_ros.parameters_type import SomeParameters
from launch_ros.remap_rule_type import SomeRemapRules
from launch_ros.substitutions.find_package import FindPackageShare
from launch_ros.utilities import evaluate_parameters, normalize_parameters, normalize_remap_rules
import launch, launch_ros
assert launch.actions.TimerAction and launch.substitutions.Command and launch.conditions.UnlessCondition
assert launch.LaunchDescription is LaunchDescription and launch_ros.actions.Node is Node
assert launch.event_handlers.OnShutdown and launch.events.process.SignalProcess and launch.logging.get_logger
assert callable(evaluate_parameters) and callable(normalize_parameters) and callable(normalize_remap_rules)
"""


def _python(launcher: Launcher, source: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [launcher.python, "-W", "error", "-c", source],
        env=launcher.environment,
        cwd=launcher.cwd,
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
        check=False,
    )


def test_names_of_modules(launcher: Launcher) -> None:
    done = _python(launcher, MODULES)
    assert (done.returncode, done.stderr) == (0, "")


def test_run_returns_and_can_be_run_again(launcher: Launcher) -> None:
    done = _python(
        launcher,
        DESCRIPTION
        + """
service = LaunchService()
for text in ('one', 'two'):
    service.include_launch_description(LaunchDescription([LogInfo(msg=text)]))
    assert service.run() == 0
""",
    )
    assert done.stderr == ""
    assert done.stdout.splitlines()[2:] == ["[INFO] [launch.user]: one", "[INFO] [launch.user]: two"]


def test_in_a_thread_with_shutdown_from_outside(launcher: Launcher) -> None:
    done = _python(
        launcher,
        DESCRIPTION
        + """
started = threading.Event()
description.add_action(RegisterEventHandler(OnProcessStart(on_start=lambda *_: started.set())))
service = LaunchService(noninteractive=True)
service.include_launch_description(description)
thread = threading.Thread(target=service.run)
thread.start()
assert started.wait(20)
service.shutdown()
thread.join(20)
assert not thread.is_alive()
""",
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "[INFO] [s-1]: sending signal 'SIGINT' to process[s-1]" in done.stdout


@pytest.mark.slow
def test_within_a_loop_that_is_there(launcher: Launcher) -> None:
    done = _python(
        launcher,
        DESCRIPTION
        + """
async def main():
    service = LaunchService(noninteractive=True)
    task = await until_started(service)
    service.shutdown()
    return await task
assert asyncio.run(main()) == 0
""",
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "process has died" in done.stdout


@pytest.mark.slow
def test_cancelling_leaves_no_process_behind(launcher: Launcher) -> None:
    done = _python(
        launcher,
        DESCRIPTION
        + """
from launch import LaunchDescription
async def main():
    task = await until_started(LaunchService())
    pid = sleeps.process_details['pid']
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)
    return pid
pid = asyncio.run(main())
try:
    os.waitpid(pid, 0)
except ChildProcessError:
    pass
try:
    os.kill(pid, 0)
except ProcessLookupError:
    print('gone')
""",
    )
    assert "gone" in done.stdout, done
