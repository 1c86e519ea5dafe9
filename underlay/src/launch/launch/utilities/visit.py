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
    visited: Visited = []
    visit_all(entity, context, visited)
    return visited


def visit_all(entity: LaunchDescriptionEntity, context: LaunchContext, visited: Visited) -> None:
    """The same; what an exception leaves undone does not hide from `visited` what was begun before."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    if future is not None:
        visited.append((entity, future))
    for each in following or ():
        visit_all(each, context, visited)
