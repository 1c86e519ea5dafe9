"""Handlers of events about ROS."""

from __future__ import annotations

from launch._lazy import lazily

_ABSENT = {
    "OnStateTransition": "managed nodes need an installed ROS 2 (sudo apt install ros-jazzy-launch-ros)"
}
__all__ = list(_ABSENT)
__getattr__ = lazily(__name__, {}, _ABSENT)
