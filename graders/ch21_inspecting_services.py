"""Grader of chapter 21: what a learner finds out about the services of a rover."""

from __future__ import annotations

from typing import Any

from course.api import AllOf, Mystery, Number, Text
from lib.following import Answer
from lib.names import for_both, spellings

# The id in the request that the task gives.
ASKED_ID = 42
NEAR = 1e-3
REQUESTS = {
    "nav_msgs/srv/GetPlan": ("start", "goal", "tolerance"),
    "nav_msgs/srv/SetMap": ("map", "initial_pose"),
    "type_description_interfaces/srv/GetTypeDescription": (
        "type_name",
        "type_hash",
        "include_type_sources",
    ),
}
RESPONSES = {
    "nav_msgs/srv/GetPlan": ("plan",),
    "nav_msgs/srv/SetMap": ("success",),
    "type_description_interfaces/srv/GetTypeDescription": (
        "successful",
        "failure_reason",
        "type_description",
        "type_sources",
        "extra_information",
    ),
}
NESTED = ("header", "stamp", "frame_id", "pose", "position", "orientation", "info", "data", "covariance")

RUNG_WITH_FALSE = "That is the response to `data: false`."

mystery = Mystery("21-inspect-services", __file__)


@mystery.words
def words(plan: Any) -> dict[str, object]:
    request = REQUESTS[plan.fields_type]
    return {
        "typed": plan.typed,
        "short_type": plan.type.rpartition("/")[2],
        "two_part_type": plan.type.replace("/srv/", "/"),
        "msg_type": plan.type.replace("/srv/", "/msg/"),
        "fields": plan.fields,
        "fields_type": plan.fields_type,
        "request_field": request[0],
        "response_field": RESPONSES[plan.fields_type][0],
        "request_as_a_list": ", ".join(reversed(request)),
        "owner": plan.owners[plan.fields],
        "sleeper": plan.sleeper,
        "oracle": plan.oracle,
        "x": plan.x(ASKED_ID),
        "x_of_nothing": plan.x(0),
        "y": plan.point[1],
        "bell": plan.bell,
        "word": plan.word,
        "other_word": plan.other_word,
        "chore": plan.chores[0],
        "silent": plan.silent,
        "silent_without_slash": plan.silent.lstrip("/"),
        "wanted": plan.wanted,
        "wanted_without_slash": plan.wanted.lstrip("/"),
    }


@mystery.answers
def answers(plan: Any) -> dict[str, Answer]:
    return {
        "type": Text(plan.type, wrong=_nearly_the_type(plan.type)),
        "request": AllOf(*REQUESTS[plan.fields_type], wrong=_not_of_the_request(plan)),
        "owner": Text(*spellings(plan.owners[plan.fields]), wrong=_not_the_owner(plan)),
        "point": Number(plan.x(ASKED_ID), NEAR, wrong=_other_numbers(plan)),
        "word": Text(*_quoted(plan.word), wrong=dict.fromkeys(_quoted(plan.other_word), RUNG_WITH_FALSE)),
        "silent": Text(*spellings(plan.silent), wrong=_not_silent(plan)),
        "wanted": Text(*spellings(plan.wanted), wrong=_not_wanted(plan)),
    }


def _quoted(word: str) -> tuple[str, str]:
    """The word as it is, and as `ros2 service call` prints it."""
    return word, f"'{word}'"


def _nearly_the_type(name: str) -> dict[str, str]:
    package, _, short = name.split("/")
    return {
        short: "That type could be from any package. Give the full name, as ROS prints it.",
        f"{package}/{short}": "Almost: the kind of interface goes between the two parts.",
        f"{package}/msg/{short}": "Almost: `msg` is for messages, and this is a service.",
    }


def _not_of_the_request(plan: Any) -> dict[str, str]:
    answered = "That field is below the dashes, so it belongs to the response, not to the request."
    nested = "That field is indented, so it belongs to the field above it."
    default = "That is a default value. The field's name comes before it."
    own = {*REQUESTS[plan.fields_type], *RESPONSES[plan.fields_type]}
    return {
        **{name: nested for name in NESTED if name not in own},
        **{name: answered for name in RESPONSES[plan.fields_type]},
        "true": default,
    }


def _not_the_owner(plan: Any) -> dict[str, str]:
    others = {*plan.owners.values(), plan.sleeper} - {plan.owners[plan.fields]}
    return for_both({node: "That node offers other services, but not this one." for node in others})


def _other_numbers(plan: Any) -> dict[float, str]:
    _, y, z = plan.point
    return {
        plan.x(0): (
            f"That is the response for id 0. Your {ASKED_ID} did not arrive. Check what `ros2 "
            "service call` prints after `making request`."
        ),
        y: "That is y.",
        z: "That is z.",
    }


def _not_silent(plan: Any) -> dict[str, str]:
    awake = {name: "That service does respond. Call it, and you will see." for name in plan.chores}
    nobody = {
        plan.wanted: (
            "That service has no server at all. The question is about a service that has a server but "
            "never responds."
        )
    }
    return for_both({**awake, **nobody})


def _not_wanted(plan: Any) -> dict[str, str]:
    offered = "That service has a server. `ros2 service info` counts it."
    silent = {plan.silent: "That service has a server. The server just does not respond."}
    return for_both({**dict.fromkeys(plan.owners, offered), **silent})
