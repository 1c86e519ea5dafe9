"""Grader of chapter 19: questions about the topics of a rover, and one message to publish."""

from __future__ import annotations

from typing import Any

from course.api import AllOf, Grader, Mystery, Number, Recording, Text
from lib.following import Answer
from lib.names import for_both, spellings

WITH_SLASH = "That is the right topic, but its full name begins with a slash."

mystery = Mystery("19-inspect-topics", __file__)
grader = Grader("19-inspect-topics", builds=None)


@mystery.words
def words(plan: Any) -> dict[str, object]:
    at = plan.recited.index(plan.asked)
    return {
        "measured": plan.measured,
        "period": 1 / plan.rate,
        "measured_rate": f"{plan.rate * 0.97:.3f}",
        "password": plan.password,
        "measurer": plan.measurer,
        "reader": plan.reader,
        "short_type": plan.type.rpartition("/")[2],
        "old_type": plan.type.replace("/msg/", "/"),
        "shared": plan.shared,
        "said": plan.said,
        "heard": plan.heard,
        "heard_without_slash": plan.heard.lstrip("/"),
        "notice": plan.notice,
        "quotes": plan.quotes,
        "asked": plan.asked.id,
        "one_before": plan.recited[at - 1].philosopher,
        "waiting": plan.waiting,
        "waiting_without_slash": plan.waiting.lstrip("/"),
    }


@mystery.answers
def answers(plan: Any) -> dict[str, Answer]:
    package, _, short = plan.type.split("/")
    return {
        "type": Text(
            plan.type,
            f"{package}/{short}",
            wrong={short: f"`{short}` could be from any package. Name the package, too."},
        ),
        "rate": Number(
            plan.rate, "10%", wrong={1 / plan.rate: "That is the time between two messages, in seconds."}
        ),
        "publisher": Text(*spellings(plan.measurer), wrong=_not_publishers(plan)),
        "two-publishers": Text(*spellings(plan.shared), wrong=_not_shared(plan)),
        "pair": AllOf(plan.said, plan.heard, wrong=_not_of_the_pair(plan)),
        "password": Text(plan.password, f"Today's password is {plan.password}"),
        "philosopher": Text(plan.asked.philosopher, wrong=_other_philosophers(plan)),
        "waiting": Text(*spellings(plan.waiting), wrong=_not_waiting(plan)),
    }


@mystery.acts
def acts(plan: Any) -> list[str]:
    return ["published"]


@grader.check("published", "you published the quote with id 1994 that a node is waiting for")
def published(recording: Recording) -> None:
    mystery.expect_act(
        recording,
        "published",
        "No `AmazingQuote` with the id 1994 has arrived on the topic where a node is waiting for it.",
        near_miss="other_id",
    )


def _not_publishers(plan: Any) -> dict[str, str]:
    return for_both({plan.reader: "That node only subscribes to the topic. It does not publish on it."})


def _not_shared(plan: Any) -> dict[str, str]:
    alone = "One node publishes there, and another subscribes. So there is only one publisher."
    return for_both(
        {
            plan.measured: alone,
            plan.said: "Only one node publishes there.",
            plan.heard: "No node publishes there. One node subscribes.",
            plan.waiting: "No node publishes there. One node is waiting for a message.",
            plan.quotes: "Only one node publishes there.",
            plan.notice: "Only one node publishes there, and only once.",
            "rosout": "That topic belongs to ROS: every node has a publisher on it.",
            "parameter_events": "That topic belongs to ROS: every node has a publisher on it.",
        }
    )


def _not_of_the_pair(plan: Any) -> dict[str, str]:
    others = (plan.measured, plan.shared, plan.notice, plan.quotes, plan.waiting)
    no_twin = "No other topic has a similar name."
    whys = {spelling: no_twin for name in others for spelling in spellings(name)}
    return {**whys, plan.said.lstrip("/"): WITH_SLASH, plan.heard.lstrip("/"): WITH_SLASH}


def _other_philosophers(plan: Any) -> dict[str, str]:
    others = (said for said in plan.recited if said != plan.asked)
    return {said.philosopher: f"That is the author of the quote with the id {said.id}." for said in others}


def _not_waiting(plan: Any) -> dict[str, str]:
    return for_both(
        {
            plan.quotes: "Quotes arrive there all the time, so some node publishes there.",
            plan.heard: (
                "No node publishes there either, but the subscriber isn't waiting for an `AmazingQuote`."
            ),
        }
    )
