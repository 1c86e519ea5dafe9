"""Grader of chapter 15: a node that uses the library of chapter 14.

The wording of the log is free. A line with three numbers is the function's, another one the class's.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from itertools import combinations

from course.arena.arena import Arena
from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine, expect_period
from course.feedback import Failure, Feedback, Location
from course.grading.author import Grader
from course.grading.expect.graph import expect_node
from course.grading.expect.logs import expect_logged
from course.grading.expect.manifests import expect_dependency
from course.grading.expect.programs import expect_clean_interrupt, expect_running
from course.grading.explain.names import listed
from course.grading.explain.python_code import calls
from course.grading.explain.timers import timer_cause, timer_places

LIBRARY = "python_package_with_a_library"
PACKAGE = "python_package_that_uses_the_library"
NODE = "node_that_uses_the_library"
FUNCTION = "sample_function_for_square_of_sum"
FUNCTION_LINE = f"{FUNCTION}(A,B) returned C."
CLASS_LINE = "sample_class_with_random_name.get_name() returned NAME."
A_RANGE, B_RANGE = (0.0, 1.0), (1.0, 2.0)
LETTERS = 10
FEW_DECIMALS = 8  # a drawn number has many more
EXACT = 1e-9
ENOUGH = 5
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?!\w)")
DECIMAL = re.compile(r"\d\.\d|\{")  # what stands in no line with a name
LIST = re.compile(r"\[(['\"]).\1, ")  # how Python shows a list of letters
WHOLE = ("randint", "randrange", "choice", "getrandbits")
MOST_NUMBERS = 6  # of a line that are looked at
TEN_LETTERS = re.compile(rf"(?<![A-Za-z0-9_])[A-Za-z]{{{LETTERS}}}(?![A-Za-z0-9_])")

user = Grader("15-use-library")


@user.scenario
def five_times_two_lines(arena: Arena) -> None:
    """Five of each kind are four intervals. One pair more, as the node may also say something else."""
    node = arena.run(PACKAGE, NODE)
    if node and arena.until(lambda: arena.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: arena.logged("") or arena.printed("."), timeout=4, while_running=node)
        arena.until(lambda: arena.logged("") >= 2 * ENOUGH + 2, timeout=4, while_running=node)
    arena.interrupt(node)


@dataclass(frozen=True)
class Sum:
    """A line with A, B and C, and the line itself."""

    a: float
    b: float
    c: float
    line: LogLine

    @property
    def error(self) -> float:
        return abs(self.c - (self.a + self.b) ** 2)

    @property
    def fits(self) -> bool:
        return within(self.a, A_RANGE) and within(self.b, B_RANGE) and self.error <= EXACT


def within(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]


def lines_of(recording: Recording) -> tuple[LogLine, ...]:
    """A message of several lines counts as several."""
    return tuple(
        LogLine(message.t, message.node, message.level, text)
        for message in recording.log
        for text in message.text.splitlines()
    )


def sums(recording: Recording) -> tuple[Sum, ...]:
    return tuple(found for found in map(as_sum, lines_of(recording)) if found)


def as_sum(line: LogLine) -> Sum | None:
    """A stands before B; C, and other numbers, may be anywhere. Else the last three count."""
    numbers = [float(text) for text in NUMBER.findall(line.text)][-MOST_NUMBERS:]
    if len(numbers) < 3:
        return None
    pairs = combinations(range(len(numbers)), 2)
    every = (
        Sum(numbers[i], numbers[j], c, line)
        for i, j in pairs
        for k, c in enumerate(numbers)
        if k not in (i, j)
    )
    return next((found for found in every if found.fits), Sum(*numbers[-3:], line))


@user.check("starts", "the node starts and keeps running")
def starts(recording: Recording) -> None:
    expect_running(recording, NODE)


@user.check("node_name", f"the node is called /{NODE}", needs="starts")
def node_name(recording: Recording) -> None:
    expect_node(recording, f"/{NODE}")


@user.check("function", "it logs A, B and what the function returned", needs="starts")
def function(recording: Recording) -> None:
    lines = tuple(found.line for found in sums(recording))
    if not lines and recording.log:
        raise Failure(no_numbers(recording))
    expect_logged(recording, NODE, lines, FUNCTION_LINE, ".")


def no_numbers(recording: Recording) -> Feedback:
    """The node logs, but nothing with A, B and C in it."""
    texts = [line.text for line in lines_of(recording)]
    braces = next((text for text in texts if "{" in text), None)
    decimal = next((text for text in texts if DECIMAL.search(text)), None)
    printed = tuple(call.where for call in calls(recording.sources, "print"))
    if braces:
        advice = "The braces were logged as they are: put an `f` before the string, `f'...'`."
    elif decimal:
        advice = "Log A and B as well as what the function returned, all in one line."
    elif printed:
        advice = "Use the node's logger in place of `print`: `self.get_logger().info(...)`."
    else:
        advice = f"In the callback, call `{FUNCTION}`, and log both numbers and its result."
    return Feedback(
        summary="The node logs no line with the three numbers A, B and C.",
        expected=FUNCTION_LINE,
        seen=(braces or decimal or texts[0])[:200],
        where=printed[:2] or tuple(call.where for call in calls(recording.sources, FUNCTION))[:2],
        advice=advice,
    )


@user.check("ranges", "A is in [0, 1], B in [1, 2]", needs="function")
def ranges(recording: Recording) -> None:
    for found in sums(recording):
        if not (within(found.a, A_RANGE) and within(found.b, B_RANGE)):
            raise Failure(outside(recording, found))


def outside(recording: Recording, found: Sum) -> Feedback:
    swapped = within(found.b, A_RANGE) and within(found.a, B_RANGE)
    name, value, limits = ("B", found.b, B_RANGE) if within(found.a, A_RANGE) else ("A", found.a, A_RANGE)
    low, high = (f"{limit:g}" for limit in limits)
    return Feedback(
        summary="A and B are swapped: A is drawn from [1, 2], and B from [0, 1]."
        if swapped
        else f"{name} is {value:g}; it should lie between {low} and {high}.",
        expected="A in [0, 1], B in [1, 2]",
        seen=found.line.text[:200],
        where=drawn_at(recording)[:2],
        advice=f"`random.uniform({low}, {high})` draws {name} from there. A is the first number of the line.",
    )


def drawn_at(recording: Recording) -> tuple[Location, ...]:
    ways = ("uniform", "random", "randint", "randrange", "choice", "choices", "sample", "seed")
    return tuple(call.where for way in ways for call in calls(recording.sources, way))


@user.check("right", "C is the square of A + B", needs="function")
def right(recording: Recording) -> None:
    for found in sums(recording):
        if found.error > EXACT:
            raise Failure(wrong(recording, found))


def wrong(recording: Recording, found: Sum) -> Feedback:
    decimals = max(len(repr(value).partition(".")[2]) for value in (found.a, found.b))
    if decimals <= FEW_DECIMALS and found.error < 0.1:
        return Feedback(
            summary="The numbers were rounded before they were logged, so C is not right for A and B.",
            expected=f"{(found.a + found.b) ** 2!r}",
            seen=found.line.text[:200],
            advice="Log them as they are: `{a}`, not `{a:.2f}`.",
        )
    return Feedback(
        summary="C is not the square of A + B.",
        expected=f"{(found.a + found.b) ** 2!r} for A = {found.a!r} and B = {found.b!r}",
        seen=found.line.text[:200],
        where=tuple(call.where for call in calls(recording.sources, FUNCTION))[:2],
        advice="Hand the very numbers that you log to the function of the library. If you do, it is the "
        "library: `ros2course check 14-library`.",
    )


@user.check("random_numbers", "A and B are drawn again each time", needs=("ranges", "right"))
def random_numbers(recording: Recording) -> None:
    found = sums(recording)
    if all(each.a.is_integer() and each.b.is_integer() for each in found):
        whole = [call.where for way in WHOLE for call in calls(recording.sources, way)]
        if whole:
            raise Failure(whole_numbers(found[0], whole[0]))
    for name, values in (("A", [each.a for each in found]), ("B", [each.b for each in found])):
        if len(values) < 2:
            raise Failure(too_few(recording, found[0].line))
        if len(set(values)) < 2:
            raise Failure(always(recording, f"{name} is", f"{values[0]!r}"))


def whole_numbers(found: Sum, where: Location) -> Feedback:
    return Feedback(
        summary="Only whole numbers are drawn: A is 0 or 1, and B is 1 or 2.",
        expected="any number in between, like 0.3745401188473625",
        seen=found.line.text[:200],
        where=(where,),
        advice="`random.uniform(0, 1)` draws from all numbers between 0 and 1.",
    )


def always(recording: Recording, what: str, value: str) -> Feedback:
    return Feedback(
        summary=f"{what} always the same: {value}.",
        expected="another one in each line",
        seen=value,
        where=drawn_at(recording)[:2],
        advice="Draw in the timer's callback, so that it happens each time. What is drawn in `__init__`, or "
        "at the top of the file, is drawn once.",
    )


def too_few(recording: Recording, line: LogLine) -> Feedback:
    cause = timer_cause(recording.sources)
    return Feedback(
        summary="The node says this only once; it should go on forever.",
        expected="a line every 0.5 s",
        seen=line.text[:200],
        where=cause.where if cause else timer_places(recording.sources),
        advice=cause.text if cause else "Make a timer of 0.5 s with `create_timer`; its callback logs.",
    )


@user.check("class", "it logs a name of ten letters that the class returned", needs="starts")
def class_(recording: Recording) -> None:
    lines = name_lines(recording)
    if not lines:
        raise Failure(no_names(recording))
    wrong_level = [line for line in lines if line.level != "INFO"]
    if wrong_level:
        expect_logged(recording, NODE, tuple(wrong_level), CLASS_LINE, ".")
    if len(varying_names(lines)) < 2:
        odd = odd_name(recording, lines)
        if odd:
            raise Failure(odd)


@user.check("random_names", "the name is drawn again each time", needs="class")
def random_names(recording: Recording) -> None:
    lines = name_lines(recording)
    if len(set(varying_names(lines))) >= 2:
        return
    if len(lines) < 2:
        raise Failure(too_few(recording, lines[0]))
    raise Failure(always(recording, "The name is", f"{TEN_LETTERS.findall(lines[0].text)[-1]}"))


def name_lines(recording: Recording) -> list[LogLine]:
    """The lines that are not the function's: of those, the kind that comes most often."""
    every = (line for line in lines_of(recording) if line.text.strip())
    lines = [line for line in every if not as_sum(line) and not DECIMAL.search(line.text)]
    firsts = Counter(line.text.split()[0] for line in lines)
    word, count = firsts.most_common(1)[0] if firsts else ("", 0)
    return [line for line in lines if line.text.split()[0] == word] if count > 1 else lines


