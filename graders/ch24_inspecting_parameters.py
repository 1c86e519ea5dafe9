"""Grader of chapter 24: questions on a rover's parameters, two acts, and the file of its parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

import yaml

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Mystery,
    Number,
    OneOf,
    OurFault,
    Recording,
    Text,
    expect_text,
    listed,
    nearest,
)
from lib.following import Answer

NODE = "/peanut_butter_falcon_quote_publisher_node"
FILE = "ros2_tutorial_workspace/src/peanut_butter_falcon_quote_publisher_node.yaml"
KEY = "ros__parameters"
# A file may be meant for one node, or for every node.
KEYS = (NODE, NODE.lstrip("/"), "/**")
WANTED = ("quote", "philosopher_name", "topic_name", "period", "use_sim_time")
DUMP = f"`ros2 param dump {NODE} > ~/{FILE}` creates it while the mystery runs."
LARGEST = 2**63
ATTEMPTS = 5

mystery = Mystery("24-inspect-parameters", __file__)
grader = Grader("24-inspect-parameters", builds=None)


# The questions -----------------------------------------------------------------------------------------


@mystery.words
def words(plan: Any) -> dict[str, object]:
    return {
        "dial": plan.dial,
        "low": plan.low,
        "high": plan.high,
        "set_to": plan.set_to,
        "odd": plan.odd,
        "fixed": plan.fixed,
        "period": plan.period,
        "rate": 1 / plan.period,
        "philosopher": plan.philosopher,
        "quote": plan.quote,
        "odd_type": plan.odd_type,
        "other_type": next(name for name in _TYPES if name != plan.odd_type),
    }


@mystery.answers
def answers(plan: Any) -> dict[str, Answer]:
    return {
        "integer": Text(plan.dial, wrong=_not_integers(plan)),
        "type": OneOf(plan.odd_type, {name: why for name, why in _TYPES.items() if name != plan.odd_type}),
        "period": Number(
            plan.period, "1%", wrong={1 / plan.period: "That is how often it publishes per second."}
        ),
        "philosopher": Text(plan.philosopher, wrong=_not_the_philosopher(plan)),
        "largest": Number(plan.high, 0.0, wrong=_not_the_largest(plan)),
        "read-only": OneOf(
            plan.fixed, dict.fromkeys(_settable_names(plan), "Set it and see: the node accepts it.")
        ),
    }


_TYPES = {
    "boolean": "A boolean is either true or false.",
    "double": "A double is a number with a decimal point, and `ros2 param get` prints `Double value`.",
    "integer": "An integer is a whole number, and `ros2 param get` prints `Integer value`.",
    "string": "A string is text, and `ros2 param get` prints `String value`.",
    "string array": "That would be several strings, in square brackets.",
}


def _settable_names(plan: Any) -> tuple[str, ...]:
    return ("quote", "philosopher_name", plan.dial, plan.odd)


def _not_integers(plan: Any) -> dict[str, str]:
    text = "That one is a string."
    return {
        **dict.fromkeys(("quote", "philosopher_name", "topic_name", plan.fixed), text),
        "period": "That one is a double: it has a decimal point.",
        "use_sim_time": "That one is a boolean.",
        "start_type_description_service": "That one is a boolean.",
        plan.odd: "`ros2 param describe` shows a different type for that one than its value suggests.",
    }


def _not_the_philosopher(plan: Any) -> dict[str, str]:
    return {
        plan.quote: "That is the quote.",
        plan.given[1]: "That value came from the file that you loaded. Start the mystery again and look.",
    }


def _not_the_largest(plan: Any) -> dict[float, str]:
    return {
        plan.low: "That is the smallest.",
        plan.set_to: "That is its value at the start. Find out which values it may have.",
        1: "That is the step from one value to the next.",
    }


# What the learner did ----------------------------------------------------------------------------------


@mystery.acts
def acts(plan: Any) -> list[str]:
    return ["set", "loaded"]


@grader.check("set", "you set the integer parameter to its largest value")
def set_to_the_largest(recording: Recording) -> None:
    mystery.expect_act(
        recording,
        "set",
        "The integer parameter has not been set to its largest allowed value.",
        near_miss="set_other",
        at_home=True,  # the node in this recording does it itself
    )


@grader.check("loaded", "you loaded quote_of_the_day.yaml into the node")
def loaded(recording: Recording) -> None:
    mystery.expect_act(
        recording,
        "loaded",
        "The node never had both values of `quote_of_the_day.yaml`. `ros2 param load` sets them.",
        near_miss="other_quote",
        at_home=True,
    )


# The file ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Dump:
    """The content of the file. values: those of our node. problem: why they cannot be used."""

    values: Mapping[str, Any] = field(default_factory=dict)
    problem: Feedback | None = None


class _NoAliases(yaml.SafeLoader):
    """A few lines with `&` and `*` can stand for more values than fit into memory."""

    def compose_node(self, parent: Any, index: Any) -> Any:
        if self.check_event(yaml.AliasEvent):
            what = "it uses `*`, which ROS never writes"
            raise yaml.MarkedYAMLError(problem=what, problem_mark=self.peek_event().start_mark)  # type: ignore[no-untyped-call]
        return super().compose_node(parent, index)


# What reading YAML raises besides marked errors: for invalid numbers, dates, and keys.
_NOT_YAML = (yaml.YAMLError, ValueError, ArithmeticError, LookupError, AttributeError, RecursionError)


def read_dump(text: str) -> Dump:
    """Never raises, because the text is the learner's."""
    try:
        data = yaml.load(text, _NoAliases)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        return Dump(problem=_no_yaml(error.problem or error.context or "", mark.line + 1 if mark else None))
    except _NOT_YAML as error:
        return Dump(problem=_no_yaml(str(error), None))
    nodes = data if isinstance(data, dict) else {}
    inside = next((nodes[key] for key in KEYS if key in nodes), None)
    if inside is None:
        return Dump(problem=_no_node(text, nodes))
    values = inside.get(KEY) if isinstance(inside, dict) else None
    if not isinstance(values, dict):
        return Dump(problem=_no_parameters(text, inside))
    return Dump({str(name): value for name, value in values.items()})


