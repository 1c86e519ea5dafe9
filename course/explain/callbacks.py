"""Functions that ROS calls back: why they are not called, and what goes wrong inside them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.explain.engine import Cause
from course.explain.python_code import PythonCall, called_name, calls, functions, nodes, number
from course.model.feedback import Location

_LONG = 10.0
# The position of the callback among each function's arguments, from 0.
TAKERS = {"create_timer": 1, "create_subscription": 2, "create_service": 2, "add_done_callback": 0}


def passed(sources: Sources, *makers: str) -> Iterator[tuple[str, PythonCall, ast.expr | None]]:
    """Each call of `makers` (default: TAKERS): the maker, the call, and what is passed as the callback."""
    for maker in makers or TAKERS:
        for call in calls(sources, maker):
            yield maker, call, call.argument(TAKERS[maker], "callback")


def called_callback(sources: Sources) -> Cause | None:
    """`self.timer_callback()` is passed instead of `self.timer_callback`."""
    for maker, taker, callback in passed(sources):
        if isinstance(callback, ast.Constant) and callback.value is None:
            text = "`None` is passed as the callback. Pass the function to call instead."
            return Cause(text, (taker.where,))
        if isinstance(callback, ast.Call) and _gives_nothing(sources, callback):
            written, name = ast.unparse(callback), ast.unparse(callback.func)
            # `add_done_callback` passes the future to the callback itself.
            given = callback.args[: -1 if maker == "add_done_callback" else None]
            bound = ", ".join(map(ast.unparse, (ast.Name(name), *given, *callback.keywords)))
            right = (
                f"`partial({bound})` from `functools`"
                if given or callback.keywords
                else f"without parentheses: `{name}`"
            )
            return Cause(
                f"`{written}` calls the function immediately, in place of passing it on. Pass the function "
                f"itself, {right}.",
                (taker.where,),
            )
    return None


def long_period(sources: Sources) -> Cause | None:
    """A period of many seconds was probably meant in milliseconds."""
    for timer in calls(sources, "create_timer"):
        value = number(sources, timer.argument(0, "timer_period_sec"))
        if value is not None and value >= _LONG:
            return Cause(
                f"`create_timer` takes its period in seconds: {value:g} means one call every {value:g} s. "
                f"Write `{value / 1000:g}`.",
                (timer.where,),
            )
    return None


def _gives_nothing(sources: Sources, call: ast.Call) -> bool:
    """Whether this calls a learner's function that returns nothing; `functools.partial(...)` is fine."""
    name = called_name(call)
    own = functions(sources, name)
    if own:
        return not any(isinstance(n, ast.Return) and n.value for function in own for n in ast.walk(function))
    return "callback" in name or name.startswith("on_")


_Def = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Function:
    """One of the learner's functions or methods."""

    file: str
    node: _Def

    @property
    def where(self) -> Location:
        return Location(self.file, self.node.lineno)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of its positional parameters, without `self`."""
        names = tuple(argument.arg for argument in self.node.args.args)
        return names[1:] if names[:1] in (("self",), ("cls",)) else names

    def calls(self, name: str) -> tuple[Location, ...]:
        """Where it calls a function or method of this name."""
        return tuple(
            Location(self.file, node.lineno) for node in _called(self.node) if called_name(node) == name
        )


def callbacks(sources: Sources, *makers: str) -> tuple[Function, ...]:
    """The learner's functions that are passed to `create_timer`, `create_service` and so on.

    makers: only functions passed to these count; by default, to any that takes a callback.
    """
    names = {name for _, _, given in passed(sources, *makers) for name in _names(given)}
    return tuple(found for found in _functions(sources) if found.node.name in names)


def in_callbacks(sources: Sources, name: str) -> tuple[Location, ...]:
    """Where a function of this name is called in a callback, or in a function that a callback calls."""
    every = _functions(sources)
    reached = list(callbacks(sources))
    for function in reached:  # grows while we loop
        called = {called_name(node) for node in _called(function.node)}
        reached += [found for found in every if found.node.name in called and found not in reached]
    return tuple(sorted({place for one in reached for place in one.calls(name)}, key=str))


def _functions(sources: Sources) -> list[Function]:
    return [
        Function(file, node)
        for file, node in nodes(sources)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


def _called(node: ast.AST) -> Iterator[ast.Call]:
    return (inner for inner in ast.walk(node) if isinstance(inner, ast.Call))


def _names(node: ast.expr | None) -> set[str]:
    """Names in `self.tick`, `partial(tick, 1)`, `lambda: self.tick()`."""
    inner = list(ast.walk(node)) if node else []
    attributes = {part.attr for part in inner if isinstance(part, ast.Attribute)}
    return attributes | {part.id for part in inner if isinstance(part, ast.Name)}


SPINS = ("spin", "spin_once", "spin_until_future_complete")


def never_spun(sources: Sources) -> Cause | None:
    """`rclpy.spin` is not called, its executor has no node, or it is called in a constructor."""
    spins = tuple(call.where for name in SPINS for call in calls(sources, name))
    if not spins:
        return Cause(
            "Nothing runs the callbacks: `main()` must call `rclpy.spin(node)`, which waits for events and "
            "calls them. A loop of your own does not."
        )
    makes = tuple(
        Location(file, node.lineno)
        for file, node in nodes(sources)
        if isinstance(node, ast.Call) and called_name(node).endswith("ThreadedExecutor")
    )
    given = any(spin.argument(0, "node") for spin in calls(sources, "spin"))
    if makes and not given and not any(calls(sources, name) for name in ("add_node", *SPINS[1:])):
        return Cause("The executor has no node: call `executor.add_node(node)` before it spins.", makes[:1])
    early = [place for place in spins if _in_a_constructor(sources, place)]
    if not early:
        return None
    return Cause(
        "`rclpy.spin` only returns when the program ends, so the lines after it in `__init__` never run. Set "
        "up the whole node first, then spin it in `main()`.",
        tuple(early),
    )


def _in_a_constructor(sources: Sources, place: Location) -> bool:
    alone = Sources({place.file: sources.files[place.file]})
    found = functions(alone, "__init__")
    return any(node.lineno <= (place.line or 0) <= (node.end_lineno or 0) for node in found)