def varying_names(lines: list[LogLine]) -> list[str]:
    """Words of ten letters that are not in every line: those belong to the wording."""
    found = [set(TEN_LETTERS.findall(line.text)) for line in lines]
    wording = set.intersection(*found) if len(found) > 1 else set()
    return [name for names in found for name in names - wording]


def odd_name(recording: Recording, lines: list[LogLine]) -> Feedback | None:
    """Why there is no name of ten letters; None when there is one, always the same."""
    text = lines[0].text
    if "bound method" in text or " object at 0x" in text:
        return misread(recording, lines[0], "method" if "bound method" in text else "object")
    if LIST.search(text):
        return a_list(recording, lines[0])
    words = [{word.strip(".,;:!?'\"()") for word in line.text.split()} for line in lines]
    changing = words[0] - set.intersection(*words)
    if changing:
        return misspelt(recording, lines[0], max(changing, key=len))
    if TEN_LETTERS.search(text):
        return None
    return misspelt(recording, lines[0], text.split()[-1].strip(".,;:!?'\"()"))


def misread(recording: Recording, line: LogLine, what: str) -> Feedback:
    places = tuple(call.where for call in calls(recording.sources, "SampleClass"))
    return Feedback(
        summary="`get_name` is named and not called: the method itself is logged."
        if what == "method"
        else "The object is logged, not its name.",
        expected=CLASS_LINE,
        seen=line.text[:200],
        where=places[:2],
        advice="Put brackets after it: `get_name()` returns the name.",
    )


