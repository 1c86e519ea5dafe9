"""Graders of chapter 2: a script, a class, and the package that contains them."""

from __future__ import annotations

import ast
import builtins
import random
import re
import stat
import sysconfig
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from course.api import (
    BASHRC,
    Arena,
    Cause,
    Failure,
    Feedback,
    Grader,
    Location,
    NotApplicable,
    OurFault,
    Process,
    Recording,
    Sources,
    answered,
    calls,
    crash,
    crash_feedback,
    entry_points,
    expect_answer,
    expect_clean_interrupt,
    expect_importable,
    expect_mode,
    expect_period,
    expect_ran,
    expect_running,
    expect_text,
    functions,
    known_error,
    listed,
    misspelled_group,
    nearest,
    replace,
    slips,
    text_places,
    trees,
)
from lib.lint import expect_no_findings, expect_readable

PROBES = Path(__file__).with_name("probes")
PROJECT = "ros2_tutorials_preamble/python/minimalist_package"
PACKAGE = f"{PROJECT}/minimalist_package"
SCRIPT = f"{PACKAGE}/minimalist_script.py"
CLASS = f"{PACKAGE}/_minimalist_class.py"
INIT = f"{PACKAGE}/__init__.py"
HOWDY = "Howdy!"
ENOUGH = 5

venv = Grader("02-venv", builds=None, ros=False)

ENVIRONMENT = "ros2tutorial_venv"
IS_APART = "import sys; print('apart' if sys.prefix != sys.base_prefix else 'not apart')"


@venv.scenario
def start_its_python(arena: Arena) -> None:
    python = f"{ENVIRONMENT}/bin/python3"
    for name, code in (("venv", IS_APART), ("dqrobotics", "import dqrobotics")):
        program = arena.in_place(python, "-c", code, name=name)
        if program:
            program.wait(10)


@venv.check("made", "`~/ros2tutorial_venv` is a virtual environment")
def made(recording: Recording) -> None:
    if recording.home.file(f"{ENVIRONMENT}/pyvenv.cfg").is_file:
        return
    others = [path for path in recording.home.entries if path.endswith("/pyvenv.cfg")]
    other = others[0].partition("/")[0] if others else None
    raise Failure(
        Feedback(
            summary=f"The environment `~/{ENVIRONMENT}` does not exist, but `~/{other}` does."
            if other
            else f"There is no virtual environment in `~/{ENVIRONMENT}`.",
            expected=f"a virtual environment in ~/{ENVIRONMENT}",
            seen=f"one in ~/{other}" if other else "none",
            advice=f"`python3 -m venv ~/{ENVIRONMENT}` creates it. You cannot rename an existing one.",
        )
    )


@venv.check("runs", "its Python runs, and is not the system's Python", needs="made")
def its_python_runs(recording: Recording) -> None:
    view = recording.process("venv")
    if "apart" in view.text:
        return
    if view.started and (view.exited is None or view.exited.signal):
        raise OurFault(f"the Python of ~/{ENVIRONMENT} did not end")
    raise Failure(
        Feedback(
            summary=f"`~/{ENVIRONMENT}` has no working Python.",
            expected=f"~/{ENVIRONMENT}/bin/python3",
            seen=view.text[-1][:120] if view.text else "no such program",
            advice=(
                f"Remove it (`rm -r ~/{ENVIRONMENT}`) and create it again. It may have been moved, or "
                "its Python is gone."
            ),
        )
    )


@venv.check("dqrobotics", "`dqrobotics` is installed in it", bonus=True, needs="runs")
def dqrobotics(recording: Recording) -> None:
    ended = recording.process("dqrobotics").exited
    if ended is None or ended.code != 0:
        raise NotApplicable(
            "It is not installed. Activate the environment and run `pip install dqrobotics`. You "
            "need internet access."
        )


editor = Grader("02-editor-quiz", builds=None, ros=False)


@editor.scenario
def look_for_the_alias(arena: Arena) -> None:
    with arena.shell() as shell:
        shell.run("alias pycharm_ros2")


@editor.check("pycharm_alias", "an alias `pycharm_ros2`", bonus=True)
def pycharm_alias(recording: Recording) -> None:
    ran = expect_ran(recording, "alias pycharm_ros2")
    if ran.code != 0:
        raise Failure(
            Feedback(
                summary="A new terminal does not know the alias `pycharm_ros2`.",
                where=tuple(text_places(only(recording, BASHRC), "pycharm")[:1]) or (Location(BASHRC),),
                advice="As in chapter 1: `alias pycharm_ros2='...'` in `~/.bashrc`, with the path of "
                "PyCharm's program in the quotation marks, and no spaces around the `=`.",
            )
        )


script = Grader("02-script", builds=None, ros=False)

IMPORT_SCRIPT = """
from minimalist_package import minimalist_script
main = ask("main", lambda: minimalist_script.main)
ask("hint", lambda: "return" in main.__annotations__)
"""


@script.scenario
def run_import_and_execute_it(arena: Arena) -> None:
    """Start it both ways at once; five lines make four intervals."""
    program = arena.python(SCRIPT, name="script")
    direct = arena.execute(SCRIPT, name="direct")
    arena.probe(IMPORT_SCRIPT, cwd=PROJECT, timeout=5)
    for process, wanted in ((program, ENOUGH), (direct, 1)):
        if process:
            arena.until(lambda p=process, n=wanted: lines(arena, p) >= n, timeout=6, while_running=process)
    arena.interrupt(program)
    arena.interrupt(direct)


def lines(arena: Arena, program: Process) -> int:
    """How many lines it has printed; 0 after an error, because then the program is about to end by itself."""
    printed = arena.lines(program)
    return 0 if any(text.startswith("Traceback") for text in printed) else len(printed)


def only(recording: Recording, *files: str) -> Sources:
    """The sources of these files only."""
    return Sources({name: text for name, text in recording.sources.files.items() if name in files})


@script.check("starts", "`python3 minimalist_script.py` keeps running")
def starts(recording: Recording) -> None:
    expect_running(recording, "script")


@script.check("howdy", "it prints `Howdy!`", needs="starts")
def howdy(recording: Recording) -> None:
    view = recording.process("script")
    printed = [line.text for line in view.lines if line.t < (view.interrupted_at or line.t + 1)]
    other = next((text for text in printed if text.strip() != HOWDY), None)
    if printed and other is None:
        return
    raise Failure(
        Feedback(
            summary=f"It prints `{other[:80]}`, not `{HOWDY}`."
            if other is not None
            else "It runs, but prints nothing.",
            expected=HOWDY,
            seen=other[:120] if other is not None else "nothing",
            where=tuple(call.where for call in calls(only(recording, SCRIPT), "print"))[:2],
            advice=(
                'Print only the word with its exclamation mark, each time on its own line: `print("Howdy!")`.'
            ),
        )
    )


