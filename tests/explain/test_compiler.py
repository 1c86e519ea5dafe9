"""The first cause in what g++ and ld print."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.evidence.sources import Sources
from course.explain import cpp_errors
from course.explain.build_errors import explain_build
from course.explain.builds import Build
from course.explain.compiler import CppError, defining_file, first_error, readable_name, warnings
from tests.build.conftest import SRC
from tests.golden import golden


def advice_on(error: CppError) -> str:
    return cpp_errors.advice_on(error, Sources()).text


OWN = ("main.cpp", "src/arm.cpp", "arm.hpp")

TEMPLATES = """\
In file included from /usr/include/c++/12/memory:66,
                 from main.cpp:1:
/usr/include/c++/12/bits/new_allocator.h: In instantiation of 'void construct(_Up*, _Args&& ...)':
/usr/include/c++/12/bits/stl_vector.h:1294:21:   required from 'void push_back(value_type&&) [with _Tp = T]'
arm.hpp:12:3:   required from 'void add(std::vector<T>&) [with T = Arm]'
main.cpp:9:14:   required from here
/usr/include/c++/12/bits/new_allocator.h:175:11: error: use of deleted function 'Arm::Arm(const Arm&)'
  175 |         { ::new((void *)__p) _Up(std::forward<_Args>(__args)...); }
"""
MEMBER = """\
main.cpp: In function 'int main()':
main.cpp:3:8: error: 'shared_ptr' is not a member of 'std'
    3 |   std::shared_ptr<int> p;
main.cpp:3:3: note: 'std::shared_ptr' is defined in header '<memory>'; did you forget to '#include <memory>'?
main.cpp:3:19: error: expected primary-expression before 'int'
"""
INCLUDED = """\
In file included from arm.hpp:3,
                 from main.cpp:1:
/ros/include/sas_core/sas_robot_driver.hpp:8:10: fatal error: Eigen/Dense: No such file or directory
    8 | #include <Eigen/Dense>
"""
CMAKE_LINK = """\
[100%] Linking CXX executable robot
/usr/bin/ld: CMakeFiles/robot.dir/src/arm.cpp.o: in function `move()':
arm.cpp:(.text+0x5): undefined reference to `Arm::bend(double, std::__cxx11::basic_string<char, \
std::char_traits<char>, std::allocator<char> > const&)'
/usr/bin/ld: arm.cpp:(.text+0x9): undefined reference to `Arm::stop()'
collect2: error: ld returned 1 exit status
"""
TWICE = """\
/usr/bin/ld: /tmp/b.o: in function `helper()':
main.cpp:7: multiple definition of `helper()'; /tmp/a.o:/home/a.cpp:7: first defined here
"""


def own(file: str) -> str | None:
    return file if file in OWN else None


def first(log: str) -> CppError:
    found = first_error(log.splitlines(), own)
    assert found is not None
    return found


def test_an_error_in_a_template_is_where_the_learners_file_asked_for_it() -> None:
    found = first(TEMPLATES)
    assert (found.kind, found.file, found.line) == ("compiler", "arm.hpp", 12)
    assert found.text == "use of deleted function 'Arm::Arm(const Arm&)'"
    assert "copies an object" in advice_on(found)


def test_an_error_in_a_header_of_others_is_where_the_learners_file_includes_it() -> None:
    golden(first(INCLUDED))


def test_the_instantiations_of_another_error_do_not_count() -> None:
    other = "/usr/include/c++/12/bits/x.h:1:1: error: something of the system's\n"
    assert first(f"main.cpp:2:2:   required from here\nmain.cpp:5:1: note: x\n{other}").file is None


def test_what_the_learner_wrote_comes_before_what_the_system_says() -> None:
    log = "/usr/include/x.h:1:1: error: first\nmain.cpp:4:2: error: second\n"
    assert (first(log).file, first(log).text) == ("main.cpp", "second")


def test_a_header_that_is_missing_is_named() -> None:
    found = first(MEMBER)
    assert (found.line, found.header, found.more) == (3, "<memory>", True)
    assert advice_on(found) == "Add `#include <memory>` at the top of the file."


