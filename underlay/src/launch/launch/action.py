"""What a launch file asks to be done."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.condition import Condition
    from launch.launch_context import LaunchContext
    from launch.substitution import Substitution


class Action(LaunchDescriptionEntity):
    """Does its work in `execute`, unless its condition says no."""

    def __init__(self, *, condition: Condition | None = None) -> None:
        self.__condition = condition

    @property
    def condition(self) -> Condition | None:
        return self.__condition

    @classmethod
    def parse(cls, entity: Any, parser: Any) -> tuple[type[Action], dict[str, Any]]:
        """What every tag of a launch file in XML or YAML may say; for actions that are exposed there."""
        return cls, {"condition": parser.parse_condition(entity)}

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        if self.__condition is not None and not self.__condition.evaluate(context):
            return None
        try:
            return self.execute(context)
        finally:
            self._announce_completion(context)

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do it; what is returned comes next."""
        return None

    def _announce_completion(self, context: LaunchContext) -> None:
        from launch.events.execution_complete import ExecutionComplete

        event = ExecutionComplete(action=self)

        def tell(_: object = None) -> None:
            if context.would_handle_event(event):
                context.emit_event_sync(event)

        future = self.get_asyncio_future()
        if future is None:
            tell()
        else:
            future.add_done_callback(tell)


def texts(value: object) -> list[Substitution]:
    """Whatever a launch file may write for a text."""
    from launch.utilities import normalize_to_list_of_substitutions

    return normalize_to_list_of_substitutions(value)


def entities_of(value: object) -> list[LaunchDescriptionEntity]:
    """One entity, several, or none, as a list."""
    if value is None:
        return []
    if isinstance(value, LaunchDescriptionEntity):
        return [value]
    if isinstance(value, Iterable):
        return list(value)
    raise TypeError(f"expected actions, got {value!r}")