@script.check("rate", "twice per second", needs="howdy")
def rate(recording: Recording) -> None:
    view = recording.process("script")
    times = tuple(line.t for line in view.lines if line.t < (view.interrupted_at or line.t + 1))
    expect_period(
        times,
        0.5,
        what="lines",
        advice="`time.sleep` takes seconds: 0.5.",
        where=tuple(call.where for call in calls(only(recording, SCRIPT), "sleep"))[:2],
        program=replace(recording, sources=only(recording, SCRIPT)),
    )


@script.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, "script")


@script.check("imports", "importing it runs nothing")
def imports(recording: Recording) -> None:
    expect_text(recording, SCRIPT)
    if recording.probe().ran and not recording.probe().finished and not recording.probe().answers:
        raise Failure(runs_when_imported(recording, "it goes on forever"))
    expect_importable(recording, "from minimalist_package import minimalist_script")
    printed = recording.process("probe").text
    if printed:
        raise Failure(runs_when_imported(recording, f"it prints `{printed[0][:80]}`"))


def runs_when_imported(recording: Recording, seen: str) -> Feedback:
    text = recording.home.file(SCRIPT).lines
    guard = any(re.match(r"if\s+__name__\s*==", line) for line in text)
    top = [n for n, line in enumerate(text, 1) if re.match(r"(main\(|while |print\(|for )", line)]
    return Feedback(
        summary="When another file imports `minimalist_script`, the whole script runs.",
        expected="an import runs nothing",
        seen=seen,
        where=tuple(Location(SCRIPT, n) for n in top[:2]) or (Location(SCRIPT),),
        advice="A line that is not indented runs at each import. Move it into `main()`"
        + (
            ", or under the `if` at the end."
            if guard
            else ', and call that under `if __name__ == "__main__":`.'
        ),
    )


@script.check("main", "`main()` states its return type", needs="imports")
def main_with_a_hint(recording: Recording) -> None:
    main = recording.probe().answer("main")
    if main is None or main.error is not None:
        raise Failure(
            Feedback(
                summary="There is no function `main` in `minimalist_script.py`.",
                where=(Location(SCRIPT),),
                advice="Put what the program does into a function: `def main() -> None:`.",
            )
        )
    if answered(recording, "hint", "main()").value is True:
        return
    defined = [node.lineno for node in functions(only(recording, SCRIPT), "main")]
    raise Failure(
        Feedback(
            summary="`main()` does not state its return type.",
            expected="def main() -> None:",
            seen="def main():",
            where=(Location(SCRIPT, defined[0] if defined else None),),
            advice="It returns nothing, so its return type is `None`: write `-> None` before the colon.",
        )
    )


@script.check("shebang", "the first line names `python3`")
def shebang(recording: Recording) -> None:
    text = expect_text(recording, SCRIPT).lines
    first = text[0] if text else ""
    if expect_text(recording, SCRIPT).dos_line_ends and first.startswith("#!"):
        raise Failure(
            Feedback(
                summary=(
                    "The file has Windows line endings, so its first line names a program that does "
                    "not exist."
                ),
                expected="nothing after `python3`",
                seen="an invisible character after it",
                where=(Location(SCRIPT, 1),),
                advice=(
                    "Save the file with Linux line endings (LF) in your editor, or remove the "
                    "characters: `sed -i 's/\\r$//' minimalist_script.py`."
                ),
            )
        )
    if re.match(r"#!\s*/\S+", first) and re.search(r"\bpython3(\.\d+)?$", first.strip()):
        return
    later = next((n for n, line in enumerate(text, 1) if line.lstrip().startswith("#!")), None)
    if later and later > 1:
        summary, advice = (
            f"The line with `#!` is line {later}, but it works only as the very first line.",
            "Move it up.",
        )
    elif first.startswith("#!"):
        summary = f"The first line does not name python3: `{first[:60]}`."
        advice = "Write `#!/usr/bin/env python3`: it finds the python3 that is on the PATH."
    else:
        summary = "The first line does not say which program runs the file."
        advice = "Begin the file with `#!/usr/bin/env python3`. Without it, bash runs the file itself."
    raise Failure(
        Feedback(
            summary=summary,
            expected="#!/usr/bin/env python3",
            seen=first[:80] or "an empty line",
            where=(Location(SCRIPT, later or 1),),
            advice=advice,
        )
    )


@script.check("direct", "`./minimalist_script.py` runs", needs="shebang")
def direct(recording: Recording) -> None:
    expect_mode(
        recording,
        SCRIPT,
        has=stat.S_IXUSR,
        summary="`minimalist_script.py` is not executable: its owner has no `x`.",
        advice="`chmod u+x minimalist_script.py`, as in chapter 1.",
    )
    view = recording.process("direct")
    if any(line.strip() == HOWDY for line in view.text):
        return
    failed = crash(view.traceback(), recording.packages, recording.sources)
    if failed:
        raise Failure(crash_feedback(failed, recording.packages, recording.sources))
    first = recording.home.file(SCRIPT).lines[0]
    if any("No such file" in line for line in view.text):
        raise NotApplicable(f"This machine has no {first.removeprefix('#!').split()[0]}.")
    raise Failure(
        Feedback(
            summary="`./minimalist_script.py` does not print `Howdy!`.",
            seen=view.text[-1][:120] if view.text else "nothing",
            where=(Location(SCRIPT, 1),),
            advice="Run it yourself in a terminal, and read its output.",
            details=view.text[-6:],
        )
    )


minimalist_class = Grader("02-class", builds=None, ros=False)


@minimalist_class.scenario
def use_it(arena: Arena) -> None:
    arena.probe(PROBES / "ch02_class.py", cwd=PROJECT)


def place(recording: Recording, name: str) -> Location:
    """The place of the class's method of this name, or else of the class."""
    sources = only(recording, CLASS, INIT)
    files = [file for file in (CLASS, INIT) if "class MinimalistClass" in sources.files.get(file, "")]
    file = files[0] if files else CLASS
    text = recording.home.file(file).lines
    methods = [n for n, line in enumerate(text, 1) if re.match(rf"\s+def {name}\b", line)]
    classes = [n for n, line in enumerate(text, 1) if line.startswith("class MinimalistClass")]
    return Location(file, (methods or classes or [None])[0])


@minimalist_class.check("class", "`MinimalistClass()` creates an object")
def makes_an_object(recording: Recording) -> None:
    expect_importable_class(recording)
    answered(recording, "made", "MinimalistClass()")


def expect_importable_class(recording: Recording) -> None:
    probe = recording.probe()
    if recording.missing_program("probe") or not probe.ran or (not probe.finished and not probe.answers):
        expect_importable(recording, "from minimalist_package import MinimalistClass")
    found = probe.answer("class")
    if found is not None and found.error is not None:
        lost = "No module named 'minimalist_package._minimalist_class'" in found.error
        if lost:
            expect_text(recording, CLASS)
        answered(recording, "class", "from minimalist_package._minimalist_class import MinimalistClass")


