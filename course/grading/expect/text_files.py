"""Expectations about files in the course home."""

from __future__ import annotations

import stat
from collections.abc import Sequence
from pathlib import PurePosixPath

from course.evidence.home_files import HomeFile
from course.evidence.recording import Recording
from course.model.feedback import Failure, Feedback, Location
from course.spelling import listed

_SHOWN = 5
_CUT = 120


def expect_file(recording: Recording, path: str, *, advice: str | None = None) -> HomeFile:
    """Check that there is a file at `path` (relative to the home); otherwise say what is there instead.

    advice: what to do if there is nothing similar either.
    """
    found = recording.home.file(path)
    if found.is_file:
        return found
    raise Failure(_wrong_kind(found) if found.exists else _missing(recording, path, advice))


def expect_text(recording: Recording, path: str, *, advice: str | None = None) -> HomeFile:
    """Check that there is a text file at `path`; otherwise, this is like `expect_file`."""
    found = expect_file(recording, path, advice=advice)
    if found.text is None:
        raise Failure(
            Feedback(
                summary=f"`~/{path}` is not a text file, or is far too large ({found.size} bytes).",
                where=(Location(path),),
                advice=advice or "Remove it with `rm`, and create it again.",
            )
        )
    return found


def expect_lines(recording: Recording, path: str, wanted: Sequence[str], *, advice: str) -> None:
    """Check that the file contains exactly these lines; the final newline is optional."""
    seen = expect_text(recording, path).lines
    if list(seen) == list(wanted):
        return
    same = next((i for i, (a, b) in enumerate(zip(seen, wanted, strict=False)) if a != b), None)
    place = min(len(seen), len(wanted)) if same is None else same
    missing, extra = place >= len(seen), place >= len(wanted)
    raise Failure(
        Feedback(
            summary=_difference(path, seen, wanted, place),
            expected="no more lines" if extra else _short(wanted[place]),
            seen="no more lines" if missing else _short(seen[place]),
            where=(Location(path) if missing else Location(path, place + 1),),
            advice=advice,
        )
    )


def expect_mode(
    recording: Recording, path: str, *, has: int = 0, lacks: int = 0, summary: str, advice: str
) -> None:
    """Check that the file's mode has all bits of `has` and none of `lacks` (such as `stat.S_IXUSR`)."""
    found = expect_file(recording, path)
    if found.mode & has == has and not found.mode & lacks:
        return
    wanted = (found.mode | has) & ~lacks
    raise Failure(
        Feedback(
            summary=summary,
            expected=_as_ls_shows(wanted),
            seen=_as_ls_shows(found.mode),
            where=(Location(path),),
            advice=advice,
        )
    )


def _as_ls_shows(mode: int) -> str:
    """A mode as `ls` shows it: `-rwxr-xr-x (755)`."""
    return f"{stat.filemode(stat.S_IFREG | mode)} ({mode & 0o777:03o})"


def _wrong_kind(found: HomeFile) -> Feedback:
    path, name = found.path, PurePosixPath(found.path).name
    if found.kind == "folder":
        return Feedback(
            summary=f"`~/{path}` is a folder; it should be a file.",
            where=(Location(path),),
            advice=(
                f"Remove the folder with `rm -r ~/{path}`, then create the file: `touch` creates "
                "files, `mkdir` creates folders."
            ),
        )
    if found.kind == "link":
        return Feedback(
            summary=f"`~/{path}` is a link to `{found.target}`, which is not in your course home.",
            where=(Location(path),),
            advice=f"Remove it with `rm ~/{path}`, and create your own file.",
        )
    return Feedback(
        summary=f"`~/{path}` cannot be read.",
        where=(Location(path),),
        advice=f"As its owner, you must be able to read `{name}`: run `chmod u+r ~/{path}`.",
    )


def _missing(recording: Recording, path: str, advice: str | None) -> Feedback:
    wanted = PurePosixPath(path)
    near = recording.home.near(path)
    if near:
        return _moved(recording, wanted, PurePosixPath(near[0]))
    parent = str(wanted.parent)
    if parent != "." and not recording.home.file(parent).exists:
        return _no_folder(recording, wanted, advice)
    there = recording.home.inside("" if parent == "." else parent)
    return Feedback(
        summary=f"There is no file `~/{path}`.",
        seen=f"{_place(wanted.parent)} contains {listed(there[:_SHOWN], 'nothing')}",
        advice=advice or f"Create it with exactly this name: `{wanted.name}`.",
    )


def _moved(recording: Recording, wanted: PurePosixPath, near: PurePosixPath) -> Feedback:
    """Feedback on a file that was probably meant, but has another name or is in another place."""
    there = recording.home.file(str(wanted.parent)).exists
    first = "" if there or str(wanted.parent) == "." else f"`mkdir -p ~/{wanted.parent}`, then "
    step = f"{first}`mv ~/{near} ~/{wanted}` moves it there."
    if near.parent == wanted.parent:
        summary = f"{_place(wanted.parent)} has no `{wanted.name}`; it has `{near.name}`."
        step = f"The name must match exactly. `mv ~/{near} ~/{wanted}` renames it."
    elif near.name == wanted.name:
        summary = f"`{wanted.name}` is in {_place(near.parent)}, not in {_place(wanted.parent)}."
    else:
        summary = f"There is no `~/{wanted}`, but there is `~/{near}`."
    return Feedback(
        summary=summary, expected=f"~/{wanted}", seen=f"~/{near}", where=(Location(str(near)),), advice=step
    )


def _no_folder(recording: Recording, wanted: PurePosixPath, advice: str | None) -> Feedback:
    folder = str(wanted.parent)
    near = recording.home.near_folder(folder)
    if near:
        return Feedback(
            summary=f"There is no folder `~/{folder}`; there is `~/{near}`.",
            expected=f"~/{folder}",
            seen=f"~/{near}",
            where=(Location(near),),
            advice=f"`mv ~/{near} ~/{folder}` renames it.",
        )
    return Feedback(
        summary=f"There is no folder `~/{folder}`, so there is no `{wanted.name}` in it.",
        advice=advice or f"Create the folder first: `mkdir ~/{folder}`.",
    )


def _place(folder: PurePosixPath) -> str:
    return "`~`" if str(folder) == "." else f"`~/{folder}`"


def _difference(path: str, seen: Sequence[str], wanted: Sequence[str], place: int) -> str:
    if not seen:
        return f"`~/{path}` is empty."
    if place >= len(seen):
        return f"`~/{path}` ends after line {len(seen)}; {len(wanted) - len(seen)} more should follow."
    if place >= len(wanted):
        return f"`~/{path}` should end before line {place + 1}; it has {len(seen)} lines."
    return f"Line {place + 1} of `~/{path}` is not what it should be."


def _short(line: str) -> str:
    if not line:
        return "an empty line"
    return line if len(line) <= _CUT else line[: _CUT - 4] + " ..."