@grader.scenario
def load_the_dump(arena: Arena) -> None:
    """Set each of its parameters on a node of that name, as `ros2 param load` does."""
    values = _settable(arena)
    if not values:
        return
    asked = arena.ros.parameters(NODE)
    arena.play(mystery.file)
    arena.until(lambda: asked.available, timeout=15)
    for _ in range(ATTEMPTS):
        call = asked.set(values)
        if arena.until(lambda call=call: call.done, timeout=3):  # type: ignore[misc]
            return


def _settable(arena: Arena) -> dict[str, Any]:
    values = read_dump(arena.files.text(FILE) or "").values
    return {name: values[name] for name in WANTED if name in values and _is_plain(values[name])}


def _is_plain(value: Any) -> bool:
    """Whether this is a value that ROS can set; the node may still refuse it."""
    if isinstance(value, str):
        return "\0" not in value and value.encode(errors="ignore").decode() == value
    if isinstance(value, int):
        return -LARGEST <= value < LARGEST
    return isinstance(value, float)


@grader.check("dump", "the file contains parameters of the node")
def dump(recording: Recording) -> None:
    text = expect_text(recording, FILE, advice=DUMP).text or ""
    problem = read_dump(text).problem if text.strip() else _empty()
    if problem:
        raise Failure(problem)


@grader.check("five", "the four parameters of chapter 22 and use_sim_time are in it", needs="dump")
def five(recording: Recording) -> None:
    text = expect_text(recording, FILE).text or ""
    values = read_dump(text).values
    for name in WANTED:
        if name not in values:
            raise Failure(_parameter_missing(text, name, values))
        if not _is_plain(values[name]):
            raise Failure(_no_value(text, name, values[name]))