@minimalist_class.check("exported", "the package exports it", needs="class")
def exported(recording: Recording) -> None:
    answer = recording.probe().answer("export")
    if answer is not None and answer.error is None:
        return
    expect_text(recording, INIT, advice="`touch __init__.py` creates it; then write the import in it.")
    error = answer.error if answer is not None and answer.error else ""
    missing = "has no attribute" in error
    raise Failure(
        Feedback(
            summary="`from minimalist_package import MinimalistClass` fails: `__init__.py` does not import "
            "the class."
            if missing
            else f"`from minimalist_package import MinimalistClass` fails: {error}",
            expected="from minimalist_package._minimalist_class import MinimalistClass",
            seen=next((line for line in recording.home.file(INIT).lines if "import" in line), "no import"),
            where=(
                Location(answer.file, answer.line)
                if answer is not None and answer.file and not answer.file.startswith("/")
                else Location(INIT),
            ),
            advice=(
                "Write that line in `minimalist_package/__init__.py`: the names imported there "
                "belong to the package."
            ),
        )
    )


@minimalist_class.check("reference", "`attribute_reference` belongs to the class", needs="class")
def reference(recording: Recording) -> None:
    where = place(recording, "__init__")
    answer = recording.probe().answer("reference")
    if answer is not None and answer.error is not None and "has no attribute" in answer.error:
        raise Failure(
            Feedback(
                summary="The class has no `attribute_reference`.",
                expected='attribute_reference: str = "Hello "',
                where=(where,),
                advice=(
                    "Set it in the class itself, before `__init__` and without `self.`, so that it "
                    "exists without any object."
                ),
            )
        )
    advice = 'The string ends with a space: `"Hello "`.'
    what = "MinimalistClass.attribute_reference"
    expect_answer(recording, "reference", "Hello ", what, advice=advice, where=where)


@minimalist_class.check("attributes", "objects store both numbers", points=2, needs="class")
def attributes(recording: Recording) -> None:
    where = place(recording, "__init__")
    given = "MinimalistClass(private_attribute_arg=2.5, attribute_arg=1.5)"
    keep = "In `__init__`: `self.attribute = attribute_arg`, and the same for `self._private_attribute`."
    for question, value, what in (
        ("default attribute", 10.0, "MinimalistClass().attribute"),
        ("default private", 20.0, "MinimalistClass()._private_attribute"),
        ("by name", 1.5, f"{given}.attribute"),
        ("private by name", 2.5, f"{given}._private_attribute"),
    ):
        expect_answer(recording, question, value, what, advice=keep, where=where)


@minimalist_class.check("apart", "two objects do not share their numbers", needs="attributes")
def apart(recording: Recording) -> None:
    shares = (
        "Set the attributes of an object with `self.` in `__init__`. All objects share "
        "`MinimalistClass.attribute`, and so does a list in the class itself."
    )
    where = place(recording, "__init__")
    two = "[first.attribute, first.get_private_attribute(), second.attribute, second.get_private_attribute()]"
    four = tuple[Any, Any, Any, Any]
    seen = answered(recording, "apart", two, shape=four).value
    if seen == [1.5, 2.5, 3.5, 4.5]:
        changed = answered(recording, "still apart", two, shape=four).value
        if changed[2:] == [3.5, 4.5]:
            return
    raise Failure(
        Feedback(
            summary="Two objects share their numbers: when the second is created or the first is changed, "
            "the other changes, too.",
            expected="first: 1.5 and 2.5, second: 3.5 and 4.5",
            seen=f"first: {seen[0]} and {seen[1]}, second: {seen[2]} and {seen[3]}"
            if seen != [1.5, 2.5, 3.5, 4.5]
            else "the second changes with the first",
            where=(where,),
            advice=shares,
        )
    )


@minimalist_class.check("method", "`method()` returns their sum", needs="class")
def method(recording: Recording) -> None:
    where = place(recording, "method")
    advice = "Write `return self.attribute + self._private_attribute`, so that it adds the current numbers."
    for question, value, what in (
        ("default sum", 30.0, "MinimalistClass().method()"),
        ("sum", -2.5, "MinimalistClass(1.5, -4.0).method()"),
        ("sum later", 9.5, "m = MinimalistClass(1.5, 2.5); m.attribute = 7.0; m.method()"),
    ):
        expect_answer(recording, question, value, what, advice=advice, where=where)


@minimalist_class.check("private", "it gets and sets the private one", needs="class")
def private(recording: Recording) -> None:
    got, was_set = place(recording, "get_private_attribute"), place(recording, "set_private_attribute")
    expect_answer(
        recording,
        "get",
        2.5,
        "MinimalistClass(1.5, 2.5).get_private_attribute()",
        advice="Write `return self._private_attribute` in it.",
        where=got,
    )
    after = "after set_private_attribute(8.0),"
    sets = "In `set_private_attribute`, assign the argument to `self._private_attribute`."
    if slip := slips.first(only(recording, CLASS, INIT), slips.compared, slips.assigned_backward):
        sets, (was_set, *_) = slip.text, slip.where
    expect_answer(
        recording, "set and get", 8.0, f"get_private_attribute(), {after}", advice=sets, where=was_set
    )


@minimalist_class.check("static", "`static_method()` needs no object", needs="class")
def static(recording: Recording) -> None:
    where = place(recording, "static_method")
    answer = recording.probe().answer("static of an object")
    bare = recording.probe().answer("static")
    if any(found and found.error and "positional argument" in found.error for found in (answer, bare)):
        decorated = bare is not None and bare.error is None
        raise Failure(
            Feedback(
                summary="`static_method` is not a static method: it lacks the line `@staticmethod` above it."
                if decorated
                else "`static_method` expects an argument such as `self`; a static method has no `self`.",
                expected="MinimalistClass.static_method() and MinimalistClass().static_method() both work",
                seen=(answer.error if decorated and answer else bare.error if bare else None),
                where=(where,),
                advice="Write `@staticmethod` on the line above `def static_method()`, and no `self`.",
            )
        )
    for question, what in (
        ("static", "MinimalistClass.static_method()"),
        ("static of an object", "MinimalistClass().static_method()"),
    ):
        expect_answer(
            recording,
            question,
            "Hello World!",
            what,
            advice="It must return the string, not print it.",
            where=where,
        )


style = Grader("02-style", builds=None, ros=False)

NAMING = ("N801", "N802", "N803", "N806", "N999")
UNKNOWN = ("F821",)
HINTS = ("ANN001", "ANN002", "ANN003", "ANN201", "ANN205", "ANN206")
DOCSTRINGS = ("D101", "D102", "D103")


@style.scenario
def look_over_the_package(arena: Arena) -> None:
    arena.lint(PACKAGE, *UNKNOWN, *NAMING, *HINTS, *DOCSTRINGS)


