"""From the tags of a launch file to actions."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path
from typing import Any

from launch.action import Action
from launch.frontend.entity import Entity
from launch.frontend.expose import action_parsers, load_extensions
from launch.frontend.parse_substitution import parse_substitution
from launch.launch_description import LaunchDescription
from launch.substitution import Substitution

ParsedAction = tuple[Callable[..., Action], dict[str, Any]]
TagParser = Callable[[Entity, Any], ParsedAction]


class Parser:
    """Handed to what parses a tag, together with the tag."""

    def parse_description(self, entity: Entity) -> LaunchDescription:
        if entity.type_name != "launch":
            raise RuntimeError("Expected 'launch' as root tag")
        entity.get_attr("version", data_type=None, optional=True)
        reason = entity.get_attr("deprecated", optional=True)
        actions = [self.parse_action(child) for child in entity.children]
        entity.assert_entity_completely_parsed()
        return LaunchDescription(actions, deprecated_reason=reason)

    def parse_action(self, entity: Entity) -> Action:
        """Raises RuntimeError for an unknown tag, and ValueError for what a tag does not have."""
        kind, kwargs = self._parser_of(entity.type_name)(entity, self)
        kwargs.setdefault("condition", self.parse_condition(entity))
        entity.assert_entity_completely_parsed()
        return kind(**kwargs)

    def parse_condition(self, entity: Entity) -> Any:
        """What the attributes `if` and `unless` say; None if neither is there."""
        from launch.conditions import IfCondition, UnlessCondition

        yes = entity.get_attr("if", optional=True)
        no = entity.get_attr("unless", optional=True)
        if yes is not None and no is not None:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        if yes is not None:
            return IfCondition(self.parse_substitution(yes))
        return None if no is None else UnlessCondition(self.parse_substitution(no))

    def parse_substitution(self, value: str) -> list[Substitution]:
        return parse_substitution(value)

    def parse_if_substitutions(self, value: Any) -> Any:
        """Texts, also in a list, as substitutions; anything else as it is."""
        if isinstance(value, str):
            return self.parse_substitution(value)
        return [self.parse_if_substitutions(item) for item in value] if isinstance(value, list) else value

    def escape_characters(self, value: str) -> str:
        return value.replace("$", "\\$")

    def _parser_of(self, tag: str) -> TagParser:
        from launch.frontend.tags import TAGS

        for known in (TAGS, _tags_of_ros(), action_parsers):
            if tag in known:
                return known[tag]
        load_extensions()
        if tag not in action_parsers:
            raise RuntimeError(f"Unrecognized entity of the type: {tag}")
        return action_parsers[tag]


def _tags_of_ros() -> dict[str, TagParser]:
    if importlib.util.find_spec("launch_ros") is None:
        return {}
    module = importlib.import_module("launch_ros.frontend")
    tags: dict[str, TagParser] = module.TAGS
    return tags


def load_description(load: Callable[[Path], Entity], path: str) -> LaunchDescription:
    return Parser().parse_description(load(Path(path)))
