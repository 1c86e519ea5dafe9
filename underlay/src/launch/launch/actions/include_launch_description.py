"""Take in another launch file."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from launch.action import Action, texts
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource
from launch.utilities import perform_substitutions

_PLACES = ("current_launch_file_path", "current_launch_file_directory")


class IncludeLaunchDescription(Action):
    """`launch_arguments` are pairs of name and value; they stay set after the include."""

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | object,
        *,
        launch_arguments: Iterable[tuple[object, object]] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__source = _source(launch_description_source)
        self.__arguments = [(texts(name), texts(value)) for name, value in launch_arguments or ()]

    @property
    def launch_description_source(self) -> LaunchDescriptionSource:
        return self.__source

    @property
    def launch_arguments(self) -> list[tuple[Any, Any]]:
        return list(self.__arguments)

    def describe(self) -> str:
        return f"IncludeLaunchDescription({self.__source.location})"

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        description = self.__source.try_get_launch_description_without_context()
        return [] if description is None else [description]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        description = self.__source.get_launch_description(context)
        before = {name: context.get_locals_as_dict().get(name) for name in _PLACES}
        self._enter(context)
        self._check_arguments(context, description)
        setting = [SetLaunchConfiguration(name, value) for name, value in self.__arguments]
        return [*setting, description, OpaqueFunction(function=_go_back, args=[before])]

    def _enter(self, context: LaunchContext) -> None:
        path = Path(self.__source.location).absolute()
        folder = str(path.parent) if self.__source.location else ""
        context.extend_globals(dict(zip(_PLACES, (str(path), folder), strict=True)))

    def _check_arguments(self, context: LaunchContext, description: LaunchDescription) -> None:
        """Every argument without a default value must be given, here or in an include below."""
        mine = [perform_substitutions(context, name) for name, _ in self.__arguments]
        for argument, includes in description.get_launch_arguments_with_include_launch_description_actions():
            if argument._conditionally_included or argument.default_value is not None:
                continue
            given = mine + [name for include in includes for name in include._plain_argument_names()]
            if argument.name not in given and argument.name not in context.launch_configurations:
                raise RuntimeError(
                    f"Included launch description missing required argument '{argument.name}' "
                    f"(description: '{argument.description}'), given: [{', '.join(given)}]"
                )

    def _plain_argument_names(self) -> list[str]:
        from launch.substitutions.text_substitution import TextSubstitution

        plain = (
            name for name, _ in self.__arguments if all(isinstance(sub, TextSubstitution) for sub in name)
        )
        return ["".join(sub.text for sub in name) for name in plain]  # type: ignore[attr-defined]


def _source(given: Any) -> LaunchDescriptionSource:
    if isinstance(given, LaunchDescriptionSource):
        return given
    from launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource

    return AnyLaunchDescriptionSource(given)


def _go_back(context: LaunchContext, before: dict[str, str | None]) -> None:
    context.extend_globals(before)