@style.check("readable", "Python can read the package's files")
def readable(recording: Recording) -> None:
    expect_text(recording, SCRIPT, advice="It is the script from 02-script.")
    texts = recording.sources.below(PACKAGE).files.values()
    if not any(re.search(r"^class \w", text, re.MULTILINE) for text in texts):
        expect_text(recording, CLASS, advice="It is the class from 02-class.")
    expect_readable(recording)


@style.check("names", "names are written as in PEP 8", needs="readable")
def names(recording: Recording) -> None:
    expect_no_findings(
        recording,
        NAMING,
        "A name does not follow PEP 8",
        advice="Classes are `LikeThis`; functions, methods, arguments, variables, and files are `like_this`.",
    )


@style.check("hints", "arguments and results have type hints", needs="readable")
def hints(recording: Recording) -> None:
    expect_no_findings(
        recording,
        UNKNOWN,
        "A name is not defined",
        advice="Python's types are `int`, `float`, `str`, and `bool`, in lowercase. Import other types.",
    )
    expect_no_findings(
        recording,
        HINTS,
        "A type hint is missing",
        advice="Write `def half(number: float) -> float:`. If a function returns nothing, write `-> None:`.",
    )


@style.check("docstrings", "classes, functions, and methods have docstrings", needs="readable")
def docstrings(recording: Recording) -> None:
    expect_no_findings(
        recording,
        DOCSTRINGS,
        "A docstring is missing",
        advice='Add a line in triple quotes right below the `def` or `class`: `"""Return the half."""`.',
    )


unit_tests = Grader("02-unit-tests", builds=None, ros=False)

TEST = f"{PROJECT}/test/test_minimalist_class.py"
SOLUTION = Path(__file__).parents[1] / "solutions" / "02-python-basics"
# The fault of each broken class, and the change to the right class that causes it.
FAULTS = {
    "the default of attribute_arg is 11.0": ("attribute_arg: float = 10.0,", "attribute_arg: float = 11.0,"),
    "the default of private_attribute_arg is 21.0": ("= 20.0", "= 21.0"),
    "attribute ignores its argument": ("float = attribute_arg\n", "float = 10.0\n"),
    "method() subtracts": ("self.attribute + self", "self.attribute - self"),
    "set_private_attribute() does nothing": (
        "        self._private_attribute = private",
        "        _ = private",
    ),
    "get_private_attribute() returns 20.0 always": ("return self._private_attribute\n", "return 20.0\n"),
    "static_method() returns a different string": ("Hello World!", "Hello!"),
    "attribute_reference is a different string": ('"Hello "', '"Bye "'),
}
NOTICED = 6


# Equivalent classes in other words. With only one, a test could pass once and then always fail.
RIGHT = tuple(f"right, version {number}" for number in range(1, 5))
SIZE = 4000
DRAW = random.SystemRandom()


@unit_tests.scenario
def run_the_tests_on_right_and_broken_classes(arena: Arena) -> None:
    """Replace the learner's class with the reference class, unchanged or with a fault.

    The order is random and each run has a separate place, so that a test can tell them apart only by what
    the class does.
    """
    if not arena.files.is_folder(PACKAGE):
        return
    init, right = ((SOLUTION / name).read_text(encoding="utf-8") for name in (INIT, CLASS))
    tests = "\n".join(arena.files.text(file) or "" for file in arena.files.below(f"{PROJECT}/test"))
    for name in DRAW.sample((*RIGHT, *FAULTS), len(RIGHT) + len(FAULTS)):
        with arena.fresh({INIT: init, CLASS: in_other_words(with_fault(right, name))}):
            run = arena.python_module(
                "unittest", "discover", "-v", "test", name=name, cwd=PROJECT, through=Report(tests)
            )
            if run and not run.wait(10) and name in RIGHT:
                return


def with_fault(right: str, name: str) -> str:
    old, new = FAULTS.get(name, ("", ""))
    if old not in right:
        raise OurFault(f"the reference class no longer contains `{old}`")
    return right.replace(old, new) if old else right


def in_other_words(text: str) -> str:
    """The same class without comments, with its methods in random order, in a file of the same size."""
    tree = ast.parse(text)
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            node.body.sort(key=lambda part: isinstance(part, ast.FunctionDef) and 1 + DRAW.random())
    code = f"{ast.unparse(tree)}\n# "
    return code + "".join(DRAW.choices("0123456789abcdef", k=SIZE - len(code)))


# The lines of unittest's output that are kept, each once; mostly about the first failed test.
FACTS = {
    "ran": r"(Ran) [1-9]\d* tests? in .*",
    "failed": r"(?:FAIL|ERROR): (\w+) .*",
    "line": rf'  File ".*/{re.escape(TEST)}", line (\d+).*',
    "error": r"(\w+Error)\b.*",
    "word": r"\w+Error: .*?'([\w.]+)'.*",
}


class Report:
    """Drops all other output, which may contain our class under test.

    A name in a fact is kept only if the word is Python's or in the learner's `tests`.
    """

    def __init__(self, tests: str) -> None:
        lines = map(str, range(1, len(tests.splitlines()) + 1))
        self._known = {"Ran", Path(TEST).stem, *dir(builtins), *lines, *re.findall(r"[\w.]+", tests)}
        self._told: set[str] = set()

    def __call__(self, line: str) -> str | None:
        found = {fact: re.fullmatch(pattern, line) for fact, pattern in FACTS.items()}
        told = {fact: match[1] for fact, match in found.items() if match and match[1] in self._known}
        new = [f"{fact}={word}" for fact, word in told.items() if fact not in self._told]
        self._told.update(told)
        return " ".join(new) or None


def fact(recording: Recording, run: str, name: str) -> str | None:
    words = " ".join(recording.process(run).text).split()
    return next((word.partition("=")[2] for word in words if word.startswith(f"{name}=")), None)


@unit_tests.check("found", "unittest finds your tests")
def found(recording: Recording) -> None:
    expect_text(recording, TEST, advice=("Create the folder `test` next to the package, and the file in it."))
    if not any(recording.process(name).started for name in (*RIGHT, *FAULTS)):
        expect_text(recording, CLASS)
    if any(fact(recording, name, "ran") for name in (*RIGHT, *FAULTS)):
        return
    text = recording.home.file(TEST).lines
    defs = [n for n, line in enumerate(text, 1) if re.match(r"\s*def ", line)]
    classes = [n for n, line in enumerate(text, 1) if line.startswith("class ")]
    derived = any("TestCase" in line for line in text if line.startswith("class "))
    raise Failure(
        Feedback(
            summary="unittest finds no test in `test_minimalist_class.py`.",
            where=tuple(Location(TEST, n) for n in (defs or classes)[:2]) or (Location(TEST),),
            advice="A test is a method whose name begins with `test`, as in `def test_method(self):`."
            if derived
            else "Tests are methods of a class such as `class TestIt(unittest.TestCase):`.",
        )
    )


