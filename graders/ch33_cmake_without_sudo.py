"""Graders of chapter 33: a library in the home, its variables, and a program that links it."""

from __future__ import annotations

import re
import secrets
import sys
from collections.abc import Iterable
from pathlib import Path

from course.api import (
    BASHRC,
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    NotApplicable,
    OurFault,
    Recording,
    expect_ran,
    expect_shell,
    expect_sound,
    native_answer,
    not_configured,
    not_made,
)

PROBES = Path(__file__).with_name("probes")
SOURCE = (
    Path(__file__).parents[1]
    / "chapters/33-cmake-without-sudo/starter/33-install-prefix/cmake_tutorial/tinyqp"
)
OPT = "opt"
PROJECT = "cmake_tutorial/tinyqp"
HEADER = f"{OPT}/include/tinyqp/tinyqp.hpp"
LIBRARY = re.compile(r"libtinyqp\.(so[\d.]*|a)")
OTHER_MACHINE = "It was built for a different kind of computer and does not run on this one."
SUBMITTED = "A submission does not include installed files, so only your own computer can check this."
INSTALL = (
    f"In `~/{PROJECT}`, run `cmake -B build -DCMAKE_INSTALL_PREFIX=~/opt`, `cmake --build build`, and "
    "`cmake --install build`."
)

prefix = Grader("33-install-prefix", builds=None, ros=False)

VARIABLES = {"LD_LIBRARY_PATH": "lib", "LIBRARY_PATH": "lib", "CPATH": "include"}
BEFORE = "/before/this"
# Programs see only exported variables.
SHOW = "; ".join(f"echo {name}=$(printenv {name})" for name in VARIABLES)
AGAIN = f"""env {" ".join(f"{name}={BEFORE}" for name in VARIABLES)} bash -ic '{SHOW}'"""
# Solved by hand: 1/2 x'Hx + g'x with H = diag(2, 4) and g = (-2, 4); with bounds; also with x1 + x2 >= 3.
# Each consists of a 1 for solved, x1, x2, and the objective.
SOLUTIONS = {
    "inside": [1.0, 1.0, -1.0, -3.0],
    "corner": [1.0, 2.0, 0.0, 0.0],
    "edge": [1.0, 3.0, 0.0, 3.0],
}


@prefix.scenario
def look_and_link(arena: Arena) -> None:
    arena.require("g++", "cmake", "make")
    library = folder_of_library(arena)
    flags = (f"-I{OPT}/include", f"-L{library}", "-ltinyqp")
    program = arena.cpp.compile("check", ours=PROBES / "ch33_check.cpp", options=flags, sanitized=False)
    path = {"LD_LIBRARY_PATH": str(arena.home / library)}
    arena.cpp.ask(program, name="check", env=path, timeout=10)
    with arena.shell() as shell:
        shell.run(SHOW)
        shell.run(AGAIN)


def folder_of_library(arena: Arena) -> str:
    """The folder is called lib64 on some systems."""
    return f"{OPT}/lib64" if arena.files.matching(f"{OPT}/lib64/libtinyqp.*") else f"{OPT}/lib"


def expect_brought(recording: Recording) -> None:
    if not recording.local and not recording.home.file(OPT).exists:
        raise NotApplicable(SUBMITTED)


@prefix.check("header", "the header is in `~/opt/include`")
def header(recording: Recording) -> None:
    expect_brought(recording)
    if recording.home.file(HEADER).is_file:
        return
    raise Failure(not_installed(recording, "tinyqp.hpp", f"~/{HEADER}"))


@prefix.check("library", "the library is in `~/opt/lib`")
def library(recording: Recording) -> None:
    expect_brought(recording)
    if libraries(recording):
        return
    raise Failure(not_installed(recording, "libtinyqp.so", "~/opt/lib/libtinyqp.so"))


