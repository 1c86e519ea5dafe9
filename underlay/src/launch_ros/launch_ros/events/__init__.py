"""Events about ROS."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {"lifecycle": "lifecycle", "matchers": "matchers", "matches_node_name": "matchers"}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
