"""Going through entities, depth first: what a visit returns comes before the next in the list."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

Visited = list[tuple[LaunchDescriptionEntity, asyncio.Future]]  # type: ignore[type-arg]


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> Visited:
    """Visit an entity and all that come of it; those that take time, with their futures."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    visited: Visited = [] if future is None else [(entity, future)]
    for each in following or ():
        visited += visit_all_entities_and_collect_futures(each, context)
    return visited
