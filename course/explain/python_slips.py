"""Mistakes that Python accepts without an error, but that the code itself proves."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable
from itertools import pairwise

from course.evidence.sources import Sources
from course.explain.callbacks import TAKERS, callbacks, called_callback, in_callbacks, long_period
from course.explain.engine import Cause
from course.explain.python_code import (
    LONGEST,
    called_name,
    calls,
    last_name,
    nodes,
    number,
    read,
    text_places,
    trees,
)
from course.explain.service_causes import blocking_call, spin_in_callback
from course.model.feedback import Location

_Def = ast.FunctionDef | ast.AsyncFunctionDef
_CONSTRUCTORS = ("_init_", "__init_", "_init__", "__int__")
# Functions that learners forget to write parentheses after, besides their own.
_METHODS = {
    "spin",
    "ok",
    "is_set",
    "done",
    "shutdown",
    "try_shutdown",
    "destroy_node",
    "cancel",
    "is_alive",
    "is_enabled",
    "wait_for_service",
    "service_is_ready",
}
_SELDOM = ("once", "skip_first", "throttle_duration_sec")
_LOGS = ("debug", "info", "warn", "warning", "error", "fatal")
_GROUPS = ("callback_group", "ReentrantCallbackGroup", "MutuallyExclusiveCallbackGroup")


def first(sources: Sources, *causes: Callable[[Sources], Cause | None]) -> Cause | None:
    """Return the first of these causes that the code proves."""
    return next((found for cause in causes if (found := cause(sources))), None)


def python_timer_cause(sources: Sources) -> Cause | None:
    """Why no callback runs, such as: no timer, one without a function, or a callback that never returns."""
    return first(
        sources,
        never_again,
        called_callback,
        long_period,
        misnamed_constructor,
        rate_in_callback,
        await_in_callback,
        uncalled,
        never_awaited,
        taken_away,
        plain_node_spun,
    )


def never_again(sources: Sources) -> Cause | None:
    """Neither a timer nor a thread is made in the code."""
    if calls(sources, "create_timer") or calls(sources, "Thread"):
        return None
    return Cause(
        "The code creates no timer: call `self.create_timer(0.5, self.timer_callback)` in `__init__`.",
        tuple(call.where for call in calls(sources, "__init__")),
    )


def misnamed_constructor(sources: Sources) -> Cause | None:
    """`def _init_(self)`, which nothing calls."""
    for file, node in nodes(sources):
        if not isinstance(node, ast.ClassDef):
            continue
        methods = {part.name: part for part in node.body if isinstance(part, _Def)}
        wrong = next((name for name in _CONSTRUCTORS if name in methods and not calls(sources, name)), None)
        if wrong and "__init__" not in methods:
            return Cause(
                f"Python never calls `{wrong}`. The method is called `__init__`, with two underscores "
                "on each side of `init`.",
                (Location(file, methods[wrong].lineno),),
            )
    return None


def shadowed_import(sources: Sources) -> Cause | None:
    """A learner's class with the same name as an import in the same file."""
    for file, tree in trees(sources):
        imported = {
            alias.asname or alias.name: node.lineno
            for node in tree.body
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and imported.get(node.name, node.lineno) < node.lineno:
                line = imported[node.name]
                return Cause(
                    f"Your class `{node.name}` hides what line {line} imports under the same name. "
                    f"Give your class a different name, such as `{node.name}Node`.",
                    (Location(file, node.lineno), Location(file, line)),
                )
    return None


def uncalled(sources: Sources, only: str = "") -> Cause | None:
    """`node.is_ready` or `rclpy.spin` without the parentheses that call it. only: a name to look for."""
    every = [node for _, node in nodes(sources)]
    stored = {last_name(n) for n in every if isinstance(n, ast.Attribute | ast.Name) and _is_stored(n)}
    stored |= {node.arg for node in every if isinstance(node, ast.arg)}
    plain = {node.name for _, node in nodes(sources) if isinstance(node, _Def) and not node.decorator_list}
    names = (plain | _METHODS) - stored
    names = names & {only} if only else names
    for file, node in nodes(sources):
        for part in _asked(node):
            method = isinstance(part, ast.Attribute) and last_name(part) in names
            alone = isinstance(part, ast.Name) and isinstance(node, ast.Expr | ast.If | ast.While)
            if method or (alone and last_name(part) in names & plain):
                written = ast.unparse(part)
                given = "(node)" if written == "rclpy.spin" else "()"
                return Cause(
                    f"`{written}` only names the function, and does not call it: write `{written}{given}`, "
                    "with parentheses.",
                    (Location(file, part.lineno),),
                )
    return None


def _is_stored(node: ast.Attribute | ast.Name) -> bool:
    return isinstance(node.ctx, ast.Store)


def _asked(node: ast.AST) -> tuple[ast.expr, ...]:
    """The values that a statement, a condition, or a lambda passed as a callback uses."""
    if isinstance(node, ast.Call) and called_name(node) in TAKERS:
        given = (*node.args, *(keyword.value for keyword in node.keywords))
        return tuple(one.body for one in given if isinstance(one, ast.Lambda))
    if isinstance(node, ast.Expr):
        return (node.value,)
    if isinstance(node, ast.If | ast.While | ast.IfExp | ast.Assert):
        return (node.test,)
    if isinstance(node, ast.BoolOp):
        return tuple(node.values)
    return (node.operand,) if isinstance(node, ast.UnaryOp) else ()


def rate_in_callback(sources: Sources) -> Cause | None:
    """`rate.sleep()` in a callback, for a rate from `create_rate`."""
    rates = {
        ast.unparse(target)
        for _, node in nodes(sources)
        if isinstance(node, ast.Assign) and _calls(node.value, "create_rate")
        for target in node.targets
    }
    waits = [
        Location(file, node.lineno)
        for file, node in nodes(sources)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "sleep"
        if ast.unparse(node.func.value) in rates or _calls(node.func.value, "create_rate")
    ]
    found = [place for place in in_callbacks(sources, "sleep") if place in waits]
    return _in(
        found,
        "Inside a callback, a rate's `sleep()` never returns: it needs a node that spins, but this node is "
        "busy with the callback. Remove it, and let a timer call the function again and again.",
    )


def compared(sources: Sources) -> Cause | None:
    """`count == count + 1` on a line of its own, or `count =+ 1`."""
    for file, node in nodes(sources):
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.UnaryOp):
            place, line = Location(file, node.lineno), sources.files[file].splitlines()[node.lineno - 1]
            if "=+" in line:
                what = ast.unparse(node.value.operand)
                return Cause(f"`=+ {what}` sets the value to {what}. To add to it, write `+=`.", (place,))
        value = node.value if isinstance(node, ast.Expr) else None
        if isinstance(value, ast.Compare) and isinstance(value.ops[0], ast.Eq):
            text = f"`{ast.unparse(value)}` only compares, and changes nothing. A single `=` assigns a value."
            return Cause(text, (Location(file, value.lineno),))
    return None


