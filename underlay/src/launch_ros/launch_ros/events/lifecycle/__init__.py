"""Events about managed nodes."""

from __future__ import annotations

from launch._lazy import lazily

_INSTEAD = "managed nodes need an installed ROS 2 (sudo apt install ros-jazzy-launch-ros)"
_ABSENT = {name: _INSTEAD for name in ("ChangeState", "StateTransition")}
__all__ = list(_ABSENT)
__getattr__ = lazily(__name__, {}, _ABSENT)
