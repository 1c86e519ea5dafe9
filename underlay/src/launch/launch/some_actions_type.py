"""One action, or several."""

from collections.abc import Iterable

from launch.action import Action

SomeActionsType = Action | Iterable[Action]
SomeActionsType_types_tuple = (Action, Iterable)
