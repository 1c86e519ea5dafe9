"""C++ files of the course home: compiled, run, and asked."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena import toolchain
from course.arena.cpp_programs import CppPrograms, compiling
from course.errors import MissingHere, OurFault
from course.model.events import ProgramMissing

from .conftest import WAIT
from .programs import PLAIN, Programs

HELLO = "#include <cstdio>\nint main(int, char** words) { std::puts(words[1]); }\n"
DEEP = "project/deep.cpp"


class CppProjects(Programs):
    def __init__(self, folder: Path, path: str = PLAIN["PATH"]) -> None:
        plain = {**PLAIN, "PATH": path, "LC_MESSAGES": "de_DE.UTF-8", "GCC_COLORS": "error=01;31"}
        super().__init__(folder, environment=plain, plain=plain)
        self.cpp = CppPrograms(self)


@pytest.fixture
def programs(tmp_path: Path) -> Iterator[CppProjects]:
    programs = CppProjects(tmp_path)
    yield programs
    programs.close()


def asked(programs: CppProjects, body: str, name: str = "asked") -> None:
    """Ask questions about an existing header, with the body of a `main`."""
    programs.write(
        "ours.cpp", f'#include "ask.hpp"\n#include "project/theirs.hpp"\nint main() {{ {body} }}\n'
    )
    program = programs.cpp.compile(name, ours=programs.home / "ours.cpp", sanitized=False)
    assert program, programs.recording.process(compiling(name)).text
    programs.cpp.ask(program, name=name)


@pytest.mark.slow
def test_files_of_a_pattern_become_a_program(programs: CppProjects) -> None:
    programs.write(
        "project/main.cpp", "void say(const char*);\nint main(int, char** words) { say(words[1]); }\n"
    )
    programs.write("project/say.cpp", "#include <cstdio>\nvoid say(const char* word) { std::puts(word); }\n")
    programs.write("project/left_out.cpp", "this is no C++\n")
    program = programs.cpp.compile("it", "project/*.cpp", without="project/left_out.cpp", sanitized=False)
    run = programs.cpp.run(program, "a b", name="run")
    assert run is not None and run.wait(WAIT)
    assert programs.recording.process("run").text == ("a b",)


@pytest.mark.slow
def test_errors_are_in_english_with_paths_of_the_home(programs: CppProjects) -> None:
    programs.write("project/main.cpp", "int main() { return 0 }\n")
    assert programs.cpp.compile("it", "project/*.cpp") is None
    said = programs.recording.process(compiling("it")).text
    assert "project/main.cpp:1:22: error: expected ';' before '}' token" in said


def test_a_file_that_is_not_there_is_recorded(programs: CppProjects) -> None:
    assert programs.cpp.compile("it", "project/main.cpp") is None
    assert programs.cpp.run(None, name="run") is None
    programs.cpp.ask(None, name="asked")
    assert [(e.process, e.file) for e in programs.timeline.of(ProgramMissing)] == [
        ("compile it", "project/main.cpp")
    ]


def test_a_scenario_stays_in_the_home(programs: CppProjects) -> None:
    with pytest.raises(OurFault, match="leaves the course home"):
        programs.cpp.compile("it", "../*.cpp")


def test_a_missing_compiler_is_not_the_learners(tmp_path: Path) -> None:
    programs = CppProjects(tmp_path, path=str(tmp_path))
    programs.write("main.cpp", HELLO)
    with pytest.raises(MissingHere) as caught:
        programs.cpp.compile("it", "main.cpp")
    assert caught.value.what == "This exercise needs g++, which this machine lacks."
    assert caught.value.next_step == "sudo apt install g++"


LACKING = """#!/bin/sh
case "$*" in
  *fsanitize*) echo "/usr/bin/ld: cannot find libasan_preinit.o: No such file or directory"; exit 1;;
