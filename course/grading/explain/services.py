"""What is usually wrong with a service's server or client."""

from __future__ import annotations

import ast

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.callbacks import Function, callbacks, in_callbacks
from course.grading.explain.python_code import called_name, calls, trees
from course.grading.explain.timers import Cause

_FOLDS = {"lower", "upper", "casefold", "IGNORECASE", "I"}


def no_response(sources: Sources) -> Cause | None:
    """A server's callback that can end without returning a value."""
    for callback in callbacks(sources, "create_service"):
        if not _always_returns(callback.node.body):
            return Cause(
                f"The response is not returned: `{callback.node.name}` must end with `return "
                f"{_response_name(callback)}`, whichever way it takes.",
                (callback.where,),
            )
    return None


def not_the_response(sources: Sources) -> Cause | None:
    """What a bare TypeError of rclpy means when each way returns something: it is no response."""
    for callback in callbacks(sources, "create_service"):
        returns = (node for node in ast.walk(callback.node) if isinstance(node, ast.Return))
        return Cause(
            f"What `{callback.node.name}` returns is not the response. It must be "
            f"`{_response_name(callback)}`, the object that the callback was given.",
            tuple(Location(callback.file, node.lineno) for node in returns),
        )
    return None


def fields_of_the_request(sources: Sources) -> Cause | None:
    """A server's callback that sets the answer's fields on the request."""
    for callback in callbacks(sources, "create_service"):
        request = callback.parameters[:1]
        for node in ast.walk(callback.node):
            if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and request:
                written = ast.unparse(node)
                if written.startswith(f"{request[0]}."):
                    return Cause(
                        f"`{written}` is set on the request. The answer's fields belong to the response: "
                        f"`{_response_name(callback)}.{written.partition('.')[2]}`.",
                        (Location(callback.file, node.lineno),),
                    )
    return None


def blocking_call(sources: Sources) -> Cause | None:
    """`client.call(request)` in a callback: it waits for an answer that the waiting itself keeps away."""
    places = in_callbacks(sources, "call")
    if not places:
        return None
    return Cause(
        "`call` waits for the answer, and while a callback waits, no answer can come in: a deadlock. "
        "Use `call_async`, and take the answer in a later callback or with `add_done_callback`.",
        places[:1],
    )


def spin_in_callback(sources: Sources) -> Cause | None:
    """`spin_until_future_complete` and the like inside a callback."""
    names = ("spin_until_future_complete", "spin_once", "spin")
    places = [(name, place) for name in names for place in in_callbacks(sources, name)]
    if not places:
        return None
    name, where = places[0]
    return Cause(
        f"`{name}` in a callback waits, while `rclpy.spin` waits for that callback: the node stands still. "
        "Let the callback return, and take the answer in a later one or with `add_done_callback`.",
        (where,),
    )


def standstill(sources: Sources) -> Cause | None:
    """Why a client asks once and then never again."""
    return blocking_call(sources) or spin_in_callback(sources)


def sleeping(sources: Sources) -> Cause | None:
    """A `sleep` in a callback."""
    places = in_callbacks(sources, "sleep")
    if not places:
        return None
    return Cause("While a callback sleeps, the node does nothing else: take the `sleep` out.", places[:1])


def case_sensitive(sources: Sources, word: str) -> Cause | None:
    """`'word' in text`, with nothing that makes capitals and small letters the same."""
    found = [(file, node) for file, tree in trees(sources) for node in ast.walk(tree)]
    if any(isinstance(node, ast.Attribute) and node.attr in _FOLDS for _, node in found):
        return None
    for file, node in found:
        if isinstance(node, ast.Constant) and node.value == word:
            return Cause(
                f"`'{word}' in text` does not find `{word.capitalize()}` or `{word.upper()}`: look in "
                "`text.lower()`.",
                (Location(file, node.lineno),),
            )
    return None


def result_too_early(sources: Sources) -> Cause | None:
    """`future.result()` of a call that has no answer yet, or never gets one, is None."""
    places = tuple(call.where for call in calls(sources, "result"))
    if not places:
        return None
    return Cause(
        "`future.result()` is `None` without an answer, and after `cancel()`. Ask `future.done()` first, or "
        "use `future.add_done_callback`; and check that the result is not `None`.",
        places[:1],
    )


def future_lost(sources: Sources) -> Cause | None:
    """`call_async` whose future nobody keeps."""
    for file, tree in trees(sources):
        for node in ast.walk(tree):
            value = node.value if isinstance(node, ast.Expr) else None
            if isinstance(value, ast.Call) and called_name(value) == "call_async":
                return Cause(
                    "`call_async` returns a future, and it is lost here. Keep it, and name a method that "
                    "gets the answer: `future.add_done_callback(self.answered)`.",
                    (Location(file, value.lineno),),
                )
    return None


def no_wait(sources: Sources) -> Cause | None:
    """A client that never asks whether its service is there."""
    if calls(sources, "wait_for_service") or calls(sources, "service_is_ready"):
        return None
    return Cause(
        "Nothing waits for the service. Before the first call, log a message in a loop: "
        "`while not self.client.wait_for_service(timeout_sec=1.0):`.",
        tuple(call.where for call in calls(sources, "create_client"))[:1],
    )


def _response_name(callback: Function) -> str:
    return callback.parameters[1] if len(callback.parameters) > 1 else "response"


def _always_returns(body: list[ast.stmt]) -> bool:
    """Whether no way through these statements comes out at their end."""
    last = body[-1]
    if isinstance(last, ast.Return):
        return last.value is not None and not (
            isinstance(last.value, ast.Constant) and last.value.value is None
        )
    if isinstance(last, ast.If):
        return bool(last.orelse) and _always_returns(last.body) and _always_returns(last.orelse)
    if isinstance(last, ast.Try):
        if last.finalbody and _always_returns(last.finalbody):
            return True
        ways = (last.orelse or last.body, *(handler.body for handler in last.handlers))
        return all(_always_returns(way) for way in ways)
    if isinstance(last, ast.With | ast.AsyncWith):
        return _always_returns(last.body)
    if isinstance(last, ast.Match):
        return all(_always_returns(case.body) for case in last.cases)
    return isinstance(last, ast.Raise | ast.While)
