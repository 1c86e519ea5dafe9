"""Start a process from a command line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions.execute_local import ExecuteLocal
from launch.descriptions.executable import Executable
from launch.substitution import Substitution


class ExecuteProcess(ExecuteLocal):
    """`cmd` is a list of arguments, each a text, a substitution or a list of them."""

    def __init__(
        self,
        *,
        cmd: Iterable[object],
        prefix: object | None = None,
        name: object | None = None,
        cwd: object | None = None,
        env: Any = None,
        additional_env: Any = None,
        **kwargs: Any,
    ) -> None:
        executable = Executable(
            cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env
        )
        super().__init__(process_description=executable, **kwargs)

    @property
    def cmd(self) -> Any:
        """The final command line once it is known, what the launch file wrote before."""
        description = self.process_description
        return description.cmd if description.final_cmd is None else description.final_cmd

    @property
    def cwd(self) -> Any:
        description = self.process_description
        return description.cwd if description.final_cwd is None else description.final_cwd

    @property
    def env(self) -> Any:
        description = self.process_description
        return description.env if description.final_env is None else description.final_env

    @property
    def additional_env(self) -> Any:
        return self.process_description.additional_env

    @property
    def prefix(self) -> list[Substitution]:
        return self.process_description.prefix