def never_awaited(sources: Sources) -> Cause | None:
    """`asyncio.sleep(0.1)` as a whole line, or such a call of the learner's own `async def`."""
    own = {node.name for _, node in nodes(sources) if isinstance(node, ast.AsyncFunctionDef)}
    own -= {node.name for _, node in nodes(sources) if isinstance(node, ast.FunctionDef)}
    for file, node in nodes(sources):
        call = node.value if isinstance(node, ast.Expr) else None
        if isinstance(call, ast.Call) and (called_name(call) in own or ast.unparse(call.func) in _COROUTINES):
            text = f"Without `await`, `{ast.unparse(call.func)}(...)` does nothing: write `await` before it."
            return Cause(text, (Location(file, call.lineno),))
    return None


_COROUTINES = ("asyncio.sleep", "asyncio.wait", "asyncio.wait_for", "asyncio.to_thread")


def assigned_backward(sources: Sources) -> Cause | None:
    """`value = self.value`, where `value` is the function's argument, and is not used after that."""
    for file, function in nodes(sources):
        inside = list(ast.walk(function)) if isinstance(function, _Def) else []
        given = {part.arg for part in inside if isinstance(part, ast.arg)} - {"self"}
        given -= {part.id for part in inside if isinstance(part, ast.Name) and not _is_stored(part)}
        for line in inside:
            match line:
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.Attribute() as kept) if name in given:
                    right = f"{ast.unparse(kept)} = {name}"
                    text = f"The side left of `=` gets the value. Swap the two sides: `{right}`."
                    return Cause(text, (Location(file, line.lineno),))
    return None