@grader.check("loads", "a node accepts the values in the file", needs="five")
def loads(recording: Recording) -> None:
    results = {result.name: result for result in recording.parameters(NODE).sets}
    for name in WANTED:
        if name not in results or results[name].successful is None:
            raise OurFault(f"our own node did not answer when {name} was set")
        if not results[name].successful:
            raise Failure(_refused(recording, name, results[name].reason))


# Words -------------------------------------------------------------------------------------------------


def _empty() -> Feedback:
    return Feedback(
        summary=f"`~/{FILE}` is empty.",
        where=(Location(FILE),),
        advice=(
            "bash creates the file first, and it stays empty if the node is not found. Start the "
            f"mystery, then: {DUMP}"
        ),
    )


def _no_yaml(what: str, line: int | None) -> Feedback:
    return Feedback(
        summary=f"`{PurePosixPath(FILE).name}` cannot be read as YAML: {what}.",
        where=(Location(FILE, line),),
        advice=f"It must contain only the output of `ros2 param dump`. {DUMP}",
    )


def _no_node(text: str, nodes: Mapping[Any, Any]) -> Feedback:
    names = [str(name) for name in nodes]
    close = nearest(NODE, names) or (names[0] if len(names) == 1 else None)
    return Feedback(
        summary=f"The file is for `{close}`, not for `{NODE}`."
        if close
        else "The file does not name the node that it is for.",
        expected=f"{NODE}:",
        seen=listed(names, "no name at the beginning of a line"),
        where=_places(text, close),
        advice=f"The node's name, and a colon, belong in the first line. {DUMP}",
    )


def _no_parameters(text: str, inside: Any) -> Feedback:
    names = [str(name) for name in inside] if isinstance(inside, dict) else []
    close = nearest(KEY, names)
    return Feedback(
        summary=f"Below the node's name is `{close}`, not `{KEY}`."
        if close
        else f"There is no `{KEY}:` below the node's name, with the parameters below that.",
        expected=f"{KEY}:",
        seen=listed(names[:5], "nothing"),
        where=_places(text, close),
        advice=f"Write two underscores between `ros` and `parameters`. {DUMP}",
    )


def _parameter_missing(text: str, name: str, values: Mapping[str, Any]) -> Feedback:
    close = nearest(name, [other for other in values if other not in WANTED])
    return Feedback(
        summary=f"The file contains `{close}`, not `{name}`."
        if close
        else f"The parameter `{name}` is not in the file.",
        expected=listed(WANTED),
        seen=listed(values, "no parameter"),
        where=_places(text, close),
        advice=f"Let ROS write the file, so that nothing is missing. {DUMP}",
    )


def _no_value(text: str, name: str, value: Any) -> Feedback:
    return Feedback(
        summary=f"`{name}` has no value in the file."
        if value is None
        else f"The value of `{name}` is not a single string, number, true or false.",
        seen=None if value is None else str(value)[:80],
        where=_places(text, name),
        advice=f"Write the value after the colon and a space. {DUMP}",
    )


def _refused(recording: Recording, name: str, reason: str) -> Feedback:
    return Feedback(
        summary=f"The node refuses the file's value of `{name}`: {reason}",
        where=_places(expect_text(recording, FILE).text or "", name),
        advice=(
            "A double needs a decimal point, a string may need quotation marks, and `true` and "
            f"`false` must not have any. {DUMP}"
        ),
    )


def _places(text: str, name: str | None) -> tuple[Location, ...]:
    """The line with this key, or just the file."""
    return (Location(FILE, next(_lines_of(text, name), None) if name else None),)


def _lines_of(text: str, name: str) -> Iterator[int]:
    for number, line in enumerate(text.splitlines(), start=1):
        if line.strip().partition(":")[0].strip("'\"") == name:
            yield number
