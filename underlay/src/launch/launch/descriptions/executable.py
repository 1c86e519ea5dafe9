"""A program, its arguments, its folder and its environment."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.launch_configuration import LaunchConfiguration
from launch.utilities import perform_substitutions

if TYPE_CHECKING:
    from launch.action import Action

_numbers = itertools.count(1)  # processes of one launch are numbered through


class Executable:
    """As it is written in a launch file; `prepare` finds out what that means in a launch."""

    def __init__(
        self,
        *,
        cmd: Iterable[object],
        prefix: object | None = None,
        name: object | None = None,
        cwd: object | None = None,
        env: Any = None,
        additional_env: Any = None,
        arguments: Iterable[object] | None = None,
    ) -> None:
        self.__cmd = [texts(part) for part in cmd] + [texts(part) for part in arguments or ()]
        self.__prefix = texts(LaunchConfiguration("launch-prefix", default="") if prefix is None else prefix)
        self.__filter = (
            texts(LaunchConfiguration("launch-prefix-filter", default="")) if prefix is None else None
        )
        self.__name = None if name is None else texts(name)
        self.__cwd = None if cwd is None else texts(cwd)
        self.__env = _pairs(env)
        self.__additional_env = _pairs(additional_env)
        self.__arguments = arguments
        self.__final_prefix: list[str] = []
        self.__final_cmd: list[str] | None = None
        # Put before the program when it is started, and shown nowhere.
        self.interpreter: list[str] = []
        self.__final_name: str | None = None
        self.__final_cwd: str | None = None
        self.__final_env: dict[str, str] | None = None

    @property
    def name(self) -> list[Substitution] | None:
        return self.__name

    @property
    def prefix(self) -> list[Substitution]:
        return self.__prefix

    @property
    def cmd(self) -> list[list[Substitution]]:
        return self.__cmd

    @property
    def cwd(self) -> list[Substitution] | None:
        return self.__cwd

    @property
    def env(self) -> list[tuple[list[Substitution], list[Substitution]]] | None:
        return self.__env

    @property
    def additional_env(self) -> list[tuple[list[Substitution], list[Substitution]]] | None:
        return self.__additional_env

    @property
    def arguments(self) -> Iterable[object] | None:
        return self.__arguments

    @property
    def final_name(self) -> str | None:
        return self.__final_name

    @property
    def final_cmd(self) -> list[str] | None:
        return self.__final_cmd

    @property
    def final_cwd(self) -> str | None:
        return self.__final_cwd

    @property
    def final_env(self) -> dict[str, str] | None:
        return self.__final_env

    @property
    def started_cmd(self) -> list[str]:
        """What is really started."""
        prefix, cmd = self.__final_prefix, self.__final_cmd or []
        return [*prefix, *self.interpreter, *cmd[len(prefix) :]]

    @property
    def program(self) -> str:
        """The program itself, whatever it is started with."""
        return (self.__final_cmd or [""])[len(self.__final_prefix)]

    def prepare(self, context: LaunchContext, action: Action) -> None:
        cmd = [perform_substitutions(context, part) for part in self.__cmd]
        name = _last_part(cmd[0]) if self.__name is None else perform_substitutions(context, self.__name)
        self.__final_name = f"{name}-{next(_numbers)}"
        self.__final_prefix = self._prefix_for(context, cmd)
        self.__final_cmd = self.__final_prefix + cmd
        self.__final_cwd = None if self.__cwd is None else perform_substitutions(context, self.__cwd)
        self.__final_env = self._environment(context)

    apply_context = prepare

    def _prefix_for(self, context: LaunchContext, cmd: list[str]) -> list[str]:
        prefix = shlex.split(perform_substitutions(context, self.__prefix))
        chosen = perform_substitutions(context, self.__filter) if self.__filter else ""
        return prefix if not chosen or re.match(chosen, _last_part(cmd[0])) else []

    def _environment(self, context: LaunchContext) -> dict[str, str]:
        env = dict(context.environment) if self.__env is None else {}
        for name, value in [*(self.__env or ()), *(self.__additional_env or ())]:
            env[perform_substitutions(context, name)] = perform_substitutions(context, value)
        return env


def _pairs(env: Any) -> list[tuple[list[Substitution], list[Substitution]]] | None:
    return None if env is None else [(texts(name), texts(value)) for name, value in dict(env).items()]


def _last_part(program: str) -> str:
    return program.rpartition("/")[2]