def test_a_linker_names_symbol_target_and_who_uses_it() -> None:
    found = first(CMAKE_LINK)
    assert (found.kind, found.target, found.file) == ("undefined", "robot", "src/arm.cpp")
    assert found.text == "Arm::bend(double, std::string const&)"


@pytest.mark.parametrize(
    ("line", "kind", "text", "file"),
    [
        ("/usr/bin/ld: x.cpp:5: undefined reference to `vtable for A'", "undefined", "vtable for A", None),
        ("(.text+0x17): undefined reference to `main'", "undefined", "main", None),
        ("/usr/bin/ld: main.cpp:5: undefined reference to `main'", "undefined", "main", "main.cpp"),
        ("/usr/bin/ld: cannot find -ltinyqp: No such file or directory", "library", "tinyqp", None),
        ("/usr/bin/ld.gold: error: cannot find -ltinyqp", "library", "tinyqp", None),
        (TWICE, "twice", "helper()", "main.cpp"),
    ],
)  # fmt: skip
def test_what_linkers_say(line: str, kind: str, text: str, file: str | None) -> None:
    found = first(line)
    assert (found.kind, found.text, found.file) == (kind, text, file)
    assert advice_on(found)


def test_nothing_is_made_of_other_lines() -> None:
    assert first_error(["main.cpp:5:1: warning: x", "all is well"], own) is None


def test_warnings_of_own_files_each_once() -> None:
    line = "main.cpp:5:1: warning: unused variable 'x' [-Wunused-variable]"
    golden(warnings([line, "/usr/include/a.h:1:1: warning: not ours", "  5 | x", line], own))


def test_long_names_are_cut() -> None:
    assert readable_name("f(int) [with T = std::vector<int>]") == "f(int)"
    assert len(readable_name("x" * 500)) <= 90
    assert readable_name("types are ‘std::ostringstream’ {aka ‘std::x<char>’} and ‘int’") == (
        "types are 'std::ostringstream' and 'int'"
    )
    assert first("main.cpp:1:1: error: it discards it [-fpermissive]").text == "it discards it"


@pytest.mark.parametrize(
    ("symbol", "file"),
    [
        ("Arm::bend(double)", "a.cpp"),
        ("robots::Arm::bend(double)", "a.cpp"),
        ("Arm::Arm(double)", "a.cpp"),
        ("free_one(int)", "b.cpp"),
        ("announced()", None),
        ("called(int)", None),
        ("vtable for Arm", None),
    ],
)
def test_who_defines_a_symbol(symbol: str, file: str | None) -> None:
    texts = {
        "a.cpp": "Arm::Arm(double x) : x_(x) {}\nvoid Arm::bend(double x) {\n  called(1);\n}\n",
        "b.cpp": "void announced();\nint free_one(int a)\n{ return a; }\n",
    }
    assert defining_file(symbol, texts) == file


def test_a_file_that_no_target_names_is_found(case: Callable[..., Build], src: Path) -> None:
    package = src / "small_interfaces"
    (package / "helper.cpp").write_text("int helper(int a) {\n  return a;\n}\n")
    (package / "main.cpp").write_text("int helper(int);\nint main() { return helper(1); }\n")
    lists = package / "CMakeLists.txt"
    lists.write_text(f"{lists.read_text()}\nadd_executable(robot main.cpp)\n")
    log = (
        "CMakeFiles/robot.dir/main.cpp.o: in function `main':\n"
        "main.cpp:(.text+0x5): undefined reference to `helper(int)'\n"
    )
    failure = explain_build(case("small_interfaces", log))
    line = lists.read_text().splitlines().index("add_executable(robot main.cpp)") + 1
    assert failure.kind == "linker"
    assert [str(place) for place in failure.feedback.where] == [
        f"{SRC}/small_interfaces/CMakeLists.txt:{line}"
    ]
    advice = (
        "`helper.cpp` defines it, but CMakeLists.txt does not list that file: add it to the files of `robot`."
    )
    assert failure.feedback.advice == advice