def missing_sign(sources: Sources) -> Cause | None:
    """A file that Python can read after one sign is added or replaced."""
    for file, text in sources.files.items():
        broken = read(text) if file.endswith(".py") and len(text) <= LONGEST else None
        lines = text.splitlines()
        begin = broken.lineno or 1 if isinstance(broken, SyntaxError) else len(lines) + 1
        for at, line in enumerate(lines[begin - 1 : begin + _LINES_TRIED], start=begin):
            for pattern, right, advice in _SIGNS:
                changed = re.sub(pattern, right, line, count=1)
                mended = "\n".join((*lines[: at - 1], changed, *lines[at:]))
                if changed != line and isinstance(read(mended), ast.Module):
                    written = advice.format(line=at, right=changed.strip())
                    return Cause(written, (Location(file, at),))
    return None


_LINES_TRIED = 20
_SIGNS = (
    (r"(?<=[\w)\]}'\"])\s*(?=#|$)", ",", "A comma is missing at the end of line {line}."),
    (r"(['\"])\s*=\s*(?!=)", r"\1: ", "In a dict, write `:` in place of `=`: `{right}`."),
    (r"(?<=[\w)\]}'\"])\s*(?=#|$)", ":", "A colon is missing at the end of line {line}."),
)


def never_counts(sources: Sources) -> Cause | None:
    """A count that a callback resets on each call, or of which it only increases a copy."""
    for callback in callbacks(sources):
        body = callback.node.body
        added = {ast.unparse(target) for line in body if (target := _added_to(line))}
        for line in body:
            if not isinstance(line, ast.Assign) or (name := ast.unparse(line.targets[0])) not in added:
                continue
            value = ast.unparse(line.value)
            if isinstance(line.value, ast.Constant):
                own = name if "." in name else f"self.{name}"
                text = f"Each call sets `{name}` to {value} again. Set `{own}` once instead, in `__init__`."
                return Cause(text, (Location(callback.file, line.lineno),))
            if value.startswith("self.") and value not in added | {ast.unparse(t) for t in _targets(body)}:
                text = f"`{name}` is a copy of `{value}`, which never changes. Add to `{value}` itself."
                return Cause(text, (Location(callback.file, line.lineno),))
    return None


def local_copy(sources: Sources) -> Cause | None:
    """`count = self.count + 1` in a callback, where nothing else changes `self.count`."""
    every = [node for _, node in nodes(sources)]
    for callback in callbacks(sources):
        inside = list(ast.walk(callback.node))
        read = {part.id for part in inside if isinstance(part, ast.Name) and not _is_stored(part)}
        for line in inside:
            match line:
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.BinOp(left=ast.Attribute() as own)):
                    written, place = ast.unparse(own), Location(callback.file, line.lineno)
                    stores = [one for one in every if isinstance(one, ast.Attribute) and _is_stored(one)]
                    changed = sum(ast.unparse(one) == written for one in stores)
                    if name not in read and name in own.attr and changed <= 1:
                        right = f"{written} = {ast.unparse(line.value)}"
                        text = f"`{name}` is a variable of this function only, so `{written}` never changes."
                        return Cause(f"{text} Write `{right}`.", (place,))
    return None


def _targets(body: Iterable[ast.stmt]) -> list[ast.expr]:
    return [target for line in body if isinstance(line, ast.Assign) for target in line.targets]


def _added_to(line: ast.stmt) -> ast.expr | None:
    """`count`, for `count += 1` and `count = count + 1`."""
    if isinstance(line, ast.AugAssign):
        return line.target
    if isinstance(line, ast.Assign) and isinstance(line.value, ast.BinOp):
        target = line.targets[0]
        return target if ast.unparse(line.value.left) == ast.unparse(target) else None
    return None


