"""Graders of chapter 14: installed libraries, used from a folder without their sources."""

from __future__ import annotations

import ast
import json
import random
import re
import string
from collections.abc import Callable
from typing import Any

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    OurFault,
    ProbeAnswer,
    Recording,
    answered,
    expect_importable,
    functions,
    learners_file,
    listed,
    nearest,
    packages_place,
    slips,
    trees,
)
from lib import rover
from lib.installed_packages import not_installed

PACKAGE = "python_package_with_a_library"
LIBRARY = "sample_python_library"
MODULE = f"{PACKAGE}.{LIBRARY}"
CLASS = "SampleClass"
FUNCTION = "sample_function_for_square_of_sum"
GIVEN = "what was drawn"
EXACT = 1e-9
TRIES = 6
PATIENCE = 5.0  # seconds

# Runs alongside the learner's programs, after lines that define PAIRS, NAMES, and the names from above.
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
    """The values that the scenario drew, from its own notes: the probe runs with the learner's code."""
    mark = recording.marked(GIVEN)
    if mark is None:
        raise OurFault("the scenario did not note what it drew")
    found: dict[str, Any] = json.loads(mark.detail)
    return found


def answer(recording: Recording, question: str) -> ProbeAnswer:
    found = recording.probe().answer(question)
    if found is None:
        expect_importable(recording, f"import {MODULE}")
        raise Failure(
            Feedback(
                summary="A program that uses the library never ends.",
                where=(Location(f"{folder(recording)}/{PACKAGE}/{LIBRARY}"),),
                advice=(
                    "Look for an endless loop, `input()`, or `sys.exit()`. A library only defines "
                    "functions and classes."
                ),
            )
        )
    return found


def folder(recording: Recording) -> str:
    built = recording.packages.get(PACKAGE)
    return built.source if built else PACKAGE


def place_of_error(recording: Recording, question: str) -> tuple[Location, ...]:
    """The line of the learner's code that led to the exception, from the frames that the probe saw."""
    frames = recording.probe().answer(f"{question} places")
    for frame in reversed(frames.value if frames and isinstance(frames.value, list) else []):
        match frame:  # its form is not certain: the learner's code runs in the same process
            case [str(file), int(line)]:
                own = learners_file(file, recording.packages, recording.sources)
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
    if built is None:
        raise OurFault(f"{PACKAGE} was not built")
    if not str(found.value).startswith(built.prefix):
        raise Failure(
            Feedback(
                summary=f"`import {MODULE}` loads something other than the installed library.",
                expected=f"a module whose `__file__` is in the installed `{PACKAGE}`",
                seen=str(found.value)[:200],
                where=(Location(f"{folder(recording)}/{PACKAGE}/__init__.py"),),
                advice="Let Python set `__file__`, and don't change `sys.modules` or `sys.path`.",
            )
        )


def not_imported(recording: Recording, error: str) -> Feedback:
    place = place_of_error(recording, "library")
    if f"No module named '{PACKAGE}'" in error or f"No module named '{MODULE}'" in error:
        return not_installed(recording.sources, folder(recording), MODULE, error)
    private = next((name for name in inner_modules(recording) if f"No module named '{name}'" in error), None)
    if f"No module named '{LIBRARY}" in error:
        advice = f"Include its package in the name: `{MODULE}`."
    elif private:
        advice = (
            f"Include its package in the name: `{MODULE}.{private}`, or `.{private}`. Python finds "
            "the bare name only "
        )
        advice += "when that file is in the current folder."
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
    told = answer(recording, "offered").value
    offered = [other for other in told if isinstance(other, str)] if isinstance(told, list) else []
    near = nearest(name, [other for other in offered if other != name and not other.startswith("_")])
    init = f"{folder(recording)}/{PACKAGE}/{LIBRARY}/__init__.py"
    return Feedback(
        summary=f"`{name}` is a file here, not the {kind} in it."
        if is_module
        else f"The library does not offer `{name}`" + (f", but it offers `{near}`." if near else "."),
        expected=f"from {MODULE} import {name}",
        seen=f"it offers {listed(offered, 'nothing')}",
        where=(*defined_at(recording, near)[:1], Location(init)) if near else (Location(init),),
        advice=advice_to_offer(recording, name, kind, near),
    )


def advice_to_offer(recording: Recording, name: str, kind: str, near: str | None) -> str:
    if near:
        return f"Correct the {kind}'s name where you define it and where you import it."
    if not defined_at(recording, name):
        return f"Write the {kind} in its own file, then import it in `__init__.py`."
    return f"In `__init__.py`, import it from its file: `from {MODULE}._... import {name}`."