@unit_tests.check("right", "they pass for a correct class", needs="found")
def right(recording: Recording) -> None:
    ends = {name: recording.process(name).exited for name in RIGHT if recording.process(name).started}
    if any(end is None or end.signal is not None for end in ends.values()):
        raise Failure(
            Feedback(
                summary="The tests never end.",
                where=(Location(TEST),),
                advice="Look for a loop that never ends, or for an `input()` that waits.",
            )
        )
    failed = next((name for name, end in ends.items() if end and end.code != 0), None)
    if failed:
        raise Failure(why_it_failed(recording, failed))


def why_it_failed(recording: Recording, run: str) -> Feedback:
    test, line, error, word = (fact(recording, run, name) for name in ("failed", "line", "error", "word"))
    text = recording.home.file(TEST).lines
    number = int(line) if line and int(line) <= len(text) else None
    cause = slip_in_tests(text, number or 0)
    advice = (
        "Compare what this test expects with the table in 02-class. " if error == "AssertionError" else ""
    )
    kind = f" with {error}" if error else ""
    return Feedback(
        summary="Your tests fail for a correct class: "
        + (f"`{test}` ends{kind}{f' about `{word}`' if word else ''}." if test else "they do not run."),
        seen=text[number - 1].strip() if number else None,
        where=cause.where if cause else (Location(TEST, number),),
        advice=cause.text
        if cause
        else f"{advice}Run `python3 -m unittest discover -v test` to see the whole message.",
    )


def slip_in_tests(text: tuple[str, ...], failed: int) -> Cause | None:
    """Why a test does not work at all. failed: the number of its line that failed."""
    for number, line in enumerate(text, 1):
        wrong = re.search(r"\bdef ((?!setUp\b)(?i:set_?up))\b", line)
        if wrong:
            what = f"unittest never calls `{wrong[1]}`. The method is called `setUp`, with a capital U."
            return Cause(what, (Location(TEST, number),))
        asserted = line.partition("assertEqual(")[2].rstrip()
        if number == failed and "==" in asserted and "," not in asserted and asserted.endswith(")"):
            what = "`assertEqual` compares two values itself. Put a comma between them, in place of `==`."
            return Cause(what, (Location(TEST, number),))
    return None


@unit_tests.check(
    "notices", f"they notice at least {NOTICED} of {len(FAULTS)} faults", points=2, needs="right"
)
def notices(recording: Recording) -> None:
    missed = unnoticed(recording)
    if len(FAULTS) - len(missed) >= NOTICED:
        return
    unnamed = never_run(only(recording, TEST))
    asserts = any("assert" in line for line in recording.home.file(TEST).lines)
    raise Failure(
        Feedback(
            summary=f"Your tests pass on {len(missed)} of {len(FAULTS)} broken classes."
            + ("" if asserts else " They call the class, but they do not compare anything."),
            expected=f"at least {NOTICED} noticed",
            seen=f"{len(FAULTS) - len(missed)} noticed",
            where=unnamed.where if unnamed else (Location(TEST),),
            advice=unnamed.text
            if unnamed
            else "For each fault below, write a test that fails because of it. `self.assertEqual` "
            "compares a result with the expected value.",
            details=tuple(f"not noticed: {fault}" for fault in missed),
        )
    )


@unit_tests.check("notices_all", "they notice every fault", bonus=True, needs="notices")
def notices_all(recording: Recording) -> None:
    missed = unnoticed(recording)
    unnamed = never_run(only(recording, TEST))
    if missed:
        raise Failure(
            Feedback(
                summary=f"{len(missed)} of {len(FAULTS)} faults went unnoticed.",
                where=unnamed.where if unnamed else (Location(TEST),),
                advice=unnamed.text
                if unnamed
                else "A test for each row of the table in 02-class notices them all.",
                details=tuple(f"not noticed: {fault}" for fault in missed),
            )
        )


def never_run(tests: Sources) -> Cause | None:
    """A method that asserts something, but has a name that unittest does not look for."""
    for file, tree in trees(tests):
        classes = (node for node in ast.walk(tree) if isinstance(node, ast.ClassDef))
        for part in (part for owner in classes for part in owner.body):
            if not isinstance(part, ast.FunctionDef) or part.name.startswith(("test", "setUp", "tearDown")):
                continue
            if "self.assert" in ast.unparse(part) and f".{part.name}(" not in tests.files[file]:
                name = f"test_{part.name.replace('test', '').strip('_')}"
                what = f"unittest runs only methods whose names begin with `test`, so not `{part.name}`. "
                return Cause(f"{what}Call it `{name}`.", (Location(file, part.lineno),))
    return None


def unnoticed(recording: Recording) -> list[str]:
    """The faults that no test notices."""
    ends = {fault: recording.process(fault).exited for fault in FAULTS}
    if None in ends.values():
        raise OurFault("not every broken class was tried")
    return [fault for fault, end in ends.items() if end is not None and end.code == 0]


async_await = Grader("02-async-await", builds=None, ros=False)
async_callback = Grader("02-async-callback", builds=None, ros=False)

ASYNC = f"{PACKAGE}/minimalist_async"
COROUTINE = f"{ASYNC}/_unlikely_to_return.py"
EXPORT = "from minimalist_package.minimalist_async import unlikely_to_return"
AWAIT, CALLBACK = "async_await_example", "async_callback_example"
# What each task returns, with the numbers from graders/probes/ch02_async.py.
WINS = {1: 0.0517, 2: 0.0271}
Story = tuple[tuple[int, float] | str, ...]


@async_await.scenario
def one_alone_then_the_example(arena: Arena) -> None:
    arena.probe(luck("alone()"), name="alone", cwd=PROJECT)
    play_example(arena, AWAIT)


@async_callback.scenario
def the_other_example(arena: Arena) -> None:
    arena.probe(luck("alone()"), name="alone", cwd=PROJECT)
    play_example(arena, CALLBACK)


def luck(command: str) -> str:
    return f"{(PROBES / 'ch02_async.py').read_text(encoding='utf-8')}\n{command}\n"


def play_example(arena: Arena, example: str) -> None:
    """Start the example, which may be in the subpackage or next to it."""
    if arena.files.is_file(file_of(example)):
        package = "minimalist_package.minimalist_async"
    elif arena.files.is_file(f"{PACKAGE}/{example}.py"):
        package = "minimalist_package"
    else:
        return
    arena.probe(luck(f"play({f'{package}.{example}'!r})"), name=example, cwd=PROJECT, timeout=8)


def file_of(example: str) -> str:
    return f"{ASYNC}/{example}.py"


@async_await.check("function", "`unlikely_to_return` is a coroutine that the subpackage exports")
def function(recording: Recording) -> None:
    if recording.missing_program("alone"):
        expect_text(recording, COROUTINE)
    expect_importable(recording, EXPORT, "alone")
    if answered(recording, "coroutine", "unlikely_to_return", "alone").value is not True:
        defined = [node.lineno for node in functions(only(recording, COROUTINE), "unlikely_to_return")]
        raise Failure(
            Feedback(
                summary="`unlikely_to_return` is an ordinary function, not a coroutine.",
                expected="async def unlikely_to_return(...)",
                where=(Location(COROUTINE, defined[0] if defined else None),),
                advice="Write `async` before its `def`. Only then can it use `await`.",
            )
        )