def waits_for_input(sources: Sources) -> Cause | None:
    """A program that waits for input, although nobody is there to type."""
    found = calls(sources, "input")
    text = "`input` waits until someone types a line, but nobody does during a check: remove it."
    return Cause(text, (found[0].where,)) if found else None


def class_spun(sources: Sources) -> Cause | None:
    """`rclpy.spin(Talker)`, where `Talker` is one of the learner's classes."""
    own = {node.name for _, node in nodes(sources) if isinstance(node, ast.ClassDef)}
    for call in calls(sources, "spin"):
        given = call.argument(0, "node")
        if isinstance(given, ast.Name) and given.id in own:
            text = f"`{given.id}` is the class. Create a node from it with parentheses: `{given.id}()`."
            return Cause(text, (call.where,))
    return None


def filled_late(sources: Sources) -> Cause | None:
    """A message whose fields are set only after it was published."""
    for file, function in nodes(sources):
        lines = function.body if isinstance(function, _Def) else []
        for line, after in pairwise(lines):
            call = line.value if isinstance(line, ast.Expr) else None
            given = call.args if isinstance(call, ast.Call) and called_name(call) == "publish" else []
            target = after.targets[0] if isinstance(after, ast.Assign) else None
            if given and isinstance(target, ast.Attribute) and _root(target) == ast.unparse(given[0]):
                return Cause(
                    f"The message is published before line {after.lineno} fills it. Move `publish` below the "
                    "lines that set its fields.",
                    (Location(file, line.lineno), Location(file, after.lineno)),
                )
    return None


def broken_loop(sources: Sources) -> Cause | None:
    """A `while` loop with a `break` that is not inside an `if`."""
    for file, loop in nodes(sources):
        body = loop.body if isinstance(loop, ast.While) else []
        tries = [part for line in body if isinstance(line, ast.Try) for part in line.body]
        for line in (*body, *tries):
            if isinstance(line, ast.Break):
                text = f"The `break` on line {line.lineno} ends the loop on its first pass: remove it."
                return Cause(text, (Location(file, line.lineno),))
    return None


def plain_node_spun(sources: Sources) -> Cause | None:
    """`rclpy.spin(Node('x'))`, although one of the learner's classes is the node."""
    classes = [node for _, node in nodes(sources) if isinstance(node, ast.ClassDef)]
    own = next((one.name for one in classes if "Node" in map(ast.unparse, one.bases)), None)
    for call in calls(sources, "spin") if own else ():
        if any(_calls(given, "Node") for given in call.args[:1]):
            return Cause(
                f"`spin` gets a plain `Node`, so nothing calls the callbacks of `{own}`. Pass it a "
                f"node of your class: `rclpy.spin({own}())`.",
                (call.where,),
            )
    return None


def asked_at_once(sources: Sources) -> Cause | None:
    """`if future.done():` just below `future = client.call_async(...)`."""
    for file, function in nodes(sources):
        lines = function.body if isinstance(function, _Def) else []
        for line, after in pairwise(lines):
            called = isinstance(line, ast.Assign) and _calls(line.value, "call_async")
            if called and isinstance(after, ast.If) and _calls(after.test, "done"):
                return Cause(
                    "This line asks once, right after the call, before the answer can arrive. Let "
                    "`add_done_callback` call your function when it does.",
                    (Location(file, after.lineno),),
                )
    return None


def _calls(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.Call) and called_name(node) == name


def _in(places: Iterable[Location], text: str) -> Cause | None:
    where = tuple(places)
    return Cause(text, where[:2]) if where else None


def named_only(text: str, sources: Sources) -> Cause | None:
    """A text such as `<bound method Future.result of ...>`, which the program printed or logged."""
    found = re.search(r"<(?:bound method|built-in method|function) (?:\w+\.)*(\w+)", text)
    if found is None:
        return None
    text = f"`{found[1]}` is named, but not called: write `{found[1]}()`, with parentheses."
    return Cause(text, text_places(sources, f".{found[1]}")[:1])


