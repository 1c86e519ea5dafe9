"""What a launch file returns: entities, in the order in which they are visited."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities.declared_arguments import Declared, declared_arguments

if TYPE_CHECKING:
    from launch.actions import DeclareLaunchArgument
    from launch.launch_context import LaunchContext


class LaunchDescription(LaunchDescriptionEntity):
    """A list of entities; conditions of them are asked when their turn comes."""

    def __init__(
        self,
        initial_entities: Iterable[LaunchDescriptionEntity] | None = None,
        *,
        deprecated_reason: str | None = None,
    ) -> None:
        self.__entities = list(initial_entities) if initial_entities is not None else []
        for entity in self.__entities:
            _require_entity(entity)
        self.__deprecated_reason = deprecated_reason

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        if self.__deprecated_reason is not None:
            _warn_deprecated(self.__deprecated_reason, context)
        return self.__entities

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return self.__entities

    @property
    def entities(self) -> list[LaunchDescriptionEntity]:
        return self.__entities

    @property
    def deprecated(self) -> bool:
        return self.__deprecated_reason is not None

    @property
    def deprecated_reason(self) -> str | None:
        return self.__deprecated_reason

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        self.__entities.append(entity)

    def add_action(self, action: LaunchDescriptionEntity) -> None:
        self.__entities.append(action)

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[DeclareLaunchArgument]:
        """Every argument declared in here, also below groups and included files; each name once."""
        first: dict[str, DeclareLaunchArgument] = {}
        for argument, _ in self.get_launch_arguments_with_include_launch_description_actions(
            conditional_inclusion
        ):
            first.setdefault(argument.name, argument)
        return list(first.values())

    def get_launch_arguments_with_include_launch_description_actions(
        self, conditional_inclusion: bool = False
    ) -> list[Declared]:
        """The arguments, each with the includes that it lies below."""
        return list(declared_arguments(self.__entities, (), conditional_inclusion))


def _require_entity(entity: object) -> None:
    if not isinstance(entity, LaunchDescriptionEntity):
        kind = type(entity).__name__
        raise TypeError(f"LaunchDescription expected a list of actions, but found {entity!r} ({kind}) in it")


def _warn_deprecated(reason: str, context: LaunchContext) -> None:
    from launch.logging import get_logger

    place = context.get_locals_as_dict().get("current_launch_file_path", "launch description")
    get_logger("launch").warning(f"{place} is deprecated: {reason}")