@async_await.check("returns", "it returns the first number below the likelihood", needs="function")
def returns(recording: Recording) -> None:
    where = Location(COROUTINE)
    advice = (
        "Draw a number. If it is less than `likelihood`, return the number itself. Otherwise, wait and "
        "draw again."
    )
    for question, what, wanted in (
        ("first", "await unlikely_to_return(tag)", 0.0271),
        ("second", "await unlikely_to_return(tag, likelihood=0.6)", 0.57),
    ):
        what = f"{what}, where 0.83, 0.57 and 0.0271 are drawn,"
        expect_answer(recording, question, wanted, what, advice=advice, where=where, name="alone")


@async_await.check("tries", "it prints each try, with its tag", needs="returns")
def tries(recording: Recording) -> None:
    printed = recording.process("alone").text
    for tag, draws in (("tag_x", 3), ("tag_y", 2)):
        lines = [line for line in printed if tag in line]
        if len(lines) < draws:
            raise Failure(
                Feedback(
                    summary=f"It drew {draws} numbers but printed {len(lines)} lines with its tag.",
                    expected="a line with the tag for each number that is drawn",
                    seen=lines[-1][:120] if lines else "no such line",
                    where=(Location(COROUTINE),),
                    advice="Print the tag and the number after each draw: before it returns, and before it "
                    "waits.",
                )
            )


def said_of_a_win(recording: Recording) -> int:
    """How many lines the coroutine itself prints after its last draw."""
    items = story(recording, "alone")
    last = max((n for n, item in enumerate(items) if isinstance(item, tuple)), default=len(items))
    return sum(isinstance(item, str) and "tag_" in item for item in items[last:])


@async_await.check("runs", "`async_await_example.py` runs to the end", needs="function")
def runs(recording: Recording) -> None:
    expect_played(recording, AWAIT)


@async_await.check("pace", "it draws every 0.1 s", needs="runs")
def pace(recording: Recording) -> None:
    lines = recording.process(AWAIT).lines
    times = tuple(line.t for line in lines if line.text.startswith("[draw 1 "))
    slip = slips.never_awaited(recording.sources.below(ASYNC))
    expect_period(
        times,
        0.1,
        what="draws",
        tolerance=0.4,
        advice=slip.text if slip else "Write `await asyncio.sleep(0.1)` between two draws.",
        where=slip.where if slip else (),
    )


@async_await.check("together", "both tasks run at the same time", needs="runs")
def together(recording: Recording) -> None:
    expect_together(recording, AWAIT)


@async_await.check("in_order", "the results are reported in the order of the await", needs=("runs", "tries"))
def in_order(recording: Recording) -> None:
    items = story(recording, AWAIT)
    first, second = (expect_report(recording, number, AWAIT) for number in WINS)
    if first < second and second > won(items, 1):
        return
    raise Failure(
        Feedback(
            summary="The result of task2 is reported before that of task1."
            if second < first
            else "The result of task2 is reported before task1 has ended.",
            expected="task1, then task2, although task2 ended first",
            seen=f"`{items[min(first, second)]}`, then `{items[max(first, second)]}`"[:200],
            where=(Location(file_of(AWAIT)),),
            advice="`await` the first task and report its result, then the second.",
        )
    )


@async_callback.check("runs", "`async_callback_example.py` runs until both tasks have ended")
def callback_runs(recording: Recording) -> None:
    expect_played(recording, CALLBACK)
    items = story(recording, CALLBACK)
    if all((number, value) in items for number, value in WINS.items()):
        return
    if (1, WINS[1]) in items and not any(isinstance(item, tuple) and item[0] == 2 for item in items):
        raise Failure(one_after_the_other(recording, CALLBACK))
    draws = sum(isinstance(item, tuple) for item in items)
    raise Failure(
        Feedback(
            summary="The program ends before its tasks do."
            if draws
            else "The program ends before any task begins.",
            expected="it waits until both have returned",
            seen=f"{draws} draws, then the end",
            where=(Location(file_of(CALLBACK)),),
            advice=(
                "When `async_main` returns, `asyncio.run` cancels any unfinished tasks. Keep the "
                "tasks in a list, and wait for them at the end: `await asyncio.wait(tasks)`."
            ),
        )
    )


@async_callback.check("together", "both tasks run at the same time", needs="runs")
def callback_together(recording: Recording) -> None:
    expect_together(recording, CALLBACK)


@async_callback.check("as_they_come", "each result is reported as soon as it arrives", points=2, needs="runs")
def as_they_come(recording: Recording) -> None:
    items = story(recording, CALLBACK)
    first, second = (expect_report(recording, number, CALLBACK) for number in WINS)
    if second < won(items, 1) < first:
        return
    raise Failure(
        Feedback(
            summary="The result of task2 is reported only after task1 has ended.",
            expected="task2 first, as soon as it ends",
            where=(Location(file_of(CALLBACK)),),
            advice=(
                "Report it in a callback that runs when the task ends: "
                "`task.add_done_callback(partial(handle_return_callback, tag))`."
            ),
        )
    )


def story(recording: Recording, name: str) -> Story:
    """What was drawn (task, number) and what was printed, in order."""
    items: list[tuple[int, float] | str] = []
    for text in recording.process(name).text:
        if text.startswith(("Exception in callback", "handle: <")):  # asyncio prints the result, too
            continue
        draw = re.fullmatch(r"\[draw (\d+) ([\d.]+)\]", text)
        items.append((int(draw[1]), float(draw[2])) if draw else text)
    return tuple(items)


def won(items: Story, number: int) -> int:
    return items.index((number, WINS[number]))


def expect_played(recording: Recording, example: str) -> None:
    """Expect that the example exists, drew numbers, and ended by itself without an exception."""
    if not recording.probe(example).ran:
        expect_text(recording, file_of(example))
    answered(recording, "ended", f"python3 {example}.py", example, where=Location(file_of(example)))
    if example == AWAIT and not all(
        (number, value) in story(recording, example) for number, value in WINS.items()
    ):
        serial = any(isinstance(item, tuple) for item in story(recording, example))
        raise Failure(one_after_the_other(recording, example) if serial else not_begun(recording, example))


def not_begun(recording: Recording, example: str) -> Feedback:
    view = recording.process(example)
    never = next(
        (found for line in view.text if (found := re.search(r"'(\w+)' was never awaited", line))), None
    )
    return Feedback(
        summary=f"The coroutine `{never[1]}` is called, but nothing awaits or runs it, so it does nothing."
        if never
        else f"`{example}.py` ends before either task begins.",
        where=(Location(file_of(example)),),
        advice=(
            "`asyncio.run(async_main())` runs the first one. In it, `asyncio.create_task(...)` "
            "starts others, and `await` waits for a task."
        ),
        details=view.text[-4:],
    )


