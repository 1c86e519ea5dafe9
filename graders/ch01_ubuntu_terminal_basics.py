"""Graders of chapter 1: files, redirection, grep, an alias, and the permission to execute."""

from __future__ import annotations

import re
import stat
from pathlib import Path

from course.api import (
    BASHRC,
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Recording,
    complaints,
    expect_file,
    expect_lines,
    expect_mode,
    expect_ran,
    expect_shell,
    expect_text,
    listed,
    nearest,
)

CHAPTER = Path(__file__).parents[1] / "chapters" / "01-ubuntu-terminal-basics"
EMPTY = "a_folder/an_empty_file.txt"
STUFF = "a_folder/file_with_stuff.txt"
LISTING = "result_of_ls.txt"
IN_EVERY_HOME = (
    "cmake_tutorial",
    LISTING,
    "ros2_tutorial_workspace",
    "ros2_tutorials_preamble",
    "sas_tutorial_workspace",
)
SHOP = "a_file.whatever"
FOUND = "robocop.txt"
HOWDY = "howdy.sh"
GREETING = "Howdy! You have made me a program."

files = Grader("01-files", builds=None)


@files.check("empty_file", "`~/a_folder/an_empty_file.txt` exists and is empty")
def empty_file(recording: Recording) -> None:
    make = "Run `mkdir ~/a_folder` if there is no such folder yet, then `touch ~/a_folder/an_empty_file.txt`."
    found = expect_file(recording, EMPTY, advice=make)
    if found.size:
        raise Failure(
            Feedback(
                summary="`an_empty_file.txt` is not empty.",
                expected="0 bytes",
                seen=f"`{found.lines[0][:60]}`" if found.lines else f"{found.size} bytes",
                where=(Location(EMPTY),),
                advice="Remove it with `rm`, and create it again with `touch`.",
            )
        )


@files.check("stuff", "`~/a_folder/file_with_stuff.txt` contains the line `stuff`")
def stuff(recording: Recording) -> None:
    write = "Write it with `echo stuff > ~/a_folder/file_with_stuff.txt`."
    found = expect_text(
        recording, STUFF, advice=f"{write} If the folder does not exist yet, run `mkdir ~/a_folder` first."
    )
    if "stuff" in (line.rstrip() for line in found.lines):
        return
    written = next((line for line in found.lines if line.strip()), None)
    raise Failure(
        Feedback(
            summary="`file_with_stuff.txt` does not contain the line `stuff`."
            if written
            else "`file_with_stuff.txt` is empty.",
            expected="stuff",
            seen=written[:120] if written else "nothing",
            where=(Location(STUFF, 1 if written else None),),
            advice=f"Write only the word, in lowercase and without quotation marks. {write}",
        )
    )


redirect = Grader("01-redirect", builds=None)


@redirect.check("listing", "`~/result_of_ls.txt` contains the listing of `~`")
def listing(recording: Recording) -> None:
    found = expect_text(recording, LISTING, advice="`cd ~`, then `ls > result_of_ls.txt`.")
    # `ls -l` prints the name last; -p and -F put a sign after it.
    named = {line.split()[-1].rstrip("/*@") for line in found.lines if line.split()}
    columns = {word for line in found.lines for word in line.split()}
    missing = [name for name in IN_EVERY_HOME if name not in named | columns]
    if not missing:
        return
    if named == {"done"}:
        raise Failure(overwritten(found.lines))
    raise Failure(
        Feedback(
            summary=f"This is not the listing of `~`: it lacks {listed(missing)}.",
            expected="every name that `ls ~` prints",
            seen=found.lines[0][:120] if found.lines else "an empty file",
            where=(Location(LISTING),),
            advice="Go home first (`cd ~`), then `ls > result_of_ls.txt`.",
        )
    )


def overwritten(lines: tuple[str, ...]) -> Feedback:
    return Feedback(
        summary="Only `done` is left in the file: the second `>` erased the listing.",
        expected="the listing, and `done` after it",
        seen=listed(lines[:3]),
        where=(Location(LISTING, 1),),
        advice=(
            "Write the listing again with `>`, then add to it with `>>`: `echo done >> result_of_ls.txt`."
        ),
    )