def defined_twice(sources: Sources) -> Cause | None:
    """Two methods of one class, or two functions of one file, with the same name."""
    for file, owner in nodes(sources):
        body = owner.body if isinstance(owner, ast.ClassDef | ast.Module) else []
        plain = [part for part in body if isinstance(part, _Def) and not part.decorator_list]
        before: dict[str, int] = {}
        for part in plain:
            line = before.setdefault(part.name, part.lineno)
            if line != part.lineno:
                text = f"This second `{part.name}` replaces the one on line {line}. Remove one of the two."
                return Cause(text, (Location(file, part.lineno),))
    return None


def destroyed_first(sources: Sources) -> Cause | None:
    """`node.destroy_node()` in a line before `rclpy.spin(node)`, in the same lines of code."""
    for file, block in nodes(sources):
        body = block.body if isinstance(block, _Def | ast.Try) else []
        spins = (number for number, line in enumerate(body) if "spin(" in ast.unparse(line))
        for line in body[: next(spins, 0)]:
            if isinstance(line, ast.Expr) and _calls(line.value, "destroy_node"):
                text = "The node is destroyed before it is spun. Move this line to the end of `main()`."
                return Cause(text, (Location(file, line.lineno),))
    return None


def one_thread(sources: Sources) -> Cause | None:
    """`MultiThreadedExecutor(num_threads=1)` in a program that waits for an answer in a callback."""
    for call in calls(sources, "MultiThreadedExecutor"):
        if number(sources, call.argument(0, "num_threads")) == 1 and in_callbacks(sources, "call"):
            text = (
                "With one thread, no answer can arrive while a callback waits for it. Leave out the number."
            )
            return Cause(text, (call.where,))
    return None


def never_above_zero(sources: Sources) -> Cause | None:
    """`min(0.0, distance)`."""
    for call in calls(sources, "min"):
        if any(isinstance(one, ast.Constant) and one.value == 0 for one in call.args):
            text = "`min(0.0, ...)` is never above zero. `max(0.0, ...)` is never below it."
            return Cause(text, (call.where,))
    return None


def long_sleep(sources: Sources, at_least: float = 0.0) -> Cause | None:
    """A sleep of at least `at_least` seconds in a callback."""
    inside = in_callbacks(sources, "sleep")
    for call in calls(sources, "sleep"):
        value = number(sources, call.argument(0, "secs"))
        if call.where in inside and value is not None and value >= at_least:
            return Cause(
                f"The callback sleeps for {value:g} s, and the node does nothing else in the meantime. "
                "Remove the `sleep`: the timer alone sets the pace.",
                (call.where,),
            )
    return None


def spin_in_a_thread(sources: Sources) -> Cause | None:
    """`Thread(target=rclpy.spin, ...)`."""
    threads = ((call.where, call.argument(1, "target")) for call in calls(sources, "Thread"))
    spinning = (where for where, target in threads if target and "spin" in ast.unparse(target))
    return _in(
        spinning,
        "Call `rclpy.spin(node)` in `main()` itself, in the main thread: only there does Ctrl+C arrive as "
        "KeyboardInterrupt. Any other thread does not see it, and keeps spinning while ROS shuts down.",
    )


def other_response(sources: Sources) -> Cause | None:
    """A server's callback that fills one response object but returns another."""
    for callback in callbacks(sources, "create_service"):
        inside = list(ast.walk(callback.node))
        filled = {_root(n) for n in inside if isinstance(n, ast.Attribute) and _is_stored(n)} - {"self", ""}
        made = {
            ast.unparse(target)
            for n in inside
            if isinstance(n, ast.Assign) and _calls(n.value, "Response")
            for target in n.targets
        }
        ends = [n for n in inside if isinstance(n, ast.Return) and isinstance(n.value, ast.Name)]
        wrong = [n for n in ends if isinstance(n.value, ast.Name) and n.value.id not in filled]
        if filled & (made | set(callback.parameters[1:])) and wrong and len(wrong) == len(ends):
            used, given = sorted(filled)[0], ast.unparse(wrong[0].value or wrong[0])
            return Cause(
                f"`{callback.node.name}` fills `{used}`, but returns `{given}`. Return the one that you "
                "fill.",
                (Location(callback.file, wrong[0].lineno),),
            )
    return None