def expect_together(recording: Recording, example: str) -> None:
    """Expect that task2 drew a number before task1 returned."""
    items = story(recording, example)
    begins = next((n for n, item in enumerate(items) if isinstance(item, tuple) and item[0] == 2), len(items))
    if begins < won(items, 1):
        return
    raise Failure(one_after_the_other(recording, example))


def one_after_the_other(recording: Recording, example: str) -> Feedback:
    sleeps = [call.where for call in calls(recording.sources.below(ASYNC), "sleep")]
    blocking = [place for place in sleeps if "time.sleep" in line_at(recording, place)]
    if blocking:
        return Feedback(
            summary="`time.sleep` stops the whole program, so the second task waits for the first.",
            expected="both at the same time",
            where=tuple(blocking),
            advice="`await asyncio.sleep(0.1)` lets the other task run in the meantime.",
        )
    slip = slips.never_awaited(recording.sources.below(ASYNC))
    return Feedback(
        summary="The second task begins only when the first has ended: together they take twice as long.",
        expected="both at the same time",
        where=slip.where if slip else (Location(file_of(example)),),
        advice=slip.text if slip else "Start both with `asyncio.create_task` before the first `await`.",
    )


def line_at(recording: Recording, place: Location) -> str:
    lines = recording.sources.files.get(place.file, "").splitlines()
    return lines[place.line - 1] if place.line and place.line <= len(lines) else ""


def expect_report(recording: Recording, number: int, example: str) -> int:
    """Index of the line that reports a task's result: the last one with its tag, after its last draw."""
    items, tag, own = story(recording, example), f"task{number}", said_of_a_win(recording)
    after = [
        n for n, item in enumerate(items) if n > won(items, number) and isinstance(item, str) and tag in item
    ]
    if len(after) > own and tells(str(items[after[-1]]), WINS[number]):
        return after[-1]
    late = slips.late_lambda(only(recording, file_of(example)))
    failed = crash(recording.process(example).traceback(), recording.packages, recording.sources)
    if failed:
        told = crash_feedback(failed, recording.packages, recording.sources)
        raise Failure(replace(told, summary=f"A callback stopped with an error: {failed.error}"))
    raise Failure(
        Feedback(
            summary=f"The result of {tag} is not reported."
            if len(after) <= own
            else f"The last line about {tag} does not contain its result.",
            expected=f"a line with `{tag}` and the number that it returned",
            seen=str(items[after[-1]])[:120] if after else "no such line",
            where=late.where if late else (Location(file_of(example)),),
            advice=late.text
            if late
            else "Print the tag and the result once the task ends, in addition to the task's own output.",
        )
    )


def tells(line: str, value: float) -> bool:
    return any(abs(float(text) - value) < 0.006 for text in re.findall(r"\d*\.\d+", line))


installable = Grader("02-installable", builds=None, ros=False)

SETUP = f"{PROJECT}/setup.py"
COMMANDS = {
    "minimalist_script": "minimalist_package.minimalist_script:main",
    AWAIT: f"minimalist_package.minimalist_async.{AWAIT}:main",
    CALLBACK: f"minimalist_package.minimalist_async.{CALLBACK}:main",
}
# What each of them prints, among other things.
SIGNS = {"minimalist_script": HOWDY, AWAIT: "task1", CALLBACK: "task1"}
VENV = ".venv_of_the_check"
LIST = "import os, sysconfig\nprint('installed:', *sorted(os.listdir(sysconfig.get_path('purelib'))))\n"
USE = "from minimalist_package import MinimalistClass\nprint(MinimalistClass(1.5, 2.5).method())\n"
OFFLINE = ("--no-index", "--no-build-isolation", "--no-deps", "--no-cache-dir", "--disable-pip-version-check")


@installable.scenario
def install_use_and_uninstall(arena: Arena) -> None:
    """Install, use and uninstall the package in a separate environment without a network."""
    with_pip = {"PYTHONPATH": sysconfig.get_path("purelib")}
    environment = str(arena.home / VENV)
    made = arena.python_module("venv", "--without-pip", environment, name="venv", ours=True)
    if not made or not made.wait(20):
        return
    pip = ("--python", environment)
    install = (*pip, "install", *OFFLINE, "./minimalist_package")
    folder = PROJECT.rpartition("/")[0]
    done = arena.python_module("pip", *install, name="install", cwd=folder, env=with_pip, ours=True)
    if not done or not done.wait(40):
        return
    alone = {"PYTHONPATH": ""}
    programs = {name: arena.execute(f"{VENV}/bin/{name}", name=name, env=alone) for name in COMMANDS}
    for name, code in (("list", LIST), ("use", USE)):
        ended = arena.execute(f"{VENV}/bin/python3", "-c", code, name=name, env=alone)
        if ended:
            ended.wait(10)
    for name, program in programs.items():
        if program:
            wanted = partial(does_its_work, name, partial(arena.lines, program))
            arena.until(wanted, timeout=10, while_running=program)
            program.close()
    away = arena.python_module(
        "pip", *pip, "uninstall", "-y", "minimalist_package", name="uninstall", env=with_pip, ours=True
    )
    if away and away.wait(20):
        last = arena.execute(f"{VENV}/bin/python3", "-c", LIST, name="list after", env=alone)
        if last:
            last.wait(10)


def does_its_work(name: str, printed: Callable[[], tuple[str, ...]]) -> bool:
    """Whether this command printed the output of its program, possibly after other output."""
    return any(SIGNS[name] in line for line in printed())


@installable.check("installs", "`pip install ./minimalist_package` works")
def installs(recording: Recording) -> None:
    expect_text(recording, SETUP, advice="Create it in the project folder, next to the package.")
    made, view = recording.process("venv"), recording.process("install")
    if made.exited is None or made.exited.code != 0:
        raise NotApplicable(
            "This computer cannot create a virtual environment: the package python3-venv is missing."
        )
    # An older setuptools installs entry points without a function.
    bare = any(":" not in entry.target for entry in entry_points(recording.sources, PROJECT))
    if view.exited is not None and view.exited.code == 0 and not bare:
        return
    if view.exited is None or view.exited.signal:
        raise Failure(
            Feedback(
                summary="pip never ends.",
                where=(Location(SETUP),),
                advice="`setup.py` must not wait for anything or start your program.",
            )
        )
    raise Failure(why_not_installed(recording))


