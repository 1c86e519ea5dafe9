"""Names that only the real packages have: importing one is not an error, using one tells what to do.

A launch file that never comes to use it, because a condition says so, then runs as it is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.action import Action

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class NotOfferedError(RuntimeError):
    """Says what is not offered here, and what to install."""

    def __init__(self, name: str, instead: str) -> None:
        super().__init__(f"{name} is not offered here: {instead}")


class AbsentAction(Action):
    """Takes any arguments; refused when its turn comes."""

    refusal = ("", "")

    def __init__(self, *args: Any, condition: Any = None, **kwargs: Any) -> None:
        super().__init__(condition=condition)

    def execute(self, context: LaunchContext) -> None:
        raise NotOfferedError(*self.refusal)


class AbsentDescription:
    """Takes any arguments: what is given it is refused."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        pass


class Absent:
    """Refused at once."""

    refusal = ("", "")

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        raise NotOfferedError(*self.refusal)


def stand_in(package: str, name: str, instead: str) -> type:
    """A class for `name` of `package`; `instead` says what to do."""
    kinds: dict[str, type] = {"actions": AbsentAction, "descriptions": AbsentDescription}
    kind = kinds.get(package.rpartition(".")[2], Absent)
    return type(name, (kind,), {"refusal": (f"{package}.{name}", instead), "__module__": package})