esac
"""


def test_a_compiler_without_sanitizers_is_not_the_learners(tmp_path: Path) -> None:
    compiler = tmp_path / "g++"
    compiler.write_text(LACKING)
    compiler.chmod(0o755)
    programs = CppProjects(tmp_path, path=f"{tmp_path}:/usr/bin:/bin")
    programs.write("main.cpp", HELLO)
    with pytest.raises(MissingHere, match="no sanitizers"):
        programs.cpp.compile("it", "main.cpp")


@pytest.mark.slow
def test_a_file_that_says_so_is_not_believed(programs: CppProjects) -> None:
    programs.write("main.cpp", "#error cannot find -lasan\n")
    assert programs.cpp.compile("it", "main.cpp") is None


@pytest.mark.slow
def test_the_sanitizers_are_heard(programs: CppProjects) -> None:
    programs.write(
        "main.cpp",
        "#include <vector>\nint main(int n, char**) {\n  std::vector<int> v(3);\n  return v[n + 2];\n}\n",
    )
    run = programs.cpp.run(programs.cpp.compile("it", "main.cpp"), name="run")
    assert run is not None and run.wait(WAIT)
    said = "\n".join(programs.recording.process("run").text)
    assert "heap-buffer-overflow" in said and "main.cpp:4" in said


@pytest.mark.slow
def test_questions_and_answers(programs: CppProjects) -> None:
    programs.write(
        "project/theirs.hpp",
        '#include <stdexcept>\n#include <cstdio>\ninline double half(int n) { std::puts("\\"done\\""); '
        'if (n == 0) throw std::out_of_range("no half"); return n / 2.0; }\nstruct Odd {};\n',
    )
    asked(
        programs,
        'ask("half", [] { return half(3); }); ask("throws", [] { return half(0); });'
        'ask("odd", [] { throw Odd(); return 1; }); ask("nothing", [] { half(2); });'
        'ask("words", [] { return std::vector<std::string>{"a\\"b", "c\\n"}; });'
        'ask("nan", [] { return std::nan(""); }); ask("yes", [] { return true; }); done();',
    )
    found = programs.recording.probe("asked")
    values = {answer.question: answer.value for answer in found.answers if answer.error is None}
    nan = values.pop("nan")
    assert found.finished and nan != nan
    assert values == {"half": 1.5, "nothing": None, "words": ['a"b', "c\n"], "yes": True}
    throws, odd = found.answer("throws"), found.answer("odd")
    assert throws is not None and (throws.error, throws.type) == (
        "std::out_of_range: no half",
        "std::out_of_range",
    )
    assert odd is not None and odd.type == "Odd"


@pytest.mark.slow
def test_a_program_that_ends_in_the_middle_is_not_finished(programs: CppProjects) -> None:
    programs.write("project/theirs.hpp", "inline int bad() { std::exit(0); }\n")
    asked(programs, 'ask("first", [] { return 1; }); ask("bad", [] { return bad(); }); done();')
    found = programs.recording.probe("asked")
    assert not found.finished and [answer.question for answer in found.answers] == ["first"]


LEAKS = """\
#include <memory>
#include <string>
#include <vector>
struct Node { std::shared_ptr<Node> other; };
static std::vector<int> forever{1, 2, 3};
int main() {
  std::string fine(100, 'x');
  auto one = std::make_shared<Node>();
  one->other = one;
  new int[4];
}
"""


@pytest.mark.slow
def test_what_is_never_freed_is_told_with_its_line(programs: CppProjects) -> None:
    programs.write(DEEP, LEAKS)
    programs.cpp.ask(programs.cpp.compile("it", DEEP, heap=True), name="run")
    found = programs.recording.probe("run")
    answer = found.answer("never freed")
    assert found.finished and answer is not None
    count, blocks = answer.value
    assert count == 2
    assert sorted(place for _, place in blocks) == [f"{DEEP}:10", f"{DEEP}:8"]
    assert [size for size, place in blocks if place.endswith(":10")] == [16]


@pytest.mark.parametrize(("bits", "steady"), [("28", False), ("32", True), ("", False)])
def test_addresses_that_are_drawn_from_too_many(tmp_path: Path, bits: str, steady: bool) -> None:
    file = tmp_path / "bits"
    if bits:
        file.write_text(bits)
    command = toolchain.steady(("program", "word"), file)
    assert command[-2:] == ("program", "word")
    assert (command[0] == "sh" and "setarch" in command[2]) is steady


def test_options_for_headers_and_libraries_of_ros(tmp_path: Path) -> None:
    folder = tmp_path
    for name in ("one/include/sas_core/sas_core", "one/lib", "two"):
        (folder / name).mkdir(parents=True)
    options = toolchain.ros_options((folder / "one", folder / "two", folder / "gone"), ["sas_core"])
    assert f"-isystem{folder}/one/include/sas_core" in options  # where <sas_core/...> is
    assert options.index(f"-L{folder}/one/lib") < options.index("-lsas_core")
    assert not any("gone" in option for option in options)
