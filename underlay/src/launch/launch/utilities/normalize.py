"""The many ways a launch file may write a text or some entities, made one."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from launch.action import entities_of
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.substitution import Substitution


def normalize_to_list_of_substitutions(subs: object) -> list[Substitution]:
    """A text, a path, a substitution, or some of them one after the other, as substitutions."""
    if isinstance(subs, str | Path | Substitution):
        return [_one(subs)]
    if isinstance(subs, Iterable):
        return [_one(item) for item in subs]
    raise _refusal(subs)


def _one(item: object) -> Substitution:
    from launch.substitutions.text_substitution import TextSubstitution

    if isinstance(item, Substitution):
        return item
    if isinstance(item, str | Path):
        return TextSubstitution(text=str(item))
    raise _refusal(item)


def _refusal(item: object) -> TypeError:
    return TypeError(
        f"Failed to normalize given item of type '{type(item)}', when only 'str' or "
        "'launch.Substitution' were expected."
    )


def normalize_to_list_of_entities(entities: object) -> list[LaunchDescriptionEntity]:
    """One entity or nested lists of them, flat."""
    flat: list[LaunchDescriptionEntity] = []
    for entity in entities_of(entities):
        flat.extend([entity] if isinstance(entity, LaunchDescriptionEntity) else entities_of(entity))
    return flat
