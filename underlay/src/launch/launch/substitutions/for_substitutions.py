"""The values of a loop in a launch file in XML or YAML."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitutions.looked_up import LookedUp


class ForEachVar(LookedUp):
    """`default_value` is taken in rounds that do not name it."""

    _missing = "no value '{}' in this round of the loop"

    def __init__(self, name: object, *, default_value: object | None = None) -> None:
        super().__init__(name, default_value)

    def _find(self, context: LaunchContext, name: str) -> object | None:
        values: dict[str, object] = context.get_locals_as_dict().get("loop_values", {})
        return values.get(name)


class ForLoopIndex(ForEachVar):
    """The number of the round, from 0 on."""

    def __init__(self, name: object) -> None:
        super().__init__(name)