def _root(node: ast.expr) -> str:
    """`response` for `response.point.x`."""
    while isinstance(node, ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def await_in_callback(sources: Sources) -> Cause | None:
    """`await` in a callback while all callbacks share one group, so the answer cannot be processed."""
    if any(group in text for text in sources.files.values() for group in _GROUPS):
        return None
    for callback in callbacks(sources):
        waits = [node.lineno for node in ast.walk(callback.node) if isinstance(node, ast.Await)]
        if waits:
            return Cause(
                "This `await` never ends: the node's callbacks take turns, so the answer waits for this "
                "callback. Use `call_async` without `await`, and read the answer in "
                "`future.add_done_callback(...)`.",
                (Location(callback.file, waits[0]),),
            )
    return None


def logged_seldom(sources: Sources) -> Cause | None:
    """`info(..., once=True)` and the like."""
    for name in _LOGS:
        for call in calls(sources, name):
            option = next((one for one in _SELDOM if one in call.keywords), None)
            if option:
                written = f"{option}={ast.unparse(call.keywords[option])}"
                return Cause(
                    f"`{written}` suppresses most of the log messages: remove it to log each time.",
                    (call.where,),
                )
    quiet = () if any(calls(sources, name) for name in _LOGS[1:]) else calls(sources, "debug")
    return _in(
        (call.where for call in quiet),
        "Messages at level DEBUG are not logged by default: log with `self.get_logger().info(...)`.",
    )


def accidental_tuple(sources: Sources) -> Cause | None:
    """`self.period = 0.5,`, which makes it a tuple."""
    for file, node in nodes(sources):
        value = node.value if isinstance(node, ast.Assign) else None
        if not isinstance(value, ast.Tuple) or len(value.elts) != 1:
            continue
        if value.col_offset == value.elts[0].col_offset:  # without parentheses
            text = ast.unparse(value.elts[0])
            return Cause(
                f"The comma at the end of this line makes a tuple of `{text}`: remove the comma.",
                (Location(file, value.lineno),),
            )
    return None


def late_lambda(sources: Sources) -> Cause | None:
    """A lambda that uses the variable of the loop around it; when called, it sees the last value."""
    for file, loop in nodes(sources):
        if not isinstance(loop, ast.For):
            continue
        names = {part.id for part in ast.walk(loop.target) if isinstance(part, ast.Name)}
        for node in (part for line in loop.body for part in ast.walk(line)):
            if isinstance(node, ast.Lambda):
                used = {part.id for part in ast.walk(node.body) if isinstance(part, ast.Name)}
                own = {argument.arg for argument in node.args.args}
                for name in sorted((names & used) - own):
                    return Cause(
                        f"This lambda looks up `{name}` when it is called, after the loop: by then it has "
                        f"its last value. Keep each value: `lambda ..., {name}={name}: ...`, or `partial`.",
                        (Location(file, node.lineno),),
                    )
    return None


def wrong_guard(sources: Sources) -> Cause | None:
    """`if __name__ == "main":` without the underscores around `main`."""
    for file, node in nodes(sources):
        if isinstance(node, ast.Compare) and ast.unparse(node.left) == "__name__":
            with_ = node.comparators[0]
            if isinstance(with_, ast.Constant) and with_.value != "__main__":
                return Cause(
                    f"`__name__` is never {with_.value!r}: it is `'__main__'`, with two underscores on each "
                    "side, when the file is run.",
                    (Location(file, node.lineno),),
                )
    return None


def shut_down_inside(sources: Sources) -> Cause | None:
    """A callback that ends the program."""
    for name in ("shutdown", "exit", "_exit", "try_shutdown", "destroy_node"):
        found = in_callbacks(sources, name)
        if found:
            return Cause(
                f"A callback calls `{name}`, which ends the node: remove that call.",
                found[:1],
            )
    return None


def taken_away(sources: Sources) -> Cause | None:
    """A callback that destroys what calls it, or always cancels the timer."""
    for name in ("subscription", "timer", "service", "publisher", "client"):
        found = in_callbacks(sources, f"destroy_{name}")
        if found:
            text = f"A callback calls `destroy_{name}`. After that, the {name} no longer exists. "
            return Cause(f"{text}Remove that call.", found[:1])
    timers = {
        ast.unparse(target)
        for _, node in nodes(sources)
        if isinstance(node, ast.Assign) and _calls(node.value, "create_timer")
        for target in node.targets
    }
    always = (
        Location(callback.file, line.lineno)
        for callback in callbacks(sources)
        for line in callback.node.body
        if isinstance(line, ast.Expr) and ast.unparse(line).removesuffix(".cancel()") in timers
    )
    return _in(always, "A callback cancels the timer, so it never runs again. Remove that call.")


def inverted_wait(sources: Sources) -> Cause | None:
    """`while client.wait_for_service():`, or an early `return` if the service is ready."""
    for file, node in nodes(sources):
        if not isinstance(node, ast.While | ast.If) or not isinstance(node.test, ast.Call):
            continue
        leaves = isinstance(node, ast.While) or isinstance(node.body[-1], ast.Return)
        asks = called_name(node.test) in ("wait_for_service", "service_is_ready")
        calls_it = any(_calls(part, name) for part in ast.walk(node) for name in ("call_async", "call"))
        if asks and leaves and not calls_it:
            written = ast.unparse(node.test)
            word = type(node).__name__.lower()
            return Cause(
                f"`{written}` is true once the service is available, so you mean the opposite. Write "
                f"`{word} not {written}:`.",
                (Location(file, node.lineno),),
            )
    return None


def loop_without_sleep(sources: Sources) -> Cause | None:
    """A `while` loop with a `sleep` right after it, but none inside."""
    for file, outer in nodes(sources):
        body = getattr(outer, "body", [])
        for loop, after in pairwise(body if isinstance(body, list) else []):
            sleeps = [part for part in ast.walk(after) if _calls(part, "sleep")]
            endless = isinstance(loop, ast.While) and not any(
                _calls(part, "sleep") for part in ast.walk(loop)
            )
            if endless and sleeps and isinstance(after, ast.Expr):
                return Cause(
                    f"This `sleep` is after the loop on line {loop.lineno}, not in it: indent it like the "
                    "lines in the loop.",
                    (Location(file, after.lineno),),
                )
    return None


def several_timers(sources: Sources) -> Cause | None:
    """Two timers that call the same function, or one that is created again and again."""
    again = in_callbacks(sources, "create_timer")
    if again:
        return Cause(
            "A callback creates a new timer each time it runs. Create it once, in `__init__`.", again[:1]
        )
    first_of: dict[str, Location] = {}
    for call in calls(sources, "create_timer"):
        callback = call.argument(1, "callback")
        name = ast.unparse(callback) if callback else ""
        if name in first_of:
            return Cause(f"Two timers call `{name}`: remove one of the two.", (call.where, first_of[name]))
        first_of[name] = call.where
    return None


def quoted_variable(sources: Sources, maker: str, topics: Iterable[str]) -> Cause | None:
    """`create_publisher(Quote, 'topic_name', 10)`, where `topic_name` is a variable."""
    given = {node.id for _, node in nodes(sources) if isinstance(node, ast.Name) and _is_stored(node)}
    for call in calls(sources, maker):
        name = getattr(call.argument(1, "topic"), "value", None)
        if name in given and f"/{name}" in topics:
            text = f"`'{name}'` in quotation marks is a text, not the variable `{name}`: remove the marks."
            return Cause(text, (call.where,))
    return None


def made_again(sources: Sources, maker: str) -> Cause | None:
    """`maker`, such as `create_publisher`, called in a callback."""
    return _in(
        in_callbacks(sources, maker),
        f"A callback calls `{maker}` each time it runs. Call it once, in `__init__`, and keep what it "
        "returns: `self.publisher = ...`.",
    )


def standstill(sources: Sources) -> Cause | None:
    """Why a client asks once and then never again."""
    return blocking_call(sources) or spin_in_callback(sources)
