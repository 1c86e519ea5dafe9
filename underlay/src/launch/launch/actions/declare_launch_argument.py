"""An argument of a launch file."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class DeclareLaunchArgument(Action):
    """Without a default value it must be given. Its value is the launch configuration of its name."""

    def __init__(
        self,
        name: str,
        *,
        default_value: object | None = None,
        description: str | None = None,
        choices: Iterable[str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = name
        self.__default_value = None if default_value is None else texts(default_value)
        self.__choices = None if choices is None else list(choices)
        self.__description = _described(description, self.__choices)
        self._check_default()
        self._conditionally_included = False

    def _check_default(self) -> None:
        from launch.substitutions.text_substitution import TextSubstitution

        if self.__choices is None or self.__default_value is None:
            return
        if not self.__choices:
            raise ValueError(f'Provided choices for the argument "{self.__name}" must not be empty.')
        if not all(isinstance(sub, TextSubstitution) for sub in self.__default_value):
            return
        default = "".join(sub.text for sub in self.__default_value)  # type: ignore[attr-defined]
        if default not in self.__choices:
            raise RuntimeError(
                f'Provided default_value "{default}" is not in provided choices "{self.__choices}".'
            )

    @property
    def name(self) -> str:
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        return self.__default_value

    @property
    def description(self) -> str:
        return self.__description

    @property
    def choices(self) -> list[str] | None:
        return self.__choices

    def execute(self, context: LaunchContext) -> None:
        if self.name not in context.launch_configurations:
            context.launch_configurations[self.name] = self._default(context)
        value = context.launch_configurations[self.name]
        if self.__choices is not None and value not in self.__choices:
            raise RuntimeError(
                f'Argument "{self.name}" provided value "{value}" is not valid. '
                f"Valid options are: {self.__choices}"
            )

    def _default(self, context: LaunchContext) -> str:
        if self.__default_value is None:
            raise RuntimeError(
                f"Required launch argument '{self.name}' (description: '{self.description}') was not provided"
            )
        return perform_substitutions(context, self.__default_value)


def _described(description: str | None, choices: list[str] | None) -> str:
    text = "no description given" if description is None else description
    if choices is None:
        return text
    end = "" if text.rstrip().endswith(".") else "."
    return f"{text}{end} Valid choices are: {choices}"