def test_a_function_that_nobody_wrote_is_where_the_header_announces_it(
    case: Callable[..., Build], src: Path
) -> None:
    package = src / "small_interfaces"
    (package / "arm.hpp").write_text(
        "struct Arm {\n  // void bend(double x) is for the elbow\n  void bend(double x) override;\n};\n"
    )
    (package / "arm.cpp").write_text('#include "arm.hpp"\nint main() { Arm().bend(1); }\n')
    log = "CMakeFiles/robot.dir/arm.cpp.o:(.data.rel+0x40): undefined reference to `sas::Arm::bend(double)'\n"
    feedback = explain_build(case("small_interfaces", log)).feedback
    assert str(feedback.where[0]) == f"{SRC}/small_interfaces/arm.hpp:3"
    wanted = "Define it in a .cpp file: its return type, then `Arm::bend(...) { ... }`"
    assert feedback.advice and wanted in feedback.advice

    (package / "more.cpp").write_text("void sas::Arm::bend(double x) {\n}\n")
    feedback = explain_build(case("small_interfaces", log)).feedback
    assert "arm.hpp" not in str(feedback.where[0])
    assert feedback.advice and "`more.cpp` defines it" in feedback.advice


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("unable to find numeric literal operator ‘operator\"\"ms’", "using namespace std::chrono_literals;"),
        ("no matching function for call to ‘Talker::create_wall_timer(int, Talker::Talker()::<lambda()>)’",
         "A period needs a unit"),
        ("no matching function for call to ‘spin(Talker&)’", "std::make_shared"),
        ("no matching function for call to ‘spin(std::shared_ptr<Talker>&, int)’", "Compare the types"),
        ("invalid operands of types ‘const char [9]’ and ‘int’ to binary ‘operator<<’", "RCLCPP_INFO_STREAM"),
        ("‘count_’ was not declared in this scope", "`Class::` before its name"),
        ("‘get_logger’ was not declared in this scope; did you mean ‘getdate’?", "`Class::` before its name"),
        ("‘count’ was not declared in this scope", "`std::` before it"),
        ("‘cout’ was not declared in this scope; did you mean ‘std::cout’?", "Write `std::cout`."),
        ("‘timer’ was not declared in this scope; did you mean ‘a::detail::timer’?", "`std::` before it"),
        ("no matching function for call to ‘spin(std::shared_ptr<Talker>)’", "from `public rclcpp::Node`"),
        ("invalid operands of types ‘const char*’ and ‘const char [8]’ to binary ‘operator+’", "Use `<<`"),
        ("invalid use of non-static member function ‘void Talker::talk()’", "std::bind(&Class::function"),
        ("static assertion failed: Wrong number of arguments for pointer-to-member", "needs an object"),
        ("static assertion failed: YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES", "in capital letters"),
        ("no declaration matches ‘std::string Arm::to_string()’", "with the header"),
        ("QString: No such file or directory", "Qt5::Core"),
        ("invalid application of ‘sizeof’ to incomplete type ‘sas::Arm::Impl’",
         "write `Arm::~Arm() = default;` in the .cpp file, below `class Arm::Impl`"),
        ("invalid application of ‘sizeof’ to incomplete type ‘Hand’", "Include the header of `Hand`"),
        ("invalid use of incomplete type ‘class sas::Arm::Impl’", "only knows the name of the type"),
        ("Eigen/Dense: No such file or directory", "`target_link_libraries(... Eigen3::Eigen)`"),
        ("Eigen/Dens: No such file or directory", "Did you mean `Eigen/Dense`?"),
        ("eigen3/Eigen/Dense.h: No such file or directory", "Did you mean `Eigen/Dense`?"),
        ("use of deleted function ‘sas::RobotDriver::RobotDriver()’", "`: RobotDriver(...)`"),
        ("use of deleted function ‘sas::Arm::Arm(const sas::Arm&)’", "copies an object"),
        ("‘override’ has not been declared", "A `)` is missing before"),
        ("ISO C++ forbids declaration of ‘Arm’ with no type", "named like its class"),
        ("invalid initialization of reference of type ‘const std::vector<double>&’ from expression of type "
         "‘Eigen::Matrix<double, -1, 1>’", "Compare the types"),
        ("‘Eigen::VectorXd sas::RobotDriverMyrobot::get_joint_positions() const’ marked ‘override’, but does "
         "not override", "Compare it with the base class"),
    ],
)  # fmt: skip
def test_advice_on_what_nodes_get_wrong(said: str, words: str) -> None:
    assert words in advice_on(first(f"main.cpp:5:1: error: {said}\n"))
