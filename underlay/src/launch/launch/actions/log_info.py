"""Tell the user something."""

from __future__ import annotations

import logging
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class Log(Action):
    """`level` as Python's logging has it, by name or by number."""

    def __init__(self, *, msg: object, level: str | int = logging.INFO, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__msg = texts(msg)
        self.__level = logging.getLevelName(level.upper()) if isinstance(level, str) else level

    @property
    def msg(self) -> list[Substitution]:
        return self.__msg

    @property
    def level(self) -> int:
        return int(self.__level)

    def execute(self, context: LaunchContext) -> None:
        from launch.logging import get_logger

        get_logger("launch.user").log(self.level, perform_substitutions(context, self.__msg))


class LogInfo(Log):
    def __init__(self, *, msg: object, **kwargs: Any) -> None:
        super().__init__(msg=msg, level=logging.INFO, **kwargs)


class LogDebug(Log):
    def __init__(self, *, msg: object, **kwargs: Any) -> None:
        super().__init__(msg=msg, level=logging.DEBUG, **kwargs)


class LogWarning(Log):
    def __init__(self, *, msg: object, **kwargs: Any) -> None:
        super().__init__(msg=msg, level=logging.WARNING, **kwargs)


class LogError(Log):
    def __init__(self, *, msg: object, **kwargs: Any) -> None:
        super().__init__(msg=msg, level=logging.ERROR, **kwargs)