def libraries(recording: Recording) -> list[str]:
    return [
        path
        for path in recording.home.entries
        if re.fullmatch(rf"{OPT}/lib(64)?/{LIBRARY.pattern}", path) and recording.home.file(path).is_file
    ]


def not_installed(recording: Recording, name: str, wanted: str) -> Feedback:
    stem = name.partition(".")[0]
    known = [path for path in recording.home.entries if f"/{stem}." in f"/{path}"]
    others = [path for path in known if not path.startswith(f"{PROJECT}/") or "/build/" in path]
    place = others[0] if others else None
    if place:
        folder = place.rpartition("/")[0] or "~"
        summary = f"`{name}` is installed in `~/{folder}`, not in `{wanted.rpartition('/')[0]}`."
        advice = f"Remove it and `build`, and start again: the prefix is `~/opt` itself. {INSTALL}"
    elif recording.home.file(OPT).kind == "folder":
        summary = f"There is no `{name}` in `~/opt`."
        advice = f"Let CMake install both files. {INSTALL}"
    else:
        summary = "There is no folder `~/opt`, so nothing is installed there."
        advice = f"Let CMake create it. {INSTALL}"
    return Feedback(
        summary=summary,
        expected=wanted,
        seen=f"~/{place}" if place else "nothing",
        where=(Location(place),) if place else (),
        advice=advice,
    )


@prefix.check("nothing_else", "nothing is installed anywhere else")
def nothing_else(recording: Recording) -> None:
    expect_brought(recording)
    outside = [
        (manifest, number, line)
        for manifest in recording.home.entries
        if manifest.endswith("install_manifest.txt")
        for number, line in enumerate(recording.home.file(manifest).lines, 1)
        if line.strip() and not re.match(r"/.+/opt/(include|lib|lib64|share|bin)/", line)
    ]
    if not outside:
        return
    manifest, number, line = outside[0]
    raise Failure(
        Feedback(
            summary="CMake installed something outside `~/opt`.",
            expected="every file in ~/opt",
            seen=line[:120],
            where=(Location(manifest, number),),
            advice="Remove these files and `build`, then configure with `-DCMAKE_INSTALL_PREFIX=~/opt`.",
            details=tuple(text for _, _, text in outside[:4]),
        )
    )


@prefix.check("works", "a program that uses it builds and runs", points=3, needs=("header", "library"))
def works(recording: Recording) -> None:
    said = recording.process("compile check").text
    if not recording.local and any(re.search(r"incompatible|wrong format", line) for line in said):
        raise NotApplicable(OTHER_MACHINE)
    ended = recording.process("compile check").exited
    if ended is None or ended.code != 0:
        raise Failure(
            Feedback(
                summary="A program that uses the files in `~/opt` does not build.",
                where=(Location(HEADER),),
                advice=f"Remove `~/opt`, and install the library again. {INSTALL}",
                details=tuple(line for line in said if "error" in line or "cannot" in line)[:3],
            )
        )
    for question, wanted in SOLUTIONS.items():
        answer = native_answer(recording, question, "tinyqp::solve(...)", "check", shape=list[float])
        if answer.error is None and near(answer.value, wanted):
            continue
        raise Failure(
            Feedback(
                summary="The library in `~/opt` returns wrong solutions, so somebody has changed it.",
                expected=numbers(wanted[1:]),
                seen=answer.error or numbers(answer.value[1:]),
                advice=f"Restore its source code with `ros2course reset 33-install-prefix`. {INSTALL}",
            )
        )


def near(values: list[float], wanted: list[float]) -> bool:
    return len(values) == len(wanted) and all(abs(a - b) < 1e-4 for a, b in zip(values, wanted, strict=True))


