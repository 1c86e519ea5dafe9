"""Grader of chapter 14: a library, tried as it is installed, from a folder where its sources do not lie."""

from __future__ import annotations

import ast
import json
import random
import re
import string
from collections.abc import Callable
from typing import Any

from course.arena.arena import Arena
from course.errors import OurFault
from course.evidence.probe_view import Answer
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location
from course.grading.author import Grader
from course.grading.expect.probes import expect_importable
from course.grading.explain.installed_packages import not_installed, packages_place
from course.grading.explain.names import listed, nearest
from course.grading.explain.python_code import functions, trees
from course.grading.explain.tracebacks import learners_file

PACKAGE = "python_package_with_a_library"
LIBRARY = "sample_python_library"
MODULE = f"{PACKAGE}.{LIBRARY}"
CLASS = "SampleClass"
FUNCTION = "sample_function_for_square_of_sum"
GIVEN = "what was drawn"
EXACT = 1e-9
TRIES = 6
PATIENCE = 5.0  # seconds

# Runs among the learner's programs, after lines that define PAIRS, NAMES and the names from above.
PROBE = """
import importlib, os, sys, traceback

def tell(question, function):
    places = []
    def tried():
        try:
            return function()
        except BaseException as error:
            frames = traceback.extract_tb(error.__traceback__)
            places.extend([frame.filename, frame.lineno] for frame in frames)
            if isinstance(error, SyntaxError):
                places.append([error.filename, error.lineno])
            raise
    ask(question, tried)
    ask(question + " places", lambda: places)

def folders_beside(module):
    top = os.path.dirname(os.path.dirname(module.__file__))
    return sorted(name for name in os.listdir(top) if os.path.isdir(os.path.join(top, name)))

def two_names():
    made = [getattr(library, CLASS)(name) for name in NAMES]
    return [each.get_name() for each in made]

tell("library", lambda: importlib.import_module(MODULE).__file__)
if PACKAGE in sys.modules:
    ask("beside", lambda: folders_beside(sys.modules[PACKAGE]))
if MODULE in sys.modules:
    library = sys.modules[MODULE]
    ask("offered", lambda: [name for name in dir(library) if not name.startswith("__")])
    for name in (CLASS, FUNCTION):
        ask("kind of " + name, lambda: type(getattr(library, name, None)).__name__)
    tell("names", two_names)
    tell("values", lambda: [getattr(library, FUNCTION)(a, b) for a, b in PAIRS])
"""

library = Grader("14-library", ros=False)


@library.scenario
def ask_the_installed_library(arena: Arena) -> None:
    pairs = [(random.uniform(-9, 9), random.uniform(-9, 9)) for _ in range(TRIES)]
    names = ["".join(random.choices(string.ascii_letters, k=8)) for _ in range(2)]
    given = {"PAIRS": pairs, "NAMES": names}
    arena.mark(GIVEN, json.dumps(given))
    known = {**given, "PACKAGE": PACKAGE, "MODULE": MODULE, "CLASS": CLASS, "FUNCTION": FUNCTION}
    arena.probe("\n".join(f"{name} = {value!r}" for name, value in known.items()) + PROBE, timeout=PATIENCE)


def given(recording: Recording) -> dict[str, Any]:
    """What the scenario drew, from its own notes: the probe runs beside the learner's code."""
    mark = recording.marked(GIVEN)
    if mark is None:
        raise OurFault("the scenario did not note what it drew")
    found: dict[str, Any] = json.loads(mark.detail)
    return found


def answer(recording: Recording, question: str) -> Answer:
    found = recording.probe().answer(question)
    if found is None:
        expect_importable(recording, f"import {MODULE}")
        raise Failure(
            Feedback(
                summary="The library does not come to an end when it is used.",
                where=(Location(f"{folder(recording)}/{PACKAGE}/{LIBRARY}"),),
                advice="Look for a loop without end, for `input()` and for `sys.exit()`: a library only "
                "defines, and returns.",
            )
        )
    return found


def folder(recording: Recording) -> str:
    built = recording.packages.get(PACKAGE)
    return built.source if built else PACKAGE


def place_of_error(recording: Recording, question: str) -> tuple[Location, ...]:
    """The learner's line that led to the exception, by the frames that the probe saw."""
    frames = recording.probe().answer(f"{question} places")
    for file, line in reversed(frames.value if frames and isinstance(frames.value, list) else []):
        own = learners_file(str(file), recording.packages, recording.sources)
        if own:
            return (Location(own, line),)
    return ()


@library.check("installed", f"`import {MODULE}` works from another folder")
def installed(recording: Recording) -> None:
    expect_importable(recording, f"import {MODULE}")
    found = answer(recording, "library")
    if found.error:
        raise Failure(not_imported(recording, found.error))
    built = recording.packages.get(PACKAGE)
    if built is None or not str(found.value).startswith(built.prefix):
        raise OurFault(f"the library was imported from {found.value}")


