"""Expectations about a node's parameters."""

from __future__ import annotations

from math import inf, isclose
from typing import Any

from course.errors import OurFault
from course.evidence.parameter_view import ParameterData, ParameterView, type_name
from course.evidence.recording import Recording
from course.explain.engine import Cause
from course.explain.observed import unproven
from course.explain.parameter_causes import declared, named, undeclared
from course.explain.python_code import calls, text_places
from course.model.events import OutputLine
from course.model.feedback import Failure, Feedback, Location
from course.spelling import listed, nearest

# ROS adds these to every node.
_OF_EVERY_NODE = ("use_sim_time", "start_type_description_service")


def expect_declared(recording: Recording, node: str, name: str, default: ParameterData) -> None:
    """Check that the node has this parameter. The scenario must have asked for it, or for the list.

    default: the initial value that the exercise asks for; shown in the advice.
    """
    view = _view(recording, node)
    if view.get(name) or name in view.names:
        return
    own = [known for known in view.names if known not in _OF_EVERY_NODE]
    close = nearest(name, own)
    if close:
        raise Failure(
            Feedback(
                summary=f"The node declares the parameter `{close}`, not `{name}`.",
                expected=name,
                seen=close,
                where=named(recording.sources, close)[:2],
                advice=f"Spell it `{name}` where it is declared and where it is read.",
            )
        )
    raise Failure(_undeclared(recording, name, default, own))


def expect_parameter(
    recording: Recording, node: str, name: str, value: ParameterData, *, t: float = inf
) -> None:
    """Check the parameter's type and value, as the node last reported them before the time `t` (s)."""
    expect_declared(recording, node, name, value)
    view = _view(recording, node)
    found = view.get(name, t)
    if found is None and name in view.undeclared:
        raise Failure(
            Feedback(
                summary=f"The node lists the parameter `{name}`, but does not answer with its value.",
                expected=_written(value),
                seen="no value",
                where=_declarations(recording, name),
                advice=f"Give `{name}` a value where you declare it.",
            )
        )
    if found is None:
        raise OurFault(f"the scenario did not get the parameter {name} of {node}")
    wanted = type_name(value)
    if found.type != wanted:
        raise Failure(
            Feedback(
                summary=f"The parameter `{name}` is of type {found.type}, not {wanted}.",
                expected=f"{wanted}: {_written(value)}",
                seen=f"{found.type}: {_written(found.value)}",
                where=_declarations(recording, name),
                advice=_advice_on_type(name, value),
            )
        )
    if not _same(found.value, value):
        raise Failure(
            Feedback(
                summary=f"The parameter `{name}` is {_written(found.value)}, not {_written(value)}.",
                expected=_written(value),
                seen=_written(found.value),
                where=_declarations(recording, name),
                advice=f"Correct the value of `{name}`. Quotes, capital letters and every digit count.",
            )
        )


def expect_set(recording: Recording, node: str, name: str) -> None:
    """Check that the node accepted every value that the scenario set for this parameter."""
    results = [result for result in _view(recording, node).sets if result.name == name]
    if not results:
        raise OurFault(f"the scenario did not set the parameter {name} of {node}")
    for result in results:
        if result.successful:
            continue
        refused = result.successful is False
        cause = _refusal(recording, result.reason or "") if refused else None
        raise Failure(
            Feedback(
                summary=f"The node {'refuses' if refused else 'does not answer'} when `{name}` is set to "
                f"{_written(result.value)}" + (f": {result.reason}" if result.reason else "."),
                expected="the new value is accepted",
                seen="refused" if refused else "no answer",
                where=cause.where if cause else (),
                advice=cause.text
                if cause
                else "A node answers only while `rclpy.spin(node)` runs and no callback keeps it busy.",
            )
        )


def _refusal(recording: Recording, reason: str) -> Cause:
    """Why a node refused a new value."""
    read_only = text_places(recording.sources, "read_only")
    if "read-only" in reason and read_only:
        return Cause(
            "A read-only parameter keeps its first value. Declare it without `read_only`.", read_only
        )
    callback = tuple(call.where for call in calls(recording.sources, "add_on_set_parameters_callback"))[:1]
    if callback:
        return Cause(
            "Your callback for changes should accept this one: end it with `return "
            "SetParametersResult(successful=True)`.",
            callback,
        )
    return unproven(recording, f"the reason that the node gives ({reason or 'none'}).")


def _view(recording: Recording, node: str) -> ParameterView:
    """Raises Failure if the node never answered, OurFault if it was not asked."""
    view = recording.parameters(node)
    if not view.asked:
        raise OurFault(f"the scenario did not ask {node} for its parameters")
    if not view.answered:
        raise Failure(
            Feedback(
                summary=f"The node `{node}` does not answer a request for its parameters.",
                expected="an answer, as from every node that `rclpy.spin` runs",
                seen="no answer",
                where=tuple(call.where for call in calls(recording.sources, "sleep"))[:1],
                advice="A node answers only while `rclpy.spin(node)` runs and no callback keeps it busy.",
            )
        )
    return view


def _undeclared(recording: Recording, name: str, default: ParameterData, own: list[str]) -> Feedback:
    errors = (line.text for line in _program_lines(recording) if "ParameterNotDeclaredException" in line.text)
    error = next(errors, None)
    cause = undeclared(error, recording.sources) if error else None
    in_source = name in declared(recording.sources)
    return Feedback(
        summary=f"The node does not declare the parameter `{name}`."
        + (f" ({error.rpartition('.')[2].partition(':')[0]})" if error else ""),
        expected=f"a parameter `{name}`",
        seen=f"the node has {listed(own, 'no parameter of its own')}",
        where=(cause.where if cause else ()) or named(recording.sources, name)[:2],
        advice="The code that declares it never runs: call that code in `__init__`."
        if in_source
        else f"Declare it in `__init__`: `self.declare_parameter('{name}', {default!r})`.",
        details=(error,) if error else (),
    )


def _program_lines(recording: Recording) -> list[OutputLine]:
    return [event for event in recording.events if isinstance(event, OutputLine)]


def _declarations(recording: Recording, name: str) -> tuple[Location, ...]:
    declaring = {
        call.where.line
        for maker in ("declare_parameter", "declare_parameters")
        for call in calls(recording.sources, maker)
    }
    places = named(recording.sources, name)
    return tuple(place for place in places if place.line in declaring) or places[:1]


def _advice_on_type(name: str, value: ParameterData) -> str:
    written = f"`self.declare_parameter('{name}', {value!r})`"
    if isinstance(value, float):
        return f"A double needs a decimal point and no quotes: {written}."
    if isinstance(value, str):
        return f"A string needs quotes: {written}."
    return f"The default value determines the type: {written}."


def _same(found: Any, wanted: ParameterData) -> bool:
    if isinstance(wanted, float):
        return isclose(found, wanted, rel_tol=1e-9, abs_tol=1e-12)
    return bool(found == (tuple(wanted) if isinstance(wanted, list) else wanted))


def _written(value: Any) -> str:
    """A value in short YAML form."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, tuple | list):
        return f"[{', '.join(map(_written, value))}]"
    return f"'{value}'" if isinstance(value, str) else str(value)
