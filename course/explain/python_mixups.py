"""Errors of Python where the line that fails may be right: the code shows what was mixed up, and where."""

from __future__ import annotations

import ast
import builtins
import re
from collections.abc import Iterator

from course.explain.callbacks import TAKERS
from course.explain.engine import Evidence, Known, Proven, Symptom, Words, here
from course.explain.python_code import (
    called_name,
    calls,
    function_around,
    functions,
    last_name,
    nodes,
    parsed,
    takes_self,
    trees,
)
from course.model.feedback import Location

_LACKS = r"'(?P<of>\w+)' object has no attribute '(?P<name>\w+)'"
_UNDEFINED = r"name '(?P<name>\w+)' is not defined"
_OF_RCLPY = {"spin", "spin_once", "init", "shutdown", "ok"}


def _classes(evidence: Evidence) -> Iterator[tuple[str, ast.ClassDef]]:
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.ClassDef):
            yield file, node


def _attributes(top: ast.AST, context: type[ast.expr_context]) -> Iterator[ast.Attribute]:
    """`self.x` where it is set (ast.Store) or deleted (ast.Del)."""
    for node in ast.walk(top):
        if (
            isinstance(node, ast.Attribute)
            and isinstance(node.ctx, context)
            and ast.unparse(node.value) == "self"
        ):
            yield node


