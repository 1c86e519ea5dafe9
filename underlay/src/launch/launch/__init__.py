"""Launch: describe processes, start them, watch them, react to what happens, and end them."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "Action": "action",
    "Condition": "condition",
    "Event": "event",
    "EventHandler": "event_handler",
    "InvalidLaunchFileError": "invalid_launch_file_error",
    "LaunchContext": "launch_context",
    "LaunchDescription": "launch_description",
    "LaunchDescriptionEntity": "launch_description_entity",
    "LaunchDescriptionSource": "launch_description_source",
    "LaunchIntrospector": "launch_introspector",
    "LaunchService": "launch_service",
    "SomeActionsType": "some_actions_type",
    "SomeEntitiesType": "some_entities_type",
    "SomeSubstitutionsType": "some_substitutions_type",
    "SomeSubstitutionsType_types_tuple": "some_substitutions_type",
    "Substitution": "substitution",
}
_MODULES = (
    "actions", "conditions", "descriptions", "event_handlers", "events", "frontend",
    "launch_description_sources", "logging", "substitutions", "utilities",
)  # fmt: skip

__all__ = list(_NAMES)
__getattr__ = lazily(__name__, {**_NAMES, **{name: name for name in _MODULES}})
