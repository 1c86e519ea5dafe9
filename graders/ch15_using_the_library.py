"""Grader of chapter 15: a node that uses the library from chapter 14.

The log may use any words. A line with three numbers belongs to the function, any other to the class.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from itertools import combinations

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    LogLine,
    Process,
    Recording,
    calls,
    cause_of_silence,
    expect_clean_interrupt,
    expect_dependency,
    expect_logged,
    expect_node,
    expect_period,
    expect_running,
    listed,
    slips,
)

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
DECIMAL = re.compile(r"\d\.\d|\{")  # never in a line with a name
LIST = re.compile(r"\[(['\"]).\1, ")  # how Python shows a list of letters
WHOLE = ("randint", "randrange", "choice", "getrandbits")
MOST_NUMBERS = 6  # per line that we look at
TEN_LETTERS = re.compile(rf"(?<![A-Za-z0-9_])[A-Za-z]{{{LETTERS}}}(?![A-Za-z0-9_])")

user = Grader("15-use-library")


@user.scenario
def five_times_two_lines(arena: Arena) -> None:
    """Record five lines of each kind, which make four intervals. Other output does not count."""
    node = arena.run(PACKAGE, NODE)
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: any(heard(arena, node)), timeout=6, while_running=node)
        # The log may come later than the terminal's lines: wait for one more of each kind.
        arena.until(lambda: min(heard(arena, node)) > ENOUGH, timeout=4, while_running=node)
    arena.interrupt(node)


def heard(arena: Arena, node: Process) -> tuple[int, int]:
    """How many lines with numbers, and how many with names, are on the node's terminal."""
    texts = [line.rpartition("]: ")[2] for line in arena.lines(node)]
    return (
        sum(bool(DECIMAL.search(text)) for text in texts),
        sum(bool(TEN_LETTERS.search(text)) for text in texts),
    )


@dataclass(frozen=True)
class Sum:
    """The numbers A, B, and C on a line, and the line itself."""

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
    """The lines of all messages."""
    return tuple(
        LogLine(message.t, message.node, message.level, text)
        for message in recording.log
        for text in message.text.splitlines()
    )


def sums(recording: Recording) -> tuple[Sum, ...]:
    return tuple(found for found in map(as_sum, lines_of(recording)) if found)


def as_sum(line: LogLine) -> Sum | None:
    """A comes before B; C and other numbers may be anywhere. If no three fit, the last three count."""
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


@user.check("function", "it logs A, B, and the function's result", needs="starts")
def function(recording: Recording) -> None:
    lines = tuple(found.line for found in sums(recording))
    if not lines and recording.log:
        raise Failure(no_numbers(recording))
    expect_logged(recording, NODE, lines, FUNCTION_LINE, ".")


def no_numbers(recording: Recording) -> Feedback:
    """The node logs, but nothing with A, B, and C."""
    texts = [line.text for line in lines_of(recording)]
    braces = next((text for text in texts if "{" in text), None)
    decimal = next((text for text in texts if DECIMAL.search(text)), None)
    printed = tuple(call.where for call in calls(recording.sources, "print"))
    if braces:
        advice = "The log shows the braces themselves. Put an `f` before the string: `f'...'`."
    elif decimal:
        advice = "Log A, B, and the function's result, all on one line."
    elif printed:
        advice = "Use the node's logger instead of `print`: `self.get_logger().info(...)`."
    else:
        advice = f"In the callback, call `{FUNCTION}`, and log both numbers and its result."
    return Feedback(
        summary="The node never logs a line with the three numbers A, B, and C.",
        expected=FUNCTION_LINE,
        seen=(braces or decimal or texts[0])[:200],
        where=printed[:2] or tuple(call.where for call in calls(recording.sources, FUNCTION))[:2],
        advice=advice,
    )


@user.check("ranges", "A is in [0, 1], and B is in [1, 2]", needs="function")
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
        else f"{name} is {value:g}; it should be between {low} and {high}.",
        expected="A in [0, 1], B in [1, 2]",
        seen=found.line.text[:200],
        where=drawn_at(recording)[:2],
        advice=(
            f"Draw {name} with `random.uniform({low}, {high})`. The first number on the line counts as A, "
            "and the second as B."
        ),
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
            summary="The numbers were rounded before they were logged, so C no longer matches A and B.",
            expected=f"{(found.a + found.b) ** 2!r}",
            seen=found.line.text[:200],
            where=tuple(call.where for call in calls(recording.sources, "info"))[:1],
            advice="Log them as they are: `{a}`, not `{a:.2f}`.",
        )
    return Feedback(
        summary="C is not the square of A + B.",
        expected=f"{(found.a + found.b) ** 2!r} for A = {found.a!r} and B = {found.b!r}",
        seen=found.line.text[:200],
        where=tuple(call.where for call in calls(recording.sources, FUNCTION))[:2],
        advice=(
            "Pass the numbers that you log to the library's function. If you already do, the "
            "library is wrong: run `ros2course check 14-library`."
        ),
    )