def _function_with_self(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`def main(self)` at the left margin."""
    for file, tree in trees(evidence.sources):
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and node.name == words["name"] and takes_self(node):
                return Proven(where=(Location(file, node.lineno),))
    return None


def _arguments_beside(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`create_task(work, tag)`, `add_done_callback(done, tag)`."""
    for call in calls(evidence.sources, words["name"]):
        given = [ast.unparse(one) for one in call.args]
        if len(given) > 1 and words["name"] == "create_task":
            return Proven({"right": f"create_task({given[0]}({', '.join(given[1:])}))"}, (call.where,))
        if len(given) > 1:
            return Proven({"right": f"{words['name']}(partial({', '.join(given)}))"}, (call.where,))
    return None


def _of_the_module(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`count = 0` at the left margin, and `count += 1` in a function."""
    for _, tree in trees(evidence.sources):
        for node in tree.body:
            targets = node.targets if isinstance(node, ast.Assign) else ()
            if any(isinstance(one, ast.Name) and one.id == words["name"] for one in targets):
                return Proven()
    return None


def _hides_a_method(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.count = 0` in a class with `def count(self)`."""
    for file, owner in _classes(evidence):
        methods = {part.name for part in owner.body if isinstance(part, ast.FunctionDef)}
        for node in _attributes(owner, ast.Store):
            if node.attr in methods:
                given = {"name": node.attr, "line": str(node.lineno)}
                return Proven(given, (Location(file, node.lineno),))
    return None


def _of_rclpy(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    own = {node.name for _, node in _classes(evidence)}
    return Proven() if words["name"] in _OF_RCLPY and words["of"] in own else None


def _deleted(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`del self.timer`."""
    for file, owner in _classes(evidence):
        for node in _attributes(owner, ast.Del):
            if (owner.name, node.attr) == (words["of"], words["name"]):
                return Proven({"line": str(node.lineno)}, (Location(file, node.lineno),))
    return None


def _other_underscores(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.__name` is set, and `self._name` is read."""
    wanted = words["name"].removeprefix(f"_{words['of']}")
    for file, owner in _classes(evidence):
        for node in _attributes(owner, ast.Store) if owner.name == words["of"] else ():
            if node.attr != wanted and node.attr.strip("_") == wanted.strip("_"):
                given = {"other": node.attr, "wanted": wanted, "line": str(node.lineno)}
                return Proven(given, (Location(file, node.lineno),))
    return None


def _comma_before_parentheses(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """Two tuples in a list, without a comma between them."""
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Tuple):
            line = node.func.end_lineno or node.func.lineno
            return Proven({"line": str(line)}, (Location(file, line),))
    return None


def _whole_vector(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.speed = message.linear`."""
    for file, node in nodes(evidence.sources):
        value = node.value if isinstance(node, ast.Assign) else None
        if isinstance(value, ast.Attribute) and value.attr in ("linear", "angular"):
            given = {"line": str(value.lineno), "right": f"{ast.unparse(value)}.x"}
            return Proven(given, (Location(file, value.lineno),))
    return None


def _name_of_a_parameter(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.get_parameter(speed)`."""
    for call in (
        call for name in ("get_parameter", "declare_parameter") for call in calls(evidence.sources, name)
    ):
        given = call.args[0] if call.args else None
        if isinstance(given, ast.Name) and given.id == words["name"]:
            return Proven(where=(call.where,))
    return None


def _super_not_called(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`super.__init__('talker')`."""
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "super":
            return Proven(where=(Location(file, node.lineno),))
    return None


def _already_a_message(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`message = Quote()`, and then `message()`."""
    made = {
        target.id
        for _, node in nodes(evidence.sources)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call)
        for target in node.targets
        if isinstance(target, ast.Name) and ast.unparse(node.value.func) == words["of"]
    }
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in made:
            return Proven({"name": node.func.id}, (Location(file, node.lineno),))
    return None


def _shut_down_first(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`rclpy.shutdown()` in a line before `rclpy.spin(node)`, in the same file."""
    for end in calls(evidence.sources, "shutdown"):
        for spin in calls(evidence.sources, "spin"):
            if end.where.file == spin.where.file and (end.where.line or 0) < (spin.where.line or 0):
                return Proven(where=(end.where,))
    return None


def _wrong_argument(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`safe_speed(message)`, where the function subtracts from its argument."""
    around, place = function_around(evidence.sources, symptom.where), symptom.where
    given = calls(evidence.sources, around.name) if around else ()
    if around is None or place is None or len(given) != 1:
        return None
    parameters = {one.arg for one in around.args.args} - {
        node.id for node in ast.walk(around) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    }
    for node in ast.walk(around):
        if isinstance(node, ast.BinOp) and node.lineno == place.line:
            for operand, of in ((node.left, words["left"]), (node.right, words["right"])):
                if isinstance(operand, ast.Name) and operand.id in parameters and of[0].isupper():
                    return Proven({"function": around.name, "name": operand.id, "of": of}, (given[0].where,))
    return None


def _on_the_class(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`Sample.get_name('a')`, where `self` becomes a string."""
    around = function_around(evidence.sources, symptom.where)
    for _, owner in _classes(evidence):
        if around and around in owner.body and words["of"] != owner.name:
            for file, node in nodes(evidence.sources):
                if (
                    isinstance(node, ast.Attribute)
                    and isinstance(node.value, ast.Name)
                    and (node.value.id, node.attr) == (owner.name, around.name)
                ):
                    return Proven({"written": ast.unparse(node)}, (Location(file, node.lineno),))
    return None


def _only_named(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`response = future.result`, and then `response.point`."""
    around, place = function_around(evidence.sources, symptom.where), symptom.where
    inside = list(ast.walk(around)) if around else []
    given = {
        ast.unparse(target): node.value
        for node in inside
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Attribute)
        for target in node.targets
    }
    for node in inside:
        if (
            isinstance(node, ast.Attribute)
            and place
            and (node.lineno, node.attr) == (place.line, words["name"])
        ):
            named = given.get(ast.unparse(node.value), node.value)
            if isinstance(named, ast.Attribute):
                return Proven({"written": ast.unparse(named)}, (Location(place.file, named.lineno),))
    return None


def _partial_with_too_few(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`partial(send, publisher)`, where `send` needs more."""
    own = [call for call in calls(evidence.sources, "partial") if call.args]
    found = [call.where for call in own if last_name(call.args[0]) == words["name"]]
    return Proven(where=tuple(found)) if found and not calls(evidence.sources, words["name"]) else None


def _gets_the_future_alone(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`add_done_callback(done)`, where `done` takes more than the future."""
    for call in calls(evidence.sources, "add_done_callback"):
        if call.args and last_name(call.args[0]) == words["name"]:
            return Proven({"given": ast.unparse(call.args[0])}, (call.where,))
    return None


def _calls_at(evidence: Evidence, place: Location | None) -> Iterator[ast.Call]:
    """The calls that begin on this line."""
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.Call) and Location(file, node.lineno) == place:
            yield node


def _called_in_place(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`signal(SIGINT, stop())`, `Thread(target=work())`: what takes a function gets a call of it."""
    if not functions(evidence.sources, words["name"]):
        return None
    for call in _calls_at(evidence, symptom.where):
        given = [one.value for one in call.keywords if one.arg in ("target", "callback", "key")]
        for one in (*given, *(call.args if called_name(call) in _TAKE_FUNCTIONS else ())):
            match one:
                case ast.Call(args=[], keywords=[]) if called_name(one) == words["name"]:
                    return Proven({"written": ast.unparse(one), "right": ast.unparse(one.func)})
    return None


_TAKE_FUNCTIONS = {"signal", "map", "filter", "register", "partial", "call_later", "call_soon", *TAKERS}


def _hint_only(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.count: int`, where `=` and a value are missing."""
    owners = list(_classes(evidence))
    fields = {id(line) for _, owner in owners for line in owner.body}  # as in a dataclass
    inside = ((file, node) for file, one in owners if one.name == words.get("of") for node in ast.walk(one))
    for file, node in inside if "of" in words else nodes(evidence.sources):
        if not isinstance(node, ast.AnnAssign) or node.value is not None or id(node) in fields:
            continue
        target, kind = ast.unparse(node.target), ast.unparse(node.annotation)
        if last_name(node.target) == words["name"] and ("." in target) == ("of" in words):
            right = f"{target}: {kind} = ..." if kind in dir(builtins) else f"{target} = {kind}"
            given = {"line": str(node.lineno), "written": f"{target}: {kind}", "right": right}
            return Proven(given, (Location(file, node.lineno),))
    return None


def _by_name_only(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`spin_once(node, 0.1)`, where the last argument has to be passed by its name."""
    own = functions(evidence.sources, words["name"])
    others = _BY_NAME.get(words["name"]) if not own and f".{words['name']}(" not in symptom.text else None
    first, names = (own[0].args.args, [one.arg for one in own[0].args.kwonlyargs]) if own else ((0,), others)
    count = len(first) - (bool(own) and takes_self(own[0]))
    for call in calls(evidence.sources, words["name"]) if names else ():
        more = [
            f"{name}={ast.unparse(one)}" for name, one in zip(names or (), call.args[count:], strict=False)
        ]
        if call.where == symptom.where and more and len(call.args) <= count + len(names or ()):
            before = [ast.unparse(one) for one in call.args[:count]]
            given = " and ".join(f"`{one}`" for one in more)
            return Proven({"names": given, "right": f"{words['name']}({', '.join([*before, *more])})"})
    return None


# Functions of others that take one argument by position: what they take by name.
_BY_NAME = {"spin_once": ["timeout_sec"], "wait": ["timeout"]}


def _imported_from(evidence: Evidence, *parts: str) -> set[str]:
    """Names that are imported from `talk.msg` and the like."""
    every = [node for _, node in nodes(evidence.sources) if isinstance(node, ast.ImportFrom)]
    found = [one for one in every if (one.module or "").endswith(parts)]
    return {alias.asname or alias.name for one in found for alias in one.names}


def _message_by_position(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`JointState(positions)`, `Trigger.Request(True)`, for classes from a package of interfaces."""
    names = _imported_from(evidence, ".msg", ".srv", ".action")
    for call in _calls_at(evidence, symptom.where):
        made = ast.unparse(call.func)
        if call.args and made.partition(".")[0] in names and words["of"].startswith(made.partition(".")[0]):
            return Proven({"made": made, "given": ast.unparse(call.args[0])})
    return None


def _has(evidence: Evidence, file: str, name: str) -> bool:
    """Whether a file defines this name, or, as an `__init__.py`, imports it."""
    tree = parsed(evidence.sources.files.get(file, "")) if file.endswith(".py") else None
    names: set[str] = set()
    for node in tree.body if tree else ():
        if isinstance(node, ast.ImportFrom) and file.endswith("/__init__.py"):
            names |= {alias.asname or alias.name for alias in node.names}
        elif isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            names.add(node.name)
        elif isinstance(node, ast.Assign):
            names |= {ast.unparse(one) for one in node.targets}
    return name in names


def _in_a_part(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`from talk import Quote`, where talk.words has it; perhaps in talk/__init__.py itself."""
    package = f"/{words['module'].replace('.', '/')}/"
    inside = [name for name in evidence.sources.files if package in f"/{name}" and "/test/" not in name]
    own = f"{package}__init__.py"
    found = [one for one in inside if _has(evidence, one, words["name"]) and not f"/{one}".endswith(own)]
    parts = [f"/{one}".rpartition(package)[2].removesuffix(".py").removesuffix("/__init__") for one in found]
    parts.sort(key=lambda part: ("_" in (part[0], part.rpartition("/")[2][0]), part.count("/"), part))
    itself = {"both": ""} if "partially" in symptom.text else {}
    itself |= {"itself": ""} if symptom.where and f"/{symptom.where.file}".endswith(own) else {}
    right = f"{words['module']}.{parts[0].replace('/', '.')}" if parts else ""
    return Proven({"right": right, **itself}) if parts else None


_TAKES = r"\b(?P<name>\w+)\(\) takes .*positional arguments? but \d+ (?:was|were) given"


def _without_arguments(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`def main(args):`, where every call, such as that of an entry point, is `main()`."""
    own = [one for one in functions(evidence.sources, "main") if len(one.args.args) > len(one.args.defaults)]
    if len(own) != 1 or takes_self(own[0]) or any(one.args for one in calls(evidence.sources, "main")):
        return None
    needed = ", ".join(f"{one.arg}=None" for one in own[0].args.args)
    places = (Location(file, own[0].lineno) for file, tree in trees(evidence.sources) if own[0] in tree.body)
    return Proven({"right": f"def main({needed}):"}, tuple(places))


def _result_not_awaited(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`task.result()` in an `async def`, where `await task` waits for the result."""
    waiting = [node for _, node in nodes(evidence.sources) if isinstance(node, ast.AsyncFunctionDef)]
    inside = {id(part) for node in waiting for part in ast.walk(node)}
    for call in _calls_at(evidence, symptom.where):
        if id(call) in inside and called_name(call) == "result" and isinstance(call.func, ast.Attribute):
            right = f"await {ast.unparse(call.func.value)}"
            return Proven({"written": ast.unparse(call), "right": right})
    return None


def _type_of_service(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`Trigger()`, where `Trigger` is imported from a package of services."""
    made = [ast.unparse(call.func) for call in _calls_at(evidence, symptom.where)]
    found = [one for one in made if one in _imported_from(evidence, ".srv")]
    return Proven({"type": found[0]}) if found else None


def _without_default(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`declare_parameter('period')`, whose value this line uses."""
    shown = evidence.shown(symptom.where)[:1] if symptom.where else ()
    given = [node for _, node in nodes(evidence.sources) if isinstance(node, ast.Assign)]
    for call in calls(evidence.sources, "declare_parameter"):
        name = ast.unparse(call.args[0]) if len(call.args) == 1 and not call.keywords else "?"
        values = [last_name(one.targets[0]) for one in given if f"({name})" in ast.unparse(one.value)]
        if any(re.search(rf"\b{re.escape(value)}\b", line) for line in shown for value in values):
            return Proven({"name": name}, (call.where,))
    return None


MIXUPS: tuple[Known[Evidence], ...] = (
    Known(r"'NoneType'",
          "This line gets `None`: `declare_parameter({name})` sets no default value. Write "
          "`declare_parameter({name}, ...)`.",
          "TypeError: float() argument must be a string or a real number, not 'NoneType'",
          proof=_without_default, where=(here,),
          given={"talk/talker.py": "node.declare_parameter('period')\n"
                 "period = node.get_parameter('period').value\nnode.create_timer(period, tick)  # here\n"}),
    Known(r"(?<!\.)\b(?P<name>main)\(\) missing \d+ required positional argument",
          "The program calls `main()` without arguments. Write `{right}`.",
          "TypeError: main() missing 1 required positional argument: 'args'", proof=_without_arguments,
          given={"talk/talker.py": "def main(args):\n    pass\n"}),
    Known(r"InvalidStateError",
          "The task has not finished yet, so it has no result. `{right}` waits for it: write that in place "
          "of `{written}`.",
          "asyncio.exceptions.InvalidStateError: Result is not set.", proof=_result_not_awaited,
          where=(here,), given={"talk/talker.py": "async def ask(task):\n    task.result()  # here\n"}),
    Known(r"must be a keyword argument: (?P<named>\w+)=(?P<value>\w+)",
          "Pass this number by name: `{named}=...`.",
          "TypeError: The number of choices must be a keyword argument: k=10"),
    Known(r"Service classes can not be instantiated",
          "A service has two kinds of messages. Create a request like this: `{type}.Request()`.",
          "NotImplementedError: Service classes can not be instantiated", proof=_type_of_service,
          where=(here,),
          given={"talk/talker.py": "from talk.srv import Tell\nTell()  # here\n"}),
    Known(r"(?P<name>\w+)\(\) missing \d+ required (?:positional|keyword-only) argument",
          "`{written}` calls the function here, before it is needed. Pass the function itself: `{right}`.",
          "TypeError: stop() missing 2 required positional arguments: 'number' and 'frame'",
          proof=_called_in_place, where=(here,),
          given={"talk/talker.py": "signal.signal(SIGINT, stop())  # here\ndef stop(number, frame): pass\n"}),
    Known(r"(?:'(?P<of>\w+)' object has no attribute|name|variable) '(?P<name>\w+)'",
          "On line {line}, `{written}` is only a type hint, and assigns nothing. Write `{right}`.",
          "AttributeError: 'Talker' object has no attribute 'count'", proof=_hint_only,
          given={"talk/talker.py": "class Talker:\n    def __init__(self, n):\n        self.count: n\n"}),
    Known(_TAKES, "Pass {names} by name: `{right}`.",
          "TypeError: spin_once() takes 1 positional argument but 2 were given", proof=_by_name_only,
          where=(here,), given={"talk/talker.py": "rclpy.spin_once(node, 0.1)  # here\n"}),
    Known(r"(?P<of>\w+)\.__init__\(\) takes 1 positional argument but \d+ (?:was|were) given",
          "A message takes its fields by name: `{made}(field={given})`, with the field's name.",
          "TypeError: Quote.__init__() takes 1 positional argument but 2 were given",
          proof=_message_by_position, where=(here,),
          given={"talk/talker.py": "from talk.msg import Quote\nmessage = Quote('Hi')  # here\n"}),
    Known(r"cannot import name '(?P<name>\w+)' from (?:partially initialized module )?'(?P<module>[\w.]+)'",
          ("{itself}This file imports `{name}` from itself. Write `from {right} import {name}`.",
           "{both}Two files import each other. Write `from {right} import {name}` here, which avoids that.",
           "`{name}` is in `{right}`: write `from {right} import {name}`."),
          "ImportError: cannot import name 'Quote' from 'talk'", proof=_in_a_part,
          given={"talk/words/__init__.py": "from talk.words._quote import Quote\n"}),
    Known(r"(?<!\.)\b(?P<name>\w+)\(\) missing 1 required positional argument: 'self'",
          "`{name}` is a function, not a method of a class: remove `self` from its `def`.",
          "TypeError: main() missing 1 required positional argument: 'self'", proof=_function_with_self,
          given={"talk/talker.py": "def main(self):\n    pass\n"}),
    Known(r"\b(?P<name>create_task|add_done_callback)\(\) takes .* given", "Write `{right}`.",
          "TypeError: create_task() takes 1 positional argument but 2 were given", proof=_arguments_beside,
          given={"talk/talker.py": "asyncio.create_task(work, 'tag')\n"}),
    Known(r"(?:cannot access local|local) variable '(?P<name>\w+)'",
          "`{name}` is defined outside this function. To change it, begin the function with `global {name}`.",
          "UnboundLocalError: cannot access local variable 'count'", proof=_of_the_module,
          given={"talk/talker.py": "count = 0\n\ndef tick():\n    count += 1\n"}),
    Known(r"'\w+' object is not callable",
          "Line {line} sets `self.{name}`, which hides the method `{name}`. They need different names.",
          "TypeError: 'int' object is not callable", proof=_hides_a_method,
          given={"talk/talker.py": "class Talker:\n    def count(self):\n        self.count = 1\n"}),
    Known(r"unsupported operand type\(s\) for \S+ '(?P<left>\w+)' and '(?P<right>\w+)'",
          "`{function}` gets a whole `{of}` as its `{name}`. Pass the field that it needs.",
          "TypeError: unsupported operand type(s) for -: 'Range' and 'float'", proof=_wrong_argument,
          given={"talk/talker.py": "def speed(far): return far - 1  # here\n\nspeed(message)\n"}),
    Known(_LACKS, "`{written}` calls the method on the class. Call it on an object of the class.",
          "AttributeError: 'str' object has no attribute '_name'", proof=_on_the_class,
          given={"talk/talker.py": "class Tag:\n    def get(self): self._name  # here\nTag.get('a')\n"}),
    Known(r"'(?:builtin_function_or_method|function|method)' object has no attribute '(?P<name>\w+)'",
          "`{written}` is named here, but not called: write `{written}()`.",
          "AttributeError: 'function' object has no attribute 'x'", proof=_only_named,
          given={"talk/talker.py": "def tell(future):\n    found = future.result\n    found.x  # here\n"}),
    Known(r"\b(?P<name>\w+)\(\) missing \d+ required positional arguments?",
          "`add_done_callback` passes only the future. Bind the other arguments: `partial({given}, ...)`.",
          "TypeError: done() missing 1 required positional argument: 'future'", proof=_gets_the_future_alone,
          given={"talk/talker.py": "task.add_done_callback(done)\ndef done(tag, future): pass\n"}),
    Known(r"\b(?P<name>\w+)\(\) missing \d+ required positional arguments?: (?P<lost>.*)",
          "This `partial` passes too few arguments to `{name}`: {lost} is missing.",
          "TypeError: send() missing 1 required positional argument: 'text'", proof=_partial_with_too_few,
          given={"talk/talker.py": "create_timer(1, partial(send, node))\ndef send(node, text): pass\n"}),
    *(
        Known[Evidence](
            rf"Node\.{name}\(\) (?:takes .* given|got an unexpected keyword)",
            f"Write `{name}({usage})`: it takes nothing else here.",
            f"TypeError: Node.{name}() takes 4 positional arguments but 5 were given",
        )
        for name, usage in (
            ("create_publisher", "Type, 'topic', 10"),
            ("create_subscription", "Type, 'topic', self.callback, 10"),
            ("create_timer", "0.5, self.callback"),
        )
    ),
    Known(r"spin_until_future_complete\(\) missing",
          "`spin_until_future_complete` waits for a future. `rclpy.spin(node)` runs until Ctrl+C.",
          "TypeError: spin_until_future_complete() missing 1 required positional argument: 'future'"),
    Known(r"'Publisher' object has no attribute", "A publisher sends a message with `publish(message)`.",
          "AttributeError: 'Publisher' object has no attribute 'send'"),
    Known(_LACKS, "`{name}` is a function of rclpy: write `rclpy.{name}(...)`.",
          "AttributeError: 'Talker' object has no attribute 'spin'", proof=_of_rclpy,
          given={"talk/talker.py": "class Talker(Node):\n    pass\n"}),
    Known(_LACKS, "Line {line} deletes `self.{name}`. If it is a timer, call its `cancel()` instead.",
          "AttributeError: 'Talker' object has no attribute 'timer'", proof=_deleted,
          given={"talk/talker.py": "class Talker(Node):\n    def stop(self):\n        del self.timer\n"}),
    Known(_LACKS, "Line {line} sets `{other}`, not `{wanted}`: the underscores differ. Use one name.",
          "AttributeError: 'Talker' object has no attribute '_count'", proof=_other_underscores,
          given={"talk/talker.py": "class Talker:\n    def __init__(self):\n        self.__count = 0\n"}),
    Known(r"No module named '(?P<package>\w+)\.(?P<kind>msg|srv|action)\.(?P<name>[A-Z]\w*)'",
          "`import` alone works only for modules: write `from {package}.{kind} import {name}`.",
          "ModuleNotFoundError: No module named 'talk.msg.Quote'"),
    Known(r"'tuple' object is not callable",
          "A comma is missing at the end of line {line}, so Python reads the next parentheses as a call.",
          "TypeError: 'tuple' object is not callable", proof=_comma_before_parentheses,
          given={"talk/talker.py": "QUOTES = [('a', 'b') ('c', 'd')]\n"}),
    Known(r"'Vector3'", "Line {line} uses the whole vector. The speed straight ahead is `{right}`.",
          "TypeError: unsupported operand type(s) for *: 'Vector3' and 'float'", proof=_whole_vector,
          given={"talk/talker.py": "speed = message.linear\n"}),
    Known(_UNDEFINED, "A parameter's name is a string: write `'{name}'`, in quotation marks.",
          "NameError: name 'speed' is not defined", proof=_name_of_a_parameter,
          given={"talk/talker.py": "node.get_parameter(speed)\n"}),
    Known(r"descriptor|super", "`super` needs parentheses, too: `super().__init__(...)`.",
          "TypeError: descriptor '__init__' requires a 'super' object but received a 'str'",
          proof=_super_not_called, given={"talk/talker.py": "super.__init__('talker')\n"}),
    Known(r"random\(\) takes no arguments", "`random.random()` takes no limits. Use `random.uniform(1, 2)`.",
          "TypeError: Random.random() takes no arguments (2 given)"),
    Known(r"'(?P<of>[A-Z]\w*)' object is not callable",
          "`{name}` is a message already: leave out the parentheses after it.",
          "TypeError: 'Quote' object is not callable", proof=_already_a_message,
          given={"talk/talker.py": "message = Quote()\nnode.publish(message())\n"}),
    Known(r"a coroutine was expected, got <function (?P<name>\w+)", "Call the function: `{name}()`.",
          "ValueError: a coroutine was expected, got <function main at 0x1>"),
    Known(r"\S: (?:'\w+' and 'method'|'method' and)",
          "This line names a method but does not call it: its parentheses are missing.",
          "TypeError: unsupported operand type(s) for +: 'float' and 'method'"),
    Known(r"does not support the context manager protocol|\(AttributeError: __enter__\)",
          "`rclpy.shutdown()` comes before `rclpy.spin(...)`: move it to the end.",
          "TypeError: 'NoneType' object does not support the context manager protocol",
          proof=_shut_down_first, given={"talk/talker.py": "rclpy.shutdown()\nrclpy.spin(node)\n"}),
)  # fmt: skip