def not_imported(recording: Recording, error: str) -> Feedback:
    place = place_of_error(recording, "library")
    if f"No module named '{PACKAGE}'" in error or f"No module named '{MODULE}'" in error:
        return not_installed(recording.sources, folder(recording), MODULE, error)
    private = next((name for name in inner_modules(recording) if f"No module named '{name}'" in error), None)
    if f"No module named '{LIBRARY}" in error:
        advice = f"Name its package too: `{MODULE}`."
    elif private:
        advice = f"Name its package too: `{MODULE}.{private}`, or `.{private}`. The bare name is only found "
        advice += "where that file happens to lie in the current folder."
    else:
        advice = remedy(error)
    return Feedback(
        summary=f"`import {MODULE}` fails: {STORE_PATH.sub('', error)}",
        where=place,
        advice=advice,
        details=code_at(recording, place),
    )


def code_at(recording: Recording, places: tuple[Location, ...]) -> tuple[str, ...]:
    lines = recording.sources.files.get(places[0].file, "").splitlines() if places else []
    number = (places[0].line or 0) if places else 0
    return (lines[number - 1].strip(),) if 0 < number <= len(lines) else ()


def inner_modules(recording: Recording) -> list[str]:
    files = recording.sources.below(folder(recording)).files
    return [file.rpartition("/")[2].removesuffix(".py") for file in files if file.endswith(".py")]


@library.check("exports", f"it offers `{CLASS}` and `{FUNCTION}`", needs="installed")
def exports(recording: Recording) -> None:
    for name, kind in ((CLASS, "class"), (FUNCTION, "function")):
        found = answer(recording, f"kind of {name}")
        if found.value in ("NoneType", "module"):
            raise Failure(not_offered(recording, name, kind, is_module=found.value == "module"))


def not_offered(recording: Recording, name: str, kind: str, *, is_module: bool) -> Feedback:
    offered = answer(recording, "offered").value or []
    near = nearest(name, [other for other in offered if other != name and not other.startswith("_")])
    init = f"{folder(recording)}/{PACKAGE}/{LIBRARY}/__init__.py"
    return Feedback(
        summary=f"`{name}` is a file here, not the {kind} in it."
        if is_module
        else f"The library offers no `{name}`" + (f"; it offers `{near}`." if near else "."),
        expected=f"from {MODULE} import {name}",
        seen=f"it offers {listed(offered, 'nothing')}",
        where=(*defined_at(recording, near or name)[:1], Location(init)),
        advice=advice_to_offer(recording, name, kind, near),
    )


def advice_to_offer(recording: Recording, name: str, kind: str, near: str | None) -> str:
    if near:
        return f"Correct the name of the {kind}, letter by letter, where it is defined and imported."
    if not defined_at(recording, name):
        return f"Write the {kind} in its file, then import it in `__init__.py`."
    return f"In `__init__.py`, import it from its file: `from {MODULE}._... import {name}`."


