"""How the learner's C++ is compiled, and what a compiled program needs to run."""

from __future__ import annotations

import contextlib
import platform
import re
import shutil
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from course.errors import MissingHere

COMPILE_TIME = 90.0
RUN_TIME = 20.0
CPP = Path(__file__).with_name("cpp")
HEAP = CPP / "heap.cpp"
ASK = CPP / "ask.hpp"
# Names the descriptor for a program's answers: see `cpp/ask.hpp`.
ANSWERS = "ROS2COURSE_ANSWERS"

_EIGEN = Path("/usr/include/eigen3")
_WARNINGS = ("-Wall", "-Wextra", "-Wpedantic")
_SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer")
_NO_SANITIZERS = re.compile(r"cannot find (?:-l|\S*lib)(?:asan|ubsan)\b|lib(?:asan|ubsan)_preinit\.o")
_RANDOM_BITS = Path("/proc/sys/vm/mmap_rnd_bits")
# The most that the address sanitizers of all compilers in use can handle.
_MOST_RANDOM_BITS = 28


def compile_command(
    sources: Sequence[str], output: Path, *, options: Sequence[str] = (), sanitized: bool = True
) -> tuple[str, ...]:
    """Standard C++17 with all the usual warnings, and line information for error reports."""
    checked = _SANITIZERS if sanitized else ()
    return ("g++", "-std=c++17", "-g", "-O0", *_WARNINGS, *checked, *sources, *options, "-o", str(output))


def ros_options(prefixes: Iterable[Path], libraries: Iterable[str]) -> tuple[str, ...]:
    """Options for files that include headers of ROS (in these install prefixes) or Eigen, and link ROS.

    Each package's headers are in a subfolder of `include`. Eigen's are where Debian puts them.
    """
    kept = [prefix for prefix in prefixes if prefix.is_dir()]
    folders = [
        folder for prefix in kept for folder in (*sorted(prefix.glob("include/*")), prefix / "include")
    ]
    headers = [f"-isystem{folder}" for folder in (*folders, _EIGEN)]
    places = [option for prefix in kept for option in (f"-L{prefix}/lib", f"-Wl,-rpath,{prefix}/lib")]
    linked = (f"-l{library}" for library in libraries)
    return (*headers, *places, "-Wl,--as-needed,--allow-shlib-undefined", *linked)


def may_lack_sanitizers(lines: Iterable[str]) -> bool:
    """Whether a compiler reported this. The code being compiled can fake the report, so verify it."""
    return any(_NO_SANITIZERS.search(line) for line in lines)


def no_sanitizers() -> MissingHere:
    return MissingHere(
        "The C++ compiler of this machine has no sanitizers, which this exercise needs.",
        "On Ubuntu, they come with the compiler: `sudo apt install g++`. On Fedora: "
        "`sudo dnf install libasan libubsan`.",
    )


def compiling(environment: Mapping[str, str]) -> dict[str, str]:
    """The environment for messages in English, in plain ASCII and without colors or the user's settings."""
    kept = {name: value for name, value in environment.items() if not name.startswith(("LC_", "LANG"))}
    return {**kept, "LC_ALL": "C", "GCC_COLORS": ""}


def running(environment: Mapping[str, str]) -> dict[str, str]:
    """The environment for sanitizer reports with lines. Leaks are left to `cpp/heap.cpp`."""
    return {
        **environment,
        "ASAN_OPTIONS": "detect_leaks=0:quarantine_size_mb=16:allocator_may_return_null=0:color=never",
        "UBSAN_OPTIONS": "print_stacktrace=1:color=never",
    }


def steady(command: Sequence[str], bits: Path = _RANDOM_BITS) -> tuple[str, ...]:
    """The command, without address randomization if the kernel draws from too many addresses.

    There, the address sanitizer of compilers before 2024 sometimes dies at startup.
    """
    with contextlib.suppress(OSError, ValueError):
        if int(bits.read_text(encoding="ascii")) > _MOST_RANDOM_BITS and shutil.which("setarch"):
            fixed = f"setarch {platform.machine()} -R"
            return ("sh", "-c", f'{fixed} true 2>/dev/null && exec {fixed} "$@"; exec "$@"', "sh", *command)
    return tuple(command)
