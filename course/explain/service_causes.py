"""Common mistakes with a service's server or client."""

from __future__ import annotations

import ast

from course.evidence.sources import Sources
from course.explain.callbacks import Function, callbacks, in_callbacks
from course.explain.engine import Cause
from course.explain.python_code import calls
from course.model.feedback import Location


def no_response(sources: Sources) -> Cause | None:
    """A server's callback that can end without returning a value."""
    for callback in callbacks(sources, "create_service"):
        if not _always_returns(callback.node.body):
            return Cause(
                f"The response is not returned: every path through `{callback.node.name}` must "
                f"end with `return {_response_name(callback)}`.",
                (callback.where,),
            )
    return None


def not_the_response(sources: Sources) -> Cause | None:
    """The cause of rclpy's bare TypeError if every path returns something: it is not the response."""
    for callback in callbacks(sources, "create_service"):
        returns = (node for node in ast.walk(callback.node) if isinstance(node, ast.Return))
        return Cause(
            f"`{callback.node.name}` does not return the response. It must return "
            f"`{_response_name(callback)}`, the object that the callback was given.",
            tuple(Location(callback.file, node.lineno) for node in returns),
        )
    return None


def fields_of_the_request(sources: Sources) -> Cause | None:
    """A server's callback that sets the response's fields on the request."""
    for callback in callbacks(sources, "create_service"):
        request = callback.parameters[:1]
        if callback.parameters[:2] == ("response", "request"):
            text = "ROS passes the request first, and then the response: swap the two names in this `def`."
            return Cause(text, (callback.where,))
        for node in ast.walk(callback.node):
            if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and request:
                written = ast.unparse(node)
                if written.startswith(f"{request[0]}."):
                    return Cause(
                        f"`{written}` is a field of the request. Set the answer on the response: "
                        f"`{_response_name(callback)}.{written.partition('.')[2]}`.",
                        (Location(callback.file, node.lineno),),
                    )
    return None


def blocking_call(sources: Sources) -> Cause | None:
    """`client.call(request)` in a callback, which blocks the very thread that would receive the answer."""
    places = in_callbacks(sources, "call")
    if not places:
        return None
    return Cause(
        "`call` waits for the answer, but while a callback waits, no answer can arrive: a "
        "deadlock. Use `call_async`, and read the answer in a later callback or with "
        "`add_done_callback`.",
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
        f"`{name}` waits inside a callback, and `rclpy.spin` waits for that callback: a deadlock. "
        "Let the callback return, and read the answer in a later one or with `add_done_callback`.",
        (where,),
    )


def sleeping(sources: Sources) -> Cause | None:
    """A `sleep` in a callback."""
    places = in_callbacks(sources, "sleep")
    if not places:
        return None
    return Cause("While a callback sleeps, the node does nothing else: remove the `sleep`.", places[:1])


def result_too_early(sources: Sources) -> Cause | None:
    """`future.result()` is None for a call that has no answer yet, or never gets one."""
    places = tuple(call.where for call in calls(sources, "result"))
    if not places:
        return None
    return Cause(
        "`future.result()` is `None` before the answer arrives, and after `cancel()`. Check "
        "`future.done()` first, or use `future.add_done_callback`. Then check that the result is "
        "not `None`.",
        places[:1],
    )


def _response_name(callback: Function) -> str:
    return callback.parameters[1] if len(callback.parameters) > 1 else "response"


def _always_returns(body: list[ast.stmt]) -> bool:
    """Whether every path through these statements returns."""
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