def a_list(recording: Recording, line: LogLine) -> Feedback:
    return Feedback(
        summary="The name is a list of letters, not a text.",
        expected=f"{LETTERS} random letters",
        seen=line.text[:200],
        where=drawn_at(recording)[-1:],
        advice="Join them: `''.join(letters)`.",
    )


def misspelt(recording: Recording, line: LogLine, name: str) -> Feedback:
    if not (name.isascii() and name.isalpha()):
        strange = [sign for sign in dict.fromkeys(name) if not (sign.isascii() and sign.isalpha())]
        summary = f"The name `{name[:40]}` holds {listed(strange[:3])}: no ASCII letters."
        advice = "Draw from `string.ascii_letters`: a to z and A to Z, and nothing else."
    else:
        summary = f"The name `{name[:40]}` has {len(name)} letters, not {LETTERS}."
        advice = f"`random.choices(string.ascii_letters, k={LETTERS})` draws {LETTERS} of them."
    return Feedback(
        summary=summary,
        expected=f"{LETTERS} random letters",
        seen=line.text[:200],
        where=drawn_at(recording)[-2:],
        advice=advice,
    )


def no_names(recording: Recording) -> Feedback:
    printed = tuple(call.where for call in calls(recording.sources, "print"))
    return Feedback(
        summary="The node logs no second kind of line, the one with the name.",
        expected=CLASS_LINE,
        seen="printed, not logged" if printed else "lines with numbers only" if recording.log else "nothing",
        where=printed[:2] or tuple(call.where for call in calls(recording.sources, "SampleClass"))[:2],
        advice="Use `self.get_logger().info(...)` for this line, too."
        if printed
        else "In the callback, make a `SampleClass` with a random name, and log what `get_name()` returns.",
    )


@user.check("rate", "it logs both every 0.5 s", needs=("function", "class"))
def rate(recording: Recording) -> None:
    advice = "The period of `create_timer` is in seconds: 0.5."
    kinds = (("lines of the function", [s.line for s in sums(recording)]), ("names", name_lines(recording)))
    for what, lines in kinds:
        expect_period(tuple(line.t for line in lines), 0.5, what=what, advice=advice)


@user.check("declares", "package.xml declares rclpy and the library")
def declares(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", LIBRARY)


@user.check("interrupt", "Ctrl+C ends it in silence", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)