def defined_at(recording: Recording, name: str) -> tuple[Location, ...]:
    return tuple(
        Location(file, node.lineno)
        for file, tree in trees(recording.sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and node.name == name
    )


@library.check("class", f"`{CLASS}` keeps its name", needs="exports")
def class_(recording: Recording) -> None:
    wanted = given(recording)["NAMES"]
    found = answer(recording, "names")
    where = place_of_error(recording, "names") or defined_at(recording, CLASS)[:1]
    if found.error:
        raise Failure(broken(recording, f"{CLASS}({wanted[0]!r}).get_name()", found.error, where))
    if found.value == wanted:
        return
    seen = found.value if isinstance(found.value, list) else [found.value]
    getter = functions(recording.sources, "get_name")
    if seen == [wanted[1], wanted[1]]:
        summary, advice = (
            f"Two objects of `{CLASS}` share one name: the last that was given.",
            ("Keep it in the object: `self._name = name` in `__init__`, not `SampleClass._name = ...`."),
        )
    elif seen == [None, None]:
        summary, advice = "`get_name()` returns nothing.", "It has to `return self._name`, not just print it."
    elif "bound method" in str(seen[0]):
        summary, advice = (
            "`get_name()` returns itself, not the name.",
            ("A method and what it returns need two names: keep the name in `self._name`."),
        )
    else:
        summary, advice = (
            "`get_name()` does not return the name that the object was made with.",
            ("`__init__` keeps the name, `self._name = name`, and `get_name` returns it unchanged."),
        )
    raise Failure(
        Feedback(
            summary=summary,
            expected=f"{wanted[0]!r}, then {wanted[1]!r} for another object",
            seen=", then ".join(repr(each) for each in seen)[:200],
            where=where if getter else where[:1],
            advice=advice,
        )
    )


def broken(recording: Recording, call: str, error: str, where: tuple[Location, ...]) -> Feedback:
    return Feedback(
        summary=f"`{call}` fails: {error}",
        where=where,
        advice=remedy(error),
        details=code_at(recording, where),
    )


def remedy(error: str) -> str:
    every = (text for words, text in REMEDIES if all(word in error for word in words))
    return next(every, "Look at the line named here: it is the one of yours that led to the error.")


REMEDIES = (
    (
        ("circular import",),
        "Two files import each other. Let the private files import nothing of the library.",
    ),
    (("cannot import name",), "Is that name spelt the same here and where it is defined?"),
    (("SyntaxError",), "Python cannot read the file. Look at this line, and at the end of the one before."),
    (("NameError",), "Is that name spelt the same everywhere? Small and capital letters differ."),
    (("for ^",), "Python writes powers with two stars: `a**2`."),
    (("takes no arguments",), "`__init__` has two underscores on each side, and stands inside the class."),
    ((f"{FUNCTION}()",), f"It takes two numbers: `def {FUNCTION}(a, b):`."),
    (("takes", "given"), "The first argument of each method is `self`: `def get_name(self):`."),
    (("has no attribute 'get_name'",), "The class needs a method `get_name`, indented below `class`."),
    (("has no attribute",), "Is it set in `__init__`, with `self.`, and spelt the same in both places?"),
    (("missing", "argument"), "Compare its arguments with those in the task."),
    (("'str' object is not callable",), "A method and what it returns need two names: `self._name`."),
)
# What Python adds to some messages: where the installed file lies, which says nothing to a learner.
STORE_PATH = re.compile(r" \(/[^)]*\)")


@library.check("function", "the function returns a² + 2ab + b²", points=2, needs="exports")
def function(recording: Recording) -> None:
    pairs = given(recording)["PAIRS"]
    found = answer(recording, "values")
    where = place_of_error(recording, "values") or defined_at(recording, FUNCTION)[:1]
    if found.error:
        raise Failure(
            broken(recording, f"{FUNCTION}({pairs[0][0]:.2f}, {pairs[0][1]:.2f})", found.error, where)
        )
    values = found.value if isinstance(found.value, list) else []
    for (a, b), value in zip(pairs, values, strict=False):
        if not same(value, (a + b) ** 2):
            raise Failure(miscalculated(pairs, values, (a, b, value), where))
    if len(values) != len(pairs):
        raise OurFault(f"the probe gave {len(values)} values for {len(pairs)} pairs")


def same(value: object, wanted: float) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value - wanted) <= EXACT * max(1.0, abs(wanted))


FORMULAS: tuple[tuple[Callable[[float, float], float], str], ...] = (
    (lambda a, b: a**2 + b**2, "The part in the middle is missing: 2·a·b."),
    (lambda a, b: a**2 + a * b + b**2, "The part in the middle counts twice: 2·a·b, not a·b."),
    (lambda a, b: (a - b) ** 2, "The part in the middle is added, not taken away."),
    (lambda a, b: a + b, "That is the sum of both. The task asks for its square."),
    (lambda a, b: 2 * a + 2 * a * b + 2 * b, "`a * 2` doubles a. The square is `a**2`."),
    (lambda a, b: a**2 + 2 * a + b + b**2, "Between 2, a and b there are two `*`."),
)


def miscalculated(
    pairs: list[list[float]], values: list[Any], shown: tuple[float, float, Any], where: tuple[Location, ...]
) -> Feedback:
    a, b, value = shown
    every = list(zip(pairs, values, strict=False))
    cause = next(
        (text for formula, text in FORMULAS if all(same(each, formula(*pair)) for pair, each in every)), None
    )
    if value is None:
        cause = "It returns nothing: begin the line with `return`. To print the result is not enough."
    elif isinstance(value, str):
        cause = "It returns a text. Return the number itself."
    elif isinstance(value, int) or (isinstance(value, float) and round(value, 6) == value):
        cause = "The result is rounded. Return it as it is."
    return Feedback(
        summary=f"`{FUNCTION}({a:.3f}, {b:.3f})` returns {value!r}, not {(a + b) ** 2!r}.",
        expected=f"{(a + b) ** 2!r}",
        seen=f"{value!r}"[:200],
        where=where,
        advice=cause or "Write the three parts one by one: `a**2`, `2 * a * b` and `b**2`, and add them.",
    )


@library.check("no_tests", "the tests are not installed with it", needs="installed")
def no_tests(recording: Recording) -> None:
    found = answer(recording, "beside").value or []
    if "test" not in found:
        return
    raise Failure(
        Feedback(
            summary="The folder test is installed as if it were a library.",
            expected=f"{PACKAGE} alone",
            seen=listed(name for name in found if "." not in name),
            where=packages_place(recording.sources, folder(recording)),
            advice="Leave it out: `packages=find_packages(exclude=['test'])`.",
        )
    )
