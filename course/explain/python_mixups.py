"""Errors of Python where the line that fails may be right: the code shows what was mixed up, and where."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from course.explain.engine import Evidence, Known, Proven, Symptom, Words
from course.explain.python_code import calls, function_around, last_name, nodes, takes_self, trees
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


MIXUPS: tuple[Known[Evidence], ...] = (
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
