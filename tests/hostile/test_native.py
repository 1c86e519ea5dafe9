"""C++ in a submission: what the compiler is told to read, and programs with sanitizers."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from tests.hostile.world import Grade

pytestmark = pytest.mark.slow

FOLDER = "ros2_tutorials_preamble/cpp/bounds"
MAIN = f"{FOLDER}/main.cpp"
HOG = """\
#include <cstdlib>
#include <cstring>
int main() {
  for (;;) {
    std::memset(std::malloc(16 << 20), 1, 16 << 20);
  }
}
"""
FORGER = """\
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>
namespace {
struct First {
  First() {
    const char* answers = std::getenv("ROS2COURSE_ANSWERS");
    if (answers != nullptr) {
      const std::string text = "{\\"question\\": \\"ranges\\"}\\n\\"done\\"\\n";
      (void)!write(std::atoi(answers), text.c_str(), text.size());
    }
    if (std::remove("/work") == 0 || std::fopen("/etc/shadow", "r") != nullptr) {
      std::puts("BREACH files");
    }
    std::puts("HELD files: nothing to be had");
  }
} first;
}
int main() {}
"""


def test_memory_is_bounded_also_with_all_addresses(grade: Grade) -> None:
    """The address sanitizer needs more addresses than programs get, but their memory is limited anyway."""
    graded = grade({MAIN: HOG}, exercise="28-bounds", guarantee="sanitized programs have no more memory")
    assert graded.failed, graded.result
    assert "more than 1024 MB of memory" in graded.words(graded.failed[0])


def test_a_compiler_reads_no_solution(grade: Grade, course_copy: Path) -> None:
    own, copy = (f"{root}/solutions/28-demystifying-cpp/{MAIN}" for root in (open_course().root, course_copy))
    text = f'#if __has_include("{own}")\n#warning BREACH\n#endif\n#include "{copy}"\n'
    graded = grade({MAIN: text}, exercise="28-bounds", guarantee="the compiler sees what programs see")
    assert not [line for line in graded.printed if "BREACH" in line]
    assert graded.failed == ("compiles",)
    assert "No such file or directory" in graded.words("compiles")


def test_what_runs_before_main_earns_nothing(grade: Grade) -> None:
    graded = grade({MAIN: FORGER}, exercise="28-bounds", guarantee="a program only reaches its own sandbox")
    assert not graded.breaches and graded.held == {"files"}
    assert {"prints"} <= set(graded.failed), graded.result