def numbers(values: list[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)


@prefix.check("reads", "a new terminal reads all of `~/.bashrc`", needs=())
def reads(recording: Recording) -> None:
    expect_shell(recording)


@prefix.check("ld_library_path", "`LD_LIBRARY_PATH` contains `~/opt/lib`, for programs", needs="reads")
def ld_library_path(recording: Recording) -> None:
    expect_variable(recording, "LD_LIBRARY_PATH")


@prefix.check("library_path", "`LIBRARY_PATH` contains `~/opt/lib`, for the linker", needs="reads")
def library_path(recording: Recording) -> None:
    expect_variable(recording, "LIBRARY_PATH")


@prefix.check("cpath", "`CPATH` contains `~/opt/include`, for the compiler", needs="reads")
def cpath(recording: Recording) -> None:
    expect_variable(recording, "CPATH")


def setting(name: str) -> str:
    """The line for `.bashrc`. It leaves no colon at the end: that would mean the current folder."""
    return f'export {name}="$HOME/{OPT}/{VARIABLES[name]}${{{name}:+:${name}}}"'


def expect_variable(recording: Recording, name: str) -> None:
    """Expect that the variable contains the folder exactly once."""
    wanted = f"~/{OPT}/{VARIABLES[name]}"
    parts = parts_of(recording, SHOW, name)
    right = [part for part in parts if leads_to(part, VARIABLES[name])]
    if len(right) == 1:
        return
    bashrc = recording.home.file(BASHRC).text or ""
    line = next(iter(lines_with(recording, name)), "").strip()
    where = tuple(Location(BASHRC, number) for number in line_numbers(recording, name))[:3]
    example = setting(name)
    if len(right) > 1:
        summary = f"`{name}` contains `{wanted}` {len(right)} times."
        advice = "Keep one of the lines, and remove the others."
    elif any(part.startswith("~") for part in parts):
        summary = f"`{name}` contains a literal `~`, which only bash understands."
        advice = f"Write `$HOME`, because bash does not replace `~` in quotation marks: `{example}`"
    elif line and re.search(rf"\b{name}\s+=|=\s", line):
        summary = f"There is a space next to the `=`, so bash does not set `{name}`."
        advice = f"Remove the spaces: `{example}`"
    elif line and not re.search(rf"\b(export|declare\s+-\w*x)\b.*\b{name}\b", bashrc):
        summary = f"`{name}` is set, but programs don't see it, because `export` is missing."
        advice = f"Write `{example}`."
    else:
        summary = f"In a new terminal, `{name}` does not contain `{wanted}`."
        advice = f"Add a line to `~/.bashrc`: `{example}`"
    raise Failure(
        Feedback(
            summary=summary,
            expected=wanted,
            seen=":".join(parts)[:120] or "nothing",
            where=where or (Location(BASHRC),),
            advice=advice,
        )
    )


def parts_of(recording: Recording, command: str, name: str) -> list[str]:
    printed = expect_ran(recording, command).printed
    found = next((line for line in printed if line.startswith(f"{name}=")), f"{name}=")
    return [part for part in found.partition("=")[2].split(":") if part]


def leads_to(part: str, folder: str) -> bool:
    """Whether it is this folder in somebody's `opt`, but not in the system's."""
    return re.fullmatch(rf"/.+/{OPT}/{folder}(64)?/*", part) is not None


def lines_with(recording: Recording, name: str) -> list[str]:
    every = recording.home.file(BASHRC).lines
    return [every[number - 1] for number in line_numbers(recording, name)]


def line_numbers(recording: Recording, name: str) -> list[int]:
    lines = enumerate(recording.home.file(BASHRC).lines, 1)
    return [n for n, line in lines if re.search(rf"(?<!\w){name}\s*\+?=", line.split("#")[0])]


@prefix.check("keeps", "they keep their old values", needs=("ld_library_path", "library_path", "cpath"))
def keeps(recording: Recording) -> None:
    for name, folder in VARIABLES.items():
        parts = parts_of(recording, AGAIN, name)
        if BEFORE in parts:
            continue
        raise Failure(
            Feedback(
                summary=f"`{name}` loses its old value, so programs no longer find other libraries.",
                expected=f"{BEFORE} and ~/{OPT}/{folder}",
                seen=":".join(parts)[:120] or "nothing",
                where=tuple(Location(BASHRC, number) for number in line_numbers(recording, name))[:1],
                advice=f"Keep it at the end: `{setting(name)}`",
            )
        )


# ----------------------------------------------------------------------------------------------- 33-link

link = Grader("33-link", builds=None, ros=False)

SOLVE = "cmake_tutorial/solve"
LISTS = f"{SOLVE}/CMakeLists.txt"
PROGRAM = f"{SOLVE}/solve.cpp"
BUILD = "built"
FIRST = (0.5, -1.5, -0.0625)
SECOND = (0.0, -1.0, -1.25)
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
# Two libraries with different answers, see `ch33_other.cpp`. One is where CMake looks by default. The other
# replaces the learner's: a program that prints its answers has used what is in ~/opt.
ELSEWHERE, IN_PLACE = "elsewhere", "in place"
OTHER_PREFIX = "other_prefix"
DRAWN = {"G1": (-200, -120), "G2": (0, 40), "AWAY": (30, 70)}  # ranges for these libraries, in hundredths
RUNS = ("solve", "solve in place", "solve in place, built again")
PRINT = 'g++ "$1" -Wl,--defsym,main=print_answers -o "$1.answers" && "$1.answers"'
REPLACE = """
for file in "$2"/lib*/libtinyqp*; do
    rm -f "$file"
    case $file in
        *.a) ar rcs "$file" "$1" ;;
        *) g++ -shared -Wl,-soname,libtinyqp.so.1 "$1" -o "$file" ;;
    esac || exit 1
done
"""
USED = "nm -C {program} 2>/dev/null | grep -m 3 qpOASES::; ldd {program} | grep -i qpoases"


@link.scenario
def build_and_run(arena: Arena) -> None:
    arena.require("g++", "cmake", "make")
    source = arena.handed(SOURCE)
    if not arena.files.is_folder(OPT) or is_of_another_machine(arena):
        install_ours(arena, source)
    other, ours = other_library(arena, source, ELSEWHERE), other_library(arena, source, IN_PLACE)
    arena.tool("cp", "-r", OPT, OTHER_PREFIX, name="copy")
    if other:
        replace(arena, other, OTHER_PREFIX)
    if not build(arena, BUILD, ""):
        return
    printed = run(arena, BUILD, RUNS[0])
    arena.tool("sh", "-c", USED.format(program=f"{BUILD}/solve"), name="used")
    if ours and replace(arena, ours, OPT) and run(arena, BUILD, RUNS[1]) == printed:
        build(arena, f"{BUILD}_again", " again")  # it may be linked statically
        run(arena, f"{BUILD}_again", RUNS[2])


def other_library(arena: Arena, source: str, name: str) -> Path | None:
    """Compile it without linking. Its answers are in the output of `answers NAME`."""
    drawn = {macro: secrets.choice(range(*bounds)) / 100 for macro, bounds in DRAWN.items()}
    numbers = (f"-D{macro}={value}" for macro, value in drawn.items())
    options = (*numbers, f"-I{source}", f"-I{source}/include", "-c", "-fPIC")
    made = arena.cpp.compile(name, ours=PROBES / "ch33_other.cpp", options=options, sanitized=False)
    if made and arena.tool("sh", "-c", PRINT, "sh", str(made), name=f"answers {name}"):
        return made
    return None


def replace(arena: Arena, library: Path, prefix: str) -> bool:
    return arena.tool("sh", "-c", REPLACE, "sh", str(library), prefix, name=f"replace {prefix}")


def build(arena: Arena, folder: str, which: str) -> bool:
    around = {"CMAKE_PREFIX_PATH": str(arena.home / OTHER_PREFIX)}
    configured = arena.tool("cmake", "-S", SOLVE, "-B", folder, name=f"configure{which}", env=around)
    return configured and arena.tool("cmake", "--build", folder, name=f"build{which}")


def run(arena: Arena, folder: str, name: str) -> tuple[str, ...]:
    """Run the program to its end, and return its output."""
    if not arena.files.is_file(f"{folder}/solve"):
        return ()
    process = arena.cpp.run(arena.home / folder / "solve", name=name)
    return arena.lines(process) if process and process.wait(10) else ()


def is_of_another_machine(arena: Arena) -> bool:
    """Whether a shared library's header says that it is for a different processor than this Python."""
    own = Path(sys.executable).read_bytes()[18:20]
    headers = (arena.files.read(file, 20) or b"" for file in arena.files.matching(f"{OPT}/lib*/libtinyqp.so"))
    return any(header[18:] not in (own, b"") for header in headers)


def install_ours(arena: Arena, source: str) -> None:
    """Install the library, which is always the same, so a submission doesn't have to contain it."""
    arena.tool("rm", "-rf", OPT, name="remove tinyqp")
    prefix = f"-DCMAKE_INSTALL_PREFIX={arena.home / OPT}"
    arena.tool("cmake", "-S", source, "-B", ".tinyqp_build", prefix, name="configure tinyqp")
    arena.tool("cmake", "--build", ".tinyqp_build", "--target", "install", name="install tinyqp")


@link.check("configures", "CMake configures the project")
def configures(recording: Recording) -> None:
    if recording.local and not recording.home.file(OPT).exists:
        raise Failure(
            Feedback(
                summary="There is no `~/opt`, so there is no library to link.",
                advice="Do `33-install-prefix` first, which installs the library there.",
            )
        )
    ended = recording.process("configure").exited
    if ended is None or ended.code != 0:
        raise Failure(not_configured(recording, "configure", SOLVE))


@link.check("builds", "it builds the program `solve`", needs="configures")
def builds(recording: Recording) -> None:
    ended = recording.process("build").exited
    if ended is None or ended.code != 0:
        raise Failure(not_built(recording))
    if recording.process("solve").started is None:
        raise Failure(
            Feedback(
                summary="The project does not build a program called `solve`.",
                expected="add_executable(solve solve.cpp)",
                where=list_lines(recording, "add_executable") or (Location(LISTS),),
                advice="Use the name `solve` as the first word in `add_executable(...)`.",
            )
        )


def not_built(recording: Recording) -> Feedback:
    feedback = not_made(recording, "build")
    text = "\n".join(recording.process("build").text)
    if "tinyqp::" in text and "undefined reference" in text:
        return Feedback(
            summary="The program uses tinyqp, but CMakeLists.txt does not link it.",
            where=list_lines(recording, "target_link_libraries") or (Location(LISTS),),
            advice="Add `target_link_libraries(solve tinyqp::tinyqp)` after `add_executable`.",
            details=feedback.details,
        )
    if "tinyqp/tinyqp.hpp: No such file" in text:
        return Feedback(
            summary="The compiler cannot find `tinyqp/tinyqp.hpp`.",
            where=feedback.where,
            advice=(
                "Link `tinyqp::tinyqp`, which adds the folder. With `find_library`, name the folder in "
                "`target_include_directories`. (In your own terminal, `CPATH` contains it, but not on "
                "other computers.)"
            ),
            details=feedback.details,
        )
    return feedback


def list_lines(recording: Recording, word: str) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(LISTS).lines, 1)
    return tuple(Location(LISTS, number) for number, line in lines if word in line.split("#")[0])[:1]


