"""Small things that actions and substitutions share."""

from __future__ import annotations

from launch.utilities.class_tools import is_a, is_a_subclass
from launch.utilities.ensure_argument_type import ensure_argument_type
from launch.utilities.normalize import normalize_to_list_of_entities, normalize_to_list_of_substitutions
from launch.utilities.perform import perform_substitutions
from launch.utilities.visit import visit_all_entities_and_collect_futures

__all__ = [
    "ensure_argument_type",
    "is_a",
    "is_a_subclass",
    "normalize_to_list_of_entities",
    "normalize_to_list_of_substitutions",
    "perform_substitutions",
    "visit_all_entities_and_collect_futures",
]
