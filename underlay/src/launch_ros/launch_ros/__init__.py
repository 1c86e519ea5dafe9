"""What launch files say about ROS: nodes, their packages, names, parameters and remappings."""

from __future__ import annotations

from launch._lazy import lazily

_MODULES = (
    "actions", "descriptions", "event_handlers", "events", "frontend", "parameter_descriptions",
    "parameters_type", "remap_rule_type", "substitutions", "utilities",
)  # fmt: skip

__all__ = list(_MODULES)
__getattr__ = lazily(__name__, {name: name for name in _MODULES})