@link.check("first", "it prints the solution of the first problem", points=2, needs="builds")
def first(recording: Recording) -> None:
    expect_solution(recording, FIRST, "first")


@link.check("second", "it prints the solution of the second problem", points=2, needs="builds")
def second(recording: Recording) -> None:
    expect_solution(recording, SECOND, "second")


def threes(text: Iterable[str]) -> list[tuple[float, ...]]:
    """The last three numbers of each line with at least three."""
    lines = map(NUMBER.findall, text)
    return [tuple(float(number) for number in found[-3:]) for found in lines if len(found) >= 3]


def is_solution(seen: tuple[float, ...], wanted: tuple[float, ...]) -> bool:
    return all(abs(a - b) < 1e-3 for a, b in zip(seen, wanted, strict=True))


def expect_solution(recording: Recording, wanted: tuple[float, float, float], which: str) -> None:
    view = expect_sound(recording, "solve")
    lines, elsewhere = threes(view.text), answers(recording, ELSEWHERE)
    at = {"first": 0, "second": 1}[which]
    if len(lines) > at and any(is_solution(lines[at], known) for known in (wanted, elsewhere[at])):
        return  # the last checks determine where the numbers come from
    seen = lines[at] if len(lines) > at else None
    raise Failure(
        Feedback(
            summary=f"The line for the {which} problem is wrong: {numbers(list(seen))}."
            if seen
            else f"There is no line with three numbers for the {which} problem.",
            expected=f"{numbers(list(wanted))} (x1, x2, and the objective)",
            seen=numbers(list(seen)) if seen else view.text[-1][:120] if view.text else "nothing",
            where=(Location(PROGRAM),),
            advice=turned(seen, wanted)
            or "Compare `h`, `g`, and all bounds with the task. `h` contains h11, h12, and h22.",
        )
    )