def why_not_installed(recording: Recording) -> Feedback:
    entries = entry_points(recording.sources, PROJECT)
    joined = next((entry for entry in entries if entry.is_joined), None)
    bare = [entry for entry in entries if ":" not in entry.target]
    lines = recording.process("install").text
    errors = [
        line.strip() for line in lines if re.search(r"Error\b|error:", line) and "subprocess" not in line
    ]
    place = re.findall(r'setup\.py", line (\d+)', "\n".join(lines))
    if joined:
        return Feedback(
            summary="A comma is missing between two entry points: Python joins the two strings into one.",
            seen=joined.text,
            where=(joined.where,),
            advice="End each entry of `console_scripts` with a comma.",
        )
    if bare:
        return Feedback(
            summary=f"The entry point `{bare[0].name}` names a module but no function in it.",
            seen=bare[0].text,
            where=(bare[0].where,),
            advice="Put a colon between the module and the function, as in `package.module:main`.",
        )
    text = recording.home.file(SETUP).lines
    searched = [n for n, line in enumerate(text, 1) if re.search(r"find_packages\(\s*['\"]", line)]
    if searched:
        return Feedback(
            summary="pip cannot find the packages: `find_packages` looks for them in another folder.",
            where=(Location(SETUP, searched[0]),),
            advice="Its first argument is that folder. Leave it out: `find_packages(exclude=['test'])`.",
            details=tuple(errors[:4]),
        )
    return Feedback(
        summary=f"pip cannot install the project: {errors[-1] if errors else 'it does not say why'}",
        where=(Location(SETUP, int(place[-1]) if place else None),),
        advice="`find_packages` needs parentheses, which call it: `find_packages()`."
        if "'method' object is not iterable" in "".join(errors)
        else "Check this line of `setup.py` and the line before it."
        if place
        else "The last line of the message says what is wrong.",
        details=tuple(errors[:4]),
    )


@installable.check("commands", "the three commands run", points=3, needs="installs")
def commands(recording: Recording) -> None:
    joined = any(entry.is_joined for entry in entry_points(recording.sources, PROJECT))
    for name, target in COMMANDS.items():
        view = recording.process(name)
        if recording.missing_program(name):
            raise Failure(why_not_installed(recording) if joined else no_command(recording, name, target))
        crashed = crashed_command(recording, name)
        if crashed:
            raise Failure(crashed)
        if not does_its_work(name, lambda view=view: view.text):  # type: ignore[misc]
            raise Failure(
                Feedback(
                    summary=f"The command `{name}` starts but does not do what the program does.",
                    expected=f"a line with `{SIGNS[name]}`",
                    seen=view.text[-1][:120] if view.text else "no output",
                    where=text_places(recording.sources.below(PROJECT), name)[:1],
                    advice=f"Its entry point should be `{name} = {target}`.",
                )
            )


def no_command(recording: Recording, name: str, target: str) -> Feedback:
    known = [entry.name for entry in entry_points(recording.sources, PROJECT)]
    close = nearest(name, known)
    group = None if known else misspelled_group(recording.sources, PROJECT)
    return Feedback(
        summary=f"There is no command `{name}`; there is `{close}`."
        if close
        else f"There is no command `{name}`.",
        expected=f"{name} = {target}",
        seen=f"commands: {listed(known)}",
        where=(group.where if group else ())
        or text_places(recording.sources.below(PROJECT), close or "entry_points")[:1]
        or (Location(SETUP),),
        advice=group.text
        if group
        else f"Add `'{name} = {target}',` to the `console_scripts` of `setup.py`."
        if not close
        else "Correct the name before the `=`.",
    )


def packages_line(recording: Recording) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(SETUP).lines, 1)
    return tuple(Location(SETUP, n) for n, line in lines if re.match(r"\s*packages\s*=", line)) or (
        Location(SETUP),
    )


def crashed_command(recording: Recording, name: str) -> Feedback | None:
    failed = crash(recording.process(name).traceback(), recording.packages, recording.sources)
    if failed is None:
        return None
    lost = re.search(r"No module named '(minimalist_package[\w.]*)'", failed.error)
    entry = next((e for e in entry_points(recording.sources, PROJECT) if e.name == name), None)
    inside = bool(lost) and f"{PROJECT}/{(lost[1] if lost else '').replace('.', '/')}"
    known = inside and any(
        file.startswith((f"{inside}/", f"{inside}.py")) for file in recording.sources.names
    )
    if lost and known:
        return Feedback(
            summary=f"The command `{name}` cannot find `{lost[1]}`: it was not installed.",
            expected="packages=find_packages(exclude=['test'])",
            where=packages_line(recording),
            advice="`packages` must name the subpackage too; `find_packages` finds each folder that has an "
            "`__init__.py`.",
            details=failed.shown,
        )
    cause = known_error(recording, failed.error, failed.where)
    bare = re.search(r"No module named '(\w+)'", failed.error)
    if bare and f"{PROJECT}/minimalist_package/{bare[1]}.py" in recording.sources.files and entry:
        text = f"Write the package before the module, too: `{name} = minimalist_package.{entry.target}`."
        cause = Cause(text, (entry.where,))
    return Feedback(
        summary=f"The command `{name}` stops with an error: {failed.error}",
        where=cause.where if cause else (entry.where,) if entry else (Location(SETUP),),
        advice=cause.text
        if cause
        else "An entry point has the form `command = package.module:function`. Are all three parts right?",
        details=failed.shown,
    )


@installable.check("importable", "`import minimalist_package` works from another folder", needs="installs")
def importable(recording: Recording) -> None:
    view = recording.process("use")
    if view.text[-1:] == ("4.0",):
        return
    failed = crash(view.traceback(), recording.packages, recording.sources)
    raise Failure(
        Feedback(
            summary=(
                "The package does not work outside the project folder: "
                f"{(failed.error if failed else 'its class does not do what it should')}"
            ),
            where=packages_line(recording),
            advice=(
                "`packages=find_packages(exclude=['test'])` in `setup.py` names everything that is needed."
            ),
            details=failed.shown if failed else view.text[-3:],
        )
    )


@installable.check("no_test", "the tests are not installed", needs="installs")
def no_test(recording: Recording) -> None:
    names = installed(recording, "list")
    if "test" not in names:
        return
    raise Failure(
        Feedback(
            summary="`test` was installed too, as a separate package.",
            expected="minimalist_package alone",
            seen=listed(name for name in names if "." not in name),
            where=packages_line(recording),
            advice="Leave it out: `packages=find_packages(exclude=['test'])`.",
        )
    )


def installed(recording: Recording, process: str) -> list[str]:
    found = (line for line in recording.process(process).text if line.startswith("installed:"))
    return next(found, "").split()[1:]


@installable.check("uninstalls", "`pip uninstall` removes it again", needs="installs")
def uninstalls(recording: Recording) -> None:
    left = [name for name in installed(recording, "list after") if name.startswith("minimalist")]
    before = installed(recording, "list")
    if (
        recording.process("list after").exited
        and not left
        and any(n.startswith("minimalist_package") for n in before)
    ):
        return
    raise Failure(
        Feedback(
            summary="`pip uninstall minimalist_package` does not remove it.",
            expected="name='minimalist_package' in setup.py",
            seen=listed(left) if left else listed(before[:4]),
            where=text_places(recording.sources.below(PROJECT), "name")[:1] or (Location(SETUP),),
            advice="pip knows the project by the `name` in `setup.py`.",
            details=recording.process("uninstall").text[-3:],
        )
    )