@redirect.check("appended", "its last line is `done`")
def appended(recording: Recording) -> None:
    found = expect_text(recording, LISTING, advice="`cd ~`, then `ls > result_of_ls.txt`.")
    lines = [line.strip() for line in found.lines if line.strip()]
    if lines and lines[-1] == "done":
        return
    elsewhere = next((n for n, line in enumerate(found.lines, 1) if line.strip() == "done"), None)
    close = nearest("done", lines[-1:])
    glued = bool(lines) and lines[-1].endswith("done")
    raise Failure(
        Feedback(
            summary=f"`done` is on line {elsewhere}, not at the end."
            if elsewhere
            else f"The last line of the file is `{lines[-1][:60]}`, not `done`."
            if lines
            else "The file is empty.",
            expected="done",
            seen=lines[-1][:120] if lines else "nothing",
            where=(Location(LISTING, elsewhere or len(found.lines) or None),),
            advice="The word must be on its own line."
            if glued
            else "Write only `done`, in lowercase, with nothing else on the line."
            if close
            else (
                "`echo done >> result_of_ls.txt` adds it to the end. A single `>` would erase the listing."
            ),
        )
    )


grep = Grader("01-grep", builds=None)


def in_the_shop() -> tuple[str, ...]:
    """The lines of the starter, in which learners search."""
    return tuple((CHAPTER / "starter" / grep.exercise / SHOP).read_text(encoding="utf-8").splitlines())


@grep.check("file", "`~/robocop.txt` exists")
def robocop_file(recording: Recording) -> None:
    expect_text(recording, FOUND, advice="`cd ~`, then `grep robocop a_file.whatever > robocop.txt`.")


@grep.check("lines", "it contains exactly the lines that `grep robocop` prints", points=2, needs="file")
def robocop_lines(recording: Recording) -> None:
    shop = in_the_shop()
    wanted = [line for line in shop if "robocop" in line]
    seen = list(expect_text(recording, FOUND).lines)
    if seen == wanted:
        return
    cause = why_not(seen, wanted, shop, recording.home.file(SHOP).lines)
    if cause:
        summary, advice = cause
        number = next((n for n, line in enumerate(seen, 1) if [line] != wanted[n - 1 : n]), None)
        raise Failure(
            Feedback(
                summary=summary,
                expected=f"{len(wanted)} lines, just as they are in `a_file.whatever`",
                seen=f"{len(seen)} lines" if len(seen) != len(wanted) else seen[0][:120],
                where=(Location(FOUND, number),),
                advice=advice,
            )
        )
    expect_lines(recording, FOUND, wanted, advice="`grep robocop a_file.whatever > robocop.txt` writes them.")