def turned(seen: tuple[float, ...] | None, wanted: tuple[float, float, float]) -> str | None:
    if seen and sorted(seen) == sorted(wanted):
        return "Change the order: the numbers are right, but x1 and x2 come first, then the objective."
    other = SECOND if wanted == FIRST else FIRST
    if seen and is_solution(seen, other):
        return "Print the first problem first. These numbers belong to the other problem."
    return None


def answers(recording: Recording, library: str) -> list[tuple[float, ...]]:
    """The answers of another library to both problems, printed before any of the learner's code runs."""
    found = threes(recording.process(f"answers {library}").text)
    if len(found) != 2:
        raise OurFault(f"the library {library} returned no answers")
    return found


def asks(recording: Recording, run: str, library: str) -> bool:
    """Whether this run of the program prints the answers of this library."""
    seen, wanted = threes(recording.process(run).text), answers(recording, library)
    return len(seen) >= 2 and all(map(is_solution, seen, wanted))


@link.check("computed", "a library computed the numbers that it prints", needs=("first", "second"))
def computed(recording: Recording) -> None:
    by_another = any("qpoases" in line.lower() for line in recording.process("used").text)
    if by_another or asks(recording, RUNS[0], ELSEWHERE):
        return
    if any(asks(recording, run, IN_PLACE) for run in RUNS[1:]):
        return
    raise Failure(
        Feedback(
            summary="The program prints the right numbers, but the library did not compute them.",
            expected="the results of `tinyqp::solve`",
            seen="numbers written in the program",
            where=(Location(PROGRAM),),
            advice="Pass both problems to `tinyqp::solve`, and print `x` and `objective` from its result.",
        )
    )


@link.check(
    "local", "it uses the library in `~/opt`, even if there is another one", points=2, needs="computed"
)
def local(recording: Recording) -> None:
    if not asks(recording, RUNS[0], ELSEWHERE):
        return
    raise Failure(
        Feedback(
            summary="If another tinyqp is installed, the program uses that one.",
            expected="the library in ~/opt",
            seen=f"the one in ~/{OTHER_PREFIX}, the folder in `CMAKE_PREFIX_PATH`",
            where=list_lines(recording, "find_") or (Location(LISTS),),
            advice=(
                "Name the folder, and exclude all others: `find_package(tinyqp REQUIRED PATHS "
                "$ENV{HOME}/opt NO_DEFAULT_PATH)`."
            ),
        )
    )