def defined_at(recording: Recording, name: str) -> tuple[Location, ...]:
    return tuple(
        Location(file, node.lineno)
        for file, tree in trees(recording.sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and node.name == name
    )


@library.check("class", f"each `{CLASS}` keeps its own name", needs="exports")
def class_(recording: Recording) -> None:
    wanted = given(recording)["NAMES"]
    found = answer(recording, "names")
    defined = (*defined_at(recording, "get_name"), *defined_at(recording, CLASS))
    where = place_of_error(recording, "names") or defined[:1]
    if found.error:
        raise Failure(broken(recording, f"{CLASS}({wanted[0]!r}).get_name()", found.error, where))
    if found.value == wanted:
        return
    seen = found.value if isinstance(found.value, list) else [found.value]
    getter = functions(recording.sources, "get_name")
    if seen == [wanted[1], wanted[1]]:
        summary, advice = (
            f"Two objects of `{CLASS}` share one name, the one given last.",
            ("Store it in the object: `self._name = name` in `__init__`, not `SampleClass._name = ...`."),
        )
    elif seen == [None, None]:
        summary, advice = "`get_name()` returns nothing.", "Add `return self._name`. Printing is not enough."
    elif "bound method" in str(seen[:1]):
        summary, advice = (
            "`get_name()` returns the method itself, not the name.",
            ("The method and the attribute need different names: store the name in `self._name`."),
        )
    else:
        summary, advice = (
            "`get_name()` does not return the name that the object was given.",
            ("Store the name in `__init__` (`self._name = name`), and return it unchanged in `get_name`."),
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
    return next(every, "The error came from this line of your code: check the values that it uses.")


REMEDIES = (
    (
        ("circular import",),
        "Two files import each other. The private files must not import from the library.",
    ),
    (("cannot import name",), "Is that name spelled the same here and where it is defined?"),
    (("SyntaxError",), "Python can't read the file. Check this line and the end of the line before it."),
    (("NameError",), "Is that name spelled the same everywhere? Upper and lower case matter."),
    (("for ^",), "Powers in Python need two asterisks: `a**2`."),
    (("takes no arguments",), "`__init__` has two underscores on each side, and belongs inside the class."),
    ((f"{FUNCTION}()",), f"It takes two numbers: `def {FUNCTION}(a, b):`."),
    (("takes", "given"), "The first argument of each method is `self`: `def get_name(self):`."),
    (("has no attribute 'get_name'",), "The class needs a method `get_name`, indented under `class`."),
    (("has no attribute",), "Is it set in `__init__` with `self.`, and spelled the same in both places?"),
    (("missing", "'self'"), "Below `@staticmethod`, a method gets no `self`. Remove that line above it."),
    (("missing", "argument"), "Compare the arguments with those in the task."),
    (
        ("'str' object is not callable",),
        "The parentheses try to call a string. Read a property without parentheses. Give a method and an "
        "attribute different names, such as `self._name` for the attribute.",
    ),
)
# Python adds the installed file's path to some messages, which does not help a learner.
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
        raise Failure(
            Feedback(
                summary=f"The check could not call `{FUNCTION}` with all of its test values.",
                expected=f"{len(pairs)} numbers, one for each pair",
                seen=f"{len(values)}",
                where=where,
                advice=(
                    "A library only defines functions and classes: don't change other modules or open files."
                ),
            )
        )


def same(value: object, wanted: float) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value - wanted) <= EXACT * max(1.0, abs(wanted))


FORMULAS: tuple[tuple[Callable[[float, float], float], str], ...] = (
    (lambda a, b: a**2 + b**2, "The middle term is missing: 2·a·b."),
    (lambda a, b: a**2 + a * b + b**2, "The middle term should be 2·a·b, not a·b."),
    (lambda a, b: (a - b) ** 2, "The middle term must be added, not subtracted."),
    (lambda a, b: (a + b) * 2, "`* 2` doubles the sum. The square is `** 2`."),
    (lambda a, b: a + b, "This is the sum of the two numbers. The task asks for its square."),
    (lambda a, b: 2 * a + 2 * a * b + 2 * b, "`a * 2` doubles a. The square is `a**2`."),
    (lambda a, b: a**2 + 2 * a + b + b**2, "Write a `*` between 2, a, and b: `2 * a * b`."),
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
        cause = "It returns nothing: start the line with `return`. Printing the result is not enough."
    elif isinstance(value, str):
        cause = "It returns a string. Return the number itself."
    elif isinstance(value, int) or (isinstance(value, float) and round(value, 6) == value):
        cause = "The result is rounded. Return it as it is."
    return Feedback(
        summary=f"`{FUNCTION}({a:.3f}, {b:.3f})` returns {value!r}, not {(a + b) ** 2!r}.",
        expected=f"{(a + b) ** 2!r}",
        seen=f"{value!r}"[:200],
        where=where,
        advice=cause or "Add up the three terms `a**2`, `2 * a * b`, and `b**2`.",
    )


@library.check("no_tests", "the tests are not installed with it", needs="installed")
def no_tests(recording: Recording) -> None:
    told = answer(recording, "beside").value
    found = [name for name in told if isinstance(name, str)] if isinstance(told, list) else []
    if "test" not in found:
        return
    raise Failure(
        Feedback(
            summary="The folder `test` is installed along with the library.",
            expected=f"only {PACKAGE}",
            seen=listed(name for name in found if "." not in name),
            where=packages_place(recording.sources, folder(recording)),
            advice="Exclude it in `setup.py`: `packages=find_packages(exclude=['test'])`.",
        )
    )


# The rover's library ---------------------------------------------------------------------------------

SPEED = "safe_speed"
IMPORT = f"from {rover.LIBRARY} import {SPEED}"
ROVER_PROBE = f"""
import importlib
ask("library", lambda: importlib.import_module("{rover.LIBRARY}").{SPEED}.__name__)
ask("usual", lambda: [importlib.import_module("{rover.LIBRARY}").{SPEED}(d) for d in DISTANCES])
ask("given", lambda: [importlib.import_module("{rover.LIBRARY}").{SPEED}(
    d, stop_at=stop, full_speed=full) for d, stop, full in CASES])
"""

driving = Grader("14-rover", ros=False)


@driving.scenario
def ask_the_rovers_library(arena: Arena) -> None:
    distances = [random.uniform(low, high) for low, high in ((0.0, 0.5), (0.55, 0.95), (1.0, 9.0)) * 2]
    limits = [(random.uniform(0.1, 0.5), random.uniform(0.1, 2.0)) for _ in range(2)]
    # For each pair of limits: too near, between the limits, and too far.
    cases = [
        (distance, stop, full)
        for stop, full in limits
        for distance in (
            random.uniform(0.0, 0.9) * stop,
            stop + random.uniform(0.1, 0.9) * full,
            stop + full + random.uniform(0.1, 5.0),
        )
    ]
    drawn = {"DISTANCES": distances, "CASES": cases}
    arena.mark(GIVEN, json.dumps(drawn))
    arena.probe("\n".join(f"{name} = {value!r}" for name, value in drawn.items()) + ROVER_PROBE)


@driving.check("installed", f"`{IMPORT}` works from another folder")
def driving_installed(recording: Recording) -> None:
    expect_importable(recording, IMPORT)
    found = recording.probe().answer("library")
    if found and found.error and f"No module named '{rover.PACKAGE}" in found.error:
        built = recording.packages.get(rover.PACKAGE)
        folder = built.source if built else rover.PACKAGE
        raise Failure(not_installed(recording.sources, folder, rover.LIBRARY, found.error))
    answered(recording, "library", IMPORT)


@driving.check("defaults", "by default, it stops at 0.5 m and drives at up to 0.5 m/s", needs="installed")
def defaults(recording: Recording) -> None:
    expect_speeds(
        recording, "usual", [(d, rover.STOP_AT, rover.FULL_SPEED) for d in given(recording)["DISTANCES"]]
    )


@driving.check("arguments", "`stop_at` and `full_speed` change both limits", points=2, needs="installed")
def arguments(recording: Recording) -> None:
    expect_speeds(recording, "given", given(recording)["CASES"])


def expect_speeds(recording: Recording, question: str, cases: list[Any]) -> None:
    where = next(iter(defined_at(recording, SPEED)), None)
    found = answered(recording, question, f"{SPEED}(...)", where=where).value
    speeds = found if isinstance(found, list) else []
    for case, speed in zip(cases, speeds, strict=False):
        if not same(speed, rover.safe_speed(*case)):
            raise Failure(wrong_speed(recording, case, speed))
    if len(speeds) != len(cases):
        advice = "A library only defines functions and classes: don't change other modules."
        raise Failure(Feedback(summary=f"The check could not call `{SPEED}` with all values.", advice=advice))


def wrong_speed(recording: Recording, case: tuple[float, float, float], speed: object) -> Feedback:
    distance, stop_at, full_speed = case
    wanted = rover.safe_speed(*case)
    cause = slips.never_above_zero(recording.sources)
    return Feedback(
        summary=f"`{SPEED}({distance:.2f})` returns {speed!r:.40}, with stop_at {stop_at:.2f} and full_speed "
        f"{full_speed:.2f}.",
        expected=f"{wanted!r}",
        seen=f"{speed!r}"[:200],
        where=cause.where if cause else defined_at(recording, SPEED)[:1],
        advice=cause.text if cause else advice_on_speed(distance, stop_at, wanted, speed),
    )


def advice_on_speed(distance: float, stop_at: float, wanted: float, speed: object) -> str:
    if speed is None:
        return "It returns nothing: use `return`. Printing the result is not enough."
    if isinstance(speed, float | int) and speed < 0.0:
        return "The rover must not drive backward. Use `max(0.0, ...)`, which is never below zero."
    if distance <= stop_at:
        return "At a distance of `stop_at` or less, the speed must be 0.0."
    if wanted < distance - stop_at:
        return "The speed must never exceed `full_speed`. Use `min(full_speed, ...)`."
    return "Between those two limits, the speed must be `distance - stop_at`."