@user.check("random_numbers", "A and B are new each time", needs=("ranges", "right"))
def random_numbers(recording: Recording) -> None:
    found = sums(recording)
    whole = [call.where for way in WHOLE for call in calls(recording.sources, way)]
    for name, limits in (("a", A_RANGE), ("b", B_RANGE)) if whole else ():
        if all(getattr(each, name).is_integer() for each in found):
            raise Failure(whole_numbers(found[0], name.upper(), limits, whole[0]))
    for name, values in (("A", [each.a for each in found]), ("B", [each.b for each in found])):
        if len(values) < 2:
            raise Failure(too_few(recording, found[0].line))
        if len(set(values)) < 2:
            raise Failure(always(recording, f"{name} is", f"{values[0]!r}"))


def whole_numbers(found: Sum, name: str, limits: tuple[float, float], where: Location) -> Feedback:
    low, high = map(int, limits)
    return Feedback(
        summary=f"Your program draws only integers for {name}: it is always {low} or {high}.",
        expected="any number in between, such as 0.3745401188473625",
        seen=found.line.text[:200],
        where=(where,),
        advice=f"Use `random.uniform({low}, {high})`, which draws any number between {low} and {high}.",
    )


def always(recording: Recording, what: str, value: str) -> Feedback:
    return Feedback(
        summary=f"{what} always the same: {value}.",
        expected="a different one on each line",
        seen=value,
        where=drawn_at(recording)[:2],
        advice=(
            "Draw it in the timer's callback, which runs every 0.5 s. A value drawn in `__init__`, or at "
            "the top of the file, never changes."
        ),
    )


def too_few(recording: Recording, line: LogLine) -> Feedback:
    cause = cause_of_silence(
        recording, NODE, slips.logged_seldom, look_at="does a 0.5 s timer call the function that logs?"
    )
    return Feedback(
        summary="The node logs this only once. It should keep logging.",
        expected="a line every 0.5 s",
        seen=line.text[:200],
        where=cause.where,
        advice=cause.text,
    )


@user.check("class", "it logs a ten-letter name from the class", needs="starts")
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


@user.check("random_names", "the name is new each time", needs="class")
def random_names(recording: Recording) -> None:
    lines = name_lines(recording)
    if len(set(varying_names(lines))) >= 2:
        return
    if len(lines) < 2:
        raise Failure(too_few(recording, lines[0]))
    raise Failure(always(recording, "The name is", f"{TEN_LETTERS.findall(lines[0].text)[-1]}"))


def name_lines(recording: Recording) -> list[LogLine]:
    """The most frequent kind of lines, among those that are not from the function."""
    every = (line for line in lines_of(recording) if line.text.strip())
    lines = [line for line in every if not as_sum(line) and not DECIMAL.search(line.text)]
    firsts = Counter(line.text.split()[0] for line in lines)
    word, count = firsts.most_common(1)[0] if firsts else ("", 0)
    return [line for line in lines if line.text.split()[0] == word] if count > 1 else lines


def varying_names(lines: list[LogLine]) -> list[str]:
    """Words of ten letters, except for those on every line, which are not names."""
    found = [set(TEN_LETTERS.findall(line.text)) for line in lines]
    wording = set.intersection(*found) if len(found) > 1 else set()
    return [name for names in found for name in names - wording]


def odd_name(recording: Recording, lines: list[LogLine]) -> Feedback | None:
    """Why there is no name of ten letters, or None if there is one that is always the same."""
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
        summary="`get_name` is not called: the log shows the method itself."
        if what == "method"
        else "The log shows the object, not its name.",
        expected=CLASS_LINE,
        seen=line.text[:200],
        where=places[:2],
        advice="Call `get_name()`, with parentheses. It returns the name.",
    )


def a_list(recording: Recording, line: LogLine) -> Feedback:
    return Feedback(
        summary="The name is a list of letters, not a string.",
        expected=f"{LETTERS} random letters",
        seen=line.text[:200],
        where=drawn_at(recording)[-1:],
        advice="Join them: `''.join(letters)`.",
    )


def misspelt(recording: Recording, line: LogLine, name: str) -> Feedback:
    if not (name.isascii() and name.isalpha()):
        strange = [sign for sign in dict.fromkeys(name) if not (sign.isascii() and sign.isalpha())]
        shown = listed(strange[:3])
        summary = f"The name `{name[:40]}` contains characters that are not ASCII letters: {shown}."
        advice = "Draw from `string.ascii_letters`, which contains a to z and A to Z."
    else:
        summary = f"The name `{name[:40]}` has {len(name)} letters, not {LETTERS}."
        advice = f"Draw {LETTERS} letters: `random.choices(string.ascii_letters, k={LETTERS})`."
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
        summary="The node never logs the second kind of line, which contains the name.",
        expected=CLASS_LINE,
        seen="printed, not logged" if printed else "lines with numbers only" if recording.log else "nothing",
        where=printed[:2] or tuple(call.where for call in calls(recording.sources, "SampleClass"))[:2],
        advice="Use `self.get_logger().info(...)` for this line, too."
        if printed
        else (
            "In the callback, create a `SampleClass` with a random name, and log the result of `get_name()`."
        ),
    )


@user.check("rate", "it logs both every 0.5 s", needs=("function", "class"))
def rate(recording: Recording) -> None:
    kinds = (
        ("lines with the function's result", [s.line for s in sums(recording)]),
        ("names", name_lines(recording)),
    )
    for what, lines in kinds:
        expect_period(tuple(line.t for line in lines), 0.5, what=what, program=recording)


@user.check("declares", "package.xml declares rclpy and the library")
def declares(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", LIBRARY)


@user.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)
