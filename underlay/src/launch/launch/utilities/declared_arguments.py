"""The arguments that entities declare, found without running anything."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription

    Declared = tuple[DeclareLaunchArgument, list[IncludeLaunchDescription]]
else:
    Declared = tuple


def declared_arguments(
    entities: Iterable[LaunchDescriptionEntity], above: tuple[LaunchDescriptionEntity, ...], conditional: bool
) -> Iterator[Declared]:
    """Depth first. `conditional` arguments lie below something that may not happen."""
    for entity in entities:
        yield from _declared_by(entity, above, conditional)


def _declared_by(
    entity: LaunchDescriptionEntity, above: tuple[LaunchDescriptionEntity, ...], conditional: bool
) -> Iterator[Declared]:
    from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription

    if isinstance(entity, DeclareLaunchArgument):
        entity._conditionally_included = conditional or entity.condition is not None
        yield entity, list(above)  # type: ignore[misc]
        return
    below = (*above, entity) if isinstance(entity, IncludeLaunchDescription) else above
    maybe = conditional or getattr(entity, "condition", None) is not None
    yield from declared_arguments(entity.describe_sub_entities(), below, maybe)
    for _, some in entity.describe_conditional_sub_entities():
        yield from declared_arguments(some, below, True)
