"""How many nodes of a name a launch has started."""

from __future__ import annotations

from launch.launch_context import LaunchContext


def count_node(context: LaunchContext, name: str) -> int:
    """One more; how many there are now."""
    counts = context.get_locals_as_dict().get("unique_ros_node_names", {})
    after = {**counts, name: counts.get(name, 0) + 1}
    context.extend_globals({"unique_ros_node_names": after})
    return int(after[name])
