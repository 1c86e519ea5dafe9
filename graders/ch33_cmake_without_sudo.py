"""Grader of chapter 33: a library in the home, the variables that lead there, and a program that links it."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

from course.arena.arena import Arena
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location, NotApplicable
from course.grading.author import Grader
from course.grading.expect.native import expect_sound, native_answer
from course.grading.expect.shell import BASHRC, expect_ran, expect_shell
from course.grading.explain.cmake import not_configured
from course.grading.explain.native import not_made

PROBES = Path(__file__).with_name("probes")
SOURCE = (
    Path(__file__).parents[1]
    / "chapters/33-cmake-without-sudo/starter/33-install-prefix/cmake_tutorial/tinyqp"
)
OPT = "opt"
PROJECT = "cmake_tutorial/tinyqp"
HEADER = f"{OPT}/include/tinyqp/tinyqp.hpp"
LIBRARY = re.compile(r"libtinyqp\.(so[\d.]*|a)")
OTHER_MACHINE = "It was built for another kind of machine, and does not run on this one."
SUBMITTED = "A submission brings nothing that was installed: only your own machine can tell."
INSTALL = f"`cmake --install build`, in `~/{PROJECT}`, after `cmake -B build -DCMAKE_INSTALL_PREFIX=~/opt`."

prefix = Grader("33-install-prefix", builds=None, ros=False)

VARIABLES = {"LD_LIBRARY_PATH": "lib", "LIBRARY_PATH": "lib", "CPATH": "include"}
BEFORE = "/before/this"
# Only what is exported do programs see.
SHOW = "; ".join(f"echo {name}=$(printenv {name})" for name in VARIABLES)
AGAIN = f"""env {" ".join(f"{name}={BEFORE}" for name in VARIABLES)} bash -ic '{SHOW}'"""
# By hand: 1/2 x'Hx + g'x with H = diag(2, 4), g = (-2, 4) alone, then with bounds, then with x1 + x2 >= 3.
# A 1 for solved, x1, x2, and the objective.
SOLUTIONS = {
    "inside": [1.0, 1.0, -1.0, -3.0],
    "corner": [1.0, 2.0, 0.0, 0.0],
    "edge": [1.0, 3.0, 0.0, 3.0],
}


@prefix.scenario
def look_and_link(arena: Arena) -> None:
    arena.require("g++", "cmake", "make")
    library = folder_of_library(arena.home)
    flags = (f"-I{OPT}/include", f"-L{library}", "-ltinyqp")
    program = arena.compile("check", ours=PROBES / "ch33_check.cpp", options=flags, sanitized=False)
    path = {"LD_LIBRARY_PATH": str(arena.home / library)}
    arena.ask_native(program, name="check", env=path, timeout=10)
    with arena.shell() as shell:
        shell.run(SHOW)
        shell.run(AGAIN)


def folder_of_library(home: Path) -> str:
    """Some systems call it lib64."""
    others = (f"{OPT}/lib64",) if any((home / OPT / "lib64").glob("libtinyqp.*")) else ()
    return next(iter(others), f"{OPT}/lib")


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
        summary = f"`{name}` was put into `~/{folder}`, not into `{wanted.rpartition('/')[0]}`."
        advice = f"Remove it, and begin again with an empty `build`: the prefix is `~/opt` itself. {INSTALL}"
    elif recording.home.file(OPT).kind == "folder":
        summary = f"There is no `{name}` in `~/opt`."
        advice = f"CMake installs both: {INSTALL}"
    else:
        summary = "There is no folder `~/opt`: nothing was installed there."
        advice = f"CMake makes it: {INSTALL}"
    return Feedback(
        summary=summary,
        expected=wanted,
        seen=f"~/{place}" if place else "nothing",
        where=(Location(place),) if place else (),
        advice=advice,
    )


@prefix.check("nothing_else", "and nothing was installed anywhere else")
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
            summary="CMake has installed something outside of `~/opt`.",
            expected="every file in ~/opt",
            seen=line[:120],
            where=(Location(manifest, number),),
            advice="Remove these files and `build`; then configure with `-DCMAKE_INSTALL_PREFIX=~/opt`.",
            details=tuple(text for _, _, text in outside[:4]),
        )
    )


@prefix.check("works", "a program can be made with it, and runs", points=3, needs=("header", "library"))
def works(recording: Recording) -> None:
    said = recording.process("compile check").text
    if not recording.local and any(re.search(r"incompatible|wrong format", line) for line in said):
        raise NotApplicable(OTHER_MACHINE)
    ended = recording.process("compile check").exited
    if ended is None or ended.code != 0:
        raise Failure(
            Feedback(
                summary="No program can be made with what lies in `~/opt`.",
                where=(Location(HEADER),),
                advice=f"Remove `~/opt`, and install it again. {INSTALL}",
                details=tuple(line for line in said if "error" in line or "cannot" in line)[:3],
            )
        )
    for question, wanted in SOLUTIONS.items():
        answer = native_answer(recording, question, "tinyqp::solve(...)", "check")
        if answer.error is None and near(answer.value, wanted):
            continue
        raise Failure(
            Feedback(
                summary="The library in `~/opt` gives wrong solutions: it was changed.",
                expected=numbers(wanted[1:]),
                seen=answer.error or numbers(answer.value[1:]),
                advice=f"`ros2course reset 33-install-prefix` brings its source back. Then {INSTALL}",
            )
        )


def near(values: list[float], wanted: list[float]) -> bool:
    return len(values) == len(wanted) and all(abs(a - b) < 1e-4 for a, b in zip(values, wanted, strict=True))


def numbers(values: list[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)


@prefix.check("reads", "a new terminal reads `~/.bashrc` to its end", needs=())
def reads(recording: Recording) -> None:
    expect_shell(recording)


@prefix.check("ld_library_path", "`LD_LIBRARY_PATH` names `~/opt/lib`, for programs", needs="reads")
def ld_library_path(recording: Recording) -> None:
    expect_variable(recording, "LD_LIBRARY_PATH")


@prefix.check("library_path", "`LIBRARY_PATH` names `~/opt/lib`, for the linker", needs="reads")
def library_path(recording: Recording) -> None:
    expect_variable(recording, "LIBRARY_PATH")


@prefix.check("cpath", "`CPATH` names `~/opt/include`, for the compiler", needs="reads")
def cpath(recording: Recording) -> None:
    expect_variable(recording, "CPATH")


def expect_variable(recording: Recording, name: str) -> None:
    """It names the folder, and once."""
    wanted = f"~/{OPT}/{VARIABLES[name]}"
    parts = parts_of(recording, SHOW, name)
    right = [part for part in parts if leads_to(part, VARIABLES[name])]
    if len(right) == 1:
        return
    bashrc = recording.home.file(BASHRC).text or ""
    line = next(iter(lines_with(recording, name)), "").strip()
    where = tuple(Location(BASHRC, number) for number in line_numbers(recording, name))[:3]
    example = f'export {name}="$HOME/{OPT}/{VARIABLES[name]}:${name}"'
    if len(right) > 1:
        summary = f"`{name}` names `{wanted}` {len(right)} times."
        advice = "Keep one of the lines, and take out the others."
    elif any(part.startswith("~") for part in parts):
        summary = f"`{name}` holds the sign `~` itself, which only bash understands."
        advice = f"In quotation marks, `~` stays as it is. Write `$HOME` in its place: `{example}`"
    elif line and re.search(rf"\b{name}\s+=|=\s", line):
        summary = f"There is a space beside the `=`, so bash does not set `{name}`."
        advice = f"Take the spaces away: `{example}`"
    elif line and not re.search(rf"\b(export|declare\s+-\w*x)\b.*\b{name}\b", bashrc):
        summary = f"`{name}` is set, but not handed on to programs: `export` is missing."
        advice = f"Write `{example}`"
    else:
        summary = f"In a new terminal, `{name}` does not name `{wanted}`."
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
    """A folder of that name in an `opt` of somebody's, which is not the system's own."""
    return re.fullmatch(rf"/.+/{OPT}/{folder}(64)?/*", part) is not None


def lines_with(recording: Recording, name: str) -> list[str]:
    every = recording.home.file(BASHRC).lines
    return [every[number - 1] for number in line_numbers(recording, name)]


def line_numbers(recording: Recording, name: str) -> list[int]:
    lines = enumerate(recording.home.file(BASHRC).lines, 1)
    return [n for n, line in lines if re.search(rf"(?<!\w){name}\s*\+?=", line.split("#")[0])]


@prefix.check("keeps", "they keep what was in them", needs=("ld_library_path", "library_path", "cpath"))
def keeps(recording: Recording) -> None:
    for name, folder in VARIABLES.items():
        parts = parts_of(recording, AGAIN, name)
        if BEFORE in parts:
            continue
        raise Failure(
            Feedback(
                summary=f"`{name}` loses what was in it before: other libraries are not found any more.",
                expected=f"{BEFORE} and ~/{OPT}/{folder}",
                seen=":".join(parts)[:120] or "nothing",
                where=tuple(Location(BASHRC, number) for number in line_numbers(recording, name))[:1],
                advice=f'End it with `:${name}`: `export {name}="$HOME/{OPT}/{folder}:${name}"`',
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
# Another library of that name lies where CMake looks by itself: see `ch33_other.cpp`.
OTHER = "other_prefix"
MAKE_OTHER = (
    f'cp -r {OPT} {OTHER} && for file in {OTHER}/lib*/libtinyqp*; do cp -f "$1" "$file" || exit 1; done'
)
USED = "nm -C {program} 2>/dev/null | grep -m 3 -E ' T tinyqp::|qpOASES::'; ldd {program} | grep -i qpoases"


@link.scenario
def build_and_run(arena: Arena) -> None:
    arena.require("g++", "cmake", "make")
    if not (arena.home / OPT).is_dir() or is_of_another_machine(arena.home):
        install_ours(arena)
    shared = (f"-I{OPT}/include", "-shared", "-fPIC", "-Wl,-soname,libtinyqp.so.1")
    other = arena.compile("other", ours=PROBES / "ch33_other.cpp", options=shared, sanitized=False)
    if other:
        arena.tool("sh", "-c", MAKE_OTHER, "sh", str(other), name="make other")
    around = {"CMAKE_PREFIX_PATH": str(arena.home / OTHER)}
    if not arena.tool("cmake", "-S", SOLVE, "-B", BUILD, name="configure", env=around):
        return
    if not arena.tool("cmake", "--build", BUILD, name="build"):
        return
    program = arena.home / BUILD / "solve"
    if not program.is_file():
        return
    preloaded = {"LD_PRELOAD": str(other)} if other else {}
    for name, env in (("solve", {}), ("with other", preloaded)):
        run = arena.run_native(program, name=name, env=env)
        if run:
            run.wait(10)
    arena.tool("sh", "-c", USED.format(program=f"{BUILD}/solve"), name="used")


def is_of_another_machine(home: Path) -> bool:
    """Whether a shared library says in its header that it is for other processors than this Python."""
    own = Path(sys.executable).read_bytes()[18:20]
    libraries = (home / OPT).glob("lib*/libtinyqp.so")
    return any(file.is_file() and file.read_bytes()[:20][18:] not in (own, b"") for file in libraries)


def install_ours(arena: Arena) -> None:
    """A submission need not bring what was installed: it is all the same library."""
    shutil.rmtree(arena.home / OPT, ignore_errors=True)
    shutil.copytree(SOURCE, arena.home / ".tinyqp")
    prefix = f"-DCMAKE_INSTALL_PREFIX={arena.home / OPT}"
    arena.tool("cmake", "-S", ".tinyqp", "-B", ".tinyqp_build", prefix, name="configure tinyqp")
    arena.tool("cmake", "--build", ".tinyqp_build", "--target", "install", name="install tinyqp")


@link.check("configures", "CMake configures the project")
def configures(recording: Recording) -> None:
    if recording.local and not recording.home.file(OPT).exists:
        raise Failure(
            Feedback(
                summary="There is no `~/opt`, so there is no library to link.",
                advice="Do `33-install-prefix` first: it installs the library there.",
            )
        )
    ended = recording.process("configure").exited
    if ended is None or ended.code != 0:
        raise Failure(not_configured(recording, "configure", SOLVE))


@link.check("builds", "and builds the program `solve`", needs="configures")
def builds(recording: Recording) -> None:
    ended = recording.process("build").exited
    if ended is None or ended.code != 0:
        raise Failure(not_built(recording))
    if recording.process("solve").started is None:
        raise Failure(
            Feedback(
                summary="The project makes no program called `solve`.",
                expected="add_executable(solve solve.cpp)",
                where=list_lines(recording, "add_executable") or (Location(LISTS),),
                advice="The first word in `add_executable(...)` is the program's name.",
            )
        )


def not_built(recording: Recording) -> Feedback:
    feedback = not_made(recording, "build")
    text = "\n".join(recording.process("build").text)
    if "tinyqp::" in text and "undefined reference" in text:
        return Feedback(
            summary="The program uses tinyqp, but nobody links it.",
            where=list_lines(recording, "target_link_libraries") or (Location(LISTS),),
            advice="Add `target_link_libraries(solve tinyqp::tinyqp)` behind `add_executable`.",
            details=feedback.details,
        )
    if "tinyqp/tinyqp.hpp: No such file" in text:
        return Feedback(
            summary="The compiler does not find `tinyqp/tinyqp.hpp`.",
            where=feedback.where,
            advice="Link `tinyqp::tinyqp`: it brings the folder along. With `find_library`, name that folder "
            "in `target_include_directories`. (In your own terminal `CPATH` leads there; others have none.)",
            details=feedback.details,
        )
    return feedback


def list_lines(recording: Recording, word: str) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(LISTS).lines, 1)
    return tuple(Location(LISTS, number) for number, line in lines if word in line.split("#")[0])[:1]


@link.check("first", "it prints the solution of the first problem", points=2, needs="builds")
def first(recording: Recording) -> None:
    expect_solution(recording, FIRST, "first")


@link.check("second", "and that of the second", points=2, needs="builds")
def second(recording: Recording) -> None:
    expect_solution(recording, SECOND, "second")


def printed(recording: Recording, run: str) -> list[tuple[float, ...]]:
    """The last three numbers of each line that has as many."""
    lines = (NUMBER.findall(line) for line in recording.process(run).text)
    return [tuple(float(number) for number in found[-3:]) for found in lines if len(found) >= 3]


def is_solution(seen: tuple[float, ...], wanted: tuple[float, ...]) -> bool:
    return all(abs(a - b) < 1e-3 for a, b in zip(seen, wanted, strict=True))


def expect_solution(recording: Recording, wanted: tuple[float, float, float], which: str) -> None:
    view = expect_sound(recording, "solve")
    lines = printed(recording, "solve")
    at = {"first": 0, "second": 1}[which]
    if len(lines) > at and (is_solution(lines[at], wanted) or any(map(is_other, lines))):
        return  # whose numbers they are, the last checks tell
    seen = lines[at] if len(lines) > at else None
    raise Failure(
        Feedback(
            summary=f"The line for the {which} problem is not right: {numbers(list(seen))}."
            if seen
            else f"There is no line with three numbers for the {which} problem.",
            expected=f"{numbers(list(wanted))}: x1, x2 and the objective",
            seen=numbers(list(seen)) if seen else view.text[-1][:120] if view.text else "nothing",
            where=(Location(PROGRAM),),
            advice=turned(seen, wanted)
            or "Compare `h`, `g` and all bounds with the task. `h` holds h11, h12 and h22.",
        )
    )


def turned(seen: tuple[float, ...] | None, wanted: tuple[float, float, float]) -> str | None:
    if seen and sorted(seen) == sorted(wanted):
        return "The numbers are right, their order is not: x1, x2, and then the objective."
    other = SECOND if wanted == FIRST else FIRST
    if seen and is_solution(seen, other):
        return "These are the numbers of the other problem: the first one comes first."
    return None


def is_other(line: tuple[float, ...]) -> bool:
    return line[2] == 99.0


@link.check("local", "it takes the library of `~/opt`, also where there is another", points=2, needs="first")
def local(recording: Recording) -> None:
    if not any(map(is_other, printed(recording, "solve"))):
        return
    raise Failure(
        Feedback(
            summary="Where another tinyqp is installed, the program takes that one.",
            expected="the library in ~/opt",
            seen=f"the one in ~/{OTHER}, where `CMAKE_PREFIX_PATH` leads",
            where=list_lines(recording, "find_") or (Location(LISTS),),
            advice="Name the folder, and forbid all others: "
            "`find_package(tinyqp REQUIRED PATHS $ENV{HOME}/opt NO_DEFAULT_PATH)`.",
        )
    )


@link.check("computed", "the library has computed what it prints", needs=("first", "second", "local"))
def computed(recording: Recording) -> None:
    if any(map(is_other, printed(recording, "with other"))):
        return
    used = recording.process("used").text
    by_another = any("qpoases" in line.lower() for line in used)
    part_of_it = any(" T tinyqp::" in line for line in used)
    if by_another or part_of_it:
        return
    raise Failure(
        Feedback(
            summary="The program prints the right numbers, but no library has computed them.",
            expected="what `tinyqp::solve` gives",
            seen="numbers that stand in the program",
            where=(Location(PROGRAM),),
            advice="Hand both problems to `tinyqp::solve`, and print `x` and `objective` of what it gives.",
        )
    )
