"""What a command prints."""

from __future__ import annotations

import shlex
import subprocess

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions

_ON_STDERR = ("fail", "ignore", "warn", "capture")


class Command(Substitution):
    """Runs without a shell. `on_stderr`: what to do if it complains: fail, ignore, warn or capture."""

    def __init__(self, command: object, *, on_stderr: object = "fail") -> None:
        self.__command = texts(command)
        self.__on_stderr = texts(on_stderr)

    @property
    def command(self) -> list[Substitution]:
        return self.__command

    @property
    def on_stderr(self) -> list[Substitution]:
        return self.__on_stderr

    def describe(self) -> str:
        return "Command({})".format(" + ".join(sub.describe() for sub in self.__command))

    def perform(self, context: LaunchContext) -> str:
        command = perform_substitutions(context, self.__command)
        on_stderr = self._checked(perform_substitutions(context, self.__on_stderr))
        done = _run(command, on_stderr == "capture")
        _judge(done, command, on_stderr)
        return done.stdout

    @staticmethod
    def _checked(on_stderr: str) -> str:
        if on_stderr not in _ON_STDERR:
            raise SubstitutionFailure(
                f"expected 'on_stderr' to be one of: 'fail', 'ignore', 'warn' or 'capture', got '{on_stderr}'"
            )
        return on_stderr


def _run(command: str, together: bool) -> subprocess.CompletedProcess[str]:
    stderr = subprocess.STDOUT if together else subprocess.PIPE
    try:
        return subprocess.run(
            shlex.split(command), stdout=subprocess.PIPE, stderr=stderr, text=True, check=False
        )
    except (FileNotFoundError, PermissionError) as error:
        raise SubstitutionFailure(f"file not found: {error}") from error


def _judge(done: subprocess.CompletedProcess[str], command: str, on_stderr: str) -> None:
    if done.returncode != 0:
        raise SubstitutionFailure(_told("executed command failed.", command, done))
    if not done.stderr or on_stderr == "ignore":
        return
    text = _told("executed command showed stderr output.", command, done)
    if on_stderr == "fail":
        raise SubstitutionFailure(text)
    from launch.logging import get_logger

    get_logger("launch").warning(text)


def _told(what: str, command: str, done: subprocess.CompletedProcess[str]) -> str:
    complaint = f"\nCaptured stderr output: {done.stderr}" if done.stderr else ""
    return f"{what} Command: {command}{complaint}"
