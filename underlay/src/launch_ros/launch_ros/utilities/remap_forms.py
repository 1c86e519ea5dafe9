"""Remappings as pairs of substitutions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.action import texts
from launch.substitution import Substitution

RemapRule = tuple[list[Substitution], list[Substitution]]


def normalize_remap_rule(remap_rule: Any) -> RemapRule:
    if not isinstance(remap_rule, tuple | list) or len(remap_rule) != 2:
        raise TypeError(f"expected a remapping as a pair ('from', 'to'), got {remap_rule!r}")
    return texts(remap_rule[0]), texts(remap_rule[1])


def normalize_remap_rules(remap_rules: Iterable[Any]) -> list[RemapRule]:
    return [normalize_remap_rule(rule) for rule in remap_rules]
