"""Grader of chapter 4: a layout of Terminator with three terminals in one window."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from configobj import ConfigObj, ConfigObjError

from course.api import Failure, Feedback, Grader, HomeFile, Location, Recording, expect_text, listed, nearest

CONFIG = ".config/terminator/config"
ENOUGH, LONGEST_LINE = 3, 2000
KINDS = ("Window", "HPaned", "VPaned", "Notebook", "Terminal")
SAVE = "In Terminator: right-click, then Preferences, Layouts, Add, Save."

layout = Grader("04-layout", builds=None)


@dataclass(frozen=True)
class Part:
    """One window, split or terminal of a layout."""

    name: str
    kind: str
    parent: str


@layout.check("reads", "`~/.config/terminator/config` exists and can be read")
def reads(recording: Recording) -> None:
    found = expect_text(recording, CONFIG, advice=f"{SAVE} The exercise's text says how to start it.")
    if not (found.text or "").strip():
        raise Failure(
            Feedback(
                summary="The file is empty: no layout has been saved yet.",
                where=(Location(CONFIG),),
                advice=SAVE,
            )
        )
    for number, line in enumerate(found.lines, 1):
        if len(line) > LONGEST_LINE:  # the longer a line, the slower Terminator parses it
            raise Failure(
                Feedback(
                    summary=f"Line {number} is longer than any line that Terminator writes.",
                    seen=f"{line[:60]}...",
                    where=(Location(CONFIG, number),),
                    advice="Remove the file, and save the layout again in Terminator.",
                )
            )
    try:
        parsed(found)
    except ConfigObjError as error:
        first = (getattr(error, "errors", None) or [error])[0]
        number = getattr(first, "line_number", None)
        raise Failure(
            Feedback(
                summary="Terminator cannot read this file.",
                seen=found.lines[number - 1].strip()[:120] if number else None,
                where=(Location(CONFIG, number),),
                advice=(
                    "The simplest way is to remove the file and save the layout again in Terminator. "
                    "If you edited it by hand, check that each heading closes as many brackets as it "
                    "opens."
                ),
                details=(str(first),),
            )
        ) from None


def parsed(file: HomeFile) -> Mapping[str, Any]:
    """The file as Terminator parses it. Raises ConfigObjError."""
    config: Mapping[str, Any] = ConfigObj(list(file.lines), interpolation=False)
    return config


def layouts(config: Mapping[str, Any]) -> dict[str, tuple[Part, ...]]:
    """The parts of each layout; anything else is left out."""
    section = config.get("layouts")
    entries = section.items() if isinstance(section, Mapping) else ()
    return {name: parts(entry) for name, entry in entries if isinstance(entry, Mapping)}


def parts(entry: Mapping[str, Any]) -> tuple[Part, ...]:
    found = ((name, part) for name, part in entry.items() if isinstance(part, Mapping))
    return tuple(Part(name, str(part.get("type", "")), str(part.get("parent", ""))) for name, part in found)


def window_of(part: Part, every: Mapping[str, Part]) -> str | None:
    """The window that contains a part; None if nothing does."""
    seen: set[str] = set()
    while part.kind != "Window":
        if part.name in seen or part.parent not in every or part.kind not in KINDS:
            return None
        seen.add(part.name)
        part = every[part.parent]
    return part.name


def terminals(entry: tuple[Part, ...]) -> dict[str | None, int]:
    """The number of terminals in each window; None for those without a window."""
    every = {part.name: part for part in entry}
    counts: dict[str | None, int] = {}
    for part in entry:
        if part.kind == "Terminal":
            window = window_of(part, every)
            counts[window] = counts.get(window, 0) + 1
    return counts


@layout.check("three", "a layout has three terminals in one window", points=2, needs="reads")
def three(recording: Recording) -> None:
    file = recording.home.file(CONFIG)
    config = parsed(file)
    found = layouts(config)
    if not found:
        raise Failure(no_layouts(config, file))
    most = {name: largest(entry) for name, entry in found.items()}
    total = {name: sum(terminals(entry).values()) for name, entry in found.items()}
    best = max(most, key=lambda name: (most[name] >= ENOUGH, total[name]))
    if most[best] < ENOUGH:
        raise Failure(too_few(best, found[best], file))


def largest(entry: tuple[Part, ...]) -> int:
    return max((count for window, count in terminals(entry).items() if window is not None), default=0)


def no_layouts(config: Mapping[str, Any], file: HomeFile) -> Feedback:
    close = nearest("layouts", list(config))
    return Feedback(
        summary=f"The file has no section `[layouts]`; it has `[{close}]`."
        if close and close != "layouts"
        else "This file contains no layout.",
        expected="[layouts]",
        seen=listed([f"[{name}]" for name in config]),
        where=(heading(file, close or "layouts"),),
        advice=SAVE,
    )


def too_few(name: str, entry: tuple[Part, ...], file: HomeFile) -> Feedback:
    counts = terminals(entry)
    lost = counts.get(None, 0)
    every = {part.name: part for part in entry}
    orphan = next((p for p in entry if p.kind == "Terminal" and window_of(p, every) is None), None)
    windows = len([window for window in counts if window is not None])
    odd = next((part for part in entry if part.kind not in KINDS), None)
    if odd:
        typed = (n for n, line in enumerate(file.lines, 1) if line.split() == ["type", "=", odd.kind])
        place = Location(CONFIG, next(typed, None))
        summary = (
            f"In the layout `{name}`, `{odd.name}` has the type `{odd.kind}`, which Terminator does not know."
        )
        advice = f"The types are {listed(KINDS)}, with the same capital letters."
    elif orphan and sum(counts.values()) >= ENOUGH:
        summary = (
            f"In the layout `{name}`, `{orphan.name}` is in `{orphan.parent}`, which is not in any window."
        )
        advice = (
            f"Set its `parent` to one of {listed(sorted(p.name for p in entry if p.kind != 'Terminal'))}."
        )
    elif windows > 1:
        summary = f"The layout `{name}` has {windows} windows, and none of them has {ENOUGH} terminals."
        advice = (
            "Split one window (Ctrl+Shift+E, Ctrl+Shift+O) instead of opening more windows, then "
            "save the layout."
        )
    else:
        summary = f"The layout `{name}` has too few terminals: {sum(counts.values()) - lost}."
        advice = f"Split the window until it has {ENOUGH}, then save the layout again. {SAVE}"
    return Feedback(
        summary=summary,
        expected=f"{ENOUGH} terminals in one window",
        seen=f"{largest(entry)} in one window",
        where=(place if odd else heading(file, orphan.name if orphan else name),),
        advice=advice,
    )


def heading(file: HomeFile, name: str) -> Location:
    lines = enumerate(file.lines, 1)
    return Location(CONFIG, next((n for n, line in lines if line.strip().strip("[]").strip() == name), None))