def why_not(
    seen: list[str], wanted: list[str], shop: tuple[str, ...], now: tuple[str, ...]
) -> tuple[str, str] | None:
    """What the learner did instead, and what to do."""
    plain = "`grep robocop a_file.whatever > robocop.txt` does it."
    if not seen and now != shop:
        return (
            "`robocop.txt` is empty, and `a_file.whatever` has changed since you got it.",
            "`ros2course reset 01-grep` restores `a_file.whatever`. Write only `robocop.txt` after `>`.",
        )
    if not seen:
        return "`robocop.txt` is empty: nothing was found.", f"Did you spell `robocop` correctly? {plain}"
    if seen == [line for line in shop if "robocop" in line.lower()]:
        return (
            "The lines with `Robocop` and `ROBOCOP` are in it too: grep ignored case.",
            f"Leave the option `-i` out. {plain}",
        )
    if all(re.match(r"\d+:", line) for line in seen):
        return "Each line begins with its line number.", f"Leave the option `-n` out. {plain}"
    if all(line.startswith(f"{SHOP}:") for line in seen):
        return "Each line begins with the name of the file.", f"Leave the option `-H` out. {plain}"
    if seen == list(shop):
        return "`robocop.txt` contains all of `a_file.whatever`.", plain
    if seen == [line for line in wanted if re.search(r"\brobocop\b", line)]:
        return "The line with `robocops` is missing: it contains `robocop`, too.", f"Leave `-w` out. {plain}"
    if seen == [line for line in shop if "robocop" not in line]:
        return "These are the lines without `robocop`.", f"Leave the option `-v` out. {plain}"
    if len(seen) > len(wanted) and seen == wanted * (len(seen) // len(wanted)):
        return "The lines are in it more than once: `>>` added them to what was there.", plain
    if seen == [str(len(wanted))]:
        return "`robocop.txt` contains the number of lines, not the lines.", f"Leave `-c` out. {plain}"
    if "\x1b" in seen[0]:
        return "The lines contain codes that color them on a terminal.", f"Leave `--color` out. {plain}"
    return None


alias = Grader("01-alias", builds=None, ros=False)


@alias.scenario
def type_it_into_a_new_terminal(arena: Arena) -> None:
    with arena.shell() as shell:
        shell.run("alias")
        shell.run("alias say_hello")
        shell.run("say_hello")


@alias.check("reads", "a new terminal reads `~/.bashrc` to the end")
def reads(recording: Recording) -> None:
    expect_shell(recording)


@alias.check("defined", "it knows the alias `say_hello`", needs="reads")
def defined(recording: Recording) -> None:
    ran = expect_ran(recording, "alias say_hello")
    if ran.code != 0:
        raise Failure(unknown_alias(recording))


def unknown_alias(recording: Recording) -> Feedback:
    spaced = spaces(recording)
    if spaced:
        return spaced
    other = in_another_file(recording)
    if other:
        return other
    known = re.findall(r"^alias ([^=]+)=", "\n".join(expect_ran(recording, "alias").printed), re.MULTILINE)
    close = nearest("say_hello", known)
    lines = list(enumerate(recording.home.file(BASHRC).lines, 1))
    here = [Location(BASHRC, n) for n, line in lines if (close or "say_hello") in line]
    commented = any(line.lstrip().startswith("#") and "alias say_hello" in line for _, line in lines)
    function = any(re.match(r"\s*(function\s+)?say_hello\s*\(\)", line) for _, line in lines)
    if close:
        summary = f"The alias `say_hello` does not exist, but `{close}` does."
        advice = "Correct its name in `~/.bashrc`."
    elif function:
        summary = "`say_hello` is a function, not an alias."
        advice = "It works too, but the task asks for an alias: `alias say_hello='echo hello'`."
    elif commented:
        summary = "The line with `say_hello` begins with `#`, so bash skips it."
        advice = "Remove the `#`."
    else:
        summary = "A new terminal does not know the alias `say_hello`."
        advice = "Add a line to `~/.bashrc`: `alias`, the name, `=`, and the command in quotation marks."
    return Feedback(
        summary=summary,
        expected="alias say_hello='echo hello'",
        where=tuple(here[:2]) or (Location(BASHRC),),
        advice=advice,
        details=tuple(text for _, text in complaints(recording))[:4],
    )


def spaces(recording: Recording) -> Feedback | None:
    for number, line in enumerate(recording.home.file(BASHRC).lines, 1):
        if re.match(r"\s*alias\s+say_hello(\s+=|\s*=\s)", line):
            return Feedback(
                summary="There is a space next to the `=`, so bash does not define the alias.",
                expected="alias say_hello='echo hello'",
                seen=line.strip(),
                where=(Location(BASHRC, number),),
                advice="Remove the spaces around the `=`.",
            )
    return None


def in_another_file(recording: Recording) -> Feedback | None:
    for name in recording.home.inside():
        place = recording.home.file(name)
        for number, line in enumerate(place.lines, 1):
            if name != BASHRC and re.match(r"\s*alias\s+say_hello\s*=", line):
                return Feedback(
                    summary=f"The alias is in `~/{name}`, which a new terminal does not read.",
                    expected=f"~/{BASHRC}",
                    seen=f"~/{name}",
                    where=(Location(name, number),),
                    advice="Move the line to `~/.bashrc`, with the dot: bash reads that file each time you "
                    "open a terminal.",
                )
    return None


@alias.check("prints", "`say_hello` prints `hello`", needs="defined")
def prints(recording: Recording) -> None:
    ran = expect_ran(recording, "say_hello")
    spaced = spaces(recording) if not any(line.strip() for line in ran.printed) else None
    if spaced:
        raise Failure(spaced)
    printed = [line.strip() for line in ran.printed if line.strip()]
    if "hello" in printed and ran.code == 0:
        return
    meant = expect_ran(recording, "alias say_hello").printed
    where = [n for n, line in enumerate(recording.home.file(BASHRC).lines, 1) if "alias say_hello" in line]
    curly = [
        n for n in where if re.search("[\u2018\u2019\u201c\u201d]", recording.home.file(BASHRC).lines[n - 1])
    ]
    if curly:
        raise Failure(
            Feedback(
                summary="The quotation marks around the command are curly, as word processors write them.",
                where=(Location(BASHRC, curly[-1]),),
                advice="bash knows only straight ones: type `'` at both ends.",
            )
        )
    lost = any("command not found" in line for line in printed)
    raise Failure(
        Feedback(
            summary="The alias runs something that is not a command."
            if lost
            else "`say_hello` prints nothing."
            if not printed
            else f"`say_hello` prints `{printed[0][:60]}`, not `hello`.",
            expected="hello",
            seen=printed[0][:120] if printed else "nothing",
            where=tuple(Location(BASHRC, n) for n in where[-1:]),
            advice="`echo` prints its arguments: put `echo hello` in the quotation marks."
            if lost or not printed
            else "Print only the word, in lowercase: `echo hello`.",
            details=meant[-1:],
        )
    )


executable = Grader("01-executable", builds=None, ros=False)


@executable.scenario
def start_it(arena: Arena) -> None:
    with arena.shell() as shell:
        shell.run(f"./{HOWDY}")


@executable.check("executable", "you may execute `~/howdy.sh`")
def may_be_executed(recording: Recording) -> None:
    expect_file(recording, HOWDY, advice="`ros2course reset 01-executable` restores it.")
    mode = recording.home.file(HOWDY).mode
    others = mode & (stat.S_IXGRP | stat.S_IXOTH)
    expect_mode(
        recording,
        HOWDY,
        has=stat.S_IXUSR,
        summary="Others may execute `howdy.sh`, but its owner may not."
        if others
        else "`howdy.sh` is not executable: its owner has no `x`.",
        advice="`chmod u+x ~/howdy.sh` lets the owner execute it; `u` stands for *user*, the owner.",
    )


@executable.check("runs", "`./howdy.sh` runs", needs="executable")
def runs(recording: Recording) -> None:
    ran = expect_ran(recording, f"./{HOWDY}")
    if ran.code == 0 and GREETING in (line.strip() for line in ran.printed):
        return
    broken = any("bad interpreter" in line or "cannot execute" in line for line in ran.printed)
    raise Failure(
        Feedback(
            summary="`./howdy.sh` does not start: its first line was changed."
            if broken
            else "`./howdy.sh` no longer prints its greeting: its text was changed.",
            expected=GREETING,
            seen=ran.printed[-1][:120] if ran.printed else "nothing",
            where=(Location(HOWDY, 1 if broken else None),),
            advice=(
                "`ros2course reset 01-executable` restores the file. Then use only `chmod`, not an editor."
            ),
        )
    )


@executable.check("not_for_all", "only you and your group may write to it", bonus=True, needs=())
def not_for_all(recording: Recording) -> None:
    expect_mode(
        recording,
        HOWDY,
        lacks=stat.S_IWOTH,
        summary="Anyone may write to `howdy.sh`, so anyone can change what it does in your name.",
        advice="`chmod 755 ~/howdy.sh` fixes that: 7 for you, 5 (read and execute) for everyone else.",
    )
