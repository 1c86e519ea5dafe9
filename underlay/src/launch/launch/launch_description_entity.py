"""Whatever can stand in a launch description."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import asyncio

    from launch.launch_context import LaunchContext


class LaunchDescriptionEntity:
    """Visited by the launch service; what a visit returns is visited next."""

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        raise NotImplementedError(f"{type(self).__name__} does not say what happens at a visit")

    def describe(self) -> str:
        return repr(self)

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """What it brings along for sure."""
        return []

    def describe_conditional_sub_entities(self) -> list[tuple[str, list[LaunchDescriptionEntity]]]:
        """What it brings along under a condition, which the text tells."""
        return []

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Done when it is: the launch service goes on for as long."""
        return None
